//! Findings of a log that the user accepts by name.

/// Accepted findings. By default nothing: each finding of that kind then stops the reading, and
/// says so.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Acceptance {
    /// Rows with an empty cell, NaN, infinity or text, or with too few or too many cells: the row
    /// is left out, and the log is split into segments there.
    pub bad_rows: bool,
    /// A step of time longer than 2.5 periods: the log is split there.
    pub gaps: bool,
    /// A time that runs back without a change of `seg`: the log is split there.
    pub restarts: bool,
    /// Rows with the time of the row before: left out.
    pub duplicates: bool,
    /// A clock with more than 5 % of its steps off by more than half a period: evened by cubic
    /// interpolation to the median rate.
    pub irregular_clock: bool,
    /// A channel that stands still while it should move: used unchanged.
    pub stuck: bool,
    /// A torque that is cut off at a level: used unchanged.
    pub clipped: bool,
    /// A torque that is zero throughout: the joint then takes no part in the fit.
    pub dead_torque: bool,
    /// Positions beyond two turns, which look like degrees: used unchanged.
    pub large_angles: bool,
    /// Torques far beyond the limits of most joints, like those in another unit: used unchanged.
    pub torque_unit: bool,
    /// Torque columns in another order, unit or place than their names say: used unchanged.
    pub misread: bool,
}

impl Acceptance {
    /// The names of the settings, for a command line.
    pub const NAMES: [&'static str; 11] = [
        "bad-rows",
        "gaps",
        "restarts",
        "duplicates",
        "irregular-clock",
        "stuck",
        "clipped",
        "dead-torque",
        "large-angles",
        "torque-unit",
        "misread",
    ];

    /// Everything.
    pub fn all() -> Self {
        let mut keep = Self::default();
        for name in Self::NAMES {
            keep.set(name);
        }
        keep
    }

    /// Allows what has this name; whether there is one.
    pub fn set(&mut self, name: &str) -> bool {
        let flag = match name {
            "bad-rows" => &mut self.bad_rows,
            "gaps" => &mut self.gaps,
            "restarts" => &mut self.restarts,
            "duplicates" => &mut self.duplicates,
            "irregular-clock" => &mut self.irregular_clock,
            "stuck" => &mut self.stuck,
            "clipped" => &mut self.clipped,
            "dead-torque" => &mut self.dead_torque,
            "large-angles" => &mut self.large_angles,
            "torque-unit" => &mut self.torque_unit,
            "misread" => &mut self.misread,
            _ => return false,
        };
        *flag = true;
        true
    }
}
