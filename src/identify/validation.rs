//! Assesses how well parameters predict other motions, and whether logs and torques are plausible.

pub(crate) mod accuracy;
pub(crate) mod extrapolation;
pub(crate) mod left_out;
pub(crate) mod log_consistency;
pub(crate) mod preference;
pub(crate) mod torque_columns;
pub(crate) mod torque_sign;
pub(crate) mod trace;
pub(crate) mod unexplained;
