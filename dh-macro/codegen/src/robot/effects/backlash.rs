//! Effect `backlash`: a dead zone between motor and link.

use super::key::{Range, Scope, effect};

effect! {
    /// A dead zone in the transmission.
    Backlash = "backlash", Scope::Joint;
    law: "a dead zone between motor and link";
    source: "order of magnitude, our choice: 3.4 arc minutes, as a planetary gear has";
    width = BL ["rad"] always 1e-3, Range::within(0.0, 1.0), "whole width";
}
