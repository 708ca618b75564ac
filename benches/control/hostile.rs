//! Steps with a failure half of the time: their times, and a check of the torque limits.

use std::time::Instant;

use denavit::control::law::{Command, Controller, Estimator, Fault, Limits, Model, Sample, Settings, Target, Tool};

use super::{ESTIMATOR, Lwr, N, STIFFNESS, nanoseconds};

/// Failure of a model.
#[derive(Clone, Copy, PartialEq)]
enum Failure {
    None,
    /// Gravity and torques have this value: NaN, or more than a drive could hold.
    Dumb(f64),
    /// Neither a posture nor a point of contact.
    Lost,
    /// Another branch of the inverse kinematics.
    Flipped,
}

/// A model that may fail.
#[derive(Clone)]
struct Failing {
    arm: Lwr,
    failure: Failure,
}

impl Model<N> for Failing {
    fn gravity(&mut self, q: &[f64; N]) -> [f64; N] {
        let mut gravity = self.arm.gravity(q);
        if let Failure::Dumb(by) = self.failure {
            gravity[3] *= by;
        }
        gravity
    }

    fn moving(&mut self, q: &[f64; N], dq: &[f64; N], ddq: &[f64; N]) -> [f64; N] {
        let mut moving = self.arm.moving(q, dq, ddq);
        if let Failure::Dumb(by) = self.failure {
            moving[1] *= by;
        }
        moving
    }

    fn pressing(&mut self, q: &[f64; N], along: &[f64; 3]) -> [f64; N] {
        self.arm.pressing(q, along)
    }

    fn touch(&mut self, q: &[f64; N]) -> Option<Tool<N>> {
        self.arm.touch(q).filter(|_| self.failure != Failure::Lost)
    }

    fn displaced(&mut self, q: &[f64; N], by: &[f64; 3], near: &[f64; N]) -> Option<[f64; N]> {
        let mut found = self.arm.displaced(q, by, near).filter(|_| self.failure != Failure::Lost)?;
        found[2] += if self.failure == Failure::Flipped { std::f64::consts::PI } else { 0.0 };
        Some(found)
    }
}

/// A xorshift generator of random numbers.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn one(&mut self, of: u64) -> u64 {
        (self.next() >> 11) % of
    }

    /// A random number from -1 to 1.
    fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / 2f64.powi(52) - 1.0
    }

    /// Any bits, often critical values.
    fn any(&mut self) -> f64 {
        match self.one(6) {
            0 => f64::NAN,
            1 => f64::INFINITY,
            2 => -f64::MAX,
            3 => f64::MIN_POSITIVE,
            _ => f64::from_bits(self.next()),
        }
    }
}

/// Time above which a step is repeated from the same state, ns, [`ROUNDS`] times; the fastest
/// counts as the law's own time.
const AGAIN: u32 = 20_000;
const ROUNDS: u32 = 7;

/// Counts of times: 32 buckets for each power of two of nanoseconds.
struct Histogram(Vec<u64>);

impl Histogram {
    fn add(&mut self, ns: u32) {
        self.0[Self::bucket(ns)] += 1;
    }

    fn bucket(ns: u32) -> usize {
        let power = ns.max(32).ilog2();
        ((power - 5) * 32 + (ns.max(32) >> (power - 5)) - 32) as usize
    }

    /// Upper end of a bucket, us.
    fn end(bucket: usize) -> f64 {
        let (power, part) = (bucket / 32, bucket % 32);
        ((33 + part) << power) as f64 * 1e-3
    }

    fn print(&self, name: &str, worst: u32) {
        let all: u64 = self.0.iter().sum();
        let at = |share: f64| {
            let mut left = (all as f64 * share).ceil() as u64;
            let found = self.0.iter().position(|count| {
                let reached = *count >= left;
                left = left.saturating_sub(*count);
                reached
            });
            found.map_or(f64::NAN, Self::end)
        };
        let shares = [0.5, 0.99, 0.999, 0.9999, 0.999_99, 0.999_999];
        let [median, most, nearly, few, rare, last] = shares.map(at);
        println!("  {name:<13}: median {median:.2} us, 99 % {most:.2} us, 99.9 % {nearly:.2} us, 99.99 % {few:.2} us");
        println!(
            "  {:<13}  99.999 % {rare:.2} us, 99.9999 % {last:.2} us, worst {:.2} us",
            "",
            f64::from(worst) * 1e-3
        );
        for power in 0..27_usize {
            let count: u64 = self.0[32 * power..32 * power + 32].iter().sum();
            if count > 0 {
                println!("    below {:>10.2} us: {count:>11}", f64::from(1_u32 << (power + 6).min(31)) * 1e-3);
            }
        }
    }
}

fn hurt(random: &mut Random, kind: u64, target: &mut Target<N>, sample: &mut Sample<N>, frozen: &Sample<N>) {
    let j = random.one(N as u64) as usize;
    match kind {
        0 => sample.q[j] = random.any(),
        1 => sample.t = random.any(),
        2 => sample.t += 0.02 * random.unit(),
        3 => sample.force = random.any(),
        4 => sample.push[j % 3] = random.any(),
        5 => target.q[j] = random.any(),
        6 => target.dq[j] = random.any(),
        7 => target.ddq[j] = random.any(),
        8 => target.normal[j % 3] = random.any(),
        9 => (target.force, target.ahead) = (Some(random.any()), random.any()),
        10 => sample.q = frozen.q,
        11 => sample.force = frozen.force,
        12 => *sample = *frozen,
        13 => sample.q[j] += 2.0 * random.unit(),
        14 => sample.q.iter_mut().for_each(|q| *q += 2e-3 * random.unit()),
        15 => sample.force += 60.0 * random.unit(),
        16 => target.force = None,
        17 => target.q.iter_mut().for_each(|q| *q += random.unit()),
        18 => sample.t -= 6.0,
        // Out of reach, an outstretched arm, an aligned wrist.
        19 => sample.force = 25.0 + random.unit(),
        20 => target.q[3] = 1e-3 * random.unit(),
        21 => target.q[5] = 1e-3 * random.unit(),
        // The wall is gone.
        22 => (sample.force, sample.push) = (0.1 * random.unit(), [0.0; 3]),
        // Only the model fails.
        23..=26 => {}
        _ => sample.t += 10.0,
    }
}

/// Failure of the model for each kind.
fn failure(kind: u64) -> Failure {
    match kind {
        23 => Failure::Dumb(f64::NAN),
        24 => Failure::Dumb(1e9),
        25 => Failure::Lost,
        26 => Failure::Flipped,
        _ => Failure::None,
    }
}

/// A step along a stroke on the wall, before any failure.
fn stroke(k: u64, displacement: f64, random: &mut Random) -> (Target<N>, Sample<N>, [f64; N]) {
    let t = 1e-3 * k as f64;
    let wave = |j: usize, d: u32| {
        0.2 * 0.3_f64.powi(d as i32) * (0.3 * t + j as f64 + f64::from(d) * std::f64::consts::FRAC_PI_2).sin()
    };
    let base = [0.3, 0.9, 0.2, 1.3, 0.1, -0.9, 0.4];
    let q: [f64; N] = std::array::from_fn(|j| base[j] + wave(j, 0));
    let [dq, ddq] = [1, 2].map(|d| std::array::from_fn(|j| wave(j, d)));
    let force = (STIFFNESS * displacement).max(0.0) + 1e-3 * random.unit();
    let target = Target { q, dq, ddq, normal: [-1.0, 0.0, 0.0], force: Some(30.0), ahead: 0.0 };
    let sample = Sample { t, q, force, push: [-force, 1.0, 2.0] };
    (target, sample, std::array::from_fn(|j| 25.0 * wave(j + 3, 0)))
}

/// Statistics so far.
struct Record {
    /// Times by the wall clock, and of the law itself, with the maximum of each.
    times: [(Histogram, u32); 2],
    faults: [u64; Fault::ALL.len()],
    resets: u64,
}

impl Record {
    fn print(&self, steps: u64) {
        println!("{steps} hostile steps, {} resets; faults:", self.resets);
        for (fault, count) in Fault::ALL.iter().zip(self.faults) {
            println!("  {fault:?}: {count}");
        }
        for (name, (histogram, worst)) in ["wall", "own"].into_iter().zip(&self.times) {
            histogram.print(name, *worst);
        }
    }
}

/// Prints the times at each power of ten of steps, and panics if torques exceed their limits.
pub fn run(lwr: Lwr, settings: Settings<N>, steps: u64) {
    let limits =
        Limits { torque_rate: [1e5; N], saturated: 0.1, frozen: [0.05; N], stuck: [2e-3, 0.2], ..settings.limits };
    let settings = Settings { most: 170.0, give_up: 0.5, limits, ..settings };
    let model = Failing { arm: lwr.clone(), failure: Failure::None };
    let Ok(mut controller) = Controller::new(model, settings) else { return };
    let mut estimator = Estimator::new(lwr, ESTIMATOR);
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let times = [(); 2].map(|()| (Histogram(vec![0; 32 * 27]), 0));
    let mut record = Record { times, faults: [0; Fault::ALL.len()], resets: 0 };
    let (mut kind, mut left, mut ill, mut frozen) = (0, 0, false, None);
    let mut last: Option<Command<N>> = None;
    for k in 0..steps {
        let (mut target, mut sample, mut tau) = stroke(k, last.map_or(0.0, |l| l.displacement), &mut random);
        if left == 0 {
            (kind, ill, frozen) = (random.one(28), !ill, Some(sample));
            left = 1 + if random.one(3) == 0 { random.one(1000) } else { random.one(12) };
        }
        left -= 1;
        if let (true, Some(frozen)) = (ill, &frozen) {
            hurt(&mut random, kind, &mut target, &mut sample, frozen);
            tau[0] = if kind == 4 { random.any() } else { tau[0] };
        }
        controller.model().failure = if ill { failure(kind) } else { Failure::None };
        let (was, before) = (controller.clone(), estimator.clone());
        let round = |controller: &mut Controller<Failing, N>, estimator: &mut Estimator<Lwr, N>| {
            let begin = Instant::now();
            std::hint::black_box(std::hint::black_box(estimator).step(&sample.q, &tau));
            let command = std::hint::black_box(controller).step(&target, &sample);
            (nanoseconds(begin.elapsed()), command)
        };
        let (wall, command) = round(&mut controller, &mut estimator);
        let again = (0..ROUNDS).map(|_| round(&mut was.clone(), &mut before.clone()).0);
        let own = if wall > AGAIN { again.fold(wall, u32::min) } else { wall };
        for ((histogram, worst), ns) in record.times.iter_mut().zip([wall, own]) {
            histogram.add(ns);
            *worst = ns.max(*worst);
        }
        let sound = (0..N).all(|j| command.torque[j].abs() <= settings.torque[j]);
        assert!(sound && command.displacement.is_finite(), "{command:?}");
        if let (Some(fault), None) = (command.status.fault(), last.and_then(|l| l.status.fault())) {
            record.faults[fault as usize] += 1;
        }
        last = Some(command);
        if command.status.brakes() && random.one(300) == 0 {
            controller.reset();
            (last, record.resets) = (None, record.resets + 1);
        }
        if (k + 1).ilog10() > k.max(1).ilog10() && k > 100_000 || k + 1 == steps {
            record.print(k + 1);
        }
    }
}
