//! Clamped B-splines (Piegl and Tiller, *The NURBS Book*, chapters 2 and 3).

use super::error::CoefficientError;

/// One B-spline per joint over common knots.
#[derive(Debug, Clone, PartialEq)]
pub struct Spline {
    /// Polynomial degree; with 5, the jerk and its derivative are continuous.
    pub degree: usize,
    /// Knots, s, ascending; the first `degree + 1` are equal, and so are the last.
    pub knots: Vec<f64>,
    /// Control points, rad or m, one row per joint.
    pub coefficients: Vec<Vec<f64>>,
}

impl Spline {
    /// Checks knots and coefficients.
    ///
    /// # Errors
    /// If the numbers of knots and coefficients do not match, or the knots do not ascend from 0
    /// with clamped ends.
    pub fn new(degree: usize, knots: Vec<f64>, coefficients: Vec<Vec<f64>>) -> Result<Self, CoefficientError> {
        let count = knots.len().saturating_sub(degree + 1);
        if !(1..=15).contains(&degree) || count < degree + 1 {
            return Err(CoefficientError::Degree { degree });
        }
        let clamped = |at: usize| (at..=at + degree).all(|k| knots[k] == knots[at]);
        if knots[0] != 0.0 || !clamped(0) || !clamped(count) || knots.windows(2).any(|w| w[1] < w[0]) {
            return Err(CoefficientError::Ends(degree + 1));
        }
        if knots[degree..=count].windows(2).any(|w| w[1] <= w[0]) {
            return Err(CoefficientError::Inner);
        }
        match coefficients.iter().position(|row| row.len() != count) {
            Some(j) => Err(CoefficientError::Count { joint: j + 1, has: coefficients[j].len(), needs: count }),
            None => Ok(Self { degree, knots, coefficients }),
        }
    }

    /// Clamped spline with `intervals` equal knot intervals over `duration`, s.
    ///
    /// # Errors
    /// Like [`Spline::new`].
    pub fn clamped(
        degree: usize,
        duration: f64,
        intervals: usize,
        coefficients: Vec<Vec<f64>>,
    ) -> Result<Self, CoefficientError> {
        Self::new(degree, clamped_knots(degree, duration, intervals), coefficients)
    }

    /// Duration, s.
    pub fn duration(&self) -> f64 {
        self.knots[self.knots.len() - 1]
    }

    /// Derivative of order `order` of every joint at `t` in `[0, duration]`, s.
    pub fn derivative(&self, t: f64, order: usize) -> Vec<f64> {
        let (first, values) = basis(&self.knots, self.degree, t, order);
        self.coefficients.iter().map(|c| values.iter().zip(&c[first..]).map(|(b, c)| b * c).sum()).collect()
    }
}

/// Clamped knots: `intervals` equal intervals over `[0, duration]`, the ends repeated `degree + 1`
/// times.
pub fn clamped_knots(degree: usize, duration: f64, intervals: usize) -> Vec<f64> {
    let inner = (0..=intervals).map(|k| duration * k as f64 / intervals as f64);
    let mut knots = vec![0.0; degree];
    knots.extend(inner);
    knots.extend(vec![duration; degree]);
    knots
}

/// Index of the first of the `degree + 1` basis functions that are nonzero at `t`, and their
/// derivatives of order `order`.
pub fn basis(knots: &[f64], degree: usize, t: f64, order: usize) -> (usize, Vec<f64>) {
    let count = knots.len() - degree - 1;
    // Knot span that contains `t`; the last nonempty span contains the end.
    let span = (degree + 1..count).take_while(|&k| knots[k] <= t).last().unwrap_or(degree);
    if order > degree {
        return (span - degree, vec![0.0; degree + 1]);
    }
    // Starts with values of degree - order, then adds one derivative per degree: N' = p (N_i /
    // (u_{i+p} - u_i) - N_{i+1} / (u_{i+p+1} - u_{i+1})).
    let mut values = vec![1.0];
    for p in 1..=degree {
        let first = span - p;
        let ratio = |i: usize| {
            let width = knots[i + p] - knots[i];
            if width > 0.0 { 1.0 / width } else { 0.0 }
        };
        // `values[k]` is N of degree p - 1 with index first + 1 + k.
        let lower = |i: usize| if i > first { values.get(i - first - 1).copied().unwrap_or(0.0) } else { 0.0 };
        let next = (first..=span).map(|i| {
            let (left, right) = (lower(i) * ratio(i), lower(i + 1) * ratio(i + 1));
            if p + order > degree {
                p as f64 * (left - right)
            } else {
                (t - knots[i]) * left + (knots[i + p + 1] - t) * right
            }
        });
        values = next.collect();
    }
    (span - degree, values)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_meet_differences_and_values_sum_to_one() {
        let knots = clamped_knots(5, 7.0, 6);
        let row = |t: f64, order: usize| {
            let (first, values) = basis(&knots, 5, t, order);
            let mut row = [0.0; 11];
            row[first..first + 6].copy_from_slice(&values);
            row
        };
        for k in 0..=70 {
            let t = 0.1 * k as f64;
            assert!((row(t, 0).iter().sum::<f64>() - 1.0).abs() < 1e-13);
            let h = 1e-5;
            let inside = t.clamp(h, 7.0 - h);
            for order in 0..4 {
                let (up, down, exact) = (row(inside + h, order), row(inside - h, order), row(inside, order + 1));
                for i in 0..11 {
                    let scale = 1.0 + exact[i].abs();
                    assert!(((up[i] - down[i]) / (2.0 * h) - exact[i]).abs() < 1e-4 * scale, "{t} {order} {i}");
                }
            }
        }
    }
}
