//! A CSV file of numbers.

use super::{Failure, files};

/// Numbers with a header. What is not a number matters only in a column that is asked for.
pub(super) struct Table {
    file: String,
    columns: Vec<Column>,
    /// Number of rows.
    pub len: usize,
}

struct Column {
    name: String,
    values: Vec<f64>,
    /// The first cell that is not a finite number, and its line.
    bad: Option<(String, u64)>,
}

impl Table {
    pub fn read(path: &std::path::Path) -> Result<Self, Failure> {
        let file = path.display().to_string();
        let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(files::open(path)?);
        let wrong = |e: csv::Error| Failure::input(format!("{file}: {e}; write one row of numbers per state"));
        let header = reader.headers().map_err(wrong)?;
        if header.is_empty() {
            return Err(Failure::input(format!("{file} is empty; its first line must name the columns: q1, q2, ..")));
        }
        let column = |name: &str| Column { name: name.into(), values: Vec::new(), bad: None };
        let mut columns: Vec<Column> = header.iter().map(column).collect();
        let mut len = 0;
        for row in reader.records() {
            let row = row.map_err(wrong)?;
            for (cell, column) in row.iter().zip(&mut columns) {
                let value = cell.parse().ok().filter(|v: &f64| v.is_finite());
                if value.is_none() && column.bad.is_none() {
                    column.bad = Some((cell.into(), row.position().map_or(0, csv::Position::line)));
                }
                column.values.push(value.unwrap_or(f64::NAN));
            }
            len += 1;
        }
        Ok(Self { file, columns, len })
    }

    /// Columns `prefix1..prefixn`, joint-major.
    pub fn joints(&self, prefix: &str, n: usize) -> Result<Vec<f64>, Failure> {
        let file = &self.file;
        let mut all = Vec::with_capacity(n * self.len);
        for j in 1..=n {
            let name = format!("{prefix}{j}");
            let column = self.columns.iter().find(|c| c.name == name).ok_or_else(|| {
                Failure::input(format!(
                    "{file}, line 1: there is no column {name}; the robot has {n} joints, so {prefix}1 to {prefix}{n} are needed"
                ))
            })?;
            all.extend_from_slice(self.whole(column)?);
        }
        Ok(all)
    }

    /// A column that may be missing.
    pub fn column(&self, name: &str) -> Result<Option<&[f64]>, Failure> {
        self.columns.iter().find(|c| c.name == name).map(|c| self.whole(c)).transpose()
    }

    /// The file's name, as it was given.
    pub fn file(&self) -> &str {
        &self.file
    }

    fn whole<'a>(&self, column: &'a Column) -> Result<&'a [f64], Failure> {
        match &column.bad {
            Some((cell, line)) => Err(Failure::input(format!(
                "{}, line {line}, column {}: `{cell}` is not a finite number; mend the cell or leave out the row",
                self.file, column.name
            ))),
            None => Ok(&column.values),
        }
    }
}
