//! Plans the painting of a wall by a UR10e: the plan, its time, and the share of the wall that it
//! covers.
//!
//! `cargo run --example paint_wall`

use std::error::Error;

use denavit::apps::painting::{Roller, Surface, Task, plan};
use denavit::model::interpreted::Interpreted;
use denavit::model::inverse_kinematics::Kinematics;
use denavit::robot::{Robot, Tool};

fn main() -> Result<(), Box<dyn Error>> {
    let root = env!("CARGO_MANIFEST_DIR");
    let read = |path: &str| std::fs::read_to_string(format!("{root}/robots/{path}"));
    let mut robot = Robot::open(format!("{root}/robots/ur10e.yaml"))?;
    robot.tool = Some(Tool::from_yaml(&read("tools/small-roller.yaml")?, "small-roller")?.0);
    let size = robot.tool.as_ref().and_then(|tool| tool.geometry).ok_or("the roller has a size")?;
    let roller = Roller { length: size.length, width: size.width, turned: false };

    let arm = Interpreted::new(&robot, &Interpreted::PLACED);
    let inverse = Kinematics::new(&robot, arm.model()).ok_or("an arm of up to ten joints")?;
    let surface = Surface::new([0.9, 0.2, 0.6], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0], 0.2, 0.3)?;
    let task = Task::new(&arm, &inverse, &robot, surface, roller, 0.5)?;
    let found = plan(&task, &|_, _| {}).map_err(|e| e.to_string())?;
    println!("{:.1} s, {:.0} % of the wall", found.duration(), 100.0 * found.coverage().painted);
    Ok(())
}
