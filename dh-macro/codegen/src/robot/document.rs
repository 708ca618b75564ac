//! Trees of YAML with the place of every node, and the mistakes found in them: what reads files
//! that stand beside a robot file.

use super::check::drive::{self, Origin};
use super::check::law;
use super::problem::Problems;
use super::torque_law::Law;
use super::{Effect, JointKind, Robot, TorqueLaw};

pub use super::problem::closest;
pub use super::reader::{Findings, join};
pub use super::yaml::{Kind, Mark, Node, Word, shortened};

/// Reads one document.
///
/// # Errors
/// Where the text is no YAML, and where it is more of it than is read.
pub fn tree(text: &str) -> Result<Node, Problems> {
    super::yaml::parse(text).map_err(Problems)
}

/// Effects of one joint: the keys of a mapping, but for its law.
pub fn effects_of_joint(fields: &[(Word, Node)], path: &str, to: &mut Findings) -> Vec<Effect> {
    drive::effects_of_joint(fields, path, to)
}

/// Effects of the whole robot, but for its law.
pub fn effects_of_robot(node: &Node, path: &str, to: &mut Findings) -> Vec<Effect> {
    drive::effects(node, path, Origin::Simulation, to)
}

/// The law among the keys of one joint, the row `row` of a robot; the names of its file's constants
/// are known.
pub fn law_of_joint(
    fields: &[(Word, Node)],
    path: &str,
    robot: &Robot,
    row: usize,
    to: &mut Findings,
) -> Option<TorqueLaw> {
    let (joints, scope) = (robot.moving_kinds(), robot.scope());
    law::at_joint(fields, path, robot.joints[row].kind, &Law { joints: &joints, scope: &scope }, to)
}

/// The law under `effects`: of every joint with a torque of its unit, by row from 0.
pub fn law_of_robot(node: &Node, path: &str, robot: &Robot, to: &mut Findings) -> Vec<(usize, TorqueLaw)> {
    let (joints, scope) = (robot.moving_kinds(), robot.scope());
    let rows: Vec<JointKind> = robot.joints.iter().map(|joint| joint.kind).collect();
    law::of_effects(node, path, &rows, &Law { joints: &joints, scope: &scope }, to)
}
