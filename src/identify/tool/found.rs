//! Complete result on the body that the arm carries: plain data for a report.

use super::identify::Carried;
use super::interpolate::{Relative, interpolate};
use super::recognise::{RecogniseSettings, Recognition, recognise};
use super::table::{Entry, Tolerance};
use dh_codegen::robot::Tool;

/// The body in the frame of a tool.
#[derive(Debug, Clone, PartialEq)]
pub struct InToolFrame {
    /// Whose frame.
    pub tool: String,
    /// Rotation (row-major) from the tool frame to the last frame, and origin, m.
    pub pose: ([[f64; 3]; 3], [f64; 3]),
    /// The ten parameters.
    pub values: [f64; 10],
    /// Their standard deviations.
    pub std: [f64; 10],
}

/// The whole result.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// The ten parameters in the last DH frame.
    pub carried: Carried,
    /// The table that was looked up; may be empty.
    pub table: Vec<Entry>,
    /// Recognised tool; `None` without a table.
    pub recognition: Option<Recognition>,
    /// As a member of a family of the table, whose size is between those that are there.
    pub relative: Option<Relative>,
    /// The same body in a tool's frame: the robot file's tool, else the recognised one.
    pub in_tool_frame: Option<InToolFrame>,
}

/// Looks up what was identified. `own`: the robot file's tool, whose frame the body is also shown
/// in.
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
