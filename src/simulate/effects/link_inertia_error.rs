//! `link_inertia_error`: the true parameters of a link are the given ones plus these; of `{}` a fifth of the given.

use dh_codegen::robot::Inertia;

use super::Given;

/// Makes the link the true one.
pub(crate) fn apply(link: &mut Inertia, given: &Given<'_>) {
    let stated_size = !given.is_bare() && given.body().iter().any(|p| *p != 0.0);
    let error = if stated_size {
        Inertia::from_array(given.body())
    } else {
        Inertia::from_array(link.to_array().map(|p| 0.2 * p))
    };
    *link = link.plus(&error);
}
