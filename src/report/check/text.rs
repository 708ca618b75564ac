//! Report of `denavit check` as text.

use core::fmt::Write;

use dh_codegen::arm::{Inverse, Model};
use dh_codegen::robot::{Convention, Joint, Robot};

use crate::report::parts::number::{counted, pad};

/// DH table, kinematic class, base parameters, operation counts.
pub fn check_text(robot: &Robot, model: &Model) -> String {
    let mut t = String::new();
    let convention = match robot.convention {
        Convention::Modified => "modified (Khalil-Kleinfinger)",
        Convention::Standard => "standard",
    };
    let _ = writeln!(
        t,
        "{}: {}, {convention} DH table\n",
        robot.name,
        counted(model.dof(), "degree of freedom", "degrees of freedom")
    );
    t.push_str(&dh_table(robot));
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

/// The DH table, one line per row; columns are as wide as their widest cell.
fn dh_table(robot: &Robot) -> String {
    let head = ["j", "name", "type", "alpha", "d", "theta", "r"].map(String::from);
    let row = |(j, joint): (usize, &Joint)| {
        let kind = format!("{:?}", joint.kind).to_lowercase();
        let [alpha, d, theta, r] =
            [&joint.alpha.text, &joint.d.text, &joint.theta.text, &joint.r.text].map(Clone::clone);
        [(j + 1).to_string(), joint.name.clone(), kind, alpha, d, theta, r]
    };
    let rows: Vec<[String; 7]> = std::iter::once(head).chain(robot.joints.iter().enumerate().map(row)).collect();
    let least = [3, 12, 10, 12, 10, 12, 10];
    let width = |k: usize| rows.iter().map(|row| row[k].chars().count()).fold(least[k], usize::max);
    let widths: [usize; 7] = std::array::from_fn(width);
    let cell = |k: usize, text: &str| pad(text, widths[k], k != 1 && k != 2);
    let line =
        |row: &[String; 7]| row.iter().enumerate().map(|(k, text)| format!(" {}", cell(k, text))).collect::<String>();
    rows.iter().map(|row| format!(" {}\n", line(row).trim_end())).collect()
}

#[cfg(test)]
mod tests {
    use dh_codegen::robot::no_files;

    use super::*;

    #[test]
    fn columns_stand_below_their_heads_whatever_the_names() {
        let text = "name: arm\nconvention: modified\njoints:\n  - { name: shoulder_of_the_left_arm, type: revolute }\n  - { name: b, \
                    type: revolute, d: 0.31 }\n";
        let robot = Robot::from_yaml(text, &no_files).unwrap().robot;
        let table = dh_table(&robot);
        let at: Vec<Option<usize>> =
            table.lines().zip(["type", "revolute", "revolute"]).map(|(line, word)| line.find(word)).collect();
        assert!(at[0].is_some() && at.iter().all(|a| *a == at[0]), "{table}");
    }
}
