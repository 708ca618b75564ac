//! Reader of a CSV file of numbers with a header.

use std::path::Path;

use super::Failure;
use super::files;

/// Numbers with a header. A cell that is not a number only matters if its column is requested.
pub(super) struct Table {
    pub(super) file: String,
    columns: Vec<Column>,
    pub(super) len: usize,
}

struct Column {
    name: String,
    values: Vec<f64>,
    /// First cell that is not a finite number, and its line.
    bad: Option<(String, u64)>,
}

impl Table {
    pub(super) fn read(path: &Path) -> Result<Self, Failure> {
        let file = path.display().to_string();
        let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(files::open(path)?);
        let wrong = |e: csv::Error| Failure::input(format!("{file}: {e}; write one row of numbers per state"));
        let header = reader.headers().map_err(wrong)?;
        if header.is_empty() {
            return Err(Failure::input(format!("{file} is empty; its first line must name the columns (see --help)")));
        }
        if let Some(twice) = header.iter().enumerate().find(|(k, name)| header.iter().take(*k).any(|n| n == *name)) {
            let name = twice.1;
            return Err(Failure::input(format!(
                "{file}, line 1: two columns are named `{name}`; rename or delete one"
            )));
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

    /// Whether there is a column of this name.
    pub(super) fn has(&self, name: &str) -> bool {
        self.columns.iter().any(|c| c.name == name)
    }

    /// Number of columns `prefix1, prefix2, ..` without a gap.
    pub(super) fn count(&self, prefix: &str) -> usize {
        (1..).take_while(|j| self.has(&format!("{prefix}{j}"))).count()
    }

    /// Values of one column.
    pub(super) fn column(&self, name: &str) -> Result<&[f64], Failure> {
        let file = &self.file;
        let column = self.columns.iter().find(|c| c.name == name).ok_or_else(|| {
            let known: Vec<&str> = self.columns.iter().map(|c| c.name.as_str()).take(30).collect();
            let mend = match known.as_slice() {
                [one] if one.contains([';', '\t']) => "; put commas between the cells",
                some if some.iter().all(|name| name.parse::<f64>().is_ok()) => "; the first line must name the columns",
                _ => "",
            };
            Failure::input(format!("{file}, line 1: there is no column {name}; there are {}{mend}", known.join(", ")))
        })?;
        match &column.bad {
            Some((cell, line)) => Err(Failure::input(format!(
                "{file}, line {line}, column {name}: `{cell}` is not a finite number; mend the cell or leave out the row"
            ))),
            None => Ok(&column.values),
        }
    }

    /// Columns `prefix1..prefixn`, joint-major.
    pub(super) fn joints(&self, prefix: &str, n: usize) -> Result<Vec<f64>, Failure> {
        let file = &self.file;
        let mut all = Vec::with_capacity(n * self.len);
        for j in 1..=n {
            let name = format!("{prefix}{j}");
            if !self.has(&name) {
                return Err(Failure::input(format!(
                    "{file}, line 1: there is no column {name}; the robot has {n} joint{}, and each needs its column",
                    if n == 1 { "" } else { "s" }
                )));
            }
            all.extend_from_slice(self.column(&name)?);
        }
        let beyond = format!("{prefix}{}", n + 1);
        if self.has(&beyond) {
            return Err(Failure::input(format!(
                "{file}, line 1: there is a column {beyond}, and the robot has {n} joint{}; joints are counted from 1 without fixed rows",
                if n == 1 { "" } else { "s" }
            )));
        }
        Ok(all)
    }
}
