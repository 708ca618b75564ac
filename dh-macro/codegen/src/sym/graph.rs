//! Arena of hash-consed expressions, in which all nodes are created.

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
    /// Index in the arena: operands always precede the node that uses them.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// Operation of a node.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Op {
    /// A number, identified by its bits, so that equal numbers are one node.
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
    /// Sign of `a`: `-1`, `0` or `1`.
    Sign(Node),
    /// Function of `a`.
    Call(Call, Node),
    /// Minimum of two, operands in arena order.
    Least(Node, Node),
    /// Maximum of two.
    Most(Node, Node),
}

impl Op {
    /// Operands of the node.
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
    /// Formulas of numbers that were given, or folded from given ones, by their bits.
    formulas: FxHashMap<u64, Formula>,
    /// Numbers introduced by the mechanics itself (such as 1/2 and 1), by their bits.
    own: FxHashSet<u64>,
}

/// Arena of expressions. All handles of one computation belong to one graph.
#[derive(Default)]
pub struct Graph(RefCell<Arena>);

/// Expression: a handle with arithmetic. The rules of `sym/rules.rs` are applied whenever one is
/// created.
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

    /// Constant `value` of a rule or a law; `-0.0` becomes `0.0`.
    pub fn constant(&self, value: f64) -> Ex<'_> {
        let bits = (value + 0.0).to_bits();
        self.0.borrow_mut().own.insert(bits);
        self.number(value)
    }

    /// Number `value` of a description, whose origin is kept through folds. Zero has none.
    pub fn given(&self, value: f64) -> Ex<'_> {
        if value == 0.0 {
            return self.constant(value);
        }
        self.0.borrow_mut().formulas.entry((value + 0.0).to_bits()).or_insert_with(|| Formula::number(value + 0.0));
        self.number(value)
    }

    /// Number of a replayed tape; `given`: whether it belongs to a description.
    pub(super) fn replayed(&self, value: f64, given: bool) -> Ex<'_> {
        if given { self.given(value) } else { self.constant(value) }
    }

    /// Node of a number, without recording an origin.
    pub(super) fn number(&self, value: f64) -> Ex<'_> {
        self.wrap(self.insert(Op::Constant((value + 0.0).to_bits())))
    }

    /// Negates `value` and records the origin; creates no node.
    pub(super) fn minus(&self, value: f64) -> f64 {
        self.note(-value, [value, value], |[a, _]| a.negated());
        -value
    }

    /// Combines two numbers and records the origin; creates no node.
    pub(super) fn fold(&self, fold: Fold, a: f64, b: f64) -> f64 {
        let value = fold.of(a, b);
        self.note(value, [a, b], |[a, b]| Formula::folded(fold, a, b, value));
        value
    }

    /// Records the origin of a derived number: given if one of the operands is, otherwise the
    /// graph's own.
    fn note(&self, value: f64, from: [f64; 2], how: impl FnOnce([Formula; 2]) -> Formula) {
        let (value, from) = ((value + 0.0).to_bits(), from.map(|x| (x + 0.0).to_bits()));
        let mut arena = self.0.borrow_mut();
        // Structural zeros have no origin.
        if value != 0 && from.iter().any(|x| arena.formulas.contains_key(x)) {
            let origins = from.map(|x| arena.formulas.get(&x).cloned().unwrap_or(Formula::Number(x)));
            arena.formulas.entry(value).or_insert_with(|| how(origins));
        } else {
            arena.own.insert(value);
        }
    }

    /// Formula of a given number; `None` for a number that the mechanics introduces, too.
    pub(super) fn formula(&self, bits: u64) -> Option<Formula> {
        let arena = self.0.borrow();
        arena.formulas.get(&bits).filter(|_| !arena.own.contains(&bits)).cloned()
    }

    /// Copies the origins of another graph's numbers.
    pub(super) fn with_origins_of(self, other: &Self) -> Self {
        {
            let (mut own, other) = (self.0.borrow_mut(), other.0.borrow());
            own.formulas.clone_from(&other.formulas);
            own.own.clone_from(&other.own);
        }
        self
    }

    /// Input with this index.
    pub fn input(&self, index: usize) -> Ex<'_> {
        self.wrap(self.insert(Op::Input(index as u32)))
    }

    /// Starts a section with this title, printed as a comment in the code.
    pub fn section(&self, title: impl Into<String>) {
        let mut arena = self.0.borrow_mut();
        let start = arena.ops.len();
        arena.sections.push((start, title.into()));
    }

    /// Gives an expression its textbook name; the first name of a node is kept.
    pub fn label(&self, ex: Ex<'_>, name: impl Into<String>) {
        let mut arena = self.0.borrow_mut();
        if matches!(arena.ops[ex.node.index()], Op::Constant(_) | Op::Input(_)) {
            return;
        }
        arena.labels.entry(ex.node).or_insert_with(|| name.into());
    }

    /// Finds or appends a node; the only function that creates nodes.
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

    /// Node of this operation, if it exists.
    pub(super) fn find(&self, op: Op) -> Option<Node> {
        self.0.borrow().index.get(&op).copied()
    }

    /// Operation of a node.
    pub fn op(&self, node: Node) -> Op {
        self.0.borrow().ops[node.index()]
    }

    /// Number of nodes.
    pub fn len(&self) -> usize {
        self.0.borrow().ops.len()
    }

    /// Whether there are no nodes.
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
    /// Handle in the arena.
    pub fn node(self) -> Node {
        self.node
    }

    /// Graph of the expression.
    pub fn graph(self) -> &'g Graph {
        self.graph
    }

    /// Value of the expression, if it is a number.
    pub fn as_constant(self) -> Option<f64> {
        match self.graph.op(self.node) {
            Op::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    /// Whether it is structurally zero.
    pub fn is_zero(self) -> bool {
        self.as_constant() == Some(0.0)
    }

    /// Sign: `-1`, `0` or `1`.
    pub fn sign(self) -> Self {
        self.graph.wrap(rules::sign(self.graph, self.node))
    }

    /// Function of the expression.
    pub fn call(self, function: Call) -> Self {
        self.graph.wrap(rules::call(self.graph, function, self.node))
    }

    /// Minimum of two expressions.
    pub fn least(self, other: Self) -> Self {
        self.graph.wrap(rules::least(self.graph, self.node, other.node))
    }

    /// Maximum of two expressions.
    pub fn most(self, other: Self) -> Self {
        self.graph.wrap(rules::most(self.graph, self.node, other.node))
    }

    /// Negation as a separate operation, without applying the rules.
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
