//! What is believed of the base parameters before any data: the file's values, as far off as a link may be from its drawing.
//!
//! Where a motion does not show a parameter, least squares gives it whatever suits the errors of the rest, and on another motion that is worse than any drawing.
//! So base parameters that are fitted anew are drawn to the file's by a normal prior that is as wide as the links themselves are heavy: mass by 100 %, first
//! moments by the mass times the link's size, inertia by the mass times its square, rotors by 100 %. What data do tell it leaves alone.

use nalgebra::{DMatrix, DVector};

use crate::arm::Plant;

/// A normal prior of the first unknowns of a fit.
#[derive(Debug, Clone, PartialEq)]
pub struct Prior {
    /// Inverse of the covariance.
    pub precision: DMatrix<f64>,
    /// Mean.
    pub mean: DVector<f64>,
}

impl Prior {
    /// Nothing is believed of so many unknowns.
    pub fn none(unknowns: usize) -> Self {
        Self { precision: DMatrix::zeros(unknowns, unknowns), mean: DVector::zeros(unknowns) }
    }
}

/// Least size of a body, m.
const SMALLEST: f64 = 0.05;
/// A link that the file gives no mass is believed to have up to this share of the mean link's.
const FORGOTTEN: f64 = 0.3;

/// Of these base parameters; `None` where the file has no links.
pub fn prior(plant: &dyn Plant, wanted: &[usize]) -> Option<Prior> {
    let given = plant.given()?;
    let std = deviations(plant.standard_names(), given)?;
    let base = plant.base_parameters();
    let mut factor = DMatrix::zeros(wanted.len(), given.len());
    for (row, &b) in wanted.iter().enumerate() {
        for &(p, k) in &base[b].coefficients {
            factor[(row, p)] = k * std[p];
        }
    }
    let mut covariance = &factor * factor.transpose();
    // A hair more, so that it can be inverted where two leaders share their columns but for rounding.
    (0..wanted.len()).for_each(|i| covariance[(i, i)] *= 1.0 + 1e-9);
    let mean = wanted.iter().map(|&b| base[b].coefficients.iter().map(|&(p, k)| k * given[p]).sum());
    let mean = DVector::from_iterator(wanted.len(), mean);
    Some(Prior { precision: covariance.cholesky()?.inverse(), mean })
}

/// The prior with friction's three unknowns of each joint (viscous, Coulomb, offset) behind it: what the file says, give or take half of the `torque` that the
/// joint was seen to need, at 1 rad/s for the viscous part. A joint that hardly moves would else get any friction at all. Offsets are seen whatever moves.
pub fn with_friction(base: Prior, torque: &[f64]) -> Prior {
    let first = base.mean.len();
    let unknowns = first + 3 * torque.len();
    let (mut precision, mut mean) = (DMatrix::zeros(unknowns, unknowns), DVector::zeros(unknowns));
    precision.view_mut((0, 0), (first, first)).copy_from(&base.precision);
    mean.rows_mut(0, first).copy_from(&base.mean);
    for (j, torque) in torque.iter().enumerate().filter(|(_, t)| **t > 0.0) {
        for k in 0..2 {
            let at = first + 3 * j + k;
            precision[(at, at)] = (0.5 * torque).powi(-2);
        }
    }
    Prior { precision, mean }
}

/// How far each standard parameter may be from the file's, one standard deviation; `None`: no link has a mass.
fn deviations(names: &[String], given: &[f64]) -> Option<Vec<f64>> {
    const TEN: [&str; 10] = ["M", "MSX", "MSY", "MSZ", "XX", "YY", "ZZ", "XY", "XZ", "YZ"];
    let kind = |name: &str| name.trim_end_matches(|c: char| c.is_ascii_digit()).to_string();
    let links: Vec<usize> = (0..names.len()).filter(|&i| kind(&names[i]) == "M").collect();
    let heavy: Vec<f64> = links.iter().map(|&i| given[i]).filter(|m| *m > 0.0).collect();
    if heavy.is_empty() {
        return None;
    }
    let mean = heavy.iter().sum::<f64>() / heavy.len() as f64;
    let mut std = vec![0.0; names.len()];
    for &first in &links {
        let mass = given[first].max(FORGOTTEN * mean);
        let body = given.get(first..first + TEN.len())?;
        let moment = body[1..4].iter().map(|m| m * m).sum::<f64>().sqrt() / mass;
        let radius = (body[4..7].iter().fold(0.0_f64, |a, i| a.max(i.abs())) / mass).sqrt();
        let size = moment.max(radius).max(SMALLEST);
        for (k, std) in std[first..first + TEN.len()].iter_mut().enumerate() {
            *std = mass * size.powi([0, 1, 2][usize::from(k > 0) + usize::from(k > 3)]);
        }
    }
    // Rotors: as heavy as the file says, or as the arm's lighter links.
    let inertia = mean * SMALLEST * SMALLEST;
    for (i, name) in names.iter().enumerate().filter(|(i, _)| !TEN.contains(&kind(&names[*i]).as_str())) {
        std[i] = if kind(name) == "IA" { given[i].abs().max(10.0 * inertia) } else { 1.0 };
    }
    Some(std)
}
