//! The paper's experiments with the end-effector, on a simulated robot with known parameters: Table
//! III, and the recognition rate of tools.

mod bench;
mod recording;
mod table_three;
mod trials;
mod waves;

pub use bench::{Bench, BenchError, PAPER_TORQUE_NOISE};
pub use recording::{Recording, SensorNoise};
pub use table_three::{Column, PaperRoller, TABLE_THREE, ToolRow, table_three};
pub use trials::{OTHER_SIZE, SizeTrial, TrialSettings, Trials, trials};
pub use waves::Waves;

#[cfg(test)]
mod tests;
