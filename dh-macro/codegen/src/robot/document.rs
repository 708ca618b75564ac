//! Reads YAML files that accompany a robot file: trees with the location of every node, and the
//! mistakes found in them.

use super::check::drive::{self, Origin};
use super::check::law;
use super::problem::Problems;
use super::torque_law::Law;
use super::{Effect, JointKind, Robot, TorqueLaw};

pub use super::problem::closest;
pub use super::reader::{Findings, join};
pub use super::yaml::{Kind, Mark, Node, Word, shortened};

/// Parses one document.
///
/// # Errors
/// If the text is not YAML, or exceeds the limits of the reader.
pub fn tree(text: &str) -> Result<Node, Problems> {
    super::yaml::parse(text).map_err(Problems)
}

/// Effects of one joint from the keys of a mapping, except its law.
pub fn effects_of_joint(fields: &[(Word, Node)], path: &str, to: &mut Findings) -> Vec<Effect> {
    drive::effects_of_joint(fields, path, to)
}

/// Effects of the whole robot, except its law.
pub fn effects_of_robot(node: &Node, path: &str, to: &mut Findings) -> Vec<Effect> {
    drive::effects(node, path, Origin::Simulation, to)
}

/// Law among the keys of one joint, in row `row` of the robot. It may use the constants of the
/// robot's file.
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

/// Law under `effects`, for every joint with a torque in its unit; rows counted from 0.
pub fn law_of_robot(node: &Node, path: &str, robot: &Robot, to: &mut Findings) -> Vec<(usize, TorqueLaw)> {
    let (joints, scope) = (robot.moving_kinds(), robot.scope());
    let rows: Vec<JointKind> = robot.joints.iter().map(|joint| joint.kind).collect();
    law::of_effects(node, path, &rows, &Law { joints: &joints, scope: &scope }, to)
}
