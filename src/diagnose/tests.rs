//! Hidden effects must be found; nothing hidden must be called nothing.

mod battery;
mod columns;
mod decisions;
mod gears;
mod mechanisms;
mod sizes;
mod sums;
mod windows;
mod world;
mod written;
