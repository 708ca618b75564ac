//! Moving joints without a motor: refused by verbs that need one, noted by others.

use std::path::Path;

use dh_codegen::robot::Robot;

use super::Failure;
use super::terminal::say;

/// Refuses a robot with moving joints without a motor (`actuated: false`). `needs` describes what
/// the verb requires of each joint.
pub(super) fn on_every_joint(path: &Path, robot: &Robot, needs: &str) -> Result<(), Failure> {
    match without(robot) {
        None => Ok(()),
        Some(joints) => Err(Failure::input(format!(
            "{}: {joints} no motor (`actuated: false`), and {needs}. Delete `actuated: false` where there is a motor after all; \
             a joint that is held still is `type: fixed`, with its position in `theta` (or `r`)",
            path.display(),
        ))),
    }
}

/// Prints a note on the meaning of a torque at joints without a motor.
pub(super) fn note(path: &Path, robot: &Robot) {
    if let Some(joints) = without(robot) {
        say(&format!(
            "{}: note: {joints} no motor (`actuated: false`): inverse dynamics gives the torque that something else must apply there",
            path.display()
        ));
    }
}

/// Refuses non-zero torques at joints without a motor. `tau`: joint-major, `len` states, N m.
pub(super) fn no_torque_without_motor(path: &Path, robot: &Robot, tau: &[f64], len: usize) -> Result<(), Failure> {
    let passive = robot.moving().into_iter().enumerate().filter(|&(_, row)| !robot.joints[row].actuated);
    for (k, row) in passive {
        let torques = tau.get(k * len..(k + 1) * len).unwrap_or(&[]);
        if let Some(at) = torques.iter().position(|t| *t != 0.0) {
            return Err(Failure::input(format!(
                "{}: `tau{}` is {} in row {}, but joint {} ({}) has no motor (`actuated: false`); set the column to 0, or delete \
                 `actuated: false` where there is a motor after all",
                path.display(),
                k + 1,
                torques[at],
                at + 1,
                row + 1,
                robot.joints[row].name,
            )));
        }
    }
    Ok(())
}

/// Moving joints without a motor, as the beginning of a sentence.
fn without(robot: &Robot) -> Option<String> {
    let names: Vec<String> =
        robot.unactuated().map(|row| format!("{} ({})", row + 1, robot.joints[row].name)).collect();
    match names.as_slice() {
        [] => None,
        [one] => Some(format!("joint {one} has")),
        more => Some(format!("joints {} have", more.join(", "))),
    }
}
