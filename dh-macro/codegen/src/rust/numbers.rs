//! Prints numbers of the robot file as Rust text, by their names in the file.

use std::collections::BTreeMap;

use super::words::Constant;
use crate::arm::chain::Chain;
use crate::robot::{Polynomial, Robot};
use crate::sym::Formula;

/// Gravity as a constant of the crate.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Gravity {
    pub name: &'static str,
    /// Value, m/s^2, without negative zeros.
    pub value: [f64; 3],
}

impl Gravity {
    /// Gravity in the world frame.
    pub(super) fn world(chain: &Chain) -> Self {
        Self { name: "GRAVITY", value: turned_back(chain.world_lift) }
    }

    /// Gravity in frame 0, in which the recursions start; a separate constant if the base is
    /// tilted.
    pub(super) fn base(chain: &Chain) -> Self {
        let (world, value) = (Self::world(chain), turned_back(chain.lift));
        if value == world.value { world } else { Self { name: "GRAVITY_IN_BASE", value } }
    }
}

/// Gravity from the acceleration that counteracts it.
fn turned_back(lift: [f64; 3]) -> [f64; 3] {
    lift.map(|x| if x == 0.0 { 0.0 } else { -x })
}

/// Text of each number, by its bits.
#[derive(Debug, Clone, Default)]
pub(super) struct Numbers {
    named: BTreeMap<u64, String>,
    /// Local variables of kernels for constants of the file, by path.
    locals: BTreeMap<String, String>,
}

impl Numbers {
    /// Collects constants of the file, gravity, and lengths of the table in closed form. Each text
    /// evaluates to the bits of its number; the first text for a number is kept. `gravity`: its
    /// name and value in the axes used by the kernel.
    pub(super) fn new(robot: &Robot, gravity: &Gravity, constants: &[Constant]) -> Self {
        let mut all = Self::default();
        for c in constants {
            let path = format!("constants::{}", c.item);
            all.locals.insert(path.clone(), c.local.clone());
            all.add(c.value, path);
        }
        for c in constants {
            all.add(-c.value, format!("-constants::{}", c.item));
        }
        for (axis, g) in gravity.value.into_iter().enumerate() {
            all.add(g, format!("{}[{axis}]", gravity.name));
            all.add(-g, format!("-{}[{axis}]", gravity.name));
        }
        let lengths = robot.joints.iter().flat_map(|j| [&j.d, &j.r]);
        for length in lengths {
            for sign in [1.0, -1.0] {
                if let Some(text) =
                    closed_form(&length.closed_form.scale(sign), sign * length.value, constants, "constants::")
                {
                    all.add(sign * length.value, text);
                }
            }
        }
        all
    }

    fn add(&mut self, value: f64, text: String) {
        if ![0.0, 1.0, -1.0].contains(&value) {
            self.named.entry(value.to_bits()).or_insert(text);
        }
    }

    /// Text of a formula; `None` if no number in it has a name.
    pub(super) fn text(&self, formula: &Formula) -> Option<String> {
        self.has_name(formula).then(|| self.written(formula))
    }

    /// Local variable that holds exactly this constant of the file.
    pub(super) fn local(&self, text: &str) -> Option<String> {
        self.locals.get(text).cloned()
    }

    fn has_name(&self, formula: &Formula) -> bool {
        match formula {
            Formula::Number(bits) => self.named.contains_key(bits),
            Formula::Neg(a) => self.has_name(a),
            Formula::Binary(_, a, b) => self.has_name(a) || self.has_name(b),
        }
    }

    fn written(&self, formula: &Formula) -> String {
        let operand = |f: &Formula| match (f, self.written(f)) {
            (Formula::Number(_), text) if !text.contains(' ') => text,
            (_, text) => format!("({text})"),
        };
        match formula {
            Formula::Number(bits) => {
                self.named.get(bits).cloned().unwrap_or_else(|| format!("{:?}", f64::from_bits(*bits)))
            }
            Formula::Neg(a) => format!("-{}", operand(a)),
            Formula::Binary(fold, a, b) => format!("{} {} {}", operand(a), fold.symbol(), operand(b)),
        }
    }
}

/// Polynomial in the file's constants as a Rust expression; `None` if it has none of them, or if
/// its evaluation differs from `value` in the last bits.
pub(super) fn closed_form(form: &Polynomial, value: f64, constants: &[Constant], path: &str) -> Option<String> {
    if form.as_number().is_some() {
        return None;
    }
    let (mut text, mut sum) = (String::new(), 0.0);
    for (monomial, factor) in form.terms() {
        let (words, size) = product(monomial, factor.abs(), constants, path)?;
        let first = text.is_empty();
        text += match (first, factor < 0.0) {
            (true, false) => "",
            (true, true) => "-",
            (false, false) => " + ",
            (false, true) => " - ",
        };
        text += &words;
        let signed = if factor < 0.0 { -size } else { size };
        sum = if first { signed } else { sum + signed };
    }
    (sum.to_bits() == value.to_bits()).then_some(text)
}

/// Product of two lengths given as numbers in the table, `0.088 * 0.088`, if it has the bits of
/// `value` and is the shorter text.
pub(super) fn product_of_lengths(value: f64, robot: &Robot) -> Option<String> {
    let lengths = robot.joints.iter().flat_map(|j| [&j.d, &j.r]).filter_map(|l| l.closed_form.as_number());
    let lengths: Vec<f64> = lengths.filter(|l| *l != 0.0).collect();
    let sign = if value < 0.0 { "-" } else { "" };
    let all = lengths.iter().flat_map(|a| lengths.iter().map(move |b| (a.abs(), b.abs())));
    let mut texts = all.filter(|(a, b)| a * b == value.abs()).map(|(a, b)| format!("{sign}{a:?} * {b:?}"));
    texts.find(|text| text.len() < format!("{value:?}").len())
}

/// Text of the product `factor * L1 * (L2 * L2)`, rounded in this order, and its value.
fn product(monomial: &[(usize, u32)], factor: f64, constants: &[Constant], path: &str) -> Option<(String, f64)> {
    let mut words = Vec::new();
    let mut value = factor;
    if factor != 1.0 || monomial.is_empty() {
        words.push(format!("{factor:?}"));
    }
    for &(k, n) in monomial {
        let constant = constants.get(k)?;
        let power: Vec<String> = (0..n).map(|_| format!("{path}{}", constant.item)).collect();
        let power = power.join(" * ");
        words.push(if n > 1 && !words.is_empty() { format!("({power})") } else { power });
        value *= (1..n).fold(constant.value, |x, _| x * constant.value);
    }
    Some((words.join(" * "), value))
}

#[cfg(test)]
mod tests {
    use crate::robot::no_files;

    use super::*;

    #[test]
    fn closed_forms_have_the_bits_of_their_number() {
        let constant =
            |word: &str, value| Constant { word: word.into(), item: word.into(), local: String::new(), value };
        let constants = [constant("L1", 0.31), constant("L2", 0.4)];
        let (a, b) = (Polynomial::constant(0), Polynomial::constant(1));
        let text = |form: &Polynomial, value: f64| closed_form(form, value, &constants, "");
        assert_eq!(text(&b.mul(&b), 0.4 * 0.4), Some("L2 * L2".into()));
        assert_eq!(text(&b.mul(&b), 0.16), None, "0.4 * 0.4 is not 0.16");
        assert_eq!(text(&b.mul(&b).scale(3.0), 3.0 * (0.4 * 0.4)), Some("3.0 * (L2 * L2)".into()));
        assert_eq!(text(&a.add(&b.scale(-2.0)), 0.31 - 2.0 * 0.4), Some("L1 - 2.0 * L2".into()));
        assert_eq!(text(&Polynomial::number(0.5), 0.5), None);
    }
    #[test]
    fn a_product_of_two_lengths_is_written_as_one() {
        let text = include_str!("../../../../robots/franka-panda.yaml");
        let robot = Robot::from_yaml(text, &no_files).unwrap().robot;
        let square = 0.088 * 0.088;
        assert_eq!(product_of_lengths(-square, &robot), Some("-0.088 * 0.088".into()));
        assert_eq!(product_of_lengths(0.007744, &robot), None, "not the same bits");
        assert_eq!(product_of_lengths(0.5, &robot), None);
    }
}
