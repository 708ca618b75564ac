//! Regularises poorly identified directions of base parameters and friction towards the file.
//!
//! In directions that the data do not determine, least squares fits the errors of the remaining
//! model, which can be arbitrarily wrong on another motion. The prior is normal about the file's
//! values, and as wide as links may be off. Masses may be off by 100 %, first moments by the mass
//! times the link's size, inertias by the mass times its square. Rotors may be off by 100 %,
//! friction by half of the measured torque.
//!
//! In the axes that whiten the prior, the eigenvalues `mu` of the data's information rank the
//! directions (Hansen 1998, generalised singular values). `mu` is the ratio of the prior's variance
//! to that of the data, with windows counted by the autocorrelation time of residuals. The
//! least-squares value of a direction has the weight `mu^4 / (mu^4 + strength^4)`. Well identified
//! directions are thus left to the data alone, unlike with a plain normal prior, and the others
//! stay with the file. The strength is the one that predicts left-out stretches of the logs best.

use nalgebra::{Cholesky, DMatrix, DVector};

use crate::model::{Inertial, PerturbableArm, StandardParameter};
use crate::numerics::eigen;

/// Candidate strengths: the ratio `mu` at which a direction has half weight.
pub const STRENGTHS: [f64; 3] = [30.0, 10.0, 3.0];

/// Upper limit of the regulariser's weight, as a multiple of the prior's own weight.
const MAX_WEIGHT: f64 = 1e3;

/// Prior of the first unknowns of a fit.
#[derive(Debug, Clone, PartialEq)]
pub struct Regulariser {
    /// Matrix added to the normal equations.
    pub precision: DMatrix<f64>,
    /// Prior mean: the values towards which it pulls.
    pub mean: DVector<f64>,
    /// Covariance of the regulariser's contribution to the right-hand side if the prior is true.
    pub spread: DMatrix<f64>,
}

impl Regulariser {
    /// No regularisation.
    pub fn none() -> Self {
        Self { precision: DMatrix::zeros(0, 0), mean: DVector::zeros(0), spread: DMatrix::zeros(0, 0) }
    }

    /// Built from the prior and the data's normal matrix of the first unknowns. `full`: with all
    /// windows counted; `thinned`: with independent windows counted. `strength`: see [`STRENGTHS`].
    pub fn new(prior: &Prior, full: &DMatrix<f64>, thinned: &DMatrix<f64>, strength: f64) -> Option<Self> {
        let n = prior.mean.len();
        let root = &prior.root;
        let white = |matrix: &DMatrix<f64>| root.transpose() * matrix.view((0, 0), (n, n)) * root;
        let information = white(thinned);
        let information = 0.5 * (&information + information.transpose());
        if !information.iter().all(|x| x.is_finite()) {
            return None;
        }
        let eigen = eigen::symmetric(information);
        let all = white(full);
        let inverse = root.clone().try_inverse()?;
        let (mut precision, mut spread) = (DMatrix::zeros(n, n), DMatrix::zeros(n, n));
        for (mu, v) in eigen.eigenvalues.iter().zip(eigen.eigenvectors.column_iter()) {
            let mu = mu.max(1e-12);
            // The solver counts every window.
            let dependence = (v.dot(&(&all * v)) / mu).clamp(1.0, 1e4);
            let weight = (strength.powi(4) / mu.powi(3)).min(MAX_WEIGHT) * dependence;
            let axis = inverse.transpose() * v;
            precision.ger(weight, &axis, &axis, 1.0);
            spread.ger((TYPICAL * weight).powi(2), &axis, &axis, 1.0);
        }
        Some(Self { precision, mean: prior.mean.clone(), spread })
    }

    /// Without the unknowns for which `out` holds; their mean becomes 0.
    pub fn without(&self, out: impl Fn(usize) -> bool) -> Self {
        let mut held = self.clone();
        for k in (0..held.mean.len()).filter(|k| out(*k)) {
            held.precision.row_mut(k).fill(0.0);
            held.precision.column_mut(k).fill(0.0);
            held.spread.row_mut(k).fill(0.0);
            held.spread.column_mut(k).fill(0.0);
            held.mean[k] = 0.0;
        }
        held
    }
}

/// Prior distribution of the first unknowns.
#[derive(Debug, Clone, PartialEq)]
pub struct Prior {
    /// The file's values.
    mean: DVector<f64>,
    /// A root of the covariance, `C = root root'`.
    root: DMatrix<f64>,
}

/// Typical error relative to the prior, which is as wide as errors may be: the size of the error
/// that a regulariser leaves.
const TYPICAL: f64 = 0.2;

/// Least size of a body, m.
const SMALLEST: f64 = 0.05;
/// Mass of a link without one in the file, as a share of the mean link's, for the prior.
const FORGOTTEN: f64 = 0.3;
/// Friction, as a share of the measured torque of the joint: Coulomb level, viscous part at 1
/// rad/s.
const FRICTION: f64 = 0.5;
/// Offset of a torque sensor, as a share of the same.
const OFFSET: f64 = 0.2;

/// The prior of these base parameters (none if the links are trusted), followed by three friction
/// parameters per joint, counted from the file's values. `None` where the file has no links but
/// base parameters are unknown. `torque`: root mean square of each joint's torque, N m.
pub fn prior(plant: &dyn PerturbableArm, wanted: &[usize], torque: &[f64]) -> Option<Prior> {
    let (b, n) = (wanted.len(), wanted.len() + 3 * torque.len());
    let (mut mean, mut root) = (DVector::zeros(n), DMatrix::zeros(n, n));
    if b > 0 {
        let given = plant.given()?;
        let std = deviations(plant.standard_parameters(), given)?;
        let base = plant.base_parameters();
        let mut factor = DMatrix::zeros(b, given.len());
        for (row, &index) in wanted.iter().enumerate() {
            for &(p, k) in &base[index].coefficients {
                factor[(row, p)] = k * std[p];
            }
            mean[row] = base[index].coefficients.iter().map(|&(p, k)| k * given[p]).sum();
        }
        let mut covariance = &factor * factor.transpose();
        // A slight increase keeps it invertible where two leaders share their columns up to
        // rounding.
        (0..b).for_each(|i| covariance[(i, i)] *= 1.0 + 1e-9);
        root.view_mut((0, 0), (b, b)).copy_from(&Cholesky::new(covariance)?.l());
    }
    let mean_torque = torque.iter().sum::<f64>() / torque.len().max(1) as f64;
    for (j, torque) in torque.iter().enumerate() {
        let torque = torque.max(1e-3 * mean_torque).max(1e-9);
        for (which, share) in [FRICTION, FRICTION, OFFSET].into_iter().enumerate() {
            let k = b + 3 * j + which;
            root[(k, k)] = share * torque;
        }
    }
    Some(Prior { mean, root })
}

/// Size of one of a body's ten parameters (`M MSX MSY MSZ XX YY ZZ XY XZ YZ`, from 0), in kg, kg m,
/// kg m^2, for a mass (kg) at a distance (m).
pub fn of_size(which: usize, mass: f64, away: f64) -> f64 {
    mass * away.powi([0, 1, 2][usize::from(which > 0) + usize::from(which > 3)])
}

/// Standard deviation of each standard parameter about the file's value; `None` if no link has a
/// mass.
pub fn deviations(parameters: &[StandardParameter], given: &[f64]) -> Option<Vec<f64>> {
    const TEN: usize = Inertial::ALL.len();
    let mass = |i: &usize| matches!(parameters[*i], StandardParameter::Link(_, Inertial::M));
    let links: Vec<usize> = (0..parameters.len()).filter(mass).collect();
    let heavy: Vec<f64> = links.iter().map(|&i| given[i]).filter(|m| *m > 0.0).collect();
    if heavy.is_empty() {
        return None;
    }
    let mean = heavy.iter().sum::<f64>() / heavy.len() as f64;
    let mut std = vec![0.0; parameters.len()];
    for &first in &links {
        let mass = given[first].max(FORGOTTEN * mean);
        let body = given.get(first..first + TEN)?;
        let moment = body[1..4].iter().map(|m| m * m).sum::<f64>().sqrt() / mass;
        let radius = (body[4..7].iter().fold(0.0_f64, |a, i| a.max(i.abs())) / mass).sqrt();
        let size = moment.max(radius).max(SMALLEST);
        for (k, std) in std[first..first + TEN].iter_mut().enumerate() {
            *std = of_size(k, mass, size);
        }
    }
    // Rotors: the file's inertia, or that of the arm's lighter links.
    let inertia = mean * SMALLEST * SMALLEST;
    for (i, parameter) in parameters.iter().enumerate().filter(|(_, p)| p.is_drive()) {
        std[i] = if parameter.is_rotor() { given[i].abs().max(10.0 * inertia) } else { 1.0 };
    }
    Some(std)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_told_is_left_alone_and_what_is_not_stays() {
        let prior = Prior { mean: DVector::from_vec(vec![1.0, 2.0]), root: DMatrix::from_diagonal_element(2, 2, 0.5) };
        // The data give (3, 7): the first ten thousand times as precise as the prior, the second a
        // hundredth.
        let information = DMatrix::from_diagonal(&DVector::from_vec(vec![1e4 / 0.25, 1e-2 / 0.25]));
        let regulariser = Regulariser::new(&prior, &information, &information, 10.0).unwrap();
        let right = &information * DVector::from_vec(vec![3.0, 7.0]) + &regulariser.precision * &regulariser.mean;
        let x = (&information + &regulariser.precision).lu().solve(&right).unwrap();
        assert!((x[0] - 3.0).abs() < 1e-4, "{x}");
        assert!((x[1] - 2.0).abs() < 1e-3, "{x}");
        // A removed unknown does not affect the others.
        let without = regulariser.without(|k| k == 1);
        assert_eq!((without.precision[(1, 1)], without.precision[(0, 1)], without.mean[1]), (0.0, 0.0, 0.0));
    }
}
