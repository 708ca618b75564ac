//! Reads `.npz` files: NumPy arrays in a zip archive. Objects (pickles) are never loaded.

use std::io::{Cursor, Read};

use zip::result::ZipError;

use super::arrays::{Array, ArrayTable, MOST_NUMBERS};
use super::malformed::TooManyNumbers;
use super::{Block, LogError, Malformed, Table};

/// Longest header of an array, bytes.
const LONGEST_HEADER: usize = 1 << 16;

/// Reason why the bytes are not a NumPy array of numbers.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum NpzError {
    /// The array can't be unpacked, or ends within its header.
    #[error(transparent)]
    Read(#[from] std::io::Error),
    /// The magic bytes are missing.
    #[error("it is no NumPy array")]
    NoArray,
    /// The header is longer than any that NumPy writes.
    #[error("its header is too long")]
    LongHeader,
    /// The header lacks a key.
    #[error("its header has no `{0}`")]
    NoKey(&'static str),
    /// The array holds Python objects, which could run code when loaded.
    #[error("it holds Python objects (a pickle), which are not loaded; save plain numbers")]
    Objects,
    /// The shape can't be parsed.
    #[error("its shape `{0}` can't be read")]
    Shape(String),
    /// The array is truncated.
    #[error("it ends before its last number")]
    Short,
    /// The file is too large for memory.
    #[error(transparent)]
    TooLarge(#[from] TooManyNumbers),
}

/// An `.npz` file as a table.
pub struct NpzTable(ArrayTable);

impl NpzTable {
    /// Reads the numeric arrays.
    ///
    /// # Errors
    /// If the file is damaged, holds objects, or is too large for memory.
    pub fn new(file: &str, bytes: Vec<u8>) -> Result<Self, LogError> {
        let damaged = |e: ZipError| LogError::malformed(file, "npz", e);
        let mut archive = zip::ZipArchive::new(Cursor::new(bytes)).map_err(damaged)?;
        let (mut arrays, mut numbers) = (Vec::new(), 0);
        for index in 0..archive.len() {
            let entry = archive.by_index(index).map_err(damaged)?;
            let name = entry.name().map_err(damaged)?.into_owned();
            let Some(name) = name.strip_suffix(".npy") else { continue };
            let array = read(entry, name, MOST_NUMBERS - numbers);
            let array = array
                .map_err(|source| LogError::malformed(file, "npz", Malformed::Npz { array: name.into(), source }))?;
            if let Some(array) = array {
                numbers += array.values.len();
                arrays.push(array);
            }
        }
        Ok(Self(ArrayTable::new(file, "npz", arrays)?))
    }
}

impl Table for NpzTable {
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

/// Reads one array; `None` for text and for more than two dimensions.
fn read(mut input: impl Read, name: &str, most: usize) -> Result<Option<Array>, NpzError> {
    let header = header(&mut input)?;
    let descr = value(&header, "descr").ok_or(NpzError::NoKey("descr"))?;
    let descr = descr.trim_matches(['\'', '"']);
    if descr.contains('O') || descr.starts_with('[') {
        return Err(NpzError::Objects);
    }
    let fortran = value(&header, "fortran_order").is_some_and(|v| v.starts_with("True"));
    let shape = value(&header, "shape").ok_or(NpzError::NoKey("shape"))?;
    let sides: Vec<usize> = shape
        .trim_matches(['(', ')'])
        .split(',')
        .map(str::trim)
        .filter(|s| !s.is_empty())
        .map(|s| s.trim_end_matches('L').parse().map_err(|_| NpzError::Shape(shape.into())))
        .collect::<Result<_, _>>()?;
    let [rows, columns] = match sides.as_slice() {
        [] => [1, 1],
        [n] => [*n, 1],
        [n, m] => [*n, *m],
        _ => return Ok(None),
    };
    let Some(number) = Number::of(descr) else { return Ok(None) };
    let count = rows.checked_mul(columns).filter(|n| *n <= most).ok_or(TooManyNumbers)?;
    let mut input = std::io::BufReader::new(input);
    let (mut plain, mut bytes) = (Vec::new(), [0; 8]);
    for _ in 0..count {
        let bytes = &mut bytes[..number.size];
        input.read_exact(bytes).map_err(|_| NpzError::Short)?;
        plain.push(number.read(bytes));
    }
    let values = if fortran && columns > 1 {
        (0..count).map(|i| plain[(i % columns) * rows + i / columns]).collect()
    } else {
        plain
    };
    Ok(Some(Array { name: name.into(), shape: [rows, columns], values }))
}

/// Text of the header, a Python dictionary.
fn header(input: &mut impl Read) -> Result<String, NpzError> {
    let mut start = [0; 8];
    input.read_exact(&mut start)?;
    if !start.starts_with(b"\x93NUMPY") {
        return Err(NpzError::NoArray);
    }
    let mut size = [0; 4];
    let width = if start[6] == 1 { 2 } else { 4 };
    input.read_exact(&mut size[..width])?;
    let size = u32::from_le_bytes(size) as usize;
    if size > LONGEST_HEADER {
        return Err(NpzError::LongHeader);
    }
    let mut text = vec![0; size];
    input.read_exact(&mut text)?;
    Ok(String::from_utf8_lossy(&text).into_owned())
}

/// Text of a value in the dictionary, up to the comma that ends it.
fn value<'a>(header: &'a str, key: &str) -> Option<&'a str> {
    let quoted = [format!("'{key}':"), format!("\"{key}\":")];
    let at = quoted.iter().find_map(|q| header.find(q.as_str()).map(|i| i + q.len()))?;
    let rest = header[at..].trim_start();
    let end = if rest.starts_with('(') {
        rest.find(')')? + 1
    } else if rest.starts_with('[') {
        rest.find(']')? + 1
    } else {
        rest.find([',', '}'])?
    };
    Some(rest[..end].trim())
}

/// Encoding of a number.
struct Number {
    kind: u8,
    size: usize,
    big: bool,
}

impl Number {
    /// Parses NumPy's type string, such as `<f8`.
    fn of(descr: &str) -> Option<Self> {
        let (order, rest) = descr.split_at_checked(1)?;
        let (kind, size) = rest.split_at_checked(1)?;
        let (kind, size) = (kind.as_bytes()[0], size.parse().ok()?);
        let known = matches!((kind, size), (b'f', 4 | 8) | (b'i' | b'u', 1 | 2 | 4 | 8) | (b'b', 1));
        known.then_some(Self { kind, size, big: order == ">" })
    }

    fn read(&self, bytes: &[u8]) -> f64 {
        let mut wide = [0; 8];
        wide[..self.size].copy_from_slice(bytes);
        if self.big {
            wide[..self.size].reverse();
        }
        let unsigned = u64::from_le_bytes(wide);
        match (self.kind, self.size) {
            (b'f', 8) => f64::from_bits(unsigned),
            (b'f', _) => f64::from(f32::from_bits(unsigned as u32)),
            (b'i', size) => {
                let unused = 64 - 8 * size as u32;
                (((unsigned << unused) as i64) >> unused) as f64
            }
            _ => unsigned as f64,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn npy(descr: &str, fortran: &str, shape: &str, data: &[u8]) -> Vec<u8> {
        let text = format!("{{'descr': '{descr}', 'fortran_order': {fortran}, 'shape': {shape}, }}\n");
        let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
        bytes.extend((text.len() as u16).to_le_bytes());
        bytes.extend(text.as_bytes());
        bytes.extend(data);
        bytes
    }

    #[test]
    fn numbers_of_all_kinds() {
        let read = |descr: &str, data: &[u8]| {
            let bytes = npy(descr, "False", "(1,)", data);
            super::read(bytes.as_slice(), "x", 10).unwrap().unwrap().values[0]
        };
        assert_eq!(read("<f8", &1.25f64.to_le_bytes()), 1.25);
        assert_eq!(read(">f4", &1.25f32.to_be_bytes()), 1.25);
        assert_eq!(read("<i2", &(-7i16).to_le_bytes()), -7.0);
        assert_eq!(read("|u1", &[200]), 200.0);
        assert_eq!(read("<i8", &(-9i64).to_le_bytes()), -9.0);
    }

    #[test]
    fn columns_of_both_orders_are_equal() {
        let c: Vec<u8> = [1f64, 2.0, 3.0, 4.0, 5.0, 6.0].iter().flat_map(|v| v.to_le_bytes()).collect();
        let f: Vec<u8> = [1f64, 3.0, 5.0, 2.0, 4.0, 6.0].iter().flat_map(|v| v.to_le_bytes()).collect();
        let a = super::read(npy("<f8", "False", "(3, 2)", &c).as_slice(), "q", 10).unwrap().unwrap();
        let b = super::read(npy("<f8", "True", "(3, 2)", &f).as_slice(), "q", 10).unwrap().unwrap();
        assert_eq!((a.values, a.shape), (b.values, [3, 2]));
    }

    #[test]
    fn pickles_and_lies_are_refused() {
        let pickle = super::read(npy("|O", "False", "(1,)", &[]).as_slice(), "x", 10);
        assert!(matches!(pickle, Err(NpzError::Objects)));
        let large = npy("<f8", "False", "(1099511627776,)", &[]);
        assert!(super::read(large.as_slice(), "x", 1000).is_err_and(|e| e.to_string().contains("Parquet")));
        assert!(super::read(npy("<f8", "False", "(3,)", &[0; 8]).as_slice(), "x", 10).is_err());
        assert!(NpzTable::new("x.npz", b"PK\x03\x04nothing".to_vec()).is_err());
    }
}
