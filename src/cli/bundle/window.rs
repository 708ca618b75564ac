//! Time window of a log that goes into a bundle.

use std::fmt::Write;
use std::path::Path;
use std::str::FromStr;

use super::super::Failure;
use super::super::files;
use crate::data::log::{Block, LogError, Reading, open_table};

/// First and last time, in the unit of a log's column `t`.
#[derive(Debug, Clone)]
pub(super) struct Window([f64; 2]);

impl FromStr for Window {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let ends: Vec<f64> = text.split(',').filter_map(|end| end.trim().parse().ok()).collect();
        match ends[..] {
            [from, to] if from < to => Ok(Self([from, to])),
            _ => Err("two times with a comma between them, the earlier one first: 12,15".into()),
        }
    }
}

impl Window {
    pub(super) fn text(&self) -> String {
        format!("{},{}", self.0[0], self.0[1])
    }

    /// Rows of a log within the window as CSV, with all numeric columns. `None` if the file is no
    /// log.
    pub(super) fn cut(&self, path: &Path) -> Result<Option<Vec<u8>>, Failure> {
        let no_log = ["yaml", "yml", "json", "urdf", "xml", "toml"];
        if path.extension().is_some_and(|e| no_log.iter().any(|other| e == *other)) {
            return Ok(None);
        }
        let shown = path.display().to_string();
        self.rows(&shown, path).map(Some).map_err(Failure::input)
    }

    fn rows(&self, shown: &str, path: &Path) -> Result<Vec<u8>, LogError> {
        let foreign = |what: String| LogError::Foreign { file: shown.into(), what };
        let input = files::open(path).map_err(|e| foreign(e.message))?;
        let mut table = open_table(shown, input, &Reading::default())?;
        let columns: Vec<usize> = (0..table.names().len()).filter(|&k| table.is_numeric(k)).collect();
        let names: Vec<String> = columns.iter().map(|&k| table.names()[k].clone()).collect();
        let of_time = |name: &String| matches!(name.split(['[', ' ']).next(), Some("t" | "time" | "timestamp"));
        let Some(time) = names.iter().position(of_time) else {
            return Err(foreign("it has no column `t`, so no window can be cut from it; leave out --window".into()));
        };
        table.select(&columns, columns[time])?;
        let quoted: Vec<String> = names.iter().map(|name| format!("\"{}\"", name.replace('"', "\"\""))).collect();
        let mut text = quoted.join(",") + "\n";
        let mut block = Block::default();
        loop {
            block.clear(columns.len());
            table.next_rows(4096, &mut block)?;
            if block.is_empty() {
                return Ok(text.into_bytes());
            }
            for row in (0..block.len()).filter(|&k| (self.0[0]..=self.0[1]).contains(&block.columns[time][k])) {
                let cells: Vec<String> = block.columns.iter().map(|column| column[row].to_string()).collect();
                let _ = writeln!(text, "{}", cells.join(","));
            }
        }
    }
}
