//! A simulated test bench: known parameters, one motion, noisy sensors, any tool.

use dh_codegen::arm::{Function, param};
use dh_codegen::robot::Robot;

use super::recording::{Recording, SensorNoise};
use super::waves::Waves;
use crate::data::signal::PrepareError;
use crate::identify::tool::{Carried, Carrying, ToolError, ToolSettings, identify_tool};
use crate::model::interpreted::Interpreted;
use crate::model::rigid_body::Numeric;
use crate::numerics::prng::Random;

/// White noise of the LWR's torques at 1 kHz, N m, joint by joint. With it the base parameters
/// identified from 10 s without a tool and 10 s with the tool have the standard deviations of the
/// paper's Table II. These are `MSY2R` 0.05 % of 3.43, `MSY4R` 0.05 % of 1.34, `MSY5R` 0.86 % of
/// 0.047, `MSY6R` 0.50 % of 0.034, `MSY7` 13.3 % of 0.001 kg m. After the 10 Hz low-pass 0.05 to
/// 0.013 N m are left. The paper's own residuals (0.42 N m) are larger, as they are model error and
/// not noise.
pub const PAPER_TORQUE_NOISE: [f64; 7] = [0.4, 0.4, 0.4, 0.2, 0.2, 0.1, 0.1];

/// Noise of its encoders, rad: of the order of their resolution.
#[cfg(test)]
pub(super) const POSITION_NOISE: f64 = 1e-5;

/// A robot, its motion and its sensors.
pub struct Bench {
    arm: Interpreted,
    phi: Vec<f64>,
    noise: SensorNoise,
    empty: Recording,
    /// Torque of a unit of each of the ten parameters.
    units: Vec<Recording>,
}

/// Reason why a bench can't be set up or used.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum BenchError {
    /// Link parameters are missing, so nothing can be simulated.
    #[error("the robot's links are not all known: there is nothing to simulate")]
    UnknownLinks,
    /// Noise is given for another number of joints.
    #[error("noise of {given} torques for {joints} joints")]
    Noise {
        /// Number of entries given.
        given: usize,
        /// Number of joints.
        joints: usize,
    },
    /// The log could not be prepared.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
    /// The identification failed.
    #[error(transparent)]
    Tool(#[from] ToolError),
}

impl Bench {
    /// Creates a bench with the robot without its tool, and the best of 200 motions of `seconds` at
    /// 1 kHz for identifying the load.
    pub fn new(robot: &Robot, noise: SensorNoise, seconds: f64, seed: u64) -> Result<Self, BenchError> {
        let mut robot = robot.clone();
        robot.tool = None;
        let phi = param::standard_values(&robot).ok_or(BenchError::UnknownLinks)?;
        let (given, joints) = (noise.torque.len(), robot.dof());
        if given != joints {
            return Err(BenchError::Noise { given, joints });
        }
        let arm = Interpreted::new(&robot, &[Function::PayloadRegressor]);
        let numeric = Numeric::new(&robot);
        let waves = Waves::exciting(&robot, &arm, &noise.torque, seconds, 200, seed);
        let record = |phi: &[f64]| Recording::new(&numeric, phi, &waves, 1000.0);
        let empty = record(&phi);
        // The parameters of the last link act like those of a carried body (RBDA, section 2.13:
        // inertias add up).
        let last = 10 * (robot.joints.len() - 1);
        let units = (last..last + 10)
            .map(|column| {
                let mut more = phi.clone();
                more[column] += 1.0;
                record(&more).combined(&[(&empty, -1.0)])
            })
            .collect();
        Ok(Self { arm, phi, noise, empty, units })
    }

    /// Records `repeats` logs without a tool and as many with a body of these ten parameters (last
    /// frame), and identifies it.
    pub fn identify(&self, body: &[f64; 10], repeats: usize, random: &mut Random) -> Result<Carried, BenchError> {
        let parts: Vec<(&Recording, f64)> = self.units.iter().zip(body.iter().copied()).collect();
        let full = self.empty.combined(&parts);
        let (without, with) = (Carrying::new(&self.arm, false), Carrying::new(&self.arm, true));
        let (mut unloaded, mut loaded) = (Vec::new(), Vec::new());
        for _ in 0..repeats.max(1) {
            unloaded.push(self.empty.factors("unloaded", &without, &self.noise, random)?);
            loaded.push(full.factors("loaded", &with, &self.noise, random)?);
        }
        let settings = ToolSettings { robot: Some(self.phi.clone()), ..ToolSettings::default() };
        Ok(identify_tool(&self.arm, &unloaded, &loaded, &settings)?)
    }
}
