//! Mapping of a log's channels to columns: `--map`, or `log:` in the robot file.

use std::path::{Path, PathBuf};

use clap::Args;
use dh_codegen::robot::Robot;

use super::Failure;
use super::files;
use crate::data::log::{Mapping, Reading};
use crate::identify::recording::source_joints;

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
    /// Interpretation of a log's columns, with the joints of the robot.
    pub(super) fn reading(&self, robot: Option<&Robot>) -> Result<Reading, Failure> {
        let of_the_robot = || robot.and_then(|robot| robot.log.clone());
        let mapping = self.map.as_deref().map(mapping).transpose()?.or_else(of_the_robot);
        Ok(Reading { mapping, joints: robot.map(source_joints).unwrap_or_default() })
    }
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
