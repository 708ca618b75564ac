//! Look-up table of known tools, expressed in the arm's last frame.

use dh_codegen::robot::{Tool, ToolGeometry};
use nalgebra::{SMatrix, SVector};

use super::body::displacements;

/// A tool of the table.
#[derive(Debug, Clone, PartialEq)]
pub struct Entry {
    /// Name of the tool.
    pub name: String,
    /// Ten inertial parameters in the arm's last DH frame, about its origin.
    pub values: [f64; 10],
    /// Covariance of the table's numbers, from [`Tolerance`].
    pub covariance: SMatrix<f64, 10, 10>,
    /// Size, if known.
    pub geometry: Option<ToolGeometry>,
    /// Rotation (row-major) from the tool frame to the last frame, and origin, m.
    pub pose: ([[f64; 3]; 3], [f64; 3]),
}

/// Accuracy of the table and of the mounting, as standard deviations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    /// Relative error of the mass; the moments scale with it. Default 0.005: a gram in 200.
    pub mass: f64,
    /// Error of the position on the flange, along each axis, m. Default 0.0005.
    pub position: f64,
    /// Error of the orientation, about each axis, rad. Default 0.005: 0.3 deg.
    pub angle: f64,
}

impl Default for Tolerance {
    fn default() -> Self {
        Self { mass: 0.005, position: 0.0005, angle: 0.005 }
    }
}

impl Tolerance {
    /// Covariance of the ten parameters, `sum s^2 d d'` over the ways in which a tool can differ
    /// from its entry.
    pub fn covariance(&self, values: &[f64; 10]) -> SMatrix<f64, 10, 10> {
        let mut all = SMatrix::zeros();
        let mut way = |size: f64, by: &[f64; 10]| {
            let by = SVector::from(*by) * size;
            all += by * by.transpose();
        };
        way(self.mass, values);
        for (k, by) in displacements(values).iter().enumerate() {
            way(if k < 3 { self.position } else { self.angle }, by);
        }
        all
    }
}

impl Entry {
    /// Entry of a tool mounted on the arm; `None` if its inertia is unknown. `mount`: origin of the
    /// tool frame in the last frame, m, instead of the tool's own.
    pub fn new(tool: &Tool, mount: Option<[f64; 3]>, tolerance: &Tolerance) -> Option<Self> {
        let pose = (tool.rotation(), mount.unwrap_or(tool.xyz));
        let values = tool.inertia?.moved(&pose.0, &pose.1).to_array();
        let covariance = tolerance.covariance(&values);
        Some(Self { name: tool.name.clone(), values, covariance, geometry: tool.geometry, pose })
    }

    /// Family derived from the name, see `family`; `None` without a size.
    pub fn family(&self) -> Option<String> {
        self.geometry?;
        family(&self.name)
    }
}

/// Common name of tools of one make: the name without the words that contain digits, `roller` for
/// `roller-400x180`. `None` if there is no such word, or nothing else.
pub(super) fn family(name: &str) -> Option<String> {
    let words: Vec<&str> = name.split(['-', '_', ' ']).collect();
    let plain: Vec<&str> = words.iter().copied().filter(|w| !w.contains(|c: char| c.is_ascii_digit())).collect();
    (plain.len() < words.len() && !plain.is_empty()).then(|| plain.join("-"))
}
