//! Bristle model of a velocity's sign: a state that depends on the last short travel. With it
//! joints stick, do not creep, and break away.
//!
//! `dz/dt = (v - |v| z) / X` (P. R. Dahl, 1968; Canudas de Wit et al. 1995); friction is a level
//! times `z + b dz/dt exp(-(v / v_d)^2)`, the damping fading with speed so that friction always
//! takes energy (H. Olsson, K. J. Astrom et al., *Friction models and friction compensation*, Eur.
//! J. Control 4, 1998). After a travel of some `X` in one direction `z` is `sign(v)`.

/// Role of a bristle's force.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    /// All laws of a joint that contain `sign(v)`.
    Sign,
    /// `presliding_hysteresis`.
    Hysteresis,
    /// The Coulomb part of the coupling with this index.
    Coupling(usize),
}

/// One bristle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bristle {
    pub part: Part,
    /// Joint, from 0.
    pub joint: usize,
    /// Coordinates and factors whose weighted sum is the bristle's velocity.
    pub along: [(usize, f64); 2],
    /// `X`, rad.
    pub travel: f64,
    /// `v_d`, rad/s.
    pub fade: f64,
}

impl Bristle {
    /// Travel of the bristles that replace a plain sign, rad: well below an encoder's resolution.
    pub const SIGN: f64 = 1e-5;

    pub fn velocity(&self, v: &[f64]) -> f64 {
        self.along.iter().map(|&(i, factor)| factor * v[i]).sum()
    }

    /// `dz/dt`.
    pub fn rate(&self, v: f64, z: f64) -> f64 {
        (v - v.abs() * z) / self.travel
    }

    /// `b exp(-(v / v_d)^2)`, with `b` such that damping adds at most a tenth of the level.
    fn damping(&self, v: f64) -> f64 {
        let ratio = v / self.fade;
        0.2 * self.travel / self.fade * libm::exp(-ratio * ratio)
    }

    /// Smooth substitute for `sign(v)`, about in `[-1, 1]`.
    pub fn sign(&self, v: f64, z: f64) -> f64 {
        z + self.damping(v) * self.rate(v, z)
    }

    /// Derivatives of [`Bristle::sign`] with respect to `z` and `v`, the latter without the fading
    /// of the damping.
    pub fn sign_slopes(&self, v: f64, z: f64) -> [f64; 2] {
        let damping = self.damping(v);
        [1.0 - damping * v.abs() / self.travel, damping * (1.0 - z * sign(v)) / self.travel]
    }

    /// Derivatives of [`Bristle::rate`] with respect to `v` and `z`.
    pub fn rate_slopes(&self, v: f64, z: f64) -> [f64; 2] {
        [(1.0 - z * sign(v)) / self.travel, -v.abs() / self.travel]
    }

    /// `z` after a travel (rad) in one direction: the exact solution.
    pub fn after(&self, travel: f64, z: f64) -> f64 {
        let s = sign(travel);
        s + (z - s) * libm::exp(-travel.abs() / self.travel)
    }
}

pub(super) fn sign(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x.signum() }
}
