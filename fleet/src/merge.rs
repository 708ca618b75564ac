//! `merge_factor(key, factor)`: the factor of all recordings of a group.
//!
//! The state is the list of the keys and factors themselves; they are folded at the end, in the
//! order of the keys. So the bits do not depend on how rows were dealt out and in which order they
//! came, and a recording that came twice counts once.

use std::sync::Arc;

use datafusion::arrow::array::{Array, ArrayRef, AsArray, BinaryArray, ListArray, StringArray};
use datafusion::arrow::datatypes::{DataType, Field, FieldRef};
use datafusion::common::utils::SingleRowListArrayBuilder;
use datafusion::common::{Result, ScalarValue};
use datafusion::logical_expr::function::{AccumulatorArgs, StateFieldsArgs};
use datafusion::logical_expr::utils::{AggregateOrderSensitivity, format_state_name};
use datafusion::logical_expr::{Accumulator, AggregateUDFImpl, Signature, Volatility};
use denavit::identify::{KeyedFactors, RecordingFactor};

use crate::error::FleetError;

/// The aggregate.
#[derive(Debug, PartialEq, Eq, Hash)]
pub struct MergeFactor {
    signature: Signature,
}

impl Default for MergeFactor {
    fn default() -> Self {
        Self { signature: Signature::exact(vec![DataType::Utf8, DataType::Binary], Volatility::Immutable) }
    }
}

impl AggregateUDFImpl for MergeFactor {
    fn name(&self) -> &'static str {
        "merge_factor"
    }

    fn signature(&self) -> &Signature {
        &self.signature
    }

    fn return_type(&self, _: &[DataType]) -> Result<DataType> {
        Ok(DataType::Binary)
    }

    fn accumulator(&self, _: AccumulatorArgs<'_>) -> Result<Box<dyn Accumulator>> {
        Ok(Box::new(Merging::default()))
    }

    fn state_fields(&self, args: StateFieldsArgs<'_>) -> Result<Vec<FieldRef>> {
        let list = |name: &str, kind| {
            Arc::new(Field::new_list(format_state_name(args.name, name), Field::new_list_field(kind, true), true))
        };
        Ok(vec![list("keys", DataType::Utf8), list("factors", DataType::Binary)])
    }

    fn order_sensitivity(&self) -> AggregateOrderSensitivity {
        AggregateOrderSensitivity::Insensitive
    }
}

/// Keys and factors that came so far.
#[derive(Debug, Default)]
struct Merging {
    factors: KeyedFactors,
    /// For the state: what came, as it came.
    rows: Vec<(String, Vec<u8>)>,
    bytes: usize,
}

impl Merging {
    fn take(&mut self, keys: &StringArray, factors: &BinaryArray) -> Result<()> {
        for (key, bytes) in keys.iter().zip(factors) {
            // A recording without a factor, or without a digest, has nothing to merge.
            let (Some(key), Some(bytes)) = (key, bytes) else { continue };
            let factor = RecordingFactor::from_bytes(key, bytes).map_err(FleetError::from)?;
            self.factors.insert(key.into(), factor).map_err(FleetError::from)?;
            self.bytes += key.len() + 2 * bytes.len();
            self.rows.push((key.into(), bytes.to_vec()));
        }
        Ok(())
    }
}

impl Accumulator for Merging {
    fn update_batch(&mut self, values: &[ArrayRef]) -> Result<()> {
        self.take(values[0].as_string(), values[1].as_binary())
    }

    fn merge_batch(&mut self, states: &[ArrayRef]) -> Result<()> {
        let (keys, factors): (&ListArray, &ListArray) = (states[0].as_list(), states[1].as_list());
        for row in (0..keys.len()).filter(|&row| !keys.is_null(row)) {
            self.take(keys.value(row).as_string(), factors.value(row).as_binary())?;
        }
        Ok(())
    }

    fn state(&mut self) -> Result<Vec<ScalarValue>> {
        let rows = std::mem::take(&mut self.rows);
        let keys: StringArray = rows.iter().map(|(key, _)| Some(key)).collect();
        let factors: BinaryArray = rows.iter().map(|(_, bytes)| Some(bytes)).collect();
        Ok(vec![
            SingleRowListArrayBuilder::new(Arc::new(keys)).build_list_scalar(),
            SingleRowListArrayBuilder::new(Arc::new(factors)).build_list_scalar(),
        ])
    }

    fn evaluate(&mut self) -> Result<ScalarValue> {
        let merged = self.factors.fold("merged").map_err(FleetError::from)?;
        Ok(ScalarValue::Binary(merged.map(|factor| factor.to_bytes())))
    }

    fn size(&self) -> usize {
        size_of_val(self) + self.bytes
    }
}
