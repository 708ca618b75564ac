//! Eigenvalues of symmetric matrices of any rank.

use nalgebra::{DMatrix, Dyn, SymmetricEigen};

/// Eigenvalues and eigenvectors of a symmetric matrix with finite entries.
///
/// Where the rank is small, each Householder step of nalgebra's tridiagonalisation leaves the
/// rounding error of the previous one: 1e-17, 1e-34 and so on, until squares underflow and the
/// result is NaN. Adding a multiple of the identity keeps the rounding error constant, at the cost
/// of relative precision of the smallest eigenvalues. The shift is therefore applied only where it
/// is needed.
pub(crate) fn symmetric(matrix: DMatrix<f64>) -> SymmetricEigen<f64, Dyn> {
    let eigen = SymmetricEigen::new(matrix.clone());
    let numbers =
        |e: &SymmetricEigen<f64, Dyn>| e.eigenvalues.iter().chain(e.eigenvectors.iter()).all(|x| x.is_finite());
    if numbers(&eigen) {
        return eigen;
    }
    let (n, shift) = (matrix.nrows(), matrix.norm());
    let mut shifted = SymmetricEigen::new(matrix + DMatrix::identity(n, n) * shift);
    shifted.eigenvalues.add_scalar_mut(-shift);
    shifted
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Unknowns of a diagnosis, most of which occur in no equation: nalgebra alone returns NaN
    /// eigenvalues here.
    #[test]
    fn a_matrix_of_low_rank_has_its_eigenvalues() {
        let entries = [
            (4, 4, 1.0000000000000002),
            (4, 23, -0.001960145252667743),
            (4, 24, 0.014989559550020792),
            (23, 23, 1.0),
            (23, 24, -0.2522831444950957),
            (24, 24, 1.0),
            (25, 25, 0.9999999999999999),
            (25, 26, -0.4116905330038977),
            (25, 27, 0.1882419112520407),
            (26, 26, 1.0),
            (26, 27, -0.15314950255871432),
            (27, 27, 1.0),
        ];
        let mut matrix = DMatrix::zeros(28, 28);
        for (i, k, x) in entries {
            (matrix[(i, k)], matrix[(k, i)]) = (x, x);
        }
        let found = symmetric(matrix.clone());
        let axes = &found.eigenvectors;
        let again = axes * DMatrix::from_diagonal(&found.eigenvalues) * axes.transpose();
        assert!((again - matrix).amax() < 1e-14);
        assert!((axes.transpose() * axes - DMatrix::identity(28, 28)).amax() < 1e-14);
    }
}
