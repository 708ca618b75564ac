//! From recordings to windows: data at the rate at which causes are distinguished, their noise and
//! the errors of their motion.

pub(super) mod earlier;
pub(super) mod holding;
pub(super) mod motion_error;
pub(super) mod recording;
pub(super) mod torque_noise;
pub(super) mod windowed_data;
