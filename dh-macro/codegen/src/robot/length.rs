//! Lengths, together with their closed form as a polynomial in the named constants.

use std::collections::BTreeMap;

/// A polynomial in the robot file's named constants, for groupings in closed form.
///
/// A monomial is a sorted list of `(constant, power)`; the empty list is the number one.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Polynomial {
    terms: BTreeMap<Vec<(usize, u32)>, f64>,
}

impl Polynomial {
    /// Constant polynomial.
    pub fn number(value: f64) -> Self {
        let mut p = Self::default();
        if value != 0.0 {
            p.terms.insert(Vec::new(), value);
        }
        p
    }

    /// The named constant with this index in [`super::Robot::constants`].
    pub fn constant(index: usize) -> Self {
        Self { terms: BTreeMap::from([(vec![(index, 1)], 1.0)]) }
    }

    /// Monomials with their coefficients.
    pub fn terms(&self) -> impl Iterator<Item = (&[(usize, u32)], f64)> {
        self.terms.iter().map(|(monomial, &factor)| (monomial.as_slice(), factor))
    }

    /// Whether it is exactly zero.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// Its value, if no named constant occurs.
    pub fn as_number(&self) -> Option<f64> {
        match self.terms.len() {
            0 => Some(0.0),
            1 => self.terms.get(&Vec::new()).copied(),
            _ => None,
        }
    }

    /// Whether every coefficient is finite.
    pub fn is_finite(&self) -> bool {
        self.terms.values().all(|c| c.is_finite())
    }

    /// Number of terms.
    pub fn len(&self) -> usize {
        self.terms.len()
    }

    /// Whether it has no terms, and is therefore zero.
    pub fn is_empty(&self) -> bool {
        self.terms.is_empty()
    }

    /// Sum. Terms that cancel to within rounding (1e-12 of the summands) are removed.
    pub fn add(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        for (monomial, &c) in &other.terms {
            let entry = sum.terms.entry(monomial.clone()).or_insert(0.0);
            let total = *entry + c;
            *entry = if total.abs() <= 1e-12 * entry.abs().max(c.abs()) { 0.0 } else { total };
        }
        sum.terms.retain(|_, c| *c != 0.0);
        sum
    }

    /// Product.
    pub fn mul(&self, other: &Self) -> Self {
        let mut product = Self::default();
        for (a, x) in &self.terms {
            for (b, y) in &other.terms {
                let mut powers: BTreeMap<usize, u32> = a.iter().copied().collect();
                for &(k, n) in b {
                    *powers.entry(k).or_insert(0) += n;
                }
                product = product.add(&Self { terms: BTreeMap::from([(powers.into_iter().collect(), x * y)]) });
            }
        }
        product
    }

    /// Product with a number.
    pub fn scale(&self, factor: f64) -> Self {
        self.mul(&Self::number(factor))
    }

    /// Value for given constants.
    pub fn value(&self, constants: &[(String, f64)]) -> f64 {
        self.terms.iter().map(|(m, c)| m.iter().fold(*c, |v, &(k, n)| v * constants[k].1.powi(n as i32))).sum()
    }

    /// Closed form, `2*L2^2 - 0.5*L1`; a sum of several terms is *not* in brackets.
    pub fn text(&self, constants: &[(String, f64)]) -> String {
        self.written(constants, number)
    }

    /// Closed form with all digits of the coefficients.
    pub(super) fn exact_text(&self, constants: &[(String, f64)]) -> String {
        self.written(constants, |value| format!("{value:?}"))
    }

    fn written(&self, constants: &[(String, f64)], number: impl Fn(f64) -> String) -> String {
        let mut out = String::new();
        for (monomial, &c) in &self.terms {
            let sign = if c < 0.0 { "-" } else { "+" };
            out += &match (out.is_empty(), sign) {
                (true, "+") => String::new(),
                (true, _) => "-".to_string(),
                _ => format!(" {sign} "),
            };
            let factors: Vec<String> = monomial
                .iter()
                .map(|&(k, n)| if n == 1 { constants[k].0.clone() } else { format!("{}^{n}", constants[k].0) })
                .collect();
            out += &match (c.abs() == 1.0, factors.is_empty()) {
                (true, false) => factors.join("*"),
                (_, true) => number(c.abs()),
                _ => format!("{}*{}", number(c.abs()), factors.join("*")),
            };
        }
        if out.is_empty() { "0".to_string() } else { out }
    }
}

/// Rounds to at most 12 significant digits, to keep rounding noise out of formulas.
fn number(value: f64) -> String {
    let rounded: f64 = format!("{value:.11e}").parse().unwrap_or(value);
    format!("{rounded}")
}

/// A length in m, as a value and as a polynomial in the file's constants.
#[derive(Debug, Clone, PartialEq)]
pub struct Length {
    /// Value, m.
    pub value: f64,
    /// Polynomial in the file's constants; a plain number if the file gives one or divides by a
    /// constant.
    pub closed_form: Polynomial,
    /// Text of the length in the file.
    pub text: String,
}

impl Length {
    /// Length zero.
    pub fn zero() -> Self {
        Self::meters(0.0)
    }

    /// Length from a number, m.
    pub fn meters(value: f64) -> Self {
        Self { value, closed_form: Polynomial::number(value), text: format!("{value}") }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_print_in_the_constants() {
        let constants = [("L1".to_string(), 0.31), ("L2".to_string(), 0.4)];
        let (a, b) = (Polynomial::constant(0), Polynomial::constant(1));
        let p = b.mul(&b).scale(2.0).add(&a.scale(-1.0)).add(&Polynomial::number(0.5));
        assert_eq!(p.text(&constants), "0.5 - L1 + 2*L2^2");
        assert!((p.value(&constants) - (0.5 - 0.31 + 0.32)).abs() < 1e-15);
        assert!(p.add(&p.scale(-1.0)).is_zero());
    }
}
