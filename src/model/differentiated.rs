//! A [`Differentiable`] arm from interpreted tapes and their adjoints: works for any robot file
//! without compiling.

use std::sync::OnceLock;

use dh_codegen::arm::{Function, Model};
use dh_codegen::interpret::Batch;
use dh_codegen::pullback::{Pullback, velocity_signs};
use dh_codegen::robot::Robot;

use crate::model::interpreted::Interpreted;
use crate::model::{Arm, Description, Differentiable, FrameKinematics, Gradient, Payload, States};

/// An [`Interpreted`] arm with the adjoints that exciting motions need. Those of torques, frames
/// and payload are built at their first use, since not every motion has such limits.
pub struct Differentiated {
    arm: Interpreted,
    base: Pullback,
    payload: OnceLock<Pullback>,
    torque: OnceLock<Pullback>,
    frames: OnceLock<Pullback>,
    tool: OnceLock<Pullback>,
    has_tool: bool,
    coulomb: Vec<(usize, usize)>,
    rows: usize,
}

impl Differentiated {
    /// Builds the tapes, and the adjoint of the base regressor.
    pub fn new(robot: &Robot) -> Self {
        let more = [Function::Frames, Function::ToolPose, Function::PayloadRegressor];
        let arm = Interpreted::new(robot, &more);
        let model: &Model = arm.model();
        let base = model.kernel(Function::BaseRegressor);
        let nonzeros = base.nonzeros();
        let place = |output: usize| nonzeros.iter().position(|&o| o == output);
        Self {
            base: Pullback::new(&base, &nonzeros, &model.chain().angle_offsets()),
            payload: OnceLock::new(),
            torque: OnceLock::new(),
            frames: OnceLock::new(),
            tool: OnceLock::new(),
            has_tool: robot.tool.is_some(),
            coulomb: velocity_signs(&base).iter().filter_map(|&(o, joint)| Some((place(o)?, joint))).collect(),
            rows: robot.joints.len(),
            arm,
        }
    }

    /// The adjoint of all structurally nonzero entries of a function, in order.
    fn adjoint<'a>(&self, slot: &'a OnceLock<Pullback>, function: Function) -> &'a Pullback {
        slot.get_or_init(|| {
            let kernel = self.arm.model().kernel(function);
            let wanted: Vec<usize> = match function {
                Function::PayloadRegressor => kernel.nonzeros(),
                _ => (0..kernel.tape.outputs.len()).collect(),
            };
            Pullback::new(&kernel, &wanted, &self.arm.model().chain().angle_offsets())
        })
    }

    /// The underlying arm without adjoints.
    pub fn interpreted(&self) -> &Interpreted {
        &self.arm
    }
}

fn batch<'a>(states: &'a States, parameters: &'a [f64]) -> Batch<'a> {
    Batch { len: states.len, q: &states.q, dq: &states.dq, ddq: &states.ddq, tau: &[], parameters }
}

impl Arm for Differentiated {
    fn description(&self) -> &Description {
        self.arm.description()
    }

    fn base_regressor(&self, states: &States, out: &mut [f64]) {
        self.arm.base_regressor(states, out);
    }

    fn inverse_dynamics(&self, states: &States, standard: &[f64], out: &mut [f64]) {
        self.arm.inverse_dynamics(states, standard, out);
    }
}

impl Differentiable for Differentiated {
    fn base_regressor_vjp(&self, states: &States, seeds: &[f64], to: &mut Gradient) {
        self.base.run(&batch(states, &[]), seeds, to);
    }

    fn coulomb_entries(&self) -> &[(usize, usize)] {
        &self.coulomb
    }

    fn payload_pattern(&self) -> &[(usize, usize)] {
        Payload::payload_pattern(&self.arm)
    }

    fn payload_regressor(&self, states: &States, out: &mut [f64]) {
        Payload::payload_regressor(&self.arm, states, out);
    }

    fn payload_regressor_vjp(&self, states: &States, seeds: &[f64], to: &mut Gradient) {
        self.adjoint(&self.payload, Function::PayloadRegressor).run(&batch(states, &[]), seeds, to);
    }

    fn inverse_dynamics_vjp(&self, states: &States, standard: &[f64], seeds: &[f64], to: &mut Gradient) {
        self.adjoint(&self.torque, Function::InverseDynamics).run(&batch(states, standard), seeds, to);
    }

    fn frame_count(&self) -> usize {
        self.rows + usize::from(self.has_tool)
    }

    fn frames(&self, states: &States, out: &mut [f64]) {
        FrameKinematics::frames(&self.arm, states, out);
    }

    fn frames_vjp(&self, states: &States, seeds: &[f64], to: &mut Gradient) {
        let (links, pose) = seeds.split_at(self.rows * 12 * states.len);
        self.adjoint(&self.frames, Function::Frames).run(&batch(states, &[]), links, to);
        if self.has_tool {
            self.adjoint(&self.tool, Function::ToolPose).run(&batch(states, &[]), pose, to);
        }
    }
}
