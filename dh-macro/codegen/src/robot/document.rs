//! Trees of YAML with the place of every node, and the mistakes found in them: what reads files
//! that stand beside a robot file.

use super::Effect;
use super::check::drive::{self, Origin};
use super::problem::Problems;

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

/// Effects of one joint: the keys of a mapping.
pub fn effects_of_joint(fields: &[(Word, Node)], path: &str, to: &mut Findings) -> Vec<Effect> {
    drive::effects_of_joint(fields, path, to)
}

/// Effects of the whole robot.
pub fn effects_of_robot(node: &Node, path: &str, to: &mut Findings) -> Vec<Effect> {
    drive::effects(node, path, Origin::Simulation, to)
}
