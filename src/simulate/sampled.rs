//! Runs the arm under a user's controller. It is called once per period with the sensor readings,
//! and its torques are held until the next call.

use super::Method;
use super::SimulateError;
use super::Simulator;
use super::Solver;
use super::Trajectory;
use super::contact::External;
use super::control::{Control, Mode, Table};
use super::drive::Drive;
use super::noise::{Coloured, Noise};
use super::plant::{Parts, Plant};
use super::robot::Settled;
use super::sensors::{Sensors, Side};
use crate::numerics::integrators::{Pace, dormand_prince::DormandPrince, rosenbrock::Rosenbrock};

/// Settings of a run with a sampled controller.
#[derive(Debug, Clone, PartialEq)]
pub struct Sampled {
    /// Posture at rest at the start, rad or m.
    pub start: Vec<f64>,
    /// Duration, s.
    pub seconds: f64,
    /// Sensors of the controller; their rate is the controller's.
    pub sensors: Sensors,
    /// Settings of the integrator.
    pub solver: Solver,
    /// Seed of the sensor noise.
    pub seed: u64,
}

/// Sensor readings at one instant; no reading is newer. Torques are those held up to the instant.
#[derive(Debug, Clone, PartialEq)]
pub struct Seen {
    /// Time, s.
    pub t: f64,
    /// Positions, rad or m.
    pub q: Vec<f64>,
    /// Torques, N m.
    pub tau: Vec<f64>,
}

/// True quantities at the same instant.
#[derive(Debug, Clone, PartialEq)]
pub struct Instant {
    /// Angles of the links, rad.
    pub q: Vec<f64>,
    /// Velocities of the links, rad/s.
    pub dq: Vec<f64>,
    /// Pose of the tool: top three rows of its matrix, world axes.
    pub pose: [f64; 12],
    /// Force (N) and moment (N m) on the tool, about its origin, world axes.
    pub wrench: [f64; 6],
}

/// Sensors of a running arm, with their noise and history.
struct Gauges<'a> {
    sensors: &'a Sensors,
    drives: &'a [Drive],
    position: Vec<Noise>,
    torque: Vec<Noise>,
    colour: Vec<Coloured>,
    /// Readings of the last instants, newest last: motor or link positions, then torques.
    past: Vec<Vec<f64>>,
}

impl<'a> Gauges<'a> {
    fn new(sensors: &'a Sensors, drives: &'a [Drive], seed: u64) -> Self {
        let streams = |from: u64| (0..drives.len() as u64).map(|j| Noise::new(seed, from + j)).collect::<Vec<_>>();
        let colour = streams(61_000);
        let colour = colour.into_iter().map(|n| Coloured::new(n, sensors.colour_corner, 1.0 / sensors.rate)).collect();
        Self { sensors, drives, position: streams(60_000), torque: streams(62_000), colour, past: Vec::new() }
    }

    /// Value `at` of the readings `age` samples ago, interpolated linearly.
    fn aged(&self, at: usize, age: f64) -> f64 {
        let last = self.past.len() - 1;
        let whole = age.floor();
        let back = |k: f64| self.past[last.saturating_sub(k as usize)][at];
        back(whole) + (age - whole) * (back(whole + 1.0) - back(whole))
    }

    fn see(&mut self, t: f64, q: &[f64], tau: &[f64]) -> Seen {
        let n = self.drives.len();
        let Sensors { rate, latency, .. } = *self.sensors;
        let most = self.drives.iter().fold(0.0_f64, |m, d| m.max(d.delay)) + latency;
        self.past.push(q.iter().chain(tau).copied().collect());
        let keep = (most * rate).ceil() as usize + 2;
        if self.past.len() > keep {
            self.past.remove(0);
        }
        let of = |list: &[f64], j: usize| list.get(j).or(list.first()).copied().unwrap_or(0.0);
        let stepped = |value: f64, step: f64| if step > 0.0 { (value / step).round() * step } else { value };
        let mut seen = Seen { t, q: vec![0.0; n], tau: vec![0.0; n] };
        for j in 0..n {
            let drive = &self.drives[j];
            let q = self.aged(j, latency * rate) - drive.encoder_offset
                + of(&self.sensors.position_noise, j) * self.position[j].normal();
            seen.q[j] = stepped(q, of(&self.sensors.encoder, j));
            let tau = drive.gain * self.aged(n + j, (latency + drive.delay) * rate)
                + drive.offset
                + of(&self.sensors.torque_noise, j) * self.torque[j].normal()
                + of(&self.sensors.torque_colour, j) * self.colour[j].next();
            seen.tau[j] = stepped(tau, of(&self.sensors.torque_step, j));
        }
        seen
    }
}

impl Simulator {
    /// Runs a controller. Every `1 / sensors.rate` s it receives the readings and, for recording,
    /// the true quantities, and writes the torques (N m) of the next period. Returning `false` ends
    /// the run early.
    pub fn run_sampled(
        &self,
        run: &Sampled,
        external: &[&dyn External],
        controller: &mut dyn FnMut(&Seen, &Instant, &mut [f64]) -> bool,
    ) -> Result<(), SimulateError> {
        self.built.is_free_of_accelerations()?;
        let (n, rate) = (self.dof(), run.sensors.rate);
        let setting = |what, value: f64, good: bool, must| {
            if good { Ok(()) } else { Err(SimulateError::Setting { what, value, must }) }
        };
        setting("sensors.rate", rate, rate > 0.0 && rate <= 1e5, "be greater than 0, and at most 100000 Hz")?;
        setting(
            "the duration",
            run.seconds,
            run.seconds > 0.0 && run.seconds <= 1e5,
            "be greater than 0, and at most 100000 s",
        )?;
        if run.start.len() != n {
            return Err(SimulateError::Joints { found: run.start.len(), expected: n });
        }
        let rest = Trajectory::rest(&run.start, run.seconds)?;
        // Gains are zero: the torques in `held` replace this loop from the first instant.
        let control = Control { mode: Mode::Position, ..Control::default() };
        let span = rest.span();
        let Settled { drives, couplings, contacts } =
            self.built.settle(&span, &vec![0.0; n], std::slice::from_ref(&run.start));
        let mut bodies = self.built.real().bodies(&self.built.bodies_standard);
        let mut plant = Plant::new(Parts {
            bodies: &mut bodies,
            drives: &drives,
            couplings: &couplings,
            contacts: &contacts,
            external,
            trajectory: &rest,
            control: &control,
            gains: [vec![0.0; n], vec![0.0; n]],
            feedforward: Table::default(),
        });
        let mut y = plant.initial();
        // Torques that balance gravity hold the arm at the first instant, in place of brakes.
        plant.held = vec![0.0; n];
        plant.look(0.0, &y)?;
        plant.held = plant.gravity();
        let stiff = run.solver.method != Method::DormandPrince;
        let (mut rosenbrock, mut dormand_prince) = (Rosenbrock::default(), DormandPrince::default());
        let mut pace = Pace::new(run.solver);
        let mut gauges = Gauges::new(&run.sensors, &drives, run.seed);
        let total = plant.motor.iter().fold(n, |most, &m| most.max(m + 1));
        let samples = (run.seconds * rate).round() as usize;
        let motors = plant.motor.clone();
        for k in 0..=samples {
            let t = k as f64 / rate;
            plant.look(t, &y)?;
            let motor: Vec<f64> = motors.iter().map(|&m| y[m]).collect();
            let q = if run.sensors.position == Side::Link { &y[..n] } else { &motor[..] };
            let tau = if run.sensors.torque == Side::Link { &plant.now.link_torque } else { &plant.now.motor_torque };
            let seen = gauges.see(t, q, tau);
            if !y.iter().chain(&seen.tau).all(|x| x.is_finite()) {
                return Err(SimulateError::NotFinite);
            }
            let wrench = plant.now.wrench;
            let pose = plant.tool_pose(&y);
            let base = super::contact::in_base(&pose, &wrench);
            let instant = Instant { q: y[..n].to_vec(), dq: y[total..total + n].to_vec(), pose, wrench: base };
            if !controller(&seen, &instant, &mut plant.held) || k == samples {
                break;
            }
            // The torques change at this instant, so the last step length is a poor guide for the
            // first step after it.
            pace.next = pace.next.min(0.5 / rate);
            let end = (k + 1) as f64 / rate;
            match stiff {
                true => rosenbrock.advance(&mut plant, &mut pace, t, end, &mut y)?,
                false => dormand_prince.advance(&mut plant, &mut pace, t, end, &mut y)?,
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ramps show the delay of each reading: positions by the latency, torques also by the delay of
    /// their drive.
    #[test]
    fn torques_are_late_by_latency_and_delay() {
        let sensors = Sensors { latency: 2.5e-3, ..Sensors::perfect(1e3) };
        let drives = [Drive { delay: 4.25e-3, ..Drive::ideal(10.0) }];
        let mut gauges = Gauges::new(&sensors, &drives, 1);
        for k in 0..60 {
            let t = 1e-3 * f64::from(k);
            let seen = gauges.see(t, &[3.0 * t], &[7.0 * t]);
            if k > 20 {
                assert!((seen.q[0] - 3.0 * (t - 2.5e-3)).abs() < 1e-12, "{k}");
                assert!((seen.tau[0] - 7.0 * (t - 6.75e-3)).abs() < 1e-12, "{k}");
            }
        }
    }

    /// An encoder mounted at +0.1 rad reads 0.1 rad less.
    #[test]
    fn an_encoder_says_less_by_its_offset() {
        let sensors = Sensors::perfect(1e3);
        let drives = [Drive { encoder_offset: 0.1, ..Drive::ideal(10.0) }];
        let mut gauges = Gauges::new(&sensors, &drives, 1);
        let seen = (0..9).map(|k| gauges.see(1e-3 * f64::from(k), &[0.7], &[0.0]).q[0]).last();
        assert!((seen.unwrap() - 0.6).abs() < 1e-12, "{seen:?}");
    }
}
