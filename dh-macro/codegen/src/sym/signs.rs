//! After factoring: which way round each difference is taken, so that as few signs as possible are left to change.
//!
//! A product's sign is that of its factors, a sum of two negatives is negative: these are forced. A difference may be taken
//! either way for nothing. What then is still negative at a root costs an operation.

use super::graph::{Graph, Node, Op};

/// Moves that are tried.
const ROUNDS: usize = 30_000;

/// The same roots in a new graph where `Neg` stands at roots only.
pub(super) fn settled(graph: &Graph, roots: &[Node]) -> (Graph, Vec<Node>) {
    let ops: Vec<Op> = (0..graph.len()).map(|i| graph.op(Node(i as u32))).collect();
    let mut turned = vec![false; ops.len()];
    let mut negative = vec![false; ops.len()];
    let mut best = negatives(&ops, roots, &turned, &mut negative);
    let differences: Vec<usize> = (0..ops.len()).filter(|&i| matches!(ops[i], Op::Add(..) | Op::Sub(..))).collect();
    // Alone, and together with a sum that it is made of: moves that change nothing are taken too, they open the way to others.
    let mut moves: Vec<Vec<usize>> = differences.iter().map(|&i| vec![i]).collect();
    for &i in &differences {
        let below = ops[i].operands().flat_map(|n| sums_below(&ops, n.index()));
        moves.extend(below.map(|j| vec![i, j]));
    }
    // Annealing with a fixed sequence: the same at every run.
    let (mut cost, mut kept_best) = (best, turned.clone());
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
        flip.iter().for_each(|&i| turned[i] = !turned[i]);
        let trial = negatives(&ops, roots, &turned, &mut negative);
        let chance = (random() % 1_000_000) as f64 / 1e6;
        let worse = trial as f64 - cost as f64;
        if worse <= 0.0 || chance < falling(worse / temperature.max(1e-3)) {
            cost = trial;
            if cost < best {
                best = cost;
                kept_best.clone_from(&turned);
            }
        } else {
            flip.iter().for_each(|&i| turned[i] = !turned[i]);
        }
    }
    turned = kept_best;
    negatives(&ops, roots, &turned, &mut negative);
    rebuild(graph, &ops, roots, &turned, &negative)
}

/// Nearly `exp(-x)` for `x > 0`. The library's own differs between machines, and what is generated must not.
fn falling(x: f64) -> f64 {
    1.0 / (1.0 + x * (1.0 + x * (0.5 + x * (1.0 / 6.0 + x / 24.0))))
}

/// The nearest sums that a node's sign depends on.
fn sums_below(ops: &[Op], node: usize) -> Vec<usize> {
    match ops[node] {
        Op::Add(..) | Op::Sub(..) => vec![node],
        Op::Neg(a) | Op::Sign(a) => sums_below(ops, a.index()),
        Op::Mul(a, b) | Op::Div(a, b) => [a, b].iter().flat_map(|n| sums_below(ops, n.index())).collect(),
        Op::Constant(_) | Op::Input(_) => Vec::new(),
    }
}

/// Fills in the sign with which each node is kept, and counts the different nodes that a root needs the other way round.
fn negatives(ops: &[Op], roots: &[Node], turned: &[bool], negative: &mut [bool]) -> usize {
    for (i, op) in ops.iter().enumerate() {
        let sign = |n: Node, negative: &[bool]| negative[n.index()];
        negative[i] = match *op {
            Op::Constant(_) | Op::Input(_) => false,
            Op::Neg(a) => !sign(a, negative),
            Op::Sign(a) => sign(a, negative),
            Op::Mul(a, b) | Op::Div(a, b) => sign(a, negative) != sign(b, negative),
            Op::Add(a, b) => match (sign(a, negative), sign(b, negative)) {
                (x, y) if x == y => x,
                _ => turned[i],
            },
            Op::Sub(a, b) => match (sign(a, negative), sign(b, negative)) {
                (x, y) if x != y => x,
                _ => turned[i],
            },
        };
    }
    let mut wrong: Vec<Node> = roots.iter().copied().filter(|r| negative[r.index()]).map(|r| kept(ops, r)).collect();
    wrong.sort_unstable();
    wrong.dedup();
    wrong.len()
}

/// The node that is really kept behind changes of sign.
fn kept(ops: &[Op], mut node: Node) -> Node {
    while let Op::Neg(a) = ops[node.index()] {
        node = a;
    }
    node
}

fn rebuild(graph: &Graph, ops: &[Op], roots: &[Node], turned: &[bool], negative: &[bool]) -> (Graph, Vec<Node>) {
    let fresh = Graph::new();
    let headings = graph.sections();
    let mut heading = headings.iter().peekable();
    let mut place: Vec<Node> = Vec::with_capacity(ops.len());
    for (i, op) in ops.iter().enumerate() {
        while let Some((_, title)) = heading.next_if(|(start, _)| *start <= i) {
            fresh.section(title.clone());
        }
        let at = |n: Node| place[n.index()];
        let sum = |a: Node, b: Node| Op::Add(a.min(b), a.max(b));
        // Straight into the arena: the rules would move the signs again.
        let node = match *op {
            Op::Constant(_) | Op::Input(_) => fresh.insert(*op),
            Op::Neg(a) => at(a),
            Op::Sign(a) => fresh.insert(Op::Sign(at(a))),
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
