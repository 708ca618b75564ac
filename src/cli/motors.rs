//! Verbs that need a motor on every joint.

use std::path::Path;

use dh_codegen::robot::Robot;

use super::Failure;

/// Refuses a robot with joints that move and have no motor (`actuated: false`). `needs` says what
/// the verb takes from each joint.
pub(super) fn on_every_joint(path: &Path, robot: &Robot, needs: &str) -> Result<(), Failure> {
    let without: Vec<String> =
        robot.unactuated().map(|row| format!("{} ({})", row + 1, robot.joints[row].name)).collect();
    if without.is_empty() {
        return Ok(());
    }
    let (joints, have) = if without.len() == 1 { ("joint", "has") } else { ("joints", "have") };
    Err(Failure::input(format!(
        "{}: {joints} {} {have} no motor (`actuated: false`), and {needs}. Delete `actuated: false` where there is a motor after all; \
         a joint that is held still is `type: fixed`, with its position in `theta` (or `r`)",
        path.display(),
        without.join(", "),
    )))
}
