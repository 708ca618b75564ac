//! Report of `denavit eval` as JSON.

use serde_json::{Value, json};

use crate::model::Arm;

/// `{"quantity", "rows", "cols", "column_names", "values"}`: one row-major list per state.
pub fn eval_json(quantity: &str, arm: &dyn Arm, shape: &[usize], mut values: Vec<Vec<f64>>) -> Value {
    let joints = |prefix: &str| -> Vec<String> { (1..=arm.dof()).map(|j| format!("{prefix}{j}")).collect() };
    let (mut rows, cols) = match shape {
        [n] => (*n, 1),
        [rows, cols] => (*rows, *cols),
        _ => (shape.iter().product(), 1),
    };
    let names: Vec<String> = match quantity {
        "regressor" => arm.standard_names(),
        "base_regressor" => arm.base_parameters().iter().map(|b| b.name.clone()).collect(),
        "jacobian" | "tool_jacobian" | "mass_matrix" => joints("q"),
        "forward_kinematics" | "tool_pose" => {
            rows = 4;
            values.iter_mut().for_each(|v| v.extend([0.0, 0.0, 0.0, 1.0]));
            ["x_axis", "y_axis", "z_axis", "origin"].map(String::from).to_vec()
        }
        "forward_dynamics" => vec!["ddq".into()],
        _ => vec!["tau".into()],
    };
    json!({ "quantity": quantity, "rows": rows, "cols": cols, "column_names": names, "values": values })
}
