//! Reads MCAP, the container in which ROS 2 records, as a stream of records.
//!
//! Records are an opcode, a length and fields of fixed order (mcap.dev/spec). The few types needed
//! here are read without the crate `mcap`, whose twenty dependencies (two of them C) serve the rest
//! of the format. Nothing behind the data section is needed, so a truncated file is read up to its
//! end.

use std::collections::{HashMap, VecDeque};
use std::io::Read;

use super::recording::{Message, Messages};
use crate::data::log::Malformed;

/// Longest record (a compressed chunk, or a message), bytes.
const LONGEST_RECORD: u64 = 48 << 20;
/// Longest unpacked chunk, bytes.
const LONGEST_CHUNK: u64 = 64 << 20;
/// Longest message that is decoded, bytes: images and point clouds are skipped.
const LONGEST_MESSAGE: usize = 1 << 20;
/// Largest sum of definitions and topic names held in memory, bytes.
const MOST_TEXT: usize = 16 << 20;
/// Bytes to which the chunks of a file of any size may unpack.
const LEAST_UNPACKED: u64 = 64 << 20;
/// Multiple of its own size to which a file may unpack in addition. Messages of an arm at rest,
/// including names, are packed to about a fiftieth; zeros to a ten thousandth.
const MOST_TIMES: u64 = 128;

const MAGIC: &[u8; 8] = b"\x89MCAP0\r\n";
const FOOTER: u8 = 0x02;
const SCHEMA: u8 = 0x03;
const CHANNEL: u8 = 0x04;
const MESSAGE: u8 = 0x05;
const CHUNK: u8 = 0x06;
const DATA_END: u8 = 0x0f;

/// Reason why a file is not a valid MCAP file.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum McapError {
    /// Error of the operating system.
    #[error(transparent)]
    Read(#[from] std::io::Error),
    /// The magic bytes are missing.
    #[error("it does not begin as an MCAP file of version 0 does")]
    Start,
    /// A record is truncated.
    #[error("a record ends before its last field")]
    Short,
    /// A record exceeds the supported length, bytes.
    #[error("a record of {0} bytes; {LONGEST_RECORD} are read at most")]
    LongRecord(u64),
    /// A chunk exceeds the supported length, bytes.
    #[error("a chunk of {0} bytes; {LONGEST_CHUNK} are read at most")]
    LongChunk(u64),
    /// The file unpacks to far more than its own size.
    #[error("it unpacks to more than {MOST_TIMES} times its size, and no recording packs that well")]
    Unpacked,
    /// Names and definitions of topics exceed the memory limit.
    #[error("names and definitions of its topics have more than {} MiB", MOST_TEXT >> 20)]
    Text,
    /// A length exceeds the address space.
    #[error(transparent)]
    Length(#[from] std::num::TryFromIntError),
    /// The compression of a chunk is not supported.
    #[error("a chunk is packed with `{0}`; zstd, lz4 and none are read")]
    Compression(String),
    /// A chunk can't be decompressed.
    #[error("a chunk can't be unpacked ({compression}): {source}")]
    Unpack {
        /// Compression of the chunk.
        compression: &'static str,
        /// Message of the decoder.
        source: std::io::Error,
    },
    /// The unpacked length of a chunk differs from that in its header, bytes.
    #[error("a chunk has {found} bytes where its header says {stated}")]
    ChunkLength {
        /// Unpacked length.
        found: usize,
        /// Length stated in the header.
        stated: u64,
    },
    /// The checksum of a chunk does not match its bytes.
    #[error("a chunk is damaged: its checksum is not that of its bytes; try `mcap recover`")]
    Checksum,
}

/// A topic, the schema of its messages, and whether they can be decoded.
struct Channel {
    topic: String,
    schema: u16,
    readable: bool,
}

/// Reader of the messages of an MCAP file.
pub(crate) struct McapMessages<R> {
    input: R,
    started: bool,
    schemas: HashMap<u16, (String, String)>,
    channels: HashMap<u16, Channel>,
    /// Bytes of text in `schemas` and `channels`.
    text: usize,
    /// Bytes read from the file so far, and bytes of its unpacked chunks.
    read: u64,
    unpacked: u64,
    /// Records of the current chunk, and the read position in it.
    chunk: Vec<u8>,
    at: usize,
    queue: VecDeque<Message>,
    passed_over: Vec<String>,
    done: bool,
}

/// Reader of a record's fields, front to back.
struct Fields<'a>(&'a [u8]);

impl<'a> Fields<'a> {
    fn bytes(&mut self, n: usize) -> Result<&'a [u8], McapError> {
        let (part, rest) = self.0.split_at_checked(n).ok_or(McapError::Short)?;
        self.0 = rest;
        Ok(part)
    }

    fn number<const N: usize>(&mut self) -> Result<[u8; N], McapError> {
        self.bytes(N)?.try_into().map_err(|_| McapError::Short)
    }

    fn u16(&mut self) -> Result<u16, McapError> {
        self.number().map(u16::from_le_bytes)
    }

    fn u32(&mut self) -> Result<u32, McapError> {
        self.number().map(u32::from_le_bytes)
    }

    fn u64(&mut self) -> Result<u64, McapError> {
        self.number().map(u64::from_le_bytes)
    }

    fn prefixed(&mut self) -> Result<&'a [u8], McapError> {
        let n = self.u32()? as usize;
        self.bytes(n)
    }

    fn text(&mut self) -> Result<String, McapError> {
        Ok(String::from_utf8_lossy(self.prefixed()?).into_owned())
    }
}

impl<R: Read> McapMessages<R> {
    /// Creates the reader; nothing is read yet.
    pub fn new(input: R) -> Self {
        Self {
            input,
            started: false,
            schemas: HashMap::new(),
            channels: HashMap::new(),
            text: 0,
            read: 0,
            unpacked: 0,
            chunk: Vec::new(),
            at: 0,
            queue: VecDeque::new(),
            passed_over: Vec::new(),
            done: false,
        }
    }

    /// Reads one record of the file. A truncated last record is treated as the end of the file.
    fn step(&mut self) -> Result<(), McapError> {
        if !std::mem::replace(&mut self.started, true) {
            let magic = self.take(8)?;
            if magic.as_deref() != Some(MAGIC) {
                return Err(McapError::Start);
            }
        }
        let Some(head) = self.take(9)? else { return self.cut() };
        let length = Fields(&head[1..]).u64()?;
        if length > LONGEST_RECORD {
            return Err(McapError::LongRecord(length));
        }
        let Some(data) = self.take(length)? else { return self.cut() };
        match head[0] {
            DATA_END | FOOTER => self.done = true,
            CHUNK => self.chunk(&data)?,
            opcode => self.record(opcode, &data)?,
        }
        Ok(())
    }

    /// Reads `n` bytes; `None` if the file ends before.
    fn take(&mut self, n: u64) -> Result<Option<Vec<u8>>, McapError> {
        let mut bytes = Vec::new();
        self.input.by_ref().take(n).read_to_end(&mut bytes)?;
        self.read += bytes.len() as u64;
        Ok((bytes.len() as u64 == n).then_some(bytes))
    }

    fn cut(&mut self) -> Result<(), McapError> {
        self.done = true;
        self.note("the file has no end: the part before it is read".into());
        Ok(())
    }

    /// Unpacks a chunk.
    fn chunk(&mut self, data: &[u8]) -> Result<(), McapError> {
        let mut fields = Fields(data);
        fields.bytes(16)?; // first and last time
        let size = fields.u64()?;
        let checksum = fields.u32()?;
        let compression = fields.text()?;
        let length = usize::try_from(fields.u64()?)?;
        if size > LONGEST_CHUNK {
            return Err(McapError::LongChunk(size));
        }
        self.unpacked += size;
        if self.unpacked > LEAST_UNPACKED + MOST_TIMES * self.read {
            return Err(McapError::Unpacked);
        }
        self.chunk = unpack(&compression, fields.bytes(length)?, size)?;
        self.at = 0;
        // A checksum of 0 means that the writer provided none.
        if checksum != 0 && crc32(&self.chunk) != checksum {
            return Err(McapError::Checksum);
        }
        Ok(())
    }

    /// Reads the next record of the chunk.
    fn step_in_chunk(&mut self) -> Result<(), McapError> {
        let chunk = std::mem::take(&mut self.chunk);
        let mut rest = Fields(chunk.get(self.at..).unwrap_or(&[]));
        let opcode = rest.bytes(1)?[0];
        let length = usize::try_from(rest.u64()?)?;
        self.record(opcode, rest.bytes(length)?)?;
        self.at = chunk.len() - rest.0.len();
        self.chunk = chunk;
        Ok(())
    }

    fn record(&mut self, opcode: u8, data: &[u8]) -> Result<(), McapError> {
        let mut fields = Fields(data);
        match opcode {
            SCHEMA => {
                let (id, name, encoding) = (fields.u16()?, fields.text()?, fields.text()?);
                // With another definition language, the type is resolved by its name alone.
                let text = if encoding == "ros2msg" { fields.text()? } else { String::new() };
                let length = name.len() + text.len();
                let before = self.schemas.insert(id, (name, text));
                self.hold(length, before.map_or(0, |(name, text)| name.len() + text.len()))?;
            }
            CHANNEL => {
                let (id, schema, topic) = (fields.u16()?, fields.u16()?, fields.text()?);
                let encoding = fields.text()?;
                let readable = encoding == "cdr";
                if !readable && !self.channels.contains_key(&id) {
                    self.note(format!("the topic {topic} is written as `{encoding}`; `cdr` is read"));
                }
                let length = topic.len();
                let before = self.channels.insert(id, Channel { topic, schema, readable });
                self.hold(length, before.map_or(0, |channel| channel.topic.len()))?;
            }
            MESSAGE => {
                let id = fields.u16()?;
                fields.u32()?; // sequence
                let arrival = i64::try_from(fields.u64()?).unwrap_or(i64::MAX);
                fields.u64()?; // time of publication
                let decoded = |c: &&Channel| c.readable && fields.0.len() <= LONGEST_MESSAGE;
                if let Some(channel) = self.channels.get(&id).filter(decoded) {
                    let message = Message { topic: channel.topic.clone(), arrival, bytes: fields.0.to_vec() };
                    self.queue.push_back(message);
                }
            }
            _ => {}
        }
        Ok(())
    }

    /// Counts text that replaces other text. A chunk may repeat what is already known.
    fn hold(&mut self, more: usize, less: usize) -> Result<(), McapError> {
        self.text = self.text + more - less;
        if self.text > MOST_TEXT { Err(McapError::Text) } else { Ok(()) }
    }

    fn note(&mut self, what: String) {
        if self.passed_over.len() < 20 && !self.passed_over.contains(&what) {
            self.passed_over.push(what);
        }
    }
}

impl<R: Read + Send> Messages for McapMessages<R> {
    fn next(&mut self) -> Result<Option<Message>, Malformed> {
        loop {
            if let Some(message) = self.queue.pop_front() {
                return Ok(Some(message));
            }
            if self.at < self.chunk.len() {
                self.step_in_chunk()?;
                continue;
            }
            if self.done {
                return Ok(None);
            }
            self.chunk = Vec::new();
            self.step()?;
        }
    }

    fn definition(&self, topic: &str) -> Option<(&str, &str)> {
        let channel = self.channels.values().find(|c| c.topic == topic)?;
        self.schemas.get(&channel.schema).map(|(name, text)| (name.as_str(), text.as_str()))
    }

    fn passed_over(&self) -> Vec<String> {
        self.passed_over.clone()
    }
}

/// CRC-32 as in zip.
fn crc32(bytes: &[u8]) -> u32 {
    let mut crc = flate2::Crc::new();
    crc.update(bytes);
    crc.sum()
}

/// Unpacked records of a chunk.
fn unpack(compression: &str, data: &[u8], size: u64) -> Result<Vec<u8>, McapError> {
    let mut out = Vec::new();
    // Reads one byte more than stated, to detect a chunk that is longer than its header says.
    let most = size + 1;
    match compression {
        "" => out.extend_from_slice(data),
        "lz4" => {
            let decoder = lz4_flex::frame::FrameDecoder::new(data);
            let failed = |source| McapError::Unpack { compression: "lz4", source };
            decoder.take(most).read_to_end(&mut out).map_err(failed)?;
        }
        "zstd" => {
            let failed = |source| McapError::Unpack { compression: "zstd", source };
            let mut rest = data;
            while !rest.is_empty() && (out.len() as u64) < most {
                let decoder =
                    ruzstd::decoding::StreamingDecoder::new(&mut rest).map_err(|e| failed(std::io::Error::other(e)))?;
                let left = most - out.len() as u64;
                decoder.take(left).read_to_end(&mut out).map_err(failed)?;
            }
        }
        other => return Err(McapError::Compression(other.into())),
    }
    if out.len() as u64 != size {
        return Err(McapError::ChunkLength { found: out.len(), stated: size });
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::Write;

    fn prefixed(text: &[u8]) -> Vec<u8> {
        [&u32::try_from(text.len()).unwrap().to_le_bytes(), text].concat()
    }

    fn record(opcode: u8, data: &[u8]) -> Vec<u8> {
        [&[opcode], &(data.len() as u64).to_le_bytes()[..], data].concat()
    }

    /// A chunk of records with zeros, which compress by a factor of a hundred and more.
    fn chunk(records: &[u8]) -> Vec<u8> {
        let mut encoder = lz4_flex::frame::FrameEncoder::new(Vec::new());
        encoder.write_all(records).unwrap();
        let packed = encoder.finish().unwrap();
        let times = [0; 16];
        let size = (records.len() as u64).to_le_bytes();
        let length = (packed.len() as u64).to_le_bytes();
        record(CHUNK, &[&times[..], &size, &[0; 4], &prefixed(b"lz4"), &length, &packed].concat())
    }

    fn schema(id: u16, length: usize) -> Vec<u8> {
        let texts = [&b"a/B"[..], b"ros2msg", &b"#".repeat(length)].map(prefixed).concat();
        record(SCHEMA, &[&id.to_le_bytes()[..], &texts].concat())
    }

    fn refused(parts: &[Vec<u8>]) -> Option<String> {
        let bytes = [&MAGIC[..], &parts.concat(), &record(DATA_END, &[0; 4])].concat();
        McapMessages::new(&bytes[..]).next().err().map(|e| e.to_string())
    }

    /// Definitions of 3.6 GB were packed in a file of 300 kB.
    #[test]
    fn definitions_do_not_fill_the_memory() {
        let most = MOST_TEXT >> 20;
        let many: Vec<_> = (0..20).map(|id| chunk(&schema(id, 1 << 20))).collect();
        let told = refused(&many).unwrap();
        assert!(told.contains(&format!("names and definitions of its topics have more than {most} MiB")), "{told}");
        // The same definition repeated is held once.
        let again: Vec<_> = (0..20).map(|_| chunk(&schema(1, 1 << 20))).collect();
        assert_eq!(refused(&again), None);
    }

    /// Messages of 12 GB were packed in a file of 1 MB.
    #[test]
    fn a_file_that_unpacks_to_far_more_than_itself_is_no_recording() {
        let one = chunk(&record(0xff, &vec![0; 8 << 20]));
        assert!(one.len() as u64 * (MOST_TIMES + 64) < 8 << 20, "{}", one.len());
        assert_eq!(refused(&vec![one.clone(); 8]), None);
        let told = refused(&vec![one; 24]).unwrap();
        assert!(told.contains("it unpacks to more than 128 times its size"), "{told}");
    }
}
