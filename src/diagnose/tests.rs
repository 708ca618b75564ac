//! Tests of the diagnosis: hidden effects must be found, and none reported where nothing is hidden.

mod battery;
pub(super) mod columns;
mod decisions;
mod excerpts;
mod gears;
mod mechanisms;
mod position_band;
mod sizes;
mod sums;
mod windows;
mod world;
mod written;
