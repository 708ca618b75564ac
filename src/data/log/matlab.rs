//! Reads MATLAB `.mat` files of level 5 (versions 5 to 7): numeric arrays and structures of them.

use std::io::Read;

use super::arrays::{Array, ArrayTable, MOST_NUMBERS};
use super::malformed::TooManyNumbers;
use super::{Block, LogError, Table};

/// Deepest nesting of structures that is read.
const DEEPEST: usize = 8;

/// Reason why a file is not a valid MATLAB file of level 5.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum MatError {
    /// The file is truncated.
    #[error("it ends in the middle of a variable")]
    Short,
    /// A compressed variable is damaged.
    #[error("a variable can't be unpacked: {0}")]
    Unpack(#[source] std::io::Error),
    /// A variable has no array flags.
    #[error("a variable has no class")]
    NoClass,
    /// A variable has fewer numbers than its dimensions state.
    #[error("the variable `{0}` ends before its last number")]
    ShortVariable(String),
    /// The file is too large for memory.
    #[error(transparent)]
    TooLarge(#[from] TooManyNumbers),
}

/// A `.mat` file as a table.
pub struct MatTable(ArrayTable);

impl MatTable {
    /// Reads the numeric variables; fields of structures are named `name.field`.
    ///
    /// # Errors
    /// If the file is damaged or too large for memory.
    pub fn new(file: &str, bytes: &[u8]) -> Result<Self, LogError> {
        let mut reader = MatReader { big: bytes.get(126..128) == Some(b"MI"), arrays: Vec::new(), left: MOST_NUMBERS };
        reader.elements(bytes.get(128..).unwrap_or(&[])).map_err(|e| LogError::malformed(file, "mat", e))?;
        Ok(Self(ArrayTable::new(file, "mat", reader.arrays)?))
    }
}

impl Table for MatTable {
    fn names(&self) -> &[String] {
        self.0.names()
    }

    fn select(&mut self, positions: &[usize], clock: usize) -> Result<(), LogError> {
        self.0.select(positions, clock)
    }

    fn next_rows(&mut self, rows: usize, block: &mut Block) -> Result<(), LogError> {
        self.0.next_rows(rows, block)
    }
}

struct MatReader {
    big: bool,
    arrays: Vec<Array>,
    /// Numbers that may still be read into memory.
    left: usize,
}

/// A data element: its type, its bytes, and the bytes after it.
type Element<'a> = (u32, &'a [u8], &'a [u8]);

impl MatReader {
    fn u32(&self, bytes: &[u8]) -> Option<u32> {
        let four: [u8; 4] = bytes.get(..4)?.try_into().ok()?;
        Some(if self.big { u32::from_be_bytes(four) } else { u32::from_le_bytes(four) })
    }

    fn element<'a>(&self, bytes: &'a [u8]) -> Result<Element<'a>, MatError> {
        let kind = self.u32(bytes).ok_or(MatError::Short)?;
        // Up to four bytes of data are stored in the tag itself.
        let (small, small_kind) = ((kind >> 16) as usize, kind & 0xffff);
        if small != 0 {
            let (data, rest) = (bytes.get(4..4 + small), bytes.get(8..));
            return Ok((small_kind, data.filter(|_| small <= 4).ok_or(MatError::Short)?, rest.ok_or(MatError::Short)?));
        }
        let size = self.u32(bytes.get(4..).unwrap_or(&[])).ok_or(MatError::Short)? as usize;
        let data = bytes.get(8..8 + size).ok_or(MatError::Short)?;
        // Compressed elements are not padded; all others are padded to eight bytes.
        let padded = if kind == 15 { size } else { size.next_multiple_of(8) };
        Ok((kind, data, bytes.get(8 + padded..).unwrap_or(&[])))
    }

    fn elements(&mut self, mut bytes: &[u8]) -> Result<(), MatError> {
        while !bytes.is_empty() {
            let (kind, data, rest) = self.element(bytes)?;
            match kind {
                14 => self.matrix(data, "", 0)?,
                15 => {
                    let most = 8 * self.left as u64 + 4096;
                    let mut plain = Vec::new();
                    flate2::read::ZlibDecoder::new(data)
                        .take(most)
                        .read_to_end(&mut plain)
                        .map_err(MatError::Unpack)?;
                    if plain.len() as u64 == most {
                        return Err(TooManyNumbers.into());
                    }
                    let (kind, data, _) = self.element(&plain)?;
                    if kind == 14 {
                        self.matrix(data, "", 0)?;
                    }
                }
                _ => {}
            }
            bytes = rest;
        }
        Ok(())
    }

    /// Reads a variable: numeric arrays are stored, structures opened, other classes skipped.
    fn matrix(&mut self, data: &[u8], prefix: &str, depth: usize) -> Result<(), MatError> {
        if data.is_empty() || depth > DEEPEST {
            return Ok(());
        }
        let (_, flags, rest) = self.element(data)?;
        let class = self.u32(flags).ok_or(MatError::NoClass)? & 0xff;
        let (_, sides, rest) = self.element(rest)?;
        let sides: Vec<usize> = sides.chunks_exact(4).filter_map(|c| self.u32(c)).map(|n| n as usize).collect();
        let (_, name, rest) = self.element(rest)?;
        let own = String::from_utf8_lossy(name);
        let name = if prefix.is_empty() { own.into_owned() } else { prefix.to_string() };
        let [rows, columns] = sides[..] else { return Ok(()) };
        match class {
            2 if rows == 1 && columns == 1 => self.structure(rest, &name, depth),
            6..=15 => self.numbers(rest, name, [rows, columns]),
            _ => Ok(()),
        }
    }

    fn structure(&mut self, data: &[u8], name: &str, depth: usize) -> Result<(), MatError> {
        let (_, length, rest) = self.element(data)?;
        let length = self.u32(length).unwrap_or(0) as usize;
        let (_, names, mut rest) = self.element(rest)?;
        if length == 0 {
            return Ok(());
        }
        for field in names.chunks_exact(length) {
            let text: Vec<u8> = field.iter().copied().take_while(|b| *b != 0).collect();
            let (kind, data, next) = self.element(rest)?;
            if kind == 14 {
                self.matrix(data, &format!("{name}.{}", String::from_utf8_lossy(&text)), depth + 1)?;
            }
            rest = next;
        }
        Ok(())
    }

    fn numbers(&mut self, data: &[u8], name: String, shape: [usize; 2]) -> Result<(), MatError> {
        let (kind, data, _) = self.element(data)?;
        let size = match kind {
            1 | 2 => 1,
            3 | 4 => 2,
            5..=7 => 4,
            9 | 12 | 13 => 8,
            _ => return Ok(()),
        };
        let count = shape[0].checked_mul(shape[1]).filter(|n| *n <= self.left).ok_or(TooManyNumbers)?;
        if data.len() < count.saturating_mul(size) {
            return Err(MatError::ShortVariable(name));
        }
        self.left -= count;
        let plain: Vec<f64> = data.chunks_exact(size).take(count).map(|c| self.number(kind, c)).collect();
        // MATLAB stores arrays column by column.
        let [rows, columns] = shape;
        let values = (0..count).map(|i| plain[(i % columns) * rows + i / columns]).collect();
        self.arrays.push(Array { name, shape, values });
        Ok(())
    }

    fn number(&self, kind: u32, bytes: &[u8]) -> f64 {
        let mut wide = [0; 8];
        wide[..bytes.len()].copy_from_slice(bytes);
        if self.big {
            wide[..bytes.len()].reverse();
        }
        let unsigned = u64::from_le_bytes(wide);
        let unused = 64 - 8 * bytes.len() as u32;
        match kind {
            1 | 3 | 5 | 12 => (((unsigned << unused) as i64) >> unused) as f64,
            7 => f64::from(f32::from_bits(unsigned as u32)),
            9 => f64::from_bits(unsigned),
            _ => unsigned as f64,
        }
    }
}
