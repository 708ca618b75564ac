//! `solve`, `drift`, `predict_error`, `diagnose`: what SQL asks of one factor or one file.

pub mod diagnose;
mod drift;
mod predict_error;
mod solve;

use std::sync::Arc;

use datafusion::arrow::array::{ArrayRef, BinaryArray, Float64Builder, StringArray, StringBuilder, StructBuilder};
use datafusion::arrow::datatypes::{DataType, Field, Fields};
use datafusion::common::cast::{as_binary_array, as_string_array};
use datafusion::common::{Result, ScalarValue};
use datafusion::execution::runtime_env::RuntimeEnv;
use datafusion::logical_expr::{ColumnarValue, ScalarUDF, Volatility, create_udf};
use denavit::identify::RecordingFactor;

use crate::error::FleetError;
use crate::robots::Robots;

/// All of them, for the robots and the object stores of a session.
pub fn all(robots: &Arc<Robots>, stores: &Arc<RuntimeEnv>) -> [ScalarUDF; 4] {
    let own = || Arc::clone(robots);
    [solve::solve(own()), drift::drift(own()), predict_error::predict_error(), diagnose::udf(own(), Arc::clone(stores))]
}

/// A function from columns of one length to a column.
fn function(
    name: &str,
    inputs: Vec<DataType>,
    output: DataType,
    volatility: Volatility,
    of: impl Fn(&[ArrayRef]) -> Result<ArrayRef> + Send + Sync + 'static,
) -> ScalarUDF {
    let body = move |values: &[ColumnarValue]| {
        let column = of(&ColumnarValue::values_to_arrays(values)?)?;
        match values.iter().all(|value| matches!(value, ColumnarValue::Scalar(_))) {
            true => Ok(ColumnarValue::Scalar(ScalarValue::try_from_array(&column, 0)?)),
            false => Ok(ColumnarValue::Array(column)),
        }
    };
    create_udf(name, inputs, output, volatility, Arc::new(body))
}

/// A column of bytes.
fn binary(array: &ArrayRef) -> Result<&BinaryArray> {
    as_binary_array(array)
}

/// A column of texts.
fn texts(array: &ArrayRef) -> Result<&StringArray> {
    as_string_array(array)
}

/// A factor of a column.
fn factor(bytes: &[u8]) -> Result<RecordingFactor> {
    Ok(RecordingFactor::from_bytes("factor", bytes).map_err(FleetError::from)?)
}

/// Fields that may be null.
fn fields<const N: usize>(all: [(&str, DataType); N]) -> Fields {
    all.into_iter().map(|(name, kind)| Field::new(name, kind, true)).collect()
}

/// A list of rows with these fields.
fn list(fields: Fields) -> DataType {
    DataType::new_list(DataType::Struct(fields), true)
}

/// Appends to a field that holds texts.
fn text_field(row: &mut StructBuilder, at: usize, text: &str) {
    row.field_builder::<StringBuilder>(at).into_iter().for_each(|builder| builder.append_value(text));
}

/// Appends to a field that holds numbers.
fn number_field(row: &mut StructBuilder, at: usize, value: f64) {
    row.field_builder::<Float64Builder>(at).into_iter().for_each(|builder| builder.append_value(value));
}
