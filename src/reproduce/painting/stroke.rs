//! Straight strokes on the wall, by closed-form inverse kinematics.

use dh_codegen::arm::Model;
use dh_codegen::robot::{Robot, Tool};

use super::super::ReproduceError;
use super::rig::{CENTER, NORMAL};
use crate::inverse::{Ask, Kinematics};
use crate::simulate::{SimulateError, Trajectory};

/// Up and down beside each other, at rest at each end; `off` the wall by so much, m.
pub fn strokes(robot: &Robot, tool: &Tool, off: f64) -> Result<Trajectory, ReproduceError> {
    let mut bare = robot.clone();
    bare.tool = None;
    let failed = |why: &str| ReproduceError::Design { what: "the strokes".into(), why: why.into() };
    let kinematics = Kinematics::new(&bare, &Model::new(&bare)).ok_or_else(|| failed("too many joints"))?;
    let geometry = tool.geometry.ok_or_else(|| failed("the tool has no size"))?;
    // Roller axis across, tool into the wall: x = y_base, z = -normal.
    let z = NORMAL.map(|n| -n);
    let x = [0.0, 1.0, 0.0];
    let y = [z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]];
    let reach = geometry.length + tool.xyz[2];
    let pose = |place: [f64; 2]| -> [[f64; 4]; 3] {
        let at = [CENTER[0] + NORMAL[0] * (reach + off), CENTER[1] + place[0], CENTER[2] + place[1]];
        std::array::from_fn(|i| [x[i], y[i], z[i], at[i]])
    };
    let lanes = (0.4 / geometry.width).ceil() as usize + 1;
    let mut places = Vec::new();
    for lane in 0..lanes {
        let across = -0.2 + 0.4 * lane as f64 / (lanes - 1) as f64;
        let ends = if lane % 2 == 0 { [0.2, -0.2] } else { [-0.2, 0.2] };
        places.extend(ends.map(|up| [across, up]));
    }
    let (mut t, mut q) = (vec![], vec![Vec::new(); robot.dof()]);
    let mut near: Option<Vec<f64>> = None;
    let mut clock = 0.0;
    for pair in places.windows(2) {
        let [from, to] = [pair[0], pair[1]];
        let length = (to[0] - from[0]).abs() + (to[1] - from[1]).abs();
        let seconds = 1.5 + 6.0 * length;
        let count = (seconds * 100.0) as usize;
        for k in 0..count {
            let s = k as f64 / count as f64;
            let s = s * s * s * (10.0 + s * (6.0 * s - 15.0));
            let place = [from[0] + s * (to[0] - from[0]), from[1] + s * (to[1] - from[1])];
            let ask = Ask { redundancy: 0.0, near: near.clone(), ..Ask::default() };
            let found = kinematics.solve(&pose(place), &ask).map_err(|why| failed(&why.to_string()))?;
            let best = match &near {
                Some(_) => found.list.first(),
                None => found.list.iter().filter(|p| p.within_limits).max_by(|a, b| a.margin.total_cmp(&b.margin)),
            };
            let best = best.ok_or_else(|| failed("a place is out of reach"))?;
            t.push(clock + seconds * k as f64 / count as f64);
            best.q.iter().zip(&mut q).for_each(|(q, row)| row.push(*q));
            near = Some(best.q.clone());
        }
        clock += seconds;
    }
    let motion = Trajectory::new(robot.dof(), t, q.concat(), None, None);
    Ok(motion.map_err(SimulateError::from)?)
}
