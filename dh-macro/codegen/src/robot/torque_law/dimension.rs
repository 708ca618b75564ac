//! Units of expressions, as far as they are known: a number may have any unit, a variable has its
//! own.

/// Powers of m, s and K; an angle has none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Powers([f64; 3]);

/// Known part of an expression's unit; `None`: a number in it takes the unit that is required.
pub(super) type Dimension = Option<Powers>;

impl Powers {
    /// Dimension of a plain number, or an angle.
    pub const NONE: Self = Self([0.0; 3]);
    pub const TIME: Self = Self([0.0, 1.0, 0.0]);
    pub const TEMPERATURE: Self = Self([0.0, 0.0, 1.0]);

    /// Dimension of a joint's position, differentiated `times` times.
    pub fn motion(slides: bool, times: u8) -> Self {
        Self([f64::from(u8::from(slides)), -f64::from(times), 0.0])
    }

    pub fn times(self, other: Self) -> Self {
        Self([0, 1, 2].map(|k| self.0[k] + other.0[k]))
    }

    pub fn raised(self, by: f64) -> Self {
        Self(self.0.map(|power| power * by))
    }

    /// Unit as text: `m/s`, `rad/s`, `K`.
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
