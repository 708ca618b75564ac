//! Each function of the generated LWR compared with the processor's limits:
//! `cargo bench --bench limits`, without any flags.
//!
//! *Ports*: the shortest time for the function's additions, multiplications and divisions without
//! dependencies. *Path*: the longest chain of dependent operations, a lower bound for any order of
//! one state's operations. Both use throughputs and latencies measured in the same run with loops
//! of independent and of dependent operations, so that no clock rate is assumed. Time is the
//! processor's, of this thread: the tenth of the samples that is fastest.

use std::hint::black_box;

use dh_codegen::arm::chain::Group;
use dh_codegen::arm::{Function, Kernel, Model};
use dh_codegen::interpret::{Batch, Interpreter};
use dh_codegen::robot::{Robot, no_files};
use dh_codegen::sym::{Kind, Operand};
use kuka_lwr4 as arm;
use kuka_lwr4::runtime::Scalar;
use kuka_lwr4::runtime::dispatch::{Level, Numbers, Set, Work, sines_and_cosines};

const N: usize = arm::DOF;
/// Number of states in an interpreted batch.
const BATCH: usize = 256;
/// Number of operations on each register of angles, in `runtime/sincos.rs`: multiplications and
/// additions.
const SINES: [f64; 2] = [26.0, 35.0];

/// Processor time of this thread, ns.
fn now() -> f64 {
    #[cfg(target_os = "linux")]
    {
        let now = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
        now.tv_sec as f64 * 1e9 + now.tv_nsec as f64
    }
    #[cfg(not(target_os = "linux"))]
    {
        static START: std::sync::LazyLock<std::time::Instant> = std::sync::LazyLock::new(std::time::Instant::now);
        START.elapsed().as_secs_f64() * 1e9
    }
}

/// Time of a call, ns.
fn time(calls: usize, mut call: impl FnMut()) -> f64 {
    let mut samples: Vec<f64> = (0..100)
        .map(|_| {
            let start = now();
            (0..calls).for_each(|_| call());
            (now() - start) / calls as f64
        })
        .collect();
    samples.sort_by(f64::total_cmp);
    samples[samples.len() / 10]
}

/// A loop of one kind of operation on registers.
#[derive(Clone, Copy)]
enum Of {
    Adds,
    Muls,
    Both,
    Divs,
    AddChain,
    MulChain,
    DivChain,
    SineChain,
}

/// A number of rounds of it.
struct Loop(Of, usize);

/// Number of registers that are independent of each other.
const APART: usize = 12;

impl Work for Loop {
    type Result = f64;

    #[inline(always)]
    fn run<S: Set>(self) -> f64 {
        let Self(which, rounds) = self;
        let number = <S::One as Scalar>::constant;
        let (small, near) = (number(black_box(1e-9)), number(black_box(1.000_000_1)));
        let mut x = [number(black_box(1.0)); APART];
        let mut angle = black_box(0.3);
        macro_rules! repeat {
            ($k:ident in $range:expr, $next:expr) => {
                for _ in 0..rounds {
                    for $k in $range {
                        x[$k] = $next;
                    }
                }
            };
        }
        match which {
            Of::Adds => repeat!(k in 0..APART, x[k] + small),
            Of::Muls => repeat!(k in 0..APART, x[k] * near),
            Of::Both => repeat!(k in 0..APART, if k % 2 == 0 { x[k] + small } else { x[k] * near }),
            Of::Divs => repeat!(k in 0..APART, x[k] / near),
            Of::AddChain => repeat!(k in 0..1, x[k] + small),
            Of::MulChain => repeat!(k in 0..1, x[k] * near),
            Of::DivChain => repeat!(k in 0..1, x[k] / near),
            Of::SineChain => {
                for _ in 0..rounds {
                    angle = sines_and_cosines::<S, N>(&[angle; N]).1[0];
                }
            }
        }
        let mut list = [0.0; 8];
        x.into_iter().fold(number(angle), |sum, x| sum + x).store(&mut list);
        list[0]
    }
}

/// Number of values in a register of a level.
struct Width;

impl Work for Width {
    type Result = usize;
    #[inline(always)]
    fn run<S: Set>(self) -> usize {
        S::One::WIDTH
    }
}

/// Nanoseconds of an operation on a register: throughputs, then latencies.
struct Machine {
    width: f64,
    add: f64,
    mul: f64,
    both: f64,
    div: f64,
    waits: [f64; 4],
}

impl Machine {
    fn measured(level: Level) -> Self {
        const ROUNDS: usize = 2000;
        let each = |of: Of, per: usize| {
            time(20, || {
                let _ = black_box(level.run(Loop(of, ROUNDS)));
            }) / (ROUNDS * per) as f64
        };
        Self {
            width: level.run(Width) as f64,
            add: each(Of::Adds, APART),
            mul: each(Of::Muls, APART),
            both: each(Of::Both, APART),
            div: each(Of::Divs, APART),
            waits: [Of::AddChain, Of::MulChain, Of::DivChain, Of::SineChain].map(|of| each(of, 1)),
        }
    }

    /// Shortest time for these numbers of operations, ns.
    fn ports(&self, muls: f64, adds: f64, divs: f64) -> f64 {
        (muls * self.mul).max(adds * self.add).max((muls + adds) * self.both) + divs * self.div
    }

    /// Time of the longest chain of a tape, ns.
    fn path(&self, kernel: &Kernel) -> f64 {
        let [add, mul, div, sine] = self.waits;
        let mut ready: Vec<f64> = Vec::with_capacity(kernel.tape.code.len());
        for step in &kernel.tape.code {
            let of = |operand: Operand| match operand {
                Operand::Temp(t) => ready[t as usize],
                Operand::Input(i) => match kernel.inputs.locate(i as usize).0 {
                    Group::Sine | Group::Cosine => sine,
                    _ => 0.0,
                },
                Operand::Constant(_) => 0.0,
            };
            let takes = match step.kind {
                Kind::Mul => mul,
                Kind::Div => div,
                Kind::Add | Kind::Sub | Kind::Neg => add,
                _ => 0.0,
            };
            let start = if step.kind.is_unary() { of(step.a) } else { of(step.a).max(of(step.b)) };
            ready.push(start + takes);
        }
        ready.into_iter().fold(0.0, f64::max)
    }
}

/// Nanoseconds of a function: for one state, and per state in a pack of eight.
fn times(function: Function) -> [f64; 2] {
    let [q, dq, ddq] = [0.7, 0.3, 0.2].map(|k| core::array::from_fn::<f64, N, _>(|i| (i as f64 + 1.0) * k));
    let eight = |x: [f64; N]| x.map(|x| core::array::from_fn::<f64, 8, _>(|l| x + 0.01 * l as f64));
    let (phi, beta) = ([0.5; arm::STANDARD], [0.5; arm::BASE]);
    let (eights, phis, betas) = ([q, dq, ddq].map(eight), [[0.5; 8]; arm::STANDARD], [[0.5; 8]; arm::BASE]);
    let [q8, dq8, ddq8] = &eights;
    macro_rules! both {
        ($name:ident, $zero:expr, $($one:expr, $eight:expr);*) => {{
            let (level, wide) = (Level::of_scalars(), Level::highest());
            let mut out = $zero;
            [
                time(1000, || {
                    let _ = black_box(arm::dispatch::$name(level, $(black_box($one)),*));
                }),
                time(200, || arm::dispatch::eight::$name(wide, $(black_box($eight),)* black_box(&mut out))) / 8.0,
            ]
        }};
    }
    match function {
        Function::BaseRegressor => both!(base_regressor, [[[0.0; 8]; arm::BASE]; N], &q, q8; &dq, dq8; &ddq, ddq8),
        Function::Regressor => both!(regressor, [[[0.0; 8]; arm::STANDARD]; N], &q, q8; &dq, dq8; &ddq, ddq8),
        Function::InverseDynamics => {
            both!(inverse_dynamics, [[0.0; 8]; N], &q, q8; &dq, dq8; &ddq, ddq8; &phi, &phis)
        }
        Function::InverseDynamicsBase => {
            both!(inverse_dynamics_base, [[0.0; 8]; N], &q, q8; &dq, dq8; &ddq, ddq8; &beta, &betas)
        }
        Function::MassMatrix => both!(mass_matrix, [[[0.0; 8]; N]; N], &q, q8; &beta, &betas),
        Function::ForwardDynamics => {
            both!(forward_dynamics, [[0.0; 8]; N], &q, q8; &dq, dq8; &ddq, ddq8; &beta, &betas)
        }
        Function::Gravity => both!(gravity, [[0.0; 8]; N], &q, q8; &beta, &betas),
        Function::Jacobian => both!(jacobian, [[[0.0; 8]; N]; 6], &q, q8),
        Function::ForwardKinematics => both!(forward_kinematics, [[[0.0; 8]; 4]; 3], &q, q8),
        other => unreachable!("{other:?} is not in the list"),
    }
}

/// Nanoseconds per state in an interpreted batch, structural zeros left out.
fn interpreted(run: &Interpreter, function: Function) -> f64 {
    let column = |k: f64| (0..N * BATCH).map(|i| (i as f64 * k).sin() * 2.0).collect::<Vec<f64>>();
    let (q, dq, ddq, tau, parameters) = (column(0.7), column(0.3), column(0.9), column(0.2), [0.5; arm::STANDARD]);
    let batch = Batch { len: BATCH, q: &q, dq: &dq, ddq: &ddq, tau: &tau, parameters: &parameters };
    let mut out = vec![0.0; run.nonzeros(function).map_or(0, <[usize]>::len) * BATCH];
    time(20, || run.run_nonzeros(function, black_box(&batch), black_box(&mut out))) / BATCH as f64
}

const FUNCTIONS: [(Function, &str); 9] = [
    (Function::BaseRegressor, "base regressor"),
    (Function::Regressor, "regressor"),
    (Function::InverseDynamicsBase, "inverse dynamics base"),
    (Function::InverseDynamics, "inverse dynamics"),
    (Function::MassMatrix, "mass matrix"),
    (Function::ForwardDynamics, "forward dynamics"),
    (Function::Gravity, "gravity"),
    (Function::Jacobian, "jacobian"),
    (Function::ForwardKinematics, "forward kinematics"),
];

fn main() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/robots/kuka-lwr4.yaml");
    let text = std::fs::read_to_string(path).expect("a robot file of the repository");
    let model = Model::new(&Robot::from_yaml(&text, &no_files).expect("a robot file without problems").robot);
    let kernels: Vec<Kernel> = FUNCTIONS.iter().map(|(function, _)| model.kernel(*function)).collect();
    let run = Interpreter::from_kernels(&model, &kernels);
    let (scalar, wide) = (Machine::measured(Level::of_scalars()), Machine::measured(Level::highest()));
    for (level, m) in [(Level::of_scalars(), &scalar), (Level::highest(), &wide)] {
        let [add, mul, div, sines] = m.waits;
        println!(
            "{level:?}, registers of {}: ns per addition {:.3}, multiplication {:.3}, either {:.3}, division {:.2}; latencies {add:.2}, {mul:.2}, {div:.2}, sines and cosines of {N} angles {sines:.1}",
            m.width, m.add, m.mul, m.both, m.div
        );
    }
    println!(
        "\n| LWR, ns | operations | ports | path | one state | / ports | / path | eight: ports | eight | ratio | interpreted |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|---|");
    for (kernel, (function, title)) in kernels.iter().zip(FUNCTIONS) {
        let count = kernel.tape.operations();
        let divs = kernel.tape.code.iter().filter(|step| step.kind == Kind::Div).count();
        let (muls, adds, divs) = ((count.mul - divs) as f64, count.add as f64, divs as f64);
        let registers = (N as f64 / scalar.width).ceil();
        let ports = scalar.ports(muls + SINES[0] * registers, adds + SINES[1] * registers, divs);
        let path = scalar.path(kernel);
        let angles = N as f64;
        let least = wide.ports(muls + SINES[0] * angles, adds + SINES[1] * angles, divs) / wide.width;
        let [one, eight] = times(function);
        let interpreted = interpreted(&run, function);
        println!(
            "| {title} | {} + {}{} | {ports:.0} | {path:.0} | {one:.0} | {:.1} | {:.1} | {least:.1} | {eight:.1} | {:.1} | {interpreted:.0} |",
            muls,
            adds,
            if divs > 0.0 { format!(" + {divs} divisions") } else { String::new() },
            one / ports,
            one / path,
            eight / least
        );
    }
}
