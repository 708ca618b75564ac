//! A [`Differentiable`] arm whose tapes and their adjoints are run: any robot file, without compiling.

use dh_codegen::arm::{Function, Model};
use dh_codegen::interpret::Batch;
use dh_codegen::pullback::{Pullback, velocity_signs};
use dh_codegen::robot::Robot;

use crate::arm::{Arm, Description, Differentiable, Gradient, States};
use crate::interpreted::Interpreted;

/// An [`Interpreted`] arm with the adjoints of what an exciting motion needs.
pub struct Differentiated {
    arm: Interpreted,
    base: Pullback,
    payload: Pullback,
    torque: Pullback,
    frames: Pullback,
    tool: Option<Pullback>,
    coulomb: Vec<(usize, usize)>,
    payload_pattern: Vec<(usize, usize)>,
    payload_places: Vec<usize>,
    frame_count: usize,
}

impl Differentiated {
    /// Builds the tapes and their adjoints.
    pub fn new(robot: &Robot) -> Self {
        let more = [Function::Frames, Function::ToolPose, Function::PayloadRegressor];
        let arm = Interpreted::new(robot, &more);
        let model: &Model = arm.model();
        let offsets = model.chain().angle_offsets();
        let base = model.kernel(Function::BaseRegressor);
        let nonzeros = base.nonzeros();
        let place = |output: usize| nonzeros.iter().position(|&o| o == output);
        let coulomb = velocity_signs(&base).iter().filter_map(|&(o, joint)| Some((place(o)?, joint))).collect();
        let payload = model.kernel(Function::PayloadRegressor);
        let payload_places = payload.nonzeros();
        let whole = |function: Function| {
            let kernel = model.kernel(function);
            let all: Vec<usize> = (0..kernel.tape.outputs.len()).collect();
            Pullback::new(&kernel, &all, &offsets)
        };
        let tool = robot.tool.as_ref().map(|_| whole(Function::ToolPose));
        Self {
            base: Pullback::new(&base, &nonzeros, &offsets),
            payload: Pullback::new(&payload, &payload_places, &offsets),
            torque: whole(Function::InverseDynamics),
            frames: whole(Function::Frames),
            frame_count: robot.joints.len() + usize::from(tool.is_some()),
            tool,
            coulomb,
            payload_pattern: payload_places.iter().map(|&o| (o / 10, o % 10)).collect(),
            payload_places,
            arm,
        }
    }

    /// The arm without adjoints.
    pub fn interpreted(&self) -> &Interpreted {
        &self.arm
    }

    /// The adjoint of the base regressor, for counting its operations.
    pub fn base_adjoint(&self) -> &Pullback {
        &self.base
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
        &self.payload_pattern
    }

    fn payload_regressor(&self, states: &States, out: &mut [f64]) {
        let len = states.len;
        let mut all = vec![0.0; self.dof() * 10 * len];
        self.arm.run(Function::PayloadRegressor, states, &[], &[], &mut all);
        for (k, &o) in self.payload_places.iter().enumerate() {
            out[k * len..(k + 1) * len].copy_from_slice(&all[o * len..(o + 1) * len]);
        }
    }

    fn payload_regressor_vjp(&self, states: &States, seeds: &[f64], to: &mut Gradient) {
        self.payload.run(&batch(states, &[]), seeds, to);
    }

    fn inverse_dynamics_vjp(&self, states: &States, standard: &[f64], seeds: &[f64], to: &mut Gradient) {
        self.torque.run(&batch(states, standard), seeds, to);
    }

    fn frame_count(&self) -> usize {
        self.frame_count
    }

    fn frames(&self, states: &States, out: &mut [f64]) {
        let rows = self.frame_count - usize::from(self.tool.is_some());
        let (links, tool) = out.split_at_mut(rows * 12 * states.len);
        self.arm.run(Function::Frames, states, &[], &[], links);
        if self.tool.is_some() {
            self.arm.run(Function::ToolPose, states, &[], &[], tool);
        }
    }

    fn frames_vjp(&self, states: &States, seeds: &[f64], to: &mut Gradient) {
        let rows = self.frame_count - usize::from(self.tool.is_some());
        let (links, pose) = seeds.split_at(rows * 12 * states.len);
        self.frames.run(&batch(states, &[]), links, to);
        if let Some(tool) = &self.tool {
            tool.run(&batch(states, &[]), pose, to);
        }
    }
}
