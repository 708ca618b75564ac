//! `geometric_error`: the true row of the DH table is the given one plus `DALPHA`, `DD`, `DTHETA`, `DR`.

use dh_codegen::robot::{Angle, Joint, Length};

use super::Given;

/// Makes the row the true one. What is not in error stays exact.
pub(crate) fn apply(joint: &mut Joint, given: &Given<'_>) {
    let angle = |slot: &mut Angle, error: f64| {
        if error != 0.0 {
            *slot = Angle::radians(slot.value + error);
        }
    };
    let length = |slot: &mut Length, error: f64| {
        if error != 0.0 {
            *slot = Length::meters(slot.value + error);
        }
    };
    angle(&mut joint.alpha, given.get("DALPHA"));
    angle(&mut joint.theta, given.get("DTHETA"));
    length(&mut joint.d, given.get("DD"));
    length(&mut joint.r, given.get("DR"));
}
