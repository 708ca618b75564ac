//! Functions of one number that laws need beyond sums and products.

use crate::elementary::Real;

/// A function of one number. Its meaning is [`Real`]'s.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Call {
    /// Size.
    Abs,
    /// Square root.
    Sqrt,
    /// `e` to a power.
    Exp,
    /// Natural logarithm.
    Ln,
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
}

impl Call {
    /// The method of [`Real`] that does it.
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

    /// Its value.
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

    /// `f(-x) = f(x)`: `Some(true)`; `f(-x) = -f(x)`: `Some(false)`.
    pub fn even(self) -> Option<bool> {
        match self {
            Self::Abs | Self::Cos => Some(true),
            Self::Sin => Some(false),
            Self::Sqrt | Self::Exp | Self::Ln => None,
        }
    }
}
