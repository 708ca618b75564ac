//! Decodes Common Data Representation, the encoding of ROS 2 messages (OMG DDS-XTypes 1.3, section
//! 7.4).

/// Reader of a message's primitives, with the byte order and alignment given by its header.
pub(super) struct Cdr<'a> {
    bytes: &'a [u8],
    at: usize,
    /// Offset from which alignment is counted.
    origin: usize,
    little: bool,
    /// Largest alignment: 8 in XCDR1, 4 in XCDR2.
    largest: usize,
}

/// Reason why the bytes of a message do not fit its type.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum CdrError {
    /// The message is truncated.
    #[error("the message ends before its last field")]
    Short,
    /// The representation is not supported: parameter lists, delimited types.
    #[error("representation {0:#04x} is not read; plain CDR and XCDR2 are")]
    Representation(u8),
}

impl<'a> Cdr<'a> {
    /// Reads a message with its header of four bytes. Alignment is counted from `origin`: 4 by the
    /// standard, 0 for some writers.
    pub(super) fn new(bytes: &'a [u8], origin: usize) -> Result<Self, CdrError> {
        let [_, id, _, _] = bytes.first_chunk::<4>().ok_or(CdrError::Short)?;
        let (little, largest) = match id {
            0x00 => (false, 8),
            0x01 => (true, 8),
            0x06 => (false, 4),
            0x07 => (true, 4),
            other => return Err(CdrError::Representation(*other)),
        };
        Ok(Self { bytes, at: 4, origin, little, largest })
    }

    fn align(&mut self, size: usize) {
        let size = size.min(self.largest);
        let over = (self.at.wrapping_sub(self.origin)) % size;
        if over != 0 {
            self.at += size - over;
        }
    }

    fn take(&mut self, n: usize) -> Result<&'a [u8], CdrError> {
        let end = self.at.checked_add(n).ok_or(CdrError::Short)?;
        let part = self.bytes.get(self.at..end).ok_or(CdrError::Short)?;
        self.at = end;
        Ok(part)
    }

    /// Reads a primitive of `N` bytes, returned in little-endian order.
    pub(super) fn primitive<const N: usize>(&mut self) -> Result<[u8; N], CdrError> {
        self.align(N);
        let mut bytes: [u8; N] = self.take(N)?.try_into().map_err(|_| CdrError::Short)?;
        if !self.little {
            bytes.reverse();
        }
        Ok(bytes)
    }

    /// Reads the length of a sequence or string.
    pub(super) fn length(&mut self) -> Result<usize, CdrError> {
        Ok(u32::from_le_bytes(self.primitive()?) as usize)
    }

    /// Reads text without its terminating zero.
    pub(super) fn text(&mut self) -> Result<&'a [u8], CdrError> {
        let n = self.length()?;
        let bytes = self.take(n)?;
        Ok(bytes.strip_suffix(&[0]).unwrap_or(bytes))
    }

    /// Skips `n` primitives of `size` bytes.
    pub(super) fn skip(&mut self, n: usize, size: usize) -> Result<(), CdrError> {
        if n > 0 {
            self.align(size);
        }
        self.take(n.checked_mul(size).ok_or(CdrError::Short)?).map(|_| ())
    }

    /// Number of bytes after the last field that was read.
    pub(super) fn left(&self) -> usize {
        self.bytes.len().saturating_sub(self.at)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn alignment_of_both_versions_and_byte_orders() {
        // u8 1, then f64 2.5: at 8 from the header in XCDR1, at 4 in XCDR2.
        let number = 2.5f64;
        let mut one = vec![0, 1, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0];
        one.extend(number.to_le_bytes());
        let mut two = vec![0, 6, 0, 0, 1, 0, 0, 0];
        two.extend(number.to_be_bytes());
        for message in [one, two] {
            let mut cdr = Cdr::new(&message, 4).unwrap();
            assert_eq!(cdr.primitive::<1>(), Ok([1]));
            assert_eq!(cdr.primitive().map(f64::from_le_bytes), Ok(number));
            assert_eq!(cdr.left(), 0);
            assert_eq!(cdr.primitive::<1>(), Err(CdrError::Short));
        }
    }

    #[test]
    fn a_length_beyond_the_message_is_an_error() {
        let message = [0, 1, 0, 0, 0xff, 0xff, 0xff, 0xff];
        assert_eq!(Cdr::new(&message, 4).unwrap().text(), Err(CdrError::Short));
        assert!(matches!(Cdr::new(&[0, 3, 0, 0], 4), Err(CdrError::Representation(3))));
        assert!(Cdr::new(&[0], 4).is_err());
    }
}
