//! Simulated substitute for the paper's KUKA LWR: bodies and friction of `robots/kuka-lwr4.yaml`
//! (sources there), sensors, and effects that no rigid-body model has.

use dh_codegen::arm::{Function, param};
use dh_codegen::robot::effects::{JointElasticity, PreslidingHysteresis, RotorInertia, TorqueRipple};
use dh_codegen::robot::{Effects, Robot, no_files};

use super::ReproduceError;
use crate::apps::paper::tool::PAPER_TORQUE_NOISE;
use crate::model::Arm;
use crate::model::interpreted::Interpreted;
use crate::simulate::{Sensors, SimulationFile};

/// The robot file of the repository, unchanged.
const FILE: &str = include_str!("../../../robots/kuka-lwr4.yaml");

/// Hysteresis level as a share of the torque limit: a quarter of the simulator's default, 0.1 to
/// 0.4 N m, as large as the LWR's Coulomb friction (Table II).
const HYSTERESIS: f64 = 0.0025;
/// Ripple amplitudes as shares of the torque limit: the simulator's defaults, as measured on a
/// Staubli TX40 (see the table of effects).
const RIPPLE: [f64; 2] = [0.006, 0.003];
/// Damping of the joint springs relative to the torque limit, s/rad: 2 to 4 % of critical at the
/// frequencies of the loaded arm, 8 to 15 Hz. Stiffness is the simulator's default, 60 times the
/// torque limit (10.6 kN m/rad at 176 N m).
const DAMPING: f64 = 0.05;
/// Inertia of a rotor on a spring relative to the torque limit, kg m^2 per N m: a tenth of the
/// simulator's default. The LWR's torque sensors are behind the gear and hardly measure the torque
/// that accelerates the rotor, and the paper's model has no rotor.
const ROTOR: f64 = 0.0003;

/// Effects outside any rigid-body model.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unmodelled {
    /// `presliding_hysteresis`.
    Hysteresis,
    /// `torque_ripple`.
    Ripple,
    /// `joint_elasticity`.
    Elasticity,
}

impl Unmodelled {
    /// All effects.
    pub const ALL: [Self; 3] = [Self::Hysteresis, Self::Ripple, Self::Elasticity];

    /// Name in the vocabulary of effects.
    pub fn name(self) -> &'static str {
        match self {
            Self::Hysteresis => PreslidingHysteresis::NAME,
            Self::Ripple => TorqueRipple::NAME,
            Self::Elasticity => JointElasticity::NAME,
        }
    }

    /// Effect at a joint with this torque limit, N m, as YAML.
    fn yaml(self, limit: f64) -> String {
        let (name, of) = (self.name(), |share: f64| share * limit);
        match self {
            Self::Hysteresis => format!("{name}: {{ HC: {:.5} }}", of(HYSTERESIS)),
            Self::Ripple => format!("{name}: {{ RC: {:.5}, RS: {:.5} }}", of(RIPPLE[0]), of(RIPPLE[1])),
            Self::Elasticity => {
                let rotor = RotorInertia::NAME;
                format!("{name}: {{ DE: {:.5} }}, {rotor}: {{ IA: {:.5} }}", of(DAMPING), of(ROTOR))
            }
        }
    }
}

/// The simulated robot with its true parameters.
pub struct Lwr {
    /// The robot of the file, without a tool.
    pub robot: Robot,
    /// Interpreted arm with its regressors.
    pub arm: Interpreted,
    /// True standard parameters.
    pub standard: Vec<f64>,
    /// True base parameters.
    pub truth: Vec<f64>,
}

impl Lwr {
    /// Reads the built-in file.
    pub fn new() -> Result<Self, ReproduceError> {
        let read = Robot::from_yaml(FILE, &no_files);
        let mut robot = read.map_err(ReproduceError::in_file("kuka-lwr4.yaml"))?.robot;
        robot.tool = None;
        Self::of(robot)
    }

    /// The same with the light rotors of [`Unmodelled::Elasticity`] on rigid joints, known to the
    /// model: a sampled loop can then be stable.
    pub fn with_rotors() -> Result<Self, ReproduceError> {
        let mut robot = Self::new()?.robot;
        for joint in &mut robot.joints {
            joint.drive.rotor_inertia = joint.limits.torque.map(|limit| ROTOR * limit);
        }
        Self::of(robot)
    }

    /// Uses another robot file.
    pub fn of(robot: Robot) -> Result<Self, ReproduceError> {
        let standard = param::standard_values(&robot);
        let standard = standard.ok_or(ReproduceError::UnknownLinks)?;
        let arm = Interpreted::new(&robot, &[Function::PayloadRegressor]);
        let truth =
            arm.base_parameters().iter().map(|b| b.coefficients.iter().map(|&(i, k)| k * standard[i]).sum()).collect();
        Ok(Self { robot, arm, standard, truth })
    }

    /// Puts these effects at every joint.
    pub fn effects(&self, which: &[Unmodelled]) -> Result<Effects, ReproduceError> {
        if which.is_empty() {
            return Ok(Effects::default());
        }
        let mut text = String::from("joints:\n");
        for (joint, row) in self.robot.moving().into_iter().enumerate() {
            let limit = self.robot.joints[row].limits.torque.unwrap_or(0.0);
            let laws: Vec<String> = which.iter().map(|w| w.yaml(limit)).collect();
            text += &format!("  {}: {{ {} }}\n", joint + 1, laws.join(", "));
        }
        let file = SimulationFile::from_yaml(&text, &self.robot);
        Ok(file.map_err(ReproduceError::in_file("effects"))?.effects)
    }

    /// Encoders as in [`Sensors`]; torques with the white noise that gives base parameters the
    /// paper's standard deviations.
    pub fn sensors() -> Sensors {
        Sensors { torque_noise: PAPER_TORQUE_NOISE.to_vec(), desired: false, ..Sensors::default() }
    }
}
