//! Uncertainty of a fit: standard deviations including those of shapes, and undetermined
//! directions.

use nalgebra::{DMatrix, DVector};

use super::model::{Chosen, Fitted, ModelUnderTest, given_friction};
use super::moments::pseudo_inverse;
use crate::diagnose::hypotheses::{Estimate, Named, UNIT};
use crate::diagnose::windows::windowed_data::Column;
use crate::numerics::eigen;

/// Covariance of everything that was estimated.
pub struct Uncertainty {
    /// Covariance of the unknowns of the fit, followed by the nonlinear numbers of the causes.
    pub covariance: DMatrix<f64>,
    /// Index of each number of each cause's shape in the covariance; `None` for a value that is not
    /// estimated.
    shapes: Vec<Vec<Option<usize>>>,
}

impl Uncertainty {
    /// The uncertainty of a fit. A number of a shape is an unknown too; its column is the
    /// derivative of its cause's torque.
    pub fn of(tested: &ModelUnderTest<'_>, fitted: &Fitted, chosen: &[Chosen]) -> Self {
        let (mut shapes, mut more, mut integer_priors) = (Vec::new(), Vec::new(), Vec::new());
        for (index, c) in chosen.iter().enumerate() {
            let places = c.cause.shape().iter().enumerate().map(|(k, number)| {
                let integer = c.integer(k);
                let first = number.step.filter(|_| !(integer && c.cause.integer_prior_std().is_none()))?;
                let column = derivative(tested, fitted, index, c, k, first)?;
                more.push(column);
                let at = fitted.solution.x.len() + more.len() - 1;
                integer_priors.extend(c.cause.integer_prior_std().filter(|_| integer).map(|std| (at, std)));
                Some(at)
            });
            shapes.push(places.collect());
        }
        if more.is_empty() {
            return Self { covariance: fitted.covariance(), shapes };
        }
        let (moments, solution) = fitted.moments.beside(&fitted.solution, &more);
        let mut covariance = moments.covariance(&solution, &fitted.memory);
        // Prior information enters as one more measurement of an unknown.
        let units = chosen.iter().enumerate().filter(|(_, c)| c.cause.unit() && !c.x.is_empty());
        for (at, std) in units.map(|(index, _)| (fitted.first[index], UNIT)).chain(integer_priors) {
            measure(&mut covariance, at, std);
        }
        Self { covariance, shapes }
    }
}

impl Uncertainty {
    /// Wald statistic of a cause's parameters, less a level that chance reaches once in a hundred
    /// cases. The parameters are its coefficients with the found shape, or the number of its shape
    /// that is its size.
    pub fn exceeds_zero(&self, tested: &ModelUnderTest<'_>, fitted: &Fitted, index: usize, chosen: &Chosen) -> f64 {
        let unknowns = if self.size_of(index, chosen).is_some() { 1 } else { chosen.x.len() };
        self.wald(tested, fitted, index, chosen) - once_in_a_hundred(unknowns as f64)
    }

    /// Wald statistic of a cause's parameters: their squares weighted by the inverse covariance.
    /// Negative infinity where the cause has no coefficients.
    pub fn wald(&self, tested: &ModelUnderTest<'_>, fitted: &Fitted, index: usize, chosen: &Chosen) -> f64 {
        let Some(x) = above_resolution(tested, chosen) else { return f64::NEG_INFINITY };
        match self.size_of(index, chosen) {
            Some(at) => chosen.shape[0].powi(2) / self.covariance[(at, at)].max(f64::MIN_POSITIVE),
            None => wald(&fitted.covariance(), fitted.first[index], &x),
        }
    }

    /// Index in the covariance of the size of a cause that has it in its shape.
    fn size_of(&self, index: usize, chosen: &Chosen) -> Option<usize> {
        *self.shapes.get(index).filter(|_| chosen.cause.unit())?.first()?
    }
}

/// A cause's coefficients above the resolution of the data; `None` where it has no columns in the
/// present model.
fn above_resolution(tested: &ModelUnderTest<'_>, chosen: &Chosen) -> Option<DVector<f64>> {
    let x = || DVector::from_vec(chosen.cause.above_resolution(&tested.scene, &chosen.place, &chosen.x));
    (!chosen.x.is_empty()).then(x)
}

/// Wald statistic of some unknowns, from `first` on: their squares weighted by the inverse
/// covariance.
fn wald(covariance: &DMatrix<f64>, first: usize, x: &DVector<f64>) -> f64 {
    let own = covariance.view((first, first), (x.len(), x.len())).into_owned();
    x.dot(&(pseudo_inverse(&own) * x))
}

/// Linear approximation of the 99 % quantile of chi-squared with `unknowns` degrees of freedom.
fn once_in_a_hundred(unknowns: f64) -> f64 {
    4.2 + 2.1 * unknowns
}

/// Updates the covariance with a measurement of one unknown, with standard deviation `std`.
fn measure(covariance: &mut DMatrix<f64>, at: usize, std: f64) {
    let own = covariance.column(at).into_owned();
    if own[at] > 0.0 {
        *covariance -= &own * own.transpose() / (own[at] + std * std);
    }
}

/// Step of a difference quotient, as a share of a number's first step in a search.
const OF_FIRST_STEP: f64 = 1e-2;

/// Difference quotient of a cause's torque by a number of its shape. `first` is that number's first
/// step in a search: a share of the number if positive, else its negative absolute step.
pub(in crate::diagnose) fn derivative(
    tested: &ModelUnderTest<'_>,
    fitted: &Fitted,
    index: usize,
    chosen: &Chosen,
    k: usize,
    first: f64,
) -> Option<Column> {
    let step = OF_FIRST_STEP * if first > 0.0 { first * chosen.shape[k] } else { -first };
    if step == 0.0 {
        return None;
    }
    let sides = [step, -step].map(|by| {
        let mut shape = chosen.shape.clone();
        shape[k] += by;
        tested.family(chosen.cause, &chosen.place, &shape)
    });
    if sides.iter().any(|s| s.len() != fitted.terms[index].len()) {
        return None;
    }
    let mut rows: Vec<(usize, Vec<f64>)> = Vec::new();
    for (terms, sign) in sides.iter().zip([1.0, -1.0]) {
        for (term, x) in terms.iter().zip(&chosen.x) {
            for (joint, series) in &term.column.rows {
                let at = rows.iter().position(|r| r.0 == *joint).unwrap_or_else(|| {
                    rows.push((*joint, vec![0.0; series.len()]));
                    rows.len() - 1
                });
                let by = sign * x / (2.0 * step);
                rows[at].1.iter_mut().zip(&**series).for_each(|(c, s)| *c += by * s);
            }
        }
    }
    let acts = rows.iter().flat_map(|r| &r.1).any(|v| *v != 0.0);
    acts.then(|| Column::new(rows))
}

/// Values of a chosen cause's parameters with standard deviations, under the names of a robot file.
pub fn parameters(
    tested: &ModelUnderTest<'_>,
    fitted: &Fitted,
    uncertainty: &Uncertainty,
    index: usize,
    chosen: &Chosen,
) -> Vec<Named> {
    let joint = chosen.place.first().copied().unwrap_or(0);
    let given = given_friction(tested.plant)[joint];
    let level = |which: usize| fitted.friction + 3 * joint + which;
    let at: Vec<usize> = (0..chosen.x.len()).map(|k| fitted.first[index] + k).chain((0..3).map(level)).collect();
    let whole = &uncertainty.covariance;
    let variance = |k: usize| whole[(k, k)].max(0.0).sqrt();
    let mut x = DVector::from_column_slice(&chosen.x);
    let mut covariance = DMatrix::from_fn(at.len(), at.len(), |i, k| whole[(at[i], at[k])]);
    if let Some(std) = chosen.cause.prior_std(&tested.scene, &chosen.place, &fitted.terms[index]) {
        let information = fitted.moments.information(&fitted.solution.weights);
        let own = information.view((fitted.first[index], fitted.first[index]), (x.len(), x.len()));
        let loose = undetermined(&own.into_owned(), &std);
        let scale = DMatrix::from_diagonal(&DVector::from_vec(std));
        let inverse = scale.map_diagonal(|s| if s > 0.0 { 1.0 / s } else { 0.0 });
        let share = x.component_mul(&inverse);
        x -= &scale * (&loose * (&loose.transpose() * share));
        let mut corner = covariance.view_mut((0, 0), (x.len(), x.len()));
        corner += &scale * (&loose * loose.transpose()) * &scale;
    }
    chosen.cause.named(&Estimate {
        scene: &tested.scene,
        place: &chosen.place,
        shape: &chosen.shape,
        shape_std: uncertainty.shapes[index].iter().map(|k| k.map(variance)).collect(),
        terms: &fitted.terms[index],
        x: x.as_slice(),
        levels: std::array::from_fn(|which| given[which].unwrap_or(0.0) + fitted.solution.x[level(which)]),
        covariance,
    })
}

/// Directions, one per column, in which the data have less information than the prior.
/// `information` is the normal matrix of the data; unknowns are in units of their prior deviation
/// `std`. For a mass on the axis and a first moment along it, for example, often only a sum is
/// determined. In these directions the smallest change is chosen, and the uncertainty is that of
/// the prior.
fn undetermined(information: &DMatrix<f64>, std: &[f64]) -> DMatrix<f64> {
    let n = std.len();
    let white = DMatrix::from_fn(n, n, |i, k| information[(i, k)] * std[i] * std[k]);
    if !white.iter().all(|x| x.is_finite()) {
        return DMatrix::zeros(n, 0);
    }
    let eigen = eigen::symmetric(white);
    let columns: Vec<_> =
        (0..n).filter(|&k| eigen.eigenvalues[k] < 1.0).map(|k| eigen.eigenvectors.column(k).into_owned()).collect();
    if columns.is_empty() { DMatrix::zeros(n, 0) } else { DMatrix::from_columns(&columns) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sum_that_is_told_leaves_the_difference_open() {
        // Unknowns in units of 2 and 0.5; the data determine x + y and z to a hundredth of that.
        let column = [1.0, 1.0, 0.0];
        let mut information = DMatrix::from_fn(3, 3, |i, k| 1e4 * column[i] * column[k]);
        information[(2, 2)] = 1e4;
        let loose = undetermined(&information, &[2.0, 0.5, 1.0]);
        assert_eq!(loose.shape(), (3, 1));
        // Along it 2 u + 0.5 v is constant: (0.5, -2, 0).
        let norm = f64::hypot(0.5, 2.0);
        assert!((loose[(0, 0)] * loose[(1, 0)] + 1.0 / norm.powi(2)).abs() < 1e-9, "{loose}");
        assert!(loose[(2, 0)].abs() < 1e-9);
        assert_eq!(undetermined(&DMatrix::identity(2, 2), &[10.0, 10.0]).ncols(), 0);
    }
}
