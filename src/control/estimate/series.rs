//! The wrench over a log, and its comparison with a reference.

use super::consistency::Consistency;
use super::method::Method;
use super::verdict::Verdict;

/// Names of the six components of a wrench.
pub const COMPONENTS: [&str; 6] = ["fx", "fy", "fz", "mx", "my", "mz"];

/// Estimates over a log, one value per used sample; wrenches of the surroundings on the tool, in
/// its axes, N and N m.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Series {
    /// Name of the log.
    pub name: String,
    /// Estimator used.
    pub method: Method,
    /// Time of each sample, s.
    pub time: Vec<f64>,
    /// Segment number of each sample.
    pub segment: Vec<usize>,
    /// Estimated wrenches, N and N m.
    pub wrench: Vec<[f64; 6]>,
    /// Half-widths of the 95 % band, N and N m.
    pub half: Vec<[f64; 6]>,
    /// Whether each component is observable; the band of one that is not is the prior.
    pub observable: Vec<[bool; 6]>,
    /// Surprise as a normal deviate, see [`Contact`](super::Contact).
    pub deviate: Vec<f64>,
    /// Whether contact is detected.
    pub touching: Vec<bool>,
    /// Whether static friction and contact are indistinguishable, see [`Contact`](super::Contact).
    pub undecided: Vec<bool>,
    /// Whether the sample is known to be without contact.
    pub free: Vec<bool>,
    /// Smallest singular value of the tool's Jacobian, angular rows times half a metre, m/rad: near
    /// zero at a singularity.
    pub dexterity: Vec<f64>,
    /// Measured wrench through the same low-pass; empty if it was not measured.
    pub measured: Vec<[f64; 6]>,
    /// Consistency of the torque errors without contact.
    pub in_free: Option<Consistency>,
    /// Consistency of the torque errors that no wrench explains, at any time: arms with more than
    /// six joints.
    pub unexplained: Option<Consistency>,
    /// Whether the bands can be relied upon, from the two checks above.
    pub verdict: Verdict,
    /// Torque subtracted as a bias, N m; empty if none was.
    pub bias: Vec<f64>,
    /// Joints, from 1, without dry friction in the model, and the static friction assumed as their
    /// upper bound, N m. It is in no band.
    pub assumed_friction: Vec<(usize, f64)>,
    /// Samples that the estimator could not use.
    pub stale: usize,
}

/// Comparison of one component with its reference, where the component is observable.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Comparison {
    /// Number of samples in which the component is observable; the other figures are of these.
    pub samples: usize,
    /// Share of samples in which the component is observable.
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
    /// Compares errors, given with their half-widths and whether the component is observable.
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
    /// Compares each component with the measured wrench; `None` if there is no measurement.
    pub fn against_measured(&self) -> Option<[Comparison; 6]> {
        (self.measured.len() == self.wrench.len() && !self.wrench.is_empty()).then(|| {
            std::array::from_fn(|i| {
                let error =
                    |s: usize| (self.wrench[s][i] - self.measured[s][i], self.half[s][i], self.observable[s][i]);
                Comparison::of((0..self.wrench.len()).map(error))
            })
        })
    }

    /// Compares each component with zero where there is no contact (the phantom force); `None`
    /// where that is nowhere known.
    pub fn phantom(&self) -> Option<[Comparison; 6]> {
        let free: Vec<usize> = (0..self.free.len()).filter(|&s| self.free[s]).collect();
        (!free.is_empty()).then(|| {
            let error = |s: usize, i: usize| (self.wrench[s][i], self.half[s][i], self.observable[s][i]);
            std::array::from_fn(|i| Comparison::of(free.iter().map(|&s| error(s, i))))
        })
    }

    /// Share of samples with detected contact, among those whose `free` has the given value.
    pub fn touch_share(&self, free: bool) -> f64 {
        let picked: Vec<bool> =
            self.touching.iter().zip(&self.free).filter(|(_, f)| **f == free).map(|(t, _)| *t).collect();
        picked.iter().filter(|t| **t).count() as f64 / picked.len().max(1) as f64
    }
}
