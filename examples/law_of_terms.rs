//! A torque law without a name, as a search would find it: made of terms, checked, printed, put
//! into a robot file, and evaluated from there.
//!
//! `cargo run --example law_of_terms`

use denavit::model::file_torque_model::FileTorqueModel;
use denavit::model::{States, TorqueModel};
use denavit::robot::{LawFunction, Robot, Run, Term, TorqueLaw, Variable, no_files};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let text = include_str!("../robots/planar2r.yaml");
    let mut robot = Robot::from_yaml(text, &no_files)?.robot;

    // -0.35 N m cos(3 q1) tanh(dq2 / (0.05 rad/s)) + 0.02 N m s/rad dq1 |q2|
    let call = |function, x| Term::Call(function, Box::new(x));
    let times = |factor: f64, v| Term::Product(vec![Term::Number(factor), Term::Variable(v)]);
    let law = Term::Sum(vec![
        Term::Product(vec![
            Term::Number(-0.35),
            call(LawFunction::Cos, times(3.0, Variable::Position(0))),
            call(LawFunction::Tanh, times(20.0, Variable::Velocity(1))),
        ]),
        Term::Product(vec![
            times(0.02, Variable::Velocity(0)),
            call(LawFunction::Abs, Term::Variable(Variable::Position(1))),
        ]),
    ]);
    let kinds = robot.moving_kinds();
    let law = TorqueLaw::new(&law, &kinds)?;
    println!("{law}");

    // A law without a value for some motion, or with mixed units, is refused as in a file.
    let bare = call(LawFunction::Exp, Term::Variable(Variable::Velocity(0)));
    println!("refused: {}", TorqueLaw::new(&bare, &kinds).unwrap_err());

    robot.joints[1].drive.law = Some(law);
    let file = robot.rewritten(text, &no_files, &no_files, &Run::default());
    let line = file.lines().find(|line| line.contains("law:")).unwrap_or_default();
    println!("in the file:{line}");

    let states = States { len: 1, q: vec![0.3, -0.7], dq: vec![0.4, -0.9], ddq: vec![0.0, 0.0] };
    let mut tau = [0.0; 2];
    FileTorqueModel::new(&Robot::from_yaml(&file, &no_files)?.robot)?.torques(&states, &mut tau);
    println!("torques: {:.4} N m, {:.4} N m", tau[0], tau[1]);
    Ok(())
}
