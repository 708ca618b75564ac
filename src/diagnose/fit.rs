//! Least-squares fit of a model under test: moments, regulariser, physical limits, uncertainty and
//! likelihood.

pub(super) mod body_limits;
pub(super) mod likelihood;
pub(super) mod model;
pub(super) mod moments;
pub(super) mod possible;
pub(super) mod regulariser;
pub(super) mod shapes;
pub(super) mod uncertainty;
pub(super) mod white_errors;
