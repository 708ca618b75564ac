//! Collects each joint's drive laws beyond the rigid body from the effects of the robot file.

use super::effects::{
    AsymmetricFriction, Backlash, Effect, FrictionDrift, GearCoupling, JointElasticity, JointSpring,
    LoadDependentFriction, PositionDependentFriction, PreslidingHysteresis, RATED, Scope, StribeckFriction,
};
use super::{JointKind, NoLink, Robot, TorqueLaw};

/// Coupling of a motor with another joint, `w = dq_m + KC dq_k`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coupling {
    /// Index of the other joint k, as a degree of freedom from 0.
    pub other: usize,
    /// Coupling ratio `KC`.
    pub ratio: f64,
    /// Rotor inertia `IAM`, kg m^2.
    pub rotor: f64,
    /// Viscous friction `FVM`, N m s/rad.
    pub viscous: f64,
    /// Coulomb friction `FCM`, N m.
    pub coulomb: f64,
    /// Ratio `CQ`: the link of this joint is at `q_m + CQ q_k`.
    pub carried: f64,
}

/// Drive laws of one degree of freedom beyond rotor inertia, `FV`, `FC` and `FO`.
#[derive(Debug, Clone, PartialEq)]
pub struct Laws {
    /// Torque limit, N m, to which default magnitudes are relative.
    pub rated: f64,
    /// Direction-dependent friction.
    pub asymmetric: AsymmetricFriction,
    /// Stribeck friction, which falls with speed.
    pub stribeck: Option<StribeckFriction>,
    /// `FN`, `EN`, `VN` of each term of nonlinear viscous friction.
    pub nonlinear: Vec<[f64; 3]>,
    /// Load-dependent friction.
    pub load: Option<LoadDependentFriction>,
    /// Presliding hysteresis.
    pub hysteresis: Option<PreslidingHysteresis>,
    /// Friction that changes with time and temperature.
    pub drift: Option<FrictionDrift>,
    /// Position-dependent friction.
    pub position: Option<PositionDependentFriction>,
    /// `RN`, `RC`, `RS` of each order of torque ripple.
    pub ripple: Vec<[f64; 3]>,
    /// Elasticity of the gear.
    pub elasticity: Option<JointElasticity>,
    /// Backlash of the gear.
    pub backlash: Option<Backlash>,
    /// Joint spring, a function of q.
    pub spring: Option<JointSpring>,
    /// Couplings of this joint's motor with other joints.
    pub couplings: Vec<Coupling>,
    /// Torque limit of the saturation `TM`, N m.
    pub limit: Option<f64>,
    /// Torque gain `GT`.
    pub gain: f64,
    /// Torque offset `TO`, N m.
    pub offset: f64,
    /// Encoder offset `QO`, rad.
    pub encoder_offset: f64,
    /// Delay of the torque `TD`, s.
    pub delay: f64,
    /// Torque law in closed form.
    pub law: Option<TorqueLaw>,
    /// Temperature of the gear if none is known, degrees C.
    pub reference: f64,
}

impl Laws {
    /// Laws of a drive without effects.
    pub fn none(rated: f64) -> Self {
        Self {
            rated,
            asymmetric: AsymmetricFriction { level: Some(0.0), viscous: Some(0.0) },
            stribeck: None,
            nonlinear: Vec::new(),
            load: None,
            hysteresis: None,
            drift: None,
            position: None,
            ripple: Vec::new(),
            elasticity: None,
            backlash: None,
            spring: None,
            couplings: Vec::new(),
            limit: None,
            gain: 1.0,
            offset: 0.0,
            encoder_offset: 0.0,
            delay: 0.0,
            law: None,
            reference: 0.0,
        }
    }

    /// Stiffness `KE` of the gear, N m/rad; `None`: rigid except for its backlash.
    pub fn stiffness(&self) -> Option<f64> {
        self.elasticity.map(|spring| spring.stiffness(self.rated))
    }

    /// Backlash `BL` of the gear, rad.
    pub fn backlash(&self) -> f64 {
        self.backlash.map_or(0.0, |backlash| backlash.width())
    }

    /// Whether motor and link can move relative to each other.
    pub fn is_soft(&self) -> bool {
        self.elasticity.is_some() || self.backlash() != 0.0
    }

    /// Whether its closed-form law depends on time or temperature.
    pub fn reads_clock(&self) -> bool {
        self.law.as_ref().is_some_and(TorqueLaw::reads_clock)
    }

    /// Adds one effect of the joint in this row. Bodies and geometry are no laws of a drive (see
    /// [`Robot::effective`]); effects of a single recording are not either.
    fn apply(&mut self, robot: &Robot, row: usize, effect: &Effect) {
        let rated = self.rated;
        match effect {
            Effect::AsymmetricFriction(e) => self.asymmetric = *e,
            Effect::StribeckFriction(e) => self.stribeck = Some(*e),
            Effect::NonlinearViscousFriction(e) => self.nonlinear.extend(e.terms(rated)),
            Effect::LoadDependentFriction(e) => self.load = Some(*e),
            Effect::PreslidingHysteresis(e) => self.hysteresis = Some(*e),
            Effect::FrictionDrift(e) => self.drift = Some(*e),
            Effect::PositionDependentFriction(e) => self.position = Some(*e),
            Effect::TorqueRipple(e) => self.ripple.extend(e.waves(rated, robot.joints[row].drive.gear_ratio)),
            Effect::JointElasticity(e) => self.elasticity = Some(*e),
            Effect::Backlash(e) => self.backlash = Some(*e),
            Effect::GearCoupling(e) => self.couplings.extend(coupling(robot, row, e, rated)),
            Effect::TorqueGainError(e) => self.gain *= e.gain(),
            Effect::TorqueOffset(e) => self.offset += e.offset(rated),
            Effect::TorqueSaturation(e) => self.limit = e.limit,
            Effect::EncoderOffset(e) => self.encoder_offset += e.offset(),
            Effect::JointSpring(e) => self.spring = Some(*e),
            Effect::TimeDelay(e) => self.delay += e.delay(),
            // These are parameters of the drive itself.
            Effect::ViscousFriction(_) | Effect::CoulombFriction(_) | Effect::RotorInertia(_) => {}
            Effect::GeometricError(_) | Effect::LinkInertiaError(_) | Effect::Payload(_) | Effect::BaseTilt(_) => {}
            Effect::ExternalContact(_) => {}
        }
    }
}

/// Coupling of an effect; `None` if the other joint is not a moving joint. Sizes that depend on a
/// motion (`IAM` if not stated) are 0.
fn coupling(robot: &Robot, row: usize, effect: &GearCoupling, rated: f64) -> Option<Coupling> {
    let moving = robot.moving();
    let other = effect.joint.checked_sub(1).filter(|&k| k != row)?;
    let dof = moving.iter().position(|&r| r == other)?;
    let viscous = |row: usize| robot.joints[row].drive.viscous_friction.unwrap_or(0.0);
    Some(Coupling {
        other: dof,
        ratio: effect.ratio(),
        rotor: effect.rotor.unwrap_or(0.0),
        viscous: effect.viscous([viscous(row), viscous(other)]),
        coulomb: effect.coulomb(rated),
        carried: effect.carried(),
    })
}

impl Robot {
    /// Effects with their row: those of joints first, then those at the top that apply to every
    /// joint.
    pub(super) fn effects_by_row(&self) -> impl Iterator<Item = (usize, &Effect)> {
        let own = self.joints.iter().enumerate().flat_map(|(row, j)| j.drive.effects.iter().map(move |e| (row, e)));
        let top = self.effects.iter().filter(|e| e.kind().description().scope == Scope::EveryJoint);
        own.chain(top.flat_map(|e| (0..self.joints.len()).map(move |row| (row, e))))
    }

    /// Laws of each degree of freedom.
    pub fn laws(&self) -> Vec<Laws> {
        let moving = self.moving();
        let mut laws: Vec<Laws> =
            moving.iter().map(|&row| Laws::none(self.joints[row].limits.torque.unwrap_or(RATED))).collect();
        for (row, effect) in self.effects_by_row() {
            if let Some(k) = moving.iter().position(|&r| r == row) {
                laws[k].apply(self, row, effect);
            }
        }
        for (law, &row) in laws.iter_mut().zip(&moving) {
            law.law.clone_from(&self.joints[row].drive.law);
        }
        let clock = laws.iter().any(Laws::reads_clock);
        for law in &mut laws {
            // Without drift, the joint's temperature is used only by a closed-form law.
            let room = if clock { FrictionDrift::default().reference() } else { 0.0 };
            law.reference = law.drift.map_or(room, |drift| drift.reference());
        }
        laws
    }

    /// Whether any effect changes the arm's functions.
    pub fn has_effects(&self) -> bool {
        let counts = |e: &Effect| !matches!(e, Effect::ExternalContact(_));
        self.joints.iter().flat_map(|j| &j.drive.effects).chain(&self.effects).any(counts)
            || self.joints.iter().any(|j| j.drive.law.is_some())
    }

    /// Arm after applying its effects of geometry and bodies: joint zeros, rows of the table, base
    /// and links. Drives are unchanged.
    #[must_use]
    pub fn effective(&self) -> Self {
        super::real::effective(self)
    }

    /// Applies one effect of geometry or bodies to its row, link or base. These are
    /// `geometric_error`, `link_inertia_error` (at the joint of `row`, or of the whole robot),
    /// `base_tilt` and `payload`. Any other effect changes nothing.
    ///
    /// # Errors
    /// If the effect refers to a link that does not exist, or whose parameters are unknown.
    pub fn change(&mut self, row: Option<usize>, effect: &Effect) -> Result<(), NoLink> {
        super::real::change(self, row, effect)
    }
}

/// Shifts the zero of a revolute or prismatic joint, rad or m.
pub(super) fn shift_zero(joint: &mut super::Joint, by: f64) {
    match joint.kind {
        JointKind::Prismatic => joint.r = super::Length::meters(joint.r.value + by),
        _ => joint.theta = super::Angle::radians(joint.theta.value + by),
    }
}
