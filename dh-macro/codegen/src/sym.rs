//! Expressions: a hash-consed graph, simplified at birth, and the straight-line tape that it is
//! lowered to.
//!
//! `Graph -> factor -> signs -> Tape -> print | eval | adjoint -> Graph`. This module is
//! independent of mechanics.

mod adjoint;
mod call;
mod eval;
mod factor;
mod formula;
mod graph;
mod order;
mod rules;
mod signs;
mod tape;
mod vec3;

pub use adjoint::adjoint;
pub use call::Call;
pub use eval::{Column, Evaluator};
pub use formula::{Fold, Formula};
pub use graph::{Ex, Graph, Node, Op};
pub use tape::{Instruction, Kind, Operand, OperationCount, Section, Tape};
pub use vec3::{Mat3, Vec3};
