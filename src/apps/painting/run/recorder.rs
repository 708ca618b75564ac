//! Recording of a run and its error figures.

use super::{Feedback, ForceErrors, Run, RunTask, Trace, root_mean_square};
use crate::apps::painting::tune::Tuning;
use crate::apps::painting::wall::WallSensor;
use crate::control::iterative_learning::Learned;
use crate::control::law::{Status, Target};
use crate::control::robot::RobotModel;
use crate::simulate::Instant;

/// The sensor in the wall through three first-order low-passes.
pub(super) struct FilteredWallSensor {
    sensor: WallSensor,
    low: [f64; 3],
    share: f64,
}

impl FilteredWallSensor {
    pub(super) fn new(task: &RunTask<'_>) -> Self {
        let turn = std::f64::consts::TAU * task.corner / task.sensors.rate;
        Self { sensor: WallSensor::new(task.seed), low: [0.0; 3], share: turn / (1.0 + turn) }
    }

    /// Filtered reading for the true force, N.
    pub(super) fn read(&mut self, truth: f64) -> f64 {
        let mut from = self.sensor.read(truth);
        for stage in &mut self.low {
            *stage += self.share * (from - *stage);
            from = *stage;
        }
        from
    }
}

/// Forces along the normal, N.
pub(super) struct Forces {
    pub estimated: f64,
    pub measured: f64,
    pub truth: f64,
}

/// Recording of the painting itself.
pub(super) struct Recorder<'a> {
    task: &'a RunTask<'a>,
    planned: RobotModel<'a>,
    pub trace: Trace,
    /// Largest planned joint speed at each sample, rad/s.
    pub pace: Vec<f64>,
    /// State of the controller.
    pub status: Status,
    /// Time without contact, s.
    idle: f64,
}

impl<'a> Recorder<'a> {
    pub(super) fn new(task: &'a RunTask<'a>, planned: RobotModel<'a>) -> Self {
        Self { task, planned, trace: Trace::default(), pace: Vec::new(), status: Status::Free, idle: 0.0 }
    }

    /// Records a sample, `t` s after painting began.
    pub(super) fn absorb<const N: usize>(
        &mut self,
        t: f64,
        forces: Forces,
        displacement: f64,
        target: &Target<N>,
        is: &Instant,
    ) {
        if self.status != Status::Pressing {
            self.idle += 1.0 / self.task.sensors.rate;
        }
        self.pace.push(target.dq.iter().fold(0.0_f64, |most, v| most.max(v.abs())));
        let contact = &self.task.wall.contact;
        let trace = &mut self.trace;
        trace.t.push(t);
        trace.estimated.push(forces.estimated);
        trace.measured.push(forces.measured);
        trace.truth.push(forces.truth);
        trace.displacement.push(displacement);
        trace.planned.push(self.planned.contact(&target.q).origin);
        trace.actual.push(std::array::from_fn(|i| {
            is.pose[4 * i + 3] + (0..3).map(|k| is.pose[4 * i + k] * contact[k]).sum::<f64>()
        }));
    }

    /// Whether contact held from beginning to end.
    pub(super) fn pressed_throughout(&self) -> bool {
        self.status == Status::Pressing && self.idle == 0.0
    }

    /// Desired force minus the one fed back, N.
    pub(super) fn force_error(&self) -> Vec<f64> {
        let fed_back = match self.task.feedback {
            Feedback::Estimated => &self.trace.estimated,
            Feedback::Measured => &self.trace.measured,
        };
        fed_back.iter().map(|f| self.task.force - f).collect()
    }

    pub(super) fn finish(self, tuning: Tuning, learned: Option<Learned>) -> Run {
        let (trace, force) = (self.trace, self.task.force);
        let rms = |difference: &dyn Fn(usize) -> f64| root_mean_square(trace.t.len(), difference);
        let n = self.task.wall.normal;
        let aside = |k: usize| {
            let d: [f64; 3] = std::array::from_fn(|i| trace.actual[k][i] - trace.planned[k][i]);
            let out: f64 = (0..3).map(|i| d[i] * n[i]).sum();
            (0..3).map(|i| (d[i] - out * n[i]).powi(2)).sum::<f64>().sqrt()
        };
        let accuracy = ForceErrors {
            estimated_measured: rms(&|k| trace.estimated[k] - trace.measured[k]),
            estimated_desired: rms(&|k| trace.estimated[k] - force),
            measured_desired: rms(&|k| trace.measured[k] - force),
        };
        Run { accuracy, tracking: rms(&aside), off: self.idle, status: self.status, tuning, learned, trace }
    }
}
