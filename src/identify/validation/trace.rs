//! Measured and estimated torque over time, thinned for plots such that spikes are kept.

use crate::data::signal::{Motion, MotionBlock};
use crate::identify::regression::rows::Rows;
use crate::model::Arm;

/// Largest number of points per curve.
const MOST: usize = 2400;

/// Curves of a joint: smallest and largest value within each point's stretch of time.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TraceJoint {
    /// Measured torque, N m.
    pub measured: Vec<[f64; 2]>,
    /// Estimated torque, N m.
    pub estimated: Vec<[f64; 2]>,
    /// Measured minus estimated torque, N m.
    pub residual: Vec<[f64; 2]>,
}

/// Thinned torques of a log.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Trace {
    /// Name of the log.
    pub name: String,
    /// Whether the log is used for validation.
    pub validates: bool,
    /// Start of each point's stretch, s, with segments end to end.
    pub time: Vec<f64>,
    /// Segment of each point; a curve is interrupted where it changes.
    pub segment: Vec<usize>,
    /// Curves of each joint.
    pub joints: Vec<TraceJoint>,
    /// Number of samples per point.
    pub thinning: usize,
}

/// Builds a [`Trace`] from motions, in bounded memory.
pub struct Tracer<'a> {
    arm: &'a dyn Arm,
    rows: Rows,
    beta: Vec<f64>,
    trace: Trace,
    clock: f64,
    /// Number of samples in the last point.
    filled: usize,
    segments: Option<usize>,
}

impl<'a> Tracer<'a> {
    /// Creates a tracer for a log, with base parameters `beta`.
    pub fn new(name: &str, validates: bool, arm: &'a dyn Arm, beta: &[f64]) -> Self {
        let joints = vec![TraceJoint::default(); arm.dof()];
        let trace = Trace { name: name.into(), validates, joints, thinning: 1, ..Trace::default() };
        Self { arm, rows: Rows::new(arm), beta: beta.to_vec(), trace, clock: 0.0, filled: 0, segments: None }
    }

    /// Adds a stretch of motion.
    pub fn absorb(&mut self, motion: &Motion) {
        let dof = self.arm.dof();
        let mut block = MotionBlock::default();
        let (mut regressor, mut estimated) = (Vec::new(), Vec::new());
        let mut from = 0;
        loop {
            let count = motion.gather(from, 256, &mut block);
            if count == 0 {
                break;
            }
            from += count;
            self.rows.evaluate(self.arm, &block.states, &block.sign, &mut regressor);
            estimated.clear();
            estimated.resize(dof * count, 0.0);
            for (entry, &(row, column)) in regressor.chunks_exact(count).zip(self.arm.base_pattern()) {
                let out = &mut estimated[row * count..(row + 1) * count];
                out.iter_mut().zip(entry).for_each(|(e, w)| *e += w * self.beta[column]);
            }
            for sample in 0..count {
                self.point(motion.segment, &block.tau, &estimated, sample, count);
                self.clock += motion.period * motion.stride.max(1) as f64;
            }
        }
    }

    fn point(&mut self, segment: usize, tau: &[f64], estimated: &[f64], sample: usize, count: usize) {
        let fresh = self.filled >= self.trace.thinning || self.segments != Some(segment);
        if fresh {
            if self.trace.time.len() >= MOST {
                self.thin();
            }
            self.trace.time.push(self.clock);
            self.trace.segment.push(segment);
            self.segments = Some(segment);
            self.filled = 0;
        }
        self.filled += 1;
        for (joint, curves) in self.trace.joints.iter_mut().enumerate() {
            let (m, e) = (tau[joint * count + sample], estimated[joint * count + sample]);
            for (curve, value) in [(&mut curves.measured, m), (&mut curves.estimated, e), (&mut curves.residual, m - e)]
            {
                match curve.last_mut() {
                    Some(last) if !fresh => *last = [last[0].min(value), last[1].max(value)],
                    _ => curve.push([value, value]),
                }
            }
        }
    }

    /// Merges neighbouring points pairwise.
    fn thin(&mut self) {
        fn halve<T: Copy>(all: &mut Vec<T>, join: impl Fn(T, T) -> T) {
            *all = all.chunks(2).map(|pair| if let [a, b] = *pair { join(a, b) } else { pair[0] }).collect();
        }
        let hull = |a: [f64; 2], b: [f64; 2]| [a[0].min(b[0]), a[1].max(b[1])];
        halve(&mut self.trace.time, |a, _| a);
        halve(&mut self.trace.segment, |a, _| a);
        for joint in &mut self.trace.joints {
            for curve in [&mut joint.measured, &mut joint.estimated, &mut joint.residual] {
                halve(curve, hull);
            }
        }
        self.trace.thinning *= 2;
    }

    /// The completed trace.
    pub fn finish(self) -> Trace {
        self.trace
    }
}
