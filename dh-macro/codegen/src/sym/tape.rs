//! Lowers the roots of a graph to a straight-line program, from which text is printed, or which is
//! run.

use std::collections::BTreeMap;

use super::call::Call;
use super::factor::factored;
use super::formula::Formula;
use super::graph::{Ex, Graph, Op};
use super::signs::settled;

/// Source of an operand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Operand {
    /// A number.
    Constant(f64),
    /// Input with this index.
    Input(u32),
    /// Result of the instruction with this index.
    Temp(u32),
}

/// Operation of an instruction on its operands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// `a + b`
    Add,
    /// `a - b`
    Sub,
    /// `a * b`
    Mul,
    /// `a / b`
    Div,
    /// `-a` (`b` is ignored)
    Neg,
    /// `sign(a)` (`b` is ignored)
    Sign,
    /// Function of `a` (`b` is ignored)
    Call(Call),
    /// Minimum of two.
    Least,
    /// Maximum of two.
    Most,
}

impl Kind {
    /// Whether `b` is ignored.
    pub fn is_unary(self) -> bool {
        matches!(self, Self::Neg | Self::Sign | Self::Call(_))
    }

    /// Whether it requires more than [`crate::runtime::Scalar`].
    pub fn is_elementary(self) -> bool {
        matches!(self, Self::Call(_) | Self::Least | Self::Most)
    }
}

/// One step; its result is the temporary with the step's own index.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Instruction {
    /// Operation.
    pub kind: Kind,
    /// First operand.
    pub a: Operand,
    /// Second operand; repeats the first for unary operations.
    pub b: Operand,
}

/// A named section of a tape.
#[derive(Debug, Clone, PartialEq)]
pub struct Section {
    /// Index of its first instruction.
    pub start: usize,
    /// Description of the section's result.
    pub title: String,
}

/// Numbers of operations of a tape. A change of sign counts as an addition, a division as a
/// multiplication; functions and choices are not counted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct OperationCount {
    /// Multiplications and divisions.
    pub mul: usize,
    /// Additions, subtractions and changes of sign.
    pub add: usize,
}

impl OperationCount {
    /// Sum of both.
    pub fn total(self) -> usize {
        self.mul + self.add
    }
}

/// A straight-line program without branches.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Tape {
    /// Steps; operands refer to earlier steps only.
    pub code: Vec<Instruction>,
    /// Results in the order of the roots.
    pub outputs: Vec<Operand>,
    /// Textbook names of some of the steps.
    pub labels: Vec<Option<String>>,
    /// Sections, ascending, the first at 0.
    pub sections: Vec<Section>,
    /// Formulas of the description's numbers, by their bits.
    pub formulas: BTreeMap<u64, Formula>,
}

impl Tape {
    /// Lowers the roots: nodes that are not needed are left out, and products with a common factor
    /// are combined.
    pub fn new(graph: &Graph, roots: &[Ex<'_>]) -> Self {
        let roots: Vec<_> = roots.iter().map(|r| r.node()).collect();
        let (graph, roots) = factored(graph, &roots);
        let (graph, roots) = settled(&graph, &roots);
        Self::lower(&graph, &roots)
    }

    /// Number of operations that the roots will need, without changes of sign: a quick estimate for
    /// searches.
    pub fn estimate(graph: &Graph, roots: &[Ex<'_>]) -> usize {
        let roots: Vec<_> = roots.iter().map(|r| r.node()).collect();
        let (graph, roots) = factored(graph, &roots);
        let tape = Self::lower(&graph, &roots);
        tape.code.iter().filter(|step| !(step.kind.is_unary() || step.kind.is_elementary())).count()
    }

    fn lower(graph: &Graph, roots: &[super::Node]) -> Self {
        let mut needed = vec![false; graph.len()];
        let mut stack = roots.to_vec();
        while let Some(node) = stack.pop() {
            if !core::mem::replace(&mut needed[node.index()], true) {
                stack.extend(graph.op(node).operands());
            }
        }
        let headings = graph.sections();
        let mut heading = headings.iter().peekable();
        let mut place: Vec<Option<Operand>> = vec![None; graph.len()];
        let mut tape = Self::default();
        for index in (0..graph.len()).filter(|&i| needed[i]) {
            let node = super::Node(index as u32);
            while let Some((_, title)) = heading.next_if(|(start, _)| *start <= index) {
                let start = tape.code.len();
                tape.sections.retain(|s: &Section| s.start < start);
                tape.sections.push(Section { start, title: title.clone() });
            }
            let at = |n: super::Node| place[n.index()].unwrap_or(Operand::Constant(f64::NAN));
            let (kind, a, b) = match graph.op(node) {
                Op::Constant(bits) => {
                    place[index] = Some(Operand::Constant(f64::from_bits(bits)));
                    tape.formulas.extend(graph.formula(bits).map(|formula| (bits, formula)));
                    continue;
                }
                Op::Input(i) => {
                    place[index] = Some(Operand::Input(i));
                    continue;
                }
                Op::Add(a, b) => (Kind::Add, a, b),
                Op::Sub(a, b) => (Kind::Sub, a, b),
                Op::Mul(a, b) => (Kind::Mul, a, b),
                Op::Div(a, b) => (Kind::Div, a, b),
                Op::Neg(a) => (Kind::Neg, a, a),
                Op::Sign(a) => (Kind::Sign, a, a),
                Op::Call(f, a) => (Kind::Call(f), a, a),
                Op::Least(a, b) => (Kind::Least, a, b),
                Op::Most(a, b) => (Kind::Most, a, b),
            };
            let (a, b) = (at(a), at(b));
            place[index] = Some(Operand::Temp(tape.code.len() as u32));
            tape.code.push(Instruction { kind, a, b });
            tape.labels.push(graph.name_of(node));
        }
        if tape.sections.first().is_none_or(|s| s.start > 0) {
            tape.sections.insert(0, Section { start: 0, title: String::new() });
        }
        tape.outputs = roots.iter().map(|r| place[r.index()].unwrap_or(Operand::Constant(f64::NAN))).collect();
        tape
    }

    /// Counts the operations.
    pub fn operations(&self) -> OperationCount {
        let mut count = OperationCount::default();
        for step in &self.code {
            match step.kind {
                Kind::Mul | Kind::Div => count.mul += 1,
                Kind::Add | Kind::Sub | Kind::Neg => count.add += 1,
                Kind::Sign | Kind::Call(_) | Kind::Least | Kind::Most => {}
            }
        }
        count
    }

    /// Copies the tape with its sections in the order with the fewest live values.
    pub fn with_few_waiting(&self) -> Self {
        super::order::few_waiting(self)
    }

    /// Whether this output is zero for any inputs.
    pub fn is_zero(&self, output: usize) -> bool {
        self.outputs[output] == Operand::Constant(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn unused_steps_are_left_out_and_constants_are_not_counted() {
        let g = Graph::new();
        let (x, y) = (g.input(0), g.input(1));
        let _unused = x * y * 7.0;
        let tape = Tape::new(&g, &[x + y, g.constant(3.0), x]);
        assert_eq!(tape.operations(), OperationCount { mul: 0, add: 1 });
        assert_eq!(tape.outputs[1], Operand::Constant(3.0));
        assert_eq!(tape.outputs[2], Operand::Input(0));
    }
}
