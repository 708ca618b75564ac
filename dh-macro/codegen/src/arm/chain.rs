//! Common form of both DH conventions: a chain of *joint frames* whose z axes are the joint axes.
//!
//! Modified rows form that chain already: `RotX(alpha) TransX(d) RotZ(theta) TransZ(r)`, and the
//! body's frame is the joint frame. In a standard row `RotZ(theta) TransZ(r) TransX(d) RotX(alpha)`
//! the last two factors commute, so they become the first two of the next joint frame. The body's
//! frame is the joint frame followed by them.

use crate::robot::{Convention, JointKind, Robot};
use crate::sym::{Call, Ex, Graph, Mat3, Vec3};

/// Layout of the inputs of all kernels: `q, sin, cos, dq, ddq, tau` of each degree of freedom, then
/// the parameters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Inputs {
    /// Degrees of freedom.
    pub dof: usize,
}

/// A group of inputs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Group {
    /// Positions (read for prismatic joints only).
    Position,
    /// Sines of the revolute joints' angles.
    Sine,
    /// Cosines of the revolute joints' angles.
    Cosine,
    /// Velocities.
    Velocity,
    /// Accelerations.
    Acceleration,
    /// Torques of the actuators.
    Torque,
    /// Standard or base parameters.
    Parameter,
}

impl Group {
    const JOINT: [Self; 6] =
        [Self::Position, Self::Sine, Self::Cosine, Self::Velocity, Self::Acceleration, Self::Torque];
}

impl Inputs {
    /// Index of the input at this position in its group.
    pub fn index(self, group: Group, at: usize) -> usize {
        Group::JOINT.iter().position(|&g| g == group).unwrap_or(Group::JOINT.len()) * self.dof + at
    }

    /// Group of an input, and position in it.
    pub fn locate(self, index: usize) -> (Group, usize) {
        match Group::JOINT.get(index / self.dof.max(1)) {
            Some(&group) => (group, index % self.dof),
            None => (Group::Parameter, index - Group::JOINT.len() * self.dof),
        }
    }
}

/// Joint frame relative to the previous one: `RotX(alpha) TransX(d) RotZ(theta) TransZ(r)`.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Type of the joint.
    pub kind: JointKind,
    /// Degree of freedom, from 0.
    pub dof: Option<usize>,
    /// Sine and cosine of the twist about x.
    pub alpha: (f64, f64),
    /// Length along x, m.
    pub d: f64,
    /// Exact quarter turns added to the angle.
    pub quarter_turns: i64,
    /// Further angle added to it, rad. For a revolute joint it is included in the sine and cosine
    /// passed to the kernel.
    pub angle: f64,
    /// Constant shift along z, m.
    pub r: f64,
    /// Transformation from the joint frame to the body's frame: `TransX(d) RotX(alpha)`, with sine
    /// and cosine of `alpha`. `None`: the same frame.
    pub body: Option<(f64, (f64, f64))>,
}

/// Joint frames from base to tip.
#[derive(Debug, Clone, PartialEq)]
pub struct Chain {
    /// One joint frame per row of the DH table.
    pub rows: Vec<Row>,
    /// Negative gravity in frame 0, m/s^2: the equivalent acceleration of the base.
    pub lift: [f64; 3],
    /// Negative gravity in the world frame, m/s^2.
    pub world_lift: [f64; 3],
    /// Rotation and origin of frame 0 in the world; `None`: they coincide.
    pub base: Option<([[f64; 3]; 3], [f64; 3])>,
    /// Rotation and origin of the tool frame in the last DH frame.
    pub tool: Option<([[f64; 3]; 3], [f64; 3])>,
}

impl Chain {
    /// Chain of a robot.
    pub fn new(robot: &Robot) -> Self {
        let mut rows = Vec::with_capacity(robot.joints.len());
        let mut before = ((0.0, 1.0), 0.0); // what a standard row hands on to the next
        let mut dof = 0;
        for joint in &robot.joints {
            let here = (joint.alpha.sin_cos(), joint.d.value);
            let ((alpha, d), body) = match robot.convention {
                Convention::Modified => (here, None),
                Convention::Standard => {
                    let given = before;
                    before = here;
                    (given, if here == ((0.0, 1.0), 0.0) { None } else { Some((here.1, here.0)) })
                }
            };
            let (quarter_turns, angle) = match joint.theta.quarter_turns() {
                Some(k) => (k, 0.0),
                None => (0, joint.theta.value),
            };
            let moves = joint.kind != JointKind::Fixed;
            rows.push(Row {
                kind: joint.kind,
                dof: moves.then_some(dof),
                alpha,
                d,
                quarter_turns,
                angle,
                r: joint.r.value,
                body,
            });
            dof += usize::from(moves);
        }
        Self {
            rows,
            lift: robot.base_gravity().map(|g| -g),
            world_lift: robot.gravity.map(|g| -g),
            base: robot.base.as_ref().map(|b| (b.rotation(), b.xyz)),
            tool: robot.tool.as_ref().map(|t| (t.rotation(), t.xyz)),
        }
    }

    /// Number of degrees of freedom.
    pub fn dof(&self) -> usize {
        self.rows.iter().filter(|r| r.dof.is_some()).count()
    }

    /// Angle added to each revolute joint's `q` before its sine and cosine are taken, rad.
    pub fn angle_offsets(&self) -> Vec<f64> {
        self.rows
            .iter()
            .filter(|r| r.dof.is_some())
            .map(|r| if r.kind == JointKind::Revolute { r.angle } else { 0.0 })
            .collect()
    }

    /// Chain over a graph: inputs become expressions.
    pub fn over<'g>(&self, graph: &'g Graph) -> Links<'g> {
        self.behind(graph, &[], &[])
    }

    /// Chain with deflected links: link `k` lags `q` by `deflection[k]` (rad or m, small; `None`:
    /// no deflection). It also turns with other motors (`geared[k]`: those degrees of freedom, with
    /// the link's turns per motor turn).
    pub(super) fn behind<'g>(
        &self,
        graph: &'g Graph,
        deflection: &[Option<Ex<'g>>],
        geared: &[Vec<(usize, f64)>],
    ) -> Links<'g> {
        let inputs = Inputs { dof: self.dof() };
        let of = |row: &Row| row.dof.and_then(|k| deflection.get(k).copied().flatten());
        let turned = |row: &Row| {
            let others = row.dof.and_then(|k| geared.get(k)).into_iter().flatten();
            let parts = others.map(|&(other, ratio)| graph.input(inputs.index(Group::Position, other)) * ratio);
            parts.reduce(|sum, part| sum + part)
        };
        Links {
            graph,
            inputs,
            links: self.rows.iter().map(|row| Link::new(graph, row, inputs, of(row), turned(row))).collect(),
            lift: Vec3::given(graph, self.lift),
            world_lift: Vec3::given(graph, self.world_lift),
            base: self.base,
            tool: self.tool,
            geared: geared.to_vec(),
        }
    }
}

/// A [`Chain`] whose entries are expressions.
pub struct Links<'g> {
    /// Graph of the expressions.
    pub graph: &'g Graph,
    /// Indices of the inputs.
    pub inputs: Inputs,
    /// Links from base to tip.
    pub links: Vec<Link<'g>>,
    /// Negative gravity in frame 0.
    pub lift: Vec3<'g>,
    /// Negative gravity in the world frame.
    pub world_lift: Vec3<'g>,
    /// Pose of frame 0 in the world.
    pub base: Option<([[f64; 3]; 3], [f64; 3])>,
    /// Pose of the tool frame in the last DH frame.
    pub tool: Option<([[f64; 3]; 3], [f64; 3])>,
    /// Other degrees of freedom that turn each link, with the link's turns per turn of each.
    geared: Vec<Vec<(usize, f64)>>,
}

impl<'g> Links<'g> {
    /// Input of a degree of freedom plus the contributions of others.
    fn summed(&self, group: Group, k: usize) -> Ex<'g> {
        let others = self.geared.get(k).into_iter().flatten();
        others.fold(self.input(group, k), |sum, &(other, ratio)| sum + self.input(group, other) * ratio)
    }

    /// An input as an expression.
    pub fn input(&self, group: Group, at: usize) -> Ex<'g> {
        self.graph.input(self.inputs.index(group, at))
    }

    /// Constant expression.
    pub fn number(&self, value: f64) -> Ex<'g> {
        self.graph.constant(value)
    }

    /// Velocity input of a row; zero for a fixed one.
    pub fn velocity(&self, row: usize) -> Ex<'g> {
        self.links[row].dof.map_or(self.number(0.0), |k| self.summed(Group::Velocity, k))
    }

    /// Acceleration input of a row; zero for a fixed one.
    pub fn acceleration(&self, row: usize) -> Ex<'g> {
        self.links[row].dof.map_or(self.number(0.0), |k| self.summed(Group::Acceleration, k))
    }

    /// Moving rows with their degree of freedom.
    pub fn moving(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        self.links.iter().enumerate().filter_map(|(row, l)| l.dof.map(|k| (row, k)))
    }
}

/// A row as expressions over a graph.
#[derive(Clone, Copy)]
pub struct Link<'g> {
    /// Type of the joint.
    pub kind: JointKind,
    /// Degree of freedom.
    pub dof: Option<usize>,
    /// Sine and cosine of the rotation about z.
    turn: (Ex<'g>, Ex<'g>),
    /// Sine and cosine of the twist about x.
    twist: (Ex<'g>, Ex<'g>),
    /// Shift along x.
    pub d: Ex<'g>,
    /// Shift along z, including `q` of a prismatic joint.
    pub r: Ex<'g>,
    /// Constant part of the shift along z, m.
    pub r_constant: f64,
    body: Option<(Ex<'g>, (Ex<'g>, Ex<'g>))>,
}

/// Sine and cosine of the sum of two angles.
fn turned_on<'g>((s, c): (Ex<'g>, Ex<'g>), by: Ex<'g>) -> (Ex<'g>, Ex<'g>) {
    let (sine, cosine) = (by.call(Call::Sin), by.call(Call::Cos));
    (s * cosine + c * sine, c * cosine - s * sine)
}

/// Sine and cosine of an angle minus a small one, by the series of the latter: accurate to 1e-11 at
/// 0.1 rad.
fn turned_back<'g>((s, c): (Ex<'g>, Ex<'g>), by: Ex<'g>) -> (Ex<'g>, Ex<'g>) {
    let square = by * by;
    let sine = by * ((square * (1.0 / 120.0) - 1.0 / 6.0) * square + 1.0);
    let cosine = ((square * (-1.0 / 720.0) + 1.0 / 24.0) * square - 0.5) * square + 1.0;
    (s * cosine - c * sine, c * cosine + s * sine)
}

/// Rotates `v` by `RotX(angle)`.
fn about_x<'g>((s, c): (Ex<'g>, Ex<'g>), v: Vec3<'g>) -> Vec3<'g> {
    let [x, y, z] = v.0;
    Vec3([x, c * y - s * z, s * y + c * z])
}

/// Rotates `v` by `RotX(-angle)`.
fn back_about_x<'g>((s, c): (Ex<'g>, Ex<'g>), v: Vec3<'g>) -> Vec3<'g> {
    let [x, y, z] = v.0;
    Vec3([x, c * y + s * z, c * z - s * y])
}

impl<'g> Link<'g> {
    fn new(g: &'g Graph, row: &Row, inputs: Inputs, deflection: Option<Ex<'g>>, geared: Option<Ex<'g>>) -> Self {
        let (s, c) = match (row.kind, row.dof) {
            (JointKind::Revolute, Some(k)) => {
                let (s, c) = (g.input(inputs.index(Group::Sine, k)), g.input(inputs.index(Group::Cosine, k)));
                let (s, c) = geared.map_or((s, c), |by| turned_on((s, c), by));
                deflection.map_or((s, c), |by| turned_back((s, c), by))
            }
            _ => {
                let (s, c) = row.angle.sin_cos();
                (g.constant(s), g.constant(c))
            }
        };
        let turn = match row.quarter_turns.rem_euclid(4) {
            0 => (s, c),
            1 => (c, -s),
            2 => (-s, -c),
            _ => (-c, s),
        };
        let r = match (row.kind, row.dof) {
            (JointKind::Prismatic, Some(k)) => {
                let r = g.input(inputs.index(Group::Position, k)) + g.given(row.r);
                let r = geared.map_or(r, |by| r + by);
                deflection.map_or(r, |by| r - by)
            }
            _ => g.given(row.r),
        };
        let pair = |(s, c): (f64, f64)| (g.constant(s), g.constant(c));
        Self {
            kind: row.kind,
            dof: row.dof,
            turn,
            twist: pair(row.alpha),
            d: g.given(row.d),
            r,
            r_constant: row.r,
            body: row.body.map(|(d, twist)| (g.given(d), pair(twist))),
        }
    }

    /// Transforms from the previous joint frame's axes to this one's.
    pub fn inward(&self, v: Vec3<'g>) -> Vec3<'g> {
        self.unturn(self.untwist(v))
    }

    /// Transforms from this joint frame's axes to the previous one's.
    pub fn outward(&self, v: Vec3<'g>) -> Vec3<'g> {
        about_x(self.twist, self.turned(v))
    }

    /// Transforms from the previous joint frame's axes to those between `RotX` and `RotZ`.
    pub fn untwist(&self, v: Vec3<'g>) -> Vec3<'g> {
        back_about_x(self.twist, v)
    }

    /// Transforms from the axes between `RotX` and `RotZ` to this joint frame's.
    pub fn unturn(&self, v: Vec3<'g>) -> Vec3<'g> {
        let ([x, y, z], (s, c)) = (v.0, self.turn);
        Vec3([c * x + s * y, c * y - s * x, z])
    }

    /// Transforms from this joint frame's axes to those between `RotX` and `RotZ`.
    pub fn turned(&self, v: Vec3<'g>) -> Vec3<'g> {
        let ([x, y, z], (s, c)) = (v.0, self.turn);
        Vec3([c * x - s * y, s * x + c * y, z])
    }

    /// Transforms from the axes between `RotX` and `RotZ` to the previous joint frame's.
    pub fn twisted(&self, v: Vec3<'g>) -> Vec3<'g> {
        about_x(self.twist, v)
    }

    /// Origin of this joint frame relative to the previous one's, in the axes between `RotX` and
    /// `RotZ`; `shifted`: before `TransZ(r)`.
    pub fn step(&self, shifted: bool) -> Vec3<'g> {
        let zero = self.d.graph().constant(0.0);
        Vec3([self.d, zero, if shifted { zero } else { self.r }])
    }

    /// Unit vector z of the joint frame.
    pub fn axis(&self) -> Vec3<'g> {
        Vec3::numbers(self.d.graph(), [0.0, 0.0, 1.0])
    }

    /// Whether the body's frame differs from the joint frame.
    pub fn has_body_frame(&self) -> bool {
        self.body.is_some()
    }

    /// Origin of the body's frame in the joint frame.
    pub fn body_origin(&self) -> Vec3<'g> {
        let zero = self.d.graph().constant(0.0);
        Vec3([self.body.map_or(zero, |(d, _)| d), zero, zero])
    }

    /// Transforms from the joint frame's axes to the body frame's.
    pub fn into_body(&self, v: Vec3<'g>) -> Vec3<'g> {
        self.body.map_or(v, |(_, twist)| back_about_x(twist, v))
    }

    /// Transforms from the body frame's axes to the joint frame's.
    pub fn out_of_body(&self, v: Vec3<'g>) -> Vec3<'g> {
        self.body.map_or(v, |(_, twist)| about_x(twist, v))
    }
}

/// Rotation from the tool frame to the last DH frame, as expressions.
pub(super) fn tool_rotation<'g>(g: &'g Graph, tool: &([[f64; 3]; 3], [f64; 3])) -> Mat3<'g> {
    Mat3::numbers(g, tool.0)
}
