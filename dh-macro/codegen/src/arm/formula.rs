//! Expresses a torque in closed form, [`crate::robot::TorqueLaw`], over the inputs of a kernel.

use crate::robot::{LawFunction, Term, Variable};
use crate::sym::{Call, Ex, Graph};

/// Argument above which `tanh` is 1 in all digits.
const FLAT: f64 = 20.0;
/// Lower bound of the argument of a logarithm, to keep that of 0 finite.
const TINY: f64 = 1e-300;

/// Expression of the term; `of`: expressions of its variables.
pub(super) fn value<'g>(graph: &'g Graph, term: &Term, of: &impl Fn(Variable) -> Ex<'g>) -> Ex<'g> {
    let value = |term: &Term| value(graph, term, of);
    match term {
        Term::Number(x) => graph.constant(*x),
        Term::Variable(v) => of(*v),
        Term::Negative(x) => -value(x),
        Term::Inverse(x) => graph.constant(1.0) / value(x),
        Term::Sum(all) => all.iter().fold(graph.constant(0.0), |sum, x| match x {
            Term::Negative(x) => sum - value(x),
            _ => sum + value(x),
        }),
        Term::Product(all) => all.iter().fold(graph.constant(1.0), |product, x| match x {
            Term::Inverse(x) => product / value(x),
            _ => product * value(x),
        }),
        Term::Power(x, n) => power(value(x), *n),
        Term::Call(function, x) => called(*function, value(x)),
        Term::Least(x, y) => value(x).least(value(y)),
        Term::Most(x, y) => value(x).most(value(y)),
    }
}

/// Integer power by products; any other power only of a non-negative base.
fn power(x: Ex<'_>, n: f64) -> Ex<'_> {
    let one = x.graph().constant(1.0);
    let size = n.abs();
    let raised = match size {
        0.5 => root(x),
        _ if size.fract() == 0.0 => (0..size as u32).fold(one, |product, _| product * x),
        _ => (x.most(x.graph().constant(TINY)).call(Call::Ln) * size).call(Call::Exp),
    };
    if n < 0.0 { one / raised } else { raised }
}

/// Root; negative rounding errors give 0.
fn root(x: Ex<'_>) -> Ex<'_> {
    x.most(x.graph().constant(0.0)).call(Call::Sqrt)
}

fn called(function: LawFunction, x: Ex<'_>) -> Ex<'_> {
    let number = |value: f64| x.graph().constant(value);
    match function {
        LawFunction::Sin => x.call(Call::Sin),
        LawFunction::Cos => x.call(Call::Cos),
        LawFunction::Exp => x.call(Call::Exp),
        LawFunction::Ln => x.call(Call::Ln),
        LawFunction::Sqrt => root(x),
        LawFunction::Abs => x.call(Call::Abs),
        LawFunction::Sign => x.sign(),
        LawFunction::Tanh => {
            let grown = (x.least(number(FLAT)).most(number(-FLAT)) * 2.0).call(Call::Exp);
            (grown - 1.0) / (grown + 1.0)
        }
    }
}
