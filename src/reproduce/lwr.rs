//! The robot that stands for the paper's KUKA LWR: bodies and friction of `robots/kuka-lwr4.yaml` (sources there), sensors, and what no
//! rigid-body model has.

use dh_codegen::arm::{Function, param};
use dh_codegen::robot::{Effects, Robot, SimulationFile};

use super::ReproduceError;
use crate::arm::Arm;
use crate::interpreted::Interpreted;
use crate::simulate::Sensors;
use crate::tool::rerun::PAPER_TORQUE_NOISE;

/// The robot file as it is in the repository.
const FILE: &str = include_str!("../../robots/kuka-lwr4.yaml");

/// Torque by which joints differ from the model, as parts of the torque limit: half the simulator's defaults for hysteresis and ripple (their sources
/// stand in its table of effects), and the springs as they are there. With these, plain least squares is left with the paper's own residuals.
const LEVEL: f64 = 0.65;

/// What no rigid-body model has.
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
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Hysteresis, Self::Ripple, Self::Elasticity];

    /// Its name in the vocabulary of effects.
    pub fn name(self) -> &'static str {
        match self {
            Self::Hysteresis => "presliding_hysteresis",
            Self::Ripple => "torque_ripple",
            Self::Elasticity => "joint_elasticity",
        }
    }

    /// At a joint with this torque limit, N m.
    fn yaml(self, limit: f64) -> String {
        let keys = match self {
            Self::Hysteresis => format!("HC: {:.4}", 0.01 * LEVEL * limit),
            Self::Ripple => format!("RC: {:.4}, RS: {:.4}", 0.006 * LEVEL * limit, 0.003 * LEVEL * limit),
            Self::Elasticity => String::new(),
        };
        format!("{}: {{ {keys} }}", self.name())
    }
}

/// The simulated robot, and the truth about it.
pub struct Lwr {
    /// As in the file, without a tool.
    pub robot: Robot,
    /// Its regressors.
    pub arm: Interpreted,
    /// Standard parameters.
    pub standard: Vec<f64>,
    /// Base parameters.
    pub truth: Vec<f64>,
}

impl Lwr {
    /// Reads the built-in file.
    pub fn new() -> Result<Self, ReproduceError> {
        let read = Robot::from_yaml(FILE, &|name| Err(format!("no file {name}")));
        let mut robot = read.map_err(|p| ReproduceError::Robot(p.in_file("kuka-lwr4.yaml").to_string()))?.robot;
        robot.tool = None;
        let standard = param::standard_values(&robot);
        let standard = standard.ok_or_else(|| ReproduceError::Robot("its links are not all known".into()))?;
        let arm = Interpreted::new(&robot, &[Function::PayloadRegressor]);
        let truth =
            arm.base_parameters().iter().map(|b| b.coefficients.iter().map(|&(i, k)| k * standard[i]).sum()).collect();
        Ok(Self { robot, arm, standard, truth })
    }

    /// These effects at every joint.
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
        Ok(file.map_err(|p| ReproduceError::Robot(p.in_file("effects").to_string()))?.effects)
    }

    /// Encoders as in [`Sensors`]; torques with the white noise that gives base parameters the paper's standard deviations.
    pub fn sensors() -> Sensors {
        Sensors { torque_noise: PAPER_TORQUE_NOISE.to_vec(), desired: false, ..Sensors::default() }
    }
}
