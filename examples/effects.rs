//! Draws the signature of every effect at its default size, on joint 4 of the KUKA LWR:
//! `docs/effects/*.svg`.
//!
//! `cargo run --release --example effects`

use std::fmt::Write as _;
use std::path::Path;

use denavit::robot::effects::ExternalContact;
use denavit::robot::{EffectKind, JointKind, Robot};
use denavit::simulate::{Control, Effect, Effects, Mode, Recording, Request, Sensors, Simulator, Trajectory};

type Problem = Box<dyn std::error::Error>;

/// The joint with the effect, from 0.
const J: usize = 3;

fn main() -> Result<(), Problem> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let robot = Robot::open(root.join("robots/kuka-lwr4.yaml"))?;
    let folder = root.join("docs/effects");
    std::fs::create_dir_all(&folder)?;
    let motion = motion(robot.dof(), 1.0, 12.0)?;
    let plain = Simulator::new(&robot, &Effects::default())?.run(&motion, &exact(), &mut |_| {})?;
    for &kind in EffectKind::ALL {
        let picture = picture(&robot, kind, &motion, &plain)?;
        std::fs::write(folder.join(format!("{kind}.svg")), picture.svg(kind.name()))?;
    }
    Ok(())
}

fn exact() -> Request {
    Request {
        control: Control { mode: Mode::Exact, ..Control::default() },
        sensors: Sensors::perfect(200.0),
        ..Request::default()
    }
}

/// Sums of sines that begin and end at rest.
fn motion(dof: usize, size: f64, seconds: f64) -> Result<Trajectory, Problem> {
    let t: Vec<f64> = (0..=(seconds * 100.0) as usize).map(|k| k as f64 * 0.01).collect();
    let q = (0..dof).flat_map(|j| {
        let (a, b) = (0.13 + 0.04 * j as f64, 0.41 - 0.03 * j as f64);
        t.iter().map(move |&t| {
            let window = (std::f64::consts::PI * t / seconds).sin().powi(2);
            let turn = std::f64::consts::TAU * t;
            size * window * ((a * turn + j as f64).sin() + 0.5 * (b * turn + 2.0 * j as f64).sin())
        })
    });
    let q = q.collect();
    Ok(Trajectory::new(dof, t, q, None, None)?)
}

/// Curves of one picture.
struct Picture {
    x: &'static str,
    y: &'static str,
    /// Reference curve, drawn in grey.
    reference: Vec<[f64; 2]>,
    curve: Vec<[f64; 2]>,
}

fn picture(robot: &Robot, kind: EffectKind, motion: &Trajectory, plain: &Recording) -> Result<Picture, Problem> {
    let keys: &[(&str, f64)] = if kind == EffectKind::GearCoupling { &[("joint", 6.0)] } else { &[] };
    let (name, effect) = (kind.name(), Effect::of_kind(kind, keys)?);
    let mut effects = Effects::default();
    if kind.description().scope.at_joint() {
        effects.joints.push((J, effect));
    } else {
        effects.robot.push(effect);
    }
    if name == "presliding_hysteresis" {
        return presliding(robot, &effects);
    }
    if name == "joint_elasticity" || name == "backlash" {
        return soft(robot, &effects, name);
    }
    // A joint's sensors do not affect the motion itself; the file's own friction would only blur
    // the rest.
    let seen = Simulator::new(robot, &effects)?.run(motion, &exact(), &mut |_| {})?;
    let (len, truth) = (seen.truth.t.len(), &seen.truth);
    let of = |values: &[f64], k: usize| values[J * len + k];
    let tau = |recording: &Recording, k: usize| {
        recording.log.joint(denavit::data::log::Quantity::Tau, J).map_or(0.0, |column| column[k])
    };
    let added = |k: usize| tau(&seen, k) - tau(plain, k);
    let pairs = |x: &dyn Fn(usize) -> f64, y: &dyn Fn(usize) -> f64| (0..len).map(|k| [x(k), y(k)]).collect::<Vec<_>>();
    let v = |k: usize| of(&truth.motor_dq, k);
    let t = |k: usize| truth.t[k];
    let q = |k: usize| of(&truth.motor_q, k);
    const ADDED: &str = "added torque (N m)";
    const SPEED: &str = "velocity (rad/s)";
    Ok(match name {
        "friction_drift" => {
            let seen = |k: usize| (tau(&seen, k) - of(&truth.link_torque, k)).abs();
            let usual = |k: usize| (tau(plain, k) - of(&truth.link_torque, k)).abs();
            Picture {
                x: "time (s)",
                y: "friction (N m); grey: warm",
                reference: pairs(&t, &usual),
                curve: pairs(&t, &seen),
            }
        }
        "load_dependent_friction" => Picture {
            x: "load (N m)",
            y: ADDED,
            reference: vec![],
            curve: pairs(&|k| of(&truth.link_torque, k), &added),
        },
        "position_dependent_friction" => {
            let curve = pairs(&q, &|k| added(k) * v(k).signum()).into_iter().enumerate();
            let curve = curve.filter(|(k, _)| v(*k).abs() > 0.1).map(|(_, p)| p).collect();
            Picture { x: "angle (rad)", y: "added level (N m)", reference: vec![], curve }
        }
        "torque_ripple" | "joint_spring" => {
            Picture { x: "angle (rad)", y: ADDED, reference: vec![], curve: pairs(&q, &added) }
        }
        "rotor_inertia" => {
            let a = |k: usize| truth.desired[J * len + k][2];
            Picture { x: "acceleration (rad/s^2)", y: ADDED, reference: vec![], curve: pairs(&a, &added) }
        }
        "torque_gain_error" | "torque_offset" => {
            let right = |k: usize| tau(plain, k);
            Picture {
                x: "true torque (N m)",
                y: "measured (N m)",
                reference: pairs(&right, &right),
                curve: pairs(&right, &|k| tau(&seen, k)),
            }
        }
        "torque_saturation" => Picture {
            x: "time (s)",
            y: "torque (N m)",
            reference: pairs(&t, &|k| tau(plain, k)),
            curve: pairs(&t, &|k| tau(&seen, k)),
        },
        "time_delay" => {
            let near = |p: Vec<[f64; 2]>| p.into_iter().filter(|[t, _]| (4.85..5.0).contains(t)).collect();
            Picture {
                x: "time (s)",
                y: "torque (N m)",
                reference: near(pairs(&t, &|k| tau(plain, k))),
                curve: near(pairs(&t, &|k| tau(&seen, k))),
            }
        }
        "gear_coupling" => {
            let other = |k: usize| truth.motor_dq[5 * len + k];
            Picture {
                x: "velocity of motor and other joint (rad/s)",
                y: ADDED,
                reference: vec![],
                curve: pairs(&|k| v(k) + other(k), &added),
            }
        }
        "encoder_offset" | "geometric_error" | "link_inertia_error" | "payload" | "base_tilt" | "external_contact" => {
            Picture { x: "time (s)", y: ADDED, reference: vec![], curve: pairs(&t, &added) }
        }
        _ => {
            // Sorted by velocity to give a curve; the instants at rest are left out.
            let mut curve = pairs(&v, &added);
            curve.sort_by(|a, b| a[0].total_cmp(&b[0]));
            if name == "stribeck_friction" {
                curve.retain(|p| p[0].abs() < 0.3);
            }
            Picture { x: SPEED, y: ADDED, reference: vec![], curve }
        }
    })
}

/// Slow strokes of decreasing size.
fn presliding(robot: &Robot, effects: &Effects) -> Result<Picture, Problem> {
    let n = robot.dof();
    let t: Vec<f64> = (0..=4000).map(|k| f64::from(k) * 0.01).collect();
    let stroke = |t: f64| 0.02 * (1.0 - t / 42.0) * (std::f64::consts::TAU * t / 8.0).sin();
    let q = (0..n).flat_map(|j| t.iter().map(move |&t| if j == J { stroke(t) } else { 0.0 })).collect();
    let motion = Trajectory::new(n, t, q, None, None)?;
    let seen = Simulator::new(robot, effects)?.run(&motion, &exact(), &mut |_| {})?;
    let plain = Simulator::new(robot, &Effects::default())?.run(&motion, &exact(), &mut |_| {})?;
    let len = seen.truth.t.len();
    let at = |k: usize| J * len + k;
    let curve = (0..len)
        .step_by(4)
        .map(|k| [1e3 * seen.truth.motor_q[at(k)], seen.truth.motor_torque[at(k)] - plain.truth.motor_torque[at(k)]]);
    Ok(Picture { x: "angle (mrad)", y: "added torque (N m)", reference: vec![], curve: curve.collect() })
}

/// A joint that is pushed and released: its oscillation, and the deflection between motor and link
/// over the load.
fn soft(robot: &Robot, effects: &Effects, name: &str) -> Result<Picture, Problem> {
    let mut robot = robot.clone();
    let n = robot.dof();
    for joint in robot.joints.iter_mut().filter(|j| j.kind != JointKind::Fixed) {
        joint.drive.coulomb_friction = None;
    }
    let ringing = name == "joint_elasticity";
    let seconds = if ringing { 1.0 } else { 12.0 };
    let path = if ringing {
        Trajectory::rest(&[0.0, 0.5, 0.0, 1.0, 0.0, 0.0, 0.0], seconds)?
    } else {
        motion(n, 1.0, seconds)?
    };
    let mut effects = effects.clone();
    if ringing {
        let (start, end) = (Some(0.05), Some(0.25));
        let push = ExternalContact { start, end, fx: Some(40.0), ..ExternalContact::default() };
        effects.robot.push(push.into());
    }
    let mut request = Request { sensors: Sensors::perfect(if ringing { 500.0 } else { 100.0 }), ..Request::default() };
    if ringing {
        // A stiff loop holds the motor; a soft one would absorb the oscillation's energy.
        request.control.bandwidth = 400.0;
    }
    let seen = Simulator::new(&robot, &effects)?.run(&path, &request, &mut |_| {})?;
    let len = seen.truth.t.len();
    let at = |k: usize| J * len + k;
    let gap = |k: usize| 1e3 * (seen.truth.motor_q[at(k)] - seen.truth.link_q[at(k)]);
    let curve: Vec<[f64; 2]> = if ringing {
        (0..len).map(|k| [seen.truth.t[k], gap(k)]).collect()
    } else {
        (0..len).map(|k| [seen.truth.link_torque[at(k)], gap(k)]).collect()
    };
    let x = if ringing { "time (s); pushed from 0.05 to 0.25 s" } else { "load (N m)" };
    Ok(Picture { x, y: "motor before link (mrad)", reference: vec![], curve })
}

impl Picture {
    /// An SVG of 320 by 200: a frame with its extremes as labels.
    fn svg(&self, title: &str) -> String {
        let (left, right, top, bottom) = (46.0, 312.0, 20.0, 164.0);
        let all = || self.curve.iter().chain(&self.reference);
        let range = |i: usize| {
            let (low, high) = all().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| (l.min(p[i]), h.max(p[i])));
            let room = 0.05 * (high - low).max(1e-9);
            (low - room, high + room)
        };
        let ((x0, x1), (y0, y1)) = (range(0), range(1));
        let place = |[x, y]: [f64; 2]| {
            (left + (x - x0) / (x1 - x0) * (right - left), bottom - (y - y0) / (y1 - y0) * (bottom - top))
        };
        let mut out = String::from(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 320 200\" width=\"320\" height=\"200\" \
             font-family=\"sans-serif\" font-size=\"10\" fill=\"#333\">\n<rect width=\"320\" height=\"200\" fill=\"#fff\"/>\n",
        );
        let _ = writeln!(out, "<text x=\"{left}\" y=\"13\" font-weight=\"bold\">{title}</text>");
        let _ = writeln!(
            out,
            "<rect x=\"{left}\" y=\"{top}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#999\"/>",
            right - left,
            bottom - top
        );
        for (is_x, low, high) in [(true, x0, x1), (false, y0, y1)] {
            for value in ticks(low, high) {
                let (px, py) = place(if is_x { [value, y0] } else { [x0, value] });
                let label = format!("{value:.6}").trim_end_matches('0').trim_end_matches('.').to_string();
                let label = if label == "-0" { "0".to_string() } else { label };
                let _ = if is_x {
                    writeln!(
                        out,
                        "<path d=\"M{px:.1} {top}V{bottom}\" stroke=\"#eee\"/><text x=\"{px:.1}\" y=\"176\" text-anchor=\"middle\">{label}</text>"
                    )
                } else {
                    writeln!(
                        out,
                        "<path d=\"M{left} {py:.1}H{right}\" stroke=\"#eee\"/><text x=\"42\" y=\"{:.1}\" text-anchor=\"end\">{label}</text>",
                        py + 3.0
                    )
                };
            }
        }
        let _ = writeln!(out, "<text x=\"179\" y=\"192\" text-anchor=\"middle\">{}</text>", self.x);
        let _ =
            writeln!(out, "<text transform=\"translate(10 92) rotate(-90)\" text-anchor=\"middle\">{}</text>", self.y);
        for (points, color) in [(&self.reference, "#aaa"), (&self.curve, "#06c")] {
            if points.is_empty() {
                continue;
            }
            let every = points.len().div_ceil(700);
            let line: Vec<String> = points
                .iter()
                .step_by(every)
                .map(|&p| {
                    let (x, y) = place(p);
                    format!("{x:.1},{y:.1}")
                })
                .collect();
            let _ = writeln!(
                out,
                "<polyline points=\"{}\" fill=\"none\" stroke=\"{color}\" stroke-linejoin=\"round\"/>",
                line.join(" ")
            );
        }
        out + "</svg>\n"
    }
}

/// Round values inside the range, about four.
fn ticks(low: f64, high: f64) -> Vec<f64> {
    let rough = (high - low) / 4.0;
    let power = 10f64.powf(rough.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].map(|m| m * power).into_iter().find(|s| *s >= rough).unwrap_or(rough);
    let first = (low / step).ceil() as i64;
    (first..).map(|k| k as f64 * step).take_while(|v| *v <= high).collect()
}
