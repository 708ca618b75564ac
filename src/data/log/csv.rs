//! CSV with a header, plain or gzipped; and the way back.

use std::io::{Read, Write};

use super::BadCell;
use super::Block;
use super::Layout;
use super::Log;
use super::LogError;
use super::Source;

/// A CSV that is read row by row.
pub struct CsvSource<R> {
    layout: Layout,
    reader: ::csv::Reader<R>,
    record: ::csv::ByteRecord,
}

impl<R: Read> CsvSource<R> {
    /// Reads the header.
    pub fn new(file: &str, input: R) -> Result<Self, LogError> {
        let mut reader = ::csv::ReaderBuilder::new()
            .flexible(true)
            .trim(::csv::Trim::All)
            .buffer_capacity(1 << 17)
            .from_reader(input);
        let header = reader.byte_headers().map_err(|e| read_error(file, 1, e))?;
        if header.is_empty() {
            return Err(LogError::Empty { file: file.into() });
        }
        let names: Vec<String> = header.iter().map(|n| String::from_utf8_lossy(n).into_owned()).collect();
        Ok(Self { layout: Layout::new(file, &names)?, reader, record: ::csv::ByteRecord::new() })
    }
}

impl<R: Read> Source for CsvSource<R> {
    fn layout(&self) -> &Layout {
        &self.layout
    }

    fn next_block(&mut self, rows: usize, block: &mut Block) -> Result<(), LogError> {
        block.clear(self.layout.roles.len());
        while block.len() < rows {
            let line = self.reader.position().line();
            match self.reader.read_byte_record(&mut self.record) {
                Ok(true) => {}
                Ok(false) => break,
                Err(e) => return Err(read_error(&self.layout.file, line, e)),
            }
            let row = block.len();
            block.lines.push(self.record.position().map_or(line, |p| p.line()));
            if self.record.len() != self.layout.width {
                let text = format!("{} cells where the header has {}", self.record.len(), self.layout.width);
                block.bad.push(BadCell { row, column: None, text });
            }
            for (column, &position) in self.layout.positions.iter().enumerate() {
                let cell = self.record.get(position).unwrap_or(b"");
                let value = match std::str::from_utf8(cell).ok().map(str::parse::<f64>) {
                    Some(Ok(value)) => value,
                    _ => {
                        if !cell.is_empty() {
                            let text = String::from_utf8_lossy(cell).chars().take(40).collect();
                            block.bad.push(BadCell { row, column: Some(column), text });
                        }
                        f64::NAN
                    }
                };
                block.columns[column].push(value);
            }
        }
        Ok(())
    }
}

fn read_error(file: &str, line: u64, error: ::csv::Error) -> LogError {
    let source = match error.into_kind() {
        ::csv::ErrorKind::Io(source) => source,
        other => std::io::Error::other(format!("{other:?}")),
    };
    LogError::Read { file: file.into(), line, source }
}

/// Writes a log as CSV, every number with as many digits as it takes to read the same number back.
pub fn write<W: Write>(log: &Log, out: W) -> std::io::Result<()> {
    let mut out = std::io::BufWriter::new(out);
    let names: Vec<String> = log.layout.roles.iter().map(|r| r.name()).collect();
    writeln!(out, "{}", names.join(","))?;
    for row in 0..log.len() {
        for (i, column) in log.columns.iter().enumerate() {
            if i > 0 {
                out.write_all(b",")?;
            }
            write!(out, "{}", column[row])?;
        }
        out.write_all(b"\n")?;
    }
    out.flush()
}
