//! Contents of the windows against the motion's analytic form, the textbook arm's torques and sums
//! by hand.

use super::columns::{PERIOD, recording};
use super::mechanisms::planar;
use crate::diagnose::fit::model::Chosen;
use crate::diagnose::fit::moments::Moments;
use crate::diagnose::fit::regulariser::Regulariser;
use crate::diagnose::hypotheses::{hypothesis, laws};
use crate::diagnose::search::alone::is_an_error_of_contact;
use crate::diagnose::windows::windowed_data::{BLOCKS, Column, WindowedData, dead_zones};
use crate::model::perturbable_robot::PerturbableRobot;
use crate::model::{Change, Contact, PerturbableArm};
use crate::numerics::prng::Random;
use dh_codegen::robot::{EffectKind, Robot};
use nalgebra::{DMatrix, DVector};

/// Lengths of the links, m; acceleration of gravity, m/s^2.
const L1: f64 = 0.5;
const L2: f64 = 0.4;
const G: f64 = 9.81;

/// Angles of both joints, rad, and the velocity of the first, rad/s, at a time.
fn motion(t: f64) -> ([f64; 2], f64) {
    let first = 0.8 * (2.3 * t).sin();
    ([first, 0.5 * first], 0.8 * 2.3 * (2.3 * t).cos())
}

fn windows<'a>(
    plant: &'a PerturbableRobot,
    recordings: &'a [crate::diagnose::Recording],
    delay: f64,
) -> WindowedData<'a> {
    WindowedData::new(plant, recordings, 1.0 / PERIOD, &[delay; 2], false)
}

/// A motion followed by a rest is split within the motion; one without a rest, by its time.
#[test]
fn the_part_kept_out_moves() {
    let [first, rest] = recording().split(0.7);
    let [whole, kept] = [&recording(), &first].map(|r| r.stretches[0].states.len);
    assert_eq!(kept, (0.7 * whole as f64).round() as usize);
    assert_eq!(rest.stretches[0].states.len, whole - kept);
    // Both joints stand from a fifth of the time on.
    let mut log = recording();
    let moves = whole / 5;
    for j in 0..2 {
        log.stretches[0].states.dq[j * whole + moves..(j + 1) * whole].fill(0.0);
    }
    let [first, rest] = log.split(0.7);
    let kept = first.stretches[0].states.len;
    assert!((moves / 2..moves).contains(&kept), "{kept} of {moves}");
    let path = |log: &crate::diagnose::Recording| log.stretches[0].states.dq.iter().map(|v| v.abs()).sum::<f64>();
    let share = path(&first) / (path(&first) + path(&rest));
    assert!((share - 0.7).abs() < 0.01, "{share}");
}

/// A torque with a delay of 0.1 s belongs to the motion of 0.1 s before: positions, times, and
/// whether the joint stuck then.
#[test]
fn a_late_torque_goes_with_the_motion_before() {
    let plant = PerturbableRobot::new(&planar());
    let mut recordings = [recording()];
    let len = recordings[0].stretches[0].states.len;
    let sticks = |t: f64| (2.9999..3.5001).contains(&t);
    recordings[0].stretches[0].stuck = (0..2 * len).map(|k| sticks((k % len) as f64 * PERIOD)).collect();
    let delay = 0.1;
    let scene = windows(&plant, &recordings, delay);
    let own = &scene.own[0][0];
    let states = &scene.states[scene.state_of_joint[0]];
    let mut stuck = 0;
    for w in 0..scene.len {
        let then = scene.time[w] - delay;
        let (q, v) = motion(then);
        assert!((own.t(w) - then).abs() < 1e-9, "{w}: {} {then}", own.t(w));
        assert!((own.q[w] - q[0]).abs() < 1e-6 && (states.q[w] - q[0]).abs() < 1e-6, "{w}: {} {}", own.q[w], q[0]);
        assert!((states.q[scene.len + w] - q[1]).abs() < 1e-6, "{w}");
        if v.abs() > 0.05 {
            assert_eq!(own.moves[w], !sticks(then), "{w} {then}");
            stuck += usize::from(sticks(then));
        }
    }
    assert!(stuck > 80, "{stuck}");
}

/// Three standard deviations of the velocity, or a hundredth of the fastest: 1.84 and 0.92 rad/s.
#[test]
fn a_velocity_within_its_noise_has_no_sign() {
    let mut recordings = [recording()];
    let zone = |noise: f64, recordings: &mut [crate::diagnose::Recording; 1]| {
        recordings[0].stretches[0].velocity_noise = vec![noise; 2];
        dead_zones(recordings, 2)
    };
    let quiet = zone(1e-6, &mut recordings);
    assert!((quiet[0].0 - 0.0184).abs() < 1e-12 && (quiet[1].0 - 0.0092).abs() < 1e-12, "{quiet:?}");
    let noisy = zone(0.05, &mut recordings);
    assert!(noisy.iter().all(|(zone, stands)| (zone - 0.15).abs() < 1e-12 && !stands), "{noisy:?}");
    // Three standard deviations of noise exceed the joint's speed: it is at rest.
    let all = zone(0.7, &mut recordings);
    assert!(all.iter().all(|(zone, stands)| (zone - 2.1).abs() < 1e-12 && *stands), "{all:?}");
}

/// Rotating the base about its z is the first joint's offset. On the textbook arm only gravity
/// depends on it: `-G ((L1^2 / 2 + L2 L1) sin q1 + L2^2 / 2 sin(q1 + q2))` on the first joint, the
/// last term alone on the second.
#[test]
fn a_change_of_the_arm_by_its_size() {
    let plant = PerturbableRobot::new(&planar());
    let recordings = [recording()];
    let scene = windows(&plant, &recordings, 0.0);
    let standard = plant.given().unwrap().to_vec();
    for scale in [1e-5, -1e-5] {
        let change = Change::Row { row: 0, alpha: 0.0, d: 0.0, theta: scale, r: 0.0 };
        let found = scene.changed(&change, &standard, scale);
        for w in 0..scene.len {
            let ([q1, q2], _) = motion(scene.time[w]);
            let elbow = -G * 0.5 * L2 * L2 * (q1 + q2).sin();
            let shoulder = elbow - G * (0.5 * L1 * L1 + L2 * L1) * q1.sin();
            assert!((found[0][w] - shoulder).abs() < 1e-4, "{w}: {} {shoulder}", found[0][w]);
            assert!((found[1][w] - elbow).abs() < 1e-4, "{w}: {} {elbow}", found[1][w]);
        }
    }
}

/// The motors supply the power of a wrench on the tool: of a force by its levers about shoulder and
/// elbow, of a moment about z on both. In the axes of the tool the first lever turns with the
/// elbow.
#[test]
fn a_push_takes_what_its_lever_says() {
    let plant = PerturbableRobot::new(&planar());
    let recordings = [recording()];
    let scene = windows(&plant, &recordings, 0.0);
    let span = 200..600;
    let ends = [span.start, span.end].map(|w| w as f64 * scene.step);
    for base in [0.0, 1.0] {
        let terms = hypothesis(EffectKind::ExternalContact).terms(&scene, &[], &[ends[0], ends[1], base, 1.0, 0.0]);
        assert_eq!(terms.len(), 3);
        for w in 0..scene.len {
            let ([q1, q2], _) = motion(scene.time[w]);
            let tip = [-(q1 + q2).sin() * L2, (q1 + q2).cos() * L2];
            let [x, y] = if base == 1.0 {
                [[tip[0] - L1 * q1.sin(), tip[0]], [tip[1] + L1 * q1.cos(), tip[1]]]
            } else {
                [[L1 * q2.sin(), 0.0], [L1 * q2.cos() + L2, L2]]
            };
            for (term, by) in [x, y, [1.0, 1.0]].into_iter().enumerate() {
                for (j, by) in by.into_iter().enumerate() {
                    let acts = span.contains(&w) && scene.live[j][w];
                    let wanted = if acts { -by } else { 0.0 };
                    let row = terms[term].column.rows.iter().find(|(row, _)| *row == j);
                    let value = row.map_or(0.0, |(_, series)| series[w]);
                    assert!((value - wanted).abs() < 1e-9, "{base} {term} {j} {w}: {value} {wanted}");
                }
            }
        }
    }
}

/// Wrenches of any windows, from the cache or not, are those of the arm in them. 1140 windows are
/// cached in two parts.
#[test]
fn wrenches_are_those_of_each_window() {
    let plant = PerturbableRobot::new(&planar());
    let recordings = [recording()];
    let scene = windows(&plant, &recordings, 0.0);
    for span in [1000..1060, 0..scene.len, 1139..1140, 600..600] {
        for (link, in_base) in [(None, true), (None, false), (Some(0), true)] {
            let contact = Contact { link, in_base };
            let found = scene.wrenches(span.clone(), contact);
            assert_eq!(found, scene.wrenches(span.clone(), contact));
            let mut direct = vec![0.0; found.len()];
            plant.wrench_columns(&scene.states[0].part(span.start, span.end), contact, &mut direct);
            assert_eq!(found, direct, "{span:?} {contact:?}");
        }
    }
}

/// A force on link 1 acts at the elbow: the shoulder alone carries it.
#[test]
fn a_push_on_a_link_takes_what_its_lever_says() {
    let plant = PerturbableRobot::new(&planar());
    let recordings = [recording()];
    let scene = windows(&plant, &recordings, 0.0);
    let on_link = laws(EffectKind::ExternalContact).nth(1).unwrap();
    let ends = [200.0, 600.0].map(|w| w * scene.step);
    let terms = on_link.terms(&scene, &[], &[ends[0], ends[1], 1.0, 1.0, 0.0]);
    assert_eq!(terms.len(), 2);
    for w in 200..600 {
        let ([q1, _], _) = motion(scene.time[w]);
        for (term, lever) in terms.iter().zip([-L1 * q1.sin(), L1 * q1.cos()]) {
            let [(0, series)] = &term.column.rows[..] else { panic!("{:?}", term.column.rows.len()) };
            assert!((series[w] + lever).abs() < 1e-9 || !scene.live[0][w], "{w}: {} {lever}", series[w]);
        }
    }
    // The elbow is carried by one joint, and the last link is the tool: no link of this arm is tried.
    let residual = vec![vec![1.0; scene.len]; 2];
    assert!(on_link.grid(&scene, &[], &residual).is_empty());
}

/// An error with a period longer than the travel has its largest power at the lowest order: that is no
/// peak.
#[test]
fn an_order_at_the_end_of_the_range_is_no_peak() {
    let plant = PerturbableRobot::new(&planar());
    let recordings = [recording()];
    let scene = windows(&plant, &recordings, 0.0);
    let ripple = hypothesis(EffectKind::TorqueRipple);
    let [low, high] = scene.travel[0];
    let first = (9.5 / (high - low)).max(1.0);
    let orders = |order: f64| {
        let series = scene.own_series(0, |own| own.q.iter().map(|q| (order * q).cos()).collect());
        ripple.grid(&scene, &[0], &[series, vec![0.0; scene.len]])
    };
    let has = |grid: Vec<Vec<f64>>, order: f64, within: f64| grid.iter().any(|s| (s[0] / order - 1.0).abs() < within);
    assert!(!has(orders(0.5 * first), first, 1e-9));
    assert!(has(orders(2.5 * first), 2.5 * first, 0.02));
}

/// A push that swells is a constant one times a squared sine.
#[test]
fn a_push_swells_and_falls() {
    let plant = PerturbableRobot::new(&planar());
    let recordings = [recording()];
    let scene = windows(&plant, &recordings, 0.0);
    let push = hypothesis(EffectKind::ExternalContact);
    let ends = [200.0, 600.0].map(|w| w * scene.step);
    let of = |swell: f64| push.terms(&scene, &[], &[ends[0], ends[1], 1.0, 0.0, swell]);
    assert!(of(0.0).len() == 2 && of(1.0).len() == 2);
    for (constant, swelling) in of(0.0).iter().zip(&of(1.0)) {
        for ((j, one), (k, other)) in constant.column.rows.iter().zip(&swelling.column.rows) {
            assert_eq!(j, k);
            for w in 0..scene.len {
                let share = (std::f64::consts::PI * (w as f64 + 0.5 - 200.0) / 400.0).sin().powi(2);
                assert!((other[w] - share * one[w]).abs() < 1e-9, "{w}: {} {}", other[w], one[w]);
            }
        }
    }
}

/// Noise, and a force in the axes of the base for 117 of 1140 windows. This is one of the lengths
/// that are tried (50, then repeatedly a third more), at one of the starts (every 14 windows).
/// Noise of three times the amplitude is not a push.
#[test]
fn a_weak_push_is_looked_for_where_it_is() {
    // Without a tool it acts at the elbow, on the first joint alone.
    let plant = PerturbableRobot::new(&Robot { tool: None, ..planar() });
    let recordings = [recording()];
    let scene = windows(&plant, &recordings, 0.0);
    assert_eq!(scene.len, 1140);
    let (pushed, loud) = (602..719, 150..250);
    let push = hypothesis(EffectKind::ExternalContact);
    let ends = [pushed.start, pushed.end].map(|w| w as f64 * scene.step);
    let terms = push.terms(&scene, &[], &[ends[0], ends[1], 1.0, 0.0, 0.0]);
    assert_eq!(terms.len(), 2);
    let noise = |w: usize| [1.0, -1.0][w % 2] * if loud.contains(&w) { 3.0 } else { 1.0 };
    let mut residual = vec![(0..scene.len).map(noise).collect::<Vec<f64>>(); 2];
    for (term, force) in terms.iter().zip([2.0, -2.5]) {
        for (j, column) in &term.column.rows {
            residual[*j].iter_mut().zip(column.iter()).for_each(|(e, c)| *e += force * c);
        }
    }
    let grid = push.grid(&scene, &[], &residual);
    let [start, end] = [0, 1].map(|k| (grid[0][k] / scene.step).round() as usize);
    assert_eq!([start, end], [pushed.start, pushed.end]);
    assert_eq!([&grid[0][2..], &grid[1][2..]], [[1.0, 0.0, 0.0], [1.0, 1.0, 0.0]]);
    // A push does not continue in the next recording.
    let mut two = [recording(), recording()];
    two[1].begin += 100.0;
    let scene = windows(&plant, &two, 0.0);
    let [across, inside] = [1100..1180, 1000..1080].map(|w| [w.start, w.end].map(|w| w as f64 * scene.step));
    assert_eq!(scene.len, 2 * 1140);
    assert!(!push.shows(&scene, &[], &[across[0], across[1], 1.0, 0.0, 0.0]));
    assert!(push.shows(&scene, &[], &[inside[0], inside[1], 1.0, 0.0, 0.0]));
}

/// A wall that the tip of the arm reaches: the candidate directions contain its normal. Its torques
/// are the derivatives of `k depth^2 / 2`.
#[test]
fn a_wall_is_looked_for_where_it_is() {
    let plant = PerturbableRobot::new(&planar());
    let recordings = [recording()];
    let scene = windows(&plant, &recordings, 0.0);
    let wall = laws(EffectKind::ExternalContact).find(|law| !law.local()).unwrap();
    let (low, high) =
        scene.tool_positions()[..scene.len].iter().fold((f64::MAX, f64::MIN), |(l, h), x| (l.min(*x), h.max(*x)));
    let at = low + 0.3 * (high - low);
    // Number 21 of the directions, counted by x, y, z from -1 to 1, is (1, 0, 0).
    let shape = [21.0, 0.0, 0.0, at, 0.0, 0.0, 0.0];
    let terms = wall.terms(&scene, &[], &shape);
    assert!(wall.shows(&scene, &[], &shape) && terms.len() == 1);
    let energy = |q1: f64, q2: f64| {
        let depth = (at - L1 * q1.cos() - L2 * (q1 + q2).cos()).max(0.0);
        0.5 * depth * depth
    };
    for (j, column) in &terms[0].column.rows {
        for w in (0..scene.len).filter(|&w| scene.live[*j][w]) {
            let ([q1, q2], _) = motion(scene.time[w]);
            let by = |e: f64| if *j == 0 { energy(q1 + e, q2) } else { energy(q1, q2 + e) };
            let slope = (by(1e-5) - by(-1e-5)) / 2e-5;
            assert!((column[w] - slope).abs() < 1e-6, "{j} {w}: {} {slope}", column[w]);
        }
    }
    let residual: Vec<Vec<f64>> = (0..2)
        .map(|j| {
            let row = terms[0].column.rows.iter().find(|(row, _)| *row == j);
            (0..scene.len).map(|w| [0.01, -0.01][w % 2] + 8.0 * row.map_or(0.0, |(_, c)| c[w])).collect()
        })
        .collect();
    let grid = wall.grid(&scene, &[], &residual);
    // Relative to the mean position behind it.
    let near = (grid[0][3] + grid[0][4] - at).abs() < 0.1 * (high - low);
    assert!(grid[0][0] == 21.0 && near, "{grid:?} {at}");
    // A tilt out of the plane of the arm has no effect.
    let leaning = wall.terms(&scene, &[], &[21.0, 0.3, 0.0, at, 0.0, 0.0, 0.0]);
    for ((_, one), (_, other)) in leaning[0].column.rows.iter().zip(&terms[0].column.rows) {
        assert!(one.iter().zip(&**other).all(|(a, b)| (a - b).abs() < 1e-12));
    }
    assert!((scene.directions_without_torque()[0].z.abs() - 1.0).abs() < 1e-12);
    assert_eq!(scene.directions_without_torque().len(), 1);
    // A push during contact is an error of the wall's law; one without contact may be a push.
    let touches = wall.touches(&scene, &shape);
    let behind = |wanted: bool| (0..scene.len - 20).find(|&w| touches[w..w + 20].iter().all(|t| *t == wanted)).unwrap();
    let chosen = |cause, shape: &[f64]| Chosen { cause, place: Vec::new(), shape: shape.to_vec(), x: vec![1.0] };
    let push = laws(EffectKind::ExternalContact).next().unwrap();
    let of = |start: usize| {
        let ends = [start, start + 20].map(|w| w as f64 * scene.step);
        is_an_error_of_contact(&scene, &chosen(push, &[ends[0], ends[1], 1.0, 0.0, 0.0]), [&chosen(wall, &shape)])
    };
    assert!(of(behind(true)) && !of(behind(false)));
    assert!(!is_an_error_of_contact(&scene, &chosen(wall, &shape), [&chosen(wall, &shape)]));
    // Permanent contact is a spring, and without contact there is no wall.
    assert!([low - 0.1, high + 0.1].iter().all(|at| !wall.shows(&scene, &[], &[21.0, 0.0, 0.0, *at, 0.0, 0.0, 0.0])));
}

/// With gravity along its axis, the first link has the torque of a rotor and no other. The second
/// link is turned by both joints, its rotor by one.
#[test]
fn a_first_link_is_a_rotor_where_gravity_is_along_its_axis() {
    let plant = PerturbableRobot::new(&Robot { gravity: [0.0, 0.0, -9.81], ..planar() });
    let recordings = [recording()];
    let scene = windows(&plant, &recordings, 0.0);
    let rotor = laws(EffectKind::RotorInertia).next().unwrap();
    assert_eq!(rotor.indistinguishable(&scene, &[0]), ["link_inertia_error"]);
    assert!(rotor.indistinguishable(&scene, &[1]).is_empty());
    let link = laws(EffectKind::LinkInertiaError).next().unwrap();
    assert_eq!(link.indistinguishable(&scene, &[0]), ["rotor_inertia"]);
    // No motion separates them.
    assert_eq!([0, 1].map(|j| rotor.decided_by(&scene, &[j]).is_some()), [true, false]);
    // The same holds for a right angle of the file with errors in its last digits.
    let plant = PerturbableRobot::new(&Robot { gravity: [0.0, 1e-7, -9.81], ..planar() });
    let scene = windows(&plant, &recordings, 0.0);
    assert_eq!(rotor.indistinguishable(&scene, &[0]), ["link_inertia_error"]);
    // Gravity also shows the first moments of the link.
    let plant = PerturbableRobot::new(&planar());
    let scene = windows(&plant, &recordings, 0.0);
    assert!(rotor.indistinguishable(&scene, &[0]).is_empty());
}

/// Random columns on joint 1: the first, and one that contains a part of it.
fn two_columns(scene: &WindowedData<'_>) -> [Vec<f64>; 2] {
    let mut random = Random::new(21);
    let mut series = || -> Vec<f64> { (0..scene.len).map(|_| random.uniform(-1.0, 1.0)).collect() };
    let (a, more) = (series(), series());
    let b = a.iter().zip(&more).map(|(a, b)| 0.7 * a + b).collect();
    [a, b]
}

/// A prior is equivalent to further equations: `root P (x - mean) = 0` below those of the data.
#[test]
fn a_prior_is_further_equations() {
    let plant = PerturbableRobot::new(&planar());
    let recordings = [recording()];
    let scene = windows(&plant, &recordings, 0.0);
    let [a, b] = two_columns(&scene);
    let y: Vec<f64> = a.iter().zip(&b).enumerate().map(|(w, (a, b))| a - 2.0 * b + (w as f64).sin()).collect();
    let columns = [Column::on(0, a.clone()), Column::on(0, b.clone())];
    let all = [y.clone(), vec![0.0; scene.len]];
    let mut moments = Moments::new(&scene, &scene.block, &all, &columns.iter().collect::<Vec<&Column>>());
    let (root, mean) = ([30.0, 50.0], [3.0, 1.0]);
    moments.regularised_by(Regulariser {
        precision: DMatrix::from_diagonal(&DVector::from_vec(root.map(|r| r * r).to_vec())),
        mean: DVector::from_vec(mean.to_vec()),
        spread: DMatrix::zeros(2, 2),
    });
    let found = moments.solve(None);
    let (n, weight) = (scene.len, found.weights[0].sqrt());
    let design = DMatrix::from_fn(n + 2, 2, |row, k| match row.checked_sub(n) {
        Some(at) => f64::from(u8::from(at == k)) * root[k],
        None => weight * [&a, &b][k][row],
    });
    let right = DVector::from_fn(n + 2, |row, _| match row.checked_sub(n) {
        Some(at) => root[at] * mean[at],
        None => weight * y[row],
    });
    let x = design.svd(true, true).solve(&right, 1e-12).unwrap();
    assert!((&found.x - &x).norm() < 1e-9, "{} {x}", found.x);
    // Neither the prior's values nor those of the data.
    assert!((x[0] - 3.0).abs() > 0.1 && (x[0] - 1.0).abs() > 0.1, "{x}");
}

/// A term that is half as large again in half of the parts, and half as large in the others: `1 /
/// (1 + 0.5^2)`. Terms beside it are correlated, and do not affect this.
#[test]
fn a_size_that_changes_recurs_less() {
    let plant = PerturbableRobot::new(&planar());
    let recordings = [recording()];
    let scene = windows(&plant, &recordings, 0.0);
    let [a, b] = two_columns(&scene);
    let columns = [Column::on(0, a.clone()), Column::on(0, b.clone())];
    for (off, wanted) in [(0.0, 1.0), (0.5, 0.8), (2.0, 0.2)] {
        let factor = |w: usize| if scene.block[w].is_multiple_of(2) { 1.0 + off } else { 1.0 - off };
        let y: Vec<f64> = (0..scene.len).map(|w| 2.0 * factor(w) * a[w] + 3.0 * b[w]).collect();
        let all = [y, vec![0.0; scene.len]];
        let moments = Moments::new(&scene, &scene.block, &all, &columns.iter().collect::<Vec<&Column>>());
        let found = moments.at(&moments.solve(None), DVector::from_vec(vec![2.0, 3.0]));
        let recurs = moments.recurrence(&found, &[(0, 2.0)]);
        assert!((recurs - wanted).abs() < 1e-9, "{off}: {recurs} {wanted}");
        // A delay of that size has shifted the data: none of it is left.
        let rest = (0..scene.len).map(|w| all[0][w] - 2.0 * a[w]).collect();
        let shifted = Moments::new(
            &scene,
            &scene.block,
            &[rest, vec![0.0; scene.len]],
            &columns.iter().collect::<Vec<&Column>>(),
        );
        let found = shifted.at(&shifted.solve(None), DVector::from_vec(vec![0.0, 3.0]));
        let recurs = shifted.recurrence(&found, &[(0, 2.0)]);
        assert!((recurs - wanted).abs() < 1e-9, "{off}: {recurs} {wanted}");
    }
    assert!((0..BLOCKS).all(|part| scene.block.contains(&part)));
}
