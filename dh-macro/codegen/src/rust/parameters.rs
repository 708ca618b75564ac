//! Prints `src/parameters.rs`: sizes, names, limits, values, and the arm of the inverse kinematics.

use super::inverse;
use super::kernel_file::Context;
use super::numbers::{Gravity, closed_form, product_of_lengths};
use super::words;
use crate::arm::{BaseParameter, Kernel, Model};
use crate::robot::{JointKind, Limits, Robot};

/// Text of a constant with its comment; `value` may have several lines.
fn constant(doc: &str, head: &str, value: &str) -> String {
    format!("/// {doc}.\npub const {head} = {value};\n")
}

/// List in brackets, `per` items to a line.
pub(super) fn list(items: &[String], per: usize) -> String {
    let lines: String = items.chunks(per).map(|c| format!("    {},\n", c.join(", "))).collect();
    format!("[\n{lines}]")
}

fn strings(items: &[String]) -> Vec<String> {
    items.iter().map(|s| format!("{s:?}")).collect()
}

/// Text of the whole file.
pub(super) fn print(robot: &Robot, model: &Model, kernels: &[Kernel], context: &Context<'_>) -> String {
    let mut t = format!(
        "//! Parameters of {}: sizes, names, limits, values of its file. SI units.\n\nuse super::ik;\n\n",
        words::code(&robot.name)
    );
    t += &sizes(robot, model);
    t += &names(robot, model, context);
    t += &groupings(model, context);
    t += &limits(robot);
    t += &values(robot, context);
    t += &offsets(model);
    t += &operations(kernels);
    t + &inverse::constants(model)
}

fn sizes(robot: &Robot, model: &Model) -> String {
    let size = |doc: &str, name: &str, value: usize| constant(doc, &format!("{name}: usize"), &value.to_string());
    let gravity = |title: &str, g: &Gravity| {
        constant(&format!("Gravity in {title}, m/s^2"), &format!("{}: [f64; 3]", g.name), &format!("{:?}", g.value))
    };
    let (world, base) = (Gravity::world(model.chain()), Gravity::base(model.chain()));
    let tilted = if base == world { String::new() } else { gravity("frame 0", &base) };
    constant("Name of the robot", "NAME: &str", &format!("{:?}", robot.name))
        + &size("Degrees of freedom", "DOF", model.dof())
        + &size("Rows of the DH table, fixed ones too", "ROWS", robot.joints.len())
        + &size("Standard parameters: ten per row, then the drives'", "STANDARD", model.standard().len())
        + &size("Base parameters", "BASE", model.base().len())
        + &gravity("the world frame", &world)
        + &tilted
        + "\n"
}

fn names(robot: &Robot, model: &Model, context: &Context<'_>) -> String {
    let moving = robot.moving();
    let joints: Vec<String> = moving.iter().map(|&i| robot.joints[i].name.clone()).collect();
    let groupings: Vec<String> =
        model.base().0.iter().map(|b| if b.stands_alone() { b.name.clone() } else { b.grouping.clone() }).collect();
    constant("Joints, in the order of `q`", "JOINT_NAMES: [&str; DOF]", &list(&strings(&joints), 8))
        + &constant(
            "Standard parameters, in the order of the regressor's columns (SI; tensors about the frame's origin)",
            "STANDARD_NAMES: [&str; STANDARD]",
            &list(&strings(context.standard), 10),
        )
        + &constant(
            "Base parameters, in the order of the base regressor's columns",
            "BASE_NAMES: [&str; BASE]",
            &list(&strings(context.base), 10),
        )
        + &constant(
            "Base parameters in closed form, in the constants of the robot file; a name alone groups nothing",
            "BASE_GROUPINGS: [&str; BASE]",
            &list(&strings(&groupings), 1),
        )
}

/// Text of the base parameters' factors, in the constants of the file if that gives the same bits.
fn groupings(model: &Model, context: &Context<'_>) -> String {
    let mut symbols = false;
    let mut row = |b: &BaseParameter| {
        let entries: Vec<String> = b
            .coefficients
            .iter()
            .zip(&b.closed_forms)
            .map(|((i, c), form)| {
                let closed = closed_form(form, *c, context.constants, "");
                symbols |= closed.is_some();
                let text = closed.or_else(|| product_of_lengths(*c, context.robot));
                format!("({i}, {})", text.unwrap_or_else(|| format!("{c:?}")))
            })
            .collect();
        format!("&[{}]", entries.join(", "))
    };
    let rows: Vec<String> = model.base().0.iter().map(&mut row).collect();
    let table = list(&rows, 1);
    // A separate scope prevents collisions of the file's words with other names.
    let value = match symbols {
        true => format!("{{\n    use super::constants::*;\n    {}\n}}", table.replace('\n', "\n    ")),
        false => table,
    };
    constant(
        "The same as numbers: index into the standard parameters, and factor",
        "BASE_COEFFICIENTS: [&[(usize, f64)]; BASE]",
        &value,
    ) + "\n"
}

fn limits(robot: &Robot) -> String {
    let moving = robot.moving();
    let each = |text: &dyn Fn(&Limits) -> String| -> String {
        let all: Vec<String> = moving.iter().map(|&i| text(&robot.joints[i].limits)).collect();
        list(&all, 4)
    };
    let largest = |doc: &str, name: &str, of: &dyn Fn(&Limits) -> Option<f64>| {
        constant(doc, &format!("{name}: [Option<f64>; DOF]"), &each(&|l| format!("{:?}", of(l))))
    };
    constant(
        "Lower and upper position of each joint, rad or m",
        "POSITION_LIMITS: [Option<[f64; 2]>; DOF]",
        &each(&|l| format!("{:?}", l.position)),
    ) + &largest("Largest speeds, rad/s or m/s", "VELOCITY_LIMITS", &|l| l.velocity)
        + &largest("Largest accelerations, rad/s^2 or m/s^2", "ACCELERATION_LIMITS", &|l| l.acceleration)
        + &largest("Largest torques or forces, N m or N", "TORQUE_LIMITS", &|l| l.torque)
}

/// Text of the standard parameters' values in the file.
fn values(robot: &Robot, context: &Context<'_>) -> String {
    let head = "STANDARD_VALUES: Option<[f64; STANDARD]>";
    match crate::arm::param::standard_values(robot) {
        None => constant("Standard parameters of the robot file: some links have none there", head, "None") + "\n",
        Some(values) => {
            let rows: String = values
                .chunks(10)
                .zip(context.standard.chunks(10))
                .map(|(values, names)| {
                    let values: Vec<String> = values.iter().map(|v| format!("{v:?}")).collect();
                    let last = names.last().map_or("", String::as_str);
                    format!("    {}, // {} to {last}\n", values.join(", "), names[0])
                })
                .collect();
            constant(
                "Standard parameters of the robot file, its tool in the last link",
                head,
                &format!("Some([\n{rows}])"),
            ) + "\n"
        }
    }
}

/// Text of the constant parts of the joint angles.
fn offsets(model: &Model) -> String {
    let offsets = model.chain().angle_offsets();
    if offsets.iter().all(|o| *o == 0.0) {
        return String::new();
    }
    let offsets: Vec<String> = offsets.iter().map(|o| format!("{o:?}")).collect();
    constant(
        "Added to each joint's angle before its sine is taken, rad (quarter turns are in the kernels)",
        "ANGLE_OFFSETS: [f64; DOF]",
        &list(&offsets, 8),
    ) + "\n"
}

fn operations(kernels: &[Kernel]) -> String {
    let rows: Vec<String> = kernels
        .iter()
        .map(|k| {
            let c = k.tape.operations();
            format!("({:?}, {}, {})", k.function.name(), c.mul, c.add)
        })
        .collect();
    constant(
        "Name, multiplications and additions of each function; sines and cosines apart (`DOF` pairs)",
        &format!("OPERATIONS: [(&str, usize, usize); {}]", kernels.len()),
        &list(&rows, 1),
    ) + "\n"
}

/// Whether the robot has a revolute joint.
pub(super) fn turns(robot: &Robot) -> bool {
    robot.moving().iter().any(|&i| robot.joints[i].kind == JointKind::Revolute)
}
