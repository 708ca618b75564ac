//! The sign of a velocity, as a bristle: a state with a memory of a little travel, so that joints
//! stick, creep nowhere, and break away.
//!
//! `dz/dt = (v - |v| z) / X` (P. R. Dahl, 1968; Canudas de Wit et al. 1995); friction is a level
//! times `z + b dz/dt exp(-(v / v_d)^2)`, the damping fading with speed so that friction always
//! takes energy (H. Olsson, K. J. Astrom et al., *Friction models and friction compensation*, Eur.
//! J. Control 4, 1998). After a travel of some `X` in one direction `z` is `sign(v)`.

/// Role of a bristle's force.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    /// All laws of a joint with `sign(v)` in them.
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
    /// Its joint, from 0.
    pub joint: usize,
    /// Its velocity is the sum of these coordinates' times the factors.
    pub along: [(usize, f64); 2],
    /// `X`, rad.
    pub travel: f64,
    /// `v_d`, rad/s.
    pub fade: f64,
}

impl Bristle {
    /// Travel of the bristles that stand for a plain sign, rad: well below what an encoder shows.
    pub const SIGN: f64 = 1e-5;

    pub fn velocity(&self, v: &[f64]) -> f64 {
        self.along.iter().map(|&(i, factor)| factor * v[i]).sum()
    }

    /// `dz/dt`.
    pub fn rate(&self, v: f64, z: f64) -> f64 {
        (v - v.abs() * z) / self.travel
    }

    /// `b exp(-(v / v_d)^2)`: b such that damping adds a tenth of the level at most.
    fn damping(&self, v: f64) -> f64 {
        let ratio = v / self.fade;
        0.2 * self.travel / self.fade * libm::exp(-ratio * ratio)
    }

    /// Substitute for `sign(v)`, in about `[-1, 1]`.
    pub fn sign(&self, v: f64, z: f64) -> f64 {
        z + self.damping(v) * self.rate(v, z)
    }

    /// Derivatives of [`Bristle::sign`] by `z` and, the fading left out, by `v`.
    pub fn sign_slopes(&self, v: f64, z: f64) -> [f64; 2] {
        let damping = self.damping(v);
        [1.0 - damping * v.abs() / self.travel, damping * (1.0 - z * sign(v)) / self.travel]
    }

    /// Derivatives of [`Bristle::rate`] by `v` and `z`.
    pub fn rate_slopes(&self, v: f64, z: f64) -> [f64; 2] {
        [(1.0 - z * sign(v)) / self.travel, -v.abs() / self.travel]
    }

    /// `z` after a travel in one direction: the exact solution.
    pub fn after(&self, travel: f64, z: f64) -> f64 {
        let s = sign(travel);
        s + (z - s) * libm::exp(-travel.abs() / self.travel)
    }
}

pub(super) fn sign(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { x.signum() }
}
