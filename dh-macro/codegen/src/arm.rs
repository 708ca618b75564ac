//! Mechanics of serial arms, written over expressions.

pub mod param;
