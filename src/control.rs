//! Position and force control of a tool that presses on a surface (the paper's section V, Fig. 8):
//! two nested loops, and tools to propose their gains.
//!
//! [`law`] is the controller itself: plain arrays, no allocation, only `core`, so that its files
//! can be copied verbatim into firmware (`tests/control.rs` compiles them under `#![no_std]`).
//! [`robot`] adapts a robot file to it. [`gains`] proposes gains from a linear model of arm, wall,
//! filter and sampling. [`iterative_learning`] computes from one coat the displacement for the
//! next.

pub mod estimate;
pub mod gains;
pub mod iterative_learning;
#[cfg(test)]
mod iterative_learning_tests;
pub mod law;
pub mod robot;
#[cfg(test)]
mod robot_tests;

pub use law::{Command, Controller, ControllerError, Fault, Sample, Settings, Status, Target};
