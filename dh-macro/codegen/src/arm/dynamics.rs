//! Inverse dynamics (Newton-Euler), mass matrix (composite bodies) and forward dynamics, for given
//! parameters.

use core::array::from_fn;

use super::chain::{Group, Links};
use super::motion::{Include, Sweep, along_axis};
use super::param::{DriveTerm, Parameter};
use super::screw::Screw;
use super::turning::moments;
use super::wrench::Wrench;
use crate::sym::{Ex, Vec3};

/// Parameter values as expressions; zero for parameters that do not occur.
pub(super) struct Values<'g> {
    ten: Vec<[Ex<'g>; 10]>,
    drive: Vec<(usize, DriveTerm, Ex<'g>)>,
}

impl<'g> Values<'g> {
    /// Takes parameter input `k` as the value of `parameters[k]`; all others are zero.
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

    /// Drive parameter; `None` if the model lacks it.
    pub fn drive(&self, row: usize, term: DriveTerm) -> Option<Ex<'g>> {
        self.drive.iter().find(|(r, t, _)| *r == row && *t == term).map(|d| d.2)
    }

    fn rotor(&self, row: usize) -> Option<Ex<'g>> {
        self.drive(row, DriveTerm::IA)
    }
}

/// Torques by an outward and an inward sweep (Khalil and Dombre, 9.5.2), with friction and rotors
/// if `drives` is set. `slide`: the last link's parameters and motion are taken about the origin
/// before `TransZ(r)`, which gives the same torques by other operations.
pub(super) fn torques<'g>(
    links: &Links<'g>,
    values: &Values<'g>,
    include: Include,
    drives: bool,
    slide: bool,
) -> Vec<Ex<'g>> {
    let g = links.graph;
    let sweep = Sweep::new(links, include);
    let mut tau = vec![links.number(0.0); links.inputs.dof];
    let mut wrench = Wrench { f: Vec3::zero(g), n: Vec3::zero(g) };
    // Moments along a joint's axis, added when the sweep reaches that joint, since no joint further
    // out needs them.
    let mut along = vec![links.number(0.0); links.links.len()];
    for (row, link) in links.links.iter().enumerate().rev() {
        g.section(format!("link {}: force and moment", row + 1));
        let slides = slide && row + 1 == links.links.len();
        let motion = sweep.body(links, row, slides);
        let ten = if slides { slid(links, row, values.ten[row]) } else { values.ten[row] };
        let body = match sweep.turning[row].two() {
            Some((first, own)) if !link.has_body_frame() => {
                let (along_first, along_own) = moments(&first, &own, &ten);
                along[first.row] = along[first.row] + along_first;
                along[row] = along[row] + along_own;
                Wrench::of_moments(&motion, &ten)
            }
            _ => Wrench::of_body(&motion, &ten).out_of_body(links, row),
        };
        wrench = wrench.plus(body);
        wrench.n.0[2] = wrench.n.0[2] + along[row];
        wrench.f.label(&format!("f{}", row + 1));
        wrench.n.label(&format!("n{}", row + 1));
        if let (Some(k), Some(t)) = (link.dof, along_axis(link.kind, wrench.f, wrench.n)) {
            tau[k] = t;
        }
        wrench = wrench.inward(links, row, slides);
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

/// Symmetric tensor.
type Tensor<'g> = [[Ex<'g>; 3]; 3];

/// Rotated tensor `R T R'`, for the rotation of vectors by `turn`.
fn turned<'g>(t: Tensor<'g>, turn: impl Fn(Vec3<'g>) -> Vec3<'g>) -> Tensor<'g> {
    let half = t.map(|row| turn(Vec3(row)).0); // T R'
    let columns: Tensor<'g> = from_fn(|j| turn(Vec3(from_fn(|i| half[i][j]))).0);
    from_fn(|i| from_fn(|j| if i <= j { columns[j][i] } else { columns[i][j] }))
}

/// First moments and tensor about the origin relative to which the present one is at `s`: `l + m
/// s`, `I + (2 l.s + m s.s) E - (l s' + s l') - m s s'`.
fn shifted<'g>(links: &Links<'g>, m: Ex<'g>, l: Vec3<'g>, t: Tensor<'g>, s: Vec3<'g>) -> (Vec3<'g>, Tensor<'g>) {
    let ls = l + s.scale(m);
    let trace = s.dot(l + ls);
    let entry = |i: usize, j: usize| {
        let diagonal = if i == j { trace } else { links.number(0.0) };
        t[i][j] + diagonal - (l.0[i] * s.0[j] + s.0[i] * ls.0[j])
    };
    (ls, from_fn(|i| from_fn(|j| entry(i.min(j), i.max(j)))))
}

/// Splits ten parameters into mass, first moments and tensor.
fn apart<'g>([m, lx, ly, lz, xx, yy, zz, xy, xz, yz]: [Ex<'g>; 10]) -> (Ex<'g>, Vec3<'g>, Tensor<'g>) {
    (m, Vec3([lx, ly, lz]), [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
}

fn together<'g>(m: Ex<'g>, l: Vec3<'g>, t: Tensor<'g>) -> [Ex<'g>; 10] {
    [m, l.0[0], l.0[1], l.0[2], t[0][0], t[1][1], t[2][2], t[0][1], t[0][2], t[1][2]]
}

/// Transforms a body's ten parameters from the joint frame of `row` to the previous joint frame.
fn carried<'g>(links: &Links<'g>, row: usize, p: [Ex<'g>; 10]) -> [Ex<'g>; 10] {
    let link = &links.links[row];
    let (m, l, t) = apart(p);
    let t = turned(t, |v| link.turned(v));
    let (l, t) = shifted(links, m, link.turned(l), t, link.step(false));
    let l = link.twisted(l);
    together(m, l, turned(t, |v| link.twisted(v)))
}

/// Upper triangle of the mass matrix, `m[i][j]` for `i <= j`, by composite bodies (Featherstone,
/// 6.2; with the rotors on the diagonal).
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
            let [m, lx, ly, _, _, _, zz, _, xz, yz] = composite;
            let screw = Screw::own(links, row);
            let mut momentum = match link.kind {
                crate::robot::JointKind::Revolute => {
                    Wrench { f: Vec3([-ly, lx, links.number(0.0)]), n: Vec3([xz, yz, zz]) }
                }
                _ => {
                    Wrench { f: Vec3([links.number(0.0), links.number(0.0), m]), n: Vec3([ly, -lx, links.number(0.0)]) }
                }
            };
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

/// Ten parameters of a row about the origin before `TransZ(r)`.
fn slid<'g>(links: &Links<'g>, row: usize, p: [Ex<'g>; 10]) -> [Ex<'g>; 10] {
    let none = links.number(0.0);
    let (m, l, t) = apart(p);
    let (l, t) = shifted(links, m, l, t, Vec3([none, none, links.links[row].r]));
    together(m, l, t)
}

/// Transforms parameters from the body's frame to the joint frame.
fn out_of_body<'g>(links: &Links<'g>, row: usize, p: [Ex<'g>; 10]) -> [Ex<'g>; 10] {
    let link = &links.links[row];
    if !link.has_body_frame() {
        return p;
    }
    let (m, l, t) = apart(p);
    let t = turned(t, |v| link.out_of_body(v));
    let (l, t) = shifted(links, m, link.out_of_body(l), t, link.body_origin());
    together(m, l, t)
}

/// Solves `M ddq = tau - bias` for `ddq` by an explicit `M = L D L'`.
pub(super) fn solve<'g>(links: &Links<'g>, mass: &[Vec<Ex<'g>>], right: &[Ex<'g>]) -> Vec<Ex<'g>> {
    let n = right.len();
    let one = links.number(1.0);
    links.graph.section("M = L D L'");
    // Entries l[i][j] for j < i; the reciprocal of d is shared.
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
