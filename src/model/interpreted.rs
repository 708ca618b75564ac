//! An [`Arm`] by interpreted tapes: works for any robot file without compiling.

mod bodies;

pub use bodies::Bodies;

use dh_codegen::arm::{Argument, Function, Model};
use dh_codegen::interpret::{Batch, Interpreter, Scratch, State};
use dh_codegen::robot::{Convention, JointKind, Robot};

use super::arm::part;
use crate::model::{Arm, BaseParameter, Description, FrameKinematics, LinkExtents, Payload, States};
use crate::numerics::parallel::{parallel, threads};

/// A robot prepared for evaluation in batches.
pub struct Interpreted {
    description: Description,
    model: Model,
    interpreter: Interpreter,
    ends: Vec<[f64; 3]>,
    ranges: Vec<[f64; 3]>,
    payload: Vec<(usize, usize)>,
    has_tool: bool,
}

impl Interpreted {
    /// Builds the tapes that an [`Arm`] needs, and those of `more`. Ignores effects of the file.
    pub fn new(robot: &Robot, more: &[Function]) -> Self {
        Self::of(robot, Model::new(robot), more)
    }

    /// The same with all effects of the file, like its generated code. Encoder zeros, DH rows and
    /// base are the true ones. Inverse dynamics contains the laws of the drives, and is no longer
    /// linear in the parameters. Its parameters are those of [`Robot::effective`].
    pub fn with_effects(robot: &Robot, more: &[Function]) -> Self {
        if !robot.has_effects() {
            return Self::new(robot, more);
        }
        Self::of(&robot.effective(), Model::with_effects(robot), more)
    }

    fn of(robot: &Robot, model: Model, more: &[Function]) -> Self {
        let mut functions = vec![Function::BaseRegressor, Function::InverseDynamics];
        functions.extend(more);
        functions.sort_unstable();
        functions.dedup();
        let interpreter = Interpreter::new(&model, &functions);
        let base: Vec<BaseParameter> = model
            .base()
            .0
            .iter()
            .map(|b| BaseParameter {
                leader: b.leader.into(),
                name: b.name.clone(),
                grouping: b.grouping.clone(),
                coefficients: b.coefficients.clone(),
                unit: b.leader.unit(robot).to_string(),
            })
            .collect();
        let width = base.len().max(1);
        let nonzeros = interpreter.nonzeros(Function::BaseRegressor).unwrap_or_default();
        let payload = interpreter.nonzeros(Function::PayloadRegressor).unwrap_or_default();
        Self {
            description: Description {
                name: robot.name.clone(),
                dof: model.dof(),
                standard: model.standard().iter().map(|&p| p.into()).collect(),
                pattern: nonzeros.iter().map(|&o| (o / width, o % width)).collect(),
                base,
            },
            payload: payload.iter().map(|&o| (o / 10, o % 10)).collect(),
            ends: ends(robot),
            ranges: ranges(robot),
            has_tool: robot.tool.is_some(),
            model,
            interpreter,
        }
    }

    /// The underlying model, for groupings and operation counts.
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// Evaluates a requested function over a batch: entry `o` of the row-major result at sample `s`
    /// goes to `out[o * len + s]`.
    ///
    /// # Panics
    /// Like [`Interpreted::evaluate`].
    pub fn run(&self, function: Function, states: &States, tau: &[f64], parameters: &[f64], out: &mut [f64]) {
        self.interpreter.run(function, &batch(states, tau, parameters), out);
    }

    /// Row-major result of a requested function, one vector per state, for these standard
    /// parameters (empty where the function takes none).
    ///
    /// # Panics
    /// If the function was not among those given to [`Interpreted::new`].
    pub fn evaluate(&self, function: Function, states: &States, tau: &[f64], standard: &[f64]) -> Vec<Vec<f64>> {
        self.evaluate_on(threads(), function, states, tau, standard)
    }

    /// The same on a given number of threads. Each state is independent of its neighbours, so the
    /// result is bitwise equal to that of one thread.
    fn evaluate_on(
        &self,
        threads: usize,
        function: Function,
        states: &States,
        tau: &[f64],
        standard: &[f64],
    ) -> Vec<Vec<f64>> {
        let blocks = parallel(threads, states.len.div_ceil(BLOCK), |k| {
            let (from, to) = (k * BLOCK, states.len.min((k + 1) * BLOCK));
            self.block(function, &states.part(from, to), &part(tau, states.len, from, to), standard)
        });
        blocks.into_iter().flatten().collect()
    }

    fn block(&self, function: Function, states: &States, tau: &[f64], standard: &[f64]) -> Vec<Vec<f64>> {
        let size: usize = self.interpreter.shape(function).map_or(0, |s| s.iter().product());
        let mut out = vec![0.0; size * states.len];
        if function.arguments().contains(&Argument::BaseParameters) {
            self.run(function, states, tau, &self.model.base().values(standard), &mut out);
        } else {
            self.run(function, states, tau, standard, &mut out);
        }
        if function == Function::Gravity {
            for (joint, offset) in self.model.offsets_in_gravity(standard) {
                out[joint * states.len..(joint + 1) * states.len].iter_mut().for_each(|tau| *tau -= offset);
            }
        }
        (0..states.len).map(|s| (0..size).map(|o| out[o * states.len + s]).collect()).collect()
    }

    /// Evaluates a requested function for one state, without allocation once `scratch` has grown;
    /// see [`Interpreter::run_one`].
    ///
    /// # Panics
    /// Like [`Interpreted::evaluate`].
    pub fn run_one(&self, function: Function, state: &State<'_>, scratch: &mut Scratch, out: &mut [f64]) {
        self.interpreter.run_one(function, state, scratch, out);
    }

    /// Shape of a function's result.
    pub fn shape(&self, function: Function) -> Vec<usize> {
        self.interpreter.shape(function).unwrap_or_default().to_vec()
    }
}

/// Number of states evaluated together: their results fit into the second-level cache.
const BLOCK: usize = 512;

fn batch<'a>(states: &'a States, tau: &'a [f64], parameters: &'a [f64]) -> Batch<'a> {
    Batch { len: states.len, q: &states.q, dq: &states.dq, ddq: &states.ddq, tau, parameters }
}

/// Per row: origin of the next row in this row's frame (modified), or of the previous row
/// (standard), with prismatic joints at zero, m.
fn ends(robot: &Robot) -> Vec<[f64; 3]> {
    let rows: Vec<[f64; 4]> = robot
        .joints
        .iter()
        .map(|row| {
            let (s, c) = row.alpha.sin_cos();
            [row.d.value, row.r.value, s, c]
        })
        .collect();
    (0..rows.len())
        .map(|i| match robot.convention {
            Convention::Modified => match (rows.get(i + 1), &robot.tool) {
                (Some([d, r, s, c]), _) => [*d, -r * s, r * c],
                (None, Some(tool)) => tool.xyz,
                (None, None) => [0.0; 3],
            },
            Convention::Standard => {
                let [d, r, s, c] = rows[i];
                [-d, -r * s, -r * c]
            }
        })
        .collect()
}

/// Position range and maximum speed of each moving joint.
fn ranges(robot: &Robot) -> Vec<[f64; 3]> {
    let moving = robot.joints.iter().filter(|joint| joint.kind != JointKind::Fixed);
    moving
        .map(|joint| {
            let half = if joint.kind == JointKind::Revolute { std::f64::consts::PI } else { 0.5 };
            let [low, high] = joint.limits.position.unwrap_or([-half, half]);
            [low, high, joint.limits.velocity.unwrap_or(1.0)]
        })
        .collect()
}

impl LinkExtents for Interpreted {
    fn ends(&self) -> Vec<[f64; 3]> {
        self.ends.clone()
    }

    fn ranges(&self) -> Vec<[f64; 3]> {
        self.ranges.clone()
    }
}

impl Arm for Interpreted {
    fn description(&self) -> &Description {
        &self.description
    }

    fn base_regressor(&self, states: &States, out: &mut [f64]) {
        self.interpreter.run_nonzeros(Function::BaseRegressor, &batch(states, &[], &[]), out);
    }

    fn inverse_dynamics(&self, states: &States, standard: &[f64], out: &mut [f64]) {
        self.interpreter.run(Function::InverseDynamics, &batch(states, &[], standard), out);
    }
}

impl Interpreted {
    /// Functions to request in [`Interpreted::new`] for [`FrameKinematics`].
    pub const PLACED: [Function; 3] = [Function::Frames, Function::ToolPose, Function::Jacobian];
}

/// Panics unless the arm was built with [`Interpreted::PLACED`].
impl FrameKinematics for Interpreted {
    fn frame_count(&self) -> usize {
        self.ends.len() + usize::from(self.has_tool)
    }

    fn frames(&self, states: &States, out: &mut [f64]) {
        let (links, tool) = out.split_at_mut(self.ends.len() * 12 * states.len);
        self.run(Function::Frames, states, &[], &[], links);
        if self.has_tool {
            self.run(Function::ToolPose, states, &[], &[], tool);
        }
    }

    fn jacobian(&self, states: &States, out: &mut [f64]) {
        self.run(Function::Jacobian, states, &[], &[], out);
    }
}

/// Without [`Function::PayloadRegressor`] at construction, the payload regressor is empty.
impl Payload for Interpreted {
    fn payload_pattern(&self) -> &[(usize, usize)] {
        &self.payload
    }

    fn payload_regressor(&self, states: &States, out: &mut [f64]) {
        if !self.payload.is_empty() {
            self.interpreter.run_nonzeros(Function::PayloadRegressor, &batch(states, &[], &[]), out);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// More states than a block holds, and not a whole number of blocks.
    #[test]
    fn results_have_the_same_bits_on_any_number_of_threads() {
        let robot =
            Robot::from_yaml(include_str!("../../robots/kuka-lwr4.yaml"), &dh_codegen::robot::no_files).unwrap();
        let arm = Interpreted::new(&robot.robot, &[Function::ForwardDynamics]);
        let len = 2 * BLOCK + 77;
        let wave = |k: f64| (0..7 * len).map(|i| (k * i as f64).sin()).collect::<Vec<f64>>();
        let states = States { len, q: wave(0.7), dq: wave(1.3), ddq: wave(2.1) };
        let standard = dh_codegen::arm::param::standard_values(&robot.robot).unwrap();
        for function in [Function::BaseRegressor, Function::ForwardDynamics, Function::InverseDynamics] {
            let one = arm.evaluate_on(1, function, &states, &wave(3.3), &standard);
            assert_eq!(one.len(), len);
            assert!(one == arm.evaluate_on(3, function, &states, &wave(3.3), &standard), "{function:?}");
            assert!(one == arm.block(function, &states, &wave(3.3), &standard), "{function:?}");
        }
    }
}
