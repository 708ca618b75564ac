//! Simplification on creation: local rules, no global rewriting. Signs are moved outwards, where
//! sums absorb them.

use super::call::Call;
use super::formula::Fold;
use super::graph::{Graph, Node, Op};
use crate::elementary::Real;

fn number(g: &Graph, n: Node) -> Option<f64> {
    match g.op(n) {
        Op::Constant(bits) => Some(f64::from_bits(bits)),
        _ => None,
    }
}

fn folded(g: &Graph, fold: Fold, a: f64, b: f64) -> Node {
    g.number(g.fold(fold, a, b)).node()
}

fn constant(g: &Graph, value: f64) -> Node {
    g.constant(value).node()
}

/// Sum. Simplifies `x + 0`, numbers, `a + (-b) = a - b`, `a + (b - a) = b`, operand order.
pub(super) fn add(g: &Graph, a: Node, b: Node) -> Node {
    match (number(g, a), number(g, b)) {
        (Some(x), Some(y)) => return folded(g, Fold::Add, x, y),
        (Some(0.0), None) => return b,
        (None, Some(0.0)) => return a,
        _ => {}
    }
    match (g.op(a), g.op(b)) {
        (Op::Neg(x), Op::Neg(y)) => {
            let sum = add(g, x, y);
            neg(g, sum)
        }
        (_, Op::Neg(y)) => sub(g, a, y),
        (Op::Neg(x), _) => sub(g, b, x),
        (_, Op::Sub(x, y)) if y == a => x,
        (Op::Sub(x, y), _) if y == b => x,
        _ => g.insert(Op::Add(a.min(b), a.max(b))),
    }
}

/// Difference. Simplifies `x - 0`, `0 - x`, `x - x`, numbers, `a - (-b) = a + b`, `(a + b) - a =
/// b`; `b - a` is the negative of an existing `a - b`.
pub(super) fn sub(g: &Graph, a: Node, b: Node) -> Node {
    match (number(g, a), number(g, b)) {
        (Some(x), Some(y)) => return folded(g, Fold::Sub, x, y),
        (Some(0.0), None) => return neg(g, b),
        (None, Some(0.0)) => return a,
        _ => {}
    }
    if a == b {
        return constant(g, 0.0);
    }
    match (g.op(a), g.op(b)) {
        (Op::Neg(x), Op::Neg(y)) => sub(g, y, x),
        (_, Op::Neg(y)) => add(g, a, y),
        (Op::Neg(x), _) => {
            let sum = add(g, x, b);
            neg(g, sum)
        }
        (Op::Add(x, y), _) if x == b => y,
        (Op::Add(x, y), _) if y == b => x,
        (_, Op::Add(x, y)) if x == a => neg(g, y),
        (_, Op::Add(x, y)) if y == a => neg(g, x),
        (_, Op::Sub(x, y)) if x == a => y,
        (Op::Sub(x, y), _) if x == b => neg(g, y),
        _ => match g.find(Op::Sub(b, a)) {
            Some(opposite) => neg(g, opposite),
            None => g.insert(Op::Sub(a, b)),
        },
    }
}

/// Product. Simplifies `x * 0`, `x * 1`, numbers (also across a product), signs to the outside,
/// operand order.
pub(super) fn mul(g: &Graph, a: Node, b: Node) -> Node {
    match (number(g, a), number(g, b)) {
        (Some(x), Some(y)) => return folded(g, Fold::Mul, x, y),
        (Some(x), None) => return scale(g, x, b),
        (None, Some(y)) => return scale(g, y, a),
        _ => {}
    }
    match (g.op(a), g.op(b)) {
        (Op::Neg(x), Op::Neg(y)) => mul(g, x, y),
        (Op::Neg(x), _) => {
            let product = mul(g, x, b);
            neg(g, product)
        }
        (_, Op::Neg(y)) => {
            let product = mul(g, a, y);
            neg(g, product)
        }
        _ => g.insert(Op::Mul(a.min(b), a.max(b))),
    }
}

fn scale(g: &Graph, factor: f64, x: Node) -> Node {
    if factor == 0.0 {
        return constant(g, 0.0);
    }
    if factor == 1.0 {
        return x;
    }
    if factor < 0.0 {
        let positive = scale(g, g.minus(factor), x);
        return neg(g, positive);
    }
    match g.op(x) {
        Op::Neg(y) => {
            let positive = scale(g, factor, y);
            neg(g, positive)
        }
        Op::Mul(p, q) => match (number(g, p), number(g, q)) {
            (Some(c), _) => scale(g, g.fold(Fold::Mul, factor, c), q),
            (_, Some(c)) => scale(g, g.fold(Fold::Mul, factor, c), p),
            _ => product(g, factor, x),
        },
        _ => product(g, factor, x),
    }
}

fn product(g: &Graph, factor: f64, x: Node) -> Node {
    let c = g.number(factor).node();
    g.insert(Op::Mul(c.min(x), c.max(x)))
}

/// Negation. Simplifies `-(-x) = x` and numbers. Keeps `-(a - b)`, which a sum that contains it
/// reverses at no cost.
pub(super) fn neg(g: &Graph, a: Node) -> Node {
    match g.op(a) {
        Op::Constant(bits) => g.number(g.minus(f64::from_bits(bits))).node(),
        Op::Neg(x) => x,
        _ => g.insert(Op::Neg(a)),
    }
}

/// Quotient. Simplifies `0 / x`, `x / 1`, numbers, signs to the outside.
pub(super) fn div(g: &Graph, a: Node, b: Node) -> Node {
    match (number(g, a), number(g, b)) {
        (Some(x), Some(y)) => return folded(g, Fold::Div, x, y),
        (Some(0.0), None) => return a,
        (None, Some(1.0)) => return a,
        _ => {}
    }
    match (g.op(a), g.op(b)) {
        (Op::Neg(x), Op::Neg(y)) => div(g, x, y),
        (Op::Neg(x), _) => {
            let quotient = div(g, x, b);
            neg(g, quotient)
        }
        (_, Op::Neg(y)) => {
            let quotient = div(g, a, y);
            neg(g, quotient)
        }
        _ => g.insert(Op::Div(a, b)),
    }
}

/// Sign. Simplifies numbers and `sign(-x) = -sign(x)`.
pub(super) fn sign(g: &Graph, a: Node) -> Node {
    match g.op(a) {
        Op::Constant(bits) => {
            let x = f64::from_bits(bits);
            constant(
                g,
                if x > 0.0 {
                    1.0
                } else if x < 0.0 {
                    -1.0
                } else {
                    0.0
                },
            )
        }
        Op::Neg(x) => {
            let s = sign(g, x);
            neg(g, s)
        }
        _ => g.insert(Op::Sign(a)),
    }
}

/// Function. Simplifies numbers and `f(-x)` of even and odd functions.
pub(super) fn call(g: &Graph, f: Call, a: Node) -> Node {
    match (g.op(a), f.even()) {
        (Op::Constant(bits), _) => constant(g, f.value(f64::from_bits(bits))),
        (Op::Neg(x), Some(true)) => call(g, f, x),
        (Op::Neg(x), Some(false)) => {
            let value = call(g, f, x);
            neg(g, value)
        }
        _ => g.insert(Op::Call(f, a)),
    }
}

/// Minimum. Simplifies numbers and equal operands; orders the operands.
pub(super) fn least(g: &Graph, a: Node, b: Node) -> Node {
    match (number(g, a), number(g, b)) {
        (Some(x), Some(y)) => constant(g, Real::min(x, y)),
        _ if a == b => a,
        _ => g.insert(Op::Least(a.min(b), a.max(b))),
    }
}

/// Maximum. Simplifies numbers and equal operands; orders the operands.
pub(super) fn most(g: &Graph, a: Node, b: Node) -> Node {
    match (number(g, a), number(g, b)) {
        (Some(x), Some(y)) => constant(g, Real::max(x, y)),
        _ if a == b => a,
        _ => g.insert(Op::Most(a.min(b), a.max(b))),
    }
}

#[cfg(test)]
mod tests {
    use super::super::Graph;

    #[test]
    fn zero_and_one_vanish() {
        let g = Graph::new();
        let (x, zero, one) = (g.input(0), g.constant(0.0), g.constant(1.0));
        assert_eq!(x + zero, x);
        assert_eq!(zero - x, -x);
        assert_eq!(x * zero, zero);
        assert_eq!(one * x, x);
        assert_eq!(x - x, zero);
        assert_eq!(zero / x, zero);
    }

    #[test]
    fn signs_float_outwards_and_are_absorbed() {
        let g = Graph::new();
        let (x, y) = (g.input(0), g.input(1));
        assert_eq!(x + (-y), x - y);
        assert_eq!((-x) * (-y), x * y);
        assert_eq!((-x) * y, -(x * y));
        assert_eq!(x * -2.0, -(x * 2.0));
        assert_eq!(-(-x), x);
        assert_eq!(y - x, -(x - y));
        assert_eq!((-x).sign(), -x.sign());
    }

    #[test]
    fn equal_expressions_are_one_node() {
        let g = Graph::new();
        let (x, y) = (g.input(0), g.input(1));
        assert_eq!(x * y + x, x + y * x);
        assert_eq!((x * 2.0) * 3.0, x * 6.0);
        assert_eq!((x + y) - x, y);
        assert_eq!(x - (x - y), y);
        let before = g.len();
        let _ = y * x;
        assert_eq!(g.len(), before);
    }
}
