//! Painting a wall with a roller (the paper, sections IV to VI): the run against the simulated wall.

pub mod run;
pub mod tune;
pub mod wall;
