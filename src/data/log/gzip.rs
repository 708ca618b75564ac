//! Unpacks gzipped text, up to the compression ratio of a plausible recording.

use std::io::{Error, ErrorKind, Read, Result};

use flate2::read::MultiGzDecoder;

/// Bytes to which a file of any size may unpack.
const LEAST: u64 = 64 << 20;
/// Multiple of its own size to which a file may unpack in addition. Samples of a moving arm are
/// packed to a third, those of an arm at rest to a twentieth, zeros to a thousandth.
const MOST_TIMES: u64 = 32;

/// A reader that counts its bytes.
struct Counted<R> {
    source: R,
    bytes: u64,
}

impl<R: Read> Read for Counted<R> {
    fn read(&mut self, out: &mut [u8]) -> Result<usize> {
        let n = self.source.read(out)?;
        self.bytes += n as u64;
        Ok(n)
    }
}

/// Content of a gzipped stream. A stream that unpacks to far more than its own size is an error,
/// since a small file could otherwise keep a reader busy for hours.
pub(super) struct Unpacked<R> {
    decoder: MultiGzDecoder<Counted<R>>,
    bytes: u64,
}

impl<R: Read> Unpacked<R> {
    pub(super) fn new(source: R) -> Self {
        Self { decoder: MultiGzDecoder::new(Counted { source, bytes: 0 }), bytes: 0 }
    }
}

impl<R: Read> Read for Unpacked<R> {
    fn read(&mut self, out: &mut [u8]) -> Result<usize> {
        let n = self.decoder.read(out)?;
        self.bytes += n as u64;
        if self.bytes > LEAST + MOST_TIMES * self.decoder.get_ref().bytes {
            let what = format!(
                "it unpacks to more than {MOST_TIMES} times its size, and hardly a recording packs that well; unpack it with \
                 `gunzip` and give the CSV if it is one"
            );
            return Err(Error::new(ErrorKind::InvalidData, what));
        }
        Ok(n)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::{Write, copy, sink};

    /// A row, packed separately, repeated `rows` times: a file may consist of several gzip members.
    fn packed(row: &[u8], rows: usize) -> Vec<u8> {
        let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
        encoder.write_all(row).unwrap();
        encoder.finish().unwrap().repeat(rows)
    }

    #[test]
    fn what_packs_as_no_recording_does_is_unpacked_no_further() {
        let block = b"0.001,0.1,0.2,0.3,0.4\n".repeat(1 << 12);
        let whole = packed(&block, 2000);
        assert!(block.len() as u64 * 2000 > LEAST + MOST_TIMES * whole.len() as u64, "{}", whole.len());
        let mut unpacked = Unpacked::new(&whole[..]);
        let error = copy(&mut unpacked, &mut sink()).unwrap_err().to_string();
        assert!(error.starts_with("it unpacks to more than 32 times its size"), "{error}");
        assert!(unpacked.bytes < LEAST + MOST_TIMES * whole.len() as u64 + (1 << 20), "{}", unpacked.bytes);
        // Content below the lower limit is read at any compression ratio.
        let little = packed(&block, 500);
        assert_eq!(copy(&mut Unpacked::new(&little[..]), &mut sink()).unwrap(), block.len() as u64 * 500);
    }
}
