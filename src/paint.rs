//! Painting a wall with a roller (the paper, sections IV to VI): the motion is planned here.
//!
//! `surface`: the wall and its axes. `strokes`: the lanes of a painting motion and the legs it is made of.

mod strokes;
mod surface;
mod vector;

pub use strokes::{Leg, Pattern, Phase, Strokes};
pub use surface::{Roller, Surface};
