//! Runs the kernels of any robot at run time: the second reader of the tapes.

use std::collections::BTreeMap;

use crate::arm::chain::{Group, Inputs};
use crate::arm::{Argument, Function, Kernel, Model};
use crate::runtime::Scalar;
use crate::sym::{Column, Evaluator};

/// States and parameters of a batch, joint-major: sample `s` of joint `j` at `j * len + s`. Unused
/// parts may be empty.
#[derive(Debug, Clone, Copy, Default)]
pub struct Batch<'a> {
    /// Number of states.
    pub len: usize,
    /// Positions.
    pub q: &'a [f64],
    /// Velocities.
    pub dq: &'a [f64],
    /// Accelerations.
    pub ddq: &'a [f64],
    /// Torques.
    pub tau: &'a [f64],
    /// Standard or base parameters, the same for all states.
    pub parameters: &'a [f64],
}

/// One state.
#[derive(Debug, Clone, Copy, Default)]
pub struct State<'a> {
    /// Positions.
    pub q: &'a [f64],
    /// Velocities.
    pub dq: &'a [f64],
    /// Accelerations.
    pub ddq: &'a [f64],
    /// Torques.
    pub tau: &'a [f64],
    /// Standard or base parameters.
    pub parameters: &'a [f64],
}

/// Working memory of [`Interpreter::run_one`]; may be shared between functions and robots.
#[derive(Debug, Clone, Default)]
pub struct Scratch {
    inputs: Vec<f64>,
    slots: Vec<f64>,
}

struct Ready {
    kernel: Kernel,
    evaluator: Evaluator,
    packed: Evaluator,
    nonzeros: Vec<usize>,
}

/// Tapes of a robot, ready to run. Results agree bit for bit with the generated code.
pub struct Interpreter {
    dof: usize,
    offsets: Vec<f64>,
    ready: BTreeMap<Function, Ready>,
}

impl Interpreter {
    /// Of these functions only: building a tape takes milliseconds.
    pub fn new(model: &Model, functions: &[Function]) -> Self {
        let kernels: Vec<Kernel> = functions.iter().map(|&f| model.kernel(f)).collect();
        Self::from_kernels(model, &kernels)
    }

    /// Of kernels that are there already.
    pub fn from_kernels(model: &Model, kernels: &[Kernel]) -> Self {
        let ready = kernels.iter().map(|kernel| {
            let nonzeros = kernel.nonzeros();
            let packed = Evaluator::of(&kernel.tape, &nonzeros);
            let evaluator = Evaluator::new(&kernel.tape);
            (kernel.function, Ready { evaluator, packed, nonzeros, kernel: kernel.clone() })
        });
        Self { dof: model.dof(), offsets: model.chain().angle_offsets(), ready: ready.collect() }
    }

    /// Extents of a function's result.
    pub fn shape(&self, function: Function) -> Option<&[usize]> {
        self.ready.get(&function).map(|r| r.kernel.shape.as_slice())
    }

    /// Places of the entries that are not structurally zero, in the row-major result.
    pub fn nonzeros(&self, function: Function) -> Option<&[usize]> {
        self.ready.get(&function).map(|r| r.nonzeros.as_slice())
    }

    /// Every output of every state: output `o` of state `s` goes to `out[o * len + s]`.
    ///
    /// # Panics
    /// If the function is not among those that were made ready, or a part of the batch is too
    /// short.
    pub fn run(&self, function: Function, batch: &Batch<'_>, out: &mut [f64]) {
        let ready = &self.ready[&function];
        self.run_on(&ready.kernel, &ready.evaluator, batch, out);
    }

    /// The same, only the entries of [`Interpreter::nonzeros`], in their order.
    ///
    /// # Panics
    /// Like [`Interpreter::run`].
    pub fn run_nonzeros(&self, function: Function, batch: &Batch<'_>, out: &mut [f64]) {
        let ready = &self.ready[&function];
        self.run_on(&ready.kernel, &ready.packed, batch, out);
    }

    fn run_on(&self, kernel: &Kernel, evaluator: &Evaluator, batch: &Batch<'_>, out: &mut [f64]) {
        let columns = Columns::new(kernel.inputs, batch, &self.offsets);
        evaluator.run(batch.len, |i| columns.input(i), out);
    }

    /// One state, without allocation once `scratch` has grown: the row-major result goes to `out`.
    /// The same bits as [`Interpreter::run`].
    ///
    /// # Panics
    /// Like [`Interpreter::run`].
    pub fn run_one(&self, function: Function, state: &State<'_>, scratch: &mut Scratch, out: &mut [f64]) {
        let Ready { kernel, evaluator, .. } = &self.ready[&function];
        let arguments = kernel.function.arguments();
        let n = self.dof;
        let Scratch { inputs, slots } = scratch;
        inputs.clear();
        inputs.resize(6 * n, 0.0);
        let index = |group| kernel.inputs.index(group, 0);
        if arguments.contains(&Argument::Configuration) {
            inputs[..n].copy_from_slice(&state.q[..n]);
            for start in (0..n).step_by(8) {
                let width = (n - start).min(8);
                let mut angles = [0.0; 8];
                (0..width).for_each(|l| angles[l] = state.q[start + l] + self.offsets[start + l]);
                let (s, c) = f64::sin_cos_all(&angles);
                inputs[index(Group::Sine) + start..][..width].copy_from_slice(&s[..width]);
                inputs[index(Group::Cosine) + start..][..width].copy_from_slice(&c[..width]);
            }
        }
        for (argument, group, values) in [
            (Argument::Velocities, Group::Velocity, state.dq),
            (Argument::Accelerations, Group::Acceleration, state.ddq),
            (Argument::Torques, Group::Torque, state.tau),
        ] {
            if arguments.contains(&argument) {
                inputs[index(group)..][..n].copy_from_slice(&values[..n]);
            }
        }
        let takes = |a| arguments.contains(&a);
        if takes(Argument::StandardParameters) || takes(Argument::BaseParameters) || takes(Argument::Seeds) {
            inputs.extend_from_slice(state.parameters);
        }
        evaluator.run_one(inputs, slots, out);
    }

    /// The row-major result of one state.
    ///
    /// # Panics
    /// Like [`Interpreter::run`].
    pub fn one(&self, function: Function, state: &State<'_>) -> Vec<f64> {
        let mut out = vec![0.0; self.ready[&function].kernel.tape.outputs.len()];
        let State { q, dq, ddq, tau, parameters } = *state;
        self.run(function, &Batch { len: 1, q, dq, ddq, tau, parameters }, &mut out);
        out
    }
}

/// A batch by the inputs of a kernel.
pub(crate) struct Columns<'a> {
    inputs: Inputs,
    batch: &'a Batch<'a>,
    offsets: &'a [f64],
}

impl<'a> Columns<'a> {
    /// `offsets` of the angles, for a kernel that reads sines and cosines.
    pub(crate) fn new(inputs: Inputs, batch: &'a Batch<'a>, offsets: &'a [f64]) -> Self {
        Self { inputs, batch, offsets }
    }

    /// Of every sample.
    pub(crate) fn input(&self, index: usize) -> Column<'a> {
        let (group, at) = self.inputs.locate(index);
        let Batch { len, q, dq, ddq, tau, parameters } = *self.batch;
        let of = |source: &'a [f64]| &source[at * len..(at + 1) * len];
        match group {
            Group::Position => Column::Each(of(q)),
            Group::Sine => Column::Sine(of(q), self.offsets[at]),
            Group::Cosine => Column::Cosine(of(q), self.offsets[at]),
            Group::Velocity => Column::Each(of(dq)),
            Group::Acceleration => Column::Each(of(ddq)),
            Group::Torque => Column::Each(of(tau)),
            Group::Parameter => Column::Same(parameters[at]),
        }
    }
}
