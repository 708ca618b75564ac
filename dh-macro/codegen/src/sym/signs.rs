//! Selects, after factoring, the direction of each difference such that the fewest changes of sign
//! remain.
//!
//! The sign of a product is that of its factors, and a sum of two negatives is negative: these are
//! forced. A difference may be taken in either direction at no cost. Any sign that is still
//! negative at a root costs an operation.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::graph::{Graph, Node, Op};

/// Number of moves that are tried.
const ROUNDS: usize = 30_000;

/// Copies the roots to a new graph in which `Neg` occurs at roots only.
pub(super) fn settled(graph: &Graph, roots: &[Node]) -> (Graph, Vec<Node>) {
    let ops: Vec<Op> = (0..graph.len()).map(|i| graph.op(Node(i as u32))).collect();
    // Arguments of functions and choices must have their own sign, like roots.
    let read = ops.iter().filter(|op| needs_own_sign(op)).flat_map(|op| op.operands());
    let counted: Vec<Node> = roots.iter().copied().chain(read).collect();
    let mut signs = Signs::new(&ops, &counted);
    let mut best = signs.cost;
    let differences: Vec<usize> = (0..ops.len()).filter(|&i| matches!(ops[i], Op::Add(..) | Op::Sub(..))).collect();
    // Each difference alone, and together with a sum on which it depends: moves that change nothing
    // are accepted, too, since they open the way to others.
    let mut moves: Vec<Vec<usize>> = differences.iter().map(|&i| vec![i]).collect();
    for &i in &differences {
        let below = ops[i].operands().flat_map(|n| sums_below(&ops, n.index()));
        moves.extend(below.map(|j| vec![i, j]));
    }
    // Simulated annealing with a fixed random sequence, reproducible in every run.
    let mut kept_best = signs.turned.clone();
    let mut state = 0x9E37_79B9_7F4A_7C15u64;
    let mut random = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        state
    };
    let rounds = if moves.is_empty() || best == 0 { 0 } else { ROUNDS };
    for round in 0..rounds {
        let temperature = 0.8 * (1.0 - round as f64 / rounds as f64);
        let flip = &moves[(random() % moves.len() as u64) as usize];
        let cost = signs.cost;
        signs.turn(flip);
        let chance = (random() % 1_000_000) as f64 / 1e6;
        let worse = signs.cost as f64 - cost as f64;
        if worse <= 0.0 || chance < falling(worse / temperature.max(1e-3)) {
            if signs.cost < best {
                best = signs.cost;
                kept_best.clone_from(&signs.turned);
            }
        } else {
            signs.undo(flip);
        }
    }
    let differing: Vec<usize> = (0..ops.len()).filter(|&i| signs.turned[i] != kept_best[i]).collect();
    signs.turn(&differing);
    rebuild(graph, &ops, roots, &signs.turned, &signs.negative)
}

/// Direction of each difference, and its consequences.
struct Signs<'a> {
    ops: &'a [Op],
    /// Nodes that use each node as an operand.
    users: Vec<Vec<usize>>,
    /// For each root: the node that is stored, without its changes of sign.
    kept: Vec<Vec<usize>>,
    /// For each such node: roots that need it with the opposite sign.
    wrong: Vec<usize>,
    /// Whether each difference is reversed.
    turned: Vec<bool>,
    /// Whether each node is stored with a negative sign.
    negative: Vec<bool>,
    /// Number of distinct nodes that a root needs with the opposite sign.
    cost: usize,
    /// Nodes whose sign the last move changed.
    changed: Vec<usize>,
}

impl<'a> Signs<'a> {
    fn new(ops: &'a [Op], roots: &[Node]) -> Self {
        let mut users = vec![Vec::new(); ops.len()];
        for (i, op) in ops.iter().enumerate() {
            op.operands().for_each(|n| users[n.index()].push(i));
        }
        let mut kept = vec![Vec::new(); ops.len()];
        for root in roots {
            let mut node = *root;
            while let Op::Neg(a) = ops[node.index()] {
                node = a;
            }
            kept[root.index()].push(node.index());
        }
        let (turned, negative) = (vec![false; ops.len()], vec![false; ops.len()]);
        let mut signs =
            Self { ops, users, kept, wrong: vec![0; ops.len()], turned, negative, cost: 0, changed: Vec::new() };
        for i in 0..ops.len() {
            if signs.sign(i) {
                signs.change(i);
            }
        }
        signs
    }

    /// Sign of a node, from those of its operands.
    fn sign(&self, i: usize) -> bool {
        let of = |n: Node| self.negative[n.index()];
        match self.ops[i] {
            Op::Constant(_) | Op::Input(_) => false,
            Op::Neg(a) => !of(a),
            Op::Sign(a) => of(a),
            Op::Call(f, a) => f.even() == Some(false) && of(a),
            Op::Least(..) | Op::Most(..) => false,
            Op::Mul(a, b) | Op::Div(a, b) => of(a) != of(b),
            Op::Add(a, b) if of(a) == of(b) => of(a),
            Op::Sub(a, b) if of(a) != of(b) => of(a),
            Op::Add(..) | Op::Sub(..) => self.turned[i],
        }
    }

    fn change(&mut self, i: usize) {
        self.negative[i] = !self.negative[i];
        for &node in &self.kept[i] {
            if self.negative[i] {
                self.cost += usize::from(self.wrong[node] == 0);
                self.wrong[node] += 1;
            } else {
                self.wrong[node] -= 1;
                self.cost -= usize::from(self.wrong[node] == 0);
            }
        }
    }

    /// Reverses these differences. Operands precede the nodes that use them, so going upwards
    /// through the changes visits each node once.
    fn turn(&mut self, which: &[usize]) {
        self.changed.clear();
        which.iter().for_each(|&i| self.turned[i] = !self.turned[i]);
        let mut ahead: BinaryHeap<Reverse<usize>> = which.iter().map(|&i| Reverse(i)).collect();
        while let Some(Reverse(i)) = ahead.pop() {
            while ahead.peek() == Some(&Reverse(i)) {
                ahead.pop();
            }
            if self.sign(i) != self.negative[i] {
                self.change(i);
                self.changed.push(i);
                ahead.extend(self.users[i].iter().map(|&u| Reverse(u)));
            }
        }
    }

    /// Reverts the last move.
    fn undo(&mut self, which: &[usize]) {
        which.iter().for_each(|&i| self.turned[i] = !self.turned[i]);
        for i in std::mem::take(&mut self.changed) {
            self.change(i);
        }
    }
}

/// Whether the operands need their own sign, because it affects the value.
fn needs_own_sign(op: &Op) -> bool {
    match op {
        Op::Call(f, _) => f.even().is_none(),
        Op::Least(..) | Op::Most(..) => true,
        _ => false,
    }
}

/// Approximates `exp(-x)` for `x > 0`. The library's function differs between machines, and
/// generated code must not.
fn falling(x: f64) -> f64 {
    1.0 / (1.0 + x * (1.0 + x * (0.5 + x * (1.0 / 6.0 + x / 24.0))))
}

/// Nearest sums on which a node's sign depends.
fn sums_below(ops: &[Op], node: usize) -> Vec<usize> {
    match ops[node] {
        Op::Add(..) | Op::Sub(..) => vec![node],
        Op::Neg(a) | Op::Sign(a) | Op::Call(_, a) => sums_below(ops, a.index()),
        Op::Mul(a, b) | Op::Div(a, b) | Op::Least(a, b) | Op::Most(a, b) => {
            [a, b].iter().flat_map(|n| sums_below(ops, n.index())).collect()
        }
        Op::Constant(_) | Op::Input(_) => Vec::new(),
    }
}

fn rebuild(graph: &Graph, ops: &[Op], roots: &[Node], turned: &[bool], negative: &[bool]) -> (Graph, Vec<Node>) {
    let fresh = Graph::new().with_origins_of(graph);
    let headings = graph.sections();
    let mut heading = headings.iter().peekable();
    let mut place: Vec<Node> = Vec::with_capacity(ops.len());
    for (i, op) in ops.iter().enumerate() {
        while let Some((_, title)) = heading.next_if(|(start, _)| *start <= i) {
            fresh.section(title.clone());
        }
        let at = |n: Node| place[n.index()];
        let own = |n: Node| if negative[n.index()] { fresh.wrap(at(n)).negated().node() } else { at(n) };
        let sum = |a: Node, b: Node| Op::Add(a.min(b), a.max(b));
        // Inserted directly into the arena: the rules would move the signs again.
        let node = match *op {
            Op::Constant(_) | Op::Input(_) => fresh.insert(*op),
            Op::Neg(a) => at(a),
            Op::Sign(a) => fresh.insert(Op::Sign(at(a))),
            Op::Call(f, a) if f.even().is_some() => fresh.insert(Op::Call(f, at(a))),
            Op::Call(f, a) => fresh.insert(Op::Call(f, own(a))),
            Op::Least(a, b) => fresh.insert(Op::Least(own(a).min(own(b)), own(a).max(own(b)))),
            Op::Most(a, b) => fresh.insert(Op::Most(own(a).min(own(b)), own(a).max(own(b)))),
            Op::Mul(a, b) => fresh.insert(Op::Mul(at(a).min(at(b)), at(a).max(at(b)))),
            Op::Div(a, b) => fresh.insert(Op::Div(at(a), at(b))),
            Op::Add(a, b) | Op::Sub(a, b) => {
                let (x, y) = (at(a), at(b));
                let minus_a = negative[a.index()];
                let minus_b = negative[b.index()] != matches!(op, Op::Sub(..));
                fresh.insert(match (minus_a, minus_b, turned[i]) {
                    (false, false, _) | (true, true, _) => sum(x, y),
                    (false, true, false) | (true, false, true) => Op::Sub(x, y),
                    (true, false, false) | (false, true, true) => Op::Sub(y, x),
                })
            }
        };
        if let Some(name) = graph.name_of(Node(i as u32))
            && !negative[i]
        {
            fresh.label(fresh.wrap(node), name);
        }
        place.push(node);
    }
    let roots = roots
        .iter()
        .map(|r| {
            let node = place[r.index()];
            if negative[r.index()] { fresh.wrap(node).negated().node() } else { node }
        })
        .collect();
    (fresh, roots)
}

#[cfg(test)]
mod tests {
    use super::super::{Graph, Tape};

    #[test]
    fn differences_are_turned_so_that_no_sign_is_left() {
        let g = Graph::new();
        let [a, b, c, d] = [0, 1, 2, 3].map(|i| g.input(i));
        let p = (a - b) * c;
        assert_eq!(Tape::new(&g, &[-p, d - p * d]).operations().total(), 4);
        assert_eq!(Tape::new(&g, &[p, -p]).operations().total(), 3);
        assert_eq!(Tape::new(&g, &[-(a + b)]).operations().total(), 2);
    }
}
