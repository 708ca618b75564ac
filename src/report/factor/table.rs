//! The table of a fleet: one row per recording, as Parquet.

use std::sync::Arc;

use ::parquet::{
    basic::Compression,
    data_type::{ByteArray, ByteArrayType, DoubleType, Int32Type, Int64Type},
    errors::ParquetError,
    file::{
        metadata::KeyValue,
        properties::WriterProperties,
        writer::{SerializedFileWriter, SerializedRowGroupWriter},
    },
    schema::parser::parse_message_type,
};

use crate::data::log::Severity;
use crate::identify::FactoredRecording;

/// Columns in order. Missing values are null.
const SCHEMA: &str = "message factors {
    REQUIRED BINARY robot (STRING);
    OPTIONAL INT32 day (DATE);
    REQUIRED BINARY file (STRING);
    OPTIONAL BINARY sha256 (STRING);
    REQUIRED INT64 samples;
    REQUIRED DOUBLE seconds;
    REQUIRED BINARY verdict (STRING);
    OPTIONAL DOUBLE temperature;
    OPTIONAL BINARY factor;
    OPTIONAL BINARY why (STRING);
}";

/// Rows per row group: some MB of factors.
const GROUP: usize = 64;

/// One recording.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FactorRow {
    /// Name of the robot.
    pub robot: String,
    /// Days since 1970, UTC; `None` if the log's time is not a calendar time.
    pub day: Option<i32>,
    /// Path of the log.
    pub file: String,
    /// SHA-256 of the file; `None` if it cannot be read to its end.
    pub sha256: Option<String>,
    /// Number of samples of the motion.
    pub samples: usize,
    /// Seconds of motion.
    pub seconds: f64,
    /// Verdict of the quality check.
    pub verdict: &'static str,
    /// Mean temperature over joints and samples, deg C.
    pub temperature: Option<f64>,
    /// The factor as bytes.
    pub factor: Option<Vec<u8>>,
    /// Reason why there is no factor.
    pub why: Option<String>,
}

impl FactorRow {
    /// The row of a factored recording of this robot.
    pub fn of(robot: &str, file: &str, sha256: String, found: FactoredRecording) -> Self {
        let warns = found.findings.iter().any(|finding| finding.severity != Severity::Note);
        Self {
            robot: robot.into(),
            day: found.day,
            file: file.into(),
            sha256: Some(sha256),
            samples: found.samples,
            seconds: found.factor.factors.seconds,
            verdict: if warns { "warning" } else { "clean" },
            temperature: found.temperature,
            factor: Some(found.factor.to_bytes()),
            why: None,
        }
    }

    /// The row of an unusable recording, with the reason.
    pub fn without(robot: &str, file: &str, sha256: Option<String>, why: String) -> Self {
        let (robot, file) = (robot.into(), file.into());
        Self { robot, file, sha256, verdict: "refused", why: Some(why), ..Self::default() }
    }
}

/// Error while writing the table.
#[derive(Debug, thiserror::Error)]
#[error("the table of factors can't be written: {0}")]
pub struct FactorTableError(#[from] ParquetError);

/// Writes rows to a Parquet file, grouped in row groups.
pub struct FactorTable<W: std::io::Write + Send> {
    writer: SerializedFileWriter<W>,
    group: Vec<FactorRow>,
}

impl<W: std::io::Write + Send> FactorTable<W> {
    /// Starts the file, with names and values for its key-value metadata.
    ///
    /// # Errors
    /// Errors of the target.
    pub fn new(out: W, provenance: &super::super::Provenance) -> Result<Self, FactorTableError> {
        let metadata = provenance.iter().map(|(name, value)| KeyValue::new(name.clone(), value.clone())).collect();
        let properties = WriterProperties::builder()
            .set_compression(Compression::SNAPPY)
            .set_dictionary_enabled(false)
            .set_key_value_metadata(Some(metadata))
            .build();
        let schema = Arc::new(parse_message_type(SCHEMA)?);
        Ok(Self { writer: SerializedFileWriter::new(out, schema, Arc::new(properties))?, group: Vec::new() })
    }

    /// Adds a row.
    ///
    /// # Errors
    /// Errors of the target.
    pub fn row(&mut self, row: FactorRow) -> Result<(), FactorTableError> {
        self.group.push(row);
        if self.group.len() >= GROUP { self.write_group() } else { Ok(()) }
    }

    /// Writes the pending rows and the end of the file.
    ///
    /// # Errors
    /// Errors of the target.
    pub fn finish(mut self) -> Result<(), FactorTableError> {
        if !self.group.is_empty() {
            self.write_group()?;
        }
        self.writer.close()?;
        Ok(())
    }

    fn write_group(&mut self) -> Result<(), FactorTableError> {
        let rows = std::mem::take(&mut self.group);
        let mut group = self.writer.next_row_group()?;
        texts(&mut group, &rows, false, |row| Some(row.robot.as_bytes()))?;
        days(&mut group, &rows)?;
        texts(&mut group, &rows, false, |row| Some(row.file.as_bytes()))?;
        texts(&mut group, &rows, true, |row| row.sha256.as_deref().map(str::as_bytes))?;
        counts(&mut group, &rows)?;
        doubles(&mut group, &rows, false, |row| Some(row.seconds))?;
        texts(&mut group, &rows, false, |row| Some(row.verdict.as_bytes()))?;
        doubles(&mut group, &rows, true, |row| row.temperature)?;
        texts(&mut group, &rows, true, |row| row.factor.as_deref())?;
        texts(&mut group, &rows, true, |row| row.why.as_deref().map(str::as_bytes))?;
        group.close()?;
        Ok(())
    }
}

/// Definition levels: 1 where there is a value.
fn levels<T>(rows: &[FactorRow], of: impl Fn(&FactorRow) -> Option<T>) -> Vec<i16> {
    rows.iter().map(|row| i16::from(of(row).is_some())).collect()
}

type Group<'a, W> = SerializedRowGroupWriter<'a, W>;

fn texts<'r, W: std::io::Write + Send>(
    group: &mut Group<'_, W>,
    rows: &'r [FactorRow],
    optional: bool,
    of: impl Fn(&'r FactorRow) -> Option<&'r [u8]>,
) -> Result<(), ParquetError> {
    let Some(mut column) = group.next_column()? else { return Ok(()) };
    let values: Vec<ByteArray> = rows.iter().filter_map(&of).map(|bytes| bytes.to_vec().into()).collect();
    let levels: Vec<i16> = rows.iter().map(|row| i16::from(of(row).is_some())).collect();
    column.typed::<ByteArrayType>().write_batch(&values, optional.then_some(&levels), None)?;
    column.close()
}

fn doubles<W: std::io::Write + Send>(
    group: &mut Group<'_, W>,
    rows: &[FactorRow],
    optional: bool,
    of: impl Fn(&FactorRow) -> Option<f64>,
) -> Result<(), ParquetError> {
    let Some(mut column) = group.next_column()? else { return Ok(()) };
    let values: Vec<f64> = rows.iter().filter_map(&of).collect();
    column.typed::<DoubleType>().write_batch(&values, optional.then_some(&levels(rows, of)), None)?;
    column.close()
}

fn days<W: std::io::Write + Send>(group: &mut Group<'_, W>, rows: &[FactorRow]) -> Result<(), ParquetError> {
    let Some(mut column) = group.next_column()? else { return Ok(()) };
    let values: Vec<i32> = rows.iter().filter_map(|row| row.day).collect();
    column.typed::<Int32Type>().write_batch(&values, Some(&levels(rows, |row| row.day)), None)?;
    column.close()
}

fn counts<W: std::io::Write + Send>(group: &mut Group<'_, W>, rows: &[FactorRow]) -> Result<(), ParquetError> {
    let Some(mut column) = group.next_column()? else { return Ok(()) };
    let values: Vec<i64> = rows.iter().map(|row| i64::try_from(row.samples).unwrap_or(i64::MAX)).collect();
    column.typed::<Int64Type>().write_batch(&values, None, None)?;
    column.close()
}
