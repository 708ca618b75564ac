//! A recording as a table whose rows are at the stamps of the messages that carry the positions.

use std::collections::{HashMap, VecDeque};

use super::align::Aligner;
use super::definition::Definition;
use super::flatten::{Flat, decode};
use crate::data::log::inspect::Summing;
use crate::data::log::{BadCell, Block, ChannelSummary, LogError, Malformed, Table};

/// Recorded time that is previewed for topics and joints, ns.
const PREVIEW_TIME: i64 = 3_000_000_000;
/// Most messages and bytes that are previewed.
const PREVIEW: (usize, usize) = (20_000, 8 << 20);
/// Number of damaged messages that are tolerated.
const MOST_DAMAGED: usize = 100;

/// A message of the recording.
pub(crate) struct Message {
    /// Topic of the message.
    pub topic: String,
    /// Time at which the recorder received it, ns.
    pub arrival: i64,
    /// Bytes in CDR, with the header.
    pub bytes: Vec<u8>,
}

/// Messages in recorded order.
pub(crate) trait Messages: Send {
    /// Next message on a topic that can be decoded; `None` at the end.
    ///
    /// # Errors
    /// If the file is malformed.
    fn next(&mut self) -> Result<Option<Message>, Malformed>;

    /// Type and definition of a topic's messages.
    fn definition(&self, topic: &str) -> Option<(&str, &str)>;

    /// Skipped parts: topics that can't be decoded, a missing end of the file.
    fn passed_over(&self) -> Vec<String>;
}

/// A topic that is decoded.
struct Topic {
    definition: Definition,
    names: Vec<String>,
    signature: u64,
    /// For each wanted number: index of its name in the table, and position in the message; `None`
    /// if absent from the last message.
    wanted: Vec<(usize, Option<usize>)>,
    /// Index of the stream in the aligner; `None` for the base stream.
    stream: Option<usize>,
}

/// A recording of messages as a table.
pub(crate) struct Recording<M> {
    file: String,
    kind: &'static str,
    messages: M,
    arrival: bool,
    preview: VecDeque<Message>,
    topics: HashMap<String, Topic>,
    names: Vec<String>,
    /// Topic of each name; empty for `t`.
    owner: Vec<String>,
    aligner: Aligner,
    /// Position in a row of the aligner for each selected column; `None` for the stamp.
    order: Vec<Option<usize>>,
    start: Option<i64>,
    damaged: usize,
    row: u64,
    done: bool,
}

impl<M: Messages> Recording<M> {
    /// Previews the first seconds for topics and their channels. `arrival`: rows are stamped with
    /// the recorder's clock.
    ///
    /// # Errors
    /// If the file can't be read, or has no message with numbers.
    pub fn new(file: &str, kind: &'static str, messages: M, arrival: bool) -> Result<Self, LogError> {
        let mut recording = Self {
            file: file.into(),
            kind,
            messages,
            arrival,
            preview: VecDeque::new(),
            topics: HashMap::new(),
            names: vec!["t".into()],
            owner: vec![String::new()],
            aligner: Aligner::new(&[]),
            order: Vec::new(),
            start: None,
            damaged: 0,
            row: 0,
            done: false,
        };
        recording.look_through()?;
        if recording.names.len() == 1 {
            let passed_over = recording.messages.passed_over();
            return Err(recording.failed(Malformed::NoNumbers { passed_over }));
        }
        Ok(recording)
    }

    fn failed(&self, source: Malformed) -> LogError {
        LogError::malformed(&self.file, self.kind, source)
    }

    fn look_through(&mut self) -> Result<(), LogError> {
        let (mut first, mut bytes) = (None, 0);
        while self.preview.len() < PREVIEW.0 && bytes < PREVIEW.1 {
            let Some(message) = self.messages.next().map_err(|e| self.failed(e))? else { break };
            let arrival = message.arrival;
            bytes += message.bytes.len();
            self.learn(&message);
            self.preview.push_back(message);
            if arrival - *first.get_or_insert(arrival) > PREVIEW_TIME {
                break;
            }
        }
        Ok(())
    }

    /// Adds the channels of a message.
    fn learn(&mut self, message: &Message) {
        let Some((kind, text)) = self.messages.definition(&message.topic) else { return };
        if !self.topics.contains_key(&message.topic) {
            let Ok(definition) = Definition::new(kind, text) else { return };
            let topic = Topic { definition, names: Vec::new(), signature: 0, wanted: Vec::new(), stream: None };
            self.topics.insert(message.topic.clone(), topic);
        }
        let Some(topic) = self.topics.get_mut(&message.topic) else { return };
        let Ok(flat) = decode(&topic.definition, &message.bytes) else { return };
        if topic.signature == flat.signature && !topic.names.is_empty() {
            return;
        }
        topic.signature = flat.signature;
        topic.names = flat.names(&topic.definition, &message.topic);
        let header = format!("{}/header/", message.topic);
        for name in &topic.names {
            if !name.starts_with(&header) && !self.names.contains(name) && self.names.len() < 4096 {
                self.names.push(name.clone());
                self.owner.push(message.topic.clone());
            }
        }
    }

    /// Next message; previewed messages come first.
    fn message(&mut self) -> Result<Option<Message>, LogError> {
        match self.preview.pop_front() {
            Some(message) => Ok(Some(message)),
            None => self.messages.next().map_err(|e| self.failed(e)),
        }
    }

    /// Decodes a message and passes its numbers to the aligner.
    fn absorb(&mut self, message: &Message) -> Result<(), LogError> {
        let Some(topic) = self.topics.get_mut(&message.topic).filter(|t| !t.wanted.is_empty()) else { return Ok(()) };
        let flat = match decode(&topic.definition, &message.bytes) {
            Ok(flat) => flat,
            Err(source) => {
                self.damaged += 1;
                let (topic, count) = (message.topic.clone(), self.damaged);
                if count > MOST_DAMAGED {
                    return Err(self.failed(Malformed::Damaged { count, topic, source }));
                }
                return Ok(());
            }
        };
        if topic.signature != flat.signature {
            relocate(topic, &flat, &message.topic, &self.names);
        }
        let number = |at: &Option<usize>| at.and_then(|i| flat.numbers.get(i)).copied().unwrap_or(f64::NAN);
        let values = topic.wanted.iter().map(|(_, at)| number(at)).collect();
        let time = flat.stamp.filter(|_| !self.arrival).unwrap_or(message.arrival);
        match topic.stream {
            Some(stream) => self.aligner.other(stream, time, values),
            None => self.aligner.base(time, values),
        }
        Ok(())
    }
}

/// Finds the wanted numbers again after names or lengths of a message have changed.
fn relocate(topic: &mut Topic, flat: &Flat, path: &str, names: &[String]) {
    topic.signature = flat.signature;
    topic.names = flat.names(&topic.definition, path);
    for (name, at) in &mut topic.wanted {
        *at = topic.names.iter().position(|n| *n == names[*name]);
    }
}

impl<M: Messages> Table for Recording<M> {
    fn names(&self) -> &[String] {
        &self.names
    }

    /// Summarises the channels, each topic by its own clock.
    fn summarise(&mut self) -> Result<Vec<ChannelSummary>, LogError> {
        let mut sums: Vec<Summing> = self.names.iter().map(|n| Summing::new(n)).collect();
        for topic in self.topics.values_mut() {
            let at = |name: &String| topic.names.iter().position(|n| n == name);
            topic.wanted = self.names.iter().enumerate().filter_map(|(i, n)| Some((i, Some(at(n)?)))).collect();
        }
        let mut start = None;
        while let Some(message) = self.message()? {
            let Some(topic) = self.topics.get_mut(&message.topic) else { continue };
            let Ok(flat) = decode(&topic.definition, &message.bytes) else { continue };
            if topic.signature != flat.signature {
                relocate(topic, &flat, &message.topic, &self.names);
            }
            let time = flat.stamp.filter(|_| !self.arrival).unwrap_or(message.arrival);
            let seconds = (time - *start.get_or_insert(time)) as f64 * 1e-9;
            for (name, at) in &topic.wanted {
                let value = at.and_then(|i| flat.numbers.get(i)).copied().unwrap_or(f64::NAN);
                sums[*name].add(Some(seconds), value);
            }
        }
        Ok(sums.into_iter().skip(1).map(Summing::finish).collect())
    }

    fn select(&mut self, positions: &[usize], clock: usize) -> Result<(), LogError> {
        for topic in self.topics.values_mut() {
            topic.wanted.clear();
            topic.stream = None;
        }
        let base = self.owner[clock].clone();
        let mut streams: Vec<String> = Vec::new();
        for &position in positions {
            let owner = &self.owner[position];
            if let Some(topic) = self.topics.get_mut(owner) {
                topic.wanted.push((position, topic.names.iter().position(|n| *n == self.names[position])));
                if *owner != base && !streams.contains(owner) {
                    topic.stream = Some(streams.len());
                    streams.push(owner.clone());
                }
            }
        }
        let width = |topic: &String| self.topics.get(topic).map_or(0, |t| t.wanted.len());
        let widths: Vec<usize> = streams.iter().map(width).collect();
        // Base first, then the other streams, each in the order of its wanted columns.
        let places: Vec<usize> = std::iter::once(&base)
            .chain(&streams)
            .filter_map(|owner| self.topics.get(owner))
            .flat_map(|topic| topic.wanted.iter().map(|(position, _)| *position))
            .collect();
        self.order = positions.iter().map(|p| places.iter().position(|q| q == p)).collect();
        self.aligner = Aligner::new(&widths);
        Ok(())
    }

    fn next_rows(&mut self, rows: usize, block: &mut Block) -> Result<(), LogError> {
        while block.len() < rows {
            let Some((time, values)) = self.aligner.next() else {
                if self.done {
                    break;
                }
                match self.message()? {
                    Some(message) => self.absorb(&message)?,
                    None => {
                        self.done = true;
                        self.aligner.end();
                    }
                }
                continue;
            };
            self.row += 1;
            if self.damaged > 0 && self.row == 1 {
                let text = "messages that can't be decoded".into();
                block.bad.push(BadCell { row: 0, column: None, text });
            }
            block.lines.push(self.row + 1);
            let start = *self.start.get_or_insert(time);
            for (column, place) in block.columns.iter_mut().zip(&self.order) {
                // Differences of ns are exact; seconds since an epoch would lose the last 0.2 us.
                column.push(place.map_or((time - start) as f64 * 1e-9, |p| values[p]));
            }
        }
        Ok(())
    }
}
