//! Compiles a tape to steps with as few memory accesses as possible.

use super::super::tape::{Instruction, Kind, Operand, Tape};

/// Computation of a step from the values in its slots `a b c d` and from `last`, the result of the
/// previous step. Products that are read once are computed where they are read, with their own
/// rounding; a result that only the next step reads is never stored in memory.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Operation {
    /// `a + b`
    Add,
    /// `a - b`
    Sub,
    /// `a b`
    Mul,
    /// `a / b`
    Div,
    /// `-a`
    Neg,
    /// `sign(a)`
    Sign,
    /// `a`
    Copy,
    /// `a b + c`
    MulAdd,
    /// `a b - c`
    MulSub,
    /// `c - a b`
    SubMul,
    /// `a b + c d`
    MulAddMul,
    /// `a b - c d`
    MulSubMul,
    /// `last`
    Again,
    /// `last + a`
    LastAdd,
    /// `last - a`
    LastSub,
    /// `a - last`
    SubLast,
    /// `last a`
    LastMul,
    /// `-last`
    LastNeg,
    /// `last + a b`
    LastAddMul,
    /// `last - a b`
    LastSubMul,
    /// `a b - last`
    MulSubLast,
    /// `last a + b`
    LastMulAdd,
    /// `last a - b`
    LastMulSub,
    /// `b - last a`
    SubLastMul,
    /// `last a + b c`
    LastMulAddMul,
    /// `last a - b c`
    LastMulSubMul,
    /// `b c - last a`
    MulSubLastMul,
    /// Function of `a`, or choice of `a` and `b`: entry `c` of [`Program::elementary`].
    Elementary,
}

impl Operation {
    /// Number of slots that it reads.
    fn reads(self) -> usize {
        use Operation as O;
        match self {
            O::Again | O::LastNeg => 0,
            O::Neg | O::Sign | O::Copy | O::LastAdd | O::LastSub | O::SubLast | O::LastMul => 1,
            O::Add | O::Sub | O::Mul | O::Div | O::LastAddMul | O::LastSubMul | O::MulSubLast => 2,
            O::LastMulAdd | O::LastMulSub | O::SubLastMul | O::Elementary => 2,
            O::MulAdd | O::MulSub | O::SubMul | O::LastMulAddMul | O::LastMulSubMul | O::MulSubLastMul => 3,
            O::MulAddMul | O::MulSubMul => 4,
        }
    }
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Step {
    pub(super) operation: Operation,
    pub(super) operands: [u32; 4],
    /// Slot in which the result is stored, or [`NOWHERE`].
    pub(super) keep: u32,
    /// Output row in which the result is stored, or [`NOWHERE`].
    pub(super) row: u32,
}

/// Marker for no slot or no row.
pub(super) const NOWHERE: u32 = u32::MAX;

/// Steps in order, and the initial content of slots.
#[derive(Debug, Clone, Default)]
pub(super) struct Program {
    pub(super) steps: Vec<Step>,
    pub(super) constants: Vec<(u32, f64)>,
    pub(super) inputs: Vec<(u32, usize)>,
    /// Functions and choices, indexed by [`Operation::Elementary`].
    pub(super) elementary: Vec<Kind>,
    /// Outputs that are constant.
    pub(super) constant_outputs: Vec<(usize, f64)>,
    pub(super) slots: usize,
    pub(super) output_count: usize,
}

/// A value, or a product of two values.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Term {
    Value(Operand),
    Product(Operand, Operand),
}

/// A fused step before slots are assigned.
#[derive(Debug)]
struct Fused {
    /// Step of the tape with which it ends.
    at: usize,
    kind: Kind,
    left: Term,
    right: Term,
}

impl Fused {
    fn operands(&self) -> impl Iterator<Item = Operand> {
        let unary = self.kind.is_unary();
        let parts = |term: Term| match term {
            Term::Value(a) => [Some(a), None],
            Term::Product(a, b) => [Some(a), Some(b)],
        };
        let right = if unary { [None, None] } else { parts(self.right) };
        parts(self.left).into_iter().chain(right).flatten()
    }

    /// Operation and the operands in slots, if `last` is the previous value.
    fn operation(&self, last: Option<Operand>) -> (Operation, Vec<Operand>) {
        let is_last = |operand: Operand| Some(operand) == last;
        let reads = self.operands().filter(|&operand| is_last(operand)).count();
        // If read twice, it is taken from its slot.
        let here = |operand: Operand| reads == 1 && is_last(operand);
        let factor = |term: Term| match term {
            Term::Product(a, b) if here(a) => Some(b),
            Term::Product(a, b) if here(b) => Some(a),
            _ => None,
        };
        use {Operation as O, Term::Product as P, Term::Value as V};
        let is_here = |term: Term| matches!(term, V(a) if here(a));
        match (self.kind, self.left, self.right) {
            (Kind::Add, l, r) => self.sum(l, r, is_here(l), is_here(r), factor(l), factor(r)),
            (Kind::Sub, V(_), V(b)) if is_here(self.left) => (O::LastSub, vec![b]),
            (Kind::Sub, V(a), V(_)) if is_here(self.right) => (O::SubLast, vec![a]),
            (Kind::Sub, V(a), V(b)) => (O::Sub, vec![a, b]),
            (Kind::Sub, V(_), P(c, d)) if is_here(self.left) => (O::LastSubMul, vec![c, d]),
            (Kind::Sub, V(a), P(c, d)) => match factor(self.right) {
                Some(f) => (O::SubLastMul, vec![f, a]),
                None => (O::SubMul, vec![c, d, a]),
            },
            (Kind::Sub, P(a, b), V(_)) if is_here(self.right) => (O::MulSubLast, vec![a, b]),
            (Kind::Sub, P(a, b), V(c)) => match factor(self.left) {
                Some(f) => (O::LastMulSub, vec![f, c]),
                None => (O::MulSub, vec![a, b, c]),
            },
            (Kind::Sub, P(a, b), P(c, d)) => match (factor(self.left), factor(self.right)) {
                (Some(f), _) => (O::LastMulSubMul, vec![f, c, d]),
                (_, Some(f)) => (O::MulSubLastMul, vec![f, a, b]),
                _ => (O::MulSubMul, vec![a, b, c, d]),
            },
            (Kind::Mul, V(_), V(b)) if is_here(self.left) => (O::LastMul, vec![b]),
            (Kind::Mul, V(a), V(_)) if is_here(self.right) => (O::LastMul, vec![a]),
            (Kind::Mul, V(a), V(b)) => (O::Mul, vec![a, b]),
            (Kind::Neg, V(_), _) if is_here(self.left) => (O::LastNeg, vec![]),
            (kind, ..) => {
                let operation = match kind {
                    Kind::Div => O::Div,
                    Kind::Neg => O::Neg,
                    Kind::Sign => O::Sign,
                    _ => O::Elementary,
                };
                (operation, self.operands().collect())
            }
        }
    }

    /// Operation of a sum, whose terms may be exchanged.
    fn sum(
        &self,
        left: Term,
        right: Term,
        left_here: bool,
        right_here: bool,
        left_factor: Option<Operand>,
        right_factor: Option<Operand>,
    ) -> (Operation, Vec<Operand>) {
        use {Operation as O, Term::Product as P, Term::Value as V};
        if right_here || (right_factor.is_some() && !left_here) {
            let swapped = (left_here, left_factor);
            if !swapped.0 && swapped.1.is_none() {
                return self.sum(right, left, right_here, left_here, right_factor, left_factor);
            }
        }
        match (left, right, left_factor) {
            (V(_), V(b), _) if left_here => (O::LastAdd, vec![b]),
            (V(_), P(c, d), _) if left_here => (O::LastAddMul, vec![c, d]),
            (P(..), V(c), Some(f)) => (O::LastMulAdd, vec![f, c]),
            (P(..), P(c, d), Some(f)) => (O::LastMulAddMul, vec![f, c, d]),
            (V(a), V(b), _) => (O::Add, vec![a, b]),
            (V(c), P(a, b), _) | (P(a, b), V(c), None) => (O::MulAdd, vec![a, b, c]),
            (P(a, b), P(c, d), None) => (O::MulAddMul, vec![a, b, c, d]),
        }
    }
}

/// Fuses steps in this order: products that are read once become part of their readers.
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
    let mut inside = vec![false; tape.code.len()];
    let mut steps: Vec<Fused> = Vec::with_capacity(order.len());
    for &at in order {
        let Instruction { kind, a, b } = tape.code[at];
        let mut term = |operand: Operand| match product(operand) {
            Some(t) if matches!(kind, Kind::Add | Kind::Sub) => {
                inside[t] = true;
                Term::Product(tape.code[t].a, tape.code[t].b)
            }
            _ => Term::Value(operand),
        };
        let (left, right) = (term(a), term(b));
        steps.push(Fused { at, kind, left, right });
    }
    steps.retain(|step| !inside[step.at]);
    steps
}

impl Program {
    /// Assigns a slot to every operand. `order`: steps of the tape, readers after what they read.
    pub(super) fn new(tape: &Tape, wanted: &[usize], order: &[usize]) -> Self {
        let roots: Vec<Operand> = wanted.iter().map(|&o| tape.outputs[o]).collect();
        let order = fused(tape, order, &roots);
        // Constants and inputs are loaded once, before the first step: they get their slots before
        // any temporary does.
        let mut slots = Slots::default();
        let mut pinned = Pinned::default();
        for operand in order.iter().flat_map(Fused::operands) {
            pinned.slot(operand, &mut slots);
        }
        let mut program = Self { output_count: roots.len(), ..Self::default() };
        let mut rows: Vec<Vec<usize>> = vec![Vec::new(); tape.code.len()];
        let mut copies = Vec::new();
        for (row, output) in roots.iter().enumerate() {
            match *output {
                Operand::Temp(t) => rows[t as usize].push(row),
                Operand::Constant(c) => program.constant_outputs.push((row, c)),
                Operand::Input(_) => copies.extend(pinned.slot(*output, &mut slots).map(|slot| (row, slot))),
            }
        }
        let chain = chained(&order);
        // Last reader of each temporary's slot, by its position in the order.
        let mut last: Vec<Option<usize>> = vec![None; tape.code.len()];
        for (place, (_, operands)) in chain.iter().enumerate() {
            operands.iter().filter_map(temporary).for_each(|t| last[t] = Some(place));
        }
        let mut place = vec![0u32; tape.code.len()];
        for (now, (Fused { at, kind, .. }, (operation, operands))) in order.iter().zip(chain).enumerate() {
            let mut read = [0; 4];
            for (slot, operand) in read.iter_mut().zip(&operands) {
                *slot = match temporary(operand) {
                    Some(t) => place[t],
                    None => pinned.slot(*operand, &mut slots).unwrap_or(0),
                };
            }
            if operation == Operation::Elementary {
                read[2] = program.elementary.len() as u32;
                program.elementary.push(*kind);
            }
            for (k, operand) in operands.iter().enumerate() {
                if let Some(t) = temporary(operand)
                    && last[t] == Some(now)
                    && !operands[..k].contains(operand)
                {
                    slots.release(place[t]);
                }
            }
            let keep = match last[*at] {
                Some(_) => slots.take(),
                None => NOWHERE,
            };
            place[*at] = keep;
            let mut rows = rows[*at].iter().map(|&row| row as u32);
            program.steps.push(Step { operation, operands: read, keep, row: rows.next().unwrap_or(NOWHERE) });
            program.steps.extend(rows.map(|row| Step::output(Operation::Again, 0, row)));
        }
        program.steps.extend(copies.into_iter().map(|(row, slot)| Step::output(Operation::Copy, slot, row as u32)));
        Self { constants: pinned.constants, inputs: pinned.inputs, slots: slots.count as usize, ..program }
    }

    /// Number of values per state that are loaded or stored, and number of slots.
    pub(super) fn traffic(&self) -> (usize, usize) {
        let of = |step: &Step| step.operation.reads() + usize::from(step.keep != NOWHERE);
        (self.steps.iter().map(of).sum(), self.slots)
    }
}

impl Step {
    /// Step that stores a value in an output row.
    fn output(operation: Operation, slot: u32, row: u32) -> Self {
        Self { operation, operands: [slot; 4], keep: NOWHERE, row }
    }
}

/// Operation of each step and its operands in slots, given the previous step.
fn chained(order: &[Fused]) -> Vec<(Operation, Vec<Operand>)> {
    let before = |now: usize| now.checked_sub(1).map(|at| Operand::Temp(order[at].at as u32));
    order.iter().enumerate().map(|(now, step)| step.operation(before(now))).collect()
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
    /// Slot of a constant or an input, allocated if new; `None` for a temporary.
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

/// Allocator of slots.
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
