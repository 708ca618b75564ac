//! Reported results: causes with their evidence, effects that no torque model contains, error maps,
//! remaining structure.

pub(super) mod attribution;
pub(super) mod calibration;
mod course_of_push;
pub(super) mod deflection;
pub(super) mod evidence;
mod force_at_rest;
pub(super) mod formula;
pub(super) mod impacts;
pub(super) mod links;
pub(super) mod maps;
pub(super) mod nameless;
pub(super) mod order;
pub(super) mod pushes_at_rest;
pub(super) mod reported_cause;
pub(super) mod result;
pub(super) mod structure;
