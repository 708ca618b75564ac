//! Converts ten inertial parameters to measurable quantities: mass, centre, tensor about the
//! centre, principal axes.

use dh_codegen::robot::Inertia;
use nalgebra::{Matrix3, Rotation3, Vector3};

/// Body in engineering terms, in the axes of the frame in which its parameters are given.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// Mass, kg.
    pub mass: f64,
    /// Centre of mass, m.
    pub center: [f64; 3],
    /// Standard deviations of the centre, m, from the covariance of the parameters to first order.
    pub center_std: [f64; 3],
    /// Tensor about the centre of mass, `XX YY ZZ XY XZ YZ`, kg m^2.
    pub tensor: [f64; 6],
    /// Principal moments, ascending, kg m^2.
    pub principal_moments: [f64; 3],
    /// Principal axes, one row each, in the order of the moments; a right-handed set.
    pub principal_axes: [[f64; 3]; 3],
    /// Reason why the body is physically impossible, if it is. Least squares does not enforce
    /// possibility, and noise may violate it.
    pub impossible: Option<String>,
}

impl Body {
    /// Body from ten parameters and their covariance (row-major `10 * 10`). `None` if the mass is
    /// not positive, as there is no centre then.
    pub fn new(values: &[f64; 10], covariance: &[f64]) -> Option<Self> {
        let inertia = Inertia::from_array(*values);
        let mass = inertia.m;
        if mass.is_nan() || mass <= 0.0 || values.iter().any(|v| !v.is_finite()) {
            return None;
        }
        let center = inertia.ms.map(|s| s / mass);
        // c = MS / M: dc = (dMS - c dM) / M.
        let center_std = std::array::from_fn(|k| {
            let c = |i: usize, j: usize| covariance[10 * i + j];
            let variance = c(k + 1, k + 1) - 2.0 * center[k] * c(0, k + 1) + center[k] * center[k] * c(0, 0);
            variance.max(0.0).sqrt() / mass
        });
        let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let centered = inertia.moved(&identity, &center.map(|c| -c));
        let tensor = centered.tensor();
        let eigen = Matrix3::from_fn(|i, k| tensor[i][k]).symmetric_eigen();
        let mut order = [0, 1, 2];
        order.sort_by(|&a, &b| eigen.eigenvalues[a].total_cmp(&eigen.eigenvalues[b]));
        let mut axes: [Vector3<f64>; 3] = order.map(|k| {
            let axis: Vector3<f64> = eigen.eigenvectors.column(k).into();
            // The sign of an axis is arbitrary: the largest component is made positive.
            if axis[axis.icamax()] < 0.0 { -axis } else { axis }
        });
        if axes[0].cross(&axes[1]).dot(&axes[2]) < 0.0 {
            axes[2] = -axes[2];
        }
        Some(Self {
            mass,
            center,
            center_std,
            tensor: centered.i,
            principal_moments: order.map(|k| eigen.eigenvalues[k]),
            principal_axes: axes.map(|a| [a.x, a.y, a.z]),
            impossible: inertia.physical().err().map(|defect| defect.to_string()),
        })
    }
}

/// Matrix `T` (`10 * 10`) with `pi' = T pi` for a body expressed in another frame. `rotation`
/// (row-major) and `origin` (m) are those of the present frame in the new one.
pub fn moving(rotation: &[[f64; 3]; 3], origin: &[f64; 3]) -> nalgebra::SMatrix<f64, 10, 10> {
    let mut matrix = nalgebra::SMatrix::<f64, 10, 10>::zeros();
    for column in 0..10 {
        let mut unit = [0.0; 10];
        unit[column] = 1.0;
        let moved = Inertia::from_array(unit).moved(rotation, origin).to_array();
        matrix.set_column(column, &nalgebra::SVector::<f64, 10>::from(moved));
    }
    matrix
}

/// Derivatives of the parameters when the body is shifted along an axis (first three, per m) or
/// rotated about it (last three, per rad).
pub(super) fn displacements(values: &[f64; 10]) -> [[f64; 10]; 6] {
    const STEP: f64 = 1e-5;
    let inertia = Inertia::from_array(*values);
    let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    std::array::from_fn(|way| {
        let at = |step: f64| {
            let mut axis = Vector3::zeros();
            axis[way % 3] = step;
            if way < 3 {
                return inertia.moved(&identity, &axis.into()).to_array();
            }
            let turn = Rotation3::new(axis);
            let rows = std::array::from_fn(|i| std::array::from_fn(|k| turn[(i, k)]));
            inertia.moved(&rows, &[0.0; 3]).to_array()
        };
        let (ahead, behind) = (at(STEP), at(-STEP));
        std::array::from_fn(|k| (ahead[k] - behind[k]) / (2.0 * STEP))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rod along y and a ball, away from the origin.
    #[test]
    fn a_rod_has_its_axis_and_its_moments() {
        let (m, l, c) = (0.6, 0.5, [0.1, -0.2, 0.3]);
        let j = m * l * l / 12.0;
        let rod = Inertia { m, ms: [0.0; 3], i: [j, 0.0, j, 0.0, 0.0, 0.0] };
        let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let values = rod.moved(&identity, &c).to_array();
        let mut covariance = vec![0.0; 100];
        covariance[0] = 1e-6;
        covariance[11] = 4e-8;
        let body = Body::new(&values, &covariance).unwrap();
        for k in 0..3 {
            assert!((body.center[k] - c[k]).abs() < 1e-12);
        }
        assert!(body.principal_moments[0].abs() < 1e-12 && (body.principal_moments[2] - j).abs() < 1e-12);
        assert!((body.principal_axes[0][1] - 1.0).abs() < 1e-12, "{:?}", body.principal_axes);
        assert!(body.impossible.is_none());
        // Independent errors of M and MSX.
        let expected = ((4e-8f64 + 0.01 * 1e-6).sqrt() / m, 0.2 * 1e-3 / m);
        assert!((body.center_std[0] - expected.0).abs() < 1e-12 && (body.center_std[1] - expected.1).abs() < 1e-12);
        assert!(Body::new(&[0.0; 10], &covariance).is_none());
        let moved = moving(&identity, &c) * nalgebra::SVector::from(rod.to_array());
        assert!(moved.iter().zip(values).all(|(a, b)| (a - b).abs() < 1e-15));
    }

    #[test]
    fn displacements_are_derivatives() {
        let values = [0.5, 0.02, -0.01, 0.1, 0.03, 0.04, 0.02, 0.001, -0.002, 0.003];
        let d = displacements(&values);
        // d MS / d p = M, d XX / d y = 2 MSY, d MSY / d (turn about x) = -MSZ.
        assert!((d[0][1] - 0.5).abs() < 1e-9 && (d[1][4] + 0.02).abs() < 1e-9 && (d[3][2] + 0.1).abs() < 1e-9);
        assert!(d.iter().all(|way| way[0].abs() < 1e-12));
    }

    /// Positively correlated errors of mass and first moments leave the centre unchanged;
    /// negatively correlated ones add up.
    #[test]
    fn errors_of_the_centre_are_those_of_a_quotient() {
        let values = [2.0, 0.6, -0.4, 0.2, 0.3, 0.3, 0.3, 0.0, 0.0, 0.0];
        let center = [0.3, -0.2, 0.1];
        for (sense, expected) in [(1.0, 0.0), (-1.0, 2.0)] {
            let direction: Vec<f64> = (0..10)
                .map(|k| {
                    if k == 0 {
                        1e-3
                    } else if k < 4 {
                        sense * 1e-3 * center[k - 1]
                    } else {
                        0.0
                    }
                })
                .collect();
            let covariance: Vec<f64> = (0..100).map(|e| direction[e / 10] * direction[e % 10]).collect();
            let body = Body::new(&values, &covariance).unwrap();
            for k in 0..3 {
                let std = expected * 1e-3 * center[k].abs() / 2.0;
                assert!((body.center_std[k] - std).abs() < 1e-9, "{sense} {k}: {:?}", body.center_std);
            }
        }
    }
}
