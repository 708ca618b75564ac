//! Tests of `denavit paint plan` and `denavit paint run`: files, figures, wrong uses.

use denavit::model::rigid_body::Numeric;

use super::*;

const ROBOT: &str = "robots/kuka-lwr4.yaml";
const QUICK: [&str; 10] = [
    "--tool",
    "robots/tools/large-roller.yaml",
    "--center",
    "-0.85,0.25,0.5",
    "--width",
    "0.4",
    "--height",
    "0.3",
    "--whole",
    "--constant-swivel",
];

fn rows(path: &str) -> (Vec<String>, Vec<Vec<String>>) {
    let text = std::fs::read_to_string(path).unwrap();
    let mut lines = text.lines().map(|l| l.split(',').map(String::from).collect());
    (lines.next().unwrap(), lines.collect())
}

#[test]
fn the_files_are_the_plan() {
    let folder = folder("paint");
    let path = |name: &str| folder.join(name).display().to_string();
    let (out, roller, plan, page) = (path("m.csv"), path("p.csv"), path("p.json"), path("p.html"));
    let files = ["--out", &out, "--path", &roller, "--plan", &plan, "--report", &page, "--rate", "50", "--json", "-"];
    let found = json(&[&["paint", "plan", ROBOT], &QUICK[..], &files[..]].concat());
    assert_eq!(found["painted"], 1.0);
    assert_eq!(found["feasible"], true);
    let written =
        denavit::report::plan_of_json(&serde_json::from_str(&std::fs::read_to_string(&plan).unwrap()).unwrap())
            .unwrap();
    assert_eq!(denavit::report::plan_of_json(&found).unwrap(), written);
    assert!((written.duration() - found["duration"].as_f64().unwrap()).abs() < 1e-9);

    let (header, joints) = rows(&out);
    assert_eq!(header, [vec!["t".to_string()], columns(&["q", "dq", "ddq"], 7)].concat());
    let (header, places) = rows(&roller);
    assert_eq!(joints.len(), places.len());
    let column = |name: &str| header.iter().position(|h| h == name).unwrap();
    let number = |row: &[String], k: usize| row[k].parse::<f64>().unwrap();
    let mut robot = read_robot(ROBOT);
    let tool = std::fs::read_to_string(PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(QUICK[1])).unwrap();
    robot.tool = Some(dh_codegen::robot::Tool::from_yaml(&tool, "roller").unwrap().0);
    let numeric = Numeric::new(&robot);
    for (joints, place) in joints.iter().zip(&places) {
        assert_eq!(joints[0], place[0]);
        let q: Vec<f64> = (1..8).map(|k| number(joints, k)).collect();
        let pose = numeric.tool(&q);
        for (i, name) in ["px", "py", "pz"].iter().enumerate() {
            assert!((pose[(i, 3)] - number(place, column(name))).abs() < 1e-9);
            assert!((pose[(i, 2)] - number(place, column(["r13", "r23", "r33"][i]))).abs() < 1e-9);
        }
        let x = number(place, column("x"));
        let contact = matches!(place[column("phase")].as_str(), "stroke" | "shift");
        assert!(if contact { (x + 0.85).abs() < 1e-9 } else { x >= -0.85 - 1e-9 });
    }
    // A motion like any other: the checker of motions finds no violation.
    let judged = json(&["excite", ROBOT, "--check", &out, "--json", "-"]);
    assert_eq!(judged["feasible"], true, "{judged}");

    let html = std::fs::read_to_string(&page).unwrap();
    assert!(html.contains("<svg") || html.contains("id=wall"));
    assert!(!html.contains("http://") || html.matches("http://").count() == html.matches("http://www.w3.org").count());
}

#[test]
fn the_area_is_weighed_against_time() {
    let base = ["paint", "plan", "robots/ur10e.yaml", "--tool", "robots/tools/large-roller.yaml", "--json", "-"];
    let wall =
        ["--center", "0.9,0.1,0.6", "--normal", "-1,0,0", "--width", "0.4", "--height", "0.6", "--pattern", "snake"];
    let dear = json(&[&base[..], &wall[..], &["--area-weight", "1000"]].concat());
    let cheap = json(&[&base[..], &wall[..], &["--area-weight", "0.05"]].concat());
    let of = |v: &serde_json::Value, key: &str| v[key].as_f64().unwrap();
    assert!(of(&dear, "area") > 1.5 * of(&cheap, "area"), "{} {}", dear["area"], cheap["area"]);
    assert!(of(&dear, "contact_seconds") > of(&cheap, "contact_seconds"));
    assert!(dear["cost_constant_swivel"].is_null());
}

#[test]
fn wrong_uses() {
    let fails = |status: i32, arguments: &[&str], parts: &[&str]| {
        let run = denavit(&[&["paint", "plan"], arguments].concat());
        assert_eq!(run.status, Some(status), "{arguments:?}: {}", run.err);
        assert_eq!(run.out, "");
        for part in parts {
            assert!(run.err.contains(part), "{arguments:?}: no `{part}` in: {}", run.err);
        }
    };
    let tool = ["--tool", "robots/tools/large-roller.yaml"];
    fails(2, &[ROBOT], &["no tool", "--tool"]);
    fails(2, &[ROBOT, "--tool", "robots/tools/gripper.yaml"], &["geometry"]);
    fails(2, &[&[ROBOT], &tool[..], &["--normal", "0,0,1"]].concat(), &["up is along its normal"]);
    fails(2, &[&[ROBOT], &tool[..], &["--normal", "1,0"]].concat(), &["--normal", "three numbers"]);
    fails(2, &[&[ROBOT], &tool[..], &["--width", "-1"]].concat(), &["width is -1 m"]);
    fails(2, &[&[ROBOT], &tool[..], &["--width", "0"]].concat(), &["width is 0 m"]);
    fails(2, &[&[ROBOT], &tool[..], &["--lanes", "0"]].concat(), &["lanes"]);
    fails(2, &[&[ROBOT], &tool[..], &["--rate", "0"]].concat(), &["--rate 0"]);
    fails(2, &[&[ROBOT], &tool[..], &["--rate", "50"]].concat(), &["--rate has no effect here", "--out"]);
    fails(1, &[&[ROBOT], &tool[..], &["--center", "-3,0,0.4"]].concat(), &["out of reach by"]);
    let buried = ["--center", "-0.85,0.25,0.5", "--ground", "0.95", "--constant-swivel"];
    fails(1, &[&[ROBOT], &tool[..], &buried].concat(), &["ground, at 0.95 m, is above the wall's upper end"]);
    let short = [&QUICK[..], &["--duration", "0.5"]].concat();
    fails(1, &[&[ROBOT], &short[..]].concat(), &["s more than the 0.5 s", "--duration"]);
}

/// Sensors at 250 Hz: a quarter of the steps.
const SLOW: &str = "sensors: { rate: 250, torque_noise: [0.05] }\n";

#[test]
fn a_run_presses_as_asked_and_shows_it() {
    let folder = folder("paint-run");
    let path = |name: &str| folder.join(name).display().to_string();
    let (plan, out, page) = (path("p.json"), path("force.csv"), path("run.html"));
    let tool = ["--tool", "robots/tools/large-roller.yaml"];
    let wall = ["--center", "-0.85,0.25,0.5", "--width", "0.2", "--height", "0.15", "--whole", "--constant-swivel"];
    let planned =
        denavit(&[&["paint", "plan", ROBOT, "--duration", "1.5", "--plan", &plan], &tool[..], &wall].concat());
    assert_eq!(planned.status, Some(0), "{}", planned.err);
    let slow = file(&folder, "slow.yaml", SLOW);
    let base = ["paint", "run", ROBOT, "--plan", &plan, "--effects", &slow, "--settle", "1", "--corner", "5"];
    let arguments = [&base[..], &tool, &["--force", "20", "--out", &out, "--report", &page, "--json", "-"]].concat();
    let found = json(&arguments);
    assert_eq!(found["status"], "painted to the end", "{found}");
    assert_eq!(found["seconds_off"], 0.0);
    for (key, most) in [("estimated_measured", 1.0), ("measured_desired", 1.0)] {
        assert!(found["rms"][key].as_f64().unwrap() < most, "{found}");
    }
    assert!(found["tracking"].as_f64().unwrap() < 0.005, "{found}");
    // The figures are those of the CSV.
    let (header, samples) = rows(&out);
    assert_eq!(header[..4], ["t", "estimated", "measured", "true"]);
    let number = |row: &Vec<String>, k: usize| row[k].parse::<f64>().unwrap();
    let rms = |f: &dyn Fn(&Vec<String>) -> f64| {
        (samples.iter().map(|r| f(r).powi(2)).sum::<f64>() / samples.len() as f64).sqrt()
    };
    let off = rms(&|r| number(r, 2) - 20.0);
    assert!((off - found["rms"]["measured_desired"].as_f64().unwrap()).abs() < 1e-4);
    assert!(rms(&|r| number(r, 3) - 20.0) < 1.0);
    let html = std::fs::read_to_string(&page).unwrap();
    assert!(html.contains("<polyline") && html.contains("Path of the roller") && !html.contains("NaN"));
    assert!(html.matches("http").count() == html.matches("http://www.w3.org").count());

    let fails = |arguments: &[&str], part: &str| {
        let run = denavit(&[&base[..], &tool, arguments].concat());
        assert_eq!((run.status, run.out.as_str()), (Some(2), ""), "{arguments:?}: {}", run.err);
        assert!(run.err.contains(part), "{arguments:?}: {}", run.err);
    };
    fails(&["--aside", "1.5"], "--aside 1.5");
    fails(&["--force", "nan"], "--force");
    fails(&["--paper", "--carry", "0.5"], "--carry");
    for tool in [&["--tool", "robots/tools/mini-roller-250x60.yaml"][..], &[]] {
        let run = denavit(&[&base[..], tool].concat());
        assert_eq!(run.status, Some(2), "{}", run.out);
        assert!(run.err.contains("the plan was made for a roller of 0.35 m x 0.2 m"), "{}", run.err);
    }
    let wrong = denavit(&["paint", "run", "robots/ur10e.yaml", "--plan", &plan]);
    assert_eq!(wrong.status, Some(2));
    assert!(wrong.err.contains("the plan has 7 joints"), "{}", wrong.err);
}

#[test]
fn a_direction_out_of_reach_is_told_in_radians() {
    // A SCARA's last axis is vertical: it can't point a roller at a wall.
    let wall = ["--tool", QUICK[1], "--center=0.2,0.3,0", "--width", "0.2", "--height", "0.1", "--ground=-2"];
    let run = denavit(&[&["paint", "plan", "robots/scara.yaml"], &wall[..]].concat());
    assert_eq!(run.status, Some(1));
    assert!(run.err.contains("can't point the roller there: 1.5708 rad off"), "{}", run.err);
}
