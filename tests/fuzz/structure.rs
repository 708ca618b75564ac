//! Mutations inside checksums and compression, where mutated bytes alone would be rejected.

use std::io::{Cursor, Read, Write};

use crate::mutate::{Random, mutated};

/// Mutates an input to one of the same kind.
pub type Mutator = fn(&[u8], &[u8], &[&str], &mut Random) -> Vec<u8>;

/// Uses the structured mutation half of the time, and a mutation of bytes otherwise.
fn or_bytes(made: Option<Vec<u8>>, input: &[u8], other: &[u8], words: &[&str], random: &mut Random) -> Vec<u8> {
    match made {
        Some(made) if random.below(2) == 0 => made,
        _ => mutated(input, other, words, random),
    }
}

/// Mutates a compressed text.
pub fn gzip(input: &[u8], other: &[u8], words: &[&str], random: &mut Random) -> Vec<u8> {
    let unpack = |bytes: &[u8]| {
        let mut text = Vec::new();
        flate2::read::MultiGzDecoder::new(bytes).take(1 << 20).read_to_end(&mut text).ok().map(|_| text)
    };
    let made = unpack(input).and_then(|text| {
        let text = mutated(&text, &unpack(other)?, words, random);
        let mut out = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
        out.write_all(&text).ok()?;
        out.finish().ok()
    });
    or_bytes(made, input, other, words, random)
}

/// Mutates the directory at the end of a Parquet file, and its length.
pub fn parquet(input: &[u8], other: &[u8], words: &[&str], random: &mut Random) -> Vec<u8> {
    let made = input.len().checked_sub(8).and_then(|end| {
        let length = u32::from_le_bytes(input[end..end + 4].try_into().ok()?) as usize;
        let start = end.checked_sub(length)?;
        let mut footer = input[start..end].to_vec();
        if random.below(2) == 0 && !footer.is_empty() {
            // Counts are zigzag varints of up to ten bytes.
            let at = random.below(footer.len());
            let size = random.below(10);
            let huge = std::iter::repeat_n(0xff, size).chain([random.below(128) as u8]);
            footer.splice(at..(at + 1 + random.below(3)).min(length), huge);
        } else {
            footer = mutated(&footer, &footer, words, random);
        }
        let length = (footer.len() as u32).to_le_bytes();
        Some([&input[..start], &footer, &length, b"PAR1"].concat())
    });
    or_bytes(made, input, other, words, random)
}

/// Records of a part of an MCAP file: opcode and data.
fn records(mut bytes: &[u8]) -> Vec<(u8, Vec<u8>)> {
    let mut all = Vec::new();
    while let Some((head, rest)) = bytes.split_first_chunk::<9>() {
        let length = u64::from_le_bytes(head[1..].try_into().unwrap_or_default());
        let Some((data, after)) = usize::try_from(length).ok().and_then(|n| rest.split_at_checked(n)) else { break };
        all.push((head[0], data.to_vec()));
        bytes = after;
    }
    all
}

fn written(records: &[(u8, Vec<u8>)]) -> Vec<u8> {
    let one = |(opcode, data): &(u8, Vec<u8>)| [&[*opcode][..], &(data.len() as u64).to_le_bytes(), data].concat();
    records.iter().flat_map(one).collect()
}

/// Uncompressed records of a chunk.
fn chunk(data: &[u8]) -> Option<Vec<u8>> {
    let name = u32::from_le_bytes(data.get(28..32)?.try_into().ok()?) as usize;
    let packed = data.get(32 + name + 8..)?;
    match data.get(32..32 + name)? {
        b"" => Some(packed.to_vec()),
        b"lz4" => {
            let mut out = Vec::new();
            lz4_flex::frame::FrameDecoder::new(packed).take(1 << 20).read_to_end(&mut out).ok()?;
            Some(out)
        }
        b"zstd" => {
            let mut out = Vec::new();
            let decoder = ruzstd::decoding::StreamingDecoder::new(packed).ok()?;
            decoder.take(1 << 20).read_to_end(&mut out).ok()?;
            Some(out)
        }
        _ => None,
    }
}

/// Mutates one record of an MCAP file, in a chunk or outside; lengths and checksums are corrected.
pub fn mcap(input: &[u8], other: &[u8], words: &[&str], random: &mut Random) -> Vec<u8> {
    let made = input.strip_prefix(b"\x89MCAP0\r\n").and_then(|rest| {
        let mut all = records(rest);
        let k = random.below(all.len());
        let (opcode, data) = all.get_mut(k)?;
        if *opcode == 6 {
            let mut inner = records(&chunk(data)?);
            // Schemas and channels come first, and matter more than messages.
            let most = if random.below(2) == 0 { 4.min(inner.len()) } else { inner.len() };
            let at = random.below(most);
            let (_, record) = inner.get_mut(at)?;
            *record = mutated(record, other, words, random);
            let inner = written(&inner);
            let size = (inner.len() as u64).to_le_bytes();
            *data = [&data[..16], &size, &[0; 4], &[0; 4], &size, &inner].concat();
        } else {
            *data = mutated(data, other, words, random);
        }
        Some([b"\x89MCAP0\r\n", written(&all).as_slice()].concat())
    });
    or_bytes(made, input, other, words, random)
}

/// Mutates one array of an npz archive.
pub fn npz(input: &[u8], other: &[u8], words: &[&str], random: &mut Random) -> Vec<u8> {
    let made = zip::ZipArchive::new(Cursor::new(input)).ok().and_then(|mut archive| {
        let mut out = zip::ZipWriter::new(Cursor::new(Vec::new()));
        let (count, hurt) = (archive.len(), random.below(archive.len()));
        for k in 0..count {
            let mut member = archive.by_index(k).ok()?;
            let (name, mut bytes) = (member.name().ok()?.into_owned(), Vec::new());
            member.by_ref().take(1 << 20).read_to_end(&mut bytes).ok()?;
            if k == hurt {
                // The header has type and shape.
                let head = bytes.len().min(128);
                let from = if random.below(4) == 0 { bytes.len() } else { head };
                bytes = [&mutated(&bytes[..from], other, words, random), &bytes[from..]].concat();
            }
            out.start_file(name, zip::write::SimpleFileOptions::default()).ok()?;
            out.write_all(&bytes).ok()?;
        }
        Some(out.finish().ok()?.into_inner())
    });
    or_bytes(made, input, other, words, random)
}

/// Mutates a compressed variable of a MATLAB file.
pub fn mat(input: &[u8], other: &[u8], words: &[&str], random: &mut Random) -> Vec<u8> {
    let made = input.get(128..136).and_then(|tag| {
        let kind = u32::from_le_bytes(tag[..4].try_into().ok()?);
        let size = u32::from_le_bytes(tag[4..].try_into().ok()?) as usize;
        let (data, rest) = input[136..].split_at_checked(size)?;
        if kind != 15 {
            return None;
        }
        let mut plain = Vec::new();
        flate2::read::ZlibDecoder::new(data).take(1 << 20).read_to_end(&mut plain).ok()?;
        let head = plain.len().min(96);
        plain = [&mutated(&plain[..head], other, words, random), &plain[head..]].concat();
        let mut out = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::fast());
        out.write_all(&plain).ok()?;
        let packed = out.finish().ok()?;
        let size = (packed.len() as u32).to_le_bytes();
        Some([&input[..132], &size, &packed, rest].concat())
    });
    or_bytes(made, input, other, words, random)
}
