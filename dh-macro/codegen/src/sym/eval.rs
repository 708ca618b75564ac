//! Runs a tape on f64, many states at a time: the meaning of a tape.

use super::order::just_in_time;
use super::tape::{Instruction, Kind, Operand, Tape};
use crate::elementary::Real;

/// States that are carried through the tape together.
pub const LANES: usize = 64;

type Lane = [f64; LANES];

#[derive(Debug, Clone, Copy)]
struct Step {
    kind: Kind,
    a: u32,
    b: u32,
    out: u32,
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
        let mut slots = Slots::default();
        let mut constants: Vec<(u32, f64)> = Vec::new();
        let mut inputs: Vec<(u32, usize)> = Vec::new();
        let mut pinned = |operand: Operand, slots: &mut Slots| -> Option<u32> {
            match operand {
                Operand::Temp(_) => None,
                Operand::Constant(c) => Some(match constants.iter().find(|(_, x)| x.to_bits() == c.to_bits()) {
                    Some((slot, _)) => *slot,
                    None => {
                        let slot = slots.take();
                        constants.push((slot, c));
                        slot
                    }
                }),
                Operand::Input(i) => Some(match inputs.iter().find(|(_, x)| *x == i as usize) {
                    Some((slot, _)) => *slot,
                    None => {
                        let slot = slots.take();
                        inputs.push((slot, i as usize));
                        slot
                    }
                }),
            }
        };
        // These are loaded once, before the first step: they get their slots before any temporary
        // does.
        for operand in order.iter().flat_map(|&at| [tape.code[at].a, tape.code[at].b]).chain(roots.iter().copied()) {
            pinned(operand, &mut slots);
        }
        // Last reader of each temporary (by its place in the order), so that its slot can be used
        // again.
        let mut last = vec![0usize; tape.code.len()];
        for (place, &at) in order.iter().enumerate() {
            for operand in [tape.code[at].a, tape.code[at].b] {
                if let Operand::Temp(t) = operand {
                    last[t as usize] = place;
                }
            }
        }
        let mut at_step: Vec<Vec<usize>> = vec![Vec::new(); tape.code.len()];
        let mut outputs = Vec::with_capacity(roots.len());
        for (index, output) in roots.iter().enumerate() {
            match output {
                Operand::Temp(t) => at_step[*t as usize].push(index),
                other => {
                    if let Some(slot) = pinned(*other, &mut slots) {
                        outputs.push((0, slot, index));
                    }
                }
            }
        }
        let mut place = vec![0u32; tape.code.len()];
        let mut steps = Vec::with_capacity(tape.code.len());
        for (now, &at) in order.iter().enumerate() {
            let Instruction { kind, a, b } = &tape.code[at];
            let mut slot_of = |operand: &Operand, slots: &mut Slots| match operand {
                Operand::Temp(t) => place[*t as usize],
                other => pinned(*other, slots).unwrap_or(0),
            };
            let (sa, sb) = (slot_of(a, &mut slots), slot_of(b, &mut slots));
            for (k, operand) in [a, b].into_iter().enumerate() {
                if let Operand::Temp(t) = operand
                    && last[*t as usize] == now
                    && !(k == 1 && a == b)
                {
                    slots.release(place[*t as usize]);
                }
            }
            let out = slots.take();
            place[at] = out;
            steps.push(Step { kind: *kind, a: sa, b: sb, out });
            outputs.extend(at_step[at].iter().map(|&index| (now + 1, out, index)));
            if last[at] == 0 && !at_step[at].is_empty() {
                slots.release(out); // an output that nothing else reads
            }
        }
        outputs.sort_unstable();
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
        let mut slots: Vec<Lane> = vec![[0.0; LANES]; self.slots];
        for &(slot, value) in &self.constants {
            slots[slot as usize] = [value; LANES];
        }
        let mut start = 0;
        while start < len {
            let width = LANES.min(len - start);
            for &(slot, index) in &self.inputs {
                slots[slot as usize][..width].copy_from_slice(&inputs(index)[start..start + width]);
            }
            let mut pending = self.outputs.iter().peekable();
            let mut write = |after: usize, slots: &[Lane]| {
                while let Some(&(_, slot, index)) = pending.next_if(|(step, _, _)| *step <= after) {
                    let from = index * len + start;
                    out[from..from + width].copy_from_slice(&slots[slot as usize][..width]);
                }
            };
            write(0, &slots);
            for (at, step) in self.steps.iter().enumerate() {
                if step.kind.is_elementary() {
                    elementary(&mut slots, step, width);
                } else {
                    // Whole lanes, which stay in registers: no arm may read one by an index that is
                    // not known beforehand.
                    let (a, b) = (slots[step.a as usize], slots[step.b as usize]);
                    let result = &mut slots[step.out as usize];
                    match step.kind {
                        Kind::Add => (0..LANES).for_each(|l| result[l] = a[l] + b[l]),
                        Kind::Sub => (0..LANES).for_each(|l| result[l] = a[l] - b[l]),
                        Kind::Mul => (0..LANES).for_each(|l| result[l] = a[l] * b[l]),
                        Kind::Div => (0..LANES).for_each(|l| result[l] = a[l] / b[l]),
                        Kind::Neg => (0..LANES).for_each(|l| result[l] = -a[l]),
                        Kind::Sign => (0..LANES).for_each(|l| result[l] = sign(a[l])),
                        Kind::Call(_) | Kind::Least | Kind::Most => {}
                    }
                }
                write(at + 1, &slots);
            }
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
                let (a, b) = (slots[step.a as usize], slots[step.b as usize]);
                slots[step.out as usize] = match step.kind {
                    Kind::Add => a + b,
                    Kind::Sub => a - b,
                    Kind::Mul => a * b,
                    Kind::Div => a / b,
                    Kind::Neg => -a,
                    Kind::Sign => sign(a),
                    Kind::Call(f) => f.value(a),
                    Kind::Least => Real::min(a, b),
                    Kind::Most => Real::max(a, b),
                };
            }
            done = after;
            out[index] = slots[slot as usize];
        }
    }
}

/// Functions and choices of `width` states. Apart from the loop over plain operations, which it
/// would slow down.
#[inline(never)]
fn elementary(slots: &mut [Lane], step: &Step, width: usize) {
    let (a, b) = (slots[step.a as usize], slots[step.b as usize]);
    let result = slots[step.out as usize].iter_mut().zip(a.into_iter().zip(b)).take(width);
    for (result, (a, b)) in result {
        *result = match step.kind {
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
