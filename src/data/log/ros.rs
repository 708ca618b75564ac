//! Recordings of ROS 2: messages on topics become channels of numbers, channels become columns.

mod align;
mod cdr;
mod definition;
mod flatten;
mod mcap;
mod names;
mod recording;
#[cfg(feature = "rosbag2")]
mod sqlite;

pub use mcap::McapMessages;
pub(crate) use names::columns;
pub use recording::{Message, Messages, Recording};
#[cfg(feature = "rosbag2")]
pub use sqlite::SqliteMessages;
