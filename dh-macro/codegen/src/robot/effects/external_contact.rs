//! Effect `external_contact`: a wrench on the tool or a link during a time window, or the force of a
//! compliant wall.

use super::key::{Key, Range, Scope, effect};

effect! {
    /// A wrench on the tool or a link during a part of the motion, or a wall that the tool meets.
    ExternalContact = "external_contact", Scope::Robot;
    law: "-J' (wrench on the tool, or on a link) during the window; of a wall the force k max(at - n'p, 0) along n";
    source: "our choice: a light push of the hand, 17 N";
    start = START as "start" ["s"] derived, Range::ANY, "begin; default: a third of the motion";
    end = END as "end" ["s"] derived, Range::ANY, "end; default: two thirds of the motion";
    rise = RISE as "rise" ["s"] always 0.02, Range::NOT_NEGATIVE, "time in which the wrench rises, and falls, as a raised cosine; at most half of the duration";
    fx = FX as "fx" ["N"] alone 10.0, Range::ANY, "force on the tool, at the origin of its frame (or on a link, at its far end)";
    fy = FY as "fy" ["N"] alone 10.0, Range::ANY, "force";
    fz = FZ as "fz" ["N"] alone -10.0, Range::ANY, "force";
    mx = MX as "mx" ["N m"] always 0.0, Range::ANY, "moment";
    my = MY as "my" ["N m"] always 0.0, Range::ANY, "moment";
    mz = MZ as "mz" ["N m"] always 0.0, Range::ANY, "moment";
    base = BASE as "base" [] always 0.0, Range::within(0.0, 1.0), "1: force and moment are in the axes of the base, 0: in those of the tool or link";
    link = LINK as "link" [] link, Range::ANY, "link that is touched, at its far end, where the next joint is; default: the tool";
    stiffness = K as "k" ["N/m"] always 0.0, Range::NOT_NEGATIVE, "stiffness of a wall that acts through the whole motion; 0: no wall";
    nx = NX as "nx" [] always 0.0, Range::within(-1.0, 1.0), "its normal, towards the free side, in the axes of the base";
    ny = NY as "ny" [] always 0.0, Range::within(-1.0, 1.0), "normal";
    nz = NZ as "nz" [] always 0.0, Range::within(-1.0, 1.0), "normal";
    at = AT as "at" ["m"] always 0.0, Range::within(-1e3, 1e3), "distance from the base's origin along the normal";
}

impl ExternalContact {
    /// Keys of the wrench, in the order of [`Self::wrench`].
    pub const WRENCH: [Key; 6] = [Self::FX, Self::FY, Self::FZ, Self::MX, Self::MY, Self::MZ];

    /// Force, N, and moment, N m, on the tool about the origin of its frame, or on the link about its
    /// far end.
    #[must_use]
    pub fn wrench(&self) -> [f64; 6] {
        [self.fx(), self.fy(), self.fz(), self.mx(), self.my(), self.mz()]
    }

    /// Combines the wall of one contact with the wrench of the other, whichever of them is the
    /// wall.
    #[must_use]
    pub fn beside(self, other: Self) -> Self {
        let (wall, push) = if self.stiffness() > 0.0 { (self, other) } else { (other, self) };
        let Self { stiffness, nx, ny, nz, at, .. } = wall;
        Self { stiffness, nx, ny, nz, at, ..push }
    }

    /// Normal of the wall as stated, not normalised.
    #[must_use]
    pub fn normal(&self) -> [f64; 3] {
        [self.nx(), self.ny(), self.nz()]
    }
}
