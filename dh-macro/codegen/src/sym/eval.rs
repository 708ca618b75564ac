//! Runs a tape on f64, many states at a time; this defines the meaning of a tape.

mod program;

use program::{NOWHERE, Operation, Program};

use super::order::just_in_time;
use super::tape::{Kind, Tape};
use crate::elementary::Real;
use crate::runtime::dispatch::{Level, Numbers, Set, Work};

/// An input for all states of a batch.
#[derive(Debug, Clone, Copy)]
pub enum Column<'a> {
    /// One value per state.
    Each(&'a [f64]),
    /// The same value for all states.
    Same(f64),
    /// Sine of each state's angle plus this offset, rad.
    Sine(&'a [f64], f64),
    /// Cosine of each state's angle plus this offset, rad.
    Cosine(&'a [f64], f64),
}

/// A tape compiled for execution.
#[derive(Debug, Clone)]
pub struct Evaluator {
    program: Program,
}

impl Evaluator {
    /// Evaluates all outputs of a tape.
    pub fn new(tape: &Tape) -> Self {
        let all: Vec<usize> = (0..tape.outputs.len()).collect();
        Self::of(tape, &all)
    }

    /// Evaluates some outputs of a tape, in this order. Of two orders of the steps it uses the one
    /// with fewer memory accesses.
    pub fn of(tape: &Tape, wanted: &[usize]) -> Self {
        let late = Program::new(tape, wanted, &just_in_time(tape, wanted));
        let in_order = Program::new(tape, wanted, &(0..tape.code.len()).collect::<Vec<_>>());
        Self { program: if late.traffic() < in_order.traffic() { late } else { in_order } }
    }

    /// Number of output values per state.
    pub fn outputs(&self) -> usize {
        self.program.output_count
    }

    /// Runs `len` states with the widest registers of the processor: input `i` is `inputs(i)`,
    /// output `o` of state `s` is stored in `out[o * len + s]`.
    ///
    /// # Panics
    /// If `out` is shorter than `outputs() * len` or an input column than `len`.
    pub fn run<'a>(&self, len: usize, inputs: impl Fn(usize) -> Column<'a>, out: &mut [f64]) {
        self.run_on(Level::highest(), len, inputs, out);
    }

    /// Does the same with a given instruction set; the results are bit-identical.
    ///
    /// # Panics
    /// Like [`Evaluator::run`].
    pub fn run_on<'a>(&self, level: Level, len: usize, inputs: impl Fn(usize) -> Column<'a>, out: &mut [f64]) {
        let program = &self.program;
        assert!(out.len() >= self.outputs() * len, "{} values do not fit into {}", self.outputs() * len, out.len());
        for &(row, value) in &program.constant_outputs {
            out[row * len..(row + 1) * len].fill(value);
        }
        let columns: Vec<Column<'a>> = program.inputs.iter().map(|&(_, index)| inputs(index)).collect();
        level.run(Batch { program, columns: &columns, len, out });
    }

    /// Runs one state: `inputs[i]` is input `i`, output `o` is stored in `out[o]`. `room` is
    /// working memory that calls may share; its content on entry does not matter. Results are
    /// bit-identical to those of [`Evaluator::run`].
    ///
    /// # Panics
    /// If `out` is shorter than `outputs()` or `inputs` than the highest input that is read.
    pub fn run_one(&self, inputs: &[f64], room: &mut Vec<f64>, out: &mut [f64]) {
        let program = &self.program;
        if room.len() < program.slots {
            room.resize(program.slots, 0.0);
        }
        for &(row, value) in &program.constant_outputs {
            out[row] = value;
        }
        for &(slot, value) in &program.constants {
            room[slot as usize] = value;
        }
        for &(slot, index) in &program.inputs {
            room[slot as usize] = inputs[index];
        }
        tile::<f64, true>(program, &mut room[..program.slots], Place { start: 0, width: 1, len: 1 }, out);
    }
}

/// A batch of states that a program is run on.
struct Batch<'a> {
    program: &'a Program,
    columns: &'a [Column<'a>],
    len: usize,
    out: &'a mut [f64],
}

impl Work for Batch<'_> {
    type Result = ();

    /// Runs wide tiles, which hide the cost of selecting operations, then the rest in tiles of one
    /// register.
    #[inline(always)]
    fn run<S: Set>(self) {
        let whole = self.len - self.len % S::Many::WIDTH;
        if whole > 0 {
            tiles::<S::Many>(self.program, self.columns, [0, whole, self.len], self.out);
        }
        if whole < self.len {
            tiles::<S::One>(self.program, self.columns, [whole, self.len, self.len], self.out);
        }
    }
}

/// Position of a tile's states within a batch.
#[derive(Clone, Copy)]
struct Place {
    start: usize,
    width: usize,
    len: usize,
}

/// Runs the states `from` to `to` of `len`, tile by tile.
#[inline(always)]
fn tiles<V: Numbers>(program: &Program, columns: &[Column<'_>], [from, to, len]: [usize; 3], out: &mut [f64]) {
    let mut slots: Vec<V> = vec![V::default(); program.slots];
    for &(slot, value) in &program.constants {
        slots[slot as usize] = V::constant(value);
    }
    for (&(slot, _), column) in program.inputs.iter().zip(columns) {
        if let Column::Same(value) = column {
            slots[slot as usize] = V::constant(*value);
        }
    }
    let turns = turns(program, columns);
    let mut start = from;
    while start < to {
        let width = V::WIDTH.min(to - start);
        for (&(slot, _), column) in program.inputs.iter().zip(columns) {
            if let Column::Each(values) = column {
                slots[slot as usize] = part(&values[start..start + width]);
            }
        }
        for turn in &turns {
            let angle = part::<V>(&turn.angles[start..start + width]) + V::constant(turn.offset);
            let ([sin], [cos]) = V::sin_cos_all(&[angle]);
            for (slot, value) in turn.slots.into_iter().zip([sin, cos]) {
                if let Some(slot) = slot {
                    slots[slot] = value;
                }
            }
        }
        let place = Place { start, width, len };
        match width == V::WIDTH {
            true => tile::<V, true>(program, &mut slots, place, out),
            false => tile::<V, false>(program, &mut slots, place, out),
        }
        start += width;
    }
}

/// An angle whose sine or cosine is read, with their slots.
struct Turn<'a> {
    angles: &'a [f64],
    offset: f64,
    slots: [Option<usize>; 2],
}

/// Angles without duplicates.
fn turns<'a>(program: &Program, columns: &[Column<'a>]) -> Vec<Turn<'a>> {
    let mut turns: Vec<Turn<'a>> = Vec::new();
    for (&(slot, _), column) in program.inputs.iter().zip(columns) {
        let (angles, offset, which) = match *column {
            Column::Sine(angles, offset) => (angles, offset, 0),
            Column::Cosine(angles, offset) => (angles, offset, 1),
            _ => continue,
        };
        let same = |turn: &&mut Turn<'_>| core::ptr::eq(turn.angles, angles) && turn.offset == offset;
        match turns.iter_mut().find(same) {
            Some(turn) => turn.slots[which] = Some(slot as usize),
            None => {
                let mut slots = [None; 2];
                slots[which] = Some(slot as usize);
                turns.push(Turn { angles, offset, slots });
            }
        }
    }
    turns
}

/// Loads the available numbers, padded with zeros.
#[inline(always)]
fn part<V: Numbers>(values: &[f64]) -> V {
    if values.len() == V::WIDTH {
        return V::load(values);
    }
    let mut padded = [0.0; MOST];
    padded[..values.len()].copy_from_slice(values);
    V::load(&padded)
}

/// Upper bound of the width of any tile.
const MOST: usize = 64;

/// Runs one tile: every step on the values of all its states. The result of a step stays in
/// registers for the next one, and is stored in memory only if a later one reads it.
#[inline(always)]
fn tile<V: Numbers, const WHOLE: bool>(program: &Program, slots: &mut [V], place: Place, out: &mut [f64]) {
    use Operation as O;
    let mut last = V::default();
    for step in &program.steps {
        let at = |k: usize| slots[step.operands[k] as usize];
        last = match step.operation {
            O::Add => at(0) + at(1),
            O::Sub => at(0) - at(1),
            O::Mul => at(0) * at(1),
            O::Div => at(0) / at(1),
            O::Neg => -at(0),
            O::Sign => at(0).sign(),
            O::Copy => at(0),
            O::MulAdd => at(0) * at(1) + at(2),
            O::MulSub => at(0) * at(1) - at(2),
            O::SubMul => at(2) - at(0) * at(1),
            O::MulAddMul => at(0) * at(1) + at(2) * at(3),
            O::MulSubMul => at(0) * at(1) - at(2) * at(3),
            O::Again => last,
            O::LastAdd => last + at(0),
            O::LastSub => last - at(0),
            O::SubLast => at(0) - last,
            O::LastMul => last * at(0),
            O::LastNeg => -last,
            O::LastAddMul => last + at(0) * at(1),
            O::LastSubMul => last - at(0) * at(1),
            O::MulSubLast => at(0) * at(1) - last,
            O::LastMulAdd => last * at(0) + at(1),
            O::LastMulSub => last * at(0) - at(1),
            O::SubLastMul => at(1) - last * at(0),
            O::LastMulAddMul => last * at(0) + at(1) * at(2),
            O::LastMulSubMul => last * at(0) - at(1) * at(2),
            O::MulSubLastMul => at(1) * at(2) - last * at(0),
            O::Elementary => elementary(program, step.operands[2], [at(0), at(1)], place.width),
        };
        if let Some(slot) = slots.get_mut(step.keep as usize) {
            *slot = last;
        }
        if step.row != NOWHERE {
            let from = step.row as usize * place.len + place.start;
            let to = &mut out[from..from + if WHOLE { V::WIDTH } else { place.width }];
            if WHOLE {
                last.store(to);
            } else {
                let mut all = [0.0; MOST];
                last.store(&mut all);
                to.copy_from_slice(&all[..place.width]);
            }
        }
    }
}

/// Evaluates functions and choices of `width` states. Separate from the plain operations, which it
/// would slow down.
#[inline(always)]
fn elementary<V: Numbers>(program: &Program, which: u32, [a, b]: [V; 2], width: usize) -> V {
    let (mut x, mut y) = ([0.0; MOST], [0.0; MOST]);
    a.store(&mut x);
    b.store(&mut y);
    one_by_one(program.elementary[which as usize], &mut x[..width], &y);
    V::load(&x)
}

#[inline(never)]
fn one_by_one(kind: Kind, x: &mut [f64], y: &[f64]) {
    for (x, &y) in x.iter_mut().zip(y) {
        *x = match kind {
            Kind::Call(f) => f.value(*x),
            Kind::Least => Real::min(*x, y),
            Kind::Most => Real::max(*x, y),
            _ => *x,
        };
    }
}

#[cfg(test)]
mod tests {
    use super::super::Graph;
    use super::*;
    use crate::runtime::Scalar;

    /// All forms of a product within a sum, including one read twice and one that is also an
    /// output.
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
        let n = 64 + 3;
        let [xs, ys, zs] = [0.37, 1.91, 0.73].map(|f| (0..n).map(|i| (i as f64 * f).cos() / 3.0).collect::<Vec<f64>>());
        let mut out = vec![0.0; forms.len() * n];
        run.run(n, |i| Column::Each([&xs, &ys, &zs][i]), &mut out);
        let mut one = vec![0.0; forms.len()];
        for s in 0..n {
            let (x, y, z) = (xs[s], ys[s], zs[s]);
            let expected = [
                x * y + z,
                z + y * y,
                z * z - y,
                x - y * z,
                x * x + y * Scalar::sign(y),
                x * Scalar::sign(x) - y * z,
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
        let n = 3 * 64 + 5;
        let xs: Vec<f64> = (0..n).map(|i| i as f64 * 0.37 - 9.0).collect();
        let ys: Vec<f64> = (0..n).map(|i| (i as f64).sin() + 1.5).collect();
        let mut out = vec![0.0; 5 * n];
        run.run(n, |i| Column::Each(if i == 0 { &xs } else { &ys }), &mut out);
        for level in [Level::Build, Level::V3, Level::V4] {
            let mut again = vec![0.0; 5 * n];
            run.run_on(level, n, |i| Column::Each(if i == 0 { &xs } else { &ys }), &mut again);
            assert!(again.iter().zip(&out).all(|(a, b)| a.to_bits() == b.to_bits()), "{level:?}");
        }
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
