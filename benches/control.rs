//! A step of the controller with force estimate on the generated KUKA LWR: equations (13), (14),
//! (15), gravity, closed-form inverse kinematics.
//!
//! `cargo bench --bench control` prints the distribution over a million steps along a painting
//! stroke: median, 99th and 99.99th percentile and maximum, by three clocks. Costly cases get a
//! tenth as many steps: a wall out of reach, an outstretched arm, an aligned wrist, missing
//! samples.
//!
//! `cargo bench --bench control -- --hostile 100000000` runs this number of steps with a failure
//! half of the time, and prints a histogram of the times.
//!
//! - wall: includes everything else on the machine; meaningful on an idle machine, or on a reserved
//!   core;
//! - thread: processor time of the thread alone, so that preemption does not count (interrupts and
//!   caches used by others do). The clock is a system call: the cost of two calls is measured and
//!   reported, not subtracted;
//! - best of three: the same step from the same state three times, the fastest by the wall clock:
//!   the cost of the law itself with warm caches.

#[path = "control/hostile.rs"]
mod hostile;

use std::time::{Duration, Instant};

use denavit::control::law::{
    Body, Controller, Estimator, EstimatorSettings, ForceSettings, JointLoop, Limits, Model, Sample, Settings, Status,
    Target, Tool, moved,
};
use kuka_lwr4::ik::{Query, Reference};

const N: usize = kuka_lwr4::DOF;
/// Distance from the last frame to the roller's face, m.
const REACH: f64 = 0.428;

#[derive(Clone)]
struct Lwr {
    beta: [f64; kuka_lwr4::BASE],
}

impl Lwr {
    fn contact(&self, q: &[f64; N]) -> Tool<N> {
        let frame = kuka_lwr4::forward_kinematics(q);
        let mut jacobian = kuka_lwr4::jacobian(q);
        let arm = [frame[0][2] * REACH, frame[1][2] * REACH, frame[2][2] * REACH];
        for j in 0..N {
            let w = [jacobian[3][j], jacobian[4][j], jacobian[5][j]];
            jacobian[0][j] += w[1] * arm[2] - w[2] * arm[1];
            jacobian[1][j] += w[2] * arm[0] - w[0] * arm[2];
            jacobian[2][j] += w[0] * arm[1] - w[1] * arm[0];
        }
        let rotation = [0, 1, 2].map(|i| [frame[i][0], frame[i][1], frame[i][2]]);
        Tool { origin: [0, 1, 2].map(|i| frame[i][3] + arm[i]), rotation, jacobian }
    }
}

impl Model<N> for Lwr {
    fn gravity(&mut self, q: &[f64; N]) -> [f64; N] {
        kuka_lwr4::gravity(q, &self.beta)
    }

    fn moving(&mut self, q: &[f64; N], dq: &[f64; N], ddq: &[f64; N]) -> [f64; N] {
        let (all, still) =
            (kuka_lwr4::inverse_dynamics_base(q, dq, ddq, &self.beta), kuka_lwr4::gravity(q, &self.beta));
        std::array::from_fn(|j| all[j] - still[j])
    }

    fn pressing(&mut self, q: &[f64; N], along: &[f64; 3]) -> [f64; N] {
        let jacobian = self.contact(q).jacobian;
        std::array::from_fn(|j| (0..3).map(|k| jacobian[k][j] * along[k]).sum())
    }

    fn touch(&mut self, q: &[f64; N]) -> Option<Tool<N>> {
        Some(self.contact(q))
    }

    fn displaced(&mut self, q: &[f64; N], by: &[f64; 3], near: &[f64; N]) -> Option<[f64; N]> {
        let mut pose = kuka_lwr4::forward_kinematics(q);
        (0..3).for_each(|i| pose[i][3] += by[i]);
        let reference = Reference::UP;
        let redundancy = kuka_lwr4::IK.redundancy(q, &reference);
        let query = Query { redundancy, reference, near: Some(near), steps: 0, tolerance: 1e-9 };
        let found = kuka_lwr4::inverse_kinematics(&pose, &query).ok()?;
        let best = found.as_slice().first().filter(|s| s.position_error < 1e-6).map(|s| s.q);
        best.or_else(|| moved(q, by, |q| self.contact(q)))
    }
}

impl Body<N> for Lwr {
    fn torques(&mut self, q: &[f64; N], dq: &[f64; N], ddq: &[f64; N], _: f64) -> [f64; N] {
        kuka_lwr4::inverse_dynamics_base(q, dq, ddq, &self.beta)
    }

    // The most work: uncertain friction of all joints.
    fn turning(&self) -> [f64; N] {
        [0.1; N]
    }

    fn tool(&mut self, q: &[f64; N]) -> Tool<N> {
        self.contact(q)
    }
}

/// Conditions of a benchmark of the law.
struct Scene {
    name: &'static str,
    /// Middle of the motion, rad.
    base: [f64; N],
    /// Size of the motion, rad.
    swing: f64,
    /// Whether the force follows the displacement (a wall). Otherwise it stays below the desired
    /// one, so that the displacement runs out of reach.
    wall: bool,
    /// Interval of samples at which one is missing, and at ten times which one is discontinuous.
    missing: Option<usize>,
}

/// A regular stroke, and cases that could cost more: out of reach, an outstretched arm, an aligned
/// wrist, missing samples.
const SCENES: [Scene; 5] = {
    let bent = [0.3, 0.9, 0.2, 1.3, 0.1, -0.9, 0.4];
    let stroke = Scene { name: "along a stroke", base: bent, swing: 0.2, wall: true, missing: None };
    [
        Scene { name: "out of reach", wall: false, ..stroke },
        Scene { name: "stretched out", base: [0.3, 0.9, 0.2, 0.0, 0.1, -0.9, 0.4], swing: 1e-3, ..stroke },
        Scene { name: "wrist in line", base: [0.3, 0.9, 0.2, 1.3, 0.1, 0.0, 0.4], swing: 1e-3, ..stroke },
        Scene { name: "samples missing", missing: Some(7), ..stroke },
        stroke,
    ]
};

/// Stiffness of the wall in all scenes, N/m.
const STIFFNESS: f64 = 8e3;

/// All limits are active, and none is exceeded by the scenes.
fn limits() -> Limits<N> {
    Limits {
        position: [[-3.0, 3.0]; N],
        acceleration: [15.0; N],
        jerk: [7500.0; N],
        tool: [1.7, 13.0, 6500.0],
        force_rate: 1e3,
        torque_rate: [1e6; N],
        saturated: 1e9,
        frozen: [0.5; N],
        stuck: [1e9; 2],
    }
}

fn main() {
    let beta = std::array::from_fn(|k| 0.3 + 0.01 * k as f64);
    let settings = Settings {
        period: 1e-3,
        joints: JointLoop { kp: [500.0; N], kd: [20.0; N] },
        force: ForceSettings { kp: 1e-5, ki: 5e-3, range: [-0.02, 0.3], rate: 0.2 },
        torque: [176.0; N],
        velocity: [2.0; N],
        patience: 5,
        contact: 3.0,
        lost_after: 0.05,
        regain: 0.03,
        give_up: 1e9,
        most: 1e5,
        carry: 1.0,
        feed: 1.0,
        aside: 0.9,
        aside_pole: 20.0,
        drag: 1.0,
        corner: 10.0,
        limits: limits(),
        stop: 0.25,
    };
    let mut arguments = std::env::args().skip_while(|a| a != "--hostile").skip(1);
    if let Some(steps) = arguments.next().and_then(|a| a.parse().ok()) {
        hostile::run(Lwr { beta }, settings, steps);
        return;
    }
    // `cargo test --benches` runs a short check, not a measurement.
    let steps: usize = if std::env::args().any(|a| a == "--bench") { 1_000_000 } else { 1_000 };
    for (k, scene) in SCENES.iter().enumerate() {
        // The stroke is measured in full; the others take a tenth of its steps.
        let count = if k + 1 == SCENES.len() { steps } else { steps / 10 };
        if let Some(measured) = measure(scene, Lwr { beta }, settings, count) {
            measured.print(scene.name);
        }
    }
    let mut empty: Vec<u32> = (0..steps).map(|_| nanoseconds(thread_time().abs_diff(thread_time()))).collect();
    empty.sort_unstable();
    println!("two calls of the thread's clock: median {:.2} us", f64::from(empty[steps / 2]) * 1e-3);
}

/// Nanoseconds of each step by each clock.
struct Measured {
    times: [Vec<u32>; 3],
    preempted: usize,
    /// Number of steps in contact.
    pressing: usize,
}

impl Measured {
    fn print(self, name: &str) {
        let steps = self.times[0].len();
        println!(
            "{name}: {steps} steps, pressing in {}, preempted for 5 us or longer in {}",
            self.pressing, self.preempted
        );
        for (name, mut times) in ["wall", "thread", "best of three"].into_iter().zip(self.times) {
            times.sort_unstable();
            let at = |share: f64| f64::from(times[((steps - 1) as f64 * share) as usize]) * 1e-3;
            let [median, most, nearly, worst] = [0.5, 0.99, 0.9999, 1.0].map(at);
            println!(
                "  {name:<13}: median {median:.2} us, 99 % {most:.2} us, 99.99 % {nearly:.2} us, worst {worst:.2} us"
            );
        }
    }
}

const ESTIMATOR: EstimatorSettings<N> = EstimatorSettings {
    period: 1e-3,
    corner: 10.0,
    weights: [1.0; N],
    damping: 1e-4,
    moment: 0.87,
    turning: [0.5; N],
    rest: [1e-4; N],
};

fn measure(scene: &Scene, lwr: Lwr, settings: Settings<N>, steps: usize) -> Option<Measured> {
    let mut controller = Controller::new(lwr.clone(), settings).ok()?;
    let mut estimator = Estimator::new(lwr, ESTIMATOR);
    let mut times: [Vec<u32>; 3] = std::array::from_fn(|_| Vec::with_capacity(steps));
    let (mut sum, mut preempted, mut pressing, mut displacement) = (0.0, 0, 0, 0.0);
    for k in 0..steps {
        let t = 1e-3 * k as f64;
        let wave = |j: usize| scene.swing * (0.3 * t + j as f64).sin();
        let q: [f64; N] = std::array::from_fn(|j| scene.base[j] + wave(j));
        let tau: [f64; N] = std::array::from_fn(|j| 5.0 * wave(j + 3));
        let dq: [f64; N] = std::array::from_fn(|j| 0.3 * scene.swing * (0.3 * t + j as f64).cos());
        let target = Target {
            q,
            dq,
            ddq: std::array::from_fn(|j| -0.09 * wave(j)),
            normal: [-1.0, 0.0, 0.0],
            force: Some(30.0),
            ahead: 0.0,
        };
        let mut seen = q;
        match scene.missing {
            Some(each) if k % each == each - 1 => seen[3] = f64::NAN,
            Some(each) if k % (10 * each) == 5 => seen[2] += 1.0,
            _ => {}
        }
        let mut best = u32::MAX;
        for round in 0..3 {
            // The last round is the one that continues.
            let (mut estimator_of, mut controller_of) = (estimator.clone(), controller.clone());
            let (own, begin) = (thread_time(), Instant::now());
            let wrench = std::hint::black_box(&mut estimator_of).step(&seen, &tau);
            let force = wrench.map_or(f64::NAN, |w| -w[0]);
            let wall = if scene.wall { (STIFFNESS * displacement).max(0.0) } else { 25.0 };
            let sample = Sample { t, q: seen, force: wall + 1e-3 * force, push: [force, 1.0, 2.0] };
            let command = std::hint::black_box(&mut controller_of).step(&target, &sample);
            let (wall, own) = (nanoseconds(begin.elapsed()), nanoseconds(thread_time().saturating_sub(own)));
            best = best.min(wall);
            if round == 0 {
                times[0].push(wall);
                times[1].push(own);
                preempted += usize::from(wall > own.saturating_add(5_000));
            }
            if round == 2 {
                sum += command.torque[0];
                displacement = command.displacement;
                pressing += usize::from(command.status == Status::Pressing);
                (estimator, controller) = (estimator_of, controller_of);
            }
        }
        times[2].push(best);
    }
    std::hint::black_box(sum);
    Some(Measured { times, preempted, pressing })
}

fn nanoseconds(time: Duration) -> u32 {
    u32::try_from(time.as_nanos()).unwrap_or(u32::MAX)
}

/// Processor time of this thread; zero if the system has no such clock.
fn thread_time() -> Duration {
    #[cfg(target_os = "linux")]
    {
        use rustix::time::{ClockId, clock_gettime};
        let now = clock_gettime(ClockId::ThreadCPUTime);
        Duration::new(u64::try_from(now.tv_sec).unwrap_or(0), u32::try_from(now.tv_nsec).unwrap_or(0))
    }
    #[cfg(not(target_os = "linux"))]
    {
        Duration::ZERO
    }
}
