//! Drive chain between the command and the link of one joint: motor, gear, friction, sensors.

use super::bristle::sign;
use super::effects::{
    AsymmetricFriction, Backlash, ClosedForm, CoulombFriction, FrictionDrift, JointElasticity, JointSpring,
    LoadDependentFriction, NonlinearViscousFriction, PositionDependentFriction, PreslidingHysteresis, StribeckFriction,
    TorqueRipple,
};

/// Temperature of a joint without a warming law, degrees C.
const ROOM: f64 = 25.0;

/// Drive of one joint with all of its effects. Torques in N m on the joint side of the gear, angles
/// in rad.
#[derive(Debug, Clone, PartialEq)]
pub struct Drive {
    /// Whether the joint has a motor.
    pub actuated: bool,
    /// The joint's torque limit, N m.
    pub rated: f64,
    /// `IA`, kg m^2.
    pub rotor: f64,
    /// `FC`, `FV`, `FO`.
    pub plain: CoulombFriction,
    /// `asymmetric_friction`.
    pub asymmetric: Option<AsymmetricFriction>,
    /// `stribeck_friction`.
    pub stribeck: Option<StribeckFriction>,
    /// `nonlinear_viscous_friction`.
    pub nonlinear: Vec<NonlinearViscousFriction>,
    /// `load_dependent_friction`.
    pub load: Option<LoadDependentFriction>,
    /// `position_dependent_friction`.
    pub position: Option<PositionDependentFriction>,
    /// `presliding_hysteresis`.
    pub hysteresis: Option<PreslidingHysteresis>,
    /// `friction_drift`.
    pub drift: Option<FrictionDrift>,
    /// `torque_ripple`.
    pub ripple: Vec<TorqueRipple>,
    /// `joint_elasticity`.
    pub elasticity: Option<JointElasticity>,
    /// `backlash`.
    pub backlash: Option<Backlash>,
    /// `joint_spring`.
    pub spring: Option<JointSpring>,
    /// `TM`, N m.
    pub limit: Option<f64>,
    /// `QO`, rad.
    pub encoder_offset: f64,
    /// `GT`.
    pub gain: f64,
    /// `TO`, N m.
    pub offset: f64,
    /// `TD`, s.
    pub delay: f64,
    /// `law`.
    pub law: Option<ClosedForm>,
}

/// For each joint, whether a closed-form law of any joint contains the sign of its velocity.
pub(super) fn signs_in_laws(drives: &[Drive]) -> Vec<bool> {
    let mut signs = vec![false; drives.len()];
    drives.iter().filter_map(|drive| drive.law.as_ref()).for_each(|law| law.signs(&mut signs));
    signs
}

impl Drive {
    /// A drive without friction, rotor or sensor errors.
    pub fn ideal(rated: f64) -> Self {
        Self {
            actuated: true,
            rated,
            rotor: 0.0,
            plain: CoulombFriction::default(),
            asymmetric: None,
            stribeck: None,
            nonlinear: Vec::new(),
            load: None,
            position: None,
            hysteresis: None,
            drift: None,
            ripple: Vec::new(),
            elasticity: None,
            backlash: None,
            spring: None,
            limit: None,
            encoder_offset: 0.0,
            gain: 1.0,
            offset: 0.0,
            delay: 0.0,
            law: None,
        }
    }

    /// Whether motor and link can move relative to each other.
    pub fn is_soft(&self) -> bool {
        self.elasticity.is_some() || self.backlash.is_some()
    }

    /// Whether a law of this drive contains `sign(v)`.
    pub fn has_sign(&self) -> bool {
        self.plain.level != 0.0
            || self.asymmetric.is_some_and(|a| a.level != 0.0)
            || self.stribeck.is_some()
            || self.load.is_some()
            || self.position.is_some()
    }

    /// Factor of all friction, `t` s after the start of the motion.
    pub fn warmth(&self, t: f64) -> f64 {
        self.drift.map_or(1.0, |d| d.factor(t))
    }

    /// Temperature, degrees C, `t` s after the start of the motion.
    pub fn temperature(&self, t: f64) -> f64 {
        self.drift.map_or(ROOM, |d| d.temperature(t))
    }

    /// Factor of `sign(v)`, N m, without warming and load.
    pub fn level(&self, q: f64, v: f64) -> f64 {
        let coulomb = self.plain.level;
        coulomb + self.stribeck.map_or(0.0, |s| s.excess(v, coulomb)) + self.position.map_or(0.0, |p| p.excess(q))
    }

    /// Friction at the motor without warming, load and offset, N m. `s` and `h` replace the sign of
    /// `v` for plain friction and for hysteresis: see `bristle.rs`.
    pub fn friction(&self, q: f64, v: f64, s: f64, h: f64) -> f64 {
        let mut torque = self.plain.viscous * v;
        if self.has_sign() {
            torque += self.level(q, v) * s;
        }
        if let Some(asymmetric) = self.asymmetric {
            torque += asymmetric.torque(v, s);
        }
        for nonlinear in &self.nonlinear {
            torque += nonlinear.slope(v) * v;
        }
        if let Some(hysteresis) = self.hysteresis {
            torque += hysteresis.level * h;
        }
        torque
    }

    /// Viscous slope of the friction at this speed, N m s/rad, clipped at zero: for the implicit
    /// integrator.
    pub fn viscosity(&self, v: f64) -> f64 {
        let slope = self.plain.viscous
            + self.asymmetric.map_or(0.0, |a| a.viscous * sign(v))
            + self.nonlinear.iter().map(|n| n.derivative(v)).sum::<f64>();
        slope.max(0.0)
    }

    /// Ripple torque at motor angle `q`, N m.
    pub fn ripple(&self, q: f64) -> f64 {
        self.ripple.iter().map(|r| r.torque(q)).sum()
    }

    /// Spring and damper of a soft joint: its elasticity, or else the teeth of its gear.
    pub fn transmission(&self) -> JointElasticity {
        self.elasticity.unwrap_or_else(|| JointElasticity::of_teeth(self.rated, self.rotor))
    }

    /// Torque that a soft joint transmits to its link, and its derivatives. `angle` and `velocity`
    /// are those of the motor relative to the link.
    pub fn transmitted(&self, angle: f64, velocity: f64) -> [f64; 3] {
        let spring = self.transmission();
        match self.backlash {
            Some(backlash) => backlash.torque(&spring, angle, velocity),
            None => [spring.stiffness * angle + spring.damping * velocity, spring.stiffness, spring.damping],
        }
    }

    /// Torque that the drive delivers for a commanded one: limited, and zero without a motor.
    pub fn clipped(&self, torque: f64) -> f64 {
        if !self.actuated {
            return 0.0;
        }
        self.limit.map_or(torque, |limit| torque.clamp(-limit, limit))
    }
}
