//! Table III: both paint rollers, identified by equation (7) on the bench of [`crate::tool::rerun`].

use super::verdict::Verdict;
use super::{ReproduceError, lwr::Lwr};
use crate::tool::rerun::{Bench, Column, PAPER_TORQUE_NOISE, POSITION_NOISE, Row, SensorNoise, table_three};

/// Of the mass of the large roller, percent, and of its centre, m: what is asked of the rerun.
pub const ASKED: [f64; 2] = [2.0, 2e-3];

/// Both rollers, 10 s with an empty hand and 10 s with each.
pub fn columns(lwr: &Lwr, seed: u64) -> Result<Vec<Column>, ReproduceError> {
    let noise = SensorNoise { torque: PAPER_TORQUE_NOISE.to_vec(), position: POSITION_NOISE };
    let bench = Bench::new(&lwr.robot, noise, 10.0, seed)?;
    Ok(table_three(&bench, 1, seed)?)
}

/// Standard deviations in SI units: relative ones of parameters that are zero say nothing.
pub fn verdict(row: &Row) -> Verdict {
    Verdict::less(row.ours[1], row.paper[1])
}
