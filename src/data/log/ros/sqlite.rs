//! Reads `.db3`: SQLite tables in which rosbag2 recorded by default up to ROS 2 Humble.

use std::collections::{HashMap, VecDeque};

use rusqlite::{Connection, params};

use super::recording::{Message, Messages};
use crate::data::log::Malformed;

/// Messages read from the table at once, and length of the longest one, bytes; longer ones, such as
/// images, are skipped.
const PAGE: (i64, i64) = (256, 1 << 16);

/// A topic: name, type, and definition if the recording has one.
struct Topic {
    name: String,
    kind: String,
    definition: String,
}

/// Messages of a `.db3` file in recorded order.
pub(crate) struct SqliteMessages {
    connection: Connection,
    topics: HashMap<i64, Topic>,
    passed_over: Vec<String>,
    queue: VecDeque<Message>,
    /// Id of the last row that was read.
    last: i64,
    done: bool,
}

impl SqliteMessages {
    /// Reads the topics.
    ///
    /// # Errors
    /// If the tables are not those of rosbag2.
    pub fn new(connection: Connection) -> rusqlite::Result<Self> {
        let mut messages = Self {
            connection,
            topics: HashMap::new(),
            passed_over: Vec::new(),
            queue: VecDeque::new(),
            last: i64::MIN,
            done: false,
        };
        messages.read_topics()?;
        Ok(messages)
    }

    fn read_topics(&mut self) -> rusqlite::Result<()> {
        // Recordings from before ROS 2 Iron have no definitions.
        let texts: HashMap<String, String> = self
            .connection
            .prepare(
                "SELECT topic_type, encoded_message_definition FROM message_definitions WHERE encoding = 'ros2msg'",
            )
            .and_then(|mut rows| rows.query_map([], |row| Ok((row.get(0)?, row.get(1)?)))?.collect())
            .unwrap_or_default();
        let mut rows = self.connection.prepare("SELECT id, name, type, serialization_format FROM topics")?;
        let mut rows = rows.query([])?;
        while let Some(row) = rows.next()? {
            let (name, kind, format): (String, String, String) = (row.get(1)?, row.get(2)?, row.get(3)?);
            if format != "cdr" {
                self.passed_over.push(format!("the topic {name} is written as `{format}`; `cdr` is read"));
                continue;
            }
            let definition = texts.get(&kind).cloned().unwrap_or_default();
            self.topics.insert(row.get(0)?, Topic { name, kind, definition });
        }
        Ok(())
    }

    /// Reads the next page of rows.
    fn page(&mut self) -> rusqlite::Result<()> {
        let mut rows = self.connection.prepare_cached(
            "SELECT id, topic_id, timestamp, data FROM messages WHERE id > ?1 AND length(data) <= ?2 ORDER BY id LIMIT ?3",
        )?;
        let mut rows = rows.query(params![self.last, PAGE.1, PAGE.0])?;
        self.done = true;
        while let Some(row) = rows.next()? {
            (self.last, self.done) = (row.get(0)?, false);
            let Some(topic) = self.topics.get(&row.get(1)?) else { continue };
            let message = Message { topic: topic.name.clone(), arrival: row.get(2)?, bytes: row.get(3)? };
            self.queue.push_back(message);
        }
        Ok(())
    }
}

impl Messages for SqliteMessages {
    fn next(&mut self) -> Result<Option<Message>, Malformed> {
        while self.queue.is_empty() && !self.done {
            self.page()?;
        }
        Ok(self.queue.pop_front())
    }

    fn definition(&self, topic: &str) -> Option<(&str, &str)> {
        let topic = self.topics.values().find(|t| t.name == topic)?;
        Some((topic.kind.as_str(), topic.definition.as_str()))
    }

    fn passed_over(&self) -> Vec<String> {
        self.passed_over.clone()
    }
}
