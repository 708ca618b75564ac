//! Rows of recordings as Arrow: the columns of `denavit factor`.

use std::sync::{Arc, LazyLock};

use datafusion::arrow::array::{
    ArrayRef, BinaryArray, Date32Array, Float64Array, Int64Array, RecordBatch, StringArray,
};
use datafusion::arrow::datatypes::{DataType, Field, Schema, SchemaRef};
use datafusion::arrow::error::ArrowError;
use denavit::report::FactorRow;

/// The columns.
pub static SCHEMA: LazyLock<SchemaRef> = LazyLock::new(|| {
    let field = |name: &str, kind: DataType, optional: bool| Field::new(name, kind, optional);
    Arc::new(Schema::new(vec![
        field("robot", DataType::Utf8, false),
        field("day", DataType::Date32, true),
        field("file", DataType::Utf8, false),
        field("sha256", DataType::Utf8, true),
        field("samples", DataType::Int64, false),
        field("seconds", DataType::Float64, false),
        field("verdict", DataType::Utf8, false),
        field("temperature", DataType::Float64, true),
        field("factor", DataType::Binary, true),
        field("why", DataType::Utf8, true),
    ]))
});

/// Rows as a batch.
///
/// # Errors
/// What Arrow says.
pub fn batch(rows: &[FactorRow]) -> Result<RecordBatch, ArrowError> {
    let texts = |of: fn(&FactorRow) -> Option<&str>| Arc::new(rows.iter().map(of).collect::<StringArray>()) as ArrayRef;
    let samples = rows.iter().map(|row| i64::try_from(row.samples).unwrap_or(i64::MAX));
    let columns: Vec<ArrayRef> = vec![
        texts(|row| Some(&row.robot)),
        Arc::new(rows.iter().map(|row| row.day).collect::<Date32Array>()),
        texts(|row| Some(&row.file)),
        texts(|row| row.sha256.as_deref()),
        Arc::new(samples.collect::<Vec<_>>().into_iter().map(Some).collect::<Int64Array>()),
        Arc::new(rows.iter().map(|row| Some(row.seconds)).collect::<Float64Array>()),
        texts(|row| Some(row.verdict)),
        Arc::new(rows.iter().map(|row| row.temperature).collect::<Float64Array>()),
        Arc::new(rows.iter().map(|row| row.factor.as_deref()).collect::<BinaryArray>()),
        texts(|row| row.why.as_deref()),
    ];
    RecordBatch::try_new(Arc::clone(&SCHEMA), columns)
}
