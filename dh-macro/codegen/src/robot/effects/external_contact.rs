//! `external_contact`: a wrench on the tool, in its frame, during a window of time.

use super::key::{Key, Range, Scope, effect};

effect! {
    /// A wrench on the tool during a part of the motion.
    ExternalContact = "external_contact", Scope::Robot;
    law: "-J' (wrench on the tool) during the window";
    source: "our choice: a light push of the hand, 17 N";
    start = START as "start" ["s"] derived, Range::ANY, "begin; default: a third of the motion";
    end = END as "end" ["s"] derived, Range::ANY, "end; default: two thirds of the motion";
    fx = FX as "fx" ["N"] alone 10.0, Range::ANY, "force on the tool, tool frame";
    fy = FY as "fy" ["N"] alone 10.0, Range::ANY, "force";
    fz = FZ as "fz" ["N"] alone -10.0, Range::ANY, "force";
    mx = MX as "mx" ["N m"] always 0.0, Range::ANY, "moment";
    my = MY as "my" ["N m"] always 0.0, Range::ANY, "moment";
    mz = MZ as "mz" ["N m"] always 0.0, Range::ANY, "moment";
}

impl ExternalContact {
    /// Keys of the wrench, in the order of [`Self::wrench`].
    pub const WRENCH: [Key; 6] = [Self::FX, Self::FY, Self::FZ, Self::MX, Self::MY, Self::MZ];

    /// Force, N, and moment, N m, on the tool, in its frame.
    #[must_use]
    pub fn wrench(&self) -> [f64; 6] {
        [self.fx(), self.fy(), self.fz(), self.mx(), self.my(), self.mz()]
    }
}
