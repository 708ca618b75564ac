//! Tests of `denavit ik`: columns, JSON and exit status.

use denavit::model::rigid_body::Numeric;
use denavit::numerics::prng::Random;

use super::*;

fn pose_columns() -> Vec<String> {
    ["r11", "r12", "r13", "px", "r21", "r22", "r23", "py", "r31", "r32", "r33", "pz"].map(String::from).to_vec()
}

fn row(m: &nalgebra::Matrix4<f64>) -> Vec<f64> {
    (0..12).map(|k| m[(k / 4, k % 4)]).collect()
}

/// Poses of random postures: every solution reaches its pose, and one is the posture.
#[test]
fn solutions_reach_their_poses() {
    for (name, class) in [("puma560", "6r-spherical-wrist"), ("ur10e", "6r-three-parallel"), ("stanford", "stanford")] {
        let robot = read_robot(&format!("robots/{name}.yaml"));
        let oracle = Numeric::new(&robot);
        let mut random = Random::new(17);
        let postures: Vec<Vec<f64>> = (0..5).map(|_| random.vector(6, 1.2)).collect();
        let goals: Vec<_> = postures.iter().map(|q| *oracle.frames(q).last().unwrap()).collect();
        let folder = folder(&format!("ik-{name}"));
        let rows: Vec<Vec<f64>> = goals.iter().map(row).collect();
        let poses = file(&folder, "poses.csv", csv(&pose_columns(), &rows));
        let said = json(&["ik", &format!("robots/{name}.yaml"), "--poses", &poses, "--json", "-"]);
        assert_eq!(said["class"], class);
        assert_eq!(json(&["check", &format!("robots/{name}.yaml"), "--json", "-"])["ik"]["class"], class);
        for ((pose, goal), q) in said["poses"].as_array().unwrap().iter().zip(&goals).zip(&postures) {
            assert_eq!(pose["status"], "ok");
            let solutions = pose["solutions"].as_array().unwrap();
            let mut met = false;
            for s in solutions {
                let found = numbers(&s["q"]);
                assert!((oracle.frames(&found).last().unwrap() - goal).abs().max() < 1e-12);
                assert!(s["position_error"].as_f64().unwrap() < 1e-12 && s["rotation_error"].as_f64().unwrap() < 1e-12);
                assert!(s["branch"].is_string() && s["within_limits"].is_boolean());
                met |= found.iter().zip(q).all(|(a, b)| ((a - b) / 2.0).sin().abs() < 1e-8);
            }
            assert!(met, "{name} {q:?}");
        }
    }
}

/// The swivel column rotates the elbow and keeps the pose; without it the angle is zero.
#[test]
fn a_redundant_arm_takes_its_swivel_from_the_file() {
    let robot = read_robot("robots/kuka-iiwa14.yaml");
    let oracle = Numeric::new(&robot);
    let goal = *oracle.frames(&[0.3, 0.5, -0.2, 1.1, 0.4, -0.8, 0.1]).last().unwrap();
    let folder = folder("ik-swivel");
    let mut header = pose_columns();
    header.push("swivel".into());
    let rows: Vec<Vec<f64>> = [0.0, 0.7].iter().map(|phi| [row(&goal), vec![*phi]].concat()).collect();
    let poses = file(&folder, "poses.csv", csv(&header, &rows));
    let said = json(&["ik", "robots/kuka-iiwa14.yaml", "--poses", &poses, "--json", "-"]);
    let all = said["poses"].as_array().unwrap();
    assert_eq!((all.len(), all[1]["swivel"].as_f64()), (2, Some(0.7)));
    assert_ne!(all[0]["solutions"], all[1]["solutions"]);
    for pose in all {
        assert_eq!(pose["solutions"].as_array().unwrap().len(), 8);
        for s in pose["solutions"].as_array().unwrap() {
            assert!((oracle.frames(&numbers(&s["q"])).last().unwrap() - goal).abs().max() < 1e-12);
        }
    }
}

/// Without a column `swivel` the angle is chosen by the limits, or near the given posture.
#[test]
fn a_swivel_angle_is_chosen() {
    for (name, q) in [
        ("kuka-iiwa14", [0.3, 0.5, -0.2, 1.1, 0.4, -0.8, 0.1]),
        ("kuka-lwr4", [1.3, -1.1, 1.9, 1.6, -2.1, 1.2, -0.7]),
        ("franka-panda", [0.3, 0.5, -0.2, -1.6, 0.4, 1.8, 0.9]),
    ] {
        let path = format!("robots/{name}.yaml");
        let robot = read_robot(&path);
        let goal = *Numeric::new(&robot).frames(&q).last().unwrap();
        let folder = folder(&format!("ik-chosen-{name}"));
        let margin = |pose: &serde_json::Value| {
            let solutions = pose["solutions"].as_array().unwrap();
            solutions.iter().filter_map(|s| s["limit_margin"].as_f64()).fold(f64::NEG_INFINITY, f64::max)
        };
        let run = |file_name: &str, more: &[&str], numbers: &[Vec<f64>]| {
            let mut header = pose_columns();
            header.extend(more.iter().map(|s| s.to_string()));
            let rows: Vec<Vec<f64>> = numbers.iter().map(|numbers| [&row(&goal)[..], numbers].concat()).collect();
            let poses = file(&folder, file_name, csv(&header, &rows));
            json(&["ik", &path, "--poses", &poses, "--json", "-"])
        };
        let chosen = run("chosen.csv", &[], &[Vec::new()]);
        // The Panda has no swivel angle; the position of a locked joint replaces it.
        let locked = chosen["poses"][0]["locked_joint"].as_u64();
        assert_eq!(locked, (name == "franka-panda").then_some(7), "{name}");
        let most = margin(&chosen["poses"][0]);
        assert!(most > 0.0, "{name}: {chosen}");
        let swivels: Vec<Vec<f64>> = (0..24).map(|k| vec![-3.0 + 0.25 * f64::from(k)]).collect();
        let given = run("given.csv", &["swivel"], &swivels);
        let poses = given["poses"].as_array().unwrap();
        assert_eq!(poses.len(), swivels.len(), "{name}");
        for (swivel, pose) in swivels.iter().zip(poses) {
            let other = margin(pose);
            assert!(other <= most + 0.07, "{name}: {other} at {swivel:?}, {most} chosen");
        }
        let names = ["q1", "q2", "q3", "q4", "q5", "q6", "q7"];
        let near = run("near.csv", &names, &[q.to_vec()]);
        let first = numbers(&near["poses"][0]["solutions"][0]["q"]);
        assert!(first.iter().zip(q).all(|(a, b)| (a - b).abs() < 1e-9), "{name}: {first:?}");
    }
}

/// A branch keeps the limits inside its interval and violates them just outside; the best angle has
/// the margin reported.
#[test]
fn swivel_intervals_are_printed() {
    let path = "robots/kuka-iiwa14.yaml";
    let goal = *Numeric::new(&read_robot(path)).frames(&[0.3, 0.5, -0.2, 1.1, 0.4, -0.8, 0.1]).last().unwrap();
    let folder = folder("ik-intervals");
    let poses = file(&folder, "poses.csv", csv(&pose_columns(), &[row(&goal)]));
    let said = json(&["ik", path, "--poses", &poses, "--json", "-"]);
    let ranges = said["poses"][0]["swivel_intervals"].as_array().unwrap();
    assert_eq!(ranges.len(), 8);
    // A second query at angles inside and outside, all in one file.
    let mut header = pose_columns();
    header.push("swivel".into());
    let (mut rows, mut expected) = (Vec::new(), Vec::new());
    for range in ranges {
        for interval in range["intervals"].as_array().unwrap() {
            let ends = numbers(interval);
            for (swivel, inside) in [(ends[0] + 1e-6, true), (ends[1] - 1e-6, true), (ends[0] - 1e-6, false)] {
                if swivel.abs() < 3.1 {
                    rows.push([row(&goal), vec![swivel]].concat());
                    expected.push((range["branch"].clone(), inside, None));
                }
            }
        }
        if let Some(best) = range["best"]["swivel"].as_f64() {
            rows.push([row(&goal), vec![best]].concat());
            expected.push((range["branch"].clone(), true, range["best"]["limit_margin"].as_f64()));
        }
    }
    assert!(expected.len() > 8, "{said}");
    let again = file(&folder, "again.csv", csv(&header, &rows));
    let said = json(&["ik", path, "--poses", &again, "--json", "-"]);
    for (pose, (branch, inside, margin)) in said["poses"].as_array().unwrap().iter().zip(&expected) {
        let own = pose["solutions"].as_array().unwrap().iter().find(|s| s["branch"] == *branch).unwrap();
        assert_eq!(own["within_limits"].as_bool(), Some(*inside), "{own}");
        if let Some(margin) = margin {
            assert!((own["limit_margin"].as_f64().unwrap() - margin).abs() < 1e-9);
        }
    }
    let text = denavit(&["ik", path, "--poses", &poses]);
    assert!(text.out.contains("swivel angles, rad, at which a branch respects the limits"), "{}", text.out);
}

/// With `--tool` the poses are the tool's.
#[test]
fn the_tool_counts_when_asked() {
    let robot = read_robot("robots/planar2r.yaml");
    let oracle = Numeric::new(&robot);
    let folder = folder("ik-tool");
    let q = [0.4, 0.9];
    let poses = file(&folder, "poses.csv", csv(&pose_columns(), &[row(&oracle.tool(&q))]));
    let met = |arguments: &[&str]| {
        let said = json(arguments);
        said["poses"][0]["solutions"]
            .as_array()
            .unwrap()
            .iter()
            .any(|s| numbers(&s["q"]).iter().zip(q).all(|(a, b)| (a - b).abs() < 1e-9))
    };
    assert!(met(&["ik", "robots/planar2r.yaml", "--poses", &poses, "--tool", "--json", "-"]));
    assert!(!met(&["ik", "robots/planar2r.yaml", "--poses", &poses, "--json", "-"]));
}

/// A robot without a closed form: six joints, none of their axes parallel or intersecting.
const GENERAL: &str = "name: general\nconvention: modified\njoints:
  - { type: revolute, r: 0.3 }
  - { type: revolute, alpha: 1.2, d: 0.1, r: 0.11 }
  - { type: revolute, alpha: -0.8, d: 0.35, r: -0.07 }
  - { type: revolute, alpha: 1.1, d: 0.06, r: 0.31 }
  - { type: revolute, alpha: -1.3, d: 0.05, r: 0.09 }
  - { type: revolute, alpha: 0.9, d: 0.08, r: 0.12 }
";

/// Poses of four postures of a robot file, and one far out of reach.
fn some_poses(folder: &std::path::Path, robot: &str) -> String {
    let robot = read_robot(robot);
    let (oracle, dof) = (Numeric::new(&robot), robot.dof());
    let mut random = Random::new(3);
    let mut rows: Vec<Vec<f64>> =
        (0..4).map(|_| row(oracle.frames(&random.vector(dof, 1.5)).last().unwrap())).collect();
    rows.push(vec![1.0, 0.0, 0.0, 9.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
    file(folder, "poses.csv", csv(&pose_columns(), &rows))
}

/// Six revolute joints in general position: all postures are found, or it is proved that there is
/// none.
#[test]
fn a_general_arm_is_solved_exactly() {
    let folder = folder("ik-general");
    let robot = file(&folder, "general.yaml", GENERAL);
    let poses = some_poses(&folder, &robot);
    assert_eq!(json(&["check", &robot, "--json", "-"])["ik"]["exact"], true);
    let said = json(&["ik", &robot, "--poses", &poses, "--json", "-"]);
    assert_eq!((&said["class"], &said["exact"]), (&"none".into(), &true.into()));
    assert_eq!(said["method"], "elimination");
    for pose in said["poses"].as_array().unwrap() {
        assert_eq!((&pose["branches_uncertain"], &pose["branches_lost"]), (&false.into(), &0.into()), "{pose}");
        assert_eq!(pose["solutions"].as_array().unwrap().len() % 2, 0, "{pose}");
    }
    let last = &said["poses"][4];
    assert_eq!((&last["status"], &last["not_found"]), (&"unreachable".into(), &false.into()));
    let text = denavit(&["ik", &robot, "--poses", &poses]).out;
    assert!(text.contains("polynomial of degree 16") && text.contains("pose 5: unreachable, by"), "{text}");
}

/// One, two and three of the joints are prismatic.
#[test]
fn general_arms_with_joints_that_slide_are_solved_exactly() {
    let folder = folder("ik-sliding");
    let mut text = GENERAL.to_string();
    for (k, joint) in ["revolute, alpha: 1.1", "revolute, alpha: 1.2", "revolute, alpha: 0.9"].into_iter().enumerate() {
        text = text.replacen(joint, &joint.replace("revolute", "prismatic"), 1);
        let robot = file(&folder, &format!("{k}.yaml"), &text);
        let poses = some_poses(&folder, &robot);
        assert_eq!(json(&["check", &robot, "--json", "-"])["ik"]["exact"], true);
        let said = json(&["ik", &robot, "--poses", &poses, "--json", "-"]);
        assert_eq!((&said["exact"], &said["method"]), (&true.into(), &"elimination".into()));
        for pose in said["poses"].as_array().unwrap().iter().take(4) {
            assert_eq!(pose["branches_uncertain"], false, "{pose}");
            let solutions = pose["solutions"].as_array().unwrap();
            assert!(!solutions.is_empty() && solutions.len() % 2 == 0, "{pose}");
        }
    }
}

/// Seven revolute joints: intervals of the locked joint within the limits.
#[test]
fn positions_of_a_locked_joint_are_printed() {
    let folder = folder("ik-seven");
    let seven = format!("{GENERAL}  - {{ type: revolute, alpha: -1.0, d: 0.07, r: 0.1 }}\n");
    let seven = seven.replace("revolute,", "revolute, position: [-1.8, 1.8],");
    let robot = file(&folder, "seven.yaml", seven);
    let poses = some_poses(&folder, &robot);
    let said = json(&["ik", &robot, "--poses", &poses, "--json", "-"]);
    assert_eq!((&said["exact"], &said["poses"][0]["locked_joint"]), (&true.into(), &7.into()));
    for pose in said["poses"].as_array().unwrap().iter().take(4) {
        let ranges = &pose["locked_intervals"];
        assert!(!ranges["intervals"].as_array().unwrap().is_empty(), "{pose}");
        // Without a column `swivel` the best position is used.
        assert_eq!(ranges["best"]["position"], pose["swivel"], "{pose}");
        let best = ranges["best"]["limit_margin"].as_f64().unwrap();
        let margins = pose["solutions"].as_array().unwrap().iter().map(|s| s["limit_margin"].as_f64().unwrap());
        assert!((margins.fold(f64::NEG_INFINITY, f64::max) - best).abs() < 1e-9 && best >= 0.0, "{pose}");
    }
    let text = denavit(&["ik", &robot, "--poses", &poses]).out;
    assert!(text.contains("positions of q7 at which a posture respects the limits"), "{text}");
}

/// A numerical search does not claim that it has every posture, nor that there is none.
#[test]
fn a_search_does_not_say_that_it_has_all() {
    let folder = folder("ik-search");
    // Eight joints: too many for the elimination.
    let more = "  - { type: revolute, alpha: -1.0, d: 0.07, r: 0.1 }\n";
    let robot = file(&folder, "eight.yaml", format!("{GENERAL}{more}{more}"));
    let poses = some_poses(&folder, &robot);
    assert_eq!(json(&["check", &robot, "--json", "-"])["ik"]["exact"], false);
    let said = json(&["ik", &robot, "--poses", &poses, "--json", "-"]);
    assert_eq!((&said["class"], &said["exact"]), (&"none".into(), &false.into()));
    assert_eq!(said["method"], "numerical search");
    for pose in said["poses"].as_array().unwrap() {
        assert_eq!(pose["branches_uncertain"], true, "{pose}");
    }
    let text = denavit(&["ik", &robot, "--poses", &poses]).out;
    assert!(text.contains("found by search"), "{text}");
    let five = file(&folder, "five.yaml", GENERAL.lines().take(8).collect::<Vec<_>>().join("\n"));
    let said = json(&["ik", &five, "--poses", &poses, "--json", "-"]);
    let last = &said["poses"][4];
    assert_eq!((&last["status"], &last["not_found"]), (&"unreachable".into(), &true.into()));
    let text = denavit(&["ik", &five, "--poses", &poses]).out;
    assert!(text.contains("pose 5: not found, by") && !text.contains("unreachable"), "{text}");
    let exact = json(&["ik", "robots/puma560.yaml", "--poses", &poses, "--json", "-"]);
    assert_eq!((&exact["method"], &exact["poses"][4]["not_found"]), (&"closed form".into(), &false.into()));
}

/// A mistake is reported with its place and status 2.
#[test]
fn wrong_poses_are_told() {
    let folder = folder("ik-wrong");
    let good = row(&nalgebra::Matrix4::identity());
    let cases = [
        (csv(&pose_columns()[1..], &[good[1..].to_vec()]), "no column r11"),
        (csv(&pose_columns(), &[vec![2.0; 12]]), "not a rotation"),
        (csv(&pose_columns(), core::slice::from_ref(&good)).replacen("1,0,0,0", "-1,0,0,0", 1), "a reflection"),
        (csv(&pose_columns(), core::slice::from_ref(&good)).replace("1,0,0,0", "1,NaN,0,0"), "not a finite number"),
        (csv(&pose_columns(), &[]), "a header and no pose"),
    ];
    for (k, (text, expected)) in cases.into_iter().enumerate() {
        let poses = file(&folder, &format!("{k}.csv"), text);
        let run = denavit(&["ik", "robots/ur10e.yaml", "--poses", &poses, "--json", "-"]);
        assert_eq!(run.status, Some(2));
        assert!(run.err.contains(expected) && run.out.is_empty(), "{}", run.err);
    }
    let poses = file(
        &folder,
        "far.csv",
        csv(&pose_columns(), &[vec![1.0, 0.0, 0.0, 9.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0]]),
    );
    let said = json(&["ik", "robots/ur10e.yaml", "--poses", &poses, "--json", "-"]);
    assert_eq!(said["poses"][0]["status"], "unreachable");
    assert!(said["poses"][0]["distance"]["position"].as_f64().unwrap() > 7.0);
}
