//! Opens a robot file on disk.

use std::io::Error;
use std::path::Path;

use super::{Problem, Problems, Robot};

impl Robot {
    /// Reads the robot file at `path`, and the tool file that it references, relative to its
    /// folder.
    ///
    /// ```
    /// let robot = dh_codegen::robot::Robot::open("../../robots/planar2r.yaml")?;
    /// assert_eq!(robot.joints.len(), 2);
    /// # Ok::<(), dh_codegen::robot::Problems>(())
    /// ```
    ///
    /// # Errors
    /// All mistakes of the file at once, with line and column; or the error of reading it.
    pub fn open(path: impl AsRef<Path>) -> Result<Self, Problems> {
        let path = path.as_ref();
        let name = path.display().to_string();
        let text = std::fs::read_to_string(path).map_err(|error| {
            let what = format!("can't be read: {error}");
            let mend = "name a robot file".to_string();
            Problems(vec![Problem { file: None, path: String::new(), line: 1, column: 1, what, mend }]).in_file(&name)
        })?;
        let beside = |tool: &str| {
            let text = std::fs::read_to_string(path.with_file_name(tool));
            text.map_err(|e| Error::new(e.kind(), format!("{tool}: {e}")))
        };
        Self::from_yaml(&text, &beside).map(|reading| reading.robot).map_err(|problems| problems.in_file(&name))
    }
}
