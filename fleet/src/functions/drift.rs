//! `drift(factor, reference)`: by how much a factor leaves the model of another one, channel by
//! channel: a list of `{kind, joint, parameter, value, std, z}`.

use std::sync::Arc;

use datafusion::arrow::array::{ArrayRef, Int64Builder, ListBuilder, StructBuilder};
use datafusion::arrow::datatypes::{DataType, Fields};
use datafusion::common::Result;
use datafusion::logical_expr::{ScalarUDF, Volatility};

use super::{binary, factor, fields, function, list, number_field, text_field};
use crate::error::FleetError;
use crate::reference::Reference;
use crate::robots::Robots;

fn change_fields() -> Fields {
    fields([
        ("kind", DataType::Utf8),
        ("joint", DataType::Int64),
        ("parameter", DataType::Utf8),
        ("value", DataType::Float64),
        ("std", DataType::Float64),
        ("z", DataType::Float64),
    ])
}

/// The function.
pub(super) fn drift(robots: Arc<Robots>) -> ScalarUDF {
    let (inputs, output) = (vec![DataType::Binary, DataType::Binary], list(change_fields()));
    function("drift", inputs, output, Volatility::Immutable, move |arrays| changes(&robots, arrays))
}

fn changes(robots: &Robots, arrays: &[ArrayRef]) -> Result<ArrayRef> {
    let mut lists = ListBuilder::new(StructBuilder::from_fields(change_fields(), 0));
    // Rows of one robot stand together, so its model is found once for many.
    let mut last: Option<(Vec<u8>, Reference)> = None;
    for (bytes, model) in binary(&arrays[0])?.iter().zip(binary(&arrays[1])?) {
        let (Some(bytes), Some(model)) = (bytes, model) else {
            lists.append_null();
            continue;
        };
        let factors = factor(bytes)?;
        let robot = robots.of(&factors)?;
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
    Ok(Arc::new(lists.finish()))
}
