//! Units of expressions, as far as they can be known: a number may stand for any unit, a variable
//! has its own.

/// Powers of m, s and K; an angle has none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Powers([f64; 3]);

/// What is known about the unit of an expression; `None`: a number in it takes what is needed.
pub(super) type Dimension = Option<Powers>;

impl Powers {
    /// A plain number, or an angle.
    pub const NONE: Self = Self([0.0; 3]);
    pub const TIME: Self = Self([0.0, 1.0, 0.0]);
    pub const TEMPERATURE: Self = Self([0.0, 0.0, 1.0]);

    /// Of the position of a joint, differentiated so often.
    pub fn motion(slides: bool, times: u8) -> Self {
        Self([f64::from(u8::from(slides)), -f64::from(times), 0.0])
    }

    pub fn times(self, other: Self) -> Self {
        Self([0, 1, 2].map(|k| self.0[k] + other.0[k]))
    }

    pub fn raised(self, by: f64) -> Self {
        Self(self.0.map(|power| power * by))
    }

    /// `m/s`, `rad/s`, `K`.
    pub fn words(self) -> String {
        let units = || self.0.iter().zip(["m", "s", "K"]).filter(|(power, _)| **power != 0.0);
        let one = |(power, unit): (&f64, &str)| match power.abs() {
            1.0 => unit.to_string(),
            power => format!("{unit}^{power}"),
        };
        let above: Vec<String> = units().filter(|(power, _)| **power > 0.0).map(one).collect();
        let below: String = units().filter(|(power, _)| **power < 0.0).map(|unit| format!("/{}", one(unit))).collect();
        match above.is_empty() {
            true => format!("rad{below}"),
            false => above.join(" ") + &below,
        }
    }
}
