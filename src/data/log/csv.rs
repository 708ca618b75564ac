//! Reads CSV with a header, plain or gzipped, in the dialect found from its first lines, and writes
//! CSV.

use std::io::{Cursor, Read, Write};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use super::BadCell;
use super::Block;
use super::Layout;
use super::Log;
use super::LogError;
use super::Role;
use super::Table;
use super::unit;

/// Bytes from the start of the file that are examined for the dialect.
const PREVIEW: u64 = 1 << 16;
/// Longest line together with the comment lines before it, bytes.
const LONGEST_LINE: usize = 4 << 20;
/// Largest number of columns.
const MOST_COLUMNS: usize = 1 << 14;
/// Number of cells in a block.
const CELLS: usize = 1 << 17;
/// Size of the read buffer, bytes.
const BUFFER: usize = 1 << 17;

/// Separators and number format of a file.
#[derive(Debug, Clone, PartialEq)]
struct Dialect {
    /// Separator between cells; a space matches any run of blanks.
    separator: u8,
    /// Whether the decimal separator is a comma.
    decimal_comma: bool,
    /// Character that starts comment lines.
    comment: Option<u8>,
    /// The header if it is written in a comment: `# t q1 tau1`.
    header: Option<Vec<String>>,
}

impl Dialect {
    /// Finds the dialect from the first lines.
    fn of(text: &str) -> Self {
        let is_comment = |line: &&str| line.starts_with(['#', '%']);
        let lines: Vec<&str> = text.lines().map(|l| l.trim_start_matches('\u{feff}').trim()).collect();
        let comment = lines.iter().find(|l| !l.is_empty()).filter(|l| is_comment(l)).map(|l| l.as_bytes()[0]);
        let plain: Vec<&str> = lines.iter().filter(|l| !l.is_empty() && !is_comment(l)).copied().collect();
        let remark = lines.iter().take_while(|l| l.is_empty() || is_comment(l)).filter(|l| !l.is_empty()).last();
        let first = plain.first().copied().unwrap_or("");
        // If the first line holds numbers only, the last comment may be the header.
        let numbers = !first.is_empty() && first.split([',', ';', '\t', ' ', '|']).all(|c| number(c, true).is_some());
        let in_comment = remark.filter(|_| numbers).map(|line| line.trim_start_matches(['#', '%']).trim());
        let names = in_comment.unwrap_or(first);
        let separator = separator(names);
        let cells = |line: &str| line.split(separator as char).any(|c| c.contains(',') && number(c, true).is_some());
        let decimal_comma = separator != b',' && plain.iter().skip(usize::from(in_comment.is_none())).any(|l| cells(l));
        let header = in_comment.map(|line| split(line, separator));
        Self { separator, decimal_comma, comment, header }
    }
}

/// Parses a number with a decimal point, or with a decimal comma if `comma` is set.
fn number(cell: &str, comma: bool) -> Option<f64> {
    let cell = cell.trim().trim_matches('"');
    if comma && cell.contains(',') { cell.replacen(',', ".", 1).parse().ok() } else { cell.parse().ok() }
}

fn split(line: &str, separator: u8) -> Vec<String> {
    let cells: Vec<&str> =
        if separator == b' ' { line.split_whitespace().collect() } else { line.split(separator as char).collect() };
    cells.iter().map(|c| c.trim().trim_matches('"').to_string()).collect()
}

/// The separator that splits the header into most known column names; if it has none, the separator
/// that gives most cells.
fn separator(header: &str) -> u8 {
    let known = |s: u8| split(header, s).iter().filter(|c| Role::of(unit::split(c).0).is_some()).count();
    let count = |s: u8| split(header, s).len();
    // `max_by_key` returns the last of equal candidates: the comma is preferred.
    let candidates = [b' ', b'|', b'\t', b';', b','];
    let best = candidates.into_iter().max_by_key(|&s| known(s)).filter(|&s| known(s) > 0);
    // Blanks belong to names such as `q1 [deg]` if another separator is present.
    let other = [b'|', b'\t', b';', b','].into_iter().max_by_key(|&s| count(s)).filter(|&s| count(s) > 1);
    match (best, other) {
        (Some(b' '), Some(other)) => other,
        (Some(best), _) => best,
        (None, Some(other)) => other,
        (None, None) if count(b' ') > 1 => b' ',
        _ => b',',
    }
}

/// Replaces each run of blanks by one comma, so that a CSV reader splits at it.
struct Blanks<R> {
    inner: R,
    line_start: bool,
    pending: bool,
}

impl<R: Read> Read for Blanks<R> {
    fn read(&mut self, out: &mut [u8]) -> std::io::Result<usize> {
        if out.len() < 2 {
            return Ok(0);
        }
        let mut raw = vec![0; out.len() / 2];
        loop {
            let n = self.inner.read(&mut raw)?;
            let mut written = 0;
            for &byte in &raw[..n] {
                match byte {
                    b' ' | b'\t' => self.pending = !self.line_start,
                    _ => {
                        let ends = matches!(byte, b'\n' | b'\r');
                        if std::mem::take(&mut self.pending) && !ends {
                            out[written] = b',';
                            written += 1;
                        }
                        self.line_start = ends;
                        out[written] = byte;
                        written += 1;
                    }
                }
            }
            if written > 0 || n == 0 {
                return Ok(written);
            }
        }
    }
}

/// Limits the bytes read until the limit is reset, so that a line without an end can't fill the
/// memory.
struct Limited<R> {
    inner: R,
    left: Arc<AtomicUsize>,
}

impl<R: Read> Read for Limited<R> {
    fn read(&mut self, out: &mut [u8]) -> std::io::Result<usize> {
        let most = out.len().min(self.left.load(Relaxed));
        if most == 0 && !out.is_empty() {
            let what = format!("a line is longer than {} MiB, so this is no table of samples", LONGEST_LINE >> 20);
            return Err(std::io::Error::other(what));
        }
        let n = self.inner.read(&mut out[..most])?;
        self.left.fetch_sub(n, Relaxed);
        Ok(n)
    }
}

/// A CSV file read row by row.
pub struct CsvTable<'a> {
    file: String,
    names: Vec<String>,
    positions: Vec<usize>,
    reader: ::csv::Reader<Box<dyn Read + Send + 'a>>,
    record: ::csv::ByteRecord,
    decimal_comma: bool,
    /// Bytes that may still be read for the current line.
    left: Arc<AtomicUsize>,
}

impl<'a> CsvTable<'a> {
    /// Reads the header. Separator (comma, semicolon, tab, bar, blanks), decimal comma and comment
    /// lines (`#`, `%`) are detected from the first lines.
    ///
    /// # Errors
    /// If there is no header, or the bytes can't be read.
    pub fn new<R: Read + Send + 'a>(file: &str, mut input: R) -> Result<Self, LogError> {
        let mut start = Vec::new();
        let failed = |source| LogError::Read { file: file.into(), line: 1, source };
        input.by_ref().take(PREVIEW).read_to_end(&mut start).map_err(failed)?;
        let dialect = Dialect::of(&String::from_utf8_lossy(&start));
        let whole = Cursor::new(start).chain(input);
        let blanks = dialect.separator == b' ';
        let left = Arc::new(AtomicUsize::new(LONGEST_LINE + BUFFER));
        let whole = Limited { inner: whole, left: Arc::clone(&left) };
        let whole: Box<dyn Read + Send + 'a> =
            if blanks { Box::new(Blanks { inner: whole, line_start: true, pending: false }) } else { Box::new(whole) };
        let mut reader = ::csv::ReaderBuilder::new()
            .flexible(true)
            .trim(::csv::Trim::All)
            .comment(dialect.comment)
            .delimiter(if blanks { b',' } else { dialect.separator })
            .has_headers(dialect.header.is_none())
            .buffer_capacity(BUFFER)
            .from_reader(whole);
        let names = match dialect.header {
            Some(names) => names,
            None => {
                let header = reader.byte_headers().map_err(|e| read_error(file, 1, e))?;
                if header.len() > MOST_COLUMNS {
                    let what = format!("it has {} cells; {MOST_COLUMNS} columns are read at most", header.len());
                    return Err(LogError::Header { file: file.into(), what });
                }
                header.iter().map(|n| String::from_utf8_lossy(n).trim_start_matches('\u{feff}').trim().into()).collect()
            }
        };
        if names.is_empty() {
            return Err(LogError::Empty { file: file.into() });
        }
        let decimal_comma = dialect.decimal_comma;
        let record = ::csv::ByteRecord::new();
        Ok(Self { file: file.into(), names, positions: Vec::new(), reader, record, decimal_comma, left })
    }
}

impl Table for CsvTable<'_> {
    fn names(&self) -> &[String] {
        &self.names
    }

    fn select(&mut self, positions: &[usize], _clock: usize) -> Result<(), LogError> {
        self.positions = positions.to_vec();
        Ok(())
    }

    fn next_rows(&mut self, rows: usize, block: &mut Block) -> Result<(), LogError> {
        let rows = rows.min(CELLS / self.positions.len().max(1)).max(1);
        while block.len() < rows {
            let line = self.reader.position().line();
            self.left.store(LONGEST_LINE + BUFFER, Relaxed);
            match self.reader.read_byte_record(&mut self.record) {
                Ok(true) => {}
                Ok(false) => break,
                Err(e) => return Err(read_error(&self.file, line, e)),
            }
            let row = block.len();
            block.lines.push(self.record.position().map_or(line, |p| p.line()));
            if self.record.len() != self.names.len() {
                let text = format!("{} cells where the header has {}", self.record.len(), self.names.len());
                block.bad.push(BadCell { row, column: None, text });
            }
            for (column, &position) in self.positions.iter().enumerate() {
                let cell = self.record.get(position).unwrap_or(b"");
                let text = std::str::from_utf8(cell).ok();
                let value = if self.decimal_comma {
                    text.and_then(|t| number(t, true))
                } else {
                    text.and_then(|t| t.parse::<f64>().ok())
                };
                if value.is_none() && !cell.is_empty() {
                    let text = String::from_utf8_lossy(cell).chars().take(40).collect();
                    block.bad.push(BadCell { row, column: Some(column), text });
                }
                block.columns[column].push(value.unwrap_or(f64::NAN));
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

/// Writes a log as CSV, each number with the fewest digits that read back as the same number.
pub fn write<W: Write>(log: &Log, out: W) -> std::io::Result<()> {
    let mut writer = CsvWriter::new(&log.layout, out)?;
    writer.rows(&log.columns)?;
    writer.finish()
}

/// Writes rows as CSV incrementally.
pub struct CsvWriter<W: Write>(std::io::BufWriter<W>);

impl<W: Write> CsvWriter<W> {
    /// Writes the header.
    ///
    /// # Errors
    /// Errors of the writer.
    pub fn new(layout: &Layout, out: W) -> std::io::Result<Self> {
        let mut out = std::io::BufWriter::new(out);
        let names: Vec<String> = layout.roles.iter().map(|r| r.name()).collect();
        writeln!(out, "{}", names.join(","))?;
        Ok(Self(out))
    }

    /// Writes rows: one vector per column.
    ///
    /// # Errors
    /// Errors of the writer.
    pub fn rows(&mut self, columns: &[Vec<f64>]) -> std::io::Result<()> {
        for row in 0..columns.first().map_or(0, Vec::len) {
            for (i, column) in columns.iter().enumerate() {
                if i > 0 {
                    self.0.write_all(b",")?;
                }
                write!(self.0, "{}", column[row])?;
            }
            self.0.write_all(b"\n")?;
        }
        Ok(())
    }

    /// Writes the buffered rows.
    ///
    /// # Errors
    /// Errors of the writer.
    pub fn finish(mut self) -> std::io::Result<()> {
        self.0.flush()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> (Vec<String>, Vec<Vec<f64>>, Vec<u64>) {
        let mut table = CsvTable::new("log.csv", text.as_bytes()).unwrap();
        let all: Vec<usize> = (0..table.names().len()).collect();
        table.select(&all, 0).unwrap();
        let mut block = Block::default();
        block.clear(all.len());
        table.next_rows(100, &mut block).unwrap();
        assert!(block.bad.is_empty(), "{:?}", block.bad);
        (table.names().to_vec(), block.columns, block.lines)
    }

    #[test]
    fn dialects_give_the_same_numbers() {
        let same = [
            "t,q1,tau1\n0,1.5,-2\n0.1,2.5,-3e1\n",
            "\u{feff}t;q1;tau1\r\n0;1,5;-2\r\n0,1;2,5;-3e1\r\n",
            "t\tq1\ttau1\n0\t1.5\t-2\n0.1\t2.5\t-3e1\n",
            "t   q1 tau1\n 0  1.5   -2 \n0.1 2.5 -3e1\n",
            "t|q1|tau1\n0|1.5|-2\n0.1|2.5|-3e1\n",
            "# recorded by somebody\n# t q1 tau1\n0 1.5 -2\n0.1 2.5 -3e1\n",
            "% t,q1,tau1\n0,1.5,-2\n0.1,2.5,-3e1\n",
            "# a comment, with commas\nt,q1,tau1\n0,1.5,-2\n# in between\n0.1,2.5,-3e1\n",
            "\"t\";\"q1\";\"tau1\"\n\"0\";\"1,5\";\"-2\"\n\"0,1\";\"2,5\";\"-3e1\"\n",
        ];
        for text in same {
            let (names, columns, _) = read(text);
            assert_eq!(names, ["t", "q1", "tau1"], "{text}");
            assert_eq!(columns, [vec![0.0, 0.1], vec![1.5, 2.5], vec![-2.0, -30.0]], "{text}");
        }
    }

    #[test]
    fn a_line_without_an_end_is_refused() {
        let text = || std::io::repeat(b'1').take(1 << 30);
        let error = CsvTable::new("log.csv", text()).err().unwrap().to_string();
        assert!(error.contains("a line is longer than 4 MiB"), "{error}");
        // An opening quote is closed neither by the end of the line nor by the end of the file.
        let quoted = (&b"t,q1,tau1\n0,0,\"0\n"[..]).chain(std::io::repeat(b'\n').take(1 << 30));
        let mut table = CsvTable::new("log.csv", quoted).unwrap();
        table.select(&[0, 1, 2], 0).unwrap();
        let mut block = Block::default();
        block.clear(3);
        let error = table.next_rows(100, &mut block).unwrap_err().to_string();
        assert!(error.contains("a line is longer than 4 MiB"), "{error}");
        let header = format!("t{}\n0\n", ",x".repeat(MOST_COLUMNS));
        let error = CsvTable::new("log.csv", header.as_bytes()).err().unwrap().to_string();
        assert!(error.contains("16385 cells"), "{error}");
    }

    #[test]
    fn lines_are_those_of_the_file() {
        let (_, _, lines) = read("# one\n# two\nt;q1\n0;1\n1;2\n");
        assert_eq!(lines, [4, 5]);
    }

    #[test]
    fn blanks_in_names_do_not_separate() {
        let (names, ..) = read("Joint Position 1;Joint Position 2\n1;2\n");
        assert_eq!(names, ["Joint Position 1", "Joint Position 2"]);
        let (names, ..) = read("t [s],q1 [deg]\n1,2\n");
        assert_eq!(names, ["t [s]", "q1 [deg]"]);
    }
}
