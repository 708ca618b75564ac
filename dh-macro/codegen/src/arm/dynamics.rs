//! Inverse dynamics (Newton-Euler), mass matrix (composite bodies) and forward dynamics, for given parameters.

use super::chain::{Group, Links};
use super::motion::{Include, Sweep, along_axis};
use super::param::{DriveTerm, Inertial, Parameter};
use super::screw::Screw;
use super::wrench::Wrench;
use crate::sym::{Ex, Vec3};

/// Parameter values as expressions: zero where a parameter does not occur.
pub(super) struct Values<'g> {
    ten: Vec<[Ex<'g>; 10]>,
    drive: Vec<(usize, DriveTerm, Ex<'g>)>,
}

impl<'g> Values<'g> {
    /// Parameter input `k` is the value of `parameters[k]`; all others are zero.
    pub fn new(links: &Links<'g>, parameters: &[Parameter]) -> Self {
        let mut values = Self { ten: vec![[links.number(0.0); 10]; links.links.len()], drive: Vec::new() };
        for (k, parameter) in parameters.iter().enumerate() {
            let input = links.input(Group::Parameter, k);
            match *parameter {
                Parameter::Link(row, which) => values.ten[row][which as usize] = input,
                Parameter::Drive(row, term) => values.drive.push((row, term, input)),
            }
        }
        values
    }

    fn rotor(&self, row: usize) -> Option<Ex<'g>> {
        self.drive.iter().find(|(r, term, _)| *r == row && *term == DriveTerm::IA).map(|d| d.2)
    }
}

/// Torques by an outward and an inward sweep (Khalil and Dombre, 9.5.2); friction and rotors where `drives` says so.
pub(super) fn torques<'g>(links: &Links<'g>, values: &Values<'g>, include: Include, drives: bool) -> Vec<Ex<'g>> {
    let g = links.graph;
    let sweep = Sweep::new(links, include);
    let mut tau = vec![links.number(0.0); links.inputs.dof];
    let mut wrench = Wrench { f: Vec3::zero(g), n: Vec3::zero(g) };
    for (row, link) in links.links.iter().enumerate().rev() {
        g.section(format!("link {}: force and moment", row + 1));
        let body = Wrench::of_body(&sweep.body(links, row, false), &values.ten[row]).out_of_body(links, row);
        wrench = wrench.plus(body);
        wrench.f.label(&format!("f{}", row + 1));
        wrench.n.label(&format!("n{}", row + 1));
        if let (Some(k), Some(t)) = (link.dof, along_axis(link.kind, wrench.f, wrench.n)) {
            tau[k] = t;
        }
        wrench = wrench.inward(links, row, false);
    }
    if drives {
        g.section("drives");
        for &(row, term, value) in &values.drive {
            let Some(k) = links.links[row].dof else { continue };
            let (dq, ddq) = (links.input(Group::Velocity, k), links.input(Group::Acceleration, k));
            tau[k] = tau[k]
                + match term {
                    DriveTerm::IA if !include.acceleration => links.number(0.0),
                    DriveTerm::IA => value * ddq,
                    DriveTerm::FV => value * dq,
                    DriveTerm::FC => value * dq.sign(),
                    DriveTerm::FO => value,
                };
        }
    }
    tau
}

/// Ten parameters of a body carried from the joint frame of `row` to the previous joint frame.
fn carried<'g>(links: &Links<'g>, row: usize, p: [Ex<'g>; 10]) -> [Ex<'g>; 10] {
    let link = &links.links[row];
    let [m, lx, ly, lz, xx, yy, zz, xy, xz, yz] = p;
    // Turned about z; in halves of sum and difference it would be two products less and three sums more.
    let tensor = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]];
    let rotate = |t: [[Ex<'g>; 3]; 3], turn: &dyn Fn(Vec3<'g>) -> Vec3<'g>| -> [[Ex<'g>; 3]; 3] {
        let half = t.map(|row| turn(Vec3(row)).0); // T R'
        let columns: [[Ex<'g>; 3]; 3] = core::array::from_fn(|j| turn(Vec3(core::array::from_fn(|i| half[i][j]))).0); // R (T R')
        core::array::from_fn(|i| core::array::from_fn(|j| if i <= j { columns[j][i] } else { columns[i][j] }))
    };
    let t = rotate(tensor, &|v| link.turned(v));
    let l = link.turned(Vec3([lx, ly, lz]));
    // To the origin of the frame before, along x and z: I' = I + (2 l.s + m s.s) E - (l s' + s l') - m s s'.
    let s = link.step(false);
    let ls = l + s.scale(m);
    let trace = s.dot(l + ls);
    let t: [[Ex<'g>; 3]; 3] = core::array::from_fn(|i| {
        core::array::from_fn(|j| {
            let diagonal = if i == j { trace } else { links.number(0.0) };
            t[i][j] + diagonal - (l.0[i] * s.0[j] + s.0[i] * ls.0[j])
        })
    });
    let l = link.twisted(ls);
    let t = rotate(t, &|v| link.twisted(v));
    [m, l.0[0], l.0[1], l.0[2], t[0][0], t[1][1], t[2][2], t[0][1], t[0][2], t[1][2]]
}

/// Upper triangle of the mass matrix, `m[i][j]` for `i <= j`, by composite bodies (Featherstone, 6.2; the rotors on the diagonal).
pub(super) fn mass_matrix<'g>(links: &Links<'g>, values: &Values<'g>) -> Vec<Vec<Ex<'g>>> {
    let g = links.graph;
    let n = links.inputs.dof;
    let mut mass = vec![vec![links.number(0.0); n]; n];
    let mut composite = [links.number(0.0); 10];
    for (row, link) in links.links.iter().enumerate().rev() {
        g.section(format!("composite body {}", row + 1));
        let own = out_of_body(links, row, values.ten[row]);
        composite = core::array::from_fn(|k| composite[k] + own[k]);
        if let Some(k) = link.dof {
            // Momentum of the composite body for a unit velocity of this joint.
            let [m, lx, ly, lz, _, _, zz, _, xz, yz] = composite;
            let screw = Screw::own(links, row);
            let mut momentum = match link.kind {
                crate::robot::JointKind::Revolute => {
                    Wrench { f: Vec3([-ly, lx, links.number(0.0)]), n: Vec3([xz, yz, zz]) }
                }
                _ => {
                    Wrench { f: Vec3([links.number(0.0), links.number(0.0), m]), n: Vec3([ly, -lx, links.number(0.0)]) }
                }
            };
            let _ = lz;
            mass[k][k] = screw.dot(&momentum);
            if let Some(rotor) = values.rotor(row) {
                mass[k][k] = mass[k][k] + rotor;
            }
            for inner in (0..row).rev() {
                momentum = momentum.inward(links, inner + 1, false);
                if let Some(i) = links.links[inner].dof {
                    mass[i][k] = Screw::own(links, inner).dot(&momentum);
                }
            }
        }
        composite = carried(links, row, composite);
    }
    mass
}

/// Parameters given in the body's frame, in the joint frame.
fn out_of_body<'g>(links: &Links<'g>, row: usize, p: [Ex<'g>; 10]) -> [Ex<'g>; 10] {
    let link = &links.links[row];
    if !link.has_body_frame() {
        return p;
    }
    let at = |which: Inertial| p[which as usize];
    let l = link.out_of_body(Vec3([at(Inertial::MSX), at(Inertial::MSY), at(Inertial::MSZ)]));
    let t = [
        [at(Inertial::XX), at(Inertial::XY), at(Inertial::XZ)],
        [at(Inertial::XY), at(Inertial::YY), at(Inertial::YZ)],
        [at(Inertial::XZ), at(Inertial::YZ), at(Inertial::ZZ)],
    ];
    let half = t.map(|row| link.out_of_body(Vec3(row)).0);
    let full: [[Ex<'g>; 3]; 3] =
        core::array::from_fn(|j| link.out_of_body(Vec3(core::array::from_fn(|i| half[i][j]))).0);
    let s = link.body_origin();
    let ls = l + s.scale(at(Inertial::M));
    let trace = s.dot(l + ls);
    let entry = |i: usize, j: usize| {
        let diagonal = if i == j { trace } else { links.number(0.0) };
        full[j][i] + diagonal - (l.0[i] * s.0[j] + s.0[i] * ls.0[j])
    };
    [
        at(Inertial::M),
        ls.0[0],
        ls.0[1],
        ls.0[2],
        entry(0, 0),
        entry(1, 1),
        entry(2, 2),
        entry(0, 1),
        entry(0, 2),
        entry(1, 2),
    ]
}

/// `ddq` from `M ddq = tau - bias`, by `M = L D L'` written out.
pub(super) fn solve<'g>(links: &Links<'g>, mass: &[Vec<Ex<'g>>], right: &[Ex<'g>]) -> Vec<Ex<'g>> {
    let n = right.len();
    let one = links.number(1.0);
    links.graph.section("M = L D L'");
    // l[i][j] for j < i; the reciprocal of d is shared.
    let mut l = vec![vec![links.number(0.0); n]; n];
    let mut d = Vec::with_capacity(n);
    let mut inverse = Vec::with_capacity(n);
    for j in 0..n {
        let mut pivot = mass[j][j];
        for k in 0..j {
            pivot = pivot - l[j][k] * l[j][k] * d[k];
        }
        d.push(pivot);
        inverse.push(one / pivot);
        for i in j + 1..n {
            let mut entry = mass[j][i];
            for k in 0..j {
                entry = entry - l[i][k] * (l[j][k] * d[k]);
            }
            l[i][j] = entry * inverse[j];
        }
    }
    links.graph.section("ddq");
    let mut x = right.to_vec();
    for i in 0..n {
        for k in 0..i {
            x[i] = x[i] - l[i][k] * x[k];
        }
    }
    for i in 0..n {
        x[i] = x[i] * inverse[i];
    }
    for i in (0..n).rev() {
        for k in i + 1..n {
            x[i] = x[i] - l[k][i] * x[k];
        }
    }
    x
}
