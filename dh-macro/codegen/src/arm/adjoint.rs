//! Adjoints of kernels, `seed' d(outputs)/d(q, dq, ddq)`: converts derivatives by sines and cosines
//! to derivatives by angles.

use std::collections::BTreeMap;

use super::chain::Group;
use super::kernel::{Function, Kernel};
use crate::sym::{Ex, Graph, adjoint};

/// Nonzero derivatives of the weighted sum of some outputs (indices into the row-major result),
/// keyed by `q` (0), `dq` (1) or `ddq` (2) and joint. The weights are the inputs from `first_seed`
/// on.
pub(crate) fn by_states<'g>(
    graph: &'g Graph,
    kernel: &Kernel,
    wanted: &[usize],
    first_seed: usize,
) -> BTreeMap<(usize, usize), Ex<'g>> {
    let inputs = kernel.inputs;
    let seeds: Vec<Ex<'g>> = (0..wanted.len()).map(|k| graph.input(first_seed + k)).collect();
    let mut sums: BTreeMap<(usize, usize), Ex<'g>> = BTreeMap::new();
    for (input, bar) in adjoint(graph, &kernel.tape, wanted, &seeds) {
        // Chain rule: d sin = cos dq, d cos = -sin dq.
        let (part, joint, bar) = match inputs.locate(input) {
            (Group::Position, j) => (0, j, bar),
            (Group::Sine, j) => (0, j, bar * graph.input(inputs.index(Group::Cosine, j))),
            (Group::Cosine, j) => (0, j, -(bar * graph.input(inputs.index(Group::Sine, j)))),
            (Group::Velocity, j) => (1, j, bar),
            (Group::Acceleration, j) => (2, j, bar),
            (Group::Torque | Group::Parameter, _) => continue,
        };
        let sum = sums.get(&(part, joint)).map_or(bar, |&sum| sum + bar);
        sums.insert((part, joint), sum);
    }
    sums
}

/// Adjoint of a kernel as a kernel, `3 x n`; its seeds follow the `parameters` parameters that the
/// kernel reads.
pub(super) fn kernel(primal: &Kernel, function: Function, parameters: usize) -> Kernel {
    let graph = Graph::new();
    let first_seed = primal.inputs.index(Group::Parameter, parameters);
    let sums = by_states(&graph, primal, &primal.nonzeros(), first_seed);
    let n = primal.inputs.dof;
    let entry = |k: usize| sums.get(&(k / n, k % n)).copied().unwrap_or_else(|| graph.constant(0.0));
    let roots: Vec<Ex<'_>> = (0..3 * n).map(entry).collect();
    Kernel::new(function, primal.inputs, vec![3, n], &roots)
}
