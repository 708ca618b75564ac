//! From recordings to windows: averaged data, their noise, and the errors of the recorded motion.

pub(super) mod earlier;
pub(super) mod holding;
pub(super) mod low_passed;
pub(super) mod motion_error;
pub(super) mod pauses;
pub(super) mod postures;
pub(super) mod recording;
pub(super) mod torque_noise;
pub(super) mod windowed_data;
