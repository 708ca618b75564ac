//! Origin of a number in the graph: the given numbers, and how they were combined.
//!
//! The rules fold numbers on creation, so `9.81 * 0.333` is one constant of the graph. Its formula
//! records the folds one by one, each a single rounded operation. A compiler that evaluates the
//! printed formula therefore gets identical bits.

/// Most given numbers in a formula; beyond it, the folded number is itself treated as a leaf.
const LEAVES: usize = 4;

/// A number, or one rounded operation on two formulas.
#[derive(Debug, Clone, PartialEq)]
pub enum Formula {
    /// A number, identified by its bits.
    Number(u64),
    /// `-a`
    Neg(Box<Formula>),
    /// `a op b`
    Binary(Fold, Box<Formula>, Box<Formula>),
}

/// Operation that combines two numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fold {
    /// `a + b`
    Add,
    /// `a - b`
    Sub,
    /// `a * b`
    Mul,
    /// `a / b`
    Div,
}

impl Fold {
    /// Symbol of the operator.
    pub fn symbol(self) -> char {
        match self {
            Self::Add => '+',
            Self::Sub => '-',
            Self::Mul => '*',
            Self::Div => '/',
        }
    }

    /// Rounded result.
    pub(super) fn of(self, a: f64, b: f64) -> f64 {
        match self {
            Self::Add => a + b,
            Self::Sub => a - b,
            Self::Mul => a * b,
            Self::Div => a / b,
        }
    }
}

impl Formula {
    /// Formula of a single number.
    pub fn number(value: f64) -> Self {
        Self::Number(value.to_bits())
    }

    /// Number of leaves.
    fn leaves(&self) -> usize {
        match self {
            Self::Number(_) => 1,
            Self::Neg(a) => a.leaves(),
            Self::Binary(_, a, b) => a.leaves() + b.leaves(),
        }
    }

    pub(super) fn negated(self) -> Self {
        match self {
            Self::Number(bits) => Self::number(-f64::from_bits(bits)),
            Self::Neg(a) => *a,
            other => Self::Neg(Box::new(other)),
        }
    }

    /// Formula of `a op b`, simplified; replaced by `value` if it is too long.
    pub(super) fn folded(fold: Fold, a: Self, b: Self, value: f64) -> Self {
        let is = |f: &Self, x: f64| *f == Self::number(x);
        match fold {
            Fold::Mul if is(&a, 1.0) => b,
            Fold::Mul if is(&b, 1.0) => a,
            Fold::Mul if is(&a, -1.0) => b.negated(),
            Fold::Mul if is(&b, -1.0) => a.negated(),
            _ if a.leaves() + b.leaves() > LEAVES => Self::number(value),
            _ => Self::Binary(fold, Box::new(a), Box::new(b)),
        }
    }
}
