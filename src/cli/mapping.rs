//! Which channel of a log is which column: `--map`, or `log:` in the robot file.

use std::path::{Path, PathBuf};

use clap::Args;
use dh_codegen::robot::{JointKind, Robot};

use super::Failure;
use super::files;
use crate::data::log::{Mapping, Reading, SourceJoint};

/// Names of a log's channels.
#[derive(Args, Clone)]
pub(super) struct MapOption {
    /// Maps channels of the logs to columns and units: a YAML file, as `denavit log inspect`
    /// proposes it. Default: `log:` of the robot file; without it columns t, q1.., tau1.., or
    /// joints by their names.
    #[arg(long, value_name = "YAML")]
    pub(super) map: Option<PathBuf>,
}

impl MapOption {
    /// With the joints of the robot.
    pub(super) fn reading(&self, robot: Option<&Robot>) -> Result<Reading, Failure> {
        let of_the_robot = || robot.and_then(|robot| robot.log.clone());
        let mapping = self.map.as_deref().map(mapping).transpose()?.or_else(of_the_robot);
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

fn mapping(path: &Path) -> Result<Mapping, Failure> {
    let text = files::text(path)?;
    Mapping::from_yaml(&text).map_err(|problems| {
        let shown = path.display().to_string();
        Failure::input(format!(
            "{shown} can't be used:\n{}\na mapping is `columns: {{ t: {{ channel: NAME, unit: ms }}, \"q*\": {{ channel: \"NAME_{{number}}\" }} }}`; `denavit log inspect LOG` proposes one",
            problems.in_file(&shown)
        ))
    })
}
