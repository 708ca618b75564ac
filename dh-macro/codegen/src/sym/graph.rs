//! The arena: the only place where a node is made.

use core::cell::RefCell;
use core::fmt;
use core::ops::{Add, Div, Mul, Neg, Sub};
use rustc_hash::{FxHashMap, FxHashSet};

use super::call::Call;
use super::formula::{Fold, Formula};
use super::rules;

/// Handle of a node in its [`Graph`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Node(pub(super) u32);

impl Node {
    /// Place in the arena: operands always stand before the node that uses them.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// Operation of a node.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Op {
    /// A number, by its bits (so that equal numbers are one node).
    Constant(u64),
    /// The input with this index.
    Input(u32),
    /// `a + b`, operands in arena order.
    Add(Node, Node),
    /// `a - b`.
    Sub(Node, Node),
    /// `a * b`, operands in arena order.
    Mul(Node, Node),
    /// `-a`.
    Neg(Node),
    /// `a / b`.
    Div(Node, Node),
    /// `-1`, `0` or `1`.
    Sign(Node),
    /// A function of `a`.
    Call(Call, Node),
    /// The smaller of two, operands in arena order.
    Least(Node, Node),
    /// The larger of two.
    Most(Node, Node),
}

impl Op {
    /// The nodes that this one reads.
    pub fn operands(self) -> impl Iterator<Item = Node> {
        let (a, b) = match self {
            Op::Constant(_) | Op::Input(_) => (None, None),
            Op::Neg(a) | Op::Sign(a) | Op::Call(_, a) => (Some(a), None),
            Op::Add(a, b) | Op::Sub(a, b) | Op::Mul(a, b) | Op::Div(a, b) | Op::Least(a, b) | Op::Most(a, b) => {
                (Some(a), Some(b))
            }
        };
        a.into_iter().chain(b)
    }
}

#[derive(Default)]
struct Arena {
    ops: Vec<Op>,
    index: FxHashMap<Op, Node>,
    labels: FxHashMap<Node, String>,
    sections: Vec<(usize, String)>,
    /// Of numbers that were given, or folded from given ones, by their bits.
    formulas: FxHashMap<u64, Formula>,
    /// Numbers that mechanics itself brings in, by their bits: halves, ones.
    own: FxHashSet<u64>,
}

/// One arena of expressions. All handles of one computation belong to one graph.
#[derive(Default)]
pub struct Graph(RefCell<Arena>);

/// An expression: a handle that can be added and multiplied. The rules of `sym/rules.rs` apply at
/// every birth.
#[derive(Clone, Copy)]
pub struct Ex<'g> {
    graph: &'g Graph,
    node: Node,
}

impl Graph {
    /// An empty graph.
    pub fn new() -> Self {
        Self::default()
    }

    /// The number `value` of a rule or a law; `-0.0` is `0.0`.
    pub fn constant(&self, value: f64) -> Ex<'_> {
        let bits = (value + 0.0).to_bits();
        self.0.borrow_mut().own.insert(bits);
        self.number(value)
    }

    /// The number `value` of a description: it keeps its origin through folds. Zero has none.
    pub fn given(&self, value: f64) -> Ex<'_> {
        if value == 0.0 {
            return self.constant(value);
        }
        self.0.borrow_mut().formulas.entry((value + 0.0).to_bits()).or_insert_with(|| Formula::number(value + 0.0));
        self.number(value)
    }

    /// The number of a tape; `given`: of a description.
    pub(super) fn replayed(&self, value: f64, given: bool) -> Ex<'_> {
        if given { self.given(value) } else { self.constant(value) }
    }

    /// The number, whatever its origin.
    pub(super) fn number(&self, value: f64) -> Ex<'_> {
        self.wrap(self.insert(Op::Constant((value + 0.0).to_bits())))
    }

    /// `-value`; the origin of `value` is kept. Makes no node.
    pub(super) fn minus(&self, value: f64) -> f64 {
        self.note(-value, [value, value], |[a, _]| a.negated());
        -value
    }

    /// Two numbers combined; their origins are kept. Makes no node.
    pub(super) fn fold(&self, fold: Fold, a: f64, b: f64) -> f64 {
        let value = fold.of(a, b);
        self.note(value, [a, b], |[a, b]| Formula::folded(fold, a, b, value));
        value
    }

    /// Notes the origin of a number that follows from others: given if one of them is, the graph's
    /// own otherwise.
    fn note(&self, value: f64, from: [f64; 2], how: impl FnOnce([Formula; 2]) -> Formula) {
        let (value, from) = ((value + 0.0).to_bits(), from.map(|x| (x + 0.0).to_bits()));
        let mut arena = self.0.borrow_mut();
        // Structural zeros are not the product of anything.
        if value != 0 && from.iter().any(|x| arena.formulas.contains_key(x)) {
            let origins = from.map(|x| arena.formulas.get(&x).cloned().unwrap_or(Formula::Number(x)));
            arena.formulas.entry(value).or_insert_with(|| how(origins));
        } else {
            arena.own.insert(value);
        }
    }

    /// How a given number came about; `None` of a number that mechanics brings in, too.
    pub(super) fn formula(&self, bits: u64) -> Option<Formula> {
        let arena = self.0.borrow();
        arena.formulas.get(&bits).filter(|_| !arena.own.contains(&bits)).cloned()
    }

    /// Takes over the origins of another graph's numbers.
    pub(super) fn with_origins_of(self, other: &Self) -> Self {
        {
            let (mut own, other) = (self.0.borrow_mut(), other.0.borrow());
            own.formulas.clone_from(&other.formulas);
            own.own.clone_from(&other.own);
        }
        self
    }

    /// The input with this index.
    pub fn input(&self, index: usize) -> Ex<'_> {
        self.wrap(self.insert(Op::Input(index as u32)))
    }

    /// Names what follows, up to the next section: a comment in the printed code.
    pub fn section(&self, title: impl Into<String>) {
        let mut arena = self.0.borrow_mut();
        let start = arena.ops.len();
        arena.sections.push((start, title.into()));
    }

    /// Gives an expression the name that a book would use; the first name of a node stays.
    pub fn label(&self, ex: Ex<'_>, name: impl Into<String>) {
        let mut arena = self.0.borrow_mut();
        if matches!(arena.ops[ex.node.index()], Op::Constant(_) | Op::Input(_)) {
            return;
        }
        arena.labels.entry(ex.node).or_insert_with(|| name.into());
    }

    /// Finds or appends; nothing else creates a node.
    pub(super) fn insert(&self, op: Op) -> Node {
        let mut arena = self.0.borrow_mut();
        if let Some(&node) = arena.index.get(&op) {
            return node;
        }
        let node = Node(arena.ops.len() as u32);
        arena.ops.push(op);
        arena.index.insert(op, node);
        node
    }

    /// Is this operation there already?
    pub(super) fn find(&self, op: Op) -> Option<Node> {
        self.0.borrow().index.get(&op).copied()
    }

    /// Operation of the node.
    pub fn op(&self, node: Node) -> Op {
        self.0.borrow().ops[node.index()]
    }

    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.0.borrow().ops.len()
    }

    /// No node yet?
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    pub(super) fn wrap(&self, node: Node) -> Ex<'_> {
        Ex { graph: self, node }
    }

    pub(super) fn name_of(&self, node: Node) -> Option<String> {
        self.0.borrow().labels.get(&node).cloned()
    }

    pub(super) fn sections(&self) -> Vec<(usize, String)> {
        self.0.borrow().sections.clone()
    }
}

impl<'g> Ex<'g> {
    /// The handle in the arena.
    pub fn node(self) -> Node {
        self.node
    }

    /// The graph that holds it.
    pub fn graph(self) -> &'g Graph {
        self.graph
    }

    /// The number, if it is one.
    pub fn as_constant(self) -> Option<f64> {
        match self.graph.op(self.node) {
            Op::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    /// Structurally zero?
    pub fn is_zero(self) -> bool {
        self.as_constant() == Some(0.0)
    }

    /// `-1`, `0` or `1`.
    pub fn sign(self) -> Self {
        self.graph.wrap(rules::sign(self.graph, self.node))
    }

    /// A function of it.
    pub fn call(self, function: Call) -> Self {
        self.graph.wrap(rules::call(self.graph, function, self.node))
    }

    /// The smaller of two.
    pub fn least(self, other: Self) -> Self {
        self.graph.wrap(rules::least(self.graph, self.node, other.node))
    }

    /// The larger of two.
    pub fn most(self, other: Self) -> Self {
        self.graph.wrap(rules::most(self.graph, self.node, other.node))
    }

    /// `-a` as an operation of its own, whatever `a` is.
    pub(super) fn negated(self) -> Self {
        match self.as_constant() {
            Some(value) => self.graph.number(self.graph.minus(value)),
            None => self.graph.wrap(self.graph.insert(Op::Neg(self.node))),
        }
    }

    /// Square.
    pub fn squared(self) -> Self {
        self * self
    }
}

impl fmt::Debug for Ex<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#{}", self.node.0)
    }
}

impl PartialEq for Ex<'_> {
    fn eq(&self, other: &Self) -> bool {
        self.node == other.node
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident) => {
        impl<'g> $trait for Ex<'g> {
            type Output = Ex<'g>;
            fn $method(self, other: Self) -> Self {
                self.graph.wrap(rules::$method(self.graph, self.node, other.node))
            }
        }
        impl<'g> $trait<f64> for Ex<'g> {
            type Output = Ex<'g>;
            fn $method(self, other: f64) -> Self {
                $trait::$method(self, self.graph.constant(other))
            }
        }
    };
}
operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl<'g> Neg for Ex<'g> {
    type Output = Ex<'g>;
    fn neg(self) -> Self {
        self.graph.wrap(rules::neg(self.graph, self.node))
    }
}
