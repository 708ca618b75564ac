//! `solve(factor)`: base parameters with standard deviations, as a list of `{name, value, std}`.

use std::sync::Arc;

use datafusion::arrow::array::{Array, Float64Builder, ListBuilder, StringBuilder, StructBuilder};
use datafusion::arrow::datatypes::{DataType, Field, Fields};
use datafusion::common::Result;
use datafusion::logical_expr::{ColumnarValue, ScalarFunctionArgs, ScalarUDFImpl, Signature, Volatility};

use super::{SessionRobots, arrays, binary, factor};

/// The function.
#[derive(Debug, PartialEq, Eq, Hash)]
pub struct Solve {
    robots: SessionRobots,
    signature: Signature,
}

impl Solve {
    /// For robots of a session.
    pub fn new(robots: SessionRobots) -> Self {
        Self { robots, signature: Signature::exact(vec![DataType::Binary], Volatility::Immutable) }
    }
}

/// Fields of an estimate.
pub(super) fn estimate_fields() -> Fields {
    let number = |name: &str| Field::new(name, DataType::Float64, true);
    Fields::from(vec![Field::new("name", DataType::Utf8, true), number("value"), number("std")])
}

impl ScalarUDFImpl for Solve {
    fn name(&self) -> &'static str {
        "solve"
    }

    fn signature(&self) -> &Signature {
        &self.signature
    }

    fn return_type(&self, _: &[DataType]) -> Result<DataType> {
        Ok(DataType::new_list(DataType::Struct(estimate_fields()), true))
    }

    fn invoke_with_args(&self, args: ScalarFunctionArgs) -> Result<ColumnarValue> {
        let arrays = arrays(&args)?;
        let mut lists = ListBuilder::new(StructBuilder::from_fields(estimate_fields(), 0));
        for bytes in binary(&arrays[0])? {
            let Some(bytes) = bytes else {
                lists.append_null();
                continue;
            };
            let factor = factor(bytes)?;
            let robot = self.robots.0.of(&factor)?;
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
        Ok(ColumnarValue::Array(Arc::new(lists.finish()) as Arc<dyn Array>))
    }
}

/// Appends to a field that holds texts.
pub(super) fn text_field(row: &mut StructBuilder, at: usize, text: &str) {
    row.field_builder::<StringBuilder>(at).into_iter().for_each(|builder| builder.append_value(text));
}

/// Appends to a field that holds numbers.
pub(super) fn number_field(row: &mut StructBuilder, at: usize, value: f64) {
    row.field_builder::<Float64Builder>(at).into_iter().for_each(|builder| builder.append_value(value));
}
