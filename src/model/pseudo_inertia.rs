//! The ten parameters of a body as a symmetric 4 x 4 pseudo-inertia matrix.
//!
//! `P = [[S, MS], [MS', M]]` with `S = tr(I)/2 1 - I`, the second moments `integral of x x' dm`.
//! The parameters are those of a mass distribution exactly if `P` is positive semidefinite (P.
//! Wensing, S. Kim, J.-J. Slotine, *Linear matrix inequalities for physically consistent inertial
//! parameter identification*, IEEE Robotics and Automation Letters 3(1), 2018).

use nalgebra::{Cholesky, Const, Matrix4, SMatrix, SVector};

/// Pseudo-inertia of `M MSX MSY MSZ XX YY ZZ XY XZ YZ` (kg, kg m, kg m^2, about the frame's
/// origin).
pub fn pseudo_inertia(body: &[f64; 10]) -> Matrix4<f64> {
    let [m, x, y, z, xx, yy, zz, xy, xz, yz] = *body;
    let half = (xx + yy + zz) / 2.0;
    #[rustfmt::skip]
    let pseudo = Matrix4::new(
        half - xx, -xy, -xz, x,
        -xy, half - yy, -yz, y,
        -xz, -yz, half - zz, z,
        x, y, z, m,
    );
    pseudo
}

/// The ten parameters of a pseudo-inertia: `I = tr(S) 1 - S`.
pub fn body_of(p: &Matrix4<f64>) -> [f64; 10] {
    let [a, b, c] = [p[(0, 0)], p[(1, 1)], p[(2, 2)]];
    [p[(3, 3)], p[(0, 3)], p[(1, 3)], p[(2, 3)], b + c, a + c, a + b, -p[(0, 1)], -p[(0, 2)], -p[(1, 2)]]
}

/// Whether a mass distribution that is not confined to a plane has these parameters.
pub(crate) fn is_body(body: &[f64; 10]) -> bool {
    body.iter().all(|v| v.is_finite()) && pseudo_inertia(body).cholesky().is_some()
}

/// Orthonormal basis of the symmetric matrices: `E_k`, `k = 0..10`.
pub(crate) fn basis(k: usize) -> Matrix4<f64> {
    const PLACES: [(usize, usize); 10] =
        [(0, 0), (1, 1), (2, 2), (3, 3), (0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)];
    let (i, j) = PLACES[k];
    let mut e = Matrix4::zeros();
    let value = if i == j { 1.0 } else { std::f64::consts::FRAC_1_SQRT_2 };
    e[(i, j)] = value;
    e[(j, i)] = value;
    e
}

/// `sum_k v_k E_k`.
pub(crate) fn symmetric(v: &[f64]) -> Matrix4<f64> {
    let r = std::f64::consts::FRAC_1_SQRT_2;
    let [a, b, c, d] = [v[0], v[1], v[2], v[3]];
    let [ab, ac, ad, bc, bd, cd] = [v[4] * r, v[5] * r, v[6] * r, v[7] * r, v[8] * r, v[9] * r];
    Matrix4::new(a, ab, ac, ad, ab, b, bc, bd, ac, bc, c, cd, ad, bd, cd, d)
}

/// Coordinates of a symmetric matrix: `<E_k, Y>`.
pub(crate) fn coordinates(y: &Matrix4<f64>) -> SVector<f64, 10> {
    SVector::from_fn(|k, _| basis(k).dot(y))
}

/// A body measured relative to another: `P = L Y L'` with `L L'` the pseudo-inertia of the
/// reference, `Y = sum_k v_k E_k`. The reference itself is `Y = 1`, and properties of `Y` do not
/// depend on units or frames.
#[derive(Debug, Clone)]
pub(crate) struct Yardstick {
    root: Cholesky<f64, Const<4>>,
    /// `x = T v`: matrix from coordinates to the ten parameters.
    pub(crate) to_body: SMatrix<f64, 10, 10>,
}

impl Yardstick {
    /// The yardstick of a reference body; `None` if that is not a possible body.
    pub(crate) fn new(reference: &[f64; 10]) -> Option<Self> {
        let root = pseudo_inertia(reference).cholesky()?;
        let l = root.l();
        let mut to_body = SMatrix::<f64, 10, 10>::zeros();
        for k in 0..10 {
            let body = body_of(&(l * basis(k) * l.transpose()));
            to_body.column_mut(k).copy_from_slice(&body);
        }
        Some(Self { root, to_body })
    }

    /// `Y` of a body.
    pub(crate) fn measure(&self, body: &[f64; 10]) -> Matrix4<f64> {
        let l = self.root.l();
        let mut half = pseudo_inertia(body);
        l.solve_lower_triangular_unchecked_mut(&mut half);
        let mut y = half.transpose();
        l.solve_lower_triangular_unchecked_mut(&mut y);
        (y + y.transpose()) * 0.5
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BODY: [f64; 10] = [2.0, 0.3, -0.1, 0.2, 0.25, 0.3, 0.28, 0.02, -0.03, 0.01];

    #[test]
    fn there_and_back() {
        for (a, b) in body_of(&pseudo_inertia(&BODY)).iter().zip(BODY) {
            assert!((a - b).abs() < 1e-15);
        }
        let y = pseudo_inertia(&BODY);
        assert!((symmetric(coordinates(&y).as_slice()) - y).norm() < 1e-14);
        assert!(is_body(&BODY) && !is_body(&[-1.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0]));
    }

    #[test]
    fn a_body_in_units_of_another() {
        let reference = [1.5, 0.0, 0.1, -0.2, 0.2, 0.2, 0.1, 0.0, 0.0, 0.0];
        let yardstick = Yardstick::new(&reference).unwrap();
        assert!((yardstick.measure(&reference) - Matrix4::identity()).norm() < 1e-13);
        let v = coordinates(&yardstick.measure(&BODY));
        let back = yardstick.to_body * v;
        for (a, b) in back.iter().zip(BODY) {
            assert!((a - b).abs() < 1e-13, "{a} {b}");
        }
        assert!(Yardstick::new(&[0.0; 10]).is_none());
    }
}
