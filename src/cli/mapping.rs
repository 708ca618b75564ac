//! `--map`: which channel of a log is which column, from a file.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use clap::Args;
use dh_codegen::robot::{JointKind, Robot};
use serde::Deserialize;

use super::Failure;
use super::files;
use crate::data::log::{Channel, Mapping, Reading, SourceJoint};

/// Names of a log's channels.
#[derive(Args, Clone)]
pub(super) struct MapOption {
    /// Which channel of the logs is which column, and in what unit: a YAML file, as `denavit log
    /// inspect` proposes it. Default: columns t, q1.., tau1..; joints by their names.
    #[arg(long, value_name = "YAML")]
    pub(super) map: Option<PathBuf>,
}

impl MapOption {
    /// With the joints of the robot.
    pub(super) fn reading(&self, robot: Option<&Robot>) -> Result<Reading, Failure> {
        let mapping = self.map.as_deref().map(mapping).transpose()?;
        Ok(Reading { mapping, joints: robot.map(joints).unwrap_or_default() })
    }
}

/// The moving joints of a robot, as the file that it was imported from has them.
pub(super) fn joints(robot: &Robot) -> Vec<SourceJoint> {
    let moving = robot.joints.iter().filter(|joint| joint.kind != JointKind::Fixed);
    moving
        .map(|joint| match &joint.source {
            Some(source) => SourceJoint {
                name: source.name.clone().unwrap_or_else(|| joint.name.clone()),
                sign: source.sign,
                offset: source.offset,
            },
            None => SourceJoint { name: joint.name.clone(), sign: 1.0, offset: 0.0 },
        })
        .collect()
}

/// The file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct MapFile {
    /// `header`: the stamp that a message carries; `arrival`: the recorder's.
    #[serde(default)]
    clock: Clock,
    columns: BTreeMap<String, Entry>,
}

#[derive(Deserialize, Default, Clone, Copy, PartialEq)]
#[serde(rename_all = "snake_case")]
enum Clock {
    #[default]
    Header,
    Arrival,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Entry {
    Name(String),
    Channel(ChannelEntry),
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ChannelEntry {
    channel: String,
    unit: Option<String>,
    #[serde(default)]
    gain: OneOrMany,
    #[serde(default)]
    offset: OneOrMany,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum OneOrMany {
    One(f64),
    Many(Vec<f64>),
}

impl Default for OneOrMany {
    fn default() -> Self {
        Self::Many(Vec::new())
    }
}

impl From<OneOrMany> for Vec<f64> {
    fn from(values: OneOrMany) -> Self {
        match values {
            OneOrMany::One(value) => vec![value],
            OneOrMany::Many(values) => values,
        }
    }
}

fn mapping(path: &Path) -> Result<Mapping, Failure> {
    let text = files::text(path)?;
    let file: MapFile = serde_saphyr::from_str(&text).map_err(|e| {
        Failure::input(format!(
            "{}: {e}\na mapping is `columns: {{ t: {{ channel: NAME, unit: ms }}, \"q*\": {{ channel: \"NAME_{{number}}\" }} }}`; `denavit log inspect LOG` proposes one",
            path.display()
        ))
    })?;
    let columns = file
        .columns
        .into_iter()
        .map(|(column, entry)| {
            let channel = match entry {
                Entry::Name(name) => Channel { name, unit: None, gain: Vec::new(), offset: Vec::new() },
                Entry::Channel(e) => {
                    Channel { name: e.channel, unit: e.unit, gain: e.gain.into(), offset: e.offset.into() }
                }
            };
            (column, channel)
        })
        .collect();
    Ok(Mapping { columns, arrival: file.clock == Clock::Arrival })
}
