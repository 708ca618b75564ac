//! `check` for people.

use core::fmt::Write;

use dh_codegen::arm::{Inverse, Model};
use dh_codegen::robot::{Convention, Robot};

/// Table, class, base parameters, operation counts.
pub fn check_text(robot: &Robot, model: &Model) -> String {
    let mut t = String::new();
    let convention = match robot.convention {
        Convention::Modified => "modified (Khalil-Kleinfinger)",
        Convention::Standard => "standard",
    };
    let _ = writeln!(t, "{}: {} degrees of freedom, {convention} DH table\n", robot.name, model.dof());
    let _ = writeln!(
        t,
        "  {:>3} {:<12} {:<10} {:>12} {:>10} {:>12} {:>10}",
        "j", "name", "type", "alpha", "d", "theta", "r"
    );
    for (j, joint) in robot.joints.iter().enumerate() {
        let kind = format!("{:?}", joint.kind).to_lowercase();
        let _ = writeln!(
            t,
            "  {:>3} {:<12} {:<10} {:>12} {:>10} {:>12} {:>10}",
            j + 1,
            joint.name,
            kind,
            joint.alpha.text,
            joint.d.text,
            joint.theta.text,
            joint.r.text
        );
    }
    let passive: Vec<String> = robot.unactuated().map(|row| robot.joints[row].name.clone()).collect();
    if !passive.is_empty() {
        let list = passive.join(", ");
        let _ = writeln!(
            t,
            "  without a motor: {list} (inverse dynamics gives the torque that something else must apply there)"
        );
    }
    if !robot.constants.is_empty() {
        let list: Vec<String> = robot.constants.iter().map(|(n, v)| format!("{n} = {v}")).collect();
        let _ = writeln!(t, "  {}", list.join(", "));
    }
    let class = Inverse::new(model.chain());
    let _ = writeln!(t, "\nkinematic class: {}\ninverse kinematics: {} ({})", class.joints, class.class, class.reason);
    let inertial =
        model.base().0.iter().filter(|b| matches!(b.leader, dh_codegen::arm::param::Parameter::Link(..))).count();
    let _ = writeln!(
        t,
        "\nbase parameters: {} of {} standard ones ({inertial} inertial, {} of the drives)\n",
        model.base().len(),
        model.standard().len(),
        model.base().len() - inertial
    );
    for b in &model.base().0 {
        let _ = writeln!(t, "  {}", b.grouping);
    }
    let _ = writeln!(
        t,
        "\noperations, sines and cosines apart:\n\n  {:<28} {:>5} {:>5} {:>9}",
        "function", "mul", "add", "sin/cos"
    );
    for (f, mul, add, sincos) in crate::report::check::json::operations(model) {
        let _ = writeln!(t, "  {:<28} {mul:>5} {add:>5} {sincos:>9}", f.name());
    }
    t
}
