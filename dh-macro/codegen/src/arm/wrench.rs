//! Wrench due to a unit inertial parameter, and its transformation inward.

use super::chain::Links;
use super::motion::Motion;
use super::param::Inertial;
use crate::sym::{Ex, Vec3};

/// Force, and moment about the frame's origin, in the frame's axes.
#[derive(Clone, Copy)]
pub(super) struct Wrench<'g> {
    pub f: Vec3<'g>,
    pub n: Vec3<'g>,
}

impl<'g> Wrench<'g> {
    /// Wrench of a body under this motion, with this parameter equal to one and all others zero: `f
    /// = M a + U MS`, `n = MS x a + I dw + w x (I w)`.
    pub fn unit(m: &Motion<'g>, which: Inertial) -> Self {
        let g = m.w.0[0].graph();
        let (zero, none) = (Vec3::zero(g), g.constant(0.0));
        let u = m.u;
        let ([x, y, z], [dx, dy, dz], [ax, ay, az]) = (m.w.0, m.dw.0, m.a.0);
        let (xy, xz, yz) = (x * y, x * z, y * z);
        let moment = |n: [Ex<'g>; 3]| Self { f: zero, n: Vec3(n) };
        match which {
            Inertial::M => Self { f: m.a, n: zero },
            Inertial::MSX => Self { f: u.column(0), n: Vec3([none, -az, ay]) },
            Inertial::MSY => Self { f: u.column(1), n: Vec3([az, none, -ax]) },
            Inertial::MSZ => Self { f: u.column(2), n: Vec3([-ay, ax, none]) },
            Inertial::XX => moment([dx, xz, -xy]),
            Inertial::YY => moment([-yz, dy, xy]),
            Inertial::ZZ => moment([yz, -xz, dz]),
            Inertial::XY => moment([-u.0[2][0], u.0[2][1], u.0[0][0] - u.0[1][1]]),
            Inertial::XZ => moment([u.0[1][0], u.0[2][2] - u.0[0][0], -u.0[1][2]]),
            Inertial::YZ => moment([u.0[1][1] - u.0[2][2], -u.0[0][1], u.0[0][2]]),
        }
    }

    /// Wrench for given values of all ten, `params[Inertial as usize]`, with the diagonal entries
    /// combined.
    pub fn of_body(m: &Motion<'g>, params: &[Ex<'g>; 10]) -> Self {
        let [.., xx, yy, zz, xy, xz, yz] = *params;
        let ([x, y, z], [dx, dy, dz]) = (m.w.0, m.dw.0);
        let diagonal =
            Vec3([(zz - yy) * (y * z) + xx * dx, (xx - zz) * (x * z) + yy * dy, (yy - xx) * (x * y) + zz * dz]);
        let mut n = diagonal;
        for (which, value) in [(Inertial::XY, xy), (Inertial::XZ, xz), (Inertial::YZ, yz)] {
            n = n + Self::unit(m, which).n.scale(value);
        }
        let point = Self::of_moments(m, params);
        Self { n: n + point.n, ..point }
    }

    /// Wrench of mass and first moments alone.
    pub fn of_moments(m: &Motion<'g>, params: &[Ex<'g>; 10]) -> Self {
        let [mass, lx, ly, lz, ..] = *params;
        let ms = Vec3([lx, ly, lz]);
        Self { f: m.a.scale(mass) + m.u * ms, n: ms.cross(m.a) }
    }

    pub fn plus(self, other: Self) -> Self {
        Self { f: self.f + other.f, n: self.n + other.n }
    }

    /// Transforms from the body's frame of a row to its joint frame.
    pub fn out_of_body(self, links: &Links<'g>, row: usize) -> Self {
        let link = &links.links[row];
        let (f, n) = (link.out_of_body(self.f), link.out_of_body(self.n));
        Self { f, n: n + link.body_origin().cross(f) }
    }

    /// Transforms from the joint frame of a row to the previous joint frame; `shifted`: it is given
    /// about the origin before `TransZ(r)`.
    pub fn inward(self, links: &Links<'g>, row: usize, shifted: bool) -> Self {
        let link = &links.links[row];
        let (f, n) = (link.turned(self.f), link.turned(self.n));
        let n = n + link.step(shifted).cross(f);
        Self { f: link.twisted(f), n: link.twisted(n) }
    }
}
