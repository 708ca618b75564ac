//! Exact forms of a number in the file: a fraction, a fraction of pi, a polynomial in the
//! constants.

use core::f64::consts::PI;

use super::decimal::{QuarterTurns, quarter_turns};
use super::ratio::Ratio;
use super::{Angle, Length, Polynomial};

/// Most terms of a polynomial product; a longer one is kept as a plain number.
const MOST_TERMS: usize = 64;

/// A number with its known exact forms.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Value {
    /// Value of the number.
    pub(super) number: f64,
    /// Exact value as a fraction.
    rational: Option<Ratio>,
    /// Exact value as a fraction of pi.
    of_pi: Option<Ratio>,
    /// Polynomial in the named constants.
    polynomial: Option<Polynomial>,
    /// Text of a single decimal, and whether it is negative.
    decimal: Option<(bool, String)>,
}

impl Value {
    pub(super) fn literal(text: &str, number: f64) -> Self {
        let rational = Ratio::literal(text);
        let of_pi = (number == 0.0).then_some(Ratio { p: 0, q: 1 });
        let polynomial = Some(Polynomial::number(number));
        Self { number, rational, of_pi, polynomial, decimal: Some((false, text.to_string())) }
    }

    pub(super) fn fraction_of_pi(ratio: Ratio) -> Self {
        let number = ratio.p as f64 * PI / ratio.q as f64;
        let rational = (ratio.p == 0).then_some(ratio);
        Self { number, rational, of_pi: Some(ratio), polynomial: Some(Polynomial::number(number)), decimal: None }
    }

    fn build(number: f64, rational: Option<Ratio>, of_pi: Option<Ratio>, polynomial: Option<Polynomial>) -> Self {
        let number = of_pi.map_or(number, |r| r.p as f64 * PI / r.q as f64);
        let polynomial = polynomial.filter(Polynomial::is_finite);
        Self { number, rational, of_pi, polynomial, decimal: None }
    }

    pub(super) fn negated(mut self) -> Self {
        let minus = |r: Ratio| Ratio { p: -r.p, q: r.q };
        self.number = -self.number;
        self.rational = self.rational.map(minus);
        self.of_pi = self.of_pi.map(minus);
        self.polynomial = self.polynomial.map(|p| p.scale(-1.0));
        self.decimal = self.decimal.map(|(negative, text)| (!negative, text));
        self
    }

    pub(super) fn plus(&self, b: &Self) -> Self {
        let rational = self.rational.zip(b.rational).and_then(|(a, b)| a.add(b));
        let of_pi = self.of_pi.zip(b.of_pi).and_then(|(a, b)| a.add(b));
        let polynomial = self.polynomial.as_ref().zip(b.polynomial.as_ref()).map(|(a, b)| a.add(b));
        Self::build(self.number + b.number, rational, of_pi, polynomial)
    }

    pub(super) fn times(&self, b: &Self) -> Self {
        let rational = self.rational.zip(b.rational).and_then(|(a, b)| a.mul(b));
        let pair = self.of_pi.zip(b.rational).or(self.rational.zip(b.of_pi));
        let polynomial = self.polynomial.as_ref().zip(b.polynomial.as_ref());
        let small = polynomial.filter(|(a, b)| a.len() * b.len() <= MOST_TERMS);
        let of_pi = pair.and_then(|(a, b)| a.mul(b));
        Self::build(self.number * b.number, rational, of_pi, small.map(|(a, b)| a.mul(b)))
    }

    /// Quotient; `b` must not be zero.
    pub(super) fn over(&self, b: &Self) -> Self {
        let same = self.rational.zip(b.rational).or(self.of_pi.zip(b.of_pi));
        let rational = same.and_then(|(a, b)| a.div(b));
        let of_pi = self.of_pi.zip(b.rational).and_then(|(a, b)| a.div(b));
        let divisor = b.polynomial.as_ref().and_then(Polynomial::as_number).filter(|&d| d != 0.0);
        let polynomial = self.polynomial.as_ref().zip(divisor).map(|(p, d)| p.scale(1.0 / d));
        Self::build(self.number / b.number, rational, of_pi, polynomial)
    }

    /// Makes it the symbol of the named constant with this index.
    pub(super) fn becomes_constant(&mut self, index: usize) {
        self.polynomial = Some(Polynomial::constant(index));
    }

    /// Converts to a length, m.
    pub(super) fn length(self, text: &str) -> Length {
        let closed_form = self.polynomial.unwrap_or_else(|| Polynomial::number(self.number));
        Length { value: self.number, closed_form, text: text.to_string() }
    }

    /// Converts to an angle, rad, with a note on how it was interpreted.
    pub(super) fn angle(self, text: &str) -> (Angle, Option<String>) {
        if let Some(Ratio { p, q }) = self.of_pi {
            return (Angle { value: self.number, pi_multiple: Some((p, q)), text: text.to_string() }, None);
        }
        let plain = Angle { value: self.number, pi_multiple: None, text: text.to_string() };
        let Some((negative, literal)) = self.decimal else { return (plain, None) };
        let written = if text.contains(&literal) { text.to_string() } else { format!("{text} = {literal}") };
        let turned = |turns: u32| Angle::pi_fraction(if negative { -1 } else { 1 } * i64::from(turns), 2);
        match quarter_turns(&literal) {
            QuarterTurns::All(turns) => {
                let exact = turned(turns);
                let note = format!("{written} read as {}", exact.text);
                (Angle { text: text.to_string(), ..exact }, Some(note))
            }
            QuarterTurns::Maybe(turns) => {
                let exact = turned(turns).text;
                (
                    plain,
                    Some(format!(
                        "{written} is not exact and was read as that decimal; if {exact} is meant, write {exact}"
                    )),
                )
            }
            QuarterTurns::No => (plain, None),
        }
    }
}
