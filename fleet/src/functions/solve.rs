//! `solve(factor)`: base parameters with standard deviations, as a list of `{name, value, std}`.

use std::sync::Arc;

use datafusion::arrow::array::{ArrayRef, ListBuilder, StructBuilder};
use datafusion::arrow::datatypes::{DataType, Fields};
use datafusion::common::Result;
use datafusion::logical_expr::{ScalarUDF, Volatility};

use super::{binary, factor, fields, function, list, number_field, text_field};
use crate::robots::Robots;

/// Fields of an estimate.
pub(super) fn estimate_fields() -> Fields {
    fields([("name", DataType::Utf8), ("value", DataType::Float64), ("std", DataType::Float64)])
}

/// The function.
pub(super) fn solve(robots: Arc<Robots>) -> ScalarUDF {
    let (input, output) = (vec![DataType::Binary], list(estimate_fields()));
    function("solve", input, output, Volatility::Immutable, move |arrays| models(&robots, arrays))
}

fn models(robots: &Robots, arrays: &[ArrayRef]) -> Result<ArrayRef> {
    let mut lists = ListBuilder::new(StructBuilder::from_fields(estimate_fields(), 0));
    for bytes in binary(&arrays[0])? {
        let Some(bytes) = bytes else {
            lists.append_null();
            continue;
        };
        let factor = factor(bytes)?;
        let robot = robots.of(&factor)?;
        let found = robot.solve(&robot.robot.name, &[factor.factors])?;
        for parameter in &found.parameters {
            let row = lists.values();
            text_field(row, 0, &parameter.name);
            number_field(row, 1, parameter.value);
            number_field(row, 2, parameter.std);
            row.append(true);
        }
        lists.append(true);
    }
    Ok(Arc::new(lists.finish()))
}
