//! Vector-Jacobian products of any kernel, run over batches: `seed' d(outputs)/d(q, dq, ddq)`.

use crate::arm::Kernel;
use crate::arm::adjoint::by_states;
use crate::arm::chain::{Group, Inputs};
use crate::interpret::{Batch, Columns};
use crate::sym::{Column, Evaluator, Ex, Graph, Operand, Tape};

/// The adjoint of a kernel, ready to run.
pub struct Pullback {
    inputs: Inputs,
    evaluator: Evaluator,
    /// Selects the derivatives: 0 by q, 1 by dq, 2 by ddq; and the joint.
    outputs: Vec<(usize, usize)>,
    /// First input that is a seed.
    first_seed: usize,
    offsets: Vec<f64>,
    tape: Tape,
}

/// Buffers to which [`Pullback::run`] adds derivatives; each part `dof * len`, joint-major like
/// [`Batch`].
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Gradient {
    /// By positions.
    pub q: Vec<f64>,
    /// By velocities.
    pub dq: Vec<f64>,
    /// By accelerations.
    pub ddq: Vec<f64>,
}

impl Pullback {
    /// Of these outputs of a kernel (indices into its row-major result), for a robot whose angles
    /// have these offsets ([`crate::arm::chain::Chain::angle_offsets`]).
    pub fn new(kernel: &Kernel, wanted: &[usize], offsets: &[f64]) -> Self {
        let first_seed = 1 + highest_input(&kernel.tape).max(kernel.inputs.index(Group::Parameter, 0));
        let graph = Graph::new();
        let sums = by_states(&graph, kernel, wanted, first_seed);
        let roots: Vec<Ex<'_>> = sums.values().copied().collect();
        let tape = Tape::new(&graph, &roots);
        Self {
            inputs: kernel.inputs,
            evaluator: Evaluator::new(&tape),
            outputs: sums.into_keys().collect(),
            first_seed,
            offsets: offsets.to_vec(),
            tape,
        }
    }

    /// The program, for counting or printing: outputs in the order `q`, `dq`, `ddq`, those that are
    /// not zero.
    pub fn tape(&self) -> &Tape {
        &self.tape
    }

    /// Seed `k` of sample `s` stands at `seeds[k * len + s]`; derivatives are added to `to`.
    ///
    /// # Panics
    /// If a part of the batch, the seeds or the gradient is too short.
    pub fn run(&self, batch: &Batch<'_>, seeds: &[f64], to: &mut Gradient) {
        let len = batch.len;
        if len == 0 {
            return;
        }
        let columns = Columns::new(self.inputs, batch, &self.offsets);
        let mut out = vec![0.0; self.outputs.len() * len];
        let seed = |k: usize| &seeds[k * len..(k + 1) * len];
        let column = |i: usize| match i.checked_sub(self.first_seed) {
            Some(k) => Column::Each(seed(k)),
            None => columns.input(i),
        };
        self.evaluator.run(len, column, &mut out);
        for (&(part, joint), column) in self.outputs.iter().zip(out.chunks(len)) {
            let target = [&mut to.q, &mut to.dq, &mut to.ddq][part].iter_mut().skip(joint * len);
            target.zip(column).for_each(|(sum, value)| *sum += value);
        }
    }
}

fn highest_input(tape: &Tape) -> usize {
    let read = tape.code.iter().flat_map(|s| [s.a, s.b]).chain(tape.outputs.iter().copied());
    read.map(|operand| if let Operand::Input(i) = operand { i as usize } else { 0 }).max().unwrap_or(0)
}

/// Outputs that are the sign of one velocity, by itself: output and joint. These are the columns of
/// Coulomb friction.
pub fn velocity_signs(kernel: &Kernel) -> Vec<(usize, usize)> {
    let sign_of = |output: Operand| match output {
        Operand::Temp(t) => {
            let step = kernel.tape.code[t as usize];
            match (step.kind, step.a) {
                (crate::sym::Kind::Sign, Operand::Input(i)) => Some(kernel.inputs.locate(i as usize)),
                _ => None,
            }
        }
        _ => None,
    };
    let outputs = kernel.tape.outputs.iter().enumerate();
    outputs
        .filter_map(|(at, &output)| match sign_of(output) {
            Some((Group::Velocity, joint)) => Some((at, joint)),
            _ => None,
        })
        .collect()
}
