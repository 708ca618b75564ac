//! `predict_error(factor, model)`: error of a model's torques on a recording, percent of the root
//! mean square of the torque over all joints. `model` is what `solve` returns.

use std::sync::Arc;

use datafusion::arrow::array::{Array, AsArray, Float64Array};
use datafusion::arrow::datatypes::{DataType, Float64Type};
use datafusion::common::Result;
use datafusion::logical_expr::{ColumnarValue, ScalarFunctionArgs, ScalarUDFImpl, Signature, Volatility};
use denavit::identify::{FactorError, Factors};

use super::solve::estimate_fields;
use super::{arrays, binary, factor};
use crate::error::FleetError;

/// The function.
#[derive(Debug, PartialEq, Eq, Hash)]
pub struct PredictError {
    signature: Signature,
}

impl Default for PredictError {
    fn default() -> Self {
        let model = DataType::new_list(DataType::Struct(estimate_fields()), true);
        Self { signature: Signature::exact(vec![DataType::Binary, model], Volatility::Immutable) }
    }
}

impl ScalarUDFImpl for PredictError {
    fn name(&self) -> &'static str {
        "predict_error"
    }

    fn signature(&self) -> &Signature {
        &self.signature
    }

    fn return_type(&self, _: &[DataType]) -> Result<DataType> {
        Ok(DataType::Float64)
    }

    fn invoke_with_args(&self, args: ScalarFunctionArgs) -> Result<ColumnarValue> {
        let arrays = arrays(&args)?;
        let (factors, models) = (binary(&arrays[0])?, arrays[1].as_list::<i32>());
        let error = |row: usize| -> Result<Option<f64>> {
            if factors.is_null(row) || models.is_null(row) {
                return Ok(None);
            }
            let factor = factor(factors.value(row))?;
            let model = models.value(row);
            let beta = model.as_struct().column(1).as_primitive::<Float64Type>().values().to_vec();
            Ok(Some(percent(&factor.factors, &beta)?))
        };
        let errors: Float64Array = (0..args.number_rows).map(error).collect::<Result<_>>()?;
        Ok(ColumnarValue::Array(Arc::new(errors)))
    }
}

/// Over all joints, percent.
fn percent(factors: &Factors, beta: &[f64]) -> Result<f64, FleetError> {
    if beta.len() != factors.parameters {
        return Err(FactorError::OtherRobot { key: factors.name.clone() }.into());
    }
    let live = || factors.joints.iter().filter(|joint| joint.is_live());
    let missed: f64 = live().map(|joint| joint.residual_norm(beta).powi(2)).sum();
    let whole: f64 = live().map(|joint| joint.torque_rms().powi(2) * joint.samples as f64).sum();
    Ok(100.0 * (missed / whole).sqrt())
}
