//! Tests of wrong uses: status 2 and one paragraph with what is wrong, where, and how to correct
//! it.

use super::*;

/// Checks that the command ends with `status`, prints nothing on standard output, and has all of
/// `parts` in one paragraph.
fn fails(status: i32, arguments: &[&str], parts: &[&str]) {
    let run = denavit(arguments);
    assert_eq!(run.status, Some(status), "{arguments:?}: {}", run.err);
    assert_eq!(run.out, "", "{arguments:?}");
    assert!(run.err.starts_with("denavit: ") && !run.err.trim_end().contains("\n\n"), "{arguments:?}: {}", run.err);
    for part in parts {
        assert!(run.err.contains(part), "{arguments:?}: no `{part}` in: {}", run.err);
    }
}

fn eval<'a>(robot: &'a str, quantity: &'a str, states: &'a str) -> [&'a str; 6] {
    ["eval", robot, "--quantity", quantity, "--states", states]
}

const PLANAR: &str = "robots/planar2r.yaml";

#[test]
fn of_the_command_line() {
    fails(2, &["chekc", PLANAR], &["chekc", "--help"]);
    fails(2, &["check"], &["<ROBOT>", "--help"]);
    fails(2, &["check", PLANAR, "--jsn"], &["--jsn", "--json"]);
    fails(2, &eval(PLANAR, "momentum", "x.csv"), &["momentum", "--quantity", "mass_matrix", "--help"]);
    fails(2, &["identify", PLANAR], &["<LOG>"]);
    fails(2, &["identify", PLANAR, "x.csv", "--cutoff", "-3"], &["-3"]);
    fails(2, &["identify", PLANAR, "x.csv", "--keep", "everything"], &["everything", "gaps", "all"]);
    fails(2, &["identify", PLANAR, "x.csv", "--order", "0"], &["--order 0", "1 to 12"]);
}

/// A negative number is accepted as a value of every option.
#[test]
fn of_negative_numbers() {
    let paint = ["paint", "run", "robots/kuka-lwr4.yaml", "--plan", "x.json"];
    for (option, value) in [("--force", "-5"), ("--settle", "-1"), ("--doubt", "-0.5"), ("--stiffness", "-1e3")] {
        let said = format!("{option} {}: from", value.parse::<f64>().unwrap());
        fails(2, &[&paint[..], &[option, value]].concat(), &[&said]);
    }
    fails(2, &["identify", PLANAR, "x.csv", "--most-cost", "-3"], &["--most-cost -3: percent, above 0"]);
    fails(2, &["diagnose", PLANAR, "x.csv", "--rate", "-3"], &["--rate -3: windows per second"]);
    fails(2, &["force", PLANAR, "x.csv", "--estimator", "momentum", "--gain", "-3"], &["--gain -3"]);
    fails(2, &["force", PLANAR, "x.csv", "--stride", "-3"], &["'-3'", "--stride"]);
}

#[test]
fn of_paths() {
    fails(2, &["check", "no/such.yaml"], &["no/such.yaml", "check the path"]);
    fails(2, &["check", "robots"], &["robots", "name a file"]);
    fails(2, &eval(PLANAR, "gravity", "no/such.csv"), &["no/such.csv", "check the path"]);
    fails(2, &eval(PLANAR, "gravity", "robots"), &["robots", "name a file"]);
    fails(2, &["identify", PLANAR, "no/such.csv"], &["no/such.csv", "check the path"]);
    fails(2, &["identify", PLANAR, "robots"], &["robots", "name a file"]);
    // Not the input's fault: the output's path.
    let folder = folder("errors-paths");
    let out = folder.display().to_string();
    fails(1, &["check", PLANAR, "--json", &out], &[&out, "can't be written"]);
    let left: Vec<_> = std::fs::read_dir(folder.parent().unwrap()).unwrap().map(|e| e.unwrap().file_name()).collect();
    assert!(!left.contains(&"errors-paths.tmp".into()), "no scraps");
}

#[test]
fn of_robot_files() {
    let folder = folder("errors-robots");
    let bad = file(&folder, "latin1.yaml", b"name: b\xe9ta\n");
    fails(2, &["check", &bad], &["latin1.yaml", "byte 7", "UTF-8"]);
    let empty = file(&folder, "empty.yaml", "");
    fails(2, &["check", &empty], &["empty.yaml"]);
    let text = "name: two\njoints:\n  - { type: revolute, alpha: pi/3x }\n  - { type: revolut }\n";
    let slips = file(&folder, "slips.yaml", text);
    fails(2, &["check", &slips], &["slips.yaml:3:", "joints[1].alpha", "slips.yaml:4:", "revolute"]);
    let states = file(&folder, "states.csv", csv(&columns(&["q", "dq", "ddq"], 6), &[vec![0.0; 18]]));
    fails(
        2,
        &eval("robots/staubli-tx40.yaml", "inverse_dynamics", &states),
        &["staubli-tx40.yaml", "links:", "identify"],
    );
}

#[test]
fn of_states() {
    let folder = folder("errors-states");
    let run = |name: &str, text: &str, quantity: &str, parts: &[&str]| {
        fails(2, &eval(PLANAR, quantity, &file(&folder, name, text)), &[&[name][..], parts].concat());
    };
    run("empty.csv", "", "gravity", &["empty", "name the columns"]);
    run("few.csv", "q1\n0.1\n", "gravity", &["q2", "2 joints"]);
    run("speed.csv", "q1,q2\n0.1,0.2\n", "coriolis", &["dq1"]);
    run("torque.csv", "q1,q2,dq1,dq2\n0,0,0,0\n", "forward_dynamics", &["tau1"]);
    run("nan.csv", "q1,q2\n0.1,0.2\n0.3,NaN\n", "gravity", &["line 3", "column q2", "NaN", "mend"]);
    run("ragged.csv", "q1,q2\n0.1,0.2\n0.3\n", "gravity", &["line: 3", "1 field", "2"]);
}

#[test]
fn of_logs() {
    let folder = folder("errors-logs");
    let log = |rows: usize| -> Vec<Vec<f64>> {
        let wave = |k: usize, w: f64| (0.01 * k as f64 * w).sin();
        (0..rows).map(|k| vec![0.01 * k as f64, wave(k, 3.0), wave(k, 5.0), wave(k, 2.0), wave(k, 7.0)]).collect()
    };
    let header: Vec<String> = ["t", "q1", "q2", "tau1", "tau2"].map(String::from).to_vec();
    let run = |name: &str, text: &str, parts: &[&str]| {
        fails(2, &["identify", PLANAR, &file(&folder, name, text)], &[&[name][..], parts].concat());
    };
    run("empty.csv", "", &["empty", "q1"]);
    run("header.csv", &(header.join(",") + "\n"), &[]);
    run("column.csv", &csv(&header, &log(500)).replacen("tau2", "torque2", 1), &["tau2", "missing"]);
    let cell = csv(&header, &log(500)).lines().enumerate().fold(String::new(), |text, (k, line)| {
        let line = if k == 200 { "2,0,NaN,0,0" } else { line };
        text + line + "\n"
    });
    run("nan.csv", &cell, &["line 201", "q2", "--keep"]);
    fails(2, &["identify", "robots/ur10e.yaml", &file(&folder, "two.csv", csv(&header, &log(500)))], &["two.csv", "6"]);
}

/// Verbs that read or drive every joint refuse one without a motor; the others accept it.
#[test]
fn a_joint_without_a_motor_is_refused_where_it_counts() {
    let folder = folder("motors");
    let text = std::fs::read_to_string("robots/planar2r.yaml").unwrap();
    let robot = read_robot("robots/planar2r.yaml");
    let mut passive = robot.clone();
    passive.joints[1].actuated = false;
    passive.joints[1].drive = Default::default();
    assert!(!text.contains("actuated"));
    let robot = file(&folder, "passive.yaml", passive.to_yaml());
    let out = folder.join("out").display().to_string();
    let refused: [&[&str]; 7] = [
        &["excite", &robot, "--duration", "2", "--criterion", "cond", "--out", &out],
        &["identify", &robot, "log.csv", "--out", &out],
        &["diagnose", &robot, "log.csv"],
        &["tool", &robot, "--unloaded", "a.csv", "--loaded", "b.csv", "--tools", "robots/tools"],
        &["force", &robot, "log.csv"],
        &["paint", "plan", &robot, "--out", &out],
        &["paint", "run", &robot, "--plan", "plan.json"],
    ];
    for arguments in refused {
        let run = denavit(arguments);
        assert_eq!(run.status, Some(2), "{arguments:?}: {}", run.err);
        let told = run.err.contains("joint 2 (elbow) has no motor") && run.err.contains("type: fixed");
        assert!(told, "{arguments:?}: {}", run.err);
    }
    let check = denavit(&["check", &robot]);
    assert!(check.status == Some(0) && check.out.contains("without a motor: elbow"), "{}", check.out);
    assert_eq!(json(&["check", &robot, "--json", "-"])["unactuated"], serde_json::json!([2]));
    let generated = denavit(&["generate", &robot, "--out", &out]);
    assert_eq!(generated.status, Some(0));
    let states = file(&folder, "states.csv", "q1,q2,dq1,dq2,ddq1,ddq2,tau1,tau2\n0.1,0.2,0,0,0,0,1,0\n");
    let eval = |quantity: &str, states: &str| denavit(&["eval", &robot, "--quantity", quantity, "--states", states]);
    let torques = eval("inverse_dynamics", &states);
    assert_eq!(torques.status, Some(0), "{}", torques.err);
    for said in [&generated.err, &torques.err] {
        assert!(said.contains("joint 2 (elbow) has no motor") && said.contains("something else"), "{said}");
    }
    assert_eq!(eval("forward_dynamics", &states).status, Some(0));
    let driven = file(&folder, "driven.csv", "q1,q2,dq1,dq2,tau1,tau2\n0,0,0,0,0,0\n0,0,0,0,0,7\n");
    let refused = eval("forward_dynamics", &driven);
    assert_eq!(refused.status, Some(2));
    assert!(refused.err.contains("`tau2` is 7 in row 2, but joint 2 (elbow) has no motor"), "{}", refused.err);
    let urdf = folder.join("passive.urdf").display().to_string();
    let exported = denavit(&["export", &robot, "--format", "urdf", "--out", &urdf]);
    assert!(exported.out.contains("that `elbow` has no motor"), "{}", exported.out);
}

/// Tables of states and poses that could be misread are refused.
#[test]
fn tables_say_what_they_mean() {
    let folder = folder("tables");
    let run = |name: &str, text: &str, words: &str| {
        let states = file(&folder, name, text);
        let run = denavit(&["eval", "robots/planar2r.yaml", "--quantity", "gravity", "--states", &states]);
        assert_eq!(run.status, Some(2), "{name}");
        assert!(run.err.contains(name) && run.err.contains(words), "{name}: {}", run.err);
    };
    run("twice.csv", "q1,q1,q2\n0,0,0\n", "two columns are named `q1`");
    run("empty.csv", "q1,q2\n", "no rows");
    run("more.csv", "q1,q2,q3\n0,0,0\n", "there is a column q3, and the robot has 2 joints");
}

/// `--prior none` omits links; if there are none it would have no effect.
#[test]
fn a_prior_that_changes_nothing_is_refused() {
    let folder = folder("prior");
    let mut robot = read_robot("robots/planar2r.yaml");
    robot.links.iter_mut().for_each(|link| *link = None);
    let robot = file(&folder, "bare.yaml", robot.to_yaml());
    let run = denavit(&["identify", &robot, "log.csv", "--prior", "none"]);
    assert_eq!(run.status, Some(2));
    assert!(run.err.contains("--prior none") && run.err.contains("it has none"), "{}", run.err);
}

#[test]
fn a_log_in_place_of_a_robot_file_does_not_fill_the_memory() {
    let place = folder("long-text");
    let path = place.join("endless.yaml");
    // A sparse file, which takes no room on the disk.
    std::fs::File::create(&path).unwrap().set_len(1 << 40).unwrap();
    for verb in ["check", "import"] {
        let run = denavit(&[verb, &path.display().to_string()]);
        assert_eq!(run.status, Some(2));
        assert!(run.err.contains("more than 64 MiB"), "{}", run.err);
    }
}
