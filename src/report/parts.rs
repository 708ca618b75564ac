//! Shared parts of pages and texts: frame, style sheets, numbers, drawings.

pub(crate) mod bodies;
pub(crate) mod budget;
pub(crate) mod fields;
pub(crate) mod number;
pub(crate) mod page;
pub(crate) mod stick_figure;
pub(crate) mod visible;
pub(crate) mod warnings;
