//! `solve`, `drift`, `predict_error`, `diagnose`: what SQL asks of one factor or one file.

pub mod diagnose;
pub mod drift;
pub mod predict_error;
pub mod solve;

use std::sync::Arc;

use datafusion::arrow::array::{ArrayRef, BinaryArray, StringArray};
use datafusion::common::Result;
use datafusion::common::cast::{as_binary_array, as_string_array};
use datafusion::logical_expr::ScalarFunctionArgs;
use denavit::identify::RecordingFactor;

use crate::error::FleetError;

/// Arguments as arrays, all of the length of the batch.
fn arrays(args: &ScalarFunctionArgs) -> Result<Vec<ArrayRef>> {
    args.args.iter().map(|value| value.to_array(args.number_rows)).collect()
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

/// The robots of a session, in a function's state. Two of a kind are of one session.
#[derive(Debug, Clone)]
pub struct SessionRobots(pub Arc<crate::robots::Robots>);

impl PartialEq for SessionRobots {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Eq for SessionRobots {}

impl std::hash::Hash for SessionRobots {
    fn hash<H: std::hash::Hasher>(&self, state: &mut H) {
        Arc::as_ptr(&self.0).hash(state);
    }
}
