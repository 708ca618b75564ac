//! `external_contact`: a wrench on the tool, in its frame, during a window of time.

use super::key::{Range, Scope, effect};

effect! {
    /// A wrench on the tool during a part of the motion.
    ExternalContact = "external_contact", Scope::Robot;
    law: "-J' (wrench on the tool) during the window";
    source: "our choice: a light push of the hand, 17 N";
    start = "start" ["s"] derived, Range::ANY, "begin; default: a third of the motion";
    end = "end" ["s"] derived, Range::ANY, "end; default: two thirds of the motion";
    fx = "fx" ["N"] alone 10.0, Range::ANY, "force on the tool, tool frame";
    fy = "fy" ["N"] alone 10.0, Range::ANY, "force";
    fz = "fz" ["N"] alone -10.0, Range::ANY, "force";
    mx = "mx" ["N m"] always 0.0, Range::ANY, "moment";
    my = "my" ["N m"] always 0.0, Range::ANY, "moment";
    mz = "mz" ["N m"] always 0.0, Range::ANY, "moment";
}

impl ExternalContact {
    /// Force, N, and moment, N m, on the tool, in its frame.
    #[must_use]
    pub fn wrench(&self) -> [f64; 6] {
        [self.fx(), self.fy(), self.fz(), self.mx(), self.my(), self.mz()]
    }
}
