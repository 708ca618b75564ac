//! The paper's equation (14) and its future work: accuracy of the estimated wrench on the tool of
//! the simulated LWR, and coverage of the 95 % bands.
//!
//! A run identifies from a noisy log and estimates from another one with a known wrench of all six
//! components. Parameters are identified again in each run, so their error, the same at all samples
//! of a run, differs between runs. A band's coverage is therefore over runs and samples.

use dh_codegen::robot::{Robot, no_files};

use super::ReproduceError;
use super::Watch;
use super::lwr::{Lwr, Unmodelled};
use super::many::many;
use crate::control::estimate::{
    Comparison, EstimationSettings, Known, Linear, Method, NoisePass, NoiseSource, Run, Series, Uncertainty,
};
use crate::data::log::{Log, Replay};
use crate::data::signal::{Prepare, each_motion};
use crate::identify::{AccumulatorSettings, Identification, IdentifySettings, QrAccumulator, recover_standard, solve};
use crate::model::Arm;
use crate::model::interpreted::Interpreted;
use crate::numerics::prng::Random;
use crate::simulate::{Control, Mode, Recording, Request, Sensors, Simulator, Trajectory};

/// Settings of the experiment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForceSettings {
    /// Number of runs for the coverage.
    pub runs: usize,
    /// Number of postures for the accuracy.
    pub postures: usize,
    /// Seed of motions, wrenches and noise.
    pub seed: u64,
}

impl Default for ForceSettings {
    fn default() -> Self {
        Self { runs: 200, postures: 40, seed: 1 }
    }
}

/// Accuracy of an estimator in one state of the arm.
#[derive(Debug, Clone, PartialEq)]
pub struct Accuracy {
    /// The estimator.
    pub method: Method,
    /// `standing`, `moving` or `near a singularity`.
    pub state: &'static str,
    /// Errors per component.
    pub components: [Comparison; 6],
}

/// Model error of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Case {
    /// A correct model; only noise.
    Right,
    /// The arm has effects that the model lacks. They are in the identification's residual too, and
    /// so in its noise.
    SeenInFit,
    /// The arm has these effects only after the identification.
    New,
    /// The file is correct and nothing else is known; the noise is estimated from the log itself.
    FileAlone,
}

impl Case {
    /// Description for reports.
    pub fn words(self) -> &'static str {
        match self {
            Self::Right => "right up to noise",
            Self::SeenInFit => "effects in both logs",
            Self::New => "effects since the identification",
            Self::FileAlone => "file is right, noise from the log",
        }
    }
}

/// Coverage of the 95 % bands over many runs.
#[derive(Debug, Clone, PartialEq)]
pub struct IntervalCoverage {
    /// Name of the robot.
    pub robot: String,
    /// The estimator.
    pub method: Method,
    /// The model error.
    pub case: Case,
    /// Number of runs.
    pub runs: usize,
    /// Number of samples over all runs.
    pub samples: usize,
    /// Share of samples whose band holds the true value, per component.
    pub components: [f64; 6],
    /// Share over all components.
    pub whole: f64,
    /// Smallest and largest share of a single run, throughout which the parameter error is the
    /// same.
    pub of_runs: [f64; 2],
    /// Mean half-width, per component, N and N m.
    pub half: [f64; 6],
    /// Root mean square error, per component, N and N m.
    pub rms: [f64; 6],
    /// Share of runs whose verdict accepts the model as accurate enough for the band to hold. Only
    /// an arm with a redundant joint can detect that it is not.
    pub found_right: f64,
}

/// Results of the experiment.
#[derive(Debug, Clone, PartialEq)]
pub struct Force {
    /// Settings used.
    pub settings: ForceSettings,
    /// Accuracy over the whole workspace.
    pub accuracy: Vec<Accuracy>,
    /// Coverage over many runs.
    pub coverage: Vec<IntervalCoverage>,
}

/// Amplitudes of the test wrench's forces and moments, N and N m; each is a sine of its own.
pub const AMPLITUDES: [f64; 6] = [30.0, 30.0, 30.0, 4.0, 4.0, 4.0];
/// Smallest singular value, m/rad, below which a posture counts as near a singularity.
pub const NEAR: f64 = 0.05;
/// Duration of a move from posture to posture, of the rest after it, and of the rest's beginning
/// that is not evaluated, s.
const MOVE: [f64; 3] = [1.5, 1.0, 0.35];

/// The robot, and the motions recorded on it.
pub struct Stage {
    lwr: Lwr,
    arm: Interpreted,
    fit: Recording,
    test: Recording,
    sensors: Sensors,
}

/// A motion through random postures within the limits, moving for `travel` s and resting for `rest`
/// s. Speeds are at most 70 % of their limits.
pub(super) fn wandering(
    lwr: &Lwr,
    random: &mut Random,
    postures: usize,
    [travel, rest]: [f64; 2],
) -> Result<Trajectory, ReproduceError> {
    let n = lwr.robot.dof();
    let limits: Vec<([f64; 2], f64)> = lwr
        .robot
        .moving()
        .into_iter()
        .map(|row| {
            let l = &lwr.robot.joints[row].limits;
            (l.position.unwrap_or([-2.0, 2.0]), l.velocity.unwrap_or(1.0))
        })
        .collect();
    let (mut t, mut at) =
        (Vec::new(), limits.iter().map(|([a, b], _)| random.uniform(0.8 * a, 0.8 * b)).collect::<Vec<_>>());
    let mut knots: Vec<Vec<f64>> = Vec::new();
    let mut now = 0.0;
    for _ in 0..postures {
        for pause in if rest > 0.0 { vec![0.0, rest] } else { vec![0.0] } {
            now += pause;
            t.push(now);
            knots.push(at.clone());
        }
        now += travel;
        for (q, ([low, high], speed)) in at.iter_mut().zip(&limits) {
            // A quintic is 15/8 as fast in the middle as on average.
            let reach = 0.7 * speed * travel * 8.0 / 15.0;
            *q = random.uniform((*q - reach).max(0.97 * low), (*q + reach).min(0.97 * high));
        }
    }
    let q: Vec<f64> = (0..n).flat_map(|j| knots.iter().map(move |k| k[j])).collect();
    let zero = (rest > 0.0).then(|| vec![0.0; q.len()]);
    Ok(Trajectory::new(n, t, q, zero.clone(), zero).map_err(crate::simulate::SimulateError::from)?)
}

impl Stage {
    /// Records a motion of `fit` postures to identify from, and one of `test` postures (with rests)
    /// under the wrench, both at `rate` Hz, each with its effects.
    pub fn new(
        seed: u64,
        rate: f64,
        fit: usize,
        test: usize,
        moves: [f64; 2],
        which: [&[Unmodelled]; 2],
    ) -> Result<Self, ReproduceError> {
        let sensors = Sensors { rate, wrench: true, ..Lwr::sensors() };
        Self::of(Lwr::new()?, sensors, seed, fit, test, moves, which)
    }

    /// The same for another robot with other sensors.
    pub fn of(
        lwr: Lwr,
        sensors: Sensors,
        seed: u64,
        fit: usize,
        test: usize,
        moves: [f64; 2],
        which: [&[Unmodelled]; 2],
    ) -> Result<Self, ReproduceError> {
        let arm = Interpreted::new(&lwr.robot, &Interpreted::BODIES);
        let mut random = Random::new(seed ^ 0xF0CE);
        let played = |which: &[Unmodelled]| -> Result<_, ReproduceError> {
            Ok(Simulator::new(&lwr.robot, &lwr.effects(which)?)?)
        };
        let request = Request {
            control: Control { mode: Mode::Exact, ..Control::default() },
            sensors: sensors.clone(),
            seed,
            ..Request::default()
        };
        let first = wandering(&lwr, &mut random, fit, [0.7, 0.0])?;
        let second = wandering(&lwr, &mut random, test, moves)?;
        let waves: [[f64; 2]; 6] =
            std::array::from_fn(|_| [random.uniform(0.1, 0.7), random.uniform(0.0, std::f64::consts::TAU)]);
        let wrench = |t: f64, pose: &[f64; 12], _: &[f64; 6]| {
            let f: [f64; 6] = std::array::from_fn(|i| {
                AMPLITUDES[i] * libm::sin(std::f64::consts::TAU * waves[i][0] * t + waves[i][1])
            });
            // From the tool's axes to the base's.
            let turned = |part: usize, i: usize| (0..3).map(|k| pose[4 * i + k] * f[3 * part + k]).sum::<f64>();
            crate::simulate::Wrench {
                wrench: std::array::from_fn(|i| turned(i / 3, i % 3)),
                ..crate::simulate::Wrench::default()
            }
        };
        let fit = played(which[0])?.run(&first, &request, &mut |_| {})?;
        let test = played(which[1])?.run_against(&second, &request, &[&wrench], &mut |_| {})?;
        Ok(Self { lwr, arm, fit, test, sensors })
    }

    /// Identifies from the first motion with the noise of this seed.
    pub fn identify(&self, seed: u64) -> Result<Identification, ReproduceError> {
        let log = self.fit.seen_by(&self.sensors, seed);
        let mut stack = QrAccumulator::new("fit", &self.arm, AccumulatorSettings::default());
        each_motion(&mut Replay::new(&log), self.arm.dof(), &Prepare::default(), |motion| stack.absorb(motion))?;
        Ok(solve(&self.arm, &[stack.finish()], &[], &IdentifySettings::default())?)
    }

    /// Estimates along the second motion with the noise of this seed.
    pub fn estimate(
        &self,
        found: &Identification,
        seed: u64,
        stride: usize,
        estimation: &EstimationSettings,
    ) -> Result<Series, ReproduceError> {
        let beta = found.values();
        let standard = recover_standard(&self.arm, &beta, Some(&self.lwr.standard))?;
        self.estimate_with(&beta, &standard, Some(Uncertainty::of(found)), seed, stride, estimation)
    }

    /// Estimates with given parameters; without an uncertainty, the noise is estimated from the
    /// log.
    fn estimate_with(
        &self,
        beta: &[f64],
        standard: &[f64],
        uncertainty: Option<Uncertainty>,
        seed: u64,
        stride: usize,
        estimation: &EstimationSettings,
    ) -> Result<Series, ReproduceError> {
        let (log, n): (Log, usize) = (self.test.seen_by(&self.sensors, seed), self.arm.dof());
        let torques = Linear::new(&self.arm, beta);
        let prepare = Prepare { raw_torque: true, margins: true, wrench: true, stride, ..Prepare::default() };
        let uncertainty = match uncertainty {
            Some(known) => known,
            None => {
                let mut pass = NoisePass::new(&self.arm, &torques, prepare.filter, &[], false);
                each_motion(&mut Replay::new(&log), n, &prepare, |motion| pass.absorb(motion))?;
                Uncertainty::noise(pass.white(), NoiseSource::Log, beta.len())
            }
        };
        let known =
            Known { arm: &self.arm, standard, torques: &torques, uncertainty: &uncertainty, torque_limits: &[] };
        let mut tool = self.arm.bodies(standard);
        let mut run = Run::new("test", known, &mut tool, estimation.clone())?;
        each_motion(&mut Replay::new(&log), n, &prepare, |motion| run.absorb(motion))?;
        Ok(run.finish())
    }
}

/// Share of samples inside their band, over all observable components.
pub fn share(all: &[Comparison; 6]) -> f64 {
    let observable: f64 = all.iter().map(|c| c.samples as f64).sum();
    all.iter().map(|c| c.inside * c.samples as f64).sum::<f64>() / observable.max(1.0)
}

/// Coverage over runs on this stage, for each method.
pub fn coverage(
    stage: &Stage,
    methods: &[Method],
    case: Case,
    runs: usize,
    seed: u64,
    watch: Watch<'_>,
) -> Result<Vec<IntervalCoverage>, ReproduceError> {
    let one = |run: usize| -> Result<Vec<Series>, ReproduceError> {
        let seed = seed.wrapping_add(2 * run as u64);
        let how = |method| EstimationSettings { method, ..EstimationSettings::default() };
        if case == Case::FileAlone {
            let Lwr { truth, standard, .. } = &stage.lwr;
            let alone = |&method| stage.estimate_with(truth, standard, None, seed + 1, 4, &how(method));
            return methods.iter().map(alone).collect();
        }
        let found = stage.identify(seed)?;
        methods.iter().map(|&method| stage.estimate(&found, seed + 1, 4, &how(method))).collect()
    };
    let all = many(runs, &one, watch)?;
    Ok(methods
        .iter()
        .enumerate()
        .map(|(m, &method)| {
            let of = |i: usize| {
                let errors = all.iter().flat_map(|run| {
                    let s = &run[m];
                    (0..s.time.len())
                        .map(move |k| (s.wrench[k][i] - s.measured[k][i], s.half[k][i], s.observable[k][i]))
                });
                Comparison::of(errors)
            };
            let components: [Comparison; 6] = std::array::from_fn(of);
            let single = |run: &Vec<Series>| run[m].against_measured().map_or(0.0, |c| share(&c));
            let shares: Vec<f64> = all.iter().map(single).collect();
            let right = all.iter().filter(|run| !run[m].verdict.is_too_wrong()).count();
            IntervalCoverage {
                robot: stage.lwr.robot.name.clone(),
                method,
                case,
                runs,
                samples: components[0].samples,
                components: components.map(|c| c.inside),
                whole: share(&components),
                of_runs: [shares.iter().copied().fold(1.0, f64::min), shares.iter().copied().fold(0.0, f64::max)],
                half: components.map(|c| c.half),
                rms: components.map(|c| c.rms),
                found_right: right as f64 / runs.max(1) as f64,
            }
        })
        .collect())
}

/// Accuracy over the workspace: postures anywhere within the limits, with a move and a rest for
/// each.
pub fn accuracy(postures: usize, seed: u64, watch: Watch<'_>) -> Result<Vec<Accuracy>, ReproduceError> {
    let stage = Stage::new(seed, 250.0, 30, postures, [MOVE[0], MOVE[1]], [&[]; 2])?;
    let found = stage.identify(seed)?;
    let mut rows = Vec::new();
    for (k, (name, method)) in Method::ALL.into_iter().enumerate() {
        watch(&format!("workspace, {name}"), k as f64 / Method::ALL.len() as f64);
        let s = stage.estimate(&found, seed + 1, 5, &EstimationSettings { method, ..EstimationSettings::default() })?;
        let standing =
            |k: usize| (s.time[k] % (MOVE[0] + MOVE[1])) > MOVE[2] && (s.time[k] % (MOVE[0] + MOVE[1])) < MOVE[1];
        let moving = |k: usize| (s.time[k] % (MOVE[0] + MOVE[1])) > MOVE[1];
        let near = |k: usize| s.dexterity[k] < NEAR;
        let states: [(&'static str, &dyn Fn(usize) -> bool); 3] = [
            ("standing", &|k| standing(k) && !near(k)),
            ("moving", &|k| moving(k) && !near(k)),
            ("near a singularity", &near),
        ];
        for (state, belongs) in states {
            let picked: Vec<usize> = (0..s.time.len()).filter(|&k| belongs(k)).collect();
            let of = |i: usize| {
                Comparison::of(
                    picked.iter().map(|&k| (s.wrench[k][i] - s.measured[k][i], s.half[k][i], s.observable[k][i])),
                )
            };
            rows.push(Accuracy { method, state, components: std::array::from_fn(of) });
        }
    }
    Ok(rows)
}

/// Estimators whose bands are tested.
const BANDS: [Method; 3] = [Method::Residual, Method::Momentum, Method::Kalman];

/// Arms with the link parameters of these files and less noisy torque sensors, N m: with heavy
/// links the encoders' noise matters.
const ALONE: [(&str, &str, f64); 2] = [
    ("ur10e.yaml", include_str!("../../../robots/ur10e.yaml"), 0.05),
    ("franka-panda.yaml", include_str!("../../../robots/franka-panda.yaml"), 0.1),
];

/// Stages for [`Case::FileAlone`].
pub fn alone(seed: u64) -> Result<Vec<Stage>, ReproduceError> {
    let stage = |(name, text, noise): (&str, &str, f64)| {
        let read = Robot::from_yaml(text, &no_files);
        let mut robot = read.map_err(ReproduceError::in_file(name))?.robot;
        robot.tool = None;
        let sensors = Sensors { rate: 100.0, wrench: true, torque_noise: vec![noise], ..Sensors::default() };
        Stage::of(Lwr::of(robot)?, sensors, seed, 4, 12, [0.7, 0.0], [&[]; 2])
    };
    ALONE.into_iter().map(stage).collect()
}

/// Runs the experiment, in about a minute; `watch` receives the progress.
pub fn force(settings: &ForceSettings, watch: Watch<'_>) -> Result<Force, ReproduceError> {
    let ForceSettings { runs, postures, seed } = *settings;
    let accuracy = accuracy(postures, seed, &|what, share| watch(what, 0.2 * share))?;
    let mut all = Vec::new();
    if runs > 0 {
        let right = Stage::new(seed, 100.0, 30, 12, [0.7, 0.0], [&[]; 2])?;
        all.extend(coverage(&right, &BANDS, Case::Right, runs, seed.wrapping_mul(1_000_003), &|what, share| {
            watch(what, 0.2 + 0.6 * share);
        })?);
        // The model always lacks the effects; the identification's log has them, or not.
        for (k, which) in [[&Unmodelled::ALL[..]; 2], [&[], &Unmodelled::ALL]].into_iter().enumerate() {
            let wrong = Stage::new(seed, 100.0, 30, 12, [0.7, 0.0], which)?;
            let (few, from) = (runs.div_ceil(5), 0.8 + 0.1 * k as f64);
            let case = if k == 0 { Case::SeenInFit } else { Case::New };
            all.extend(coverage(&wrong, &BANDS[..1], case, few, seed.wrapping_mul(1_000_003), &|what, share| {
                watch(what, from + 0.1 * share);
            })?);
        }
    }
    if runs > 0 {
        let few = runs.div_ceil(5);
        for stage in alone(seed)? {
            all.extend(coverage(&stage, &BANDS[..2], Case::FileAlone, few, seed.wrapping_mul(1_000_003), &|_, _| {})?);
        }
    }
    Ok(Force { settings: *settings, accuracy, coverage: all })
}
