//! Sensors: converts the true motion and torques into a log.

use super::drive::Drive;
use super::noise::{Coloured, Noise};
use super::trajectory::Point;
use crate::data::log::{Layout, Log};
use crate::numerics::hermite::cubic;

/// Side of the gear on which a sensor is mounted.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Side {
    /// Motor side: the motor's angle and torque, referred to the joint side of the gear.
    #[default]
    Motor,
    /// Link side: the link's angle, and the torque that the gear transmits.
    Link,
}

/// Recorded quantities and their accuracy. A list has one entry, or one per joint.
#[derive(Debug, Clone, PartialEq)]
pub struct Sensors {
    /// Sampling rate, Hz.
    pub rate: f64,
    /// Step of the encoders, rad; 0: none.
    pub encoder: Vec<f64>,
    /// White noise of the positions before they are rounded, standard deviation, rad.
    pub position_noise: Vec<f64>,
    /// White noise of the torques, standard deviation, N m.
    pub torque_noise: Vec<f64>,
    /// Coloured noise of the torques, standard deviation, N m.
    pub torque_colour: Vec<f64>,
    /// Corner frequency of the coloured noise, Hz.
    pub colour_corner: f64,
    /// Step of the torque sensors, N m; 0: none.
    pub torque_step: Vec<f64>,
    /// Delay of all samples relative to their time stamps, s.
    pub latency: f64,
    /// Jitter of the sampling instants, standard deviation, s; the time stamps are true.
    pub jitter: f64,
    /// Side of `tau`; with the link side `taum` is recorded too.
    pub torque: Side,
    /// Side of `q`; with the link side `qm` is recorded too.
    pub position: Side,
    /// Whether `dq` is recorded.
    pub velocity: bool,
    /// White noise of `dq`, standard deviation, rad/s.
    pub velocity_noise: Vec<f64>,
    /// Whether `qd` is recorded.
    pub desired: bool,
    /// Whether `temp` is recorded, in steps of 0.1 degrees C.
    pub temperature: bool,
    /// Whether the external wrench is recorded.
    pub wrench: bool,
}

impl Default for Sensors {
    /// 1 kHz as in the paper. Encoder step 1e-5 rad: an absolute encoder of 19 bits, or a motor's
    /// of 13 bits behind a gear of 100. White noise of 0.05 N m: the order of the resolution of
    /// joint torque sensors of light-weight arms.
    fn default() -> Self {
        Self {
            rate: 1000.0,
            encoder: vec![1e-5],
            position_noise: vec![0.0],
            torque_noise: vec![0.05],
            torque_colour: vec![0.0],
            colour_corner: 2.0,
            torque_step: vec![0.0],
            latency: 0.0,
            jitter: 0.0,
            torque: Side::Motor,
            position: Side::Motor,
            velocity: false,
            velocity_noise: vec![1e-3],
            desired: true,
            temperature: false,
            wrench: false,
        }
    }
}

impl Sensors {
    /// Ideal sensors.
    pub fn perfect(rate: f64) -> Self {
        Self { rate, encoder: vec![0.0], torque_noise: vec![0.0], velocity_noise: vec![0.0], ..Self::default() }
    }

    /// Sampling instants from `start` to `end`, s.
    pub(super) fn instants(&self, start: f64, end: f64, seed: u64) -> Vec<f64> {
        let count = ((end - start) * self.rate * (1.0 + 1e-12) + 1e-9).floor().max(0.0) as usize + 1;
        let mut noise = Noise::new(seed, 1);
        let period = 1.0 / self.rate;
        (0..count)
            .map(|k| {
                let even = start + k as f64 / self.rate;
                if self.jitter <= 0.0 || k == 0 {
                    return even;
                }
                // Limited so that samples keep their order; time stamps have whole microseconds.
                let off = (self.jitter * noise.normal()).clamp(-0.45 * period, 0.45 * period);
                (((even + off) * 1e6).round() / 1e6).clamp(start, end)
            })
            .collect()
    }
}

/// True motion and torques, joint-major over the samples.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Truth {
    /// Times, s.
    pub t: Vec<f64>,
    /// Angles of the motors on the joint side of the gear, rad.
    pub motor_q: Vec<f64>,
    /// Velocities of the motors, rad/s.
    pub motor_dq: Vec<f64>,
    /// Angles of the links, rad.
    pub link_q: Vec<f64>,
    /// Velocities of the links, rad/s.
    pub link_dq: Vec<f64>,
    /// Torques of the motors, N m.
    pub motor_torque: Vec<f64>,
    /// Torques that the gears transmit, N m.
    pub link_torque: Vec<f64>,
    /// Desired motion.
    pub desired: Vec<Point>,
    /// Temperatures of the joints, degrees C.
    pub temperature: Vec<f64>,
    /// External force (N) and moment (N m) on the tool, tool axes, `6 * samples`.
    pub wrench: Vec<f64>,
}

impl Truth {
    pub(super) fn sized(dof: usize, t: Vec<f64>) -> Self {
        let all = vec![0.0; dof * t.len()];
        Self {
            motor_q: all.clone(),
            motor_dq: all.clone(),
            link_q: all.clone(),
            link_dq: all.clone(),
            motor_torque: all.clone(),
            link_torque: all.clone(),
            desired: vec![[0.0; 3]; all.len()],
            temperature: all,
            wrench: vec![0.0; 6 * t.len()],
            t,
        }
    }
}

/// Sensor readings of a true motion, as a log.
pub(super) fn record(truth: &Truth, drives: &[Drive], sensors: &Sensors, seed: u64) -> Log {
    let (n, len) = (drives.len(), truth.t.len());
    let of = |list: &[f64], joint: usize| list.get(joint).or(list.first()).copied().unwrap_or(0.0);
    let joint = |values: &[f64], j: usize| values[j * len..(j + 1) * len].to_vec();
    let late = |values: Vec<f64>, age: f64| if age == 0.0 { values } else { shifted(&truth.t, &values, age) };
    let stepped = |values: &mut Vec<f64>, step: f64| {
        if step > 0.0 {
            values.iter_mut().for_each(|v| *v = (*v / step).round() * step);
        }
    };
    let noisy = |values: &mut Vec<f64>, size: f64, stream: u64| {
        if size > 0.0 {
            let mut noise = Noise::new(seed, stream);
            values.iter_mut().for_each(|v| *v += size * noise.normal());
        }
    };
    let mut names = vec!["t".to_string()];
    let mut columns = vec![truth.t.clone()];
    let mut add = |prefix: &str, make: &dyn Fn(usize) -> Vec<f64>| {
        for j in 0..n {
            names.push(format!("{prefix}{}", j + 1));
            columns.push(make(j));
        }
    };
    let position = |angles: &[f64], j: usize, stream: u64| {
        let mut q: Vec<f64> = joint(angles, j).iter().map(|q| q - drives[j].encoder_offset).collect();
        q = late(q, sensors.latency);
        noisy(&mut q, of(&sensors.position_noise, j), stream + j as u64);
        stepped(&mut q, of(&sensors.encoder, j));
        q
    };
    let torque = |torques: &[f64], j: usize, stream: u64| {
        let drive = &drives[j];
        let mut tau = late(joint(torques, j), sensors.latency + drive.delay);
        tau.iter_mut().for_each(|tau| *tau = drive.gain * *tau + drive.offset);
        noisy(&mut tau, of(&sensors.torque_noise, j), stream + j as u64);
        let size = of(&sensors.torque_colour, j);
        if size > 0.0 {
            let mut colour =
                Coloured::new(Noise::new(seed, stream + 1000 + j as u64), sensors.colour_corner, 1.0 / sensors.rate);
            tau.iter_mut().for_each(|tau| *tau += size * colour.next());
        }
        stepped(&mut tau, of(&sensors.torque_step, j));
        tau
    };
    let link_position = sensors.position == Side::Link;
    let link_torque = sensors.torque == Side::Link;
    add("q", &|j| position(if link_position { &truth.link_q } else { &truth.motor_q }, j, 10_000));
    if link_position {
        add("qm", &|j| position(&truth.motor_q, j, 20_000));
    }
    if sensors.velocity {
        add("dq", &|j| {
            let mut dq = late(joint(if link_position { &truth.link_dq } else { &truth.motor_dq }, j), sensors.latency);
            noisy(&mut dq, of(&sensors.velocity_noise, j), 30_000 + j as u64);
            dq
        });
    }
    add("tau", &|j| torque(if link_torque { &truth.link_torque } else { &truth.motor_torque }, j, 40_000));
    if link_torque {
        add("taum", &|j| torque(&truth.motor_torque, j, 50_000));
    }
    if sensors.desired {
        add("qd", &|j| truth.desired[j * len..(j + 1) * len].iter().map(|p| p[0]).collect());
    }
    if sensors.temperature || drives.iter().any(|d| d.drift.is_some_and(|d| d.per_kelvin != 0.0)) {
        add("temp", &|j| joint(&truth.temperature, j).iter().map(|c| (c * 10.0).round() / 10.0).collect());
    }
    if sensors.wrench {
        for (i, name) in ["fx", "fy", "fz", "mx", "my", "mz"].iter().enumerate() {
            names.push((*name).into());
            columns.push(truth.wrench[i * len..(i + 1) * len].to_vec());
        }
    }
    let roles = names.iter().filter_map(|name| crate::data::log::Role::of(name)).collect();
    let positions = (0..names.len()).collect();
    let layout = Layout { file: "simulated".into(), dof: n, roles, positions, ignored: Vec::new(), width: names.len() };
    Log { layout, columns, starts: vec![0], findings: Vec::new() }
}

/// Values `age` s before each instant, by a cubic with finite-difference slopes; before the start,
/// the first value.
fn shifted(t: &[f64], values: &[f64], age: f64) -> Vec<f64> {
    let last = t.len() - 1;
    if last == 0 {
        return values.to_vec();
    }
    let slope = |k: usize| {
        let (a, b) = (k.saturating_sub(1), (k + 1).min(last));
        (values[b] - values[a]) / (t[b] - t[a])
    };
    t.iter()
        .map(|&now| {
            let at = (now - age).clamp(t[0], t[last]);
            let k = t.partition_point(|&x| x <= at).saturating_sub(1).min(last - 1);
            let h = t[k + 1] - t[k];
            let s = (at - t[k]) / h;
            let (a, b) = (slope(k) * h, slope(k + 1) * h);
            cubic([values[k], values[k + 1]], [a, b], s)
        })
        .collect()
}
