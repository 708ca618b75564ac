//! Report of `denavit check` as JSON.

use dh_codegen::arm::{Function, Inverse, Kernel, Model};
use dh_codegen::robot::Robot;
use serde_json::{Map, Value, json};

/// Number of multiplications, additions and sine-cosine pairs of each kernel.
pub(in crate::report) fn operations(model: &Model) -> Vec<(Function, usize, usize, usize)> {
    let one = |f: &Function| {
        let kernel: Kernel = model.kernel(*f);
        let count = kernel.tape.operations();
        (*f, count.mul, count.add, kernel.sines())
    };
    Function::ALL.iter().map(one).collect()
}

/// Description of the robot.
pub fn check_json(robot: &Robot, model: &Model) -> Value {
    let class = Inverse::new(model.chain());
    let standard: Vec<String> = model.standard().iter().map(|p| p.name()).collect();
    let base: Vec<Value> = model
        .base()
        .0
        .iter()
        .map(|b| {
            let coefficients: Map<String, Value> =
                b.coefficients.iter().map(|&(i, c)| (standard[i].clone(), json!(c))).collect();
            json!({ "name": b.name, "grouping": b.grouping, "unit": b.leader.unit(robot), "coefficients": coefficients })
        })
        .collect();
    let counts: Map<String, Value> = operations(model)
        .into_iter()
        .map(|(f, mul, add, sincos)| (f.name().to_string(), json!({ "mul": mul, "add": add, "sincos": sincos })))
        .collect();
    json!({
        "name": robot.name,
        "dof": model.dof(),
        "joints": class.joints,
        "unactuated": robot.unactuated().map(|row| row + 1).collect::<Vec<_>>(),
        "ik": { "class": class.class, "exact": class.exact, "reason": class.reason },
        "standard_parameters": standard,
        "base_parameters": base,
        "operations": counts,
    })
}
