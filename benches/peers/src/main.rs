//! Inverse kinematics compared with other crates, in one run: median time per pose for all
//! branches.
//!
//! `RUSTFLAGS="-C target-cpu=native" cargo run --release` in this folder. It needs cmake and a C
//! compiler, for nlopt (ik-geo). ik-geo gets the same axes and poses as our solver.
//! rs-opw-kinematics gets an arm of the same lengths and poses of its own forward kinematics,
//! because its zero posture differs.

#[path = "../../ik/measure.rs"]
mod measure;

use std::hint::black_box;

use dh_codegen::ik::Axis;
use ik_geo::nalgebra::{Matrix3, Vector3};
use ik_geo::robot::{IKSolver, Robot, spherical_two_parallel, three_parallel_two_intersecting};
use measure::{Bench, POSES, Pose, median};
use rs_opw_kinematics::kinematic_traits::Kinematics;
use rs_opw_kinematics::kinematics_impl::OPWKinematics;
use rs_opw_kinematics::parameters::opw_kinematics::Parameters;

fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| a[i] - b[i])
}

/// Our axes as ik-geo's product of exponentials; `points`: one on each axis.
fn geo(bench: &Bench<6>, points: [[f64; 3]; 6], make: fn(&[Vector3<f64>; 6], &[Vector3<f64>; 7]) -> Robot) -> f64 {
    let h = bench.arm.axes.map(|a| Vector3::from(a.h));
    let tip = bench.arm.home.shift;
    let p = core::array::from_fn(|k| {
        let (before, here) = (if k == 0 { [0.0; 3] } else { points[k - 1] }, if k == 6 { tip } else { points[k] });
        Vector3::from(sub(here, before))
    });
    let robot = make(&h, &p);
    let home = bench.arm.home.rotation;
    let rows = |m: &[[f64; 3]; 3]| Matrix3::from_fn(|i, j| m[i][j]);
    let poses: Vec<(Matrix3<f64>, Vector3<f64>)> = bench
        .poses
        .iter()
        .map(|(pose, _): &(Pose, f64)| {
            let r = Matrix3::from_fn(|i, j| pose[i][j]);
            (r * rows(&home).transpose(), Vector3::new(pose[0][3], pose[1][3], pose[2][3]))
        })
        .collect();
    // Checks that it solves the given poses.
    let mut met = 0;
    for (r, t) in &poses {
        let reached = robot.ik(*r, *t).iter().any(|(q, _)| {
            let mut joints = [0.0; 6];
            joints.copy_from_slice(q.as_slice());
            let (r2, t2) = robot.fk(&joints);
            (r2 - r).norm() + (t2 - t).norm() < 1e-6
        });
        met += usize::from(reached);
    }
    assert!(met * 100 >= 99 * poses.len(), "ik-geo meets {met} of {} poses", poses.len());
    median(&poses, |(r, t)| {
        black_box(robot.ik(*r, *t));
    })
}

fn columns<const N: usize>(v: &[Vector3<f64>; N]) -> ik_geo::nalgebra::SMatrix<f64, 3, N> {
    ik_geo::nalgebra::SMatrix::from_columns(v)
}

/// An ortho-parallel arm of these lengths.
fn opw(a2: f64, b: f64, c1: f64, c2: f64, c3: f64, c4: f64) -> f64 {
    let arm = OPWKinematics::new(Parameters { a2, b, c1, c2, c3, c4, ..Parameters::new() });
    let poses: Vec<_> = (0..POSES)
        .map(|k| arm.forward(&core::array::from_fn(|i| ((k * 7 + i + 1) as f64 * 0.7371).sin() * 2.5)))
        .collect();
    median(&poses, |pose| {
        black_box(arm.inverse(pose));
    })
}

fn us(ns: Option<f64>) -> String {
    ns.map_or("-".into(), |ns| format!("{:.2} us", ns / 1e3))
}

fn row<const N: usize>(name: &str, bench: &Bench<N>, geo: Option<f64>, opw: Option<f64>) {
    let (ns, branches) = bench.solve();
    let intervals = (bench.class == "srs").then(|| bench.intervals());
    println!(
        "| {name} | {} | {branches:.1} | {} | {} | {} | {} |",
        bench.class,
        us(Some(ns)),
        us(geo),
        us(opw),
        us(intervals)
    );
}

/// Points for an intersection of the last three axes in `center`.
fn wrist(axes: &[Axis; 6], center: [f64; 3]) -> [[f64; 3]; 6] {
    core::array::from_fn(|k| if k < 3 { axes[k].c } else { center })
}

fn main() {
    println!(
        "| robot | class | branches | denavit | ik-geo 0.1.2 | rs-opw-kinematics 3.0.0 | swivel intervals |\n|---|---|---:|---:|---:|---:|---:|"
    );
    row("kuka-lwr4", &Bench::<7>::new("kuka-lwr4"), None, None);
    row("kuka-iiwa14", &Bench::<7>::new("kuka-iiwa14"), None, None);
    row("franka-panda", &Bench::<7>::new("franka-panda"), None, None);
    let ur = Bench::<6>::new("ur10e");
    let mut points = ur.arm.axes.map(|a| a.c);
    // Axes 5 and 6 intersect; axes 1 and 2 as well.
    let meet = |a: &Axis, b: &Axis| {
        let d = sub(b.c, a.c);
        let c: f64 = (0..3).map(|i| a.h[i] * b.h[i]).sum();
        let along = |h: [f64; 3]| -> f64 { (0..3).map(|i| h[i] * d[i]).sum() };
        let s = (along(a.h) - c * along(b.h)) / (1.0 - c * c);
        [0, 1, 2].map(|i| a.c[i] + s * a.h[i])
    };
    let at = meet(&ur.arm.axes[4], &ur.arm.axes[5]);
    (points[4], points[5]) = (at, at);
    let at = meet(&ur.arm.axes[0], &ur.arm.axes[1]);
    (points[0], points[1]) = (at, at);
    let ns = geo(&ur, points, |h, p| three_parallel_two_intersecting(columns(h), columns(p)));
    row("ur10e", &ur, Some(ns), None);
    for (name, opw) in [
        ("puma560", opw(-0.0203, 0.1501, 0.0, 0.4318, 0.4331, 0.0)),
        ("staubli-tx40", opw(0.0, 0.035, 0.32, 0.225, 0.225, 0.065)),
    ] {
        let bench = Bench::<6>::new(name);
        let center = meet(&bench.arm.axes[3], &bench.arm.axes[4]);
        let points = wrist(&bench.arm.axes, center);
        let ns = geo(&bench, points, |h, p| spherical_two_parallel(columns(h), columns(p)));
        row(name, &bench, Some(ns), Some(opw));
    }
    row("scara", &Bench::<4>::new("scara"), None, None);
    row("stanford", &Bench::<6>::new("stanford"), None, None);
}
