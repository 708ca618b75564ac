//! Effect `geometric_error`: the true row of the DH table is the given one plus these errors.

use super::key::{Range, Scope, effect};

effect! {
    /// A length or an angle of the DH table is wrong.
    GeometricError = "geometric_error", Scope::EveryJoint;
    law: "true row of the DH table = given row + these";
    source: "our choice: a mistaken drawing; what calibration finds in built arms is smaller";
    alpha = DALPHA ["rad"] alone 0.02, Range::HALF_TURN, "of alpha";
    d = DD ["m"] alone 0.01, LENGTH, "of d";
    theta = DTHETA ["rad"] always 0.0, Range::HALF_TURN, "of theta";
    r = DR ["m"] always 0.0, LENGTH, "of r";
}

/// Largest error of a length, m; a larger one suggests a wrong unit.
const LENGTH: Range = Range::within(-10.0, 10.0);
