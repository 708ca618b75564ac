//! Torques in closed form, for effects without a name: `law: "0.7*sin(3*q2)*sign(dq4)"`.
//!
//! Conversion: `text -> expression (tree) -> torque_law/read (names, values, units) -> Term`, and
//! back by `Display`. Generated code evaluates it by `arm/formula.rs`.

mod bounds;
mod dimension;
mod read;

use core::fmt;

pub(super) use read::{Law, unit_of};

use super::JointKind;
use super::expression::{ExpressionError, Scope};

/// A quantity at one joint, or of the whole arm. Indices count moving joints from 0; texts count
/// from 1, like the columns of a log.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Variable {
    /// `q`: position, rad or m, without the encoder's error.
    Position(usize),
    /// `dq`: velocity, rad/s or m/s.
    Velocity(usize),
    /// `ddq`: acceleration, rad/s^2 or m/s^2.
    Acceleration(usize),
    /// `temp`: temperature, degrees C.
    Temperature(usize),
    /// `t`: time since the start of the motion, s.
    Time,
}

/// Function of one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LawFunction {
    /// `sin`
    Sin,
    /// `cos`
    Cos,
    /// `exp`
    Exp,
    /// `ln`
    Ln,
    /// `sqrt`
    Sqrt,
    /// `abs`
    Abs,
    /// `sign`: -1, 0 or 1.
    Sign,
    /// `tanh`
    Tanh,
}

impl LawFunction {
    /// All functions.
    pub const ALL: [Self; 8] =
        [Self::Sin, Self::Cos, Self::Exp, Self::Ln, Self::Sqrt, Self::Abs, Self::Sign, Self::Tanh];

    /// Name of the function in a law.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Sin => "sin",
            Self::Cos => "cos",
            Self::Exp => "exp",
            Self::Ln => "ln",
            Self::Sqrt => "sqrt",
            Self::Abs => "abs",
            Self::Sign => "sign",
            Self::Tanh => "tanh",
        }
    }
}

/// An expression. Laws found by identification are built from these; see [`TorqueLaw::new`].
#[derive(Debug, Clone, PartialEq)]
pub enum Term {
    /// A number, in the unit that its place requires.
    Number(f64),
    /// A variable.
    Variable(Variable),
    /// `-x`
    Negative(Box<Self>),
    /// `1 / x`; in a product `/ x`.
    Inverse(Box<Self>),
    /// `x + y + ..`, from left to right; a [`Term::Negative`] after the first is a difference.
    Sum(Vec<Self>),
    /// `x * y * ..`, from left to right; a [`Term::Inverse`] after the first is a quotient.
    Product(Vec<Self>),
    /// `x ^ n`: any `x` for an integer `n`, otherwise only `x >= 0`.
    Power(Box<Self>, f64),
    /// A function of one argument.
    Call(LawFunction, Box<Self>),
    /// Minimum of two.
    Least(Box<Self>, Box<Self>),
    /// Maximum of two.
    Most(Box<Self>, Box<Self>),
}

impl Term {
    /// Calls `f` with each variable that occurs.
    pub fn variables(&self, f: &mut impl FnMut(Variable)) {
        match self {
            Self::Number(_) => {}
            Self::Variable(v) => f(*v),
            Self::Negative(x) | Self::Inverse(x) | Self::Power(x, _) | Self::Call(_, x) => x.variables(f),
            Self::Sum(all) | Self::Product(all) => all.iter().for_each(|x| x.variables(f)),
            Self::Least(x, y) | Self::Most(x, y) => {
                x.variables(f);
                y.variables(f);
            }
        }
    }
}

/// A torque (for a prismatic joint, a force) in closed form.
#[derive(Debug, Clone)]
pub struct TorqueLaw {
    text: String,
    term: Term,
}

/// Equality of the expressions, independent of their text.
impl PartialEq for TorqueLaw {
    fn eq(&self, other: &Self) -> bool {
        self.term == other.term
    }
}

/// Reason why an expression is not a law.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("`{text}`: {what}; {mend}")]
pub struct NotALaw {
    /// Text of the expression.
    pub text: String,
    /// Description of the mistake.
    pub what: String,
    /// Advice on how to fix it.
    pub mend: String,
}

impl TorqueLaw {
    /// Law of an expression, for an arm whose moving joints are of these kinds, base to tip.
    ///
    /// # Errors
    /// The reasons for which a robot file with this expression is rejected: a joint that does not
    /// exist, inconsistent units, an expression that is undefined somewhere (a divisor that may be
    /// 0, a root of what may be negative), too many characters or brackets.
    pub fn new(term: &Term, joints: &[JointKind]) -> Result<Self, NotALaw> {
        Self::read(&term.to_string(), joints, &Scope::default())
    }

    /// Law stated by a text, which may not use named constants.
    ///
    /// # Errors
    /// See [`TorqueLaw::new`].
    pub fn parse(text: &str, joints: &[JointKind]) -> Result<Self, NotALaw> {
        Self::read(text, joints, &Scope::default())
    }

    fn read(text: &str, joints: &[JointKind], scope: &Scope) -> Result<Self, NotALaw> {
        Self::of_file(text, &Law { joints, scope }).map_err(|error| NotALaw {
            text: super::yaml::shortened(text),
            what: format!("character {}: {}", error.offset + 1, error.what),
            mend: error.mend,
        })
    }

    /// Law of a file, with the variables and constants in `words`.
    pub(super) fn of_file(text: &str, words: &Law<'_>) -> Result<Self, ExpressionError> {
        let term = words.term(text)?;
        Ok(Self { text: text.split_whitespace().collect::<Vec<_>>().join(" "), term })
    }

    /// The expression.
    #[must_use]
    pub fn term(&self) -> &Term {
        &self.term
    }

    /// Text in the file, with constants by name.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Whether it depends on time or temperature.
    #[must_use]
    pub fn reads_clock(&self) -> bool {
        let mut clock = false;
        self.term.variables(&mut |v| clock |= matches!(v, Variable::Time | Variable::Temperature(_)));
        clock
    }

    /// Whether it depends on an acceleration.
    #[must_use]
    pub fn reads_acceleration(&self) -> bool {
        let mut found = false;
        self.term.variables(&mut |v| found |= matches!(v, Variable::Acceleration(_)));
        found
    }

    /// Original text if it has the same meaning with these constants, otherwise a text without
    /// constants.
    pub(super) fn words(&self, words: &Law<'_>) -> String {
        let same = Self::of_file(&self.text, words).is_ok_and(|law| law == *self);
        if same { self.text.clone() } else { self.term.to_string() }
    }
}

impl fmt::Display for TorqueLaw {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.term, f)
    }
}

impl fmt::Display for Variable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Position(k) => write!(f, "q{}", k + 1),
            Self::Velocity(k) => write!(f, "dq{}", k + 1),
            Self::Acceleration(k) => write!(f, "ddq{}", k + 1),
            Self::Temperature(k) => write!(f, "temp{}", k + 1),
            Self::Time => f.write_str("t"),
        }
    }
}

/// Precedence of a term's operation.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Power,
    Single,
}

impl Term {
    fn binding(&self) -> Binding {
        match self {
            Self::Number(x) if x.is_sign_negative() => Binding::Sum,
            Self::Sum(_) | Self::Negative(_) => Binding::Sum,
            Self::Product(_) | Self::Inverse(_) => Binding::Product,
            Self::Power(..) => Binding::Power,
            Self::Number(_) | Self::Variable(_) | Self::Call(..) | Self::Least(..) | Self::Most(..) => Binding::Single,
        }
    }

    /// Writes the term, in brackets if its precedence is below `least`.
    fn within(&self, least: Binding, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.binding() < least { write!(f, "({self})") } else { fmt::Display::fmt(self, f) }
    }
}

/// Writes text that reads back as an expression of the same value.
impl fmt::Display for Term {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(x) => {
                let text = format!("{x:?}");
                f.write_str(text.strip_suffix(".0").unwrap_or(&text))
            }
            Self::Variable(v) => write!(f, "{v}"),
            Self::Negative(x) => {
                f.write_str("-")?;
                x.within(Binding::Product, f)
            }
            Self::Inverse(x) => {
                f.write_str("1/")?;
                x.within(Binding::Power, f)
            }
            Self::Sum(all) if all.is_empty() => f.write_str("0"),
            Self::Sum(all) => all.iter().enumerate().try_for_each(|(k, x)| match x {
                _ if k == 0 && matches!(x, Self::Sum(_)) => write!(f, "({x})"),
                _ if k == 0 => write!(f, "{x}"),
                Self::Negative(x) => {
                    f.write_str(" - ")?;
                    x.within(Binding::Product, f)
                }
                Self::Number(x) if x.is_sign_negative() => write!(f, " - {}", Self::Number(-x)),
                _ => {
                    f.write_str(" + ")?;
                    x.within(Binding::Product, f)
                }
            }),
            Self::Product(all) if all.is_empty() => f.write_str("1"),
            Self::Product(all) => all.iter().enumerate().try_for_each(|(k, x)| match x {
                Self::Inverse(x) if k > 0 => {
                    f.write_str("/")?;
                    x.within(Binding::Power, f)
                }
                // The first factor may have a sign: `-2*q1`.
                Self::Number(_) if k == 0 => write!(f, "{x}"),
                Self::Negative(x) if k == 0 => {
                    f.write_str("-")?;
                    x.within(Binding::Power, f)
                }
                _ => {
                    f.write_str(if k > 0 { "*" } else { "" })?;
                    x.within(Binding::Power, f)
                }
            }),
            Self::Power(x, n) => {
                x.within(Binding::Single, f)?;
                write!(f, "^{}", Self::Number(*n))
            }
            Self::Call(function, x) => write!(f, "{}({x})", function.name()),
            Self::Least(x, y) => write!(f, "min({x}, {y})"),
            Self::Most(x, y) => write!(f, "max({x}, {y})"),
        }
    }
}
