//! Effect `link_inertia_error`: the true parameters of a link are the given ones plus these errors.

use super::key::{Key, Range, Scope, effect};

effect! {
    /// The given inertial parameters of a link are wrong.
    LinkInertiaError = "link_inertia_error", Scope::Link;
    law: "true parameters of the link = given + these; of `{}` a fifth of the given";
    source: "our choice: CAD is off by 0 to 70 % of a parameter in Katsumata et al., table II";
    link = LINK as "link" [] link, Range::ANY, "the link; default: that of the joint that this stands at";
    m = M ["kg"] always 0.0, Range::ANY, "mass";
    msx = MSX ["kg m"] always 0.0, Range::ANY, "first moment";
    msy = MSY ["kg m"] always 0.0, Range::ANY, "first moment";
    msz = MSZ ["kg m"] always 0.0, Range::ANY, "first moment";
    xx = XX ["kg m^2"] always 0.0, Range::ANY, "tensor about the frame's origin";
    yy = YY ["kg m^2"] always 0.0, Range::ANY, "tensor about the frame's origin";
    zz = ZZ ["kg m^2"] always 0.0, Range::ANY, "tensor about the frame's origin";
    xy = XY ["kg m^2"] always 0.0, Range::ANY, "tensor about the frame's origin";
    xz = XZ ["kg m^2"] always 0.0, Range::ANY, "tensor about the frame's origin";
    yz = YZ ["kg m^2"] always 0.0, Range::ANY, "tensor about the frame's origin";
}

impl LinkInertiaError {
    /// Keys of the ten parameters, in the order of [`Self::body`].
    pub const BODY: [Key; 10] =
        [Self::M, Self::MSX, Self::MSY, Self::MSZ, Self::XX, Self::YY, Self::ZZ, Self::XY, Self::XZ, Self::YZ];

    /// The ten inertial parameters, `M MSX MSY MSZ XX YY ZZ XY XZ YZ`.
    #[must_use]
    pub fn body(&self) -> [f64; 10] {
        [self.m(), self.msx(), self.msy(), self.msz(), self.xx(), self.yy(), self.zz(), self.xy(), self.xz(), self.yz()]
    }
}
