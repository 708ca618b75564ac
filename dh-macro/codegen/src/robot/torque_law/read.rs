//! Converts the tree of a text to a law: resolves names, and checks that values exist for every
//! motion and that units are consistent.

use super::super::JointKind;
use super::super::expression::{ExpressionError, Part, Scope, Syntax, error, law};
use super::super::problem::closest;
use super::super::yaml::shortened;
use super::bounds::Bounds;
use super::dimension::{Dimension, Powers};
use super::{LawFunction, Term, Variable};
use crate::elementary::Real;

/// Largest exponent.
const HIGHEST: f64 = 16.0;

/// Names of variables that are followed by the number of a joint.
const NUMBERED: [&str; 4] = ["ddq", "dq", "q", "temp"];
const TIME: &str = "t";
const LEAST: &str = "min";
const MOST: &str = "max";

/// Lowest temperature of a log column (absolute zero), degrees C.
const COLDEST: f64 = -273.15;

/// Unit of a joint's torque or force.
pub(in crate::robot) fn unit_of(kind: JointKind) -> &'static str {
    if kind == JointKind::Prismatic { "N" } else { "N m" }
}

/// Meaning of the words in a law: variables and constants.
pub(in crate::robot) struct Law<'a> {
    /// Kinds of the moving joints.
    pub(in crate::robot) joints: &'a [JointKind],
    pub(in crate::robot) scope: &'a Scope,
}

/// A word that names a variable.
enum Word<'n> {
    /// A variable of this arm.
    Variable(Variable),
    /// A quantity with the number of a joint that the arm does not have.
    OfNoJoint(&'n str),
}

/// A parsed part with its known properties.
struct Known {
    term: Term,
    bounds: Bounds,
    dimension: Dimension,
    /// Value, if it contains no variable.
    constant: Option<f64>,
}

type Result<T> = core::result::Result<T, ExpressionError>;

impl Law<'_> {
    pub(in crate::robot) fn term(&self, text: &str) -> Result<Term> {
        let known = |word: &str| self.variable(word).is_some() || function(word) || self.scope.constant(word).is_some();
        let root = law(text, &known)?;
        self.part(&root).map(|known| known.term)
    }

    fn part(&self, part: &Part) -> Result<Known> {
        let known = match &part.syntax {
            Syntax::Number(_, value) => number(*value),
            Syntax::Name(name) => self.name(name, part.at)?,
            Syntax::Degrees(inner) => {
                let inner = self.part(inner)?;
                product(inner, number(core::f64::consts::PI / 180.0))
            }
            Syntax::Negative(inner) => negated(self.part(inner)?),
            Syntax::Sum(parts) => self.sum(parts)?,
            Syntax::Product(parts) => self.product(parts)?,
            Syntax::Power(base, exponent) => self.power(base, exponent, part.at)?,
            Syntax::Call(name, bracket, arguments) => self.call(name, part.at, *bracket, arguments)?,
        };
        match known.constant {
            Some(value) if !value.is_finite() => {
                Err(error(part.at, "the result is too large for a number", "check the exponents"))
            }
            _ => Ok(known),
        }
    }

    /// Variable with this name; `None` if the name is no variable.
    fn variable<'n>(&self, name: &'n str) -> Option<Word<'n>> {
        if name == TIME {
            return Some(Word::Variable(Variable::Time));
        }
        let stem = name.trim_end_matches(|c: char| c.is_ascii_digit());
        let digits = &name[stem.len()..];
        if !NUMBERED.contains(&stem) || digits.is_empty() {
            return None;
        }
        let number = digits.parse::<usize>().ok().filter(|_| !digits.starts_with('0'));
        let joint = number.and_then(|n| n.checked_sub(1)).filter(|&k| k < self.joints.len());
        let Some(joint) = joint else { return Some(Word::OfNoJoint(stem)) };
        Some(Word::Variable(match stem {
            "ddq" => Variable::Acceleration(joint),
            "dq" => Variable::Velocity(joint),
            "q" => Variable::Position(joint),
            _ => Variable::Temperature(joint),
        }))
    }

    fn name(&self, name: &str, at: usize) -> Result<Known> {
        let constant = self.scope.constant(name);
        match self.variable(name) {
            Some(_) if constant.is_some() => {
                let what = format!("`{}` is a constant of this file and a variable of laws", shortened(name));
                Err(error(at, what, "give the constant another name"))
            }
            Some(Word::Variable(variable)) => Ok(self.of(variable)),
            Some(Word::OfNoJoint(stem)) => {
                let what = format!("there is no joint of `{}`", shortened(name));
                let last = self.joints.len();
                let range = if last == 1 { format!("{stem}1") } else { format!("{stem}1 to {stem}{last}") };
                Err(error(at, what, format!("the joints that move have {range}")))
            }
            None if name == "pi" => Ok(number(core::f64::consts::PI)),
            None => constant.map(|value| number(value.number)).ok_or_else(|| self.unknown(name, at)),
        }
    }

    fn of(&self, variable: Variable) -> Known {
        let slides = |k: usize| self.joints.get(k) == Some(&JointKind::Prismatic);
        let (dimension, bounds) = match variable {
            Variable::Position(k) => (Powers::motion(slides(k), 0), Bounds::ANY),
            Variable::Velocity(k) => (Powers::motion(slides(k), 1), Bounds::ANY),
            Variable::Acceleration(k) => (Powers::motion(slides(k), 2), Bounds::ANY),
            Variable::Temperature(_) => (Powers::TEMPERATURE, Bounds::new(COLDEST, f64::INFINITY)),
            Variable::Time => (Powers::TIME, Bounds::new(0.0, f64::INFINITY)),
        };
        Known { term: Term::Variable(variable), bounds, dimension: Some(dimension), constant: None }
    }

    fn unknown(&self, name: &str, at: usize) -> ExpressionError {
        let name = shortened(name);
        let constants = self.scope.constants();
        let functions = LawFunction::ALL.iter().map(|f| f.name()).chain([LEAST, MOST]);
        let mend = match name.as_str() {
            "q" | "dq" | "ddq" | "temp" => format!("write the number of a joint behind it: {name}1"),
            "deg" | "rad" => format!("write the unit behind its number: 90{name}"),
            "tan" => "it has poles; write what stays finite with sin and cos".to_string(),
            "log" => "write ln, the natural logarithm".to_string(),
            "e" => "write exp(x), or 1e-3 for a power of ten".to_string(),
            word if word.starts_with("tau") => {
                "a law is of positions q, velocities dq, accelerations ddq, time t and temperatures temp".to_string()
            }
            _ => match closest(&name, constants.iter().map(|(known, _)| known.as_str()).chain(functions.clone())) {
                Some(close) => format!("did you mean `{close}`?"),
                None => format!(
                    "a law has the variables q1.. dq1.. ddq1.. temp1.. t, the constants of the file, pi, and {}",
                    functions.collect::<Vec<_>>().join(" ")
                ),
            },
        };
        error(at, format!("`{name}` has no meaning in a law"), mend)
    }

    fn sum(&self, parts: &[(char, usize, Part)]) -> Result<Known> {
        let mut terms = Vec::with_capacity(parts.len());
        let mut so_far: Option<(Bounds, Dimension, Option<f64>)> = None;
        for (sign, at, part) in parts {
            let known = self.part(part)?;
            let known = if *sign == '-' { negated(known) } else { known };
            so_far = Some(match so_far {
                None => (known.bounds, known.dimension, known.constant),
                Some((bounds, dimension, constant)) => (
                    bounds.plus(known.bounds),
                    together(dimension, known.dimension, *at, "added")?,
                    constant.zip(known.constant).map(|(a, b)| a + b),
                ),
            });
            terms.push(known.term);
        }
        let (bounds, dimension, constant) = so_far.unwrap_or((Bounds::of(0.0), None, Some(0.0)));
        Ok(Known { term: Term::Sum(terms), bounds, dimension, constant })
    }

    fn product(&self, parts: &[(char, usize, Part)]) -> Result<Known> {
        let mut terms = Vec::with_capacity(parts.len());
        let mut all = Known { dimension: Some(Powers::NONE), ..number(1.0) };
        for (sign, at, part) in parts {
            let mut known = self.part(part)?;
            if *sign == '/' {
                not_zero(known.bounds, known.constant, *at)?;
                known = inverse(known);
            }
            terms.push(known.term.clone());
            all = product(all, known);
        }
        Ok(Known { term: Term::Product(terms), ..all })
    }

    fn power(&self, base: &Part, exponent: &Part, at: usize) -> Result<Known> {
        let known = self.part(base)?;
        let Some(n) = self.part(exponent)?.constant else {
            let mend = "the exponent must be a number; write exp(y*ln(x)) of an x that is never 0 or less";
            return Err(error(exponent.at, "the exponent has a variable in it", mend));
        };
        if n.abs() > HIGHEST {
            return Err(error(
                exponent.at,
                format!("the power {n}"),
                format!("powers from -{HIGHEST} to {HIGHEST} are read"),
            ));
        }
        let whole = n.fract() == 0.0;
        if !whole && known.bounds.least < 0.0 {
            let mend = format!("write abs( ) around it, and sign( ) beside: sign(x)*abs(x)^{n}");
            return Err(error(at, format!("the power {n} of what may be negative"), mend));
        }
        let raised = match whole {
            true => known.bounds.raised(n.abs() as u32),
            false => known.bounds.by(|x| x.powf(n.abs())),
        };
        if n < 0.0 {
            not_zero(known.bounds, known.constant, at)?;
            not_zero(raised, None, at)?;
        }
        Ok(Known {
            bounds: if n < 0.0 { raised.inverse() } else { raised },
            dimension: known.dimension.map(|powers| powers.raised(n)),
            constant: known.constant.map(|x| x.powf(n)),
            term: Term::Power(Box::new(known.term), n),
        })
    }

    fn call(&self, name: &str, at: usize, bracket: usize, arguments: &[Part]) -> Result<Known> {
        if !function(name) {
            let is_name = name == "pi" || self.scope.constant(name).is_some() || self.variable(name).is_some();
            return Err(match is_name {
                true => error(bracket, "`(` follows without an operator", "write a product with `*`"),
                false => self.unknown(name, at),
            });
        }
        let choice = name == LEAST || name == MOST;
        let wanted = if choice { 2 } else { 1 };
        if arguments.len() != wanted {
            let (what, s) = (arguments.len(), if wanted == 1 { "" } else { "s" });
            let example = if choice { format!("{name}(x, y)") } else { format!("{name}(x)") };
            let what = format!("{name} of {what}, and it is of {wanted} number{s}");
            return Err(error(bracket, what, format!("write {example}; a decimal point is no comma")));
        }
        let first = self.part(&arguments[0])?;
        match LawFunction::ALL.into_iter().find(|f| f.name() == name) {
            Some(function) => called(function, first, arguments[0].at, at),
            None => {
                let second = self.part(&arguments[1])?;
                let dimension = together(first.dimension, second.dimension, arguments[1].at, "compared")?;
                let (bounds, pair) = (first.bounds, (Box::new(first.term), Box::new(second.term)));
                let constant = first.constant.zip(second.constant);
                Ok(match name {
                    LEAST => Known {
                        term: Term::Least(pair.0, pair.1),
                        bounds: bounds.least_of(second.bounds),
                        constant: constant.map(|(a, b)| a.min(b)),
                        dimension,
                    },
                    _ => Known {
                        term: Term::Most(pair.0, pair.1),
                        bounds: bounds.most_of(second.bounds),
                        constant: constant.map(|(a, b)| a.max(b)),
                        dimension,
                    },
                })
            }
        }
    }
}

/// Whether this is the name of a function.
fn function(name: &str) -> bool {
    name == LEAST || name == MOST || LawFunction::ALL.iter().any(|f| f.name() == name)
}

fn number(value: f64) -> Known {
    Known { term: Term::Number(value), bounds: Bounds::of(value), dimension: None, constant: Some(value) }
}

fn negated(known: Known) -> Known {
    Known {
        term: Term::Negative(Box::new(known.term)),
        bounds: known.bounds.negated(),
        constant: known.constant.map(|x| -x),
        ..known
    }
}

/// Inverse of an expression that is never 0.
fn inverse(known: Known) -> Known {
    Known {
        term: Term::Inverse(Box::new(known.term)),
        bounds: known.bounds.inverse(),
        dimension: known.dimension.map(|powers| powers.raised(-1.0)),
        constant: known.constant.map(|x| 1.0 / x),
    }
}

fn product(a: Known, b: Known) -> Known {
    Known {
        term: Term::Product(vec![a.term, b.term]),
        bounds: a.bounds.times(b.bounds),
        dimension: a.dimension.zip(b.dimension).map(|(a, b)| a.times(b)),
        constant: a.constant.zip(b.constant).map(|(a, b)| a * b),
    }
}

fn not_zero(bounds: Bounds, constant: Option<f64>, at: usize) -> Result<()> {
    match constant {
        Some(0.0) => Err(error(at, "division by zero", "the divisor must not be 0")),
        _ if bounds.holds_zero() => {
            let mend = "add what keeps it away from 0: abs(dq1) + 0.1, q1^2 + 0.01";
            Err(error(at, "division by what may be 0", mend))
        }
        _ => Ok(()),
    }
}

/// Common unit of operands that are added or compared.
fn together(a: Dimension, b: Dimension, at: usize, how: &str) -> Result<Dimension> {
    match (a, b) {
        (Some(x), Some(y)) if x != y => {
            let what = format!("{} and {} are {how}", x.words(), y.words());
            Err(error(at, what, "give one of them a number that carries the unit: q1 + 0.1*dq1"))
        }
        (known, other) => Ok(known.or(other)),
    }
}

/// Applies a function; `inside`: position of the argument.
fn called(function: LawFunction, x: Known, inside: usize, at: usize) -> Result<Known> {
    let name = function.name();
    let transcendental = !matches!(function, LawFunction::Abs | LawFunction::Sign | LawFunction::Sqrt);
    if let (true, Some(powers)) = (transcendental, x.dimension.filter(|powers| *powers != Powers::NONE)) {
        let what = format!("{name} of {}; it is of a plain number or an angle", powers.words());
        return Err(error(inside, what, format!("divide by a number that carries the unit: {name}(x/0.1)")));
    }
    let bounds = match function {
        LawFunction::Sin | LawFunction::Cos | LawFunction::Tanh => Bounds::new(-1.0, 1.0),
        LawFunction::Sign => x.bounds.sign(),
        LawFunction::Abs => x.bounds.abs(),
        LawFunction::Exp => x.bounds.exp(),
        LawFunction::Sqrt if x.bounds.least < 0.0 => {
            return Err(error(at, "sqrt of what may be negative", "write sqrt(abs(x)), and sign(x) beside it"));
        }
        LawFunction::Sqrt => x.bounds.by(Real::sqrt),
        LawFunction::Ln if x.bounds.least <= 0.0 => {
            let mend = "add what keeps it above 0: ln(1 + abs(x)), ln(q1^2 + 0.01)";
            return Err(error(at, "ln of what may be 0 or negative", mend));
        }
        LawFunction::Ln => x.bounds.by(f64::ln),
    };
    let dimension = match function {
        LawFunction::Abs => x.dimension,
        LawFunction::Sqrt => x.dimension.map(|powers| powers.raised(0.5)),
        _ => Some(Powers::NONE),
    };
    let value = |x: f64| match function {
        LawFunction::Sin => x.sin(),
        LawFunction::Cos => x.cos(),
        LawFunction::Tanh => x.tanh(),
        LawFunction::Exp => x.exp(),
        LawFunction::Ln => x.ln(),
        LawFunction::Sqrt => x.sqrt(),
        LawFunction::Abs => x.abs(),
        LawFunction::Sign => crate::runtime::Scalar::sign(x),
    };
    let constant = x.constant.map(value);
    // The value itself, for a constant argument.
    let bounds = constant.map_or(bounds, Bounds::of);
    Ok(Known { term: Term::Call(function, Box::new(x.term)), bounds, dimension, constant })
}
