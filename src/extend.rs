//! The robot file that comes back: links and drives with identified values, effects with what a diagnosis found.

use dh_codegen::arm::param::{self, DriveTerm, Parameter};
use dh_codegen::robot::effect::Law;
use dh_codegen::robot::{Effect, Inertia, Robot};

use crate::coupled::{self, Coupling};
use crate::diagnose::{Cause, Diagnosis};

/// The robot with these standard parameters; what the tool contributes to the last link is taken out again.
pub fn with_values(mut robot: Robot, standard: &[f64]) -> Robot {
    let parameters = param::standard(&robot);
    let mut links = vec![[0.0; 10]; robot.joints.len()];
    for (parameter, &value) in parameters.iter().zip(standard) {
        match *parameter {
            Parameter::Link(row, which) => links[row][which as usize] = value,
            Parameter::Drive(row, term) => {
                let drive = &mut robot.joints[row].drive;
                *match term {
                    DriveTerm::IA => &mut drive.rotor_inertia,
                    DriveTerm::FV => &mut drive.viscous_friction,
                    DriveTerm::FC => &mut drive.coulomb_friction,
                    DriveTerm::FO => &mut drive.offset,
                } = Some(value);
            }
        }
    }
    if let (Some(tool), Some(last)) = (&robot.tool, links.last_mut())
        && let Some(inertia) = &tool.inertia
    {
        let carried = inertia.moved(&tool.rotation(), &tool.xyz).to_array();
        last.iter_mut().zip(carried).for_each(|(l, c)| *l -= c);
    }
    robot.links = links.into_iter().map(|l| Some(Inertia::from_array(l))).collect();
    robot
}

/// The couplings that the robot's drives name, with what the file says of their [`coupled::TERMS`] (zero: not known yet). One whose
/// `joint` is no other moving joint is left out: nothing can be fitted to it.
pub fn couplings(robot: &Robot) -> Vec<(Coupling, [f64; 3])> {
    let moving = robot.moving();
    let dof_of = |row: usize| moving.iter().position(|&r| r == row);
    let read = |(row, effect): &(usize, Effect)| {
        let value = |key: &str| effect.parameters.iter().find(|(k, _)| k == key).map(|(_, v)| *v);
        let other = (value("joint")? as usize).checked_sub(1).and_then(dof_of)?;
        let motor = dof_of(*row).filter(|&motor| motor != other)?;
        let coupling = Coupling { row: *row, motor, other, ratio: value("KC").unwrap_or(1.0) };
        Some((coupling, coupled::TERMS.map(|(key, _)| value(key).unwrap_or(0.0))))
    };
    robot.all_effects().joints.iter().filter(|(_, effect)| effect.name == "gear_coupling").filter_map(read).collect()
}

/// The robot with these values of its [`couplings`], in their order, three each.
pub fn with_couplings(mut robot: Robot, values: &[f64]) -> Robot {
    for ((coupling, _), values) in couplings(&robot).into_iter().zip(values.chunks_exact(coupled::TERMS.len())) {
        let effects = &mut robot.joints[coupling.row].drive.effects;
        let Some(effect) = effects.iter_mut().find(|e| e.name == "gear_coupling") else { continue };
        for ((key, _), &value) in coupled::TERMS.iter().zip(values) {
            match effect.parameters.iter_mut().find(|(k, _)| k == key) {
                Some((_, old)) => *old = value,
                None => effect.parameters.push((key.to_string(), value)),
            }
        }
    }
    robot
}

const BODY: [&str; 10] = ["M", "MSX", "MSY", "MSZ", "XX", "YY", "ZZ", "XY", "XZ", "YZ"];

/// The robot with everything in it that a diagnosis found.
pub fn extended(robot: Robot, found: &Diagnosis) -> Robot {
    let mut robot = match &found.standard {
        Some(standard) if found.links_refitted => {
            // The diagnosis keeps friction apart; the file's own stays unless a cause changes it.
            let names = param::standard(&robot);
            let values: Vec<f64> = names
                .iter()
                .zip(standard)
                .map(|(p, v)| match *p {
                    Parameter::Drive(row, term) if term != DriveTerm::IA => {
                        param::drive_value(&robot, row, term).unwrap_or(0.0)
                    }
                    _ => *v,
                })
                .collect();
            with_values(robot, &values)
        }
        _ => robot,
    };
    let moving = robot.moving();
    for cause in &found.causes {
        put(&mut robot, &moving, cause);
    }
    robot
}

fn put(robot: &mut Robot, moving: &[usize], cause: &Cause) {
    let row = cause.joints.first().and_then(|j| moving.get(j - 1)).copied();
    let mut left: Vec<(String, f64)> = Vec::new();
    for named in &cause.keys {
        let drive = row.map(|row| &mut robot.joints[row].drive);
        match (named.symbol.as_str(), drive) {
            ("FV", Some(drive)) => drive.viscous_friction = Some(named.value),
            ("FC", Some(drive)) => drive.coulomb_friction = Some(named.value),
            ("IA", Some(drive)) if cause.cause == "rotor_inertia" => drive.rotor_inertia = Some(named.value),
            _ => left.push((named.symbol.clone(), named.value)),
        }
    }
    if cause.cause == "link_inertia_error" {
        if let Some(row) = row {
            let mut values = robot.links.get(row).copied().flatten().map_or([0.0; 10], Inertia::to_array);
            for (symbol, by) in &left {
                if let Some(at) = BODY.iter().position(|b| b == symbol) {
                    values[at] += by;
                }
            }
            if !left.is_empty() && row < robot.links.len() {
                robot.links[row] = Some(Inertia::from_array(values));
            }
        }
        return;
    }
    if left.is_empty() || cause.cause == "unknown" {
        return;
    }
    if cause.cause == "gear_coupling"
        && let Some(other) = cause.joints.get(1).and_then(|j| moving.get(j - 1))
    {
        left.insert(0, ("joint".into(), (other + 1) as f64));
    }
    // The file knows the keys of its own table; what else was found stands in the comments and the JSON.
    left.retain(|(key, _)| Law::of(cause.cause).is_some_and(|law| law.key(key).is_some()));
    if left.is_empty() {
        return;
    }
    let effects = match row {
        Some(row) => &mut robot.joints[row].drive.effects,
        None => &mut robot.effects,
    };
    match effects.iter_mut().find(|e| e.name == cause.cause) {
        // A second ripple of the same joint: its keys are numbered.
        Some(known) => {
            let number = 1 + known.parameters.iter().filter(|(k, _)| k.starts_with(left[0].0.as_str())).count();
            known.parameters.extend(left.into_iter().map(|(k, v)| (format!("{k}{number}"), v)));
        }
        None => effects.push(Effect { name: cause.cause.to_string(), parameters: left }),
    }
}
