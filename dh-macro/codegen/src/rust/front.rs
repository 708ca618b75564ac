//! Prints the front page of a crate, its example, and its README.

use core::fmt::Write;

use super::kernel_file::Context;
use super::krate::Runtime;
use super::{shell, words};
use crate::arm::{Inverse, Kernel, Model};
use crate::robot::{JointKind, Robot, crate_name};

/// Data of the front pages.
pub(super) struct Front<'a> {
    pub context: &'a Context<'a>,
    pub model: &'a Model,
    pub kernels: &'a [Kernel],
    /// Text of the robot file.
    pub source: &'a str,
    pub runtime: &'a Runtime,
}

impl Front<'_> {
    fn robot(&self) -> &Robot {
        self.context.robot
    }

    /// Library name of the crate in Rust.
    fn library(&self) -> String {
        crate_name(&self.robot().name).replace('-', "_")
    }

    /// Summary: description of the robot, and its source file.
    fn summary(&self) -> String {
        format!(
            "Closed-form kinematics and dynamics of {}: {} degrees of freedom, {} base parameters.\n\nWritten by denavit {} from the robot file with digest {:016x}. Do not edit it: change the file and run `denavit generate` again.\n",
            words::code(&self.robot().name),
            self.model.dof(),
            self.model.base().len(),
            env!("CARGO_PKG_VERSION"),
            shell::digest(self.source)
        )
    }

    /// Comment at the top of a module, without the example, which is for a crate.
    pub(super) fn module(&self) -> String {
        commented(&format!("{}\n{UNITS}\n{}", self.summary(), self.functions(true)))
    }

    /// Comment at the top of `src/lib.rs`.
    pub(super) fn root(&self) -> String {
        commented(&format!("{}\n{UNITS}\n```\n{}```\n\n{}", self.summary(), self.example(), self.functions(true)))
    }

    /// Text of `README.md`.
    pub(super) fn readme(&self) -> String {
        let (robot, name) = (self.robot(), crate_name(&self.robot().name));
        let mut t = format!("# {name}\n\n{}\n", self.summary());
        let needs = match self.runtime {
            Runtime::Shipped => "The folder depends on nothing: copy it anywhere and add it to a `Cargo.toml`.",
            Runtime::Crate(_) => "The crate runs on `denavit-runtime`. Add it to a `Cargo.toml`.",
        };
        let _ = writeln!(
            t,
            "{needs}\n\n```toml\n[dependencies]\n{name} = {{ path = \"{name}\" }}\n```\n\n```rust\n{}```\n",
            self.example()
        );
        t += "## Joints\n\n| | joint | type | position | velocity | torque |\n|---|---|---|---|---|---|\n";
        for (k, &row) in robot.moving().iter().enumerate() {
            let joint = &robot.joints[row];
            let (kind, unit) = match joint.kind {
                JointKind::Prismatic => ("prismatic", ["m", "m/s", "N"]),
                _ => ("revolute", ["rad", "rad/s", "N m"]),
            };
            let position = joint.limits.position.map(|[low, high]| format!("{low:.4} to {high:.4} {}", unit[0]));
            let size = |value: Option<f64>, unit: &str| value.map_or("-".into(), |v| format!("{v:.4} {unit}"));
            let _ = writeln!(
                t,
                "| {} | {} | {kind} | {} | {} | {} |",
                k + 1,
                words::code(&joint.name).replace('|', "\\|"),
                position.unwrap_or_else(|| "-".into()),
                size(joint.limits.velocity, unit[1]),
                size(joint.limits.torque, unit[2])
            );
        }
        let _ = writeln!(t, "\n## Functions\n\n{UNITS}\n{}", self.functions(false));
        t += "`cargo test` checks the functions against each other and against differences.\n\n## Licence\n\nMIT (`LICENSE-MIT`) or Apache-2.0 (`LICENSE-APACHE`), at your choice.\n";
        t
    }

    /// Table of the functions; `links`: whether to link their documentation.
    fn functions(&self, links: bool) -> String {
        let mut t = String::from("| function | result | multiplications | additions |\n|---|---|---|---|\n");
        for kernel in self.kernels {
            let c = kernel.tape.operations();
            let shape: Vec<String> = kernel.shape.iter().map(usize::to_string).collect();
            let name = kernel.function.name();
            let name = if links { format!("[`{name}`]") } else { format!("`{name}`") };
            let title = self.context.doc(kernel.function).0;
            let _ = writeln!(t, "| {name}: {title} | {} | {} | {} |", shape.join(" x "), c.mul, c.add);
        }
        t
    }

    /// Example program that uses the crate.
    fn example(&self) -> String {
        let redundancy = if Inverse::new(self.model.chain()).is_redundant() {
            "redundancy: arm::IK.redundancy(&q, &arm::ik::Reference::UP), "
        } else {
            ""
        };
        let phi = match crate::arm::param::standard_values(self.robot()) {
            Some(_) => "arm::STANDARD_VALUES.expect(\"the robot file has the parameters of every link\")",
            None => "[0.1; arm::STANDARD]; // identified parameters go here",
        };
        let end = if phi.ends_with("here") { "" } else { ";" };
        format!(
            "use {} as arm;

// Frames: rows of homogeneous matrices, m. Every posture found reaches the pose.
let q = [{}];
let pose = arm::forward_kinematics(&q);
let query = arm::ik::Query {{ {redundancy}near: Some(&q), ..Default::default() }};
let postures = arm::inverse_kinematics(&pose, &query).expect(\"a pose\");
for posture in postures.as_slice() {{
    let reached = arm::forward_kinematics(&posture.q);
    assert!((0..3).all(|row| (reached[row][3] - pose[row][3]).abs() < 1e-9));
}}

// Torques: they are linear in the parameters.
let phi = {phi}{end}
let beta = arm::base_parameters(&phi);
let (dq, ddq) = ([0.1; arm::DOF], [0.2; arm::DOF]);
let tau = arm::inverse_dynamics_base(&q, &dq, &ddq, &beta);
let regressor = arm::base_regressor(&q, &dq, &ddq);
for (row, tau) in regressor.iter().zip(tau) {{
    let sum: f64 = row.iter().zip(&beta).map(|(w, b)| w * b).sum();
    assert!((sum - tau).abs() < 1e-9 * (1.0 + tau.abs()));
}}
",
            self.library(),
            self.posture()
        )
    }

    /// A posture inside the limits, to two digits, away from straight arms.
    fn posture(&self) -> String {
        let robot = self.robot();
        let one = |(k, &row): (usize, &usize)| {
            let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
            let wanted = sign * (0.3 + 0.1 * k as f64);
            let inside = match robot.joints[row].limits.position {
                Some([low, high]) if !(low..high).contains(&wanted) => low + (high - low) * 0.4,
                _ => wanted,
            };
            format!("{:?}", (inside * 100.0).round() / 100.0)
        };
        robot.moving().iter().enumerate().map(one).collect::<Vec<_>>().join(", ")
    }
}

const UNITS: &str = "SI units: m, rad, s, kg, N m. Torques are those of the actuators on the links. Poses and Jacobians are in the world frame: frame 0 of the table where the robot file has no `base`. Tensors are about the frame's origin. Nothing is allocated; nothing but `core` is used. Kernels (module `kernel`) take sines and cosines (`Trig`); the functions here take `q`. All are generic over `runtime::Scalar`: `f64`, `f32` and packs of states run the same text. With the feature `dispatch` (needs `std`) module `dispatch` has them for `f64` with the instructions of the processor at hand.
";

/// Formats a text as the comment of a module.
fn commented(text: &str) -> String {
    text.lines().map(|l| if l.is_empty() { "//!\n".to_string() } else { format!("//! {l}\n") }).collect()
}
