//! Decodes UTF-16 text, as saved by some Windows programs, to UTF-8.

use std::io::{Error, ErrorKind, Read, Result};

/// Bytes decoded at once.
const CHUNK: usize = 8192;

/// UTF-8 reader of a UTF-16 stream that begins with a byte order mark.
pub(super) struct Utf16<R> {
    source: R,
    /// Whether the stream is big-endian; `None` until the mark is read.
    big: Option<bool>,
    /// Bytes of an incomplete code unit or surrogate pair.
    rest: Vec<u8>,
    text: Vec<u8>,
    given: usize,
}

impl<R: Read> Utf16<R> {
    pub(super) fn new(source: R) -> Self {
        Self { source, big: None, rest: Vec::new(), text: Vec::new(), given: 0 }
    }

    /// Decodes the next part; `false` at the end.
    fn more(&mut self) -> Result<bool> {
        let before = self.rest.len();
        self.source.by_ref().take(CHUNK as u64).read_to_end(&mut self.rest)?;
        let ended = self.rest.len() == before;
        let broken = || Error::new(ErrorKind::InvalidData, "this is no whole UTF-16 text; save it as UTF-8");
        if ended {
            return if self.rest.is_empty() { Ok(false) } else { Err(broken()) };
        }
        let big = *self.big.get_or_insert(self.rest.starts_with(&[0xfe, 0xff]));
        let unit = |b: &[u8]| if big { u16::from_be_bytes([b[0], b[1]]) } else { u16::from_le_bytes([b[0], b[1]]) };
        let mut units: Vec<u16> = self.rest.chunks_exact(2).map(unit).collect();
        // The second half of a surrogate pair may be in the next part.
        if units.last().is_some_and(|u| (0xd800..0xdc00).contains(u)) {
            units.pop();
        }
        self.rest.drain(..2 * units.len());
        let text: String = char::decode_utf16(units).collect::<std::result::Result<_, _>>().map_err(|_| broken())?;
        (self.text, self.given) = (text.into_bytes(), 0);
        Ok(true)
    }
}

impl<R: Read> Read for Utf16<R> {
    fn read(&mut self, out: &mut [u8]) -> Result<usize> {
        while self.given == self.text.len() {
            if !self.more()? {
                return Ok(0);
            }
        }
        let n = out.len().min(self.text.len() - self.given);
        out[..n].copy_from_slice(&self.text[self.given..self.given + n]);
        self.given += n;
        Ok(n)
    }
}
