//! Complete result on the carried body, as plain data for a report.

use super::identify::Carried;
use super::interpolate::{Relative, interpolate};
use super::recognise::{RecogniseSettings, Recognition, recognise};
use super::table::{Entry, Tolerance};
use dh_codegen::robot::Tool;

/// The body expressed in the frame of a tool.
#[derive(Debug, Clone, PartialEq)]
pub struct InToolFrame {
    /// Name of the tool.
    pub tool: String,
    /// Rotation (row-major) from the tool frame to the last frame, and origin, m.
    pub pose: ([[f64; 3]; 3], [f64; 3]),
    /// Ten inertial parameters.
    pub values: [f64; 10],
    /// Standard deviations of the parameters.
    pub std: [f64; 10],
}

/// Complete result.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// Ten parameters in the last DH frame.
    pub carried: Carried,
    /// Table of known tools; may be empty.
    pub table: Vec<Entry>,
    /// Recognised tool; `None` without a table.
    pub recognition: Option<Recognition>,
    /// Estimated size as a member of one of the table's families, interpolated between its tools.
    pub relative: Option<Relative>,
    /// The same body in a tool's frame: that of the robot file's tool, otherwise of the recognised
    /// one.
    pub in_tool_frame: Option<InToolFrame>,
}

/// Looks up the identified body in the table. `own`: the robot file's tool, in whose frame the body
/// is also expressed.
pub fn look_up(
    carried: Carried,
    own: Option<&Tool>,
    table: Vec<Entry>,
    tolerance: &Tolerance,
    settings: &RecogniseSettings,
) -> Found {
    let recognition = recognise(&carried, &table, settings);
    let relative = interpolate(&carried, &table, tolerance, settings.level);
    let recognised = recognition.as_ref().filter(|r| !r.rejected).map(|r| &table[r.nearest().entry]);
    let frame = match (own, recognised) {
        (Some(tool), _) => Some((tool.name.clone(), (tool.rotation(), tool.xyz))),
        (None, Some(entry)) => Some((entry.name.clone(), entry.pose)),
        _ => None,
    };
    let in_tool_frame = frame.and_then(|(tool, pose)| {
        let (r, p) = pose;
        let back: [[f64; 3]; 3] = std::array::from_fn(|i| std::array::from_fn(|k| r[k][i]));
        let origin = std::array::from_fn(|i| -(0..3).map(|k| back[i][k] * p[k]).sum::<f64>());
        let (values, std) = carried.moved(&back, &origin)?;
        Some(InToolFrame { tool, pose, values, std })
    });
    Found { carried, table, recognition, relative, in_tool_frame }
}
