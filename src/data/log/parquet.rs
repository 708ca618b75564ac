//! Parquet files: flat, numeric columns of the same names as in a CSV.

use std::sync::Arc;

use ::parquet::{
    column::reader::{ColumnReader, ColumnReaderImpl},
    data_type::{DataType, DoubleType, FloatType, Int32Type, Int64Type},
    errors::ParquetError,
    file::{
        properties::WriterProperties,
        reader::{FileReader, SerializedFileReader},
        writer::SerializedFileWriter,
    },
    schema::parser::parse_message_type,
};
use bytes::Bytes;

use super::BadCell;
use super::Block;
use super::Layout;
use super::Log;
use super::LogError;
use super::Source;

/// A Parquet file that is read row group by row group, a block of rows at a time.
pub struct ParquetSource {
    layout: Layout,
    reader: SerializedFileReader<Bytes>,
    group: usize,
    left: usize,
    columns: Vec<ColumnReader>,
    row: u64,
}

impl ParquetSource {
    /// Reads the schema.
    pub fn new(file: &str, bytes: Bytes) -> Result<Self, LogError> {
        let reader = SerializedFileReader::new(bytes).map_err(|e| failed(file, e))?;
        let schema = reader.metadata().file_metadata().schema_descr();
        let names: Vec<String> = schema.columns().iter().map(|c| c.path().string()).collect();
        if names.is_empty() {
            return Err(LogError::Empty { file: file.into() });
        }
        let layout = Layout::new(file, &names)?;
        for (&position, role) in layout.positions.iter().zip(&layout.roles) {
            if schema.column(position).max_rep_level() > 0 || schema.column(position).max_def_level() > 1 {
                let what = format!("the column `{}` is nested; write plain numbers", role.name());
                return Err(LogError::Parquet { file: file.into(), what });
            }
        }
        Ok(Self { layout, reader, group: 0, left: 0, columns: Vec::new(), row: 1 })
    }

    /// Opens the next row group that has rows; false at the end.
    fn open_group(&mut self) -> Result<bool, ParquetError> {
        while self.left == 0 {
            if self.group >= self.reader.num_row_groups() {
                return Ok(false);
            }
            let group = self.reader.get_row_group(self.group)?;
            self.left = usize::try_from(group.metadata().num_rows()).unwrap_or(0);
            self.columns =
                self.layout.positions.iter().map(|&i| group.get_column_reader(i)).collect::<Result<_, _>>()?;
            self.group += 1;
        }
        Ok(true)
    }
}

impl Source for ParquetSource {
    fn layout(&self) -> &Layout {
        &self.layout
    }

    fn next_block(&mut self, rows: usize, block: &mut Block) -> Result<(), LogError> {
        block.clear(self.layout.roles.len());
        let file = self.layout.file.clone();
        while block.len() < rows && self.open_group().map_err(|e| failed(&file, e))? {
            let take = self.left.min(rows - block.len());
            let start = block.len();
            for ((column, reader), role) in self.columns.iter_mut().enumerate().zip(&self.layout.roles) {
                let out = &mut block.columns[column];
                let read = match reader {
                    ColumnReader::DoubleColumnReader(r) => pull::<DoubleType>(r, take, out, |v| v),
                    ColumnReader::FloatColumnReader(r) => pull::<FloatType>(r, take, out, f64::from),
                    ColumnReader::Int32ColumnReader(r) => pull::<Int32Type>(r, take, out, f64::from),
                    ColumnReader::Int64ColumnReader(r) => pull::<Int64Type>(r, take, out, |v| v as f64),
                    _ => {
                        let what = format!("the column `{}` holds no numbers", role.name());
                        return Err(LogError::Parquet { file, what });
                    }
                };
                read.map_err(|e| failed(&file, e))?;
                if out.len() != start + take {
                    let text = "a column that ends early".to_string();
                    block.bad.push(BadCell { row: out.len().max(1) - 1, column: Some(column), text });
                    out.resize(start + take, f64::NAN);
                }
            }
            block.lines.extend((0..take as u64).map(|i| self.row + i + 1));
            self.row += take as u64;
            self.left -= take;
        }
        Ok(())
    }
}

/// Appends `take` rows of a column, NaN where the value is null.
fn pull<T: DataType>(
    reader: &mut ColumnReaderImpl<T>,
    take: usize,
    out: &mut Vec<f64>,
    convert: impl Fn(T::T) -> f64,
) -> Result<(), ParquetError>
where
    T::T: Clone,
{
    let mut done = 0;
    while done < take {
        let (mut values, mut defined) = (Vec::with_capacity(take - done), Vec::new());
        let (records, found, _) = reader.read_records(take - done, Some(&mut defined), None, &mut values)?;
        if records == 0 {
            break;
        }
        let mut next = values.into_iter().take(found);
        if defined.is_empty() {
            out.extend(next.map(&convert));
        } else {
            let full = defined.iter().copied().max().unwrap_or(0).max(1);
            out.extend(
                defined.iter().map(|&d| if d == full { next.next().map_or(f64::NAN, &convert) } else { f64::NAN }),
            );
        }
        done += records;
    }
    Ok(())
}

fn failed(file: &str, error: ParquetError) -> LogError {
    LogError::Parquet { file: file.into(), what: error.to_string() }
}

/// Writes a log as a Parquet file of doubles, one row group.
pub fn write<W: std::io::Write + Send>(log: &Log, out: W) -> Result<(), LogError> {
    let file = log.layout.file.as_str();
    let fields: String = log.layout.roles.iter().map(|r| format!("REQUIRED DOUBLE {};", r.name())).collect();
    let schema = Arc::new(parse_message_type(&format!("message log {{ {fields} }}")).map_err(|e| failed(file, e))?);
    let properties = WriterProperties::builder().set_compression(::parquet::basic::Compression::SNAPPY).build();
    let put = || -> Result<(), ParquetError> {
        let mut writer = SerializedFileWriter::new(out, schema, Arc::new(properties))?;
        let mut group = writer.next_row_group()?;
        for column in &log.columns {
            if let Some(mut target) = group.next_column()? {
                target.typed::<DoubleType>().write_batch(column, None, None)?;
                target.close()?;
            }
        }
        group.close()?;
        writer.close()?;
        Ok(())
    };
    put().map_err(|e| failed(file, e))
}
