//! Edits of a robot file: identified values, couplings, removal of effects.

use crate::model::LinkExtents;
use crate::model::coupled::{Coupling, CouplingTerm};
use crate::model::likely_bodies::{PriorBody, geometric_bodies, prior_bodies};
use dh_codegen::arm::param::{self, DriveTerm, Parameter};
use dh_codegen::robot::{Effect, EffectKind, Inertia, Robot};

/// The robot with these standard parameters. The tool's contribution to the last link is
/// subtracted.
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

/// Couplings of the robot's drives, with the file's values of their [`CouplingTerm`]s (zero if
/// unknown). The reader of robot files rejects one whose `joint` is not another moving joint.
pub fn couplings(robot: &Robot) -> Vec<(Coupling, [f64; 3])> {
    let moving = robot.moving();
    let dof_of = |row: usize| moving.iter().position(|&r| r == row);
    let read = |(row, effect): &(usize, Effect)| {
        let Effect::GearCoupling(stated) = effect else { return None };
        let other = stated.joint.checked_sub(1).and_then(dof_of)?;
        let motor = dof_of(*row).filter(|&motor| motor != other)?;
        // A carried axis is not a shared motor, unless the file also declares one.
        if stated.carried.is_some() && stated.ratio.is_none() && !stated.has_motor() {
            return None;
        }
        let coupling = Coupling { row: *row, motor, other, ratio: stated.ratio() };
        Some((coupling, [stated.rotor, stated.viscous, stated.coulomb].map(|term| term.unwrap_or(0.0))))
    };
    robot.all_effects().joints.iter().filter_map(read).collect()
}

/// The robot with a rotor inertia at every moving joint, 0 where its file has none.
pub fn with_rotors(mut robot: Robot) -> Robot {
    for row in robot.moving() {
        robot.joints[row].drive.rotor_inertia.get_or_insert(0.0);
    }
    robot
}

/// The robot with these values of its [`couplings`], in order, three each.
pub fn with_couplings(mut robot: Robot, values: &[f64]) -> Robot {
    for ((coupling, _), values) in couplings(&robot).into_iter().zip(values.chunks_exact(CouplingTerm::ALL.len())) {
        let effects = &mut robot.joints[coupling.row].drive.effects;
        let stated = effects.iter_mut().find_map(|effect| match effect {
            Effect::GearCoupling(stated) => Some(stated),
            _ => None,
        });
        if let (Some(stated), &[rotor, viscous, coulomb]) = (stated, values) {
            (stated.rotor, stated.viscous, stated.coulomb) = (Some(rotor), Some(viscous), Some(coulomb));
        }
    }
    robot
}

/// The bodies of the robot file, or guesses from the geometry for missing ones.
pub fn prior(robot: &Robot, arm: &dyn LinkExtents) -> Vec<PriorBody> {
    let known: Vec<Option<[f64; 10]>> = robot.links.iter().map(|l| l.as_ref().map(|l| l.to_array())).collect();
    prior_bodies(&known, &geometric_bodies(&arm.ends()))
}

/// The tool, in the last link's frame: link (from 0) and the ten parameters.
pub fn carried(robot: &Robot) -> Vec<(usize, [f64; 10])> {
    let tool = robot.tool.as_ref().and_then(|tool| Some((tool, tool.inertia.as_ref()?)));
    let moved = tool.map(|(tool, inertia)| inertia.moved(&tool.rotation(), &tool.xyz).to_array());
    moved.map(|body| (robot.joints.len().saturating_sub(1), body)).into_iter().collect()
}

/// The robot without some of its effects: kind, and joint (degree of freedom, from 0) or `None` for
/// one of the whole robot.
pub fn without(mut robot: Robot, effects: &[(EffectKind, Option<usize>)]) -> Robot {
    let moving = robot.moving();
    for (kind, joint) in effects {
        match joint.and_then(|j| moving.get(j)) {
            Some(&row) => robot.joints[row].drive.effects.retain(|e| e.kind() != *kind),
            None => robot.effects.retain(|e| e.kind() != *kind),
        }
    }
    robot
}
