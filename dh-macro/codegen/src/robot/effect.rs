//! The effects beyond the rigid body: names, keys, units, defaults. The robot file's checker, the
//! simulator and the diagnosis all read this table.
//!
//! Throughout, `v` is the joint's velocity, and a law is what is *added* to the torque of the rigid
//! model, `tau` being the torque of the actuator on the link. For a prismatic joint read N for N m,
//! and m for rad.

/// Where an effect may stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// In `drive` (or `drive.friction`) of one joint.
    Joint,
    /// Under `effects` at the top of the file.
    Robot,
    /// Either; at the top it means every joint.
    Either,
}

/// The value of a key that is not written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Magnitude {
    /// This number.
    Is(f64),
    /// This part of the joint's torque limit (of 100 N m where the file gives none).
    OfTorque(f64),
    /// As the key's words say; whoever uses it works it out.
    Derived,
    /// It must be written.
    Needed,
}

/// Values that a key may have: beyond them a law has no value, a gear locks, or a unit was
/// mistaken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Range {
    /// Least value.
    pub least: f64,
    /// Whether the least value itself is one too.
    pub with_least: bool,
    /// Largest value.
    pub most: f64,
    /// An identified value may lie below `least`, down to here: data that hardly show a size may
    /// make it negative.
    pub identified: f64,
}

impl Range {
    const ANY: Self =
        Self { least: f64::NEG_INFINITY, with_least: true, most: f64::INFINITY, identified: f64::NEG_INFINITY };

    /// Whether a value lies in it.
    #[must_use]
    pub fn holds(&self, value: f64) -> bool {
        (value > self.least || (self.with_least && value == self.least)) && value <= self.most
    }

    /// What a value must be, in words.
    fn words(&self, unit: &str) -> String {
        let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
        match (self.least == 0.0, self.with_least, self.most.is_finite()) {
            (true, true, false) => "not be negative".to_string(),
            (true, false, false) => "be greater than 0".to_string(),
            (_, true, _) => format!("be from {} to {}{unit}", self.least, self.most),
            (_, false, _) => format!("be greater than {}, and at most {}{unit}", self.least, self.most),
        }
    }
}

/// A key of an effect.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EffectKey {
    /// Its symbol; a diagnosis adds the joint's number: `FS3`.
    pub name: &'static str,
    /// Unit, empty for a plain number.
    pub unit: &'static str,
    /// The value where nothing is written about the effect but its name, `{}`.
    pub default: Magnitude,
    /// The value where other keys of the effect are written.
    pub omitted: Magnitude,
    /// A whole number, from 1.
    pub count: bool,
    /// The values it may have.
    pub range: Range,
    /// In words.
    pub doc: &'static str,
}

/// An effect of the vocabulary (contract, section 5).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Law {
    /// Its name.
    pub name: &'static str,
    /// Where it may stand.
    pub place: Place,
    /// Its keys; a bare number is the first.
    pub keys: &'static [EffectKey],
    /// Whether the keys may stand again with 2, 3, ... behind them.
    pub repeats: bool,
    /// What is added to the torque.
    pub law: &'static str,
    /// Where the default magnitudes come from.
    pub source: &'static str,
}

/// A key that makes the effect large or small: 0 where other keys are written.
const fn size(name: &'static str, unit: &'static str, default: Magnitude, doc: &'static str) -> EffectKey {
    EffectKey { name, unit, default, omitted: Magnitude::Is(0.0), count: false, range: Range::ANY, doc }
}

/// A key that shapes it: its default holds wherever it is not written.
const fn shape(name: &'static str, unit: &'static str, default: Magnitude, doc: &'static str) -> EffectKey {
    EffectKey { name, unit, default, omitted: default, count: false, range: Range::ANY, doc }
}

/// A number of a joint or link.
const fn number(name: &'static str, default: Magnitude, doc: &'static str) -> EffectKey {
    EffectKey { name, unit: "", default, omitted: default, count: true, range: Range::ANY, doc }
}

impl EffectKey {
    const fn within(mut self, least: f64, most: f64) -> Self {
        (self.range.least, self.range.most, self.range.identified) = (least, most, least);
        self
    }

    const fn above(mut self, least: f64, most: f64) -> Self {
        self.range.with_least = false;
        self.within(least, most)
    }

    /// A size that an identification may have made negative.
    const fn sized(self, most: f64, identified: f64) -> Self {
        let mut key = self.within(0.0, most);
        key.range.identified = identified;
        key
    }
}

const fn law(
    name: &'static str,
    place: Place,
    keys: &'static [EffectKey],
    law: &'static str,
    source: &'static str,
) -> Law {
    Law { name, place, keys, repeats: false, law, source }
}

use Magnitude::{Derived, Is, Needed, OfTorque};

/// Half a turn, rad: what an angle's error may be.
const HALF_TURN: f64 = core::f64::consts::PI;
/// A turn, rad.
const TURN: f64 = 2.0 * HALF_TURN;
/// The largest number below one: a gear that loses as much as it transmits is locked.
const BEFORE_ONE: f64 = 1.0 - f64::EPSILON / 2.0;

/// Ten inertial parameters without defaults of their own.
const BODY: [EffectKey; 10] = [
    size("M", "kg", Is(0.0), "mass"),
    size("MSX", "kg m", Is(0.0), "first moment"),
    size("MSY", "kg m", Is(0.0), "first moment"),
    size("MSZ", "kg m", Is(0.0), "first moment"),
    size("XX", "kg m^2", Is(0.0), "tensor about the frame's origin"),
    size("YY", "kg m^2", Is(0.0), "tensor about the frame's origin"),
    size("ZZ", "kg m^2", Is(0.0), "tensor about the frame's origin"),
    size("XY", "kg m^2", Is(0.0), "tensor about the frame's origin"),
    size("XZ", "kg m^2", Is(0.0), "tensor about the frame's origin"),
    size("YZ", "kg m^2", Is(0.0), "tensor about the frame's origin"),
];

const COULOMB: &str = "between the 0.05 to 0.5 % of the torque limit of a KUKA LWR (Katsumata et al., table II) or 0.2 to 2.3 % of a Panda (Gaz et al., RA-L 2019, table III) and the 1 to 7 % of a Staubli TX40 (figaroh)";
const VISCOUS: &str = "per rad/s between the 0.1 to 0.9 % of the torque limit of a KUKA LWR (FloBaRoID) or a Panda (Gaz et al. 2019) and the 2 to 6 % of a Staubli TX40 (figaroh) or a UR10 (Petrone et al., IEEE TII 2025)";

/// The table.
pub static LAWS: [Law; 25] = [
    law(
        "viscous_friction",
        Place::Joint,
        &[shape("FV", "N m s/rad", OfTorque(0.01), "torque per speed")],
        "FV v",
        VISCOUS,
    ),
    law("coulomb_friction", Place::Joint, &[shape("FC", "N m", OfTorque(0.01), "level")], "FC sign(v)", COULOMB),
    law(
        "asymmetric_friction",
        Place::Joint,
        &[
            size("FCA", "N m", OfTorque(0.004), "half the difference of the Coulomb levels forward and backward"),
            size("FVA", "N m s/rad", OfTorque(0.002), "half the difference of the viscous parts"),
        ],
        "FCA |sign(v)| + FVA |v|",
        "two fifths of the default symmetric part: the upper end of what the PUMA 560 has, 5 to 45 % (Corke and Armstrong-Helouvry, ICRA 1994); its viscous part is our choice",
    ),
    law(
        "stribeck_friction",
        Place::Joint,
        &[
            shape("FS", "N m", Derived, "breakaway level; default: the Coulomb level and 1 % of the torque limit")
                .sized(f64::INFINITY, f64::NEG_INFINITY),
            shape("VS", "rad/s", Is(0.05), "Stribeck velocity").above(0.0, f64::INFINITY),
            shape("DS", "", Is(2.0), "exponent").above(0.0, 20.0),
        ],
        "(FS - FC) exp(-|v / VS|^DS) sign(v), FC the joint's Coulomb level",
        "the law: Armstrong-Helouvry, Dupont and Canudas de Wit, Automatica 30 (1994). Size and velocity: order of magnitude, our choice",
    ),
    law(
        "nonlinear_viscous_friction",
        Place::Joint,
        &[
            shape("FN", "N m (s/rad)^EN", OfTorque(0.015), "torque at 1 rad/s").sized(f64::INFINITY, f64::NEG_INFINITY),
            shape("EN", "", Is(0.5), "exponent").within(0.0, 20.0),
        ],
        "FN |v|^EN sign(v)",
        "size as viscous_friction, our choice. A column sign(v) sqrt|v| and one of v^3 take 21 % off the residual of the Staubli TX40's joints 1 and 2 (our fit of figaroh's log)",
    ),
    law(
        "load_dependent_friction",
        Place::Joint,
        &[shape("FL", "", Is(0.08), "friction per transmitted torque").sized(BEFORE_ONE, -BEFORE_ONE)],
        "FL |tau_load| sign(v), tau_load the torque of the bodies that the gear transmits",
        "the law: Hamon, Gautier and Garrec, IROS 2010. Size: order of magnitude, our choice (a gear of 92 % efficiency)",
    ),
    law(
        "presliding_hysteresis",
        Place::Joint,
        &[
            shape("HC", "N m", OfTorque(0.01), "level").sized(f64::INFINITY, f64::NEG_INFINITY),
            shape("HX", "rad", Is(2e-3), "travel in which it builds up to 1 - 1/e").above(0.0, f64::INFINITY),
        ],
        "HC z, dz/dt = (v / HX)(1 - z sign(v)); in the simulator LuGre's bristle, with its damping",
        "the law: Canudas de Wit et al., IEEE TAC 40 (1995). Level as coulomb_friction, travel: our choice; at rest a KUKA iiwa 14 shows 0.05 to 0.13 % of its torque limits (Drake's static poses, our fit)",
    ),
    law(
        "friction_drift",
        Place::Either,
        &[
            size("DA", "", Is(0.5), "what cold friction has more than warm friction, as a part of the latter")
                .within(-1.0, 1e3),
            shape("DT", "s", Is(30.0), "time constant of the warming").above(0.0, f64::INFINITY),
            size("DK", "1/K", Is(0.0), "change per kelvin of the `temp` column"),
            shape("T0", "degC", Is(25.0), "temperature at which DK does nothing").within(-273.15, 1e3),
        ],
        "the joint's friction times 1 + DA exp(-t / DT) + DK (temp - T0)",
        "order of magnitude, our choice. Gears take tens of minutes to warm; the default is shorter so that a log of half a minute shows it",
    ),
    law(
        "position_dependent_friction",
        Place::Joint,
        &[
            size("PC", "N m", OfTorque(0.004), "amplitude of the cosine"),
            size("PS", "N m", OfTorque(0.003), "amplitude of the sine"),
            shape("PN", "", Is(1.0), "periods per turn of the joint").within(0.0, 1e5),
        ],
        "sign(v) (PC cos(PN q) + PS sin(PN q))",
        "the law: Armstrong-Helouvry, Control of Machines with Friction (1991), on a PUMA. Size: half of the default Coulomb level, our choice",
    ),
    law(
        "rotor_inertia",
        Place::Joint,
        &[shape("IA", "kg m^2", OfTorque(0.003), "on the link side of the gear")],
        "IA ddq",
        "three times the 0.0007 to 0.0011 kg m^2 per N m of torque limit of a Staubli TX40 (figaroh); high ratios have more",
    ),
    Law {
        name: "torque_ripple",
        place: Place::Joint,
        keys: &[
            shape("RN", "", Derived, "periods per turn of the joint; default: the gear ratio, 32 where there is none")
                .within(0.0, 1e6),
            size("RC", "N m", OfTorque(0.006), "amplitude of the cosine"),
            size("RS", "N m", OfTorque(0.003), "amplitude of the sine"),
        ],
        repeats: true,
        law: "RC cos(RN q) + RS sin(RN q)",
        source: "0.5 to 1.3 % of the torque limit on joints 4 to 6 of a Staubli TX40, at 3 orders per turn of the motor (our fit of figaroh's log); here 0.7 % in all. In harmonic drives at the motor's turn and twice: Tuttle and Seering, IEEE T-RA 12 (1996)",
    },
    law(
        "joint_elasticity",
        Place::Joint,
        &[
            shape("KE", "N m/rad", OfTorque(60.0), "stiffness").above(0.0, f64::INFINITY),
            shape("DE", "N m s/rad", Is(0.0), "damping").within(0.0, f64::INFINITY),
        ],
        "the angle that is measured is the motor's; the link's is less by tau_link / KE",
        "order of magnitude, our choice: 10 kN m/rad at 170 N m, as in the large joints of light-weight arms with harmonic drives",
    ),
    law(
        "backlash",
        Place::Joint,
        &[shape("BL", "rad", Is(1e-3), "whole width").within(0.0, 1.0)],
        "a dead zone between motor and link",
        "order of magnitude, our choice: 3.4 arc minutes, as a planetary gear has",
    ),
    law(
        "gear_coupling",
        Place::Joint,
        &[
            number("joint", Needed, "the other joint, k; m is the one that this stands at"),
            shape("KC", "", Is(1.0), "turns of the motor, on the joint's side, per turn of joint k").within(-1e3, 1e3),
            size(
                "IAM",
                "kg m^2",
                Derived,
                "rotor; default: half of what leaves the mass matrix positive definite along the motion",
            ),
            size("FVM", "N m s/rad", Derived, "viscous; default: half the geometric mean of the two joints' FV"),
            size("FCM", "N m", OfTorque(0.01), "Coulomb"),
        ],
        "motor m turns with w = dq_m + KC dq_k: on k KC (IAM ddq_m + FVM dq_m + FCM sign(w)), on m IAM KC ddq_k + FVM KC dq_k + FCM sign(w)",
        "the wrist of the Staubli TX40 (figaroh): IAM 0.0077, FVM 0.62, FCM 1.96 at 30 N m",
    ),
    law(
        "torque_gain_error",
        Place::Either,
        &[shape("GT", "", Is(0.9), "measured torque per true torque").above(0.0, 1e3)],
        "measured = GT true",
        "our choice, rather large: ten percent",
    ),
    law(
        "torque_offset",
        Place::Joint,
        &[shape("TO", "N m", OfTorque(0.01), "offset")],
        "measured = true + TO",
        "rather more than the 0.5 % of the torque limit of a KUKA LWR (FloBaRoID), 0.2 % of an iiwa 14 (Drake's logs), 0.1 to 0.8 % of a Panda (Gaz et al. 2019)",
    ),
    law(
        "torque_saturation",
        Place::Joint,
        &[shape("TM", "N m", Derived, "limit; default: 0.8 of the largest torque that the motion asks for")
            .above(0.0, f64::INFINITY)],
        "the torque that is applied is clipped to +-TM",
        "a drive's current limit",
    ),
    law(
        "encoder_offset",
        Place::Either,
        &[shape("QO", "rad", Is(0.02), "offset").within(-TURN, TURN)],
        "true angle = measured + QO",
        "our choice: a degree, as after a homing by eye",
    ),
    law(
        "geometric_error",
        Place::Either,
        &[
            size("DALPHA", "rad", Is(0.02), "of alpha").within(-HALF_TURN, HALF_TURN),
            size("DD", "m", Is(0.01), "of d").within(-10.0, 10.0),
            size("DTHETA", "rad", Is(0.0), "of theta").within(-HALF_TURN, HALF_TURN),
            size("DR", "m", Is(0.0), "of r").within(-10.0, 10.0),
        ],
        "true row of the DH table = given row + these",
        "our choice: a mistaken drawing; what calibration finds in built arms is smaller",
    ),
    law(
        "link_inertia_error",
        Place::Either,
        &[
            number("link", Derived, "the link; default: that of the joint that this stands at"),
            BODY[0],
            BODY[1],
            BODY[2],
            BODY[3],
            BODY[4],
            BODY[5],
            BODY[6],
            BODY[7],
            BODY[8],
            BODY[9],
        ],
        "true parameters of the link = given + these; of `{}` a fifth of the given",
        "our choice: CAD is off by 0 to 70 % of a parameter in Katsumata et al., table II",
    ),
    law(
        "payload",
        Place::Robot,
        &[
            size("M", "kg", Is(1.0), "mass"),
            size("MSX", "kg m", Is(0.02), "first moment"),
            size("MSY", "kg m", Is(0.0), "first moment"),
            size("MSZ", "kg m", Is(0.1), "first moment"),
            size("XX", "kg m^2", Is(0.0125), "tensor about the frame's origin"),
            size("YY", "kg m^2", Is(0.0129), "tensor about the frame's origin"),
            size("ZZ", "kg m^2", Is(0.0029), "tensor about the frame's origin"),
            size("XY", "kg m^2", Is(0.0), "tensor about the frame's origin"),
            size("XZ", "kg m^2", Is(-0.002), "tensor about the frame's origin"),
            size("YZ", "kg m^2", Is(0.0), "tensor about the frame's origin"),
        ],
        "a body fixed in the last frame; of `M` alone a point mass",
        "our choice, a gripper: 1 kg, a sphere of 0.08 m whose centre is 0.1 m out and 0.02 m aside",
    ),
    law(
        "base_tilt",
        Place::Robot,
        &[
            size("roll", "rad", Is(0.02), "about x").within(-HALF_TURN, HALF_TURN),
            size("pitch", "rad", Is(0.02), "about y").within(-HALF_TURN, HALF_TURN),
        ],
        "true base = given base turned by RotY(pitch) RotX(roll)",
        "our choice: a degree, as on a cart or an uneven floor",
    ),
    law(
        "joint_spring",
        Place::Joint,
        &[
            shape("KS", "N m/rad", OfTorque(0.05), "stiffness"),
            shape("QS", "rad", Is(0.0), "angle without torque").within(-1e3, 1e3),
        ],
        "KS (q - QS)",
        "our choice: cables and hoses, some N m over the travel of an industrial wrist",
    ),
    law(
        "external_contact",
        Place::Robot,
        &[
            shape("start", "s", Derived, "begin; default: a third of the motion"),
            shape("end", "s", Derived, "end; default: two thirds of the motion"),
            size("fx", "N", Is(10.0), "force on the tool, tool frame"),
            size("fy", "N", Is(10.0), "force"),
            size("fz", "N", Is(-10.0), "force"),
            size("mx", "N m", Is(0.0), "moment"),
            size("my", "N m", Is(0.0), "moment"),
            size("mz", "N m", Is(0.0), "moment"),
        ],
        "-J' (wrench on the tool) during the window",
        "our choice: a light push of the hand, 17 N",
    ),
    law(
        "time_delay",
        Place::Either,
        &[shape("TD", "s", Is(0.005), "how late the torque is").within(-10.0, 10.0)],
        "the torque sample at t belongs to the motion at t - TD",
        "our choice: some cycles of a field bus. The torques of the iiwa 14 in Drake's logs are 40 ms late",
    ),
];

impl Law {
    /// The effect of this name.
    pub fn of(name: &str) -> Option<&'static Self> {
        LAWS.iter().find(|law| law.name == name)
    }

    /// What a key's value must be where it is not: the same for robot files, files of effects and
    /// the simulator.
    pub fn must(&self, key: &str, value: f64) -> Option<String> {
        let key = self.key(key)?;
        let words = || match key.name {
            "FL" => "be from 0 to less than 1: beyond, the gear locks".to_string(),
            _ => key.range.words(key.unit),
        };
        (!key.range.holds(value)).then(words)
    }

    /// Whether an identification may have made a value beyond its range.
    pub fn may_be_identified(&self, key: &str, value: f64) -> bool {
        self.key(key).is_some_and(|key| value >= key.range.identified && value <= key.range.most)
    }

    /// The key of this name; of `RN2` the key `RN` where keys repeat.
    pub fn key(&self, name: &str) -> Option<&'static EffectKey> {
        let exact = self.keys.iter().find(|key| key.name == name);
        let again = || {
            let stem = name.trim_end_matches(|c: char| c.is_ascii_digit());
            let number: usize = name[stem.len()..].parse().ok()?;
            let fits = self.repeats && (2..=9).contains(&number);
            self.keys.iter().find(|key| fits && key.name == stem)
        };
        exact.or_else(again)
    }
}

#[cfg(test)]
mod tests {
    use super::super::EFFECT_NAMES;
    use super::*;

    #[test]
    fn the_table_is_the_vocabulary() {
        assert_eq!(LAWS.map(|law| law.name), EFFECT_NAMES);
        for law in &LAWS {
            assert!(!law.keys.is_empty() && !law.source.is_empty() && !law.law.is_empty(), "{}", law.name);
        }
        let ripple = Law::of("torque_ripple").unwrap();
        assert_eq!(ripple.key("RC3").unwrap().name, "RC");
        assert!(ripple.key("RC1").is_none() && ripple.key("RX").is_none());
        assert!(Law::of("backlash").unwrap().key("BL2").is_none());
    }
}
