//! Joint motion as a piecewise quintic, stored as position, velocity and acceleration at knots.

use nalgebra::DMatrix;

use crate::data::trajectory::Instant;

use super::strokes::rest_to_rest;
use super::task::Task;
use super::track::Line;
use crate::apps::painting::cost::Scored;
use crate::numerics::chebyshev::Chebyshev;

/// A quintic spline with continuous acceleration. Between two knots it is the polynomial of fifth
/// order through position, velocity and acceleration at both (a B-spline with triple inner knots).
#[derive(Debug, Clone, Default, PartialEq)]
pub struct PaintingMotion {
    /// Knots, s, ascending from 0.
    pub times: Vec<f64>,
    /// Positions at the knots, rad or m, one row per knot.
    pub q: Vec<Vec<f64>>,
    /// Velocities at the knots, rad/s or m/s.
    pub dq: Vec<Vec<f64>>,
    /// Accelerations at the knots, rad/s^2 or m/s^2.
    pub ddq: Vec<Vec<f64>>,
}

/// Reason why a branch is not smooth enough for a spline.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub(super) enum RoughBranch {
    /// No posture near the previous one.
    #[error(
        "the arm does not follow the path at {0:.3?} of the wall (m): no posture is near the previous one; move the \
         wall, or paint less of it"
    )]
    Lost([f64; 3]),
    /// A joint's path does not converge as a polynomial series.
    #[error(
        "joint {joint} turns too sharply at {place:.3?} of the wall (m), since the arm is all but singular there; move \
         the wall, or paint less of it"
    )]
    Sharp {
        /// The joint, from 1.
        joint: usize,
        /// Position of the roller: wall coordinates and distance, m.
        place: [f64; 3],
    },
}

impl PaintingMotion {
    /// Number of joints.
    pub fn dof(&self) -> usize {
        self.q.first().map_or(0, Vec::len)
    }

    /// Duration, s.
    pub fn duration(&self) -> f64 {
        self.times.last().copied().unwrap_or(0.0)
    }

    /// Evaluates the motion at time `t`, s; it is at rest before the start and after the end.
    pub fn at(&self, t: f64) -> Instant {
        let n = self.dof();
        let mut instant = Instant { q: vec![0.0; n], dq: vec![0.0; n], ddq: vec![0.0; n], dddq: vec![0.0; n] };
        let rest = |row: Option<&Vec<f64>>, mut instant: Instant| {
            if let Some(row) = row {
                instant.q.clone_from(row);
            }
            instant
        };
        if t.is_nan() || t <= 0.0 {
            return rest(self.q.first(), instant);
        }
        if t >= self.duration() {
            return rest(self.q.last(), instant);
        }
        let k = self.times.partition_point(|x| *x <= t).clamp(1, self.times.len() - 1) - 1;
        let h = self.times[k + 1] - self.times[k];
        let u = (t - self.times[k]) / h;
        for j in 0..n {
            let at = |k: usize| [self.q[k][j], self.dq[k][j] * h, self.ddq[k][j] * h * h];
            let [x, v, a, b] = hermite(at(k), at(k + 1), u);
            (instant.q[j], instant.dq[j]) = (x, v / h);
            (instant.ddq[j], instant.dddq[j]) = (a / (h * h), b / (h * h * h));
        }
        instant
    }

    /// Builds the motion from a candidate on its branch, leg by leg.
    ///
    /// # Errors
    /// Returns an error if the branch is not smooth enough for a spline.
    pub(super) fn new(task: &Task<'_>, scored: &Scored) -> Result<Self, RoughBranch> {
        let n = task.dof();
        let mut motion = Self::default();
        let mut begin = 0.0;
        let mut here = scored.start.clone();
        for (leg, (time, _)) in scored.legs.iter().zip(&scored.times) {
            let smooth = Smooth::new(task, scored, &leg.line, &here)?;
            let knots = smooth.knots();
            let shares: Vec<f64> = (0..=knots).map(|k| k as f64 / knots as f64).collect();
            let samples = smooth.at(&shares);
            let first = usize::from(!motion.times.is_empty());
            for (k, [x, v, a]) in samples.iter().enumerate().skip(first) {
                motion.times.push(begin + time * shares[k]);
                motion.q.push(x.clone());
                motion.dq.push(v.iter().map(|v| v / time).collect());
                motion.ddq.push(a.iter().map(|a| a / (time * time)).collect());
            }
            begin += time;
            here = samples.last().map_or_else(|| vec![0.0; n], |s| s[0].clone());
        }
        Ok(motion)
    }
}

/// Value and three derivatives with respect to the share `u` of the step, from value and two such
/// derivatives at both ends.
fn hermite([q0, v0, a0]: [f64; 3], [q1, v1, a1]: [f64; 3], u: f64) -> [f64; 4] {
    let d = q1 - q0;
    let c = [
        q0,
        v0,
        0.5 * a0,
        10.0 * d - 6.0 * v0 - 4.0 * v1 - 1.5 * a0 + 0.5 * a1,
        -15.0 * d + 8.0 * v0 + 7.0 * v1 + 1.5 * a0 - a1,
        6.0 * d - 3.0 * (v0 + v1) - 0.5 * (a0 - a1),
    ];
    [
        c[0] + u * (c[1] + u * (c[2] + u * (c[3] + u * (c[4] + u * c[5])))),
        c[1] + u * (2.0 * c[2] + u * (3.0 * c[3] + u * (4.0 * c[4] + u * 5.0 * c[5]))),
        2.0 * c[2] + u * (6.0 * c[3] + u * (12.0 * c[4] + u * 20.0 * c[5])),
        6.0 * c[3] + u * (24.0 * c[4] + u * 60.0 * c[5]),
    ]
}

/// A leg's branch as Chebyshev polynomials on equal panels, accurate to rounding.
struct Smooth {
    chebyshev: Chebyshev,
    panels: Vec<DMatrix<f64>>,
}

/// Polynomial order of a panel.
const ORDER: usize = 20;
/// Largest truncation error of a panel, rad or m.
const TAIL: f64 = 2e-12;
/// Number of panels of a leg beyond which they are not halved, and a thousand times that error is
/// accepted.
const PANELS: usize = 512;
/// Largest error of the quintic between knots, rad or m.
const BETWEEN: f64 = 1e-11;

impl Smooth {
    fn new(task: &Task<'_>, scored: &Scored, line: &Line, start: &[f64]) -> Result<Self, RoughBranch> {
        let along = |shares: &[f64], here: &[f64]| {
            let all = task.postures(&scored.roller, line, shares);
            task.follow(&all, here).map_err(|k| RoughBranch::Lost(line.place(shares[k])))
        };
        let sharp = |joint: usize, share: f64| RoughBranch::Sharp { joint: joint + 1, place: line.place(share) };
        Self::through(along, start, sharp)
    }

    /// Approximates postures `along` a leg, of which there is one row per share of the leg, next to the
    /// given posture. `sharp` makes the error where joint (from 0) and share do not converge.
    fn through<E>(
        along: impl Fn(&[f64], &[f64]) -> Result<DMatrix<f64>, E>,
        start: &[f64],
        sharp: impl Fn(usize, f64) -> E,
    ) -> Result<Self, E> {
        let chebyshev = Chebyshev::new(ORDER);
        let mut count = 1;
        loop {
            let mut panels = Vec::with_capacity(count);
            let mut here = start.to_vec();
            let (mut tail, mut worst) = (0.0, (0, 0));
            for p in 0..count {
                let shares: Vec<f64> = chebyshev.points.iter().map(|s| (p as f64 + s) / count as f64).collect();
                let q = along(&shares, &here)?;
                here = q.row(ORDER).iter().copied().collect();
                for j in 0..q.ncols() {
                    let own = chebyshev.tail(|k| q[(k, j)]);
                    if own > tail {
                        (tail, worst) = (own, (j, p));
                    }
                }
                panels.push(q);
            }
            if tail <= TAIL || count >= PANELS {
                if tail > 1e3 * TAIL {
                    return Err(sharp(worst.0, (worst.1 as f64 + 0.5) / count as f64));
                }
                return Ok(Self { chebyshev, panels });
            }
            count *= 2;
        }
    }

    /// Position and its first two derivatives with respect to the share of time, at these shares.
    fn at(&self, shares: &[f64]) -> Vec<[Vec<f64>; 3]> {
        let count = self.panels.len() as f64;
        shares
            .iter()
            .map(|&u| {
                let [s0, s1, s2, _] = rest_to_rest(u);
                let place = s0.clamp(0.0, 1.0) * count;
                let p = (place.floor().max(0.0) as usize).min(self.panels.len() - 1);
                let rows = self.chebyshev.rows(&[place - p as f64]);
                let [x, x1, x2] = [0, 1, 2].map(|d| &rows[d] * &self.panels[p]);
                let n = x.ncols();
                let by = |d: usize, j: usize| [x1[(0, j)] * count, x2[(0, j)] * count * count][d];
                [
                    (0..n).map(|j| x[(0, j)]).collect(),
                    (0..n).map(|j| by(0, j) * s1).collect(),
                    (0..n).map(|j| by(1, j) * s1 * s1 + by(0, j) * s2).collect(),
                ]
            })
            .collect()
    }

    /// Number of pieces at which the quintics between knots reproduce the branch to [`BETWEEN`].
    fn knots(&self) -> usize {
        let mut knots = 16;
        while knots < 1024 {
            let shares: Vec<f64> = (0..=2 * knots).map(|k| k as f64 / (2 * knots) as f64).collect();
            let samples = self.at(&shares);
            let h = 1.0 / knots as f64;
            let off = (0..knots).flat_map(|k| {
                let [a, middle, b] = [&samples[2 * k], &samples[2 * k + 1], &samples[2 * k + 2]];
                (0..a[0].len()).map(move |j| {
                    let end = |s: &[Vec<f64>; 3]| [s[0][j], s[1][j] * h, s[2][j] * h * h];
                    (hermite(end(a), end(b), 0.5)[0] - middle[0][j]).abs()
                })
            });
            if off.fold(0.0, f64::max) <= BETWEEN {
                break;
            }
            knots *= 2;
        }
        knots
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Near a singularity a joint turns by half a turn within a small share of the leg.
    fn half_turn_within(width: f64) -> Result<Smooth, (usize, f64)> {
        let q = |share: f64, j: usize| if j == 1 { ((share - 0.3) / width).atan() } else { share };
        let along = |shares: &[f64], _: &[f64]| Ok(DMatrix::from_fn(shares.len(), 2, |k, j| q(shares[k], j)));
        Smooth::through(along, &[0.0, 0.0], |joint, share| (joint, share))
    }

    #[test]
    fn a_sharp_turn_has_more_panels_up_to_a_limit() {
        let panels = |width: f64| half_turn_within(width).map(|smooth| smooth.panels.len()).ok();
        assert!(panels(1.0) < Some(8) && panels(1e-2) > panels(1.0));
        let smooth = half_turn_within(3e-3).ok().unwrap();
        assert!((65..=PANELS).contains(&smooth.panels.len()), "{}", smooth.panels.len());
        // Where the turn is: the time at which a motion from rest to rest has gone so far.
        let (mut low, mut high) = (0.0, 1.0);
        while high - low > 1e-15 {
            let middle = 0.5 * (low + high);
            if rest_to_rest(middle)[0] < 0.3 { low = middle } else { high = middle }
        }
        let [q, dq, _] = &smooth.at(&[low])[0];
        let [share, speed, ..] = rest_to_rest(low);
        assert!((q[0] - share).abs() < 1e-12 && q[1].abs() < 1e-9 && (dq[1] / (speed / 3e-3) - 1.0).abs() < 1e-6);
        let (joint, share) = half_turn_within(1e-7).err().unwrap();
        assert!(joint == 1 && (share - 0.3).abs() < 1.0 / PANELS as f64, "{joint} {share}");
    }

    #[test]
    fn a_lost_posture_is_reported() {
        let along = |_: &[f64], here: &[f64]| Err(here.to_vec());
        assert_eq!(Smooth::through(along, &[0.5], |_, _| Vec::new()).err(), Some(vec![0.5]));
    }
}
