//! Effect `payload`: a body fixed in the last frame.

use super::key::{Key, Range, Scope, effect};

effect! {
    /// An unmodelled body is fixed to the flange.
    Payload = "payload", Scope::Robot;
    law: "a body fixed in the last frame; of `M` alone a point mass";
    source: "our choice, a gripper: 1 kg, a sphere of 0.08 m whose centre is 0.1 m out and 0.02 m aside";
    m = M ["kg"] alone 1.0, Range::ANY, "mass";
    msx = MSX ["kg m"] alone 0.02, Range::ANY, "first moment";
    msy = MSY ["kg m"] always 0.0, Range::ANY, "first moment";
    msz = MSZ ["kg m"] alone 0.1, Range::ANY, "first moment";
    xx = XX ["kg m^2"] alone 0.0125, Range::ANY, "tensor about the frame's origin";
    yy = YY ["kg m^2"] alone 0.0129, Range::ANY, "tensor about the frame's origin";
    zz = ZZ ["kg m^2"] alone 0.0029, Range::ANY, "tensor about the frame's origin";
    xy = XY ["kg m^2"] always 0.0, Range::ANY, "tensor about the frame's origin";
    xz = XZ ["kg m^2"] alone -0.002, Range::ANY, "tensor about the frame's origin";
    yz = YZ ["kg m^2"] always 0.0, Range::ANY, "tensor about the frame's origin";
}

impl Payload {
    /// Keys of the ten parameters, in the order of [`Self::body`].
    pub const BODY: [Key; 10] =
        [Self::M, Self::MSX, Self::MSY, Self::MSZ, Self::XX, Self::YY, Self::ZZ, Self::XY, Self::XZ, Self::YZ];

    /// The ten inertial parameters, `M MSX MSY MSZ XX YY ZZ XY XZ YZ`.
    #[must_use]
    pub fn body(&self) -> [f64; 10] {
        [self.m(), self.msx(), self.msy(), self.msz(), self.xx(), self.yy(), self.zz(), self.xy(), self.xz(), self.yz()]
    }

    /// Whether it is a point mass: no tensor is stated.
    #[must_use]
    pub fn is_point(&self) -> bool {
        let tensor = [self.xx, self.yy, self.zz, self.xy, self.xz, self.yz];
        !self.is_bare() && tensor.iter().all(Option::is_none)
    }
}
