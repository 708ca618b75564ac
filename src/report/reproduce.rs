//! Reports of the `reproduce` command.

pub(crate) mod diagnosis;
pub(crate) mod excitation;
pub(crate) mod force;
pub(crate) mod json;
pub(crate) mod on_real;
pub(crate) mod page;
pub(crate) mod painting;
pub(crate) mod text;
