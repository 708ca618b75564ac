//! Simulated logs of a robot with known parameters, with sensor noise.
//!
//! Torques come from the numeric recursion ([`Numeric`]), which shares no code with the regressor
//! used for identification.

use crate::data::log::{Block, Layout, LogError, Source};
use crate::data::signal::{Prepare, PrepareError, each_motion};
use crate::identify::tool::Carrying;
use crate::identify::{AccumulatorSettings, Factors, QrAccumulator};
use crate::model::rigid_body::Numeric;
use crate::numerics::prng::Random;

use super::waves::Waves;

/// White noise of the sensors, independent at each sample.
#[derive(Debug, Clone, PartialEq)]
pub struct SensorNoise {
    /// Standard deviation of each joint's torque, N m.
    pub torque: Vec<f64>,
    /// Standard deviation of the positions, rad.
    pub position: f64,
}

/// A noise-free log.
#[derive(Debug, Clone, PartialEq)]
pub struct Recording {
    rate: f64,
    /// Positions, one vector per joint, rad; `tau` are the torques, N m.
    q: Vec<Vec<f64>>,
    tau: Vec<Vec<f64>>,
}

impl Recording {
    /// Records one period of the motion of a robot with standard parameters `phi`.
    pub fn new(robot: &Numeric, phi: &[f64], waves: &Waves, rate: f64) -> Self {
        let n = robot.dof();
        let samples = (waves.period * rate).round() as usize;
        let mut recording =
            Self { rate, q: vec![Vec::with_capacity(samples); n], tau: vec![Vec::with_capacity(samples); n] };
        let (mut work, mut tau) = (robot.workspace(), vec![0.0; n]);
        for sample in 0..samples {
            let [q, dq, ddq] = waves.at(sample as f64 / rate);
            robot.inverse_dynamics_into(&mut work, &q, &dq, &ddq, phi, &mut tau);
            for joint in 0..n {
                recording.q[joint].push(q[joint]);
                recording.tau[joint].push(tau[joint]);
            }
        }
        recording
    }

    /// The same motion with added torques: those of each part times its factor.
    pub(super) fn combined(&self, parts: &[(&Self, f64)]) -> Self {
        let mut all = self.clone();
        for (part, factor) in parts {
            for (to, from) in all.tau.iter_mut().zip(&part.tau) {
                to.iter_mut().zip(from).for_each(|(t, f)| *t += factor * f);
            }
        }
        all
    }

    /// Noisy sensor readings, prepared and stacked as the equations of `arm`. Uses every tenth
    /// sample after the low-pass, as those between are nearly redundant.
    pub fn factors(
        &self,
        name: &str,
        arm: &Carrying<'_>,
        noise: &SensorNoise,
        random: &mut Random,
    ) -> Result<Factors, PrepareError> {
        use crate::model::Arm;
        let n = self.q.len();
        let header: Vec<String> = std::iter::once("t".to_string())
            .chain((1..=n).map(|j| format!("q{j}")))
            .chain((1..=n).map(|j| format!("tau{j}")))
            .collect();
        let samples = self.q.first().map_or(0, Vec::len);
        let mut columns = vec![(0..samples).map(|k| k as f64 / self.rate).collect::<Vec<f64>>()];
        let mut disturbed = |clean: &Vec<f64>, std: f64| clean.iter().map(|x| x + std * normal(random)).collect();
        columns.extend(self.q.iter().map(|q| disturbed(q, noise.position)));
        columns.extend(self.tau.iter().zip(&noise.torque).map(|(tau, std)| disturbed(tau, *std)));
        let mut source = Memory { layout: Layout::new(name, &header)?, columns, at: 0 };
        let stride = ((self.rate / 100.0) as usize).max(1);
        let mut stack = QrAccumulator::new(name, arm, AccumulatorSettings::default());
        each_motion(&mut source, arm.dof(), &Prepare { stride, ..Prepare::default() }, |motion| stack.absorb(motion))?;
        Ok(stack.finish())
    }
}

/// A nearly normal number: the sum of twelve uniform ones minus six (Irwin-Hall), bit-identical on
/// every machine.
pub(super) fn normal(random: &mut Random) -> f64 {
    (0..12).map(|_| random.uniform(0.0, 1.0)).sum::<f64>() - 6.0
}

/// A log in memory.
struct Memory {
    layout: Layout,
    columns: Vec<Vec<f64>>,
    at: usize,
}

impl Source for Memory {
    fn layout(&self) -> &Layout {
        &self.layout
    }

    fn next_block(&mut self, rows: usize, block: &mut Block) -> Result<(), LogError> {
        block.clear(self.columns.len());
        let end = (self.at + rows).min(self.columns[0].len());
        block.lines.extend((self.at..end).map(|k| k as u64 + 2));
        for (to, from) in block.columns.iter_mut().zip(&self.columns) {
            to.extend_from_slice(&from[self.at..end]);
        }
        self.at = end;
        Ok(())
    }
}
