//! Kinetic and potential energy, linear in the parameters: one column per standard parameter.

use super::chain::{Group, Links};
use super::kinematics::{Pose, frames};
use super::param::{DriveTerm, Inertial, Parameter};
use crate::robot::JointKind;
use crate::sym::{Ex, Vec3};

/// Kinetic energy `T = h phi`: `h`, J per unit of each parameter.
pub(super) fn kinetic<'g>(links: &Links<'g>, parameters: &[Parameter]) -> Vec<Ex<'g>> {
    let g = links.graph;
    let mut twists: Vec<(Vec3<'g>, Vec3<'g>)> = Vec::new(); // of each body's frame
    let (mut w, mut v) = (Vec3::zero(g), Vec3::zero(g));
    for (row, link) in links.links.iter().enumerate() {
        g.section(format!("link {}: velocity", row + 1));
        let dq = links.velocity(row);
        let (w1, v1) = (link.untwist(w), link.untwist(v));
        let v1 = v1 + w1.cross(link.step(false));
        (w, v) = (link.unturn(w1), link.unturn(v1));
        match link.kind {
            JointKind::Revolute => w = w + link.axis().scale(dq),
            JointKind::Prismatic => v = v + link.axis().scale(dq),
            JointKind::Fixed => {}
        }
        twists.push((link.into_body(w), link.into_body(v + w.cross(link.body_origin()))));
    }
    g.section("kinetic energy");
    let half = |x: Ex<'g>| x * 0.5;
    parameters
        .iter()
        .map(|p| match *p {
            Parameter::Link(row, which) => {
                let (w, v) = twists[row];
                let turning = v.cross(w).0;
                let [x, y, z] = w.0;
                match which {
                    Inertial::M => half(v.dot(v)),
                    Inertial::MSX => turning[0],
                    Inertial::MSY => turning[1],
                    Inertial::MSZ => turning[2],
                    Inertial::XX => half(x * x),
                    Inertial::YY => half(y * y),
                    Inertial::ZZ => half(z * z),
                    Inertial::XY => x * y,
                    Inertial::XZ => x * z,
                    Inertial::YZ => y * z,
                }
            }
            Parameter::Drive(row, DriveTerm::IA) => half(links.velocity(row).squared()),
            Parameter::Drive(..) => links.number(0.0),
        })
        .collect()
}

/// Potential energy `U = h phi`, zero at the world frame's origin; an offset torque has the
/// potential `FO q`.
pub(super) fn potential<'g>(links: &Links<'g>, parameters: &[Parameter]) -> Vec<Ex<'g>> {
    let poses = frames(links);
    links.graph.section("potential energy");
    parameters
        .iter()
        .map(|p| match *p {
            Parameter::Link(row, which) => {
                let Pose { r, p } = poses[row];
                match which {
                    Inertial::M => links.world_lift.dot(p),
                    Inertial::MSX => links.world_lift.dot(r.column(0)),
                    Inertial::MSY => links.world_lift.dot(r.column(1)),
                    Inertial::MSZ => links.world_lift.dot(r.column(2)),
                    _ => links.number(0.0),
                }
            }
            Parameter::Drive(row, DriveTerm::FO) => {
                links.links[row].dof.map_or(links.number(0.0), |k| links.input(Group::Position, k))
            }
            Parameter::Drive(..) => links.number(0.0),
        })
        .collect()
}
