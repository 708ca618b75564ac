//! Numerical methods, independent of robots: filters, splines, integrators, direct search.

pub(crate) mod butterworth;
pub(crate) mod chebyshev;
pub(crate) mod cholesky;
pub(crate) mod eigen;
pub mod elastic_joint;
pub(crate) mod fft;
pub(crate) mod hermite;
pub(crate) mod integrators;
pub(crate) mod median;
pub(crate) mod parallel;
pub(crate) mod pattern_search;
pub(crate) mod periodogram;
pub mod prng;
pub(crate) mod sos;
pub(crate) mod sums;
