//! SHA-256 of a recording, computed while the recording is read.

use std::io::Read;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use sha2::{Digest as _, Sha256};

/// Digest of the bytes read through its readers. Clones share one state, since a log may be read on
/// another thread.
#[derive(Debug, Clone, Default)]
pub struct Digest(Arc<Mutex<Sha256>>);

impl Digest {
    /// Wraps a reader so that its bytes are digested.
    pub fn reading<R: Read>(&self, inner: R) -> Digested<R> {
        Digested { inner, digest: self.clone() }
    }

    /// Digests the rest of a reader, for a format that is read by seeking.
    ///
    /// # Errors
    /// Errors of the reader.
    pub fn take_in(&self, mut reader: impl Read) -> std::io::Result<()> {
        std::io::copy(&mut reader, &mut *self.state()).map(|_| ())
    }

    /// Digest of the bytes so far, in hexadecimal digits.
    pub fn hexadecimal(&self) -> String {
        hexadecimal(&self.state().clone().finalize())
    }

    /// Locks the state; a poisoned lock is accepted, since the panic that caused it propagates
    /// anyway.
    fn state(&self) -> MutexGuard<'_, Sha256> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A reader whose bytes are digested while they are read.
#[derive(Debug)]
pub struct Digested<R> {
    inner: R,
    digest: Digest,
}

impl<R: Read> Read for Digested<R> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        let n = self.inner.read(buffer)?;
        self.digest.state().update(&buffer[..n]);
        Ok(n)
    }
}

/// Bytes in hexadecimal digits.
pub fn hexadecimal(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Checks the example of FIPS 180-4, read in two ways.
    #[test]
    fn a_digest_is_that_of_the_bytes() {
        let known = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        let (streamed, taken_in) = (Digest::default(), Digest::default());
        let mut read = Vec::new();
        streamed.reading(&b"abc"[..]).read_to_end(&mut read).unwrap();
        taken_in.take_in(&b"abc"[..]).unwrap();
        assert_eq!(read, b"abc");
        assert_eq!([streamed.hexadecimal(), taken_in.hexadecimal()], [known, known]);
    }
}
