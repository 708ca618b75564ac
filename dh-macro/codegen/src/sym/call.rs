//! Functions of one number that laws need in addition to sums and products.

use crate::elementary::Real;

/// A function of one number, defined by [`Real`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Call {
    /// Absolute value.
    Abs,
    /// Square root.
    Sqrt,
    /// Exponential function.
    Exp,
    /// Natural logarithm.
    Ln,
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
}

impl Call {
    /// Name of the corresponding method of [`Real`].
    pub fn name(self) -> &'static str {
        match self {
            Self::Abs => "abs",
            Self::Sqrt => "sqrt",
            Self::Exp => "exp",
            Self::Ln => "ln",
            Self::Sin => "sin",
            Self::Cos => "cos",
        }
    }

    /// Value of the function.
    pub fn value(self, x: f64) -> f64 {
        match self {
            Self::Abs => Real::abs(x),
            Self::Sqrt => Real::sqrt(x),
            Self::Exp => Real::exp(x),
            Self::Ln => Real::ln(x),
            Self::Sin => Real::sin(x),
            Self::Cos => Real::cos(x),
        }
    }

    /// Parity: `Some(true)` for even, `f(-x) = f(x)`; `Some(false)` for odd, `f(-x) = -f(x)`.
    pub fn even(self) -> Option<bool> {
        match self {
            Self::Abs | Self::Cos => Some(true),
            Self::Sin => Some(false),
            Self::Sqrt | Self::Exp | Self::Ln => None,
        }
    }
}
