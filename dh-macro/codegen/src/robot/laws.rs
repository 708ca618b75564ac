//! Each joint's drive beyond the rigid body, from the effects of the robot file.

use super::effects::{
    AsymmetricFriction, Backlash, Effect, FrictionDrift, GearCoupling, JointElasticity, JointSpring,
    LoadDependentFriction, PositionDependentFriction, PreslidingHysteresis, RATED, Scope, StribeckFriction,
};
use super::{JointKind, NoLink, Robot, TorqueLaw};

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
    /// `CQ`: the link of this joint stands at `q_m + CQ q_k`.
    pub carried: f64,
}

/// The drive of one degree of freedom beyond rotor, `FV`, `FC` and `FO`.
#[derive(Debug, Clone, PartialEq)]
pub struct Laws {
    /// Torque limit, N m: what default magnitudes are parts of.
    pub rated: f64,
    /// Friction that differs with direction.
    pub asymmetric: AsymmetricFriction,
    /// Friction that falls with speed.
    pub stribeck: Option<StribeckFriction>,
    /// `FN`, `EN`, `VN` of each term of friction that is not in proportion to speed.
    pub nonlinear: Vec<[f64; 3]>,
    /// Friction by the load.
    pub load: Option<LoadDependentFriction>,
    /// Friction with memory.
    pub hysteresis: Option<PreslidingHysteresis>,
    /// Friction that changes with time.
    pub drift: Option<FrictionDrift>,
    /// Friction that changes with the angle.
    pub position: Option<PositionDependentFriction>,
    /// `RN`, `RC`, `RS` of each order of ripple.
    pub ripple: Vec<[f64; 3]>,
    /// The spring of the gear.
    pub elasticity: Option<JointElasticity>,
    /// Its dead zone.
    pub backlash: Option<Backlash>,
    /// A spring in q.
    pub spring: Option<JointSpring>,
    /// Coupling of this joint's motor with others.
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
    /// What has no name.
    pub law: Option<TorqueLaw>,
    /// Temperature of its gear where none is known, degrees C.
    pub reference: f64,
}

impl Laws {
    /// A drive without any.
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

    /// `KE` of the gear, N m/rad; `None`: rigid but for its backlash.
    pub fn stiffness(&self) -> Option<f64> {
        self.elasticity.map(|spring| spring.stiffness(self.rated))
    }

    /// `BL` of the gear, rad.
    pub fn backlash(&self) -> f64 {
        self.backlash.map_or(0.0, |backlash| backlash.width())
    }

    /// Whether motor and link can move against each other.
    pub fn is_soft(&self) -> bool {
        self.elasticity.is_some() || self.backlash() != 0.0
    }

    /// Whether it has a law that asks for the time or for temperatures.
    pub fn reads_clock(&self) -> bool {
        self.law.as_ref().is_some_and(TorqueLaw::reads_clock)
    }

    /// One effect of the joint of this row. Bodies and geometry are no laws of a drive: see
    /// [`Robot::effective`]; nor is what belongs to one recording.
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
            // Parameters of the drive itself.
            Effect::ViscousFriction(_) | Effect::CoulombFriction(_) | Effect::RotorInertia(_) => {}
            Effect::GeometricError(_) | Effect::LinkInertiaError(_) | Effect::Payload(_) | Effect::BaseTilt(_) => {}
            Effect::ExternalContact(_) => {}
        }
    }
}

/// `None` where the other joint is none. Sizes that depend on a motion (`IAM` where nothing is
/// written) are 0.
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
    /// Effects with their row: those of joints first, then those at the top that mean every joint.
    pub(super) fn effects_by_row(&self) -> impl Iterator<Item = (usize, &Effect)> {
        let own = self.joints.iter().enumerate().flat_map(|(row, j)| j.drive.effects.iter().map(move |e| (row, e)));
        let top = self.effects.iter().filter(|e| e.kind().description().scope == Scope::EveryJoint);
        own.chain(top.flat_map(|e| (0..self.joints.len()).map(move |row| (row, e))))
    }

    /// Of each degree of freedom: the effects of its drive.
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
            // Only a law asks for the temperature of a joint that does not drift.
            let room = if clock { FrictionDrift::default().reference() } else { 0.0 };
            law.reference = law.drift.map_or(room, |drift| drift.reference());
        }
        laws
    }

    /// Whether any effect changes what the arm's functions compute.
    pub fn has_effects(&self) -> bool {
        let counts = |e: &Effect| !matches!(e, Effect::ExternalContact(_));
        self.joints.iter().flat_map(|j| &j.drive.effects).chain(&self.effects).any(counts)
            || self.joints.iter().any(|j| j.drive.law.is_some())
    }

    /// The arm as its effects of geometry and bodies say that it is: zeros of joints, rows of the
    /// table, base, links. Drives stay.
    #[must_use]
    pub fn effective(&self) -> Self {
        super::real::effective(self)
    }

    /// Applies one effect of geometry or bodies, so that row, link or base become the true ones.
    /// These are `geometric_error`, `link_inertia_error` (at the joint of `row`, or of the whole
    /// robot), `base_tilt` and `payload`. Any other effect changes nothing.
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
