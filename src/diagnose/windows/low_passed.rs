//! Recordings behind a further low-pass of the positions.

use std::borrow::Cow;

use super::recording::{Recording, Stretch};
use crate::data::signal::Filter;

/// A low-pass of the positions below their own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PositionBand {
    /// Cutoff, Hz.
    pub cutoff: f64,
    /// Share of the squared error of refitted models that it removes: geometric mean over joints.
    pub removes: f64,
}

/// Recordings behind this low-pass, if there is one.
pub(in crate::diagnose) fn in_band<'a>(
    recordings: &'a [Recording],
    band: Option<&PositionBand>,
) -> Cow<'a, [Recording]> {
    match band {
        Some(band) => Cow::Owned(recordings.iter().map(|r| r.low_passed(band.cutoff)).collect()),
        None => Cow::Borrowed(recordings),
    }
}

impl Recording {
    /// The recording with the positions of all joints low-passed at `cutoff`, Hz, forward and
    /// backward, where their band is wider; torques are unchanged.
    pub(in crate::diagnose) fn low_passed(&self, cutoff: f64) -> Self {
        Self { stretches: self.stretches.iter().map(|s| s.low_passed(cutoff)).collect(), ..self.clone() }
    }
}

impl Stretch {
    fn low_passed(&self, cutoff: f64) -> Self {
        let mut next = self.clone();
        let len = self.states.len;
        let before = self.beside[0].len() / self.velocity_noise.len().max(1);
        for j in 0..self.velocity_noise.len() {
            let Some(&known) = self.band.narrow.get(j).filter(|known| known.cutoff > cutoff) else { continue };
            let filter = Filter { cutoff, ..known };
            let own = j * len..(j + 1) * len;
            let [q, dq, ddq] = filter.derivatives(&self.positions_around(j), self.period);
            let inside = before..before + len;
            next.states.q[own.clone()].copy_from_slice(&q[inside.clone()]);
            next.states.dq[own.clone()].copy_from_slice(&dq[inside.clone()]);
            next.states.ddq[own.clone()].copy_from_slice(&ddq[inside]);
            // White noise of positions, up to the cutoff, and its derivatives.
            let less = cutoff / known.cutoff;
            next.velocity_noise[j] *= less.powf(1.5);
            if let Some(error) = next.error.get_mut(j) {
                (0..3).for_each(|k| error[k] *= less.powf(0.5 + k as f64));
            }
            next.band.narrow[j] = filter;
            if let Some(share) = next.band.share.get_mut(own) {
                share.fill(0.0);
            }
        }
        next
    }
}
