//! Hidden effects must be found; nothing hidden must be called nothing.

mod battery;
mod columns;
mod decisions;
mod mechanisms;
mod sums;
mod world;
mod written;
