//! Position and force control of a tool that presses on something (the paper's section V, Fig. 8): two nested loops, and what proposes
//! their gains.
//!
//! [`law`] is the controller itself: plain arrays, no allocation, nothing but `core`, so that its files can be copied verbatim into firmware
//! (`tests/control.rs` compiles them under `#![no_std]`). [`robot`] lends it a robot file, [`gains`] proposes gains from a linear model of
//! arm, wall, filter and sampling, [`learned`] is what one coat teaches the next.

pub mod gains;
pub mod law;
pub mod learned;
#[cfg(test)]
mod learned_tests;
pub mod robot;

pub use law::{Command, Controller, Fault, Sample, Settings, Status, Target};
