//! Motions that are linear in their search variables, of the same family for every joint, at rest
//! at both ends.

use std::f64::consts::PI;

use crate::data::trajectory::{Fourier, Spline, Trajectory, basis, clamped_knots, harmonic};

const DEGREE: usize = 5;

/// A family of motions. Each joint has [`Curve::count`] variables `x`, and its position is `sum of
/// row(t)[k] x[k]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Curve {
    /// Clamped quintic B-spline. Speed and acceleration are zero at both ends because the first
    /// three control points are one variable, and so are the last three.
    Spline {
        /// Duration, s.
        duration: f64,
        /// Number of intervals between way points.
        intervals: usize,
    },
    /// Fourier series with zero speed and acceleration where a period begins, so that it can be
    /// played from rest.
    Fourier {
        /// Duration of one period, s.
        period: f64,
        /// Highest multiple of the base frequency, at least 2.
        harmonics: usize,
        /// Number of periods played.
        periods: usize,
    },
}

/// Rows that bound a derivative everywhere, also between samples: if every `row x - middle` is at
/// most `share * half` in size, the derivative stays within `middle -+ half`.
pub(super) struct Bound {
    pub(super) rows: Vec<Vec<f64>>,
    pub(super) share: f64,
}

impl Curve {
    /// Number of search variables per joint.
    pub fn count(&self) -> usize {
        match *self {
            Self::Spline { intervals, .. } => intervals + 1,
            Self::Fourier { harmonics, .. } => 2 * harmonics - 1,
        }
    }

    /// Duration of the designed part, s: one period of a Fourier series.
    pub fn design_duration(&self) -> f64 {
        match *self {
            Self::Spline { duration, .. } => duration,
            Self::Fourier { period, .. } => period,
        }
    }

    /// Weights of the variables in the derivative of this order at `t`.
    pub fn row(&self, t: f64, order: usize) -> Vec<f64> {
        let mut row = vec![0.0; self.count()];
        match *self {
            Self::Spline { duration, intervals } => {
                let (first, values) = basis(&clamped_knots(DEGREE, duration, intervals), DEGREE, t, order);
                for (k, value) in values.iter().enumerate() {
                    row[variable(first + k, intervals)] += value;
                }
            }
            Self::Fourier { period, harmonics, .. } => {
                row[0] = if order == 0 { 1.0 } else { 0.0 };
                let (s1, c1) = harmonic(period, 1, t, order);
                for l in 2..=harmonics {
                    let (s, c) = harmonic(period, l, t, order);
                    // Amplitudes of speed for the sines and of acceleration for the cosines
                    // would be l and l^2 times these; the first harmonic cancels their values at
                    // t = 0.
                    let l = l as f64;
                    row[2 * (l as usize) - 3] = s / l - s1;
                    row[2 * (l as usize) - 2] = c / (l * l) - c1;
                }
            }
        }
        row
    }

    /// Bounds of the derivative of this order. A spline lies in the convex hull of its control
    /// points; knots are inserted so that each interval has `refine` of them, which brings the hull
    /// close to the curve. A trigonometric polynomial of degree `N` is at most `1 / cos(pi N / M)`
    /// times its largest value at `M` equal steps (Ehlich and Zeller, Mathematische Zeitschrift 86,
    /// 1964).
    pub(super) fn bound(&self, order: usize, refine: usize) -> Bound {
        match *self {
            Self::Spline { duration, intervals } => {
                // A short motion has few intervals; at least 24 pieces are used.
                let rows = hull(duration, intervals, order, refine.max(24usize.div_ceil(intervals)));
                let folded = rows.iter().map(|row| {
                    let mut folded = vec![0.0; intervals + 1];
                    row.iter().enumerate().for_each(|(c, value)| folded[variable(c, intervals)] += value);
                    folded
                });
                let mut rows: Vec<Vec<f64>> = folded.filter(|row| row.iter().any(|v| v.abs() > 1e-12)).collect();
                rows.dedup_by(|a, b| a.iter().zip(&*b).all(|(a, b)| (a - b).abs() < 1e-12));
                Bound { rows, share: 1.0 }
            }
            Self::Fourier { period, harmonics, .. } => {
                let steps = 16 * harmonics;
                let rows = (0..steps).map(|k| self.row(period * k as f64 / steps as f64, order)).collect();
                Bound { rows, share: (PI * harmonics as f64 / steps as f64).cos() }
            }
        }
    }

    /// Trajectory of these variables; `x` holds joint after joint.
    pub fn trajectory(&self, x: &[f64]) -> Option<Trajectory> {
        let joints = x.chunks(self.count());
        match *self {
            Self::Spline { duration, intervals } => {
                let coefficients = joints.map(|x| (0..intervals + DEGREE).map(|c| x[variable(c, intervals)]).collect());
                Spline::clamped(DEGREE, duration, intervals, coefficients.collect()).ok().map(Trajectory::Spline)
            }
            Self::Fourier { period, harmonics, periods } => {
                let (mut center, mut sine, mut cosine) = (Vec::new(), Vec::new(), Vec::new());
                for x in joints {
                    let (mut s, mut c) = (vec![0.0; harmonics], vec![0.0; harmonics]);
                    for l in 2..=harmonics {
                        let (a, b) = (x[2 * l - 3], x[2 * l - 2]);
                        s[l - 1] = a / l as f64;
                        s[0] -= a;
                        c[l - 1] = b / (l * l) as f64;
                        c[0] -= b;
                    }
                    center.push(x[0]);
                    sine.push(s);
                    cosine.push(c);
                }
                Fourier::new(period, periods, center, sine, cosine).ok().map(Trajectory::Fourier)
            }
        }
    }

    /// Variables of one joint that keep it at `q`.
    pub(super) fn rest(&self, q: f64) -> Vec<f64> {
        let mut x = vec![q; self.count()];
        if let Self::Fourier { .. } = self {
            x[1..].fill(0.0);
        }
        x
    }
}

/// Index of the variable that sets a control point.
fn variable(control: usize, intervals: usize) -> usize {
    control.saturating_sub(2).min(intervals)
}

/// Control points of the derivative of this order after knot insertion, as rows over the control
/// points of the spline.
fn hull(duration: f64, intervals: usize, order: usize, refine: usize) -> Vec<Vec<f64>> {
    let mut knots = clamped_knots(DEGREE, duration, intervals);
    let count = intervals + DEGREE;
    let mut rows: Vec<Vec<f64>> =
        (0..count).map(|i| (0..count).map(|k| f64::from(u8::from(i == k))).collect()).collect();
    let mut degree = DEGREE;
    for _ in 0..order {
        // Q_i = p (P_{i+1} - P_i) / (u_{i+p+1} - u_{i+1}); the outer knots are dropped (The NURBS
        // Book, equation 3.8).
        rows = (0..rows.len() - 1)
            .map(|i| {
                let factor = degree as f64 / (knots[i + degree + 1] - knots[i + 1]);
                rows[i].iter().zip(&rows[i + 1]).map(|(a, b)| factor * (b - a)).collect()
            })
            .collect();
        knots = knots[1..knots.len() - 1].to_vec();
        degree -= 1;
    }
    for step in 1..intervals * refine {
        if step % refine == 0 {
            continue;
        }
        // Boehm's insertion of one knot (The NURBS Book, equation 5.15).
        let u = duration * step as f64 / (intervals * refine) as f64;
        let span = knots.iter().rposition(|&k| k <= u).unwrap_or(0);
        let mix = |i: usize| -> Vec<f64> {
            if i + degree <= span {
                return rows[i].clone();
            }
            if i > span {
                return rows[i - 1].clone();
            }
            let a = (u - knots[i]) / (knots[i + degree] - knots[i]);
            rows[i].iter().zip(&rows[i - 1]).map(|(new, old)| a * new + (1.0 - a) * old).collect()
        };
        rows = (0..=rows.len()).map(mix).collect();
        knots.insert(span + 1, u);
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    const CURVES: [Curve; 3] = [
        Curve::Spline { duration: 4.0, intervals: 4 },
        Curve::Spline { duration: 1.5, intervals: 1 },
        Curve::Fourier { period: 5.0, harmonics: 4, periods: 2 },
    ];

    fn variables(curve: &Curve, seed: u64) -> Vec<f64> {
        let mut random = crate::numerics::prng::Random::stream(seed, 0);
        (0..curve.count()).map(|_| random.uniform(-1.0, 1.0)).collect()
    }

    fn dot(a: &[f64], b: &[f64]) -> f64 {
        a.iter().zip(b).map(|(a, b)| a * b).sum()
    }

    #[test]
    fn rows_and_trajectory_are_one_motion_and_it_rests_at_both_ends() {
        for curve in CURVES {
            let x = variables(&curve, 3);
            let motion = curve.trajectory(&x).unwrap();
            for k in 0..=40 {
                let t = curve.design_duration() * k as f64 / 40.0;
                let at = motion.at(t);
                for (order, value) in [at.q[0], at.dq[0], at.ddq[0], at.dddq[0]].into_iter().enumerate() {
                    assert!((dot(&curve.row(t, order), &x) - value).abs() < 1e-9, "{curve:?} {t} {order}");
                    if k % 40 == 0 && (1..3).contains(&order) {
                        assert!(value.abs() < 1e-9, "{curve:?} rests");
                    }
                }
            }
        }
    }

    #[test]
    fn bounds_hold_everywhere_and_are_close() {
        for curve in CURVES {
            for seed in 0..5 {
                let x = variables(&curve, seed);
                for order in 0..4 {
                    let bound = curve.bound(order, 6);
                    let values: Vec<f64> = bound.rows.iter().map(|row| dot(row, &x)).collect();
                    let (low, high) = values.iter().fold((0.0_f64, 0.0_f64), |(l, h), v| (l.min(*v), h.max(*v)));
                    let (mut least, mut most) = (0.0_f64, 0.0_f64);
                    for k in 0..=2000 {
                        let v = dot(&curve.row(curve.design_duration() * k as f64 / 2000.0, order), &x);
                        (least, most) = (least.min(v), most.max(v));
                    }
                    let size = (high - low) * 1e-9;
                    let reach = most.max(-least);
                    if bound.share < 1.0 {
                        assert!(reach <= high.max(-low) / bound.share + size);
                    } else {
                        assert!(low <= least + size && most <= high + size, "{curve:?} {order}");
                    }
                    if order < 3 {
                        assert!(high.max(-low) <= 1.12 * reach, "{curve:?} {order}: {} for {reach}", high.max(-low));
                    }
                }
            }
        }
    }
}
