//! Description of an effect's type: keys with units, defaults and ranges.

/// Places in a file where an effect is allowed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scope {
    /// In `drive` (or `drive.friction`) of one joint.
    Joint,
    /// In `drive` of one joint, or under `effects` at the top of the file: then at every joint.
    EveryJoint,
    /// In `drive` of one joint, for its link, or under `effects` at the top of the file with the
    /// number of the link.
    Link,
    /// Under `effects` at the top of the file.
    Robot,
}

impl Scope {
    /// Whether it is allowed at a joint.
    #[must_use]
    pub fn at_joint(self) -> bool {
        self != Self::Robot
    }

    /// Whether it is allowed at the top of the file.
    #[must_use]
    pub fn at_top(self) -> bool {
        self != Self::Joint
    }
}

/// Value of a key that is not stated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Magnitude {
    /// A fixed number.
    Is(f64),
    /// A share of the joint's torque limit (of [`RATED`](crate::robot::RATED) if the file gives
    /// none).
    OfTorque(f64),
    /// A value that depends on the robot or the motion, as the key's documentation states.
    Derived,
    /// No default: the key is required.
    Needed,
}

/// Admissible values of a key. Outside, a law has no value, a gear locks, or the unit is wrong.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Smallest value.
    pub least: f64,
    /// Whether the smallest value belongs to the range.
    pub with_least: bool,
    /// Largest value.
    pub most: f64,
    /// Whether the largest value belongs to the range.
    pub with_most: bool,
    /// Lower limit for identified values, which may lie below `least`: data that hardly determine a
    /// size may make it negative.
    pub identified: f64,
    /// Consequence of a value outside, for messages; empty if obvious.
    pub beyond: &'static str,
}

impl Range {
    /// Any finite number.
    pub const ANY: Self = Self::within(f64::NEG_INFINITY, f64::INFINITY);
    /// A size: not negative, unless identified.
    pub const SIZE: Self = Self { identified: f64::NEG_INFINITY, ..Self::within(0.0, f64::INFINITY) };
    /// From 0.
    pub const NOT_NEGATIVE: Self = Self::within(0.0, f64::INFINITY);
    /// Above 0.
    pub const POSITIVE: Self = Self::above(0.0, f64::INFINITY);
    /// Angle error of at most half a turn, rad.
    pub const HALF_TURN: Self = Self::within(-core::f64::consts::PI, core::f64::consts::PI);

    /// From `least` to `most`, both included.
    #[must_use]
    pub const fn within(least: f64, most: f64) -> Self {
        Self { least, with_least: true, most, with_most: true, identified: least, beyond: "" }
    }

    /// Above `least`, up to `most`.
    #[must_use]
    pub const fn above(least: f64, most: f64) -> Self {
        Self { with_least: false, ..Self::within(least, most) }
    }

    /// Whether a value lies in the range.
    #[must_use]
    pub fn holds(&self, value: f64) -> bool {
        let above = value > self.least || (self.with_least && value == self.least);
        above && (value < self.most || (self.with_most && value == self.most)) && value.is_finite()
    }

    /// Whether an identification may give this value.
    #[must_use]
    pub fn may_be_identified(&self, value: f64) -> bool {
        self.holds(value) || (value > self.identified && value < self.least)
    }

    /// Condition on a value, in words.
    #[must_use]
    pub fn words(&self, unit: &str) -> String {
        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        let beyond = if self.beyond.is_empty() { String::new() } else { format!(": {}", self.beyond) };
        let words = match (self.least, self.with_least, self.most, self.with_most) {
            (f64::NEG_INFINITY, _, f64::INFINITY, _) => "be a finite number".to_string(),
            (0.0, true, f64::INFINITY, _) => "not be negative".to_string(),
            (0.0, false, f64::INFINITY, _) => "be greater than 0".to_string(),
            (least, true, most, true) => format!("be from {least} to {most}{unit}"),
            (least, true, most, false) => format!("be from {least} to less than {most}{unit}"),
            (least, false, most, true) => format!("be greater than {least}, and at most {most}{unit}"),
            (least, false, most, false) => format!("be greater than {least}, and less than {most}{unit}"),
        };
        words + &beyond
    }
}

/// Symbol of an effect's key in files and diagnoses. Only the files of the effects create keys, so
/// a misspelt key does not compile.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Key(&'static str);

impl Key {
    pub(super) const fn new(name: &'static str) -> Self {
        Self(name)
    }

    /// Text of the key in a file.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.0
    }
}

impl AsRef<str> for Key {
    fn as_ref(&self) -> &str {
        self.0
    }
}

impl core::fmt::Display for Key {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.write_str(self.0)
    }
}

/// A key of an effect.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EffectKey {
    /// Symbol of the key; a diagnosis adds the joint's number: `FS3`.
    pub name: &'static str,
    /// Unit, empty for a plain number. For a prismatic joint read N for N m, and m for rad.
    pub unit: &'static str,
    /// Value if only the effect's name is stated, `{}`.
    pub default: Magnitude,
    /// Value if other keys of the effect are stated.
    pub omitted: Magnitude,
    /// Whether it is the number of a joint or link, from 1.
    pub count: bool,
    /// Admissible values.
    pub range: Range,
    /// Description in words.
    pub doc: &'static str,
}

/// Description of an effect's type as data, for reading, checking and documenting all effects.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Description {
    /// Name in files and diagnoses.
    pub name: &'static str,
    /// Description in one sentence.
    pub sentence: &'static str,
    /// Allowed places.
    pub scope: Scope,
    /// Keys of the effect; a bare number is the value of the first.
    pub keys: &'static [EffectKey],
    /// How often the keys may be stated: repeated with 2, 3, ... appended.
    pub repeats: usize,
    /// Torque added to that of the rigid model (of the actuator on the link); `v` is the joint's
    /// velocity.
    pub law: &'static str,
    /// Source of the default magnitudes.
    pub source: &'static str,
}

impl Description {
    /// Key with this name; for `RN2` the key `RN` if keys repeat.
    #[must_use]
    pub fn key(&self, name: &str) -> Option<&'static EffectKey> {
        self.place(name).map(|(key, _)| &self.keys[key])
    }

    /// Index of a key, and its number: 2 for `RN2`, 1 for `RN`.
    pub(super) fn place(&self, name: &str) -> Option<(usize, usize)> {
        let index = |name: &str| self.keys.iter().position(|key| key.name == name);
        if let Some(key) = index(name) {
            return Some((key, 1));
        }
        let stem = name.trim_end_matches(|c: char| c.is_ascii_digit());
        let digits = &name[stem.len()..];
        let number: usize = digits.parse().ok().filter(|_| !digits.starts_with('0'))?;
        let key = index(stem)?;
        (2..=self.repeats).contains(&number).then_some((key, number))
    }

    /// Keys with units as text: `FS (N m), VS (rad/s), DS`.
    pub(crate) fn keys_in_words(&self) -> String {
        let with_unit = |key: &EffectKey| match key.unit {
            "" => key.name.to_string(),
            unit => format!("{} ({unit})", key.name),
        };
        self.keys.iter().map(with_unit).collect::<Vec<_>>().join(", ")
    }
}

/// An effect's type: its description, and access to its fields by key.
pub(super) trait Keys: Default {
    /// Description of the type.
    const DESCRIPTION: Description;

    /// Stated value of a key (index into the description's) with this number, from 1.
    fn stated(&self, key: usize, number: usize) -> Option<f64>;

    /// Sets a value; `false` if the field can't hold it.
    fn state(&mut self, key: usize, number: usize, value: f64) -> bool;

    /// Number of times the keys are stated.
    fn numbers(&self) -> usize {
        1
    }
}

/// A field of an effect.
pub(super) trait Field {
    fn stated(&self) -> Option<f64>;
    fn state(&mut self, value: f64) -> bool;
}

impl Field for Option<f64> {
    fn stated(&self) -> Option<f64> {
        *self
    }

    fn state(&mut self, value: f64) -> bool {
        *self = Some(value);
        true
    }
}

/// The number of a joint or link, from 1.
fn number(value: f64) -> Option<usize> {
    (value.fract() == 0.0 && (1.0..=1e6).contains(&value)).then_some(value as usize)
}

impl Field for Option<usize> {
    fn stated(&self) -> Option<f64> {
        self.map(|number| number as f64)
    }

    fn state(&mut self, value: f64) -> bool {
        *self = number(value);
        self.is_some()
    }
}

/// A required number; 0 until it is stated.
impl Field for usize {
    fn stated(&self) -> Option<f64> {
        (*self > 0).then_some(*self as f64)
    }

    fn state(&mut self, value: f64) -> bool {
        *self = number(value).unwrap_or(0);
        *self > 0
    }
}

/// Defines an effect's type and its table of keys at once.
///
/// Each row is a field and a constant for its key: `field = KEY ["unit"] default, range, "words";`,
/// with `[]` for a plain number, and `KEY as "key"` for a lower-case key. The default is
///
/// - `always 0.05`: whenever the key is not stated,
/// - `alone 0.05`: if only the effect's name is stated; otherwise 0,
/// - either of these `* torque`: multiplied by the joint's torque limit,
/// - `by_hand 0.05`: like `alone`, by a method written beside the table,
/// - `derived`: computed by the user from the robot or the motion; `derived_alone`: otherwise 0,
/// - `link`, `joint`: the number of a link, which is optional, or of a joint, which is required.
///
/// A field holds the value stated in the file. The method of its name returns it or the default.
macro_rules! effect {
    (
        #[doc = $sentence:literal]
        $Type:ident = $name:literal, $scope:expr;
        law: $law:literal;
        source: $source:expr;
        $($field:ident = $KEY:ident $(as $key:literal)? [$($unit:literal)?] $when:ident $($value:literal $(* $torque:ident)?)?,
            $range:expr, $doc:literal;)+
    ) => {
        #[doc = $sentence]
        #[derive(Debug, Clone, Copy, Default, PartialEq)]
        pub struct $Type {
            $(
                #[doc = concat!("`", effect!(@name $KEY $($key)?), "`" $(, ", ", $unit)?, ": ", $doc, ".")]
                pub $field: effect!(@type $when),
            )+
        }

        impl $Type {
            /// Its name in files and diagnoses.
            pub const NAME: &'static str = $name;

            $(
                #[doc = concat!("Key of `", stringify!($field), "`: ", $doc, ".")]
                pub const $KEY: $crate::robot::effects::Key =
                    $crate::robot::effects::Key::new(effect!(@name $KEY $($key)?));
            )+

            /// Whether nothing but the name is written.
            #[must_use]
            pub fn is_bare(&self) -> bool {
                [$($crate::robot::effects::key::Field::stated(&self.$field)),+].iter().all(Option::is_none)
            }

            $(effect!(@value $field [$KEY $($key)?] $when $($value $(* $torque)?)?);)+
        }

        impl $crate::robot::effects::key::Keys for $Type {
            const DESCRIPTION: $crate::robot::effects::Description = $crate::robot::effects::Description {
                name: $name,
                sentence: $sentence,
                scope: $scope,
                keys: &[$($crate::robot::effects::EffectKey {
                    name: Self::$KEY.name(),
                    unit: concat!($($unit)?),
                    default: effect!(@default $when $($value $(* $torque)?)?),
                    omitted: effect!(@omitted $when $($value $(* $torque)?)?),
                    count: effect!(@count $when),
                    range: $range,
                    doc: $doc,
                }),+],
                repeats: 1,
                law: $law,
                source: $source,
            };

            fn stated(&self, key: usize, _number: usize) -> Option<f64> {
                let fields = [$($crate::robot::effects::key::Field::stated(&self.$field)),+];
                fields.get(key).copied().flatten()
            }

            fn state(&mut self, key: usize, _number: usize, value: f64) -> bool {
                let mut fields = [$(&mut self.$field as &mut dyn $crate::robot::effects::key::Field),+];
                fields.get_mut(key).is_some_and(|field| field.state(value))
            }
        }
    };

    (@name $KEY:ident) => { stringify!($KEY) };
    (@name $KEY:ident $key:literal) => { $key };

    (@type joint) => { usize };
    (@type link) => { Option<usize> };
    (@type $when:ident) => { Option<f64> };

    (@count joint) => { true };
    (@count link) => { true };
    (@count $when:ident) => { false };

    (@default joint) => { $crate::robot::effects::Magnitude::Needed };
    (@default $when:ident $value:literal * torque) => { $crate::robot::effects::Magnitude::OfTorque($value) };
    (@default $when:ident $value:literal) => { $crate::robot::effects::Magnitude::Is($value) };
    (@default $when:ident) => { $crate::robot::effects::Magnitude::Derived };

    (@omitted alone $($rest:tt)*) => { $crate::robot::effects::Magnitude::Is(0.0) };
    (@omitted by_hand $($rest:tt)*) => { $crate::robot::effects::Magnitude::Is(0.0) };
    (@omitted derived_alone) => { $crate::robot::effects::Magnitude::Is(0.0) };
    (@omitted $($rest:tt)*) => { effect!(@default $($rest)*) };

    (@value $field:ident [$($key:tt)+] always $value:literal) => {
        #[doc = concat!("`", effect!(@name $($key)+), "`, or its default.")]
        #[must_use]
        pub fn $field(&self) -> f64 {
            self.$field.unwrap_or($value)
        }
    };
    (@value $field:ident [$($key:tt)+] always $value:literal * torque) => {
        #[doc = concat!("`", effect!(@name $($key)+), "`, or its default at a joint with this torque limit, N m.")]
        #[must_use]
        pub fn $field(&self, rated: f64) -> f64 {
            self.$field.unwrap_or($value * rated)
        }
    };
    (@value $field:ident [$($key:tt)+] alone $value:literal) => {
        #[doc = concat!("`", effect!(@name $($key)+), "`, or its default.")]
        #[must_use]
        pub fn $field(&self) -> f64 {
            self.$field.unwrap_or(if self.is_bare() { $value } else { 0.0 })
        }
    };
    (@value $field:ident [$($key:tt)+] alone $value:literal * torque) => {
        #[doc = concat!("`", effect!(@name $($key)+), "`, or its default at a joint with this torque limit, N m.")]
        #[must_use]
        pub fn $field(&self, rated: f64) -> f64 {
            self.$field.unwrap_or(if self.is_bare() { $value * rated } else { 0.0 })
        }
    };
    (@value $($rest:tt)*) => {};
}

pub(super) use effect;
