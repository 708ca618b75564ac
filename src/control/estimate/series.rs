//! The wrench over a log, and how it compares.

use super::consistency::Consistency;
use super::method::Method;
use super::verdict::Verdict;

/// Names of the components.
pub const COMPONENTS: [&str; 6] = ["fx", "fy", "fz", "mx", "my", "mz"];

/// One value per used sample; wrenches of the surroundings on the tool, in its axes, N and N m.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Series {
    /// Name of the log.
    pub name: String,
    /// How it was estimated.
    pub method: Method,
    /// s
    pub time: Vec<f64>,
    /// Number of the segment.
    pub segment: Vec<usize>,
    /// Estimates.
    pub wrench: Vec<[f64; 6]>,
    /// Half-widths of the 95 % band.
    pub half: Vec<[f64; 6]>,
    /// Whether each component is observable: if not, its band is the prior.
    pub observable: Vec<[bool; 6]>,
    /// The surprise as a normal deviate, see [`Contact`](super::Contact).
    pub deviate: Vec<f64>,
    /// Whether something touches.
    pub touching: Vec<bool>,
    /// Whether static friction or contact can't be observable apart, see
    /// [`Contact`](super::Contact).
    pub undecided: Vec<bool>,
    /// Whether it is known that nothing does.
    pub free: Vec<bool>,
    /// Smallest singular value of the tool's Jacobian, angular rows times half a metre, m/rad: near
    /// zero at a singularity.
    pub dexterity: Vec<f64>,
    /// Measured, with the same low-pass; empty where it was not.
    pub measured: Vec<[f64; 6]>,
    /// Of the torque errors where nothing touches.
    pub in_free: Option<Consistency>,
    /// Of the torque errors that no wrench explains, anywhere: arms with more than six joints.
    pub unexplained: Option<Consistency>,
    /// Whether the bands can be relied upon: of the two checks before.
    pub verdict: Verdict,
    /// Torque that was taken off as a bias, N m; empty if none was.
    pub bias: Vec<f64>,
    /// Joints, from 1, of which the model has no dry friction, with what static friction is taken
    /// to hold at most, N m. It is in no band.
    pub assumed_friction: Vec<(usize, f64)>,
    /// Samples that the estimator could not use.
    pub stale: usize,
}

/// Comparison of one component with its reference, where it is observable.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Comparison {
    /// Samples in which the component is observable; all figures are of these.
    pub samples: usize,
    /// Their share of all.
    pub observable: f64,
    /// Mean error.
    pub mean: f64,
    /// Root mean square error.
    pub rms: f64,
    /// Largest error.
    pub largest: f64,
    /// Mean half-width of the 95 % band.
    pub half: f64,
    /// Share of samples whose band holds the true value.
    pub inside: f64,
}

impl Comparison {
    /// Of errors with their half-widths, and whether the component is observable.
    pub fn of(errors: impl Iterator<Item = (f64, f64, bool)>) -> Self {
        let (mut c, mut all) = (Self::default(), 0_u32);
        for (error, half, observable) in errors {
            all += 1;
            if !observable {
                continue;
            }
            c.samples += 1;
            c.mean += error;
            c.rms += error * error;
            c.largest = c.largest.max(error.abs());
            c.half += half;
            c.inside += f64::from(u8::from(error.abs() <= half));
        }
        let n = c.samples.max(1) as f64;
        let observable = c.samples as f64 / f64::from(all.max(1));
        Self { observable, mean: c.mean / n, rms: (c.rms / n).sqrt(), half: c.half / n, inside: c.inside / n, ..c }
    }
}

impl Series {
    /// Each component against what was measured; `None` where nothing was.
    pub fn against_measured(&self) -> Option<[Comparison; 6]> {
        (self.measured.len() == self.wrench.len() && !self.wrench.is_empty()).then(|| {
            std::array::from_fn(|i| {
                let error =
                    |s: usize| (self.wrench[s][i] - self.measured[s][i], self.half[s][i], self.observable[s][i]);
                Comparison::of((0..self.wrench.len()).map(error))
            })
        })
    }

    /// The phantom force: each component where nothing touches; `None` where that is nowhere known.
    pub fn phantom(&self) -> Option<[Comparison; 6]> {
        let free: Vec<usize> = (0..self.free.len()).filter(|&s| self.free[s]).collect();
        (!free.is_empty()).then(|| {
            let error = |s: usize, i: usize| (self.wrench[s][i], self.half[s][i], self.observable[s][i]);
            std::array::from_fn(|i| Comparison::of(free.iter().map(|&s| error(s, i))))
        })
    }

    /// Share of samples in which something is said to touch, among those with `free` as asked.
    pub fn touch_share(&self, free: bool) -> f64 {
        let picked: Vec<bool> =
            self.touching.iter().zip(&self.free).filter(|(_, f)| **f == free).map(|(t, _)| *t).collect();
        picked.iter().filter(|t| **t).count() as f64 / picked.len().max(1) as f64
    }
}
