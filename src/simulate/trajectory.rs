//! Desired motion: knots, with a quintic between neighbours.

use std::ops::Range;

/// Desired motion. Between two knots each joint follows the quintic with the position, velocity and
/// acceleration of both.
#[derive(Debug, Clone, PartialEq)]
pub struct Trajectory {
    dof: usize,
    t: Vec<f64>,
    /// Joint-major, `dof * knots`.
    q: Vec<f64>,
    dq: Vec<f64>,
    ddq: Vec<f64>,
    /// Torques for torque control, joint-major, N m; empty without them.
    tau: Vec<f64>,
}

/// Reasons why a trajectory can't be played.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum TrajectoryError {
    /// Fewer than two rows.
    #[error("the trajectory has {0} rows; it takes at least two")]
    TooShort(usize),
    /// Time that does not ascend.
    #[error("the trajectory's time does not ascend at row {row}: {from} s, then {to} s")]
    Time {
        /// Row of the later time, from 1.
        row: usize,
        /// Earlier time, s.
        from: f64,
        /// Later time, s.
        to: f64,
    },
    /// A duration that gives too many rows at 1 kHz.
    #[error("the motion lasts {0} s; a motion to be simulated lasts 10000 s at most (is its time in ms?)")]
    TooLong(f64),
    /// A value that is NaN or infinite.
    #[error("the trajectory holds a value that is not finite")]
    NotFinite,
    /// A number of values that does not match the number of joints.
    #[error("the trajectory has {found} values of {what}, not {expected}")]
    Length {
        /// Name of the column.
        what: &'static str,
        /// Number of values.
        found: usize,
        /// Joints times rows.
        expected: usize,
    },
}

/// Longest duration of a spline or Fourier series, s.
const LONGEST: f64 = 1e4;

/// Position, velocity and acceleration of a joint.
pub type Point = [f64; 3];

impl Trajectory {
    /// Motion through knots, joint-major. Missing velocities come from the cubic spline through the
    /// positions, whose end slopes are those of the cubic through the four outermost knots. Missing
    /// accelerations come from the spline through the velocities.
    pub fn new(
        dof: usize,
        t: Vec<f64>,
        q: Vec<f64>,
        dq: Option<Vec<f64>>,
        ddq: Option<Vec<f64>>,
    ) -> Result<Self, TrajectoryError> {
        let rows = t.len();
        if rows < 2 {
            return Err(TrajectoryError::TooShort(rows));
        }
        for (what, values) in [("q", Some(&q)), ("dq", dq.as_ref()), ("ddq", ddq.as_ref())] {
            if let Some(values) = values {
                if values.len() != dof * rows {
                    return Err(TrajectoryError::Length { what, found: values.len(), expected: dof * rows });
                }
                if !values.iter().all(|v| v.is_finite()) {
                    return Err(TrajectoryError::NotFinite);
                }
            }
        }
        if !t.iter().all(|v| v.is_finite()) {
            return Err(TrajectoryError::NotFinite);
        }
        if let Some(row) = t.windows(2).position(|w| w[1] <= w[0]) {
            return Err(TrajectoryError::Time { row: row + 2, from: t[row], to: t[row + 1] });
        }
        let slopes = |values: &[f64]| values.chunks(rows).flat_map(|v| spline_slopes(&t, v)).collect::<Vec<f64>>();
        let dq = dq.unwrap_or_else(|| slopes(&q));
        let ddq = ddq.unwrap_or_else(|| slopes(&dq));
        Ok(Self { dof, t, q, dq, ddq, tau: Vec::new() })
    }

    /// Motion of a spline or a Fourier series. It is exact if the pieces of a spline have degree 5
    /// or less and a continuous second derivative; else it passes through its values at 1 kHz.
    ///
    /// # Errors
    /// If its duration is zero, or more than 10000 s.
    pub fn of_motion(motion: &crate::data::trajectory::Trajectory) -> Result<Self, TrajectoryError> {
        use crate::data::trajectory::{Trajectory as Motion, times};
        if motion.duration() > LONGEST || motion.duration().is_nan() {
            return Err(TrajectoryError::TooLong(motion.duration()));
        }
        let t = match motion {
            Motion::Spline(spline) if spline.degree <= 5 => {
                let mut knots = spline.knots.clone();
                knots.dedup();
                // Splitting a quintic leaves it unchanged. Rows about 1 ms apart, as in a CSV, give
                // `motion_warnings` the same data.
                let parts = |w: &[f64]| ((w[1] - w[0]) * 1000.0 + 1e-6).floor().clamp(1.0, 1e6) as usize;
                let inner = knots.windows(2).flat_map(|w| {
                    let n = parts(w);
                    let (from, step) = (w[0], (w[1] - w[0]) / n as f64);
                    (0..n).map(move |k| from + step * k as f64)
                });
                inner.chain(knots.last().copied()).collect()
            }
            _ => times(motion.duration(), 1000.0),
        };
        let (n, rows) = (motion.dof(), t.len());
        let mut columns = [(); 3].map(|()| vec![0.0; n * rows]);
        for (row, &t) in t.iter().enumerate() {
            let at = motion.at(t);
            for (column, values) in columns.iter_mut().zip([&at.q, &at.dq, &at.ddq]) {
                values.iter().enumerate().for_each(|(joint, value)| column[joint * rows + row] = *value);
            }
        }
        let [q, dq, ddq] = columns;
        Self::new(n, t, q, Some(dq), Some(ddq))
    }

    /// Adds torques, joint-major, N m, for torque control; they are interpolated linearly.
    pub fn with_torques(mut self, tau: Vec<f64>) -> Result<Self, TrajectoryError> {
        let expected = self.dof * self.t.len();
        if tau.len() != expected {
            return Err(TrajectoryError::Length { what: "tau", found: tau.len(), expected });
        }
        if !tau.iter().all(|v| v.is_finite()) {
            return Err(TrajectoryError::NotFinite);
        }
        self.tau = tau;
        Ok(self)
    }

    /// Rest at a position for `duration` s: the start of a free swing.
    pub fn rest(q: &[f64], duration: f64) -> Result<Self, TrajectoryError> {
        let twice: Vec<f64> = q.iter().flat_map(|&q| [q, q]).collect();
        let zero = vec![0.0; twice.len()];
        Self::new(q.len(), vec![0.0, duration], twice, Some(zero.clone()), Some(zero))
    }

    /// Degrees of freedom.
    pub fn dof(&self) -> usize {
        self.dof
    }

    /// First and last time, s.
    pub fn span(&self) -> Range<f64> {
        self.t[0]..self.t[self.t.len() - 1]
    }

    /// Smallest and largest position of a joint's knots.
    pub fn reach(&self, joint: usize) -> [f64; 2] {
        let q = &self.q[joint * self.t.len()..(joint + 1) * self.t.len()];
        q.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| [low.min(*v), high.max(*v)])
    }

    /// Largest mean speed of a joint between two knots, and the time of the first of them, s.
    pub fn fastest(&self, joint: usize) -> [f64; 2] {
        let q = &self.q[joint * self.t.len()..(joint + 1) * self.t.len()];
        let speeds = self.t.windows(2).zip(q.windows(2)).map(|(t, q)| [((q[1] - q[0]) / (t[1] - t[0])).abs(), t[0]]);
        speeds.fold([0.0, self.t[0]], |most, one| if one[0] > most[0] { one } else { most })
    }

    /// Relative difference between a joint's velocities and the slope of its positions. It is the
    /// root mean square of the difference divided by that of the slope; zero without motion.
    pub fn off_slope(&self, joint: usize) -> f64 {
        let knots = joint * self.t.len()..(joint + 1) * self.t.len();
        let (q, dq) = (&self.q[knots.clone()], &self.dq[knots]);
        let (mut off, mut all) = (0.0, 0.0);
        for ((t, q), dq) in self.t.windows(2).zip(q.windows(2)).zip(dq.windows(2)) {
            let (h, slope) = (t[1] - t[0], (q[1] - q[0]) / (t[1] - t[0]));
            off += h * (slope - 0.5 * (dq[0] + dq[1])).powi(2);
            all += h * slope * slope;
        }
        if all > 0.0 { (off / all).sqrt() } else { 0.0 }
    }

    /// Whether the trajectory has torques.
    pub fn has_torques(&self) -> bool {
        !self.tau.is_empty()
    }

    /// Index of the interval of a time; `hint` is the result of the last search.
    fn interval(&self, t: f64, hint: &mut usize) -> usize {
        let last = self.t.len() - 2;
        let fits = |k: usize| (k == 0 || self.t[k] <= t) && (k == last || t < self.t[k + 1]);
        if !fits(*hint) {
            *hint = if *hint < last && fits(*hint + 1) {
                *hint + 1
            } else {
                self.t.partition_point(|&knot| knot <= t).saturating_sub(1).min(last)
            };
        }
        *hint
    }

    /// Desired motion of every joint; at rest before the first and after the last knot.
    pub fn at(&self, t: f64, hint: &mut usize, points: &mut [Point]) {
        let rows = self.t.len();
        let inside = t.clamp(self.t[0], self.t[rows - 1]);
        let k = self.interval(inside, hint);
        let h = self.t[k + 1] - self.t[k];
        let s = (inside - self.t[k]) / h;
        for (j, point) in points.iter_mut().enumerate() {
            let at = j * rows + k;
            let knot = |i: usize| [self.q[i], self.dq[i] * h, self.ddq[i] * h * h];
            let [x, v, a] = quintic(knot(at), knot(at + 1), s);
            *point = if t == inside { [x, v / h, a / (h * h)] } else { [x, 0.0, 0.0] };
        }
    }

    /// Torques at a time, N m; zero if the trajectory has none.
    pub fn torques_at(&self, t: f64, hint: &mut usize, tau: &mut [f64]) {
        if self.tau.is_empty() {
            tau.fill(0.0);
            return;
        }
        let rows = self.t.len();
        let inside = t.clamp(self.t[0], self.t[rows - 1]);
        let k = self.interval(inside, hint);
        let s = (inside - self.t[k]) / (self.t[k + 1] - self.t[k]);
        for (j, tau) in tau.iter_mut().enumerate() {
            let at = j * rows + k;
            *tau = self.tau[at] + s * (self.tau[at + 1] - self.tau[at]);
        }
    }
}

/// Value and two derivatives at `s` of the quintic on `[0, 1]` with these values and derivatives at
/// its ends.
fn quintic(a: Point, b: Point, s: f64) -> Point {
    let d = b[0] - a[0] - a[1] - 0.5 * a[2];
    let e = b[1] - a[1] - a[2];
    let f = b[2] - a[2];
    let c3 = 10.0 * d - 4.0 * e + 0.5 * f;
    let c4 = -15.0 * d + 7.0 * e - f;
    let c5 = 6.0 * d - 3.0 * e + 0.5 * f;
    [
        a[0] + s * (a[1] + s * (0.5 * a[2] + s * (c3 + s * (c4 + s * c5)))),
        a[1] + s * (a[2] + s * (3.0 * c3 + s * (4.0 * c4 + s * 5.0 * c5))),
        a[2] + s * (6.0 * c3 + s * (12.0 * c4 + s * 20.0 * c5)),
    ]
}

/// Slopes at the knots of the cubic spline through `(t, y)` with given end slopes (de Boor, *A
/// Practical Guide to Splines*, chapter IV).
fn spline_slopes(t: &[f64], y: &[f64]) -> Vec<f64> {
    let n = t.len();
    let rise = |k: usize| (y[k + 1] - y[k]) / (t[k + 1] - t[k]);
    if n == 2 {
        return vec![rise(0); 2];
    }
    let step = |k: usize| t[k + 1] - t[k];
    let mut slopes = vec![0.0; n];
    let near: Vec<usize> = (0..n.min(4)).collect();
    let far: Vec<usize> = near.iter().map(|k| n - 1 - k).collect();
    slopes[0] = end_slope(t, y, &near);
    slopes[n - 1] = end_slope(t, y, &far);
    // h[k] m[k-1] + 2 (h[k-1] + h[k]) m[k] + h[k-1] m[k+1] = 3 (h[k] d[k-1] + h[k-1] d[k])
    let (mut upper, mut right) = (vec![0.0; n], vec![0.0; n]);
    right[0] = slopes[0];
    for k in 1..n - 1 {
        let (before, after) = (step(k - 1), step(k));
        let pivot = 2.0 * (before + after) - after * upper[k - 1];
        upper[k] = before / pivot;
        right[k] = (3.0 * (after * rise(k - 1) + before * rise(k)) - after * right[k - 1]) / pivot;
    }
    for k in (1..n - 1).rev() {
        slopes[k] = right[k] - upper[k] * slopes[k + 1];
    }
    slopes
}

/// Derivative, at the first of these knots, of the polynomial through all of them (Lagrange).
fn end_slope(t: &[f64], y: &[f64], knots: &[usize]) -> f64 {
    let end = knots[0];
    let mut slope = 0.0;
    for &k in &knots[1..] {
        let others = || knots[1..].iter().filter(move |&&i| i != k);
        let weight: f64 = others().map(|&i| (t[end] - t[i]) / (t[k] - t[i])).product();
        slope += (y[k] - y[end]) * weight / (t[k] - t[end]);
    }
    slope
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sine(step: f64, with: usize) -> Trajectory {
        let t: Vec<f64> = (0..=(4.0 / step) as usize).map(|k| k as f64 * step).collect();
        let of = |f: fn(f64) -> f64| t.iter().map(|&t| f(2.0 * t)).collect::<Vec<f64>>();
        let dq = (with > 0).then(|| of(|x| 2.0 * x.cos()));
        let ddq = (with > 1).then(|| of(|x| -4.0 * x.sin()));
        Trajectory::new(1, t.clone(), of(f64::sin), dq, ddq).unwrap()
    }

    #[test]
    fn between_knots_the_motion_is_smooth() {
        for (with, accuracy) in [(0, [2e-5, 2e-3, 1e-1]), (1, [1e-6, 2e-5, 2e-3]), (2, [1e-9, 1e-7, 1e-5])] {
            let trajectory = sine(0.05, with);
            let (mut hint, mut point) = (0, [[0.0; 3]]);
            for k in 0..4001 {
                let t = f64::from(k) * 1e-3;
                trajectory.at(t, &mut hint, &mut point);
                let exact = [(2.0 * t).sin(), 2.0 * (2.0 * t).cos(), -4.0 * (2.0 * t).sin()];
                for i in 0..3 {
                    assert!((point[0][i] - exact[i]).abs() < accuracy[i], "{with} {t}: {point:?} {exact:?}");
                }
            }
        }
    }

    #[test]
    fn it_rests_outside_and_finds_its_place_again() {
        let trajectory = sine(0.1, 2);
        let mut point = [[0.0; 3]];
        let mut hint = 0;
        trajectory.at(9.0, &mut hint, &mut point);
        assert_eq!(point[0], [8.0f64.sin(), 0.0, 0.0]);
        trajectory.at(0.0, &mut hint, &mut point);
        assert_eq!((hint, point[0]), (0, [0.0, 2.0, -0.0]));
        trajectory.at(2.0, &mut hint, &mut point);
        assert!((point[0][0] - 4.0f64.sin()).abs() < 1e-12);
    }

    #[test]
    fn what_is_no_motion_is_refused() {
        assert_eq!(Trajectory::new(1, vec![0.0], vec![0.0], None, None), Err(TrajectoryError::TooShort(1)));
        let back = Trajectory::new(1, vec![0.0, 1.0, 1.0], vec![0.0; 3], None, None);
        assert_eq!(back, Err(TrajectoryError::Time { row: 3, from: 1.0, to: 1.0 }));
        let nan = Trajectory::new(1, vec![0.0, 1.0], vec![0.0, f64::NAN], None, None);
        assert_eq!(nan, Err(TrajectoryError::NotFinite));
    }
}
