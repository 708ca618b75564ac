//! Parses expressions of a robot file to a tree. Numbers allow `+ - * / ( )`, `pi`, named constants
//! and `90deg`; laws (`torque_law`) also powers, functions and variables. Both use one grammar.

use super::problem::closest;
use super::ratio::Ratio;
use super::value::Value;
use super::yaml::shortened;

/// Longest expression of a number, characters.
const LONGEST: usize = 1000;
/// Longest expression of a law, characters.
const LONGEST_LAW: usize = 4000;
/// Deepest nesting of brackets.
const DEEPEST: usize = 32;

/// Words that can't be names of constants.
pub(super) const RESERVED: [&str; 3] = ["pi", "deg", "rad"];

/// Reason why a text is not a number, or not a law.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct ExpressionError {
    /// Position of the error in the text, in characters from 0.
    pub(super) offset: usize,
    pub(super) what: String,
    pub(super) mend: String,
}

/// A part of an expression and its position in the text, in characters from 0.
#[derive(Debug)]
pub(super) struct Part {
    pub(super) at: usize,
    pub(super) syntax: Syntax,
}

/// Syntax of a part. Only brackets add depth, so no tree is deeper than a few times [`DEEPEST`].
#[derive(Debug)]
pub(super) enum Syntax {
    Number(String, f64),
    Name(String),
    /// `x deg`, with `deg` at `at`.
    Degrees(Box<Part>),
    Negative(Box<Part>),
    /// Summands, each with its sign `+` or `-` and the position of that sign.
    Sum(Vec<(char, usize, Part)>),
    /// Factors, each with the operator `*` or `/` before it and its position.
    Product(Vec<(char, usize, Part)>),
    /// `x ^ y`, with the operator at `at`.
    Power(Box<Part>, Box<Part>),
    /// Function call: name, position of the opening bracket, arguments.
    Call(String, usize, Vec<Part>),
}

/// Named constants, in the file's order.
#[derive(Debug, Default)]
pub(super) struct Scope {
    names: Vec<(String, Value)>,
}

impl Scope {
    /// Adds a constant.
    pub(super) fn define(&mut self, name: &str, mut value: Value) {
        value.becomes_constant(self.names.len());
        self.names.push((name.to_string(), value));
    }

    /// Names and values of the constants.
    pub(super) fn constants(&self) -> Vec<(String, f64)> {
        self.names.iter().map(|(name, value)| (name.clone(), value.number)).collect()
    }

    /// Constant with this name.
    pub(super) fn constant(&self, name: &str) -> Option<&Value> {
        self.names.iter().find(|(known, _)| known == name).map(|(_, value)| value)
    }

    /// Evaluates an expression.
    pub(super) fn evaluate(&self, text: &str) -> Result<Value, ExpressionError> {
        let known = |word: &str| self.constant(word).is_some();
        let root = Reader::new(text, Grammar::Number, &known)?.whole()?;
        self.value(&root)
    }

    fn value(&self, part: &Part) -> Result<Value, ExpressionError> {
        match &part.syntax {
            Syntax::Number(text, number) => Ok(Value::literal(text, *number)),
            Syntax::Name(name) if name == "pi" => Ok(Value::fraction_of_pi(Ratio { p: 1, q: 1 })),
            Syntax::Name(name) => self.constant(name).cloned().ok_or_else(|| self.unknown(name, part.at)),
            Syntax::Degrees(inner) => {
                let degree = Value::fraction_of_pi(Ratio { p: 1, q: 180 });
                finite(part.at, self.value(inner)?.times(&degree))
            }
            Syntax::Negative(inner) => Ok(self.value(inner)?.negated()),
            Syntax::Sum(parts) => self
                .folded(parts, |sign, _, sum, other| Ok(sum.plus(&if sign == '-' { other.negated() } else { other }))),
            Syntax::Product(parts) => self.folded(parts, |operator, at, product, other| match operator {
                '*' => Ok(product.times(&other)),
                _ if other.number == 0.0 => Err(error(at, "division by zero", "the divisor must not be 0")),
                _ => Ok(product.over(&other)),
            }),
            Syntax::Power(..) => Err(error(part.at, "`^` is not read", "write a power as a product: L1*L1")),
            Syntax::Call(name, at, _) if name == "pi" || self.constant(name).is_some() => {
                Err(error(*at, "`(` follows without an operator", "write a product with `*`"))
            }
            Syntax::Call(name, ..) => Err(self.unknown(name, part.at)),
        }
    }

    /// Applies an operation, given its operator and position, from the first to the last part.
    fn folded(
        &self,
        parts: &[(char, usize, Part)],
        operation: impl Fn(char, usize, Value, Value) -> Result<Value, ExpressionError>,
    ) -> Result<Value, ExpressionError> {
        let mut value: Option<Value> = None;
        for (sign, at, part) in parts {
            let next = self.value(part)?;
            value = Some(match value {
                None => next,
                Some(before) => finite(*at, operation(*sign, *at, before, next)?)?,
            });
        }
        value.ok_or_else(|| error(0, "the text is empty", "write a number"))
    }

    fn unknown(&self, name: &str, offset: usize) -> ExpressionError {
        let (name, known) = (shortened(name), self.names.iter().map(|(known, _)| known.as_str()));
        let mend = match name.as_str() {
            "deg" | "rad" => format!("write the unit behind its number: 90{name}"),
            "nan" | "NaN" | "inf" | "Inf" | "infinity" => "leave the key out where a value is not known".to_string(),
            "s" | "m" | "mm" | "cm" | "kg" | "g" | "N" | "Nm" | "A" => {
                "units other than deg and rad are not written: m, s, kg, N are understood".to_string()
            }
            "sin" | "cos" | "tan" | "sqrt" => "only + - * / ( ) are read; write the value".to_string(),
            _ => match closest(&name, known.clone().chain(["pi"])) {
                Some(close) => format!("did you mean `{close}`?"),
                None if self.names.is_empty() => {
                    "define it under `constants`; a constant may use those before it".to_string()
                }
                None => format!("the constants are {}", known.collect::<Vec<_>>().join(", ")),
            },
        };
        error(offset, format!("`{name}` is not a named constant"), mend)
    }
}

/// Parses a law; `known`: whether a word may be used in it.
pub(super) fn law(text: &str, known: &dyn Fn(&str) -> bool) -> Result<Part, ExpressionError> {
    Reader::new(text, Grammar::Law, known)?.whole()
}

/// Whether this is a valid name of a constant.
pub(super) fn is_name(text: &str) -> bool {
    text.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_')
        && text.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

pub(super) fn error(offset: usize, what: impl Into<String>, mend: impl Into<String>) -> ExpressionError {
    ExpressionError { offset, what: what.into(), mend: mend.into() }
}

fn finite(offset: usize, value: Value) -> Result<Value, ExpressionError> {
    if value.number.is_finite() {
        return Ok(value);
    }
    let mend = "check the exponents; units are m, rad, s, kg, N";
    Err(error(offset, "the result is too large for a number", mend))
}

/// Kind of the expression, on which the advice in errors depends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Grammar {
    Number,
    Law,
}

struct Reader<'a> {
    grammar: Grammar,
    known: &'a dyn Fn(&str) -> bool,
    characters: Vec<char>,
    at: usize,
    depth: usize,
}

impl<'a> Reader<'a> {
    fn new(text: &str, grammar: Grammar, known: &'a dyn Fn(&str) -> bool) -> Result<Self, ExpressionError> {
        let (longest, mend) = match grammar {
            Grammar::Number => (LONGEST, "split it with named constants"),
            Grammar::Law => (LONGEST_LAW, "leave out terms that are too small to matter, or digits"),
        };
        let characters: Vec<char> = text.chars().collect();
        if characters.len() > longest {
            let what = format!("an expression of {} characters; at most {longest} are read", characters.len());
            return Err(error(0, what, mend));
        }
        Ok(Self { grammar, known, characters, at: 0, depth: 0 })
    }

    /// Parses the whole text.
    fn whole(mut self) -> Result<Part, ExpressionError> {
        let root = self.sum()?;
        match self.peek() {
            None => Ok(root),
            Some(_) => Err(self.unexpected()),
        }
    }

    fn peek(&mut self) -> Option<char> {
        while self.characters.get(self.at).is_some_and(|c| c.is_whitespace()) {
            self.at += 1;
        }
        self.characters.get(self.at).copied()
    }

    fn take_while(&mut self, keep: impl Fn(char) -> bool) -> String {
        let rest = &self.characters[self.at..];
        let taken: String = rest.iter().copied().take_while(|&c| keep(c)).collect();
        self.at += taken.chars().count();
        taken
    }

    /// `product (+|- product)*`
    fn sum(&mut self) -> Result<Part, ExpressionError> {
        let first = self.product()?;
        let mut parts = vec![('+', first.at, first)];
        while let Some(sign @ ('+' | '-')) = self.peek() {
            let offset = self.at;
            self.at += 1;
            parts.push((sign, offset, self.product()?));
        }
        Ok(one_or(parts, Syntax::Sum))
    }

    /// `unary (*|/ unary)*`
    fn product(&mut self) -> Result<Part, ExpressionError> {
        let first = self.unary()?;
        let mut parts = vec![('*', first.at, first)];
        while let Some(operator @ ('*' | '/')) = self.peek() {
            let offset = self.at;
            self.at += 1;
            if operator == '*' && self.characters.get(self.at) == Some(&'*') {
                let mend = match self.grammar {
                    Grammar::Number => "write a power as a product: L1*L1",
                    Grammar::Law => "write a power with `^`: q1^2",
                };
                return Err(error(offset, "`**` is not read", mend));
            }
            parts.push((operator, offset, self.unary()?));
        }
        Ok(one_or(parts, Syntax::Product))
    }

    /// `(+|-)* single (^ (+|-)* single)?`
    fn unary(&mut self) -> Result<Part, ExpressionError> {
        let (negative, at) = self.signs();
        let mut part = self.single()?;
        if self.peek() == Some('^') {
            let sign = self.at;
            self.at += 1;
            let (negative, from) = self.signs();
            let exponent = signed(negative, from, self.single()?);
            if self.peek() == Some('^') {
                return Err(error(self.at, "a power of a power", "say which is first with brackets: (q1^2)^3"));
            }
            part = Part { at: sign, syntax: Syntax::Power(Box::new(part), Box::new(exponent)) };
        }
        Ok(signed(negative, at, part))
    }

    /// Reads signs: whether the result is negative, and the position of the first sign.
    fn signs(&mut self) -> (bool, usize) {
        let mut negative = false;
        self.peek();
        let start = self.at;
        while let Some(sign @ ('+' | '-')) = self.peek() {
            negative ^= sign == '-';
            self.at += 1;
        }
        (negative, start)
    }

    /// `primary (deg|rad)?`
    fn single(&mut self) -> Result<Part, ExpressionError> {
        let part = self.primary()?;
        self.suffix(part)
    }

    fn primary(&mut self) -> Result<Part, ExpressionError> {
        let offset = {
            self.peek();
            self.at
        };
        match self.peek() {
            Some('(') => {
                self.open()?;
                let inner = self.sum()?;
                self.close(offset)?;
                Ok(inner)
            }
            Some(c) if c.is_ascii_digit() || c == '.' => self.number(),
            Some(c) if c.is_ascii_alphabetic() || c == '_' => self.named(),
            _ => Err(self.unexpected()),
        }
    }

    fn open(&mut self) -> Result<(), ExpressionError> {
        self.depth += 1;
        if self.depth > DEEPEST {
            let mend = match self.grammar {
                Grammar::Number => "use named constants",
                Grammar::Law => "write the law as a sum of products",
            };
            return Err(error(self.at, format!("more than {DEEPEST} brackets in each other"), mend));
        }
        self.at += 1;
        Ok(())
    }

    /// Reads the closing bracket; `offset`: position of the opening one.
    fn close(&mut self, offset: usize) -> Result<(), ExpressionError> {
        if self.peek() != Some(')') {
            return Err(error(offset, "this bracket is not closed", "add the missing `)`"));
        }
        self.at += 1;
        self.depth -= 1;
        Ok(())
    }

    fn number(&mut self) -> Result<Part, ExpressionError> {
        let offset = self.at;
        let mut literal = self.take_while(|c| c.is_ascii_digit() || c == '.');
        if let [mark @ ('e' | 'E'), rest @ ..] = &self.characters[self.at..] {
            let sign = rest.first().filter(|c| ['+', '-'].contains(c));
            let digit = if sign.is_some() { rest.get(1) } else { rest.first() };
            if digit.is_some_and(char::is_ascii_digit) {
                literal.push(*mark);
                literal.extend(sign);
                self.at += 1 + usize::from(sign.is_some());
                literal += &self.take_while(|c| c.is_ascii_digit());
            }
        }
        match literal.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(Part { at: offset, syntax: Syntax::Number(literal, number) }),
            Ok(_) => {
                Err(error(offset, format!("{} is too large for a number", shortened(&literal)), "check the exponent"))
            }
            Err(_) => {
                let word = self.take_while(|c| c.is_ascii_alphabetic());
                let mend = if word.is_empty() {
                    "write digits with at most one point, and an exponent as in 1.5e-3"
                } else {
                    "leave the key out where a value is not known"
                };
                literal += &word;
                Err(error(offset, format!("`{}` is not a number", shortened(&literal)), mend))
            }
        }
    }

    /// Reads a name, or a function with its arguments.
    fn named(&mut self) -> Result<Part, ExpressionError> {
        let at = self.at;
        let name = self.take_while(|c| c.is_ascii_alphanumeric() || c == '_');
        if self.peek() != Some('(') {
            return Ok(Part { at, syntax: Syntax::Name(name) });
        }
        let bracket = self.at;
        self.open()?;
        let mut arguments = vec![self.sum()?];
        while self.peek() == Some(',') {
            self.at += 1;
            arguments.push(self.sum()?);
        }
        self.close(bracket)?;
        Ok(Part { at, syntax: Syntax::Call(name, bracket, arguments) })
    }

    /// Reads `deg` or `rad` after a number, a name or a bracket.
    fn suffix(&mut self, part: Part) -> Result<Part, ExpressionError> {
        let Some(c) = self.peek() else { return Ok(part) };
        if !(c.is_ascii_alphabetic() || c == '_') {
            return Ok(part);
        }
        let offset = self.at;
        let word = self.take_while(|c| c.is_ascii_alphanumeric() || c == '_');
        match word.as_str() {
            "rad" => Ok(part),
            "deg" => Ok(Part { at: offset, syntax: Syntax::Degrees(Box::new(part)) }),
            "degrees" | "degree" | "grad" => Err(error(offset, format!("the unit `{word}` is not read"), "write deg")),
            "radians" | "radian" => {
                Err(error(offset, format!("the unit `{word}` is not read"), "write rad, or nothing"))
            }
            "pi" => Err(error(offset, "`pi` follows without an operator", "write a product with `*`: 2*pi")),
            _ if (self.known)(&word) => {
                let what = format!("`{}` follows without an operator", shortened(&word));
                Err(error(offset, what, format!("write a product with `*`: 2*{}", shortened(&word))))
            }
            _ => {
                let mend = "only deg and rad may follow a number; m, s, kg, N are understood and not written";
                Err(error(offset, format!("`{}` follows a number", shortened(&word)), mend))
            }
        }
    }

    fn unexpected(&mut self) -> ExpressionError {
        let law = self.grammar == Grammar::Law;
        let (what, mend) = match self.peek() {
            None if self.characters.iter().all(|c| c.is_whitespace()) => {
                ("the text is empty".into(), if law { "write an expression" } else { "write a number" })
            }
            None => ("the expression ends too early".into(), "a number is missing at the end"),
            Some(')') => ("a `)` without its `(`".to_string(), "delete it, or open the bracket"),
            Some('^') if law => ("`^` stands where a number is missing".into(), "write a number before it"),
            Some('^') => ("`^` is not read".into(), "write a power as a product: L1*L1"),
            Some(',') => ("a comma stands in a number".into(), "write a decimal point: 1.5"),
            Some('\u{b0}') => ("the sign of a degree is not read".into(), "write deg: 90deg"),
            Some('\u{2212}' | '\u{2013}') => ("a dash that is no minus".into(), "write the `-` of the keyboard"),
            Some('\u{3c0}') => ("the letter for pi is not read".into(), "write pi"),
            Some(c @ ('*' | '/')) => (format!("`{c}` stands where a number is missing"), "write a number before it"),
            Some(c) if c.is_ascii_digit() || c == '(' => {
                (format!("`{c}` follows without an operator"), "write a product with `*`")
            }
            Some(c) if law => (
                format!("`{c}` does not belong in a law"),
                "digits, + - * / ^ ( ), pi, deg, named constants, functions and variables",
            ),
            Some(c) => {
                (format!("`{c}` does not belong in a number"), "digits, + - * / ( ), pi, deg and named constants")
            }
        };
        error(self.at, what, mend)
    }
}

/// The only part if there is just one, otherwise all of them combined.
fn one_or(mut parts: Vec<(char, usize, Part)>, all: fn(Vec<(char, usize, Part)>) -> Syntax) -> Part {
    let at = parts[0].1;
    match parts.len() {
        1 => parts.remove(0).2,
        _ => Part { at, syntax: all(parts) },
    }
}

fn signed(negative: bool, at: usize, part: Part) -> Part {
    if negative { Part { at, syntax: Syntax::Negative(Box::new(part)) } } else { part }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::robot::Angle;

    fn scope() -> Scope {
        let mut scope = Scope::default();
        for (name, text) in
            [("L1", "0.3105"), ("L2", "0.40"), ("A", "22.5deg"), ("B", "1.5708"), ("C", "-1.5707963"), ("Z", "0")]
        {
            let value = scope.evaluate(text).unwrap();
            scope.define(name, value);
        }
        scope
    }

    #[test]
    fn fractions_of_pi_stay_exact() {
        let scope = scope();
        for (text, expected) in [
            ("pi/2", (1, 2)),
            ("-pi/2", (-1, 2)),
            ("90deg", (1, 2)),
            ("-90 deg", (-1, 2)),
            ("22.5deg", (1, 8)),
            ("3*pi/4", (3, 4)),
            ("A", (1, 8)),
            ("pi - A*2", (3, 4)),
            ("0.5*pi", (1, 2)),
            ("(30 + 60)deg", (1, 2)),
            ("--90deg", (1, 2)),
            ("pi*(pi/pi)", (1, 1)),
            ("0", (0, 1)),
            ("0.0", (0, 1)),
            ("1.5708", (1, 2)),
            ("-1.5708rad", (-1, 2)),
            ("(1.5708)", (1, 2)),
            ("B", (1, 2)),
            ("-B", (-1, 2)),
            ("C", (-1, 2)),
            ("3.14159", (1, 1)),
        ] {
            let (angle, _) = scope.evaluate(text).unwrap().angle(text);
            assert_eq!(angle.pi_multiple, Some(expected), "{text}");
            assert_eq!(angle.value, Angle::pi_fraction(expected.0, expected.1).value, "{text}");
        }
        for text in ["1.5712", "1.57", "B + 0", "1.5708 + 0", "2*0.7854", "1", "L1*1"] {
            assert_eq!(scope.evaluate(text).unwrap().angle(text).0.pi_multiple, None, "{text}");
        }
    }

    #[test]
    fn readings_are_told() {
        let scope = scope();
        let note = |text: &str| scope.evaluate(text).unwrap().angle(text).1.unwrap_or_default();
        assert_eq!(note("1.5708"), "1.5708 read as pi/2");
        assert_eq!(note("-1.5708"), "-1.5708 read as -pi/2");
        assert_eq!(note("B"), "B = 1.5708 read as pi/2");
        assert_eq!(note("1.57"), "1.57 is not exact and was read as that decimal; if pi/2 is meant, write pi/2");
        assert_eq!(note("1.5712") + &note("pi/2") + &note("1.5708 + 0"), "");
    }

    #[test]
    fn lengths_are_polynomials_in_the_constants() {
        let scope = scope();
        let length = |text: &str| scope.evaluate(text).unwrap().length(text);
        for (text, closed) in [
            ("L1 + 0.1", "0.1 + L1"),
            ("2*L2", "2*L2"),
            ("L1/2", "0.5*L1"),
            ("-(L1 - L2)", "-L1 + L2"),
            ("(L1+L2)*(L1-L2)", "L1^2 - L2^2"),
            ("0.3105", "0.3105"),
            ("L1 - L1", "0"),
        ] {
            assert_eq!(length(text).closed_form.text(&scope.constants()), closed, "{text}");
        }
        let quotient = length("L1/L2");
        assert_eq!(quotient.closed_form.as_number(), Some(0.3105 / 0.40));
        assert_eq!(length("(((L1+L2)*(L1+L2)))*1e3").value, (0.3105 + 0.4) * (0.3105 + 0.4) * 1e3);
    }

    #[test]
    fn what_is_no_number_says_where_and_why() {
        let scope = scope();
        for (text, offset, word) in [
            ("1/0", 1, "division by zero"),
            ("1/(L1-L1)", 1, "division by zero"),
            ("pi/Z", 2, "division by zero"),
            ("1e308*10", 5, "too large"),
            ("1e999", 0, "too large"),
            ("L9", 0, "not a named constant"),
            ("2*L22", 2, "not a named constant"),
            ("nan", 0, "not a named constant"),
            (".inf", 0, "not a number"),
            ("1.2.3", 0, "not a number"),
            ("1 +", 3, "ends too early"),
            ("", 0, "empty"),
            ("(1", 0, "not closed"),
            ("1)", 1, "without its"),
            ("2^3", 1, "is not read"),
            ("2**3", 1, "is not read"),
            ("2L1", 1, "without an operator"),
            ("1 2", 2, "without an operator"),
            ("5mm", 1, "follows a number"),
            ("90\u{b0}", 2, "degree"),
            ("1,5", 1, "comma"),
        ] {
            let error = scope.evaluate(text).expect_err(text);
            assert!(error.what.contains(word) && error.offset == offset, "{text}: {error:?}");
        }
        assert!(scope.evaluate(&"(".repeat(900)).is_err());
        assert!(scope.evaluate(&"1+".repeat(5000)).is_err());
        assert_eq!(scope.evaluate(&format!("{}1", "-".repeat(900))).unwrap().number, 1.0);
    }
}
