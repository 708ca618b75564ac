//! Mutations of inputs: bytes, words of a text, and numbers. Deterministic by seed.

/// The SplitMix64 generator.
pub struct Random(u64);

impl Random {
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number below `n`; 0 if `n` is 0.
    pub fn below(&mut self, n: usize) -> usize {
        (self.next() % n.max(1) as u64) as usize
    }

    pub fn pick<'a, T: ?Sized>(&mut self, of: &[&'a T]) -> &'a T {
        of[self.below(of.len())]
    }

    /// A range within `len`, short ones more often.
    fn stretch(&mut self, len: usize) -> std::ops::Range<usize> {
        let from = self.below(len + 1);
        let most = if self.below(4) == 0 { len } else { 16 };
        from..from + self.below((len - from).min(most) + 1)
    }
}

/// Numbers that break arithmetic and conversions.
pub const NUMBERS: [&str; 30] = [
    "nan",
    "NaN",
    ".nan",
    "inf",
    "-inf",
    ".inf",
    "1e308",
    "-1e308",
    "1e309",
    "1e-308",
    "5e-324",
    "-0",
    "0",
    "-1",
    "1",
    "2",
    "65536",
    "1048576",
    "2147483647",
    "4294967296",
    "9223372036854775807",
    "18446744073709551616",
    "-9223372036854775808",
    "1e17",
    "1e-17",
    "0.1",
    "1/0",
    "pi",
    "-90deg",
    "99999999999999999999999999999999999999999",
];

/// Critical lengths and counts for binary formats.
const INTEGERS: [u64; 16] = [
    0,
    1,
    2,
    0x7f,
    0x80,
    0xff,
    0x7fff,
    0xffff,
    0x1_0000,
    0x7fff_ffff,
    0x8000_0000,
    0xffff_ffff,
    1 << 32,
    1 << 40,
    i64::MAX as u64,
    u64::MAX,
];

/// Tokens of the text formats.
const PIECES: [&str; 44] = [
    ":",
    "- ",
    "\n",
    "\n  ",
    "\n    ",
    "{",
    "}",
    "[",
    "]",
    "[[[[[[[[[[[[[[[[",
    "{a: {a: {a: {a: ",
    "&a",
    "*a",
    "<<: *a",
    "!!int ",
    "|",
    ">",
    "'",
    "\"",
    "#",
    "%",
    "---\n",
    "...\n",
    "? ",
    ",",
    ";",
    "\t",
    " ",
    "\0",
    "\u{feff}",
    "\u{202e}",
    "é",
    "(((((((((((",
    ")",
    "+",
    "-",
    "*",
    "/",
    "^",
    "<!DOCTYPE a [<!ENTITY b \"bbbb\">]>",
    "&b;",
    "<a>",
    "</a>",
    "<![CDATA[",
];

/// One to a few mutations of `input`; `other` is a further input to take pieces from.
pub fn mutated(input: &[u8], other: &[u8], words: &[&str], random: &mut Random) -> Vec<u8> {
    let mut out = input.to_vec();
    for _ in 0..=[0, 0, 0, 1, 2, 5][random.below(6)] {
        out = once(out, other, words, random);
    }
    out.truncate(LONGEST);
    out
}

/// Longest input, bytes: limits of length have tests of their own.
const LONGEST: usize = 1 << 17;

fn once(mut bytes: Vec<u8>, other: &[u8], words: &[&str], random: &mut Random) -> Vec<u8> {
    let text = std::str::from_utf8(&bytes).is_ok();
    match random.below(if text { 16 } else { 9 }) {
        0 => flip(&mut bytes, random),
        1 => splice(&mut bytes, &[], random),
        2 => {
            let piece = other[random.stretch(other.len())].to_vec();
            splice(&mut bytes, &piece, random);
        }
        3 => {
            // Duplicates a piece, here or elsewhere.
            let piece = bytes[random.stretch(bytes.len())].to_vec();
            let at = random.below(bytes.len() + 1);
            bytes.splice(at..at, piece);
        }
        4 => bytes.truncate(random.below(bytes.len() + 1)),
        5 | 6 => integer(&mut bytes, random),
        7 => {
            let cut = random.below(bytes.len() + 1);
            let from = random.below(other.len() + 1);
            bytes.truncate(cut);
            bytes.extend_from_slice(&other[from..]);
        }
        8 => {
            let to = random.below(256) as u8;
            let range = random.stretch(bytes.len());
            bytes[range].fill(to);
        }
        9 | 10 => {
            replace_token(&mut bytes, |c| c.is_ascii_digit() || b".+-eE".contains(&c), NUMBERS.as_slice(), random)
        }
        11 | 12 => replace_token(&mut bytes, |c| c.is_ascii_alphanumeric() || c == b'_', words, random),
        13 => splice(&mut bytes, random.pick(&PIECES).as_bytes(), random),
        14 => lines(&mut bytes, random),
        _ => {
            let piece = random.pick(&PIECES).repeat(1 + random.below(400));
            splice(&mut bytes, piece.as_bytes(), random);
        }
    }
    bytes
}

fn flip(bytes: &mut [u8], random: &mut Random) {
    if !bytes.is_empty() {
        let at = random.below(bytes.len());
        bytes[at] ^= 1 << random.below(8);
    }
}

/// Replaces a range by a piece.
fn splice(bytes: &mut Vec<u8>, piece: &[u8], random: &mut Random) {
    let range = random.stretch(bytes.len());
    bytes.splice(range, piece.iter().copied());
}

/// Overwrites an integer of 1 to 8 bytes.
fn integer(bytes: &mut [u8], random: &mut Random) {
    let size = [1, 2, 4, 8][random.below(4)].min(bytes.len());
    let value = INTEGERS[random.below(INTEGERS.len())].wrapping_sub(random.below(3) as u64).to_le_bytes();
    let at = random.below(bytes.len() + 1 - size);
    let mut value = value[..size].to_vec();
    if random.below(4) == 0 {
        value.reverse();
    }
    bytes[at..at + size].copy_from_slice(&value);
}

/// Replaces a token by one of `words`, or swaps two tokens.
fn replace_token(bytes: &mut Vec<u8>, inside: impl Fn(u8) -> bool, words: &[&str], random: &mut Random) {
    let token = |bytes: &[u8], random: &mut Random| {
        let start = random.below(bytes.len());
        let from = (start..bytes.len()).find(|&i| inside(bytes[i]))?;
        let from = (0..from).rev().take_while(|&i| inside(bytes[i])).last().unwrap_or(from);
        Some(from..(from..bytes.len()).find(|&i| !inside(bytes[i])).unwrap_or(bytes.len()))
    };
    let Some(range) = token(bytes, random) else { return };
    let with = match random.below(3) {
        0 => token(bytes, random).map(|other| bytes[other].to_vec()).unwrap_or_default(),
        _ if words.is_empty() => Vec::new(),
        _ => random.pick(words).as_bytes().to_vec(),
    };
    bytes.splice(range, with);
}

/// Deletes, duplicates, swaps or indents lines.
fn lines(bytes: &mut Vec<u8>, random: &mut Random) {
    let mut all: Vec<Vec<u8>> = bytes.split_inclusive(|&b| b == b'\n').map(<[u8]>::to_vec).collect();
    let (a, b) = (random.below(all.len()), random.below(all.len()));
    if all.is_empty() {
        return;
    }
    match random.below(5) {
        0 => drop(all.remove(a)),
        1 => {
            let line = all[a].clone();
            let times = if random.below(8) == 0 { random.below(300) } else { 1 };
            all.splice(b..b, std::iter::repeat_n(line, times));
        }
        2 => all.swap(a, b),
        3 => drop(all[a].splice(..0, *b"  ")),
        _ => all[a] = all[a].trim_ascii_start().to_vec(),
    }
    *bytes = all.concat();
}
