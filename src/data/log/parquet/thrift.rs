//! Decodes the part of Thrift's compact protocol needed to check numbers of a structure before the
//! Parquet library, which trusts them, reads it.

/// Deepest nesting of structures; Parquet's own have eight levels.
const DEEPEST: usize = 24;

/// Decoder of bytes, from front to back.
pub(super) struct Compact<'a> {
    bytes: &'a [u8],
    at: usize,
}

/// A decoded value, or its kind.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Value {
    /// Integer.
    Number(i64),
    /// List; its elements follow. Type of the elements and their number.
    List(u8, usize),
    /// Structure; its fields follow.
    Structure,
    /// Any other value, which was skipped.
    Other,
}

impl<'a> Compact<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, at: 0 }
    }

    /// Number of bytes read.
    pub(super) fn position(&self) -> usize {
        self.at
    }

    fn byte(&mut self) -> Option<u8> {
        let byte = *self.bytes.get(self.at)?;
        self.at += 1;
        Some(byte)
    }

    fn skip(&mut self, n: usize) -> Option<()> {
        self.at = self.at.checked_add(n).filter(|at| *at <= self.bytes.len())?;
        Some(())
    }

    fn varint(&mut self) -> Option<u64> {
        let mut value = 0;
        for shift in (0..64).step_by(7) {
            let byte = self.byte()?;
            value |= u64::from(byte & 0x7f) << shift;
            if byte < 0x80 {
                return Some(value);
            }
        }
        None
    }

    fn zigzag(&mut self) -> Option<i64> {
        let value = self.varint()?;
        Some((value >> 1) as i64 ^ -((value & 1) as i64))
    }

    /// Number and value of the next field of a structure after field `last`; `Some(None)` at the
    /// end of the structure, `None` if the bytes end or are malformed.
    pub(super) fn field(&mut self, last: i64) -> Option<Option<(i64, Value)>> {
        let head = self.byte()?;
        if head == 0 {
            return Some(None);
        }
        let number = if head >> 4 == 0 { self.zigzag()? } else { last.checked_add(i64::from(head >> 4))? };
        // A boolean is stored in the head itself.
        let value = if matches!(head & 0xf, 1 | 2) { Value::Other } else { self.value(head & 0xf)? };
        Some(Some((number, value)))
    }

    /// Reads a value of a type, encoded as an element of a list.
    pub(super) fn value(&mut self, kind: u8) -> Option<Value> {
        match kind {
            1..=3 => self.skip(1)?,
            4..=6 => return self.zigzag().map(Value::Number),
            7 => self.skip(8)?,
            8 => {
                let length = usize::try_from(self.varint()?).ok()?;
                self.skip(length)?;
            }
            9 | 10 => {
                let head = self.byte()?;
                let count =
                    if head >> 4 == 15 { usize::try_from(self.varint()?).ok()? } else { usize::from(head >> 4) };
                return Some(Value::List(head & 0xf, count));
            }
            12 => return Some(Value::Structure),
            // Parquet has no maps.
            _ => return None,
        }
        Some(Value::Other)
    }

    /// Skips the elements or fields that follow a value.
    pub(super) fn pass(&mut self, value: Value, depth: usize) -> Option<()> {
        if depth > DEEPEST {
            return None;
        }
        match value {
            Value::Number(_) | Value::Other => {}
            Value::List(kind, count) => {
                for _ in 0..count {
                    let element = self.value(kind)?;
                    self.pass(element, depth + 1)?;
                }
            }
            Value::Structure => {
                let mut last = 0;
                while let Some((number, value)) = self.field(last)? {
                    self.pass(value, depth + 1)?;
                    last = number;
                }
            }
        }
        Some(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fields_of_a_structure() {
        // Encodes 1: i32 -3; 3: "ab"; 4: list of two i32; 20: structure { 1: true }; end.
        let bytes = [0x15, 5, 0x28, 2, b'a', b'b', 0x19, 0x25, 2, 4, 0x0c, 40, 0x11, 0, 0];
        let mut compact = Compact::new(&bytes);
        assert_eq!(compact.field(0), Some(Some((1, Value::Number(-3)))));
        assert_eq!(compact.field(1), Some(Some((3, Value::Other))));
        let Some(Some((4, list))) = compact.field(3) else { panic!() };
        assert_eq!(list, Value::List(5, 2));
        assert_eq!(compact.pass(list, 0), Some(()));
        let Some(Some((20, inner))) = compact.field(4) else { panic!() };
        assert_eq!((inner, compact.pass(inner, 0)), (Value::Structure, Some(())));
        assert_eq!((compact.field(20), compact.position()), (Some(None), bytes.len()));
        assert_eq!(compact.field(0), None);
    }

    #[test]
    fn lies_end() {
        // A list of 2^63 booleans, and endlessly nested structures.
        let list = [0x19, 0xf1, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0x7f];
        assert_eq!(Compact::new(&list).pass(Value::Structure, 0), None);
        assert_eq!(Compact::new(&[0x1c; 100_000]).pass(Value::Structure, 0), None);
    }
}
