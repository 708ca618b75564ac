//! Effect `torque_ripple`: `RC cos(RN q) + RS sin(RN q)`, in several orders.

use super::key::{Description, EffectKey, Field, Key, Keys, Magnitude, Range, Scope};

/// Torque that is periodic in the angle of the joint or motor: cogging, orders of the gear's mesh.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TorqueRipple {
    /// Orders: the keys without a number, those with 2 appended, and so on. An order without
    /// amplitudes is ignored, except the first.
    pub orders: Vec<RippleOrder>,
}

/// One order of a ripple.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct RippleOrder {
    /// `RN`: periods per turn of the joint.
    pub periods: Option<f64>,
    /// `RC`, N m: amplitude of the cosine.
    pub cosine: Option<f64>,
    /// `RS`, N m: amplitude of the sine.
    pub sine: Option<f64>,
}

impl RippleOrder {
    fn fields(&self) -> [Option<f64>; 3] {
        [self.periods, self.cosine, self.sine]
    }
}

/// Periods per turn if the robot file has no gear ratio: a compact planetary gear or a pole count.
const PERIODS: f64 = 32.0;

/// Default amplitudes of cosine and sine, as shares of the torque limit.
const AMPLITUDE: [f64; 2] = [0.006, 0.003];

/// Most orders that a file can state.
const ORDERS: usize = 9;

impl TorqueRipple {
    /// Name in files and diagnoses.
    pub const NAME: &'static str = "torque_ripple";

    /// Key of `periods`: periods per turn of the joint.
    pub const RN: Key = Key::new("RN");

    /// Key of `cosine`: amplitude of the cosine.
    pub const RC: Key = Key::new("RC");

    /// Key of `sine`: amplitude of the sine.
    pub const RS: Key = Key::new("RS");

    /// Ripple of one order.
    #[must_use]
    pub fn of(periods: f64, cosine: f64, sine: f64) -> Self {
        let order = RippleOrder { periods: Some(periods), cosine: Some(cosine), sine: Some(sine) };
        Self { orders: vec![order] }
    }

    /// Whether only the name is stated.
    #[must_use]
    pub fn is_bare(&self) -> bool {
        self.orders.iter().flat_map(RippleOrder::fields).all(|value| value.is_none())
    }

    /// Periods per turn and amplitudes of cosine and sine, N m, of each order, at a joint with this
    /// torque limit, N m, and gear ratio.
    #[must_use]
    pub fn waves(&self, rated: f64, gear_ratio: Option<f64>) -> Vec<[f64; 3]> {
        let first = self.orders.first().copied().unwrap_or_default();
        let periods = first.periods.unwrap_or(gear_ratio.map_or(PERIODS, f64::abs));
        let [cosine, sine] = AMPLITUDE.map(|part| if self.is_bare() { part * rated } else { 0.0 });
        let first = [periods, first.cosine.unwrap_or(cosine), first.sine.unwrap_or(sine)];
        let further = self.orders.iter().enumerate().skip(1).filter_map(|(k, order)| {
            let acts = order.cosine.is_some() || order.sine.is_some();
            let periods = order.periods.unwrap_or((k + 1) as f64 * periods);
            acts.then(|| [periods, order.cosine.unwrap_or(0.0), order.sine.unwrap_or(0.0)])
        });
        core::iter::once(first).chain(further).collect()
    }

    /// Appends the orders of another ripple of the same joint, up to the number that a file can
    /// state.
    pub fn extend(&mut self, other: Self) {
        self.orders.extend(other.orders);
        self.orders.truncate(ORDERS);
    }
}

impl Keys for TorqueRipple {
    const DESCRIPTION: Description = Description {
        name: Self::NAME,
        sentence: "Torque that is periodic in the angle of the joint or motor: cogging, orders of the gear's mesh.",
        scope: Scope::Joint,
        keys: &[
            EffectKey {
                name: Self::RN.name(),
                unit: "",
                default: Magnitude::Derived,
                omitted: Magnitude::Derived,
                count: false,
                range: Range::within(0.0, 1e6),
                doc: "periods per turn of the joint; default: the gear ratio, 32 where there is none",
            },
            amplitude(Self::RC, AMPLITUDE[0], "amplitude of the cosine"),
            amplitude(Self::RS, AMPLITUDE[1], "amplitude of the sine"),
        ],
        repeats: ORDERS,
        law: "RC cos(RN q) + RS sin(RN q)",
        source: "0.5 to 1.3 % of the torque limit on joints 4 to 6 of a Staubli TX40, at 3 orders per turn of the motor (our fit of figaroh's log); here 0.7 % in all. In harmonic drives at the motor's turn and twice: Tuttle and Seering, IEEE T-RA 12 (1996)",
    };

    fn stated(&self, key: usize, number: usize) -> Option<f64> {
        self.orders.get(number.checked_sub(1)?)?.fields().get(key).copied().flatten()
    }

    fn state(&mut self, key: usize, number: usize, value: f64) -> bool {
        if self.orders.len() < number {
            self.orders.resize(number, RippleOrder::default());
        }
        let order = number.checked_sub(1).and_then(|k| self.orders.get_mut(k));
        let field = order.and_then(|order| match key {
            0 => Some(&mut order.periods),
            1 => Some(&mut order.cosine),
            2 => Some(&mut order.sine),
            _ => None,
        });
        field.is_some_and(|field| field.state(value))
    }

    fn numbers(&self) -> usize {
        self.orders.len()
    }
}

const fn amplitude(key: Key, part: f64, doc: &'static str) -> EffectKey {
    EffectKey {
        name: key.name(),
        unit: "N m",
        default: Magnitude::OfTorque(part),
        omitted: Magnitude::Is(0.0),
        count: false,
        range: Range::ANY,
        doc,
    }
}
