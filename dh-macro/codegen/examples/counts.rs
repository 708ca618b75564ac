//! Operation counts of a few arms.
use dh_codegen::arm::{Function, Model};
use dh_codegen::robot::*;

fn arm(name: &str, rows: &[(i64, f64, f64)], drive: bool) -> Robot {
    let mut drive_ = Drive::default();
    if drive { drive_.rotor_inertia = Some(0.0); }
    Robot {
        name: name.into(),
        convention: Convention::Modified,
        constants: vec![],
        gravity: [0.0, 0.0, -9.81],
        joints: rows.iter().enumerate().map(|(i, &(a, d, r))| Joint {
            name: format!("j{i}"), kind: JointKind::Revolute, actuated: true,
            alpha: Angle::pi_fraction(a, 2), d: Length::meters(d), theta: Angle::zero(), r: Length::meters(r),
            limits: Limits::default(), drive: drive_.clone(),
        }).collect(),
        links: vec![], tool: None, collision: Collision::default(), effects: vec![],
    }
}

fn main() {
    let lwr = [(0, 0.0, 0.3105), (1, 0.0, 0.0), (-1, 0.0, 0.4), (-1, 0.0, 0.0), (1, 0.0, 0.39), (1, 0.0, 0.0), (-1, 0.0, 0.0)];
    let panda = [(0, 0.0, 0.333), (-1, 0.0, 0.0), (1, 0.0, 0.316), (1, 0.0825, 0.0), (-1, -0.0825, 0.384), (1, 0.0, 0.0), (1, 0.088, 0.0)];
    let ur10 = [(0, 0.0, 0.1273), (1, 0.0, 0.0), (0, -0.612, 0.0), (0, -0.5723, 0.163941), (1, 0.0, 0.1157), (-1, 0.0, 0.0922)];
    let puma = [(0, 0.0, 0.0), (-1, 0.0, 0.2435), (0, 0.4318, -0.0934), (1, -0.0203, 0.4331), (-1, 0.0, 0.0), (1, 0.0, 0.0)];
    let gen3 = [(2, 0.0, -0.28481), (1, 0.0, -0.01175), (-1, 0.0, -0.42076), (1, 0.0, -0.01275), (-1, 0.0, -0.31436), (1, 0.0, -0.00035), (-1, 0.0, -0.167455)];
    for (name, rows) in [("lwr", &lwr[..]), ("panda", &panda[..]), ("ur10", &ur10[..]), ("puma", &puma[..]), ("gen3", &gen3[..])] {
        let t = std::time::Instant::now();
        let model = Model::new(&arm(name, rows, false)); let t0 = std::time::Instant::now(); write(&arm(name, rows, true)); println!("crate in {:?}", t0.elapsed());
        let search = t.elapsed();
        let ia = Model::new(&arm(name, rows, true)).base().len();
        println!("{name}: base {} with IA {ia}; search {search:?}", model.base().len());
        for f in Function::ALL {
            let t = std::time::Instant::now();
            let k = model.kernel(f);
            print!("{:?} ", t.elapsed());
            let c = k.tape.operations();
            let neg = k.tape.code.iter().filter(|s| s.kind == dh_codegen::sym::Kind::Neg).count();
            print!("neg {neg:3}");
            println!("   {:28} {:4}x {:4}+ = {:5}  nnz {} of {}", f.name(), c.mul, c.add, c.total(), k.nonzeros().len(), k.tape.outputs.len());
        }
        if name == "lwr" && false { for b in &model.base().0 { println!("      {}", b.grouping); } }
    }
}

#[allow(dead_code)]
fn write(robot: &Robot) {
    for (path, text) in dh_codegen::krate(robot, "") {
        let to = std::path::Path::new("/tmp/gen").join(&robot.name).join(path);
        std::fs::create_dir_all(to.parent().unwrap()).unwrap();
        std::fs::write(to, text).unwrap();
    }
}
