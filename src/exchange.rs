//! Import and export of robot descriptions: URDF and MJCF to a robot file, and back.
//!
//! `text -> xml -> urdf | mjcf -> Tree -> chain (base to tip) -> to_dh (lines, common normals) ->
//! Robot`, each step a pure function. The tree is evaluated independently ([`Tree::poses`]), so
//! that source and result can be compared.

mod chain;
mod delay;
mod displacement;
mod exact;
mod export;
pub mod import;
pub mod mjcf;
mod onto;
mod tip;
mod to_dh;
pub mod tree;
pub mod urdf;
mod xml;

pub use exact::Snap;
pub use export::{Exported, export};
pub use import::{ForwardKinematicsError, ImportOptions, Imported, import};
pub use onto::onto;
pub use to_dh::Neighbours;
pub use tree::Tree;

use dh_codegen::robot::{Problem, Problems};

/// A format of robot models.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ModelFormat {
    /// The Unified Robot Description Format.
    Urdf,
    /// MuJoCo's format.
    Mjcf,
}

impl ModelFormat {
    /// Format according to the first element of a text.
    pub fn of(text: &str) -> Self {
        let root = xml::parse(text).ok().map(|d| d.root_element().tag_name().name().to_string());
        if root.is_some_and(|name| name.starts_with("mujoco")) { Self::Mjcf } else { Self::Urdf }
    }

    /// Reads the tree of a text in this format.
    ///
    /// # Errors
    /// As for [`urdf::tree`] and [`mjcf::tree`].
    pub fn tree(self, text: &str, snap: &mut Snap) -> Result<Tree, ImportError> {
        match self {
            Self::Urdf => urdf::tree(text, snap),
            Self::Mjcf => mjcf::tree(text, snap),
        }
    }
}

/// Reason why a file can't be imported.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ImportError {
    /// Mistakes in the file, each with line and column.
    #[error("{0}")]
    File(Problems),
    /// The content of the file, or the request, does not make a serial arm.
    #[error("{what}{}{mend}", if mend.is_empty() { "" } else { "; " })]
    Arm {
        /// Name of the obstacle.
        what: String,
        /// Suggested remedy; may be empty.
        mend: String,
    },
}

impl ImportError {
    fn arm(what: impl Into<String>, mend: impl Into<String>) -> Self {
        Self::Arm { what: what.into(), mend: mend.into() }
    }

    /// The message with the name of the file.
    pub fn in_file(&self, file: &str) -> String {
        match self {
            Self::File(problems) => problems.clone().in_file(file).to_string(),
            Self::Arm { .. } => format!("{file}: {self}"),
        }
    }
}

impl From<Vec<Problem>> for ImportError {
    fn from(problems: Vec<Problem>) -> Self {
        Self::File(Problems(problems))
    }
}
