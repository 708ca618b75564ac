//! Runs a tape on f64, many states at a time: the meaning of a tape.

use super::order::just_in_time;
use super::tape::{Instruction, Kind, Operand, Tape};
use crate::elementary::Real;

/// States that are carried through the tape together.
pub const LANES: usize = 64;

/// One value of every state of a tile, on lines of the cache of its own.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
struct Lane([f64; LANES]);

/// What a step computes of its operands `a b c d`. Products that are read once are computed where
/// they are read, with the rounding that they have by themselves: half of the steps, each of which
/// costs a visit, go away.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Operation {
    Plain(Kind),
    /// `a b + c`
    MulAdd,
    /// `c + a b`
    AddMul,
    /// `a b - c`
    MulSub,
    /// `c - a b`
    SubMul,
    /// `a b + c d`
    MulAddMul,
    /// `a b - c d`
    MulSubMul,
}

#[derive(Debug, Clone, Copy)]
struct Step {
    operation: Operation,
    operands: [u32; 4],
    out: u32,
}

/// Before its values have slots.
struct Fused {
    /// Step of the tape that it ends with.
    at: usize,
    operation: Operation,
    operands: Vec<Operand>,
}

/// The steps in this order, products that are read once within their readers.
fn fused(tape: &Tape, order: &[usize], roots: &[Operand]) -> Vec<Fused> {
    let mut readers = vec![0u32; tape.code.len()];
    let operands = order.iter().flat_map(|&at| [tape.code[at].a, tape.code[at].b]);
    for operand in operands.chain(roots.iter().copied()) {
        if let Operand::Temp(t) = operand {
            readers[t as usize] += 1;
        }
    }
    // A product that is added to itself counts as read twice.
    let product = |operand: Operand| match operand {
        Operand::Temp(t) if tape.code[t as usize].kind == Kind::Mul && readers[t as usize] == 1 => Some(t as usize),
        _ => None,
    };
    let factors = |t: usize| [tape.code[t].a, tape.code[t].b];
    let mut inside = vec![false; tape.code.len()];
    let mut steps: Vec<Fused> = Vec::with_capacity(order.len());
    for &at in order {
        let Instruction { kind, a, b } = tape.code[at];
        let parts = match kind {
            Kind::Add | Kind::Sub => [product(a), product(b)],
            _ => [None, None],
        };
        parts.into_iter().flatten().for_each(|t| inside[t] = true);
        let add = kind == Kind::Add;
        let (operation, operands) = match parts {
            [Some(x), Some(y)] => {
                let operation = if add { Operation::MulAddMul } else { Operation::MulSubMul };
                (operation, [factors(x), factors(y)].concat())
            }
            [Some(x), None] => {
                let operation = if add { Operation::MulAdd } else { Operation::MulSub };
                (operation, [&factors(x)[..], &[b]].concat())
            }
            [None, Some(y)] => {
                let operation = if add { Operation::AddMul } else { Operation::SubMul };
                (operation, [&factors(y)[..], &[a]].concat())
            }
            [None, None] => (Operation::Plain(kind), vec![a, b]),
        };
        steps.push(Fused { at, operation, operands });
    }
    steps.retain(|step| !inside[step.at]);
    steps
}

/// A tape made ready to run: temporaries share slots as soon as they are no longer needed.
#[derive(Debug, Clone)]
pub struct Evaluator {
    steps: Vec<Step>,
    constants: Vec<(u32, f64)>,
    inputs: Vec<(u32, usize)>,
    /// For each output: the slot it is in, and after which step it can be read (it may be
    /// overwritten later).
    outputs: Vec<(usize, u32, usize)>,
    slots: usize,
    output_count: usize,
}

impl Evaluator {
    /// All outputs of a tape.
    pub fn new(tape: &Tape) -> Self {
        let all: Vec<usize> = (0..tape.outputs.len()).collect();
        Self::of(tape, &all)
    }

    /// Some outputs of a tape, in this order. Of two orders of the steps it takes the one that
    /// needs fewer slots: what fits into the nearest cache runs faster.
    pub fn of(tape: &Tape, wanted: &[usize]) -> Self {
        let late = Self::in_order(tape, wanted, &just_in_time(tape, wanted));
        let in_order = Self::in_order(tape, wanted, &(0..tape.code.len()).collect::<Vec<_>>());
        if (late.steps.len(), late.slots) < (in_order.steps.len(), in_order.slots) { late } else { in_order }
    }

    /// Gives every operand a slot. `order`: steps of the tape, readers behind what they read.
    fn in_order(tape: &Tape, wanted: &[usize], order: &[usize]) -> Self {
        let roots: Vec<Operand> = wanted.iter().map(|&o| tape.outputs[o]).collect();
        let order = fused(tape, order, &roots);
        // Constants and inputs are loaded once, before the first step: they get their slots before
        // any temporary does.
        let mut slots = Slots::default();
        let mut pinned = Pinned::default();
        for operand in order.iter().flat_map(|step| &step.operands).chain(&roots) {
            pinned.slot(*operand, &mut slots);
        }
        // Last reader of each temporary (by its place in the order), so that its slot can be used
        // again.
        let mut last = vec![0usize; tape.code.len()];
        for (place, step) in order.iter().enumerate() {
            step.operands.iter().filter_map(temporary).for_each(|t| last[t] = place);
        }
        let mut at_step: Vec<Vec<usize>> = vec![Vec::new(); tape.code.len()];
        let mut outputs = Vec::with_capacity(roots.len());
        for (index, output) in roots.iter().enumerate() {
            match temporary(output) {
                Some(t) => at_step[t].push(index),
                None => outputs.extend(pinned.slot(*output, &mut slots).map(|slot| (0, slot, index))),
            }
        }
        let mut place = vec![0u32; tape.code.len()];
        let mut steps = Vec::with_capacity(order.len());
        for (now, Fused { at, operation, operands }) in order.iter().enumerate() {
            let mut read = [0; 4];
            for (slot, operand) in read.iter_mut().zip(operands) {
                *slot = match temporary(operand) {
                    Some(t) => place[t],
                    None => pinned.slot(*operand, &mut slots).unwrap_or(0),
                };
            }
            for (k, operand) in operands.iter().enumerate() {
                if let Some(t) = temporary(operand)
                    && last[t] == now
                    && !operands[..k].contains(operand)
                {
                    slots.release(place[t]);
                }
            }
            let out = slots.take();
            place[*at] = out;
            steps.push(Step { operation: *operation, operands: read, out });
            outputs.extend(at_step[*at].iter().map(|&index| (now + 1, out, index)));
            if last[*at] == 0 && !at_step[*at].is_empty() {
                slots.release(out); // an output that nothing else reads
            }
        }
        outputs.sort_unstable();
        let Pinned { constants, inputs } = pinned;
        Self { steps, constants, inputs, outputs, slots: slots.count as usize, output_count: roots.len() }
    }

    /// Number of values that come out per state.
    pub fn outputs(&self) -> usize {
        self.output_count
    }

    /// Runs `len` states. Input `i` of state `s` is `inputs(i)[s]`; output `o` of state `s` goes to
    /// `out[o * len + s]`.
    ///
    /// # Panics
    /// If `out` is shorter than `outputs() * len` or an input column than `len`.
    pub fn run<'a>(&self, len: usize, inputs: impl Fn(usize) -> &'a [f64], out: &mut [f64]) {
        let mut slots: Vec<Lane> = vec![Lane([0.0; LANES]); self.slots];
        for &(slot, value) in &self.constants {
            slots[slot as usize] = Lane([value; LANES]);
        }
        let mut start = 0;
        while start < len {
            let width = LANES.min(len - start);
            for &(slot, index) in &self.inputs {
                slots[slot as usize].0[..width].copy_from_slice(&inputs(index)[start..start + width]);
            }
            tile(self, &mut slots, [start, width, len], out);
            start += width;
        }
    }
}

impl Evaluator {
    /// Runs one state: `inputs[i]` is input `i`, output `o` goes to `out[o]`. `room` is working
    /// memory that calls may share; its content on entry does not matter. The same bits as
    /// [`Evaluator::run`].
    ///
    /// # Panics
    /// If `out` is shorter than `outputs()` or `inputs` than the highest input that is read.
    pub fn run_one(&self, inputs: &[f64], room: &mut Vec<f64>, out: &mut [f64]) {
        if room.len() < self.slots {
            room.resize(self.slots, 0.0);
        }
        let slots = &mut room[..self.slots];
        for &(slot, value) in &self.constants {
            slots[slot as usize] = value;
        }
        for &(slot, index) in &self.inputs {
            slots[slot as usize] = inputs[index];
        }
        let mut done = 0;
        for &(after, slot, index) in &self.outputs {
            for step in &self.steps[done..after] {
                let [a, b, c, d] = step.operands.map(|slot| slots[slot as usize]);
                slots[step.out as usize] = match step.operation {
                    Operation::MulAdd => a * b + c,
                    Operation::AddMul => c + a * b,
                    Operation::MulSub => a * b - c,
                    Operation::SubMul => c - a * b,
                    Operation::MulAddMul => a * b + c * d,
                    Operation::MulSubMul => a * b - c * d,
                    Operation::Plain(Kind::Add) => a + b,
                    Operation::Plain(Kind::Sub) => a - b,
                    Operation::Plain(Kind::Mul) => a * b,
                    Operation::Plain(Kind::Div) => a / b,
                    Operation::Plain(Kind::Neg) => -a,
                    Operation::Plain(Kind::Sign) => sign(a),
                    Operation::Plain(Kind::Call(f)) => f.value(a),
                    Operation::Plain(Kind::Least) => Real::min(a, b),
                    Operation::Plain(Kind::Most) => Real::max(a, b),
                };
            }
            done = after;
            out[index] = slots[slot as usize];
        }
    }
}

/// Runs the states from `start`, `width` of `len`, with the widest registers of this processor.
/// Sums and products keep their rounding, so the bits are those of any other.
#[multiversion::multiversion(targets("x86_64+avx2"))]
fn tile(evaluator: &Evaluator, slots: &mut [Lane], [start, width, len]: [usize; 3], out: &mut [f64]) {
    let mut pending = evaluator.outputs.iter().peekable();
    for after in 0..=evaluator.steps.len() {
        if let Some(step) = after.checked_sub(1).map(|at| &evaluator.steps[at]) {
            step.run(slots, width);
        }
        while let Some(&(_, slot, index)) = pending.next_if(|(step, _, _)| *step <= after) {
            let from = index * len + start;
            out[from..from + width].copy_from_slice(&slots[slot as usize].0[..width]);
        }
    }
}

impl Step {
    /// All states of a tile; of functions and choices, `width` states.
    #[inline(always)]
    fn run(&self, slots: &mut [Lane], width: usize) {
        match self.operation {
            Operation::MulAdd => self.each(slots, |[a, b, c, _]| a * b + c),
            Operation::AddMul => self.each(slots, |[a, b, c, _]| c + a * b),
            Operation::MulSub => self.each(slots, |[a, b, c, _]| a * b - c),
            Operation::SubMul => self.each(slots, |[a, b, c, _]| c - a * b),
            Operation::MulAddMul => self.each(slots, |[a, b, c, d]| a * b + c * d),
            Operation::MulSubMul => self.each(slots, |[a, b, c, d]| a * b - c * d),
            Operation::Plain(Kind::Add) => self.each(slots, |[a, b]| a + b),
            Operation::Plain(Kind::Sub) => self.each(slots, |[a, b]| a - b),
            Operation::Plain(Kind::Mul) => self.each(slots, |[a, b]| a * b),
            Operation::Plain(Kind::Div) => self.each(slots, |[a, b]| a / b),
            Operation::Plain(Kind::Neg) => self.each(slots, |[a]| -a),
            Operation::Plain(Kind::Sign) => self.each(slots, |[a]| sign(a)),
            Operation::Plain(kind @ (Kind::Call(_) | Kind::Least | Kind::Most)) => {
                elementary(kind, slots, self, width);
            }
        }
    }

    /// Eight states at a time: what does not fit into the registers of the plainest processors
    /// would go through memory once more.
    #[inline(always)]
    fn each<const K: usize>(&self, slots: &mut [Lane], operation: impl Fn([f64; K]) -> f64) {
        for start in (0..LANES).step_by(8) {
            let mut read = [[0.0; K]; 8];
            for k in 0..K {
                let lane = &slots[self.operands[k] as usize].0[start..start + 8];
                for l in 0..8 {
                    read[l][k] = lane[l];
                }
            }
            let out = &mut slots[self.out as usize].0[start..start + 8];
            for l in 0..8 {
                out[l] = operation(read[l]);
            }
        }
    }
}

/// Functions and choices of `width` states. Apart from the loops over plain operations, which it
/// would slow down.
#[inline(never)]
fn elementary(kind: Kind, slots: &mut [Lane], step: &Step, width: usize) {
    let [a, b, ..] = step.operands.map(|slot| slots[slot as usize].0);
    let result = slots[step.out as usize].0.iter_mut().zip(a.into_iter().zip(b)).take(width);
    for (result, (a, b)) in result {
        *result = match kind {
            Kind::Call(f) => f.value(a),
            Kind::Least => Real::min(a, b),
            Kind::Most => Real::max(a, b),
            _ => *result,
        };
    }
}

/// The meaning of `Sign`: what the generated crates' `Scalar::sign` does. By selection, which
/// vectorises, not by branches.
fn sign(x: f64) -> f64 {
    let positive = if x > 0.0 { 1.0 } else { 0.0 };
    let negative = if x < 0.0 { 1.0 } else { 0.0 };
    if x.is_nan() { x } else { positive - negative }
}

fn temporary(operand: &Operand) -> Option<usize> {
    match operand {
        Operand::Temp(t) => Some(*t as usize),
        _ => None,
    }
}

/// Constants and inputs with their slots.
#[derive(Default)]
struct Pinned {
    constants: Vec<(u32, f64)>,
    inputs: Vec<(u32, usize)>,
}

impl Pinned {
    /// Slot of a constant or an input; a new one gets the next. None for a temporary.
    fn slot(&mut self, operand: Operand, slots: &mut Slots) -> Option<u32> {
        match operand {
            Operand::Temp(_) => None,
            Operand::Constant(c) => {
                let known = self.constants.iter().find(|(_, x)| x.to_bits() == c.to_bits()).map(|(slot, _)| *slot);
                Some(known.unwrap_or_else(|| {
                    let slot = slots.take();
                    self.constants.push((slot, c));
                    slot
                }))
            }
            Operand::Input(i) => {
                let known = self.inputs.iter().find(|(_, x)| *x == i as usize).map(|(slot, _)| *slot);
                Some(known.unwrap_or_else(|| {
                    let slot = slots.take();
                    self.inputs.push((slot, i as usize));
                    slot
                }))
            }
        }
    }
}

/// Slots in use and free ones.
#[derive(Default)]
struct Slots {
    free: Vec<u32>,
    count: u32,
}

impl Slots {
    fn take(&mut self) -> u32 {
        self.free.pop().unwrap_or_else(|| {
            self.count += 1;
            self.count - 1
        })
    }

    fn release(&mut self, slot: u32) {
        self.free.push(slot);
    }
}

#[cfg(test)]
mod tests {
    use super::super::Graph;
    use super::*;

    /// Every form of a product within a sum, one that is read twice, and one that is an output too.
    #[test]
    fn products_within_sums_round_by_themselves() {
        let g = Graph::new();
        let (x, y, z) = (g.input(0), g.input(1), g.input(2));
        let twice = x * z;
        let forms = [
            x * y + z,
            z + y * y,
            z * z - y,
            x - y * z,
            x * x + y * y.sign(),
            x * x.sign() - y * z,
            twice + y,
            twice - x,
            twice,
        ];
        let run = Evaluator::new(&Tape::new(&g, &forms));
        let n = LANES + 3;
        let [xs, ys, zs] = [0.37, 1.91, 0.73].map(|f| (0..n).map(|i| (i as f64 * f).cos() / 3.0).collect::<Vec<f64>>());
        let mut out = vec![0.0; forms.len() * n];
        run.run(n, |i| [&xs, &ys, &zs][i], &mut out);
        let mut one = vec![0.0; forms.len()];
        for s in 0..n {
            let (x, y, z) = (xs[s], ys[s], zs[s]);
            let expected = [
                x * y + z,
                z + y * y,
                z * z - y,
                x - y * z,
                x * x + y * sign(y),
                x * sign(x) - y * z,
                x * z + y,
                x * z - x,
                x * z,
            ];
            run.run_one(&[x, y, z], &mut Vec::new(), &mut one);
            for (o, e) in expected.into_iter().enumerate() {
                assert_eq!(out[o * n + s].to_bits(), e.to_bits(), "output {o} of state {s}");
                assert_eq!(one[o].to_bits(), e.to_bits(), "output {o} of state {s} by itself");
            }
        }
    }

    #[test]
    fn a_batch_is_each_state_by_itself() {
        let g = Graph::new();
        let (x, y) = (g.input(0), g.input(1));
        let tape = Tape::new(&g, &[x * y - x / y, g.constant(2.5), y, -(x * x), (x - y).sign()]);
        let run = Evaluator::new(&tape);
        let n = 3 * LANES + 5;
        let xs: Vec<f64> = (0..n).map(|i| i as f64 * 0.37 - 9.0).collect();
        let ys: Vec<f64> = (0..n).map(|i| (i as f64).sin() + 1.5).collect();
        let mut out = vec![0.0; 5 * n];
        run.run(n, |i| if i == 0 { &xs } else { &ys }, &mut out);
        let mut room = Vec::new();
        for s in 0..n {
            let (x, y) = (xs[s], ys[s]);
            let mut one = [0.0; 5];
            run.run_one(&[x, y], &mut room, &mut one);
            assert!((0..5).all(|o| one[o].to_bits() == out[o * n + s].to_bits()), "state {s} by itself");
            let expected = [x * y - x / y, 2.5, y, -(x * x), if x > y { 1.0 } else { -1.0 }];
            for (o, e) in expected.iter().enumerate() {
                assert_eq!(out[o * n + s], *e, "output {o} of state {s}");
            }
        }
    }
}
