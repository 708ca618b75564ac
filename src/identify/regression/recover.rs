//! Recovers standard parameters for the robot file from identified base parameters.

use nalgebra::{DMatrix, DVector};

use crate::model::{Arm, Inertial, StandardParameter};

/// Mismatch between parameters and arm.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RecoverError {
    /// A vector has the wrong length.
    #[error("{what}: {found} numbers where the arm has {expected}")]
    Length {
        /// Name of the parameters.
        what: &'static str,
        /// Length given.
        found: usize,
        /// Length required.
        expected: usize,
    },
    /// The base parameters are not independent combinations of standard ones.
    #[error("the base parameters are not independent combinations of the standard ones")]
    Dependent,
}

/// Base parameters `beta = K phi` of standard parameters `phi`.
pub(in crate::identify) fn base_of(arm: &dyn Arm, standard: &[f64]) -> Vec<f64> {
    arm.base_parameters().iter().map(|b| b.coefficients.iter().map(|&(i, k)| k * standard[i]).sum()).collect()
}

/// Standard parameters that give exactly these base parameters and differ least from `prior` (zeros
/// if there is none). They are `phi = phi0 + D K' (K D K')^-1 (beta - K phi0)`, the least change in
/// the metric `D^-1`.
///
/// `D` holds the squared sizes of admissible changes, so that kilograms and kilogram square metres
/// can be compared. For a link of mass `m` and a length `l = 0.2 m` they are `m`, `m l` and `m
/// l^2`; for the drive, the parameter's own size. `m` is the prior mass, at least 1 kg. Rotor
/// inertias and friction levels that share a base parameter with others (`IA3` in `ZZ3R`) are kept
/// non-negative.
pub fn recover_standard(arm: &dyn Arm, beta: &[f64], prior: Option<&[f64]>) -> Result<Vec<f64>, RecoverError> {
    let (parameters, base) = (arm.standard_parameters(), arm.base_parameters());
    let length = |what, found, expected| match found == expected {
        true => Ok(()),
        false => Err(RecoverError::Length { what, found, expected }),
    };
    length("base parameters", beta.len(), base.len())?;
    let zeros = vec![0.0; parameters.len()];
    let prior = prior.unwrap_or(&zeros);
    length("standard parameters", prior.len(), parameters.len())?;
    let mut sizes: Vec<f64> = (0..parameters.len()).map(|i| size(parameters, prior, i).powi(2)).collect();
    let k = DMatrix::from_fn(base.len(), parameters.len(), |row, column| {
        base[row].coefficients.iter().filter(|(i, _)| *i == column).map(|(_, k)| k).sum::<f64>()
    });
    let shared = |i: usize| base.iter().any(|b| b.coefficients.len() > 1 && b.coefficients.iter().any(|c| c.0 == i));
    let mut phi0 = DVector::from_column_slice(prior);
    loop {
        let phi = least_change(&k, &sizes, &phi0, beta)?;
        let below = |i: &usize| phi[*i] < 0.0 && sizes[*i] > 0.0 && parameters[*i].is_level() && shared(*i);
        let negative: Vec<usize> = (0..parameters.len()).filter(below).collect();
        if negative.is_empty() {
            return Ok(phi.iter().copied().collect());
        }
        negative.iter().for_each(|&i| (sizes[i], phi0[i]) = (0.0, 0.0));
    }
}

/// Least change `phi0 + D K' (K D K')^-1 (beta - K phi0)`; `sizes`: the diagonal of `D`.
fn least_change(
    k: &DMatrix<f64>,
    sizes: &[f64],
    phi0: &DVector<f64>,
    beta: &[f64],
) -> Result<DVector<f64>, RecoverError> {
    let kd = DMatrix::from_fn(k.nrows(), k.ncols(), |row, column| k[(row, column)] * sizes[column]);
    let root = (&kd * k.transpose()).cholesky().ok_or(RecoverError::Dependent)?;
    let mut phi = phi0.clone();
    // Repeats the step to remove rounding errors.
    for _ in 0..2 {
        let missing = DVector::from_column_slice(beta) - k * &phi;
        phi += kd.transpose() * root.solve(&missing);
    }
    Ok(phi)
}

/// Links (numbered from 1, as in the names) whose standard parameters belong to no possible body.
/// Their pseudo-inertia `[[tr(I)/2 1 - I, MS], [MS', M]]` is not positive definite (Wensing, Kim
/// and Slotine 2018). Least squares does not enforce this.
pub fn implausible_links(parameters: &[StandardParameter], standard: &[f64]) -> Vec<usize> {
    let value = |row: usize, which: Inertial| {
        let at = parameters.iter().position(|p| *p == StandardParameter::Link(row, which));
        at.and_then(|i| standard.get(i)).copied().unwrap_or(0.0)
    };
    let rows = parameters.iter().filter_map(|p| match *p {
        StandardParameter::Link(row, Inertial::M) => Some(row),
        _ => None,
    });
    rows.filter(|&row| {
        let [m, x, y, z, xx, yy, zz, xy, xz, yz] = Inertial::ALL.map(|which| value(row, which));
        let half = (xx + yy + zz) / 2.0;
        #[rustfmt::skip]
            let pseudo = nalgebra::Matrix4::new(
                half - xx, -xy, -xz, x,
                -xy, half - yy, -yz, y,
                -xz, -yz, half - zz, z,
                x, y, z, m,
            );
        pseudo.cholesky().is_none()
    })
    .map(|row| row + 1)
    .collect()
}

/// Typical size of a change of this parameter.
fn size(parameters: &[StandardParameter], prior: &[f64], index: usize) -> f64 {
    const LENGTH: f64 = 0.2;
    let StandardParameter::Link(row, which) = parameters[index] else { return prior[index].abs().max(0.1) };
    let own = parameters.iter().position(|p| *p == StandardParameter::Link(row, Inertial::M));
    let mass = own.map_or(0.0, |i| prior[i]).abs().max(1.0);
    match which {
        Inertial::M => mass,
        Inertial::MSX | Inertial::MSY | Inertial::MSZ => mass * LENGTH,
        _ => mass * LENGTH * LENGTH,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::identify::planar::{Planar, STANDARD};

    /// `IA1` occurs in `ZZ1R` alone; a small `ZZ1R` would make it negative.
    #[test]
    fn a_rotor_that_shares_a_base_parameter_is_not_negative() {
        let arm = Planar::new();
        let mut beta = arm.beta();
        beta[0] = 0.3;
        let standard = recover_standard(&arm, &beta, Some(&STANDARD)).unwrap();
        assert!((8..14).all(|i| standard[i] >= 0.0), "{standard:?}");
        let back = base_of(&arm, &standard);
        assert!(back.iter().zip(&beta).all(|(a, b)| (a - b).abs() < 1e-12), "{back:?}");
    }

    #[test]
    fn a_body_and_what_is_none() {
        let names = Inertial::ALL.map(|which| StandardParameter::Link(1, which));
        // A ball of 2 kg, radius 0.1 m, at (0.3, 0, 0.1) m.
        let (m, x, z, ball) = (2.0, 0.3, 0.1, 0.4 * 2.0 * 0.01);
        let body = [
            m,
            m * x,
            0.0,
            m * z,
            ball + m * z * z,
            ball + m * (x * x + z * z),
            ball + m * x * x,
            0.0,
            -m * x * z,
            0.0,
        ];
        assert!(implausible_links(&names, &body).is_empty());
        let mut none = body;
        none[0] = -1.0;
        assert_eq!(implausible_links(&names, &none), [2]);
        let mut thin = body;
        thin[6] = 0.01; // less than M x^2
        assert_eq!(implausible_links(&names, &thin), [2]);
    }
}
