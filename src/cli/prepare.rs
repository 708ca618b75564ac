//! Options of the verbs that read logs: how samples become motion.

use clap::{Args, ValueEnum};

use super::Failure;
use crate::identify::{DeadZone, StackSettings};
use crate::log::{Keep, Quantity};
use crate::signal::{Filter, Prepare};

/// Low-pass, clock, torque column, and what to keep.
#[derive(Args, Clone)]
pub(super) struct Preparation {
    /// Cut-off frequency of the low-pass, Hz; 0 for none.
    #[arg(long, default_value_t = 10.0)]
    cutoff: f64,
    /// Order of one pass of the Butterworth low-pass.
    #[arg(long, default_value_t = 5)]
    order: usize,
    /// Seconds cut off both ends of each stretch.
    #[arg(long, default_value_t = 0.2)]
    trim: f64,
    /// Seconds by which the torque is late against the positions; it is moved back by as much.
    #[arg(long, default_value_t = 0.0, value_name = "SECONDS", allow_negative_numbers = true)]
    delay: f64,
    /// Use every n-th sample, after the low-pass.
    #[arg(long, default_value_t = 1, value_name = "N")]
    stride: usize,
    /// Which torque: `tau`, or `taum` (motor side).
    #[arg(long, value_enum, default_value_t = Torque::Tau)]
    torque: Torque,
    /// Speed below which a joint's rows are not used, rad/s; default from the noise.
    #[arg(long, value_name = "SPEED")]
    dead_zone: Option<f64>,
    /// Keep what is normally refused: bad-rows, gaps, restarts, duplicates, irregular-clock, stuck, clipped, dead-torque,
    /// large-angles, or all.
    #[arg(long, value_delimiter = ',', value_name = "WHAT")]
    keep: Vec<String>,
}

#[derive(Clone, Copy, ValueEnum)]
enum Torque {
    Tau,
    Taum,
}

impl Preparation {
    /// Checked.
    pub(super) fn prepare(&self) -> Result<Prepare, Failure> {
        let mut keep = Keep::default();
        for name in &self.keep {
            if name == "all" {
                keep = Keep::all();
            } else if !keep.set(name) {
                return Err(Failure::input(format!("--keep {name}: choose among {}, all", Keep::NAMES.join(", "))));
            }
        }
        let bad = |what: String| Err(Failure::input(what));
        if !(self.cutoff >= 0.0 && self.cutoff.is_finite()) {
            return bad(format!("--cutoff {}: a frequency in Hz, or 0 for none", self.cutoff));
        }
        if !(1..=12).contains(&self.order) {
            return bad(format!("--order {}: from 1 to 12", self.order));
        }
        if !(self.trim >= 0.0 && self.trim.is_finite()) {
            return bad(format!("--trim {}: seconds, zero or more", self.trim));
        }
        if self.delay.is_nan() || self.delay.abs() > 10.0 {
            return bad(format!("--delay {}: seconds, at most 10", self.delay));
        }
        if self.stride == 0 {
            return bad("--stride 0: one or more".into());
        }
        Ok(Prepare {
            filter: (self.cutoff > 0.0).then_some(Filter { order: self.order, cutoff: self.cutoff }),
            trim: self.trim,
            torque_delay: self.delay,
            stride: self.stride,
            torque: match self.torque {
                Torque::Tau => Quantity::Tau,
                Torque::Taum => Quantity::Taum,
            },
            keep,
            ..Prepare::default()
        })
    }

    /// What is done near standstill.
    pub(super) fn stack(&self) -> StackSettings {
        let dead_zone = match self.dead_zone {
            Some(speed) if speed > 0.0 => DeadZone::Fixed(speed),
            Some(_) => DeadZone::Off,
            None => DeadZone::FromNoise,
        };
        StackSettings { dead_zone, ..StackSettings::default() }
    }

    /// For the foot of a report.
    pub(super) fn low_pass(&self) -> String {
        if self.cutoff > 0.0 {
            format!("Butterworth order {}, {} Hz, forward and backward", self.order, self.cutoff)
        } else {
            "none".into()
        }
    }
}
