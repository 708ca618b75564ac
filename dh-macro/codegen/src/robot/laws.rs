//! What the file says of each joint's drive beyond the rigid body, as numbers with their defaults
//! resolved; keys and laws are those of [`super::effect::LAWS`].

use super::{Effect, Given, JointKind, NoLink, Robot};

/// `(FS - FC) exp(-|v / VS|^DS) sign(v)`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stribeck {
    /// `FS`, N m; `None`: 1 % of the torque limit above the Coulomb level.
    pub breakaway: Option<f64>,
    /// `VS`, rad/s.
    pub velocity: f64,
    /// `DS`.
    pub exponent: f64,
}

/// Friction that changes with time and temperature: a factor `1 + DA exp(-t / DT) + DK (temp -
/// T0)`, not less than 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drift {
    /// `DA`.
    pub cold: f64,
    /// `DT`, s.
    pub time: f64,
    /// `DK`, 1/K.
    pub per_kelvin: f64,
    /// `T0`, degrees C.
    pub reference: f64,
}

/// A motor that turns with another joint, `w = dq_m + KC dq_k`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coupling {
    /// The other joint, k: degree of freedom, from 0.
    pub other: usize,
    /// `KC`.
    pub ratio: f64,
    /// `IAM`, kg m^2.
    pub rotor: f64,
    /// `FVM`, N m s/rad.
    pub viscous: f64,
    /// `FCM`, N m.
    pub coulomb: f64,
}

/// The drive of one degree of freedom beyond rotor, `FV`, `FC` and `FO`.
#[derive(Debug, Clone, PartialEq)]
pub struct Laws {
    /// Torque limit, N m; 100 where the file gives none.
    pub rated: f64,
    /// `FCA`, `FVA`.
    pub asymmetric: [f64; 2],
    /// `stribeck_friction`.
    pub stribeck: Option<Stribeck>,
    /// `FN`, `EN`.
    pub nonlinear: Option<[f64; 2]>,
    /// `FL`.
    pub load: f64,
    /// `HC`, `HX`.
    pub hysteresis: Option<[f64; 2]>,
    /// `friction_drift`.
    pub drift: Option<Drift>,
    /// `PC`, `PS`, `PN`.
    pub position: Option<[f64; 3]>,
    /// `RN`, `RC`, `RS` of each order.
    pub ripple: Vec<[f64; 3]>,
    /// `KE`, N m/rad.
    pub stiffness: Option<f64>,
    /// `DE`, N m s/rad.
    pub damping: f64,
    /// `BL`, rad.
    pub backlash: f64,
    /// `KS`, `QS`.
    pub spring: Option<[f64; 2]>,
    /// Where this joint's motor turns with others.
    pub couplings: Vec<Coupling>,
    /// `TM`, N m.
    pub limit: Option<f64>,
    /// `GT`.
    pub gain: f64,
    /// `TO`, N m.
    pub offset: f64,
    /// `QO`, rad.
    pub encoder_offset: f64,
    /// `TD`, s.
    pub delay: f64,
}

impl Laws {
    /// A drive without any.
    pub fn none(rated: f64) -> Self {
        Self {
            rated,
            asymmetric: [0.0; 2],
            stribeck: None,
            nonlinear: None,
            load: 0.0,
            hysteresis: None,
            drift: None,
            position: None,
            ripple: Vec::new(),
            stiffness: None,
            damping: 0.0,
            backlash: 0.0,
            spring: None,
            couplings: Vec::new(),
            limit: None,
            gain: 1.0,
            offset: 0.0,
            encoder_offset: 0.0,
            delay: 0.0,
        }
    }

    /// Whether motor and link can move against each other.
    pub fn is_soft(&self) -> bool {
        self.stiffness.is_some() || self.backlash != 0.0
    }

    /// Whether its torque depends on more than the present state.
    pub fn remembers(&self) -> bool {
        self.hysteresis.is_some() || self.drift.is_some() || self.stiffness.is_some()
    }

    fn take(&mut self, robot: &Robot, row: usize, effect: &Effect) {
        let joint = &robot.joints[row];
        let given = Given::new(effect, joint.limits.torque);
        let of = |key: &str| given.get(key);
        match effect.name.as_str() {
            "asymmetric_friction" => self.asymmetric = ["FCA", "FVA"].map(of),
            "stribeck_friction" => {
                self.stribeck =
                    Some(Stribeck { breakaway: given.stated("FS"), velocity: of("VS"), exponent: of("DS") });
            }
            "nonlinear_viscous_friction" => self.nonlinear = Some(["FN", "EN"].map(of)),
            "load_dependent_friction" => self.load = of("FL"),
            "presliding_hysteresis" => self.hysteresis = Some(["HC", "HX"].map(of)),
            "friction_drift" => {
                let [cold, time, per_kelvin, reference] = ["DA", "DT", "DK", "T0"].map(of);
                self.drift = Some(Drift { cold, time, per_kelvin, reference });
            }
            "position_dependent_friction" => self.position = Some(["PC", "PS", "PN"].map(of)),
            "torque_ripple" => self.ripple.extend(ripple(&given, joint.drive.gear_ratio)),
            "joint_elasticity" => (self.stiffness, self.damping) = (Some(of("KE")), of("DE")),
            "backlash" => self.backlash = of("BL"),
            "gear_coupling" => self.couplings.extend(coupling(robot, row, &given)),
            "torque_gain_error" => self.gain *= of("GT"),
            "torque_offset" => self.offset += of("TO"),
            "torque_saturation" => self.limit = given.stated("TM"),
            "encoder_offset" => self.encoder_offset += of("QO"),
            "joint_spring" => self.spring = Some(["KS", "QS"].map(of)),
            "time_delay" => self.delay += of("TD"),
            _ => {} // bodies and geometry: see `Robot::as_it_is`; what belongs to one recording: none of a drive's
        }
    }
}

/// Orders of a ripple where the robot file has no gear ratio.
const ORDER: f64 = 32.0;

fn ripple(given: &Given<'_>, gear_ratio: Option<f64>) -> Vec<[f64; 3]> {
    let order = given.stated("RN").unwrap_or(gear_ratio.map_or(ORDER, f64::abs));
    let first = [order, given.get("RC"), given.get("RS")];
    let further = (2..=9).filter_map(|k| {
        let [n, c, s] = ["RN", "RC", "RS"].map(|key| given.stated(&format!("{key}{k}")));
        (c.is_some() || s.is_some()).then(|| [n.unwrap_or(f64::from(k) * order), c.unwrap_or(0.0), s.unwrap_or(0.0)])
    });
    core::iter::once(first).chain(further).collect()
}

/// `None` where the other joint is none. Sizes that depend on a motion (`IAM` where nothing is
/// written) are 0.
fn coupling(robot: &Robot, row: usize, given: &Given<'_>) -> Option<Coupling> {
    let moving = robot.moving();
    let other = (given.stated("joint")? as usize).checked_sub(1).filter(|&k| k != row)?;
    let dof = moving.iter().position(|&r| r == other)?;
    let bare = given.stated("IAM").is_none() && given.stated("FVM").is_none() && given.stated("FCM").is_none();
    let viscous = |row: usize| robot.joints[row].drive.viscous_friction.unwrap_or(0.0);
    let mean = 0.5 * (viscous(row) * viscous(other)).max(0.0).sqrt();
    Some(Coupling {
        other: dof,
        ratio: given.get("KC"),
        rotor: given.stated("IAM").unwrap_or(0.0),
        viscous: given.stated("FVM").unwrap_or(if bare { mean } else { 0.0 }),
        coulomb: given.stated("FCM").unwrap_or(if bare { 0.01 * given.rated } else { 0.0 }),
    })
}

/// Effects that mean every joint where they stand at the top.
const EVERY_JOINT: [&str; 5] =
    ["friction_drift", "torque_gain_error", "encoder_offset", "geometric_error", "time_delay"];

impl Robot {
    /// Effects with their row: those of joints first, then those at the top that mean every joint.
    pub(super) fn effects_by_row(&self) -> impl Iterator<Item = (usize, &Effect)> {
        let own = self.joints.iter().enumerate().flat_map(|(row, j)| j.drive.effects.iter().map(move |e| (row, e)));
        let top = self.effects.iter().filter(|e| EVERY_JOINT.contains(&e.name.as_str()));
        own.chain(top.flat_map(|e| (0..self.joints.len()).map(move |row| (row, e))))
    }

    /// Of each degree of freedom: the effects of its drive.
    pub fn laws(&self) -> Vec<Laws> {
        let moving = self.moving();
        let mut laws: Vec<Laws> =
            moving.iter().map(|&row| Laws::none(self.joints[row].limits.torque.unwrap_or(super::RATED))).collect();
        for (row, effect) in self.effects_by_row() {
            if let Some(k) = moving.iter().position(|&r| r == row) {
                laws[k].take(self, row, effect);
            }
        }
        laws
    }

    /// Whether any effect changes what the arm's functions compute.
    pub fn has_effects(&self) -> bool {
        let counts = |name: &str| name != "external_contact";
        self.joints.iter().flat_map(|j| &j.drive.effects).chain(&self.effects).any(|e| counts(&e.name))
    }

    /// The arm as its effects of geometry and bodies say that it is: zeros of joints, rows of the
    /// table, base, links. Drives stay.
    #[must_use]
    pub fn as_it_is(&self) -> Self {
        super::real::as_it_is(self)
    }

    /// Makes row, link or base the true one, as one effect of geometry or bodies says that it is:
    /// `geometric_error`, `link_inertia_error` (at the joint of `row`, or of the whole robot),
    /// `base_tilt`, `payload`. Any other effect changes nothing.
    ///
    /// # Errors
    /// Where the effect means a link that is not there, or whose parameters are not known.
    pub fn change(&mut self, row: Option<usize>, effect: &Effect) -> Result<(), NoLink> {
        super::real::change(self, row, effect)
    }
}

/// A joint's zero, of whatever kind it is.
pub(super) fn shift_zero(joint: &mut super::Joint, by: f64) {
    match joint.kind {
        JointKind::Prismatic => joint.r = super::Length::meters(joint.r.value + by),
        _ => joint.theta = super::Angle::radians(joint.theta.value + by),
    }
}
