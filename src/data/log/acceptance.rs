//! Findings of the quality check that the user accepts by name.

/// Accepted findings. Default: none, so that each finding of these kinds is reported and stops the
/// reading.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Acceptance {
    /// Rows with an empty cell, NaN, infinity or text, or with too few or too many cells: such a
    /// row is left out, and the log is split into segments there.
    pub bad_rows: bool,
    /// A time step longer than 2.5 periods: the log is split there.
    pub gaps: bool,
    /// A time that decreases without a change of `seg`: the log is split there.
    pub restarts: bool,
    /// Rows that repeat the time of the previous row: left out.
    pub duplicates: bool,
    /// A clock with more than 5 % of its steps off by more than half a period: resampled by cubic
    /// interpolation at the median rate.
    pub irregular_clock: bool,
    /// A channel that stays constant while it should change: used unchanged.
    pub stuck: bool,
    /// A torque that saturates at a level: used unchanged.
    pub clipped: bool,
    /// A torque that is zero throughout: the joint is excluded from the fit.
    pub dead_torque: bool,
    /// Positions beyond two turns, which look like degrees: used unchanged.
    pub large_angles: bool,
    /// Torques far beyond the limits of most joints, which suggests another unit: used unchanged.
    pub torque_unit: bool,
    /// Columns whose data fit another order, unit or side of the gear than their names state: used
    /// unchanged.
    pub misread: bool,
}

impl Acceptance {
    /// Names of the settings, for the command line.
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

    /// Accepts every finding.
    pub fn all() -> Self {
        let mut keep = Self::default();
        for name in Self::NAMES {
            keep.set(name);
        }
        keep
    }

    /// Accepts the finding with this name; false if there is none.
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
