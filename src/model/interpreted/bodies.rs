//! [`Dynamics`] by interpreted tapes, one state at a time.

use dh_codegen::arm::Function;
use dh_codegen::arm::param::Parameter;
use dh_codegen::interpret::{Scratch, State};

use super::Interpreted;
use crate::model::{Dynamics, ToolState};

/// The bodies of an [`Interpreted`] arm with given parameters.
pub struct Bodies<'a> {
    arm: &'a Interpreted,
    base: Vec<f64>,
    still: Vec<f64>,
    /// Vector from the last frame's origin to the tool's, in the tool's axes, m: constant. `None`
    /// before the first evaluation.
    arm_of_tool: Option<[f64; 3]>,
    scratch: Scratch,
}

impl Interpreted {
    /// Functions to request in [`Interpreted::new`] for [`Interpreted::bodies`].
    pub const BODIES: [Function; 5] = [
        Function::MassMatrix,
        Function::InverseDynamicsBase,
        Function::ForwardKinematics,
        Function::ToolPose,
        Function::Jacobian,
    ];

    /// The bodies with these standard parameters (`P`); drive parameters are ignored. Their methods
    /// panic unless [`Interpreted::BODIES`] were requested.
    pub fn bodies(&self, standard: &[f64]) -> Bodies<'_> {
        let links_only = |(p, &value): (&Parameter, &f64)| if matches!(p, Parameter::Link(..)) { value } else { 0.0 };
        let standard: Vec<f64> = self.model.standard().iter().zip(standard).map(links_only).collect();
        Bodies {
            base: self.model.base().values(&standard),
            still: vec![0.0; self.model.dof()],
            arm: self,
            arm_of_tool: None,
            scratch: Scratch::default(),
        }
    }
}

impl Bodies<'_> {
    fn run(&mut self, function: Function, q: &[f64], dq: &[f64], out: &mut [f64]) {
        let state = State { q, dq, ddq: &self.still, tau: &[], parameters: &self.base };
        self.arm.interpreter.run_one(function, &state, &mut self.scratch, out);
    }
}

impl Dynamics for Bodies<'_> {
    fn dof(&self) -> usize {
        self.still.len()
    }

    fn mass_matrix(&mut self, q: &[f64], mass: &mut [f64]) {
        self.run(Function::MassMatrix, q, &[], mass);
    }

    fn bias(&mut self, q: &[f64], dq: &[f64], bias: &mut [f64]) {
        self.run(Function::InverseDynamicsBase, q, dq, bias);
    }

    fn tool(&mut self, q: &[f64], tool: &mut ToolState) {
        let n = self.dof();
        tool.jacobian.resize(6 * n, 0.0);
        self.run(Function::ToolPose, q, &[], &mut tool.pose);
        let pose = tool.pose;
        let arm = self.arm_of_tool.unwrap_or_else(|| {
            let mut last = [0.0; 12];
            self.run(Function::ForwardKinematics, q, &[], &mut last);
            let away = [3, 7, 11].map(|k| pose[k] - last[k]);
            std::array::from_fn(|k| (0..3).map(|i| pose[4 * i + k] * away[i]).sum())
        });
        self.arm_of_tool = Some(arm);
        self.run(Function::Jacobian, q, &[], &mut tool.jacobian);
        // The Jacobian is the last frame's: v_tool = v_last + w x (p_tool - p_last).
        let [x, y, z]: [f64; 3] = std::array::from_fn(|i| (0..3).map(|k| pose[4 * i + k] * arm[k]).sum());
        let j = &mut tool.jacobian;
        for k in 0..n {
            let [wx, wy, wz] = [3, 4, 5].map(|row| j[row * n + k]);
            j[k] += wy * z - wz * y;
            j[n + k] += wz * x - wx * z;
            j[2 * n + k] += wx * y - wy * x;
        }
    }
}
