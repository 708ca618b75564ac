//! Computes the regressor, one unit parameter at a time (Khalil and Dombre, 12.4.3).

use core::cmp::Ordering;

use super::chain::{Group, Links};
use super::motion::{Include, Motion, Sweep, along_axis};
use super::param::{DriveTerm, Inertial, Parameter};
use super::plan::{ColumnPlan, Plan};
use super::screw::{Screw, Screws};
use super::wrench::Wrench;
use crate::sym::{Ex, Vec3};

/// Columns of `W` in `tau = W phi`, computed one by one.
pub(super) struct Columns<'a, 'g> {
    links: &'a Links<'g>,
    sweep: Sweep<'g>,
    screws: Screws<'g>,
    plan: &'a Plan,
}

impl<'a, 'g> Columns<'a, 'g> {
    pub fn new(links: &'a Links<'g>, plan: &'a Plan, include: Include) -> Self {
        let sweep = Sweep::new(links, include);
        let screws = Screws::new(links);
        Self { links, sweep, screws, plan }
    }

    /// Column of a parameter, one entry per degree of freedom.
    pub fn column(&self, parameter: Parameter) -> Vec<Ex<'g>> {
        match parameter {
            Parameter::Link(row, which) => self.link(row, which),
            Parameter::Drive(row, term) => self.drive(row, term),
        }
    }

    fn drive(&self, row: usize, term: DriveTerm) -> Vec<Ex<'g>> {
        let mut column = vec![self.links.number(0.0); self.links.inputs.dof];
        if let Some(k) = self.links.links[row].dof {
            column[k] = match term {
                DriveTerm::IA => self.links.input(Group::Acceleration, k),
                DriveTerm::FV => self.links.input(Group::Velocity, k),
                DriveTerm::FC => self.links.input(Group::Velocity, k).sign(),
                DriveTerm::FO => self.links.number(1.0),
            };
        }
        column
    }

    fn link(&self, row: usize, which: Inertial) -> Vec<Ex<'g>> {
        if !self.plan[row].shifted {
            return self.about_origin(row, which, false);
        }
        // With z' = z + r: M' = M, MSZ' = MSZ + r M, XX' = XX + 2 r MSZ + r^2 M, YY' alike, XZ' =
        // XZ - r MSX, YZ' = YZ - r MSY.
        let r = self.links.links[row].r_constant;
        let at = |p| self.about_origin(row, p, true);
        let combine = |a: Vec<Ex<'g>>, f: f64, b: Vec<Ex<'g>>| -> Vec<Ex<'g>> {
            a.into_iter().zip(b).map(|(a, b)| a + b * f).collect()
        };
        let transverse = || combine(at(Inertial::XX), 1.0, at(Inertial::YY));
        match which {
            Inertial::M => combine(combine(at(Inertial::M), r, at(Inertial::MSZ)), r * r, transverse()),
            Inertial::MSX => combine(at(Inertial::MSX), -r, at(Inertial::XZ)),
            Inertial::MSY => combine(at(Inertial::MSY), -r, at(Inertial::YZ)),
            Inertial::MSZ => combine(at(Inertial::MSZ), 2.0 * r, transverse()),
            tensor => at(tensor),
        }
    }

    fn about_origin(&self, row: usize, which: Inertial, shifted: bool) -> Vec<Ex<'g>> {
        self.links.graph.section(format!("{}: column", Parameter::Link(row, which).name()));
        let motion = self.sweep.body(self.links, row, shifted);
        let wrench = Wrench::unit(&motion, which).out_of_body(self.links, row);
        self.torques(row, wrench, self.plan[row].columns[which as usize], shifted)
    }

    /// Torques of all joints against a wrench in the joint frame of `row`, which is carried inward
    /// to frame `plan.moment` and projected there (for its force, see [`ColumnPlan`]).
    pub fn torques(&self, row: usize, wrench: Wrench<'g>, plan: ColumnPlan, shifted: bool) -> Vec<Ex<'g>> {
        let links = self.links;
        let mut tau = vec![links.number(0.0); links.inputs.dof];
        let (mut wrench, mut at, mut shifted) = (wrench, row, shifted);
        loop {
            let link = &links.links[at];
            if let (Some(k), Some(t)) = (link.dof, along_axis(link.kind, wrench.f, wrench.n)) {
                tau[k] = t;
            }
            if at == plan.moment {
                break;
            }
            wrench = wrench.inward(links, at, shifted);
            shifted = false;
            at -= 1;
        }
        // Joints up to `about`: in these axes, but with the moment about that frame's origin.
        let inner = if plan.about < at { plan.about + 1 } else { 0 };
        if inner > 0 {
            let mut p = Vec3::zero(links.graph);
            for between in inner..=at {
                let link = &links.links[between];
                p = link.unturn(link.untwist(p) + link.step(shifted && between == at));
            }
            let moved = Wrench { f: wrench.f, n: wrench.n + p.cross(wrench.f) };
            for (joint, k) in links.moving().filter(|(joint, _)| *joint < inner) {
                let own = if joint == plan.about {
                    Screw::own(links, joint)
                } else {
                    self.screws.get(joint, plan.about, false)
                };
                let v = (inner..=at).fold(own.v, |v, between| links.links[between].inward(v));
                tau[k] = Screw { w: self.screws.get(joint, at, shifted).w, v }.dot(&moved);
            }
        }
        let outer = || links.moving().filter(move |(joint, _)| (inner..at).contains(joint));
        if plan.force == at {
            for (joint, k) in outer() {
                tau[k] = self.screws.get(joint, at, shifted).dot(&wrench);
            }
            return tau;
        }
        // The point of application is kept; only the axes change.
        let (mut f, mut p) = (wrench.f, Vec3::zero(links.graph));
        for between in (plan.force + 1..=at).rev() {
            let link = &links.links[between];
            f = link.outward(f);
            p = link.outward(p) + link.twisted(link.step(shifted && between == at));
        }
        for (joint, k) in outer() {
            let here = self.screws.get(joint, at, shifted);
            let linear = match joint.cmp(&plan.force) {
                Ordering::Greater => here.v.dot(wrench.f),
                Ordering::Equal => Screw::own(links, joint).at(p).dot(f),
                Ordering::Less => self.screws.get(joint, plan.force, false).at(p).dot(f),
            };
            tau[k] = here.w.dot(wrench.n) + linear;
        }
        tau
    }

    /// Ten columns of a body at the tool frame (the last DH frame if there is no tool).
    pub fn payload(&self) -> Vec<Vec<Ex<'g>>> {
        let links = self.links;
        let last = links.links.len() - 1;
        let body = self.sweep.body(links, last, false);
        let g = links.graph;
        Inertial::ALL
            .iter()
            .map(|&which| {
                let wrench = match &links.tool {
                    None => Wrench::unit(&body, which),
                    Some(tool) => {
                        let (r, p) = (super::chain::tool_rotation(g, tool), crate::sym::Vec3::given(g, tool.1));
                        let back = r.transposed();
                        let motion = Motion::new(back * body.w, back * body.dw, back * body.at(p));
                        let Wrench { f, n } = Wrench::unit(&motion, which);
                        let (f, n) = (r * f, r * n);
                        Wrench { f, n: n + p.cross(f) }
                    }
                };
                g.section(format!("payload: column {which:?}"));
                self.torques(last, wrench.out_of_body(links, last), self.plan[last].columns[which as usize], false)
            })
            .collect()
    }
}
