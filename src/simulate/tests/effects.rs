//! The signature of each effect.
