//! `payload`: a body fixed in the last DH frame. A point mass where nothing is said of its tensor.

use dh_codegen::robot::Inertia;

use super::Given;

/// Adds it to the last link.
pub(crate) fn apply(last: &mut Inertia, given: &Given<'_>) {
    let mut body = Inertia::from_array(given.body());
    let said = ["XX", "YY", "ZZ", "XY", "XZ", "YZ"].iter().any(|key| given.stated(key).is_some());
    if !given.is_bare() && !said && body.m > 0.0 {
        let [x, y, z] = body.ms;
        body.i = [y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z].map(|p| p / body.m);
    }
    *last = last.plus(&body);
}
