//! Weighted least squares on triangular factors: accumulation, solution, standard deviations.

pub(crate) mod accumulator;
pub(crate) mod batches;
pub(crate) mod essential;
pub(crate) mod known_parameters;
pub(crate) mod nonnegative;
pub(crate) mod r_factor;
pub(crate) mod recover;
pub(crate) mod rows;
pub(crate) mod spectrum;
pub(crate) mod statistics;
pub(crate) mod wls;
