//! Reverse-mode differentiation: from a tape to the expressions of `seed' J`, one product with the
//! transposed Jacobian.
//!
//! The tape is replayed into a graph, then traversed backwards: each step propagates its adjoint to
//! its operands (Griewank and Walther, *Evaluating Derivatives*, section 3.2). The result is again
//! a graph, so the rules simplify it, equal parts are computed once, and it is printed or run like
//! any other. It needs at most about four times the operations of the tape, however many outputs
//! there are.

use std::collections::BTreeMap;

use super::call::Call;
use super::graph::{Ex, Graph};
use super::tape::{Kind, Operand, Tape};

/// Derivative of `sum of seeds[k] * output(wanted[k])` by every input on which it depends: map from
/// input index to expression.
///
/// The derivative of a sign is zero, its value almost everywhere.
///
/// # Panics
/// If `seeds` is shorter than `wanted`.
pub fn adjoint<'g>(graph: &'g Graph, tape: &Tape, wanted: &[usize], seeds: &[Ex<'g>]) -> BTreeMap<usize, Ex<'g>> {
    let mut values: Vec<Ex<'g>> = Vec::with_capacity(tape.code.len());
    let value = |operand: Operand, values: &[Ex<'g>]| match operand {
        Operand::Constant(c) => graph.replayed(c, tape.formulas.contains_key(&c.to_bits())),
        Operand::Input(i) => graph.input(i as usize),
        Operand::Temp(t) => values[t as usize],
    };
    for step in &tape.code {
        let (a, b) = (value(step.a, &values), value(step.b, &values));
        values.push(match step.kind {
            Kind::Add => a + b,
            Kind::Sub => a - b,
            Kind::Mul => a * b,
            Kind::Div => a / b,
            Kind::Neg => -a,
            Kind::Sign => a.sign(),
            Kind::Call(f) => a.call(f),
            Kind::Least => a.least(b),
            Kind::Most => a.most(b),
        });
    }
    let mut temps: Vec<Option<Ex<'g>>> = vec![None; tape.code.len()];
    let mut inputs: BTreeMap<usize, Ex<'g>> = BTreeMap::new();
    let give = |to: Operand, bar: Ex<'g>, temps: &mut [Option<Ex<'g>>], inputs: &mut BTreeMap<usize, Ex<'g>>| {
        if bar.is_zero() {
            return;
        }
        match to {
            Operand::Constant(_) => {}
            Operand::Input(i) => {
                let sum = inputs.get(&(i as usize)).map_or(bar, |&sum| sum + bar);
                inputs.insert(i as usize, sum);
            }
            Operand::Temp(t) => {
                let slot = &mut temps[t as usize];
                *slot = Some(slot.map_or(bar, |sum| sum + bar));
            }
        }
    };
    for (&output, &seed) in wanted.iter().zip(seeds) {
        give(tape.outputs[output], seed, &mut temps, &mut inputs);
    }
    for (at, step) in tape.code.iter().enumerate().rev() {
        let Some(bar) = temps[at] else { continue };
        let (a, b) = (value(step.a, &values), value(step.b, &values));
        let (to_a, to_b) = match step.kind {
            Kind::Add => (Some(bar), Some(bar)),
            Kind::Sub => (Some(bar), Some(-bar)),
            Kind::Mul => (Some(bar * b), Some(bar * a)),
            Kind::Div => (Some(bar / b), Some(-(bar * values[at] / b))),
            Kind::Neg => (Some(-bar), None),
            Kind::Sign => (None, None),
            Kind::Call(f) => {
                let by = match f {
                    Call::Abs => bar * a.sign(),
                    Call::Sqrt => bar / (values[at] * 2.0),
                    Call::Exp => bar * values[at],
                    Call::Ln => bar / a,
                    Call::Sin => bar * a.call(Call::Cos),
                    Call::Cos => -(bar * a.call(Call::Sin)),
                };
                (Some(by), None)
            }
            // At equality each operand gets half.
            Kind::Least | Kind::Most => {
                let larger = ((a - b).sign() + 1.0) * 0.5;
                let to_a = if step.kind == Kind::Most { larger } else { -larger + 1.0 };
                (Some(bar * to_a), Some(bar * (-to_a + 1.0)))
            }
        };
        for (operand, bar) in [(step.a, to_a), (step.b, to_b)] {
            if let Some(bar) = bar {
                give(operand, bar, &mut temps, &mut inputs);
            }
        }
    }
    inputs
}

#[cfg(test)]
mod tests {
    use super::super::{Column, Evaluator};
    use super::*;

    #[test]
    fn by_hand() {
        let g = Graph::new();
        let (x, y) = (g.input(0), g.input(1));
        let tape = Tape::new(&g, &[x * y / (x - y), -(x * x) + y, x.sign() * y]);
        let h = Graph::new();
        let seeds: Vec<_> = (2..5).map(|i| h.input(i)).collect();
        let by = adjoint(&h, &tape, &[0, 1, 2], &seeds);
        let run = Evaluator::new(&Tape::new(&h, &[by[&0], by[&1]]));
        let inputs = [1.5, 0.25, 2.0, 3.0, 5.0].map(|v| [v]);
        let mut out = [0.0; 2];
        run.run(1, |i| Column::Each(&inputs[i]), &mut out);
        let (x, y) = (1.5, 0.25_f64);
        let square = (x - y) * (x - y);
        assert!((out[0] - (2.0 * (-y * y / square) + 3.0 * (-2.0 * x))).abs() < 1e-14);
        assert!((out[1] - (2.0 * (x * x / square) + 3.0 + 5.0)).abs() < 1e-14);
    }
}
