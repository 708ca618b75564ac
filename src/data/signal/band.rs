//! Effect of the low-pass, and of the bursts it let through, on recorded positions, so that
//! computed series can be filtered in the same way.

use super::Filter;
use super::low_pass;
use crate::data::signal::breakaway_band::Derived;

impl Filter {
    /// The filtered series (even samples, `period` s apart), its first derivative (1/s) and its
    /// second (1/s^2).
    pub fn derivatives(self, x: &[f64], period: f64) -> [Vec<f64>; 3] {
        let Derived { q, dq, ddq } = self.through(x, period);
        [q, dq, ddq]
    }

    fn through(self, x: &[f64], period: f64) -> Derived {
        let mut y = x.to_vec();
        // A series shorter than the filter's transient is not filtered.
        if let Ok(sos) = low_pass(self.order, self.cutoff, period.recip()) {
            let pad = (1.0 / (period * self.cutoff)).ceil() as usize;
            sos.forward_backward(&mut y, pad.max(sos.scipy_padding()));
        }
        Derived::of(y, period)
    }
}

/// Filters that turned recorded positions into those of a motion.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Band {
    /// Low-pass of each joint; empty if there was none.
    pub narrow: Vec<Filter>,
    /// Wider low-pass of each joint, blended in during bursts; empty if there was none.
    pub wide: Vec<Filter>,
    /// Weight of the wider low-pass at each sample, joint-major; empty if it is zero everywhere.
    pub share: Vec<f64>,
}

impl Band {
    /// Band of the samples `range` out of `len` samples.
    pub fn cut(&self, len: usize, range: std::ops::Range<usize>) -> Self {
        let share = self.share.chunks_exact(len.max(1)).flat_map(|row| row[range.clone()].to_vec()).collect();
        Self { share, ..self.clone() }
    }

    /// Band of one joint, with the weights `share` of its samples.
    pub fn of(&self, joint: usize, share: Vec<f64>) -> Self {
        let own = |filters: &[Filter]| filters.get(joint).copied().into_iter().collect();
        Self { narrow: own(&self.narrow), wide: own(&self.wide), share }
    }

    /// Effect on an evenly sampled series of joint `joint`: the filtered series, its first
    /// derivative (1/s) and its second (1/s^2).
    pub fn seen(&self, joint: usize, x: &[f64], period: f64) -> [Vec<f64>; 3] {
        let through = |filter: Filter| filter.through(x, period);
        let mut seen = match self.narrow.get(joint) {
            Some(filter) => through(*filter),
            None => Derived::of(x.to_vec(), period),
        };
        let share = self.share.get(joint * x.len()..(joint + 1) * x.len()).unwrap_or(&[]);
        if let Some(filter) = self.wide.get(joint).filter(|_| share.iter().any(|s| *s != 0.0)) {
            seen.share_of(&through(*filter), share);
        }
        [seen.q, seen.dq, seen.ddq]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A step is rounded by the low-pass and stays sharper where the wider one has a weight; at a
    /// weight of one it is filtered by the wider one alone.
    #[test]
    fn a_share_of_the_wider_band() {
        let x: Vec<f64> = (0..400).map(|k| f64::from(u8::from(k >= 200))).collect();
        let of = |cutoff: f64| Filter { order: 4, cutoff };
        let (narrow, wide) = (vec![of(15.0)], of(40.0));
        let plain = Band { narrow: narrow.clone(), ..Band::default() }.seen(0, &x, 2e-3);
        let sharp = Band { narrow: vec![wide], ..Band::default() }.seen(0, &x, 2e-3);
        let band = |share: f64| Band { narrow: narrow.clone(), wide: vec![wide], share: vec![share; 400] };
        assert_eq!(band(0.0).seen(0, &x, 2e-3), plain);
        let most = |x: &[f64]| x.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
        for which in 0..3 {
            let (all, half) = (band(1.0).seen(0, &x, 2e-3), band(0.5).seen(0, &x, 2e-3));
            for k in 0..400 {
                assert!((all[which][k] - sharp[which][k]).abs() < 1e-9 * most(&sharp[which]).max(1.0));
                assert!((2.0 * half[which][k] - plain[which][k] - sharp[which][k]).abs() < 1e-6 * most(&sharp[which]));
            }
        }
        assert!(most(&sharp[1]) > 2.0 * most(&plain[1]));
        let cut = Band { share: (0..6).map(f64::from).collect(), ..Band::default() }.cut(3, 1..3);
        assert_eq!(cut.share, [1.0, 2.0, 4.0, 5.0]);
    }
}
