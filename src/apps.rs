//! Applications: painting a wall, and the paper's experiments.

pub mod painting;
pub mod paper;
