//! `predict_error(factor, model)`: error of a model's torques on a recording, percent of the root
//! mean square of the torque over all joints. `model` is what `solve` returns.

use std::sync::Arc;

use datafusion::arrow::array::{Array, ArrayRef, AsArray, Float64Array};
use datafusion::arrow::datatypes::{DataType, Float64Type};
use datafusion::common::Result;
use datafusion::logical_expr::{ScalarUDF, Volatility};
use denavit::identify::{FactorError, Factors};

use super::solve::estimate_fields;
use super::{binary, factor, function, list};
use crate::error::FleetError;

/// The function.
pub(super) fn predict_error() -> ScalarUDF {
    let inputs = vec![DataType::Binary, list(estimate_fields())];
    function("predict_error", inputs, DataType::Float64, Volatility::Immutable, errors)
}

fn errors(arrays: &[ArrayRef]) -> Result<ArrayRef> {
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
    let errors: Float64Array = (0..factors.len()).map(error).collect::<Result<_>>()?;
    Ok(Arc::new(errors))
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
