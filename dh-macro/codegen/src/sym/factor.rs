//! Post-processing of a graph: factors sums, and reverses differences where that saves an
//! operation.
//!
//! `a b + a c -> a (b + c)` saves a multiplication if both products are used nowhere else. `-(a -
//! b) -> b - a` saves a change of sign if the difference is used nowhere else. Repeated until
//! nothing more is found, at most 8 times.

use super::graph::{Graph, Node, Op};

/// Copies the roots to a new graph with fewer operations; names and headings are kept.
pub(super) fn factored(graph: &Graph, roots: &[Node]) -> (Graph, Vec<Node>) {
    let mut current = rebuild(graph, roots);
    for _ in 0..8 {
        let next = rebuild(&current.0, &current.1);
        let done = next.2 == 0;
        current = next;
        if done {
            break;
        }
    }
    (current.0, current.1)
}

fn uses(graph: &Graph, roots: &[Node]) -> Vec<u32> {
    let mut uses = vec![0u32; graph.len()];
    for r in roots {
        uses[r.index()] += 1;
    }
    for index in (0..graph.len()).rev() {
        if uses[index] > 0 {
            for operand in graph.op(Node(index as u32)).operands() {
                uses[operand.index()] += 1;
            }
        }
    }
    uses
}

/// One pass in arena order. Returns the new graph, its roots and the number of rewritings.
fn rebuild(graph: &Graph, roots: &[Node]) -> (Graph, Vec<Node>, usize) {
    let uses = uses(graph, roots);
    let fresh = Graph::new().with_origins_of(graph);
    let mut map = vec![Node(0); graph.len()];
    let mut rewritten = 0;
    let headings = graph.sections();
    let mut heading = headings.iter().peekable();
    let single = |n: Node| uses[n.index()] == 1;
    for index in 0..graph.len() {
        while let Some((_, title)) = heading.next_if(|(start, _)| *start <= index) {
            fresh.section(title.clone());
        }
        if uses[index] == 0 {
            continue;
        }
        let node = Node(index as u32);
        let ex = |n: Node| fresh.wrap(map[n.index()]);
        let op = graph.op(node);
        let new = match op {
            Op::Constant(bits) => fresh.number(f64::from_bits(bits)),
            Op::Input(i) => fresh.input(i as usize),
            Op::Add(a, b) | Op::Sub(a, b) => match common_factor(graph, a, b).filter(|_| single(a) && single(b)) {
                Some((f, x, y)) => {
                    rewritten += 1;
                    if matches!(op, Op::Add(..)) { ex(f) * (ex(x) + ex(y)) } else { ex(f) * (ex(x) - ex(y)) }
                }
                None if matches!(op, Op::Add(..)) => ex(a) + ex(b),
                None => ex(a) - ex(b),
            },
            Op::Mul(a, b) => ex(a) * ex(b),
            Op::Div(a, b) => ex(a) / ex(b),
            Op::Sign(a) => ex(a).sign(),
            Op::Call(f, a) => ex(a).call(f),
            Op::Least(a, b) => ex(a).least(ex(b)),
            Op::Most(a, b) => ex(a).most(ex(b)),
            Op::Neg(a) => match graph.op(a) {
                Op::Sub(x, y) if single(a) => {
                    rewritten += 1;
                    // Inserted directly into the arena: the rules would find `x - y`, which is no
                    // longer needed.
                    fresh.wrap(fresh.insert(Op::Sub(map[y.index()], map[x.index()])))
                }
                _ => -ex(a),
            },
        };
        if let Some(name) = graph.name_of(node) {
            fresh.label(new, name);
        }
        map[index] = new.node();
    }
    let roots = roots.iter().map(|r| map[r.index()]).collect();
    (fresh, roots, rewritten)
}

/// Common factor: `(f, x, y)` with `a = f x` and `b = f y`.
fn common_factor(graph: &Graph, a: Node, b: Node) -> Option<(Node, Node, Node)> {
    let (Op::Mul(p, q), Op::Mul(r, s)) = (graph.op(a), graph.op(b)) else { return None };
    match () {
        () if p == r => Some((p, q, s)),
        () if p == s => Some((p, q, r)),
        () if q == r => Some((q, p, s)),
        () if q == s => Some((q, p, r)),
        () => None,
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Graph, Tape};

    #[test]
    fn a_common_factor_is_drawn_out_only_where_both_products_are_used_once() {
        let g = Graph::new();
        let (a, b, c) = (g.input(0), g.input(1), g.input(2));
        let sum = a * b + a * c;
        assert_eq!(Tape::new(&g, &[sum]).operations().total(), 2);
        assert_eq!(Tape::new(&g, &[sum, a * b]).operations().total(), 3);
    }

    #[test]
    fn a_difference_is_turned_round_where_nothing_else_needs_it() {
        let g = Graph::new();
        let (a, b) = (g.input(0), g.input(1));
        assert_eq!(Tape::new(&g, &[-(a - b)]).operations().total(), 1);
        assert_eq!(Tape::new(&g, &[-(a - b), a - b]).operations().total(), 2);
    }
}
