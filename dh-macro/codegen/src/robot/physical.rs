//! Checks whether ten inertial parameters belong to a physically possible body.

use super::Inertia;

/// Tolerated rounding error, relative to the largest entry of the tensor.
const ROUNDING: f64 = 1e-6;

/// Reason why no body has the parameters.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum NotPhysical {
    /// The mass is negative.
    #[error("the mass is {mass} kg")]
    NegativeMass {
        /// Mass, kg.
        mass: f64,
    },
    /// The mass is zero, but moments are not.
    #[error("the mass is 0, but the moments are not: the largest is {largest}")]
    MomentsWithoutMass {
        /// Largest moment, kg m or kg m^2.
        largest: f64,
    },
    /// The tensor at the centre of mass has a negative principal moment.
    #[error(
        "about the centre of mass ({:.4}, {:.4}, {:.4}) m the smallest principal moment of inertia is {:.4e} kg m^2, \
         which is negative", center[0], center[1], center[2], moments[0]
    )]
    NegativeMoment {
        /// Centre of mass, m.
        center: [f64; 3],
        /// Principal moments, ascending, kg m^2.
        moments: [f64; 3],
    },
    /// One principal moment is larger than the sum of the others.
    #[error(
        "about the centre of mass the principal moments of inertia are {:.4e}, {:.4e} and {:.4e} kg m^2: \
         the largest exceeds the sum of the others", moments[0], moments[1], moments[2]
    )]
    Triangle {
        /// Principal moments, ascending, kg m^2.
        moments: [f64; 3],
    },
}

impl Inertia {
    /// Checks that some distribution of mass has these parameters. The mass must not be negative,
    /// and the tensor about the centre of mass must be positive semidefinite. Its principal moments
    /// `J1 <= J2 <= J3` must satisfy `J3 <= J1 + J2`. All zeros (no body) are valid.
    pub fn physical(&self) -> Result<(), NotPhysical> {
        if self.m < 0.0 {
            return Err(NotPhysical::NegativeMass { mass: self.m });
        }
        if self.m == 0.0 {
            let largest = self.ms.iter().chain(&self.i).fold(0.0f64, |a, b| if b.abs() > a.abs() { *b } else { a });
            return if largest == 0.0 { Ok(()) } else { Err(NotPhysical::MomentsWithoutMass { largest }) };
        }
        let center = self.ms.map(|s| s / self.m);
        let moments = principal_moments(self.at_center().tensor());
        let tolerance = ROUNDING * self.i.iter().fold(0.0f64, |a, b| a.max(b.abs()));
        let finite = moments.iter().all(|j| j.is_finite()); // MS / M overflows for a mass of next to nothing
        if moments[0] < -tolerance || !finite {
            return Err(NotPhysical::NegativeMoment { center, moments });
        }
        if moments[2] - moments[1] - moments[0] > tolerance {
            return Err(NotPhysical::Triangle { moments });
        }
        Ok(())
    }

    /// The same body about its centre of mass; the mass must not be zero.
    fn at_center(&self) -> Self {
        let identity = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        self.moved(&identity, &self.ms.map(|s| -s / self.m))
    }
}

/// Eigenvalues of a symmetric matrix, ascending, by Jacobi rotations.
fn principal_moments(mut a: [[f64; 3]; 3]) -> [f64; 3] {
    for _ in 0..20 {
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            if a[p][q] == 0.0 {
                continue;
            }
            let angle = 0.5 * (2.0 * a[p][q]).atan2(a[q][q] - a[p][p]);
            let (s, c) = angle.sin_cos();
            for k in 0..3 {
                (a[k][p], a[k][q]) = (c * a[k][p] - s * a[k][q], s * a[k][p] + c * a[k][q]);
            }
            for k in 0..3 {
                (a[p][k], a[q][k]) = (c * a[p][k] - s * a[q][k], s * a[p][k] + c * a[q][k]);
            }
        }
    }
    let mut moments = [a[0][0], a[1][1], a[2][2]];
    moments.sort_by(f64::total_cmp);
    moments
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn principal_moments_are_eigenvalues() {
        let moments = principal_moments([[2.0, 1.0, 0.0], [1.0, 2.0, 0.0], [0.0, 0.0, 5.0]]);
        assert!(moments.iter().zip([1.0, 3.0, 5.0]).all(|(a, b)| (a - b).abs() < 1e-14), "{moments:?}");
        let a = [[4.0, -1.0, 0.5], [-1.0, 3.0, 0.25], [0.5, 0.25, 2.0]];
        let moments = principal_moments(a);
        assert!((moments.iter().sum::<f64>() - 9.0).abs() < 1e-13);
        for j in moments {
            let m = core::array::from_fn::<_, 3, _>(|r| {
                core::array::from_fn::<_, 3, _>(|c| a[r][c] - if r == c { j } else { 0.0 })
            });
            let det = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1])
                - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
                + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
            assert!(det.abs() < 1e-12, "{det}");
        }
    }

    #[test]
    fn bodies_that_can_not_be_are_told_apart() {
        let body = |m, ms, i| Inertia { m, ms, i };
        assert_eq!(body(0.0, [0.0; 3], [0.0; 6]).physical(), Ok(()));
        assert_eq!(body(2.0, [0.0, 0.0, 0.2], [0.02, 0.02, 0.0, 0.0, 0.0, 0.0]).physical(), Ok(()), "a point mass");
        assert!(matches!(body(-1.0, [0.0; 3], [1.0; 6]).physical(), Err(NotPhysical::NegativeMass { .. })));
        let without_mass = body(0.0, [0.0; 3], [0.0, 0.0, 0.35, 0.0, 0.0, 0.0]);
        assert_eq!(without_mass.physical(), Err(NotPhysical::MomentsWithoutMass { largest: 0.35 }));
        let too_far = body(2.0, [0.0, 0.0, 1.0], [0.02, 0.02, 0.01, 0.0, 0.0, 0.0]);
        assert!(matches!(too_far.physical(), Err(NotPhysical::NegativeMoment { .. })));
        let triangle = body(1.0, [0.0; 3], [0.1, 0.1, 0.3, 0.0, 0.0, 0.0]);
        assert!(matches!(triangle.physical(), Err(NotPhysical::Triangle { .. })));
        let products = body(1.0, [0.0; 3], [0.1, 0.1, 0.1, 0.2, 0.0, 0.0]);
        assert!(matches!(products.physical(), Err(NotPhysical::NegativeMoment { .. })));
    }
}
