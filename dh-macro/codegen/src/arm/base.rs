//! Base parameters in closed form: which standard parameters have an independent effect, and how
//! the others are grouped.
//!
//! Gautier and Khalil's regrouping (Khalil and Dombre, 9.4) in a form for every geometry. The
//! energies are linear in the parameters: link `j` contributes `delta . e_j(q, dq)`. A change
//! `delta` of link `j`'s parameters is invisible to its own joint exactly if `delta . e_j` does not
//! depend on `q_j` and `dq_j`. It is then equivalent to the change made by the moved body on link
//! `j - 1`. The condition is linear and must hold for the span of all motions that the preceding
//! joints can produce. The span is therefore propagated outwards (subspaces of dimension at most
//! ten), each link's null space is computed, and the regrouping proceeds inwards with the lengths
//! as named constants.

use std::collections::BTreeMap;

use super::param::{DriveTerm, Inertial, Parameter, standard};
use super::subspace::Subspace;
use crate::robot::{Convention, JointKind, Polynomial, Robot};

/// A base parameter and its grouping.
#[derive(Debug, Clone, PartialEq)]
pub struct BaseParameter {
    /// Standard parameter whose column is kept.
    pub leader: Parameter,
    /// Name of the leader, with `R` appended if it groups others.
    pub name: String,
    /// Grouping formula `ZZ2R = ZZ2 + ...` in the constants of the file.
    pub grouping: String,
    /// Indices into [`standard`] and factors, ascending.
    pub coefficients: Vec<(usize, f64)>,
    /// The same factors as polynomials in the constants of the file.
    pub closed_forms: Vec<Polynomial>,
}

impl BaseParameter {
    /// Whether it consists of its leader alone.
    pub fn stands_alone(&self) -> bool {
        self.coefficients.len() == 1 && self.coefficients[0].1 == 1.0
    }
}

/// The base parameters of a robot, in the order of the base regressor's columns.
#[derive(Debug, Clone, PartialEq)]
pub struct BaseParameters(pub Vec<BaseParameter>);

/// Numbers or polynomials, in which a regrouping is computed.
trait Ring: Clone {
    fn zero() -> Self;
    fn plus(&self, other: &Self) -> Self;
    fn times(&self, factor: f64) -> Self;
    fn by(&self, other: &Self) -> Self;
}

impl Ring for f64 {
    fn zero() -> Self {
        0.0
    }
    fn plus(&self, other: &Self) -> Self {
        self + other
    }
    fn times(&self, factor: f64) -> Self {
        self * factor
    }
    fn by(&self, other: &Self) -> Self {
        self * other
    }
}

impl Ring for Polynomial {
    fn zero() -> Self {
        Self::default()
    }
    fn plus(&self, other: &Self) -> Self {
        self.add(other)
    }
    fn times(&self, factor: f64) -> Self {
        self.scale(factor)
    }
    fn by(&self, other: &Self) -> Self {
        self.mul(other)
    }
}

/// Ten inertial parameters `M MSX MSY MSZ XX YY ZZ XY XZ YZ`.
type Ten<T> = [T; 10];

const M: usize = Inertial::M as usize;
const MSX: usize = Inertial::MSX as usize;
const MSY: usize = Inertial::MSY as usize;
const MSZ: usize = Inertial::MSZ as usize;
const XX: usize = Inertial::XX as usize;
const YY: usize = Inertial::YY as usize;
const ZZ: usize = Inertial::ZZ as usize;
const XY: usize = Inertial::XY as usize;
const XZ: usize = Inertial::XZ as usize;
const YZ: usize = Inertial::YZ as usize;
/// Indices of the two drive terms that can be grouped with inertial ones.
const IA: usize = 10;
const FO: usize = 11;

/// Parameters of the body about an origin that is shifted back by `s` along the axis with first
/// moment `along`. `i`, `j` are the diagonal entries across; `products` are those with the other
/// two first moments.
fn translated<T: Ring>(v: &Ten<T>, s: &T, along: usize, [i, j]: [usize; 2], products: [(usize, usize); 2]) -> Ten<T> {
    let mut out = v.clone();
    let across = v[along].by(s).times(2.0).plus(&v[M].by(s).by(s));
    out[along] = v[along].plus(&v[M].by(s));
    out[i] = v[i].plus(&across);
    out[j] = v[j].plus(&across);
    for (product, moment) in products {
        out[product] = v[product].plus(&v[moment].by(s).times(-1.0));
    }
    out
}

fn trans_x<T: Ring>(v: &Ten<T>, d: &T) -> Ten<T> {
    translated(v, d, MSX, [YY, ZZ], [(XY, MSY), (XZ, MSZ)])
}

fn trans_z<T: Ring>(v: &Ten<T>, r: &T) -> Ten<T> {
    translated(v, r, MSZ, [XX, YY], [(XZ, MSX), (YZ, MSY)])
}

/// Linear combination `a x + b y`.
fn mix<T: Ring>(a: f64, x: &T, b: f64, y: &T) -> T {
    x.times(a).plus(&y.times(b))
}

fn rot_x<T: Ring>(v: &Ten<T>, (s, c): (f64, f64)) -> Ten<T> {
    let mut out = v.clone();
    out[MSY] = mix(c, &v[MSY], -s, &v[MSZ]);
    out[MSZ] = mix(s, &v[MSY], c, &v[MSZ]);
    out[XY] = mix(c, &v[XY], -s, &v[XZ]);
    out[XZ] = mix(s, &v[XY], c, &v[XZ]);
    out[YY] = mix(c * c, &v[YY], s * s, &v[ZZ]).plus(&v[YZ].times(-2.0 * c * s));
    out[ZZ] = mix(s * s, &v[YY], c * c, &v[ZZ]).plus(&v[YZ].times(2.0 * c * s));
    out[YZ] = mix(c * s, &v[YY], -c * s, &v[ZZ]).plus(&v[YZ].times(c * c - s * s));
    out
}

fn rot_z<T: Ring>(v: &Ten<T>, (s, c): (f64, f64)) -> Ten<T> {
    let mut out = v.clone();
    out[MSX] = mix(c, &v[MSX], -s, &v[MSY]);
    out[MSY] = mix(s, &v[MSX], c, &v[MSY]);
    out[XZ] = mix(c, &v[XZ], -s, &v[YZ]);
    out[YZ] = mix(s, &v[XZ], c, &v[YZ]);
    out[XX] = mix(c * c, &v[XX], s * s, &v[YY]).plus(&v[XY].times(-2.0 * c * s));
    out[YY] = mix(s * s, &v[XX], c * c, &v[YY]).plus(&v[XY].times(2.0 * c * s));
    out[XY] = mix(c * s, &v[XX], -c * s, &v[YY]).plus(&v[XY].times(c * c - s * s));
    out
}

/// A linear map of parameters.
type Order = fn(&Ten<f64>) -> Ten<f64>;

/// Effect of a joint's motion on a body's parameters, term by term. First the constant part, then
/// the coefficients of `cos q, sin q, cos 2q, sin 2q` (revolute) or `q, q^2` (prismatic).
fn harmonics(kind: JointKind) -> Vec<Order> {
    match kind {
        JointKind::Revolute => vec![
            constant_part::<f64>,
            |v| pick(v, &[(MSX, 1.0, MSX), (MSY, 1.0, MSY), (XZ, 1.0, XZ), (YZ, 1.0, YZ)]),
            |v| pick(v, &[(MSX, -1.0, MSY), (MSY, 1.0, MSX), (XZ, -1.0, YZ), (YZ, 1.0, XZ)]),
            |v| pick(v, &[(XX, 0.5, XX), (XX, -0.5, YY), (YY, -0.5, XX), (YY, 0.5, YY), (XY, 1.0, XY)]),
            |v| pick(v, &[(XX, -1.0, XY), (YY, 1.0, XY), (XY, 0.5, XX), (XY, -0.5, YY)]),
        ],
        JointKind::Prismatic => vec![
            |v| *v,
            |v| pick(v, &[(MSZ, 1.0, M), (XX, 2.0, MSZ), (YY, 2.0, MSZ), (XZ, -1.0, MSX), (YZ, -1.0, MSY)]),
            |v| pick(v, &[(XX, 1.0, M), (YY, 1.0, M)]),
        ],
        JointKind::Fixed => vec![|v| *v],
    }
}

/// Average parameters of a body that rotates about z.
fn constant_part<T: Ring>(v: &Ten<T>) -> Ten<T> {
    let mean = mix(0.5, &v[XX], 0.5, &v[YY]);
    let mut out: Ten<T> = core::array::from_fn(|_| T::zero());
    out[M] = v[M].clone();
    out[MSZ] = v[MSZ].clone();
    out[ZZ] = v[ZZ].clone();
    out[XX] = mean.clone();
    out[YY] = mean;
    out
}

/// Product of a sparse matrix with `v`; entries `(row, factor, column)`.
fn pick(v: &Ten<f64>, entries: &[(usize, f64, usize)]) -> Ten<f64> {
    let mut out = [0.0; 10];
    for &(row, factor, column) in entries {
        out[row] += factor * v[column];
    }
    out
}

/// Transformation of parameters from a body's frame to the previous frame by one row of the DH
/// table: `before . joint . after`.
struct Step {
    kind: JointKind,
    convention: Convention,
    alpha: (f64, f64),
    theta: (f64, f64),
    d: (f64, Polynomial),
    r: (f64, Polynomial),
}

impl Step {
    fn all(robot: &Robot) -> Vec<Self> {
        let length = |l: &crate::robot::Length| (l.value, l.closed_form.clone());
        robot
            .joints
            .iter()
            .map(|j| Self {
                kind: j.kind,
                convention: robot.convention,
                alpha: j.alpha.sin_cos(),
                theta: j.theta.sin_cos(),
                d: length(&j.d),
                r: length(&j.r),
            })
            .collect()
    }

    /// Transforms from the body's frame to the axes of the joint's motion.
    fn after<T: Ring>(&self, v: &Ten<T>, d: &T, r: &T) -> Ten<T> {
        let v = match self.convention {
            Convention::Modified => v.clone(),
            Convention::Standard => trans_x(&rot_x(v, self.alpha), d),
        };
        let v = trans_z(&v, r);
        if self.kind == JointKind::Revolute { v } else { rot_z(&v, self.theta) }
    }

    /// Transforms from those axes to the previous frame.
    fn before<T: Ring>(&self, v: &Ten<T>, d: &T) -> Ten<T> {
        match self.convention {
            Convention::Modified => rot_x(&trans_x(v, d), self.alpha),
            Convention::Standard => v.clone(),
        }
    }

    /// Constant part of the whole transformation, with the lengths as polynomials.
    fn constant(&self, v: &Ten<Polynomial>) -> Ten<Polynomial> {
        let turned = self.after(v, &self.d.1, &self.r.1);
        let turned = if self.kind == JointKind::Revolute { constant_part(&turned) } else { turned };
        self.before(&turned, &self.d.1)
    }

    /// Velocity `(w, v)` of the previous frame, expressed at the joint's axes.
    fn arriving(&self, x: &[f64]) -> [f64; 6] {
        match self.convention {
            Convention::Modified => {
                let ((s, c), d) = (self.alpha, self.d.0);
                let turn = |y: f64, z: f64| (c * y + s * z, c * z - s * y);
                let ((wy, wz), (vy, vz)) = (turn(x[1], x[2]), turn(x[4], x[5]));
                [x[0], wy, wz, x[3], vy + wz * d, vz - wy * d]
            }
            Convention::Standard => core::array::from_fn(|k| x[k]),
        }
    }

    /// Velocity at the joint's axes, expressed in the body's frame, with the joint at `q` (in
    /// quarter turns or as a length).
    fn leaving(&self, x: &[f64; 6], q: f64) -> [f64; 6] {
        let (turn, slide) = match self.kind {
            JointKind::Revolute => ([(0.0, 1.0), (1.0, 0.0), (0.0, -1.0)][q as usize], 0.0),
            JointKind::Prismatic => (self.theta, q),
            JointKind::Fixed => (self.theta, 0.0),
        };
        let ((s, c), r) = (turn, self.r.0 + slide);
        let about_z = |x: f64, y: f64| (c * x + s * y, c * y - s * x);
        let (vx, vy) = (x[3] + x[1] * r, x[4] - x[0] * r);
        let ((wx, wy), (vx, vy)) = (about_z(x[0], x[1]), about_z(vx, vy));
        let here = [wx, wy, x[2], vx, vy, x[5]];
        match self.convention {
            Convention::Modified => here,
            Convention::Standard => {
                let ((s, c), d) = (self.alpha, self.d.0);
                let turn = |y: f64, z: f64| (c * y + s * z, c * z - s * y);
                let (vy, vz) = (here[4] + here[2] * d, here[5] - here[1] * d);
                let ((wy, wz), (vy, vz)) = (turn(here[1], here[2]), turn(vy, vz));
                [here[0], wy, wz, here[3], vy, vz]
            }
        }
    }
}

/// Transposed map: the row `r` with `r . v = row . f(v)`.
fn pulled_back(row: &[f64], f: impl Fn(&Ten<f64>) -> Ten<f64>) -> Ten<f64> {
    core::array::from_fn(|k| {
        let mut unit = [0.0; 10];
        unit[k] = 1.0;
        f(&unit).iter().zip(row).map(|(a, b)| a * b).sum()
    })
}

/// Momentum along or about the joint's axis per unit of each parameter, if its frame moves with
/// `(w, v)`.
fn momentum(kind: JointKind, x: &[f64; 6]) -> Ten<f64> {
    let mut row = [0.0; 10];
    match kind {
        JointKind::Revolute => {
            (row[XZ], row[YZ], row[ZZ], row[MSX], row[MSY]) = (x[0], x[1], x[2], x[4], -x[3]);
        }
        JointKind::Prismatic => (row[M], row[MSY], row[MSX]) = (x[5], x[0], -x[1]),
        JointKind::Fixed => {}
    }
    row
}

/// Everything that the preceding joints reveal about a body fixed to the present frame.
struct Reach {
    /// Velocities `(w, v)`.
    velocities: Subspace,
    /// Rows of the kinetic energy.
    kinetic: Subspace,
    /// Rows of the potential energy, with a constant row as eleventh entry.
    potential: Subspace,
}

impl Reach {
    fn base(gravity: [f64; 3]) -> Self {
        let mut potential = Subspace::default();
        let [x, y, z] = gravity.map(|g| -g);
        potential.insert(&[0.0, x, y, z, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]);
        Self { velocities: Subspace::default(), kinetic: Subspace::default(), potential }
    }

    /// Conditions on the parameters of the link behind `step` (ten, `IA`, `FO`) under which they
    /// are invisible to its own joint; and the reach of that link.
    fn through(&self, step: &Step) -> (Subspace, Self) {
        let (d, r) = (step.d.0, step.r.0);
        let mut hidden = Subspace::default();
        let mut reach =
            Self { velocities: Subspace::default(), kinetic: Subspace::default(), potential: Subspace::default() };
        let orders = harmonics(step.kind);
        let row12 = |row: &Ten<f64>, ia: f64, fo: f64| -> Vec<f64> { row.iter().copied().chain([ia, fo]).collect() };
        let seen = |row: &[f64], order: Order| pulled_back(row, |v| order(&step.after(v, &d, &r)));
        let before = |row: &[f64]| pulled_back(row, |v| step.before(v, &d));

        let mut own = [0.0; 6];
        match step.kind {
            JointKind::Revolute => own[2] = 1.0,
            JointKind::Prismatic => own[5] = 1.0,
            JointKind::Fixed => {}
        }
        if step.kind != JointKind::Fixed {
            let square = seen(&momentum(step.kind, &own), |v| *v);
            hidden.insert(&row12(&square, 1.0, 0.0));
            reach.kinetic.insert(&square);
        }
        for x in self.velocities.rows() {
            let x = step.arriving(x);
            for &order in &orders {
                let row = seen(&momentum(step.kind, &x), order);
                if step.kind != JointKind::Fixed {
                    hidden.insert(&row12(&row, 0.0, 0.0));
                    reach.kinetic.insert(&row);
                }
            }
        }
        for e in self.kinetic.rows() {
            let e = before(e);
            for (k, &order) in orders.iter().enumerate() {
                let row = seen(&e, order);
                reach.kinetic.insert(&row);
                if k > 0 {
                    hidden.insert(&row12(&row, 0.0, 0.0));
                }
            }
        }
        for e in self.potential.rows() {
            let (e, one) = (before(&e[..10]), e[10]);
            for (k, &order) in orders.iter().enumerate() {
                let row = seen(&e, order);
                let constant = if k == 0 { one } else { 0.0 };
                reach.potential.insert(&row.iter().copied().chain([constant]).collect::<Vec<_>>());
                if k > 0 {
                    let offset = if step.kind == JointKind::Prismatic && k == 1 { one } else { 0.0 };
                    hidden.insert(&row12(&row, 0.0, offset));
                }
            }
        }
        if step.kind == JointKind::Revolute {
            hidden.insert(&row12(&[0.0; 10], 0.0, 1.0)); // a constant torque is no inertial effect
        }
        let stands: &[f64] = match step.kind {
            JointKind::Revolute => &[0.0, 1.0, 2.0], // quarter turns: enough for 1, cos q, sin q
            JointKind::Prismatic => &[0.0, 1.0],
            JointKind::Fixed => &[0.0],
        };
        for &q in stands {
            reach.velocities.insert(&step.leaving(&own, q));
            for x in self.velocities.rows() {
                reach.velocities.insert(&step.leaving(&step.arriving(x), q));
            }
        }
        (hidden, reach)
    }
}

/// Preference among a link's parameters to be kept, highest first, as is customary in the
/// literature. (Keeping `YY` instead of `XX` changes the base regressors of the arms in `robots/`
/// by less than half a per cent, either way.)
///
/// `FO` is dropped first if a prismatic joint's weight, rotor and offset can't be separated. Mass
/// matrix and torques are then right; only the gravity torque from base parameters contains the
/// offset.
const PREFERENCE: [usize; 12] = [ZZ, MSY, MSX, YZ, XZ, XY, XX, YY, MSZ, M, IA, FO];

impl BaseParameters {
    /// Groups the standard parameters of a robot.
    pub fn new(robot: &Robot) -> Self {
        let parameters = standard(robot);
        let index: BTreeMap<Parameter, usize> = parameters.iter().enumerate().map(|(i, &p)| (p, i)).collect();
        let of_row = |row: usize, k: usize| match k {
            IA => Parameter::Drive(row, DriveTerm::IA),
            FO => Parameter::Drive(row, DriveTerm::FO),
            k => Parameter::Link(row, Inertial::ALL[k]),
        };
        let steps = Step::all(robot);
        let mut reach = Reach::base(robot.base_gravity());
        let mut hidden = Vec::with_capacity(steps.len());
        for step in &steps {
            let (conditions, next) = reach.through(step);
            hidden.push(conditions);
            reach = next;
        }

        // Each standard parameter starts as itself; a dropped one passes on what it has gathered.
        type Form = BTreeMap<usize, Polynomial>;
        let mut forms: Vec<Option<Form>> =
            (0..parameters.len()).map(|i| Some(Form::from([(i, Polynomial::number(1.0))]))).collect();
        let hand_on = |forms: &mut Vec<Option<Form>>, to: usize, what: &Form, factor: &Polynomial| {
            if let Some(form) = &mut forms[to] {
                for (&i, c) in what {
                    let sum = form.get(&i).cloned().unwrap_or_default().add(&c.mul(factor));
                    if sum.is_zero() {
                        form.remove(&i)
                    } else {
                        form.insert(i, sum)
                    };
                }
            }
        };
        for (row, step) in steps.iter().enumerate().rev() {
            let mut conditions = hidden[row].clone();
            for k in [IA, FO] {
                if !index.contains_key(&of_row(row, k)) {
                    let mut absent = vec![0.0; 12];
                    absent[k] = 1.0;
                    conditions.insert(&absent);
                }
            }
            for (free, vector) in conditions.null_space(&PREFERENCE) {
                let Some(gathered) = forms[index[&of_row(row, free)]].take() else { continue };
                for (k, &factor) in vector.iter().enumerate().filter(|&(k, f)| k != free && *f != 0.0) {
                    hand_on(&mut forms, index[&of_row(row, k)], &gathered, &Polynomial::number(-factor));
                }
                if row > 0 {
                    let body: Ten<Polynomial> = core::array::from_fn(|k| Polynomial::number(vector[k]));
                    for (k, factor) in step.constant(&body).iter().enumerate().filter(|(_, f)| !f.is_zero()) {
                        hand_on(&mut forms, index[&of_row(row - 1, k)], &gathered, factor);
                    }
                }
            }
        }
        let constants = unlike_parameters(&robot.constants, &parameters);
        let base = parameters.iter().zip(forms).filter_map(|(&leader, form)| {
            let form = form?;
            let groups = form.len() > 1;
            let name = format!("{}{}", leader.name(), if groups { "R" } else { "" });
            let grouping = grouping_text(&name, index[&leader], &form, &parameters, &constants);
            let coefficients = form.iter().map(|(&i, c)| (i, c.value(&robot.constants))).collect();
            Some(BaseParameter { leader, name, grouping, coefficients, closed_forms: form.into_values().collect() })
        });
        Self(base.collect())
    }

    /// Number of base parameters.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there are no base parameters.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Values from those of the standard parameters, `beta = K phi`.
    pub fn values(&self, standard: &[f64]) -> Vec<f64> {
        self.0.iter().map(|b| b.coefficients.iter().map(|&(i, c)| c * standard[i]).sum()).collect()
    }
}

/// Constants as written in groupings: `constants.M2` if a parameter has the same name.
fn unlike_parameters(constants: &[(String, f64)], parameters: &[Parameter]) -> Vec<(String, f64)> {
    let names: Vec<String> = parameters.iter().map(|p| p.name()).collect();
    let is_parameter = |word: &str| names.iter().any(|n| word == n || word == format!("{n}R"));
    let one = |(word, value): &(String, f64)| match is_parameter(word) {
        true => (format!("constants.{word}"), *value),
        false => (word.clone(), *value),
    };
    constants.iter().map(one).collect()
}

/// Grouping formula, `ZZ1R = ZZ1 + YY2 + L2^2*(M3 + M4)`: parameters with the same factor are
/// collected.
fn grouping_text(
    name: &str,
    leader: usize,
    form: &BTreeMap<usize, Polynomial>,
    parameters: &[Parameter],
    constants: &[(String, f64)],
) -> String {
    let mut text = format!("{name} = {}", parameters[leader].name());
    let mut factors: Vec<(Polynomial, Vec<String>)> = Vec::new();
    for (&i, factor) in form.iter().filter(|&(&i, _)| i != leader) {
        let parameter = parameters[i].name();
        match factors.iter_mut().find(|(f, _)| f == factor) {
            Some((_, list)) => list.push(parameter),
            None => factors.push((factor.clone(), vec![parameter])),
        }
    }
    for (factor, list) in factors {
        let written = factor.text(constants);
        let (sign, size) = match written.strip_prefix('-') {
            Some(rest) if factor.len() == 1 => ("-", rest.to_string()),
            _ => ("+", written),
        };
        let size = if factor.len() > 1 { format!("({size})") } else { size };
        let plain = size == "1";
        text += &match (plain, list.len()) {
            (true, _) => list.iter().map(|p| format!(" {sign} {p}")).collect::<String>(),
            (false, 1) => format!(" {sign} {size}*{}", list[0]),
            (false, _) => format!(" {sign} {size}*({})", list.join(" + ")),
        };
    }
    text
}
