//! Reads ROS 2 recordings: messages on topics become numeric channels, and channels become columns.

mod align;
mod cdr;
mod definition;
mod flatten;
mod mcap;
mod names;
mod recording;
#[cfg(feature = "rosbag2")]
mod sqlite;

pub use cdr::CdrError;
pub use mcap::McapError;
pub(crate) use mcap::McapMessages;
pub(crate) use names::columns;
pub(crate) use recording::Recording;
#[cfg(feature = "rosbag2")]
pub(crate) use sqlite::SqliteMessages;
