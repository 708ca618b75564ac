//! Reasons why knots and coefficients do not define a motion.

/// Reason why knots and coefficients do not define a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum CoefficientError {
    /// Too few knots for the degree.
    #[error("a spline of degree {degree} needs at least {} knots", 2 * (degree + 1))]
    Degree {
        /// Polynomial degree.
        degree: usize,
    },
    /// Knots do not ascend from 0, or their ends are not clamped.
    #[error("`knots` must ascend from 0, with the first and the last {0} of them equal")]
    Ends(usize),
    /// Inner knots coincide.
    #[error("inner `knots` must be different from each other")]
    Inner,
    /// A joint has another number of coefficients than the knots require.
    #[error("joint {joint} has {has} `coefficients`; these knots need {needs}")]
    Count {
        /// Joint, counted from 1.
        joint: usize,
        /// Number of its coefficients.
        has: usize,
        /// Number that the knots require.
        needs: usize,
    },
    /// Amplitudes and constant parts of a Fourier series differ in shape.
    #[error("`sine` and `cosine` need one row per entry of `center`, all of the same length")]
    Amplitudes,
}
