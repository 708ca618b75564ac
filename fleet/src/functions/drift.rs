//! `drift(factor, reference)`: by how much a factor leaves the model of another one, channel by
//! channel: a list of `{kind, joint, parameter, value, std, z}`.

use std::sync::Arc;

use datafusion::arrow::array::{Array, Int64Builder, ListBuilder, StructBuilder};
use datafusion::arrow::datatypes::{DataType, Field, Fields};
use datafusion::common::Result;
use datafusion::logical_expr::{ColumnarValue, ScalarFunctionArgs, ScalarUDFImpl, Signature, Volatility};

use super::solve::{number_field, text_field};
use super::{SessionRobots, arrays, binary, factor};
use crate::error::FleetError;
use crate::reference::Reference;

/// The function.
#[derive(Debug, PartialEq, Eq, Hash)]
pub struct Drift {
    robots: SessionRobots,
    signature: Signature,
}

impl Drift {
    /// For robots of a session.
    pub fn new(robots: SessionRobots) -> Self {
        Self { robots, signature: Signature::exact(vec![DataType::Binary, DataType::Binary], Volatility::Immutable) }
    }
}

fn fields() -> Fields {
    let field = |name: &str, kind: DataType| Field::new(name, kind, true);
    Fields::from(vec![
        field("kind", DataType::Utf8),
        field("joint", DataType::Int64),
        field("parameter", DataType::Utf8),
        field("value", DataType::Float64),
        field("std", DataType::Float64),
        field("z", DataType::Float64),
    ])
}

impl ScalarUDFImpl for Drift {
    fn name(&self) -> &'static str {
        "drift"
    }

    fn signature(&self) -> &Signature {
        &self.signature
    }

    fn return_type(&self, _: &[DataType]) -> Result<DataType> {
        Ok(DataType::new_list(DataType::Struct(fields()), true))
    }

    fn invoke_with_args(&self, args: ScalarFunctionArgs) -> Result<ColumnarValue> {
        let arrays = arrays(&args)?;
        let mut lists = ListBuilder::new(StructBuilder::from_fields(fields(), 0));
        // Rows of one robot stand together, so its model is found once for many.
        let mut last: Option<(Vec<u8>, Reference)> = None;
        for (bytes, model) in binary(&arrays[0])?.iter().zip(binary(&arrays[1])?) {
            let (Some(bytes), Some(model)) = (bytes, model) else {
                lists.append_null();
                continue;
            };
            let factors = factor(bytes)?;
            let robot = self.robots.0.of(&factors)?;
            let reference = match last.take().filter(|(known, _)| known == model) {
                Some((_, reference)) => reference,
                None => {
                    let whole = factor(model)?;
                    let name = || FleetError::NoReference { what: robot.robot.name.clone() };
                    Reference::of(&whole.factors).ok_or_else(name)?
                }
            };
            let estimates = robot.channels.estimates(&factors.factors, &reference);
            for (channel, estimate) in robot.channels.list.iter().zip(estimates) {
                let (row, std) = (lists.values(), estimate.variance.sqrt());
                text_field(row, 0, channel.kind.name());
                let joint = i64::try_from(channel.joint).unwrap_or(i64::MAX);
                row.field_builder::<Int64Builder>(1).into_iter().for_each(|b| b.append_value(joint));
                text_field(row, 2, &channel.parameter);
                number_field(row, 3, estimate.value);
                number_field(row, 4, std);
                number_field(row, 5, estimate.value / std);
                row.append(true);
            }
            lists.append(true);
            last = Some((model.to_vec(), reference));
        }
        Ok(ColumnarValue::Array(Arc::new(lists.finish()) as Arc<dyn Array>))
    }
}
