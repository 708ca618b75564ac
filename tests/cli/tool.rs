//! Tests of `denavit tool`: recognition of a tool on a known arm.

use std::sync::OnceLock;

use denavit::apps::paper::tool::Waves;
use denavit::identify::tool::{MINI_ROLLERS, catalogue};
use denavit::model::rigid_body::Numeric;
use denavit::numerics::prng::Random;
use dh_codegen::arm::param;
use dh_codegen::robot::Tool;
use serde_json::Value;

use super::*;

const ROBOT: &str = "robots/kuka-lwr4.yaml";
const TOOLS: &str = "robots/tools";
const NOISE: f64 = 0.05; // N m, half the width of an even distribution, white at 250 Hz

/// A log of 12 s at 250 Hz of the arm with this tool.
fn record(tool: Option<&Tool>, seed: u64) -> String {
    let mut robot = read_robot(ROBOT);
    robot.tool = tool.cloned();
    let (arm, phi, mut random) = (Numeric::new(&robot), param::standard_values(&robot).unwrap(), Random::new(seed));
    let waves = Waves::random(&robot, 12.0, &mut random);
    let rows: Vec<Vec<f64>> = (0..3000)
        .map(|k| {
            let t = f64::from(k) / 250.0;
            let [q, dq, ddq] = waves.at(t);
            let tau = arm.inverse_dynamics(&q, &dq, &ddq, &phi);
            let noisy = tau.iter().map(|tau| tau + random.even(NOISE));
            std::iter::once(t).chain(q.iter().copied()).chain(noisy).collect()
        })
        .collect();
    csv(&[vec!["t".to_string()], columns(&["q", "tau"], 7)].concat(), &rows)
}

fn tool(name: &str) -> Tool {
    catalogue().into_iter().find(|t| t.name == name).unwrap()
}

/// Ten parameters of the tool in the last frame.
fn truth(tool: &Tool) -> [f64; 10] {
    tool.inertia.unwrap().moved(&tool.rotation(), &tool.xyz).to_array()
}

struct Logs {
    folder: PathBuf,
    empty: String,
    large: String,
}

fn logs() -> &'static Logs {
    static ONCE: OnceLock<Logs> = OnceLock::new();
    ONCE.get_or_init(|| {
        let folder = folder("tool");
        let empty = file(&folder, "empty.csv", record(None, 1));
        let large = file(&folder, "large.csv", record(Some(&tool("large-roller")), 2));
        Logs { folder, empty, large }
    })
}

fn ten(said: &Value) -> Vec<f64> {
    [vec![said["M"].as_f64().unwrap()], numbers(&said["MS"]), numbers(&said["I"])].concat()
}

fn agrees(said: &Value, truth: &[f64; 10]) {
    for (k, ((value, std), truth)) in ten(said).iter().zip(numbers(&said["std"])).zip(truth).enumerate() {
        assert!((value - truth).abs() <= 4.5 * std + 1e-12, "parameter {k}: {value} +- {std}, is {truth}");
    }
}

#[test]
fn the_large_roller_is_found_from_both_logs() {
    let logs = logs();
    let page = logs.folder.join("tool.html").display().to_string();
    let said = json(&[
        "tool",
        ROBOT,
        "--unloaded",
        &logs.empty,
        "--loaded",
        &logs.large,
        "--tools",
        TOOLS,
        "--json",
        "-",
        "--report",
        &page,
    ]);
    let truth = truth(&tool("large-roller"));
    agrees(&said, &truth);
    assert!((ten(&said)[0] / truth[0] - 1.0).abs() < 0.02);
    let percent = numbers(&said["relative_std_percent"]);
    assert_eq!(percent.len(), 10);
    for (k, percent) in percent.iter().enumerate() {
        let expected = 100.0 * numbers(&said["std"])[k] / ten(&said)[k].abs();
        assert!((percent - expected).abs() < 1e-9 * expected);
    }
    let recognised = &said["recognised"];
    assert_eq!(recognised["name"], "large-roller");
    assert_eq!(recognised["rejected"], false);
    assert!(recognised["distance"].as_f64().unwrap() < recognised["limit"].as_f64().unwrap());
    // Its own frame is the table's; mass and centre in it are those of the file.
    let frame = &said["tool_frame"];
    assert_eq!(frame["tool"], "large-roller");
    assert!((frame["MS"][2].as_f64().unwrap() - 0.0484).abs() < 0.002, "{frame}");
    let [length, width] = ["length", "width"].map(|k| numbers(&said["size"][k]["interval"]));
    assert!(length[0] < 0.35 && 0.35 < length[1] && length[1] - length[0] < 0.03, "{length:?}");
    assert!(width[0] < 0.20 && 0.20 < width[1] && width[1] - width[0] < 0.06, "{width:?}");
    let page = std::fs::read_to_string(page).unwrap();
    for part in ["large-roller", "MSZ", "principal", "empty.csv", "large.csv"] {
        assert!(page.contains(part), "{part}");
    }
    for outside in ["src=\"http", "src='http", "src=http", "<link", "@import", "fetch(", "NaN"] {
        assert!(!page.contains(outside), "{outside}");
    }
}

#[test]
fn the_errors_of_an_identified_robot_are_counted() {
    let logs = logs();
    let [robot, identified] = ["robot.yaml", "robot.json"].map(|name| logs.folder.join(name).display().to_string());
    let run = denavit(&["identify", ROBOT, &logs.empty, "--out", &robot, "--json", &identified]);
    assert_eq!(run.status, Some(0), "{}", run.err);
    let exact = json(&["tool", &robot, "--loaded", &logs.large, "--json", "-"]);
    let counted = json(&["tool", &robot, "--loaded", &logs.large, "--identified", &identified, "--json", "-"]);
    assert_eq!((&exact["robot_errors"], &counted["robot_errors"]), (&"not_counted".into(), &"counted".into()));
    assert!(exact["warnings"].to_string().contains("taken as exact"), "{}", exact["warnings"]);
    assert!(!counted["warnings"].to_string().contains("taken as exact"), "{}", counted["warnings"]);
    agrees(&counted, &truth(&tool("large-roller")));
    let [narrow, wide] = [&exact, &counted].map(|said| numbers(&said["std"]));
    assert!(narrow.iter().zip(&wide).all(|(a, b)| a <= b) && wide[0] > 1.05 * narrow[0], "{narrow:?} {wide:?}");
    let run = denavit(&["tool", &robot, "--loaded", &logs.large, "--mount", "0,0,0.1"]);
    assert_eq!(run.status, Some(2), "{}", run.out);
    let run = denavit(&["tool", &robot, "--loaded", &logs.large, "--on-top"]);
    assert!(run.status == Some(2) && run.err.contains("has no tool"), "{}", run.err);
}

#[test]
fn a_known_robot_and_a_scale_say_more() {
    let logs = logs();
    let alone = |more: &[&str]| {
        json(&[&["tool", ROBOT, "--loaded", &logs.large, "--tools", TOOLS, "--json", "-"], more].concat())
    };
    let truth = truth(&tool("large-roller"));
    let (free, refreshed, weighed) = (alone(&[]), alone(&["--refresh-friction"]), alone(&["--known-mass", "0.2"]));
    for said in [&free, &refreshed, &weighed] {
        agrees(said, &truth.map(|v| if said["known_mass"].is_null() { v } else { v * 0.2 / truth[0] }));
        assert_eq!(said["recognised"]["name"], "large-roller");
        assert_eq!(said["robot_identified"], false);
    }
    // A scale of this accuracy is combined with the logs: the result is between the two, and more
    // accurate than either.
    let [mass, std] =
        [0, 1].map(|k| if k == 0 { free["M"].as_f64().unwrap() } else { free["std"][0].as_f64().unwrap() });
    let reads = mass + 2.0 * std;
    let rough = alone(&["--known-mass", &reads.to_string(), "--mass-std", &std.to_string()]);
    assert!((rough["M"].as_f64().unwrap() - (mass + std)).abs() < 1e-3 * std, "{rough}");
    assert!((rough["std"][0].as_f64().unwrap() / std - 0.5f64.sqrt()).abs() < 1e-6);
    assert!((rough["mass_of_logs"]["M"].as_f64().unwrap() - mass).abs() < 1e-12);
    // Grams in place of kilograms contradict the logs and are reported; so is an unloaded log that
    // has a load.
    let said = |arguments: &[&str]| denavit(&[&["tool", ROBOT], arguments].concat()).out;
    assert!(said(&["--loaded", &logs.large, "--known-mass", "200"]).contains("contradict the logs"));
    assert!(said(&["--unloaded", &logs.large, "--loaded", &logs.empty]).contains("exchanged"));
    assert_eq!(weighed["M"], 0.2);
    assert_eq!(weighed["relative_std_percent"][0], 0.0);
    let std = |said: &Value, k: usize| said["std"][k].as_f64().unwrap();
    // Weights are estimated each time, so a tolerance of a twentieth is allowed.
    assert!(std(&weighed, 4) <= 1.05 * std(&free, 4) && std(&free, 4) <= 1.05 * std(&refreshed, 4));
}

#[test]
fn an_unknown_roller_is_rejected_and_measured() {
    let logs = logs();
    let (length, width) = (0.40, 0.085);
    let other = Tool { inertia: Some(MINI_ROLLERS.roller(length, width)), ..tool("small-roller") };
    let loaded = file(&logs.folder, "other.csv", record(Some(&other), 7));
    let said = json(&["tool", ROBOT, "--unloaded", &logs.empty, "--loaded", &loaded, "--tools", TOOLS, "--json", "-"]);
    agrees(&said, &truth(&other));
    assert_eq!(said["recognised"]["rejected"], true, "{}", said["recognised"]);
    assert_eq!(said["size"]["family"], "mini-roller");
    assert_eq!(said["size"]["fits"], true);
    for (key, truth) in [("length", length), ("width", width)] {
        let interval = numbers(&said["size"][key]["interval"]);
        assert!(interval[0] < truth && truth < interval[1], "{key}: {interval:?}");
    }
    let told = denavit(&["tool", ROBOT, "--unloaded", &logs.empty, "--loaded", &loaded, "--tools", TOOLS]);
    assert_eq!(told.status, Some(0), "{}", told.err);
    assert!(told.out.contains("none of the 28 tools") && told.out.contains("mini-roller"), "{}", told.out);
}

/// A user's table: another pose, rotated, and a robot file with the tool's pose.
#[test]
fn a_tool_in_a_turned_frame() {
    let logs = logs();
    let (mine, table) = (logs.folder.join("mine"), &logs.folder);
    std::fs::create_dir_all(&mine).unwrap();
    let text = "name: probe\npose: { xyz: [0.02, -0.01, 0.12], rpy: [pi/2, 0, 0.3] }\nM: 0.8\nMS: [0.04, 0, 0.08]\nI: [0.02, 0.022, 0.008, 0, -0.002, 0]\n";
    let probe = file(&mine, "probe.yaml", text);
    file(&mine, "twice.yaml", text.replace("probe", "heavier").replace("0.8", "0.9"));
    let (read, _) = Tool::from_yaml(text, "probe").unwrap();
    let loaded = file(table, "probe.csv", record(Some(&read), 5));
    let folder = mine.display().to_string();
    let said =
        json(&["tool", ROBOT, "--unloaded", &logs.empty, "--loaded", &loaded, "--tools", &folder, "--json", "-"]);
    agrees(&said, &truth(&read));
    assert_eq!(said["recognised"]["name"], "probe");
    assert_eq!(said["recognised"]["rejected"], false);
    for (k, (inside, file)) in numbers(&said["tool_frame"]["MS"]).iter().zip([0.04, 0.0, 0.08]).enumerate() {
        assert!((inside - file).abs() < 0.004, "{k}: {inside} {file}");
    }
    // The same arm with the probe in its file: the file's tool counts as removed, so the probe is
    // found again.
    let robot = std::fs::read_to_string(ROBOT).unwrap() + &format!("tool: {}\n", "probe.yaml");
    let robot = file(&mine, "robot.txt", robot);
    assert!(std::path::Path::new(&probe).exists());
    let again =
        json(&["tool", &robot, "--loaded", &loaded, "--tools", &folder, "--json", "-", "--mount", "0.02,-0.01,0.12"]);
    agrees(&again, &truth(&read));
    let on_top = json(&["tool", &robot, "--loaded", &loaded, "--on-top", "--json", "-"]);
    agrees(&on_top, &[0.0; 10]);
    assert!(on_top["recognised"].is_null());
}

/// Two unloaded logs: a mass within its deviation, and no centre.
#[test]
fn of_an_empty_hand() {
    let logs = logs();
    let run = denavit(&["tool", ROBOT, "--loaded", &logs.empty]);
    assert_eq!(run.status, Some(0), "{}", run.err);
    assert!(run.out.contains("nothing in the hand, or less than the noise lets see"), "{}", run.out);
    assert!(!run.out.contains("The arm carries"), "{}", run.out);
    let run = denavit(&["tool", ROBOT, "--loaded", &logs.empty, "--tools", TOOLS]);
    assert!(run.out.contains("nothing in the hand") && !run.out.contains("It is none"), "{}", run.out);
}

/// Two torque columns of the loaded log exchanged: this is reported, and nothing else advised.
#[test]
fn exchanged_columns_are_named() {
    let logs = logs();
    let text = std::fs::read_to_string(&logs.large).unwrap().replacen("tau2,tau3", "tau3,tau2", 1);
    let exchanged = file(&folder("tool-exchanged"), "exchanged.csv", text);
    let run = denavit(&["tool", ROBOT, "--unloaded", &logs.empty, "--loaded", &exchanged]);
    assert!(run.out.contains("exchanged.csv: torque columns stand in another order"), "{}", run.out);
    assert!(!run.out.contains("friction of this joint") && !run.out.contains("empty.csv: torque"), "{}", run.out);
}

#[test]
fn of_wrong_use() {
    let logs = logs();
    let fails = |arguments: &[&str], parts: &[&str]| {
        let run = denavit(&[&["tool"], arguments].concat());
        assert_eq!(run.status, Some(2), "{arguments:?}: {}", run.err);
        assert!(run.out.is_empty() && run.err.starts_with("denavit: "));
        for part in parts {
            assert!(run.err.contains(part), "{arguments:?}: no `{part}` in: {}", run.err);
        }
    };
    let large = logs.large.as_str();
    fails(&[ROBOT], &["--loaded", "--help"]);
    fails(&["robots/stanford.yaml", "--loaded", large], &["large.csv", "6"]);
    fails(&[ROBOT, "--loaded", large, "--tools", "no/such"], &["no/such", "--tools"]);
    fails(&[ROBOT, "--loaded", large, "--tools", "data"], &["data", "no tool file"]);
    fails(&[ROBOT, "--loaded", large, "--known-mass", "0"], &["0 kg", "positive"]);
    fails(&[ROBOT, "--loaded", large, "--known-mass", "-1"], &["-1 kg", "positive"]);
    fails(&[ROBOT, "--loaded", large, "--tools", "robots/tools", "--level", "2"], &["--level 2"]);
    fails(&[ROBOT, "--loaded", large, "--trim", "-1"], &["--trim -1: seconds"]);
    fails(&[ROBOT, "--loaded", large, "--dead-zone", "nan"], &["--dead-zone NaN"]);
    fails(&[ROBOT, "--loaded", large, "--unloaded", large], &["large.csv: the same log", "empty hand"]);
    let without = |flag| fails(&[ROBOT, "--loaded", large, "--unloaded", &logs.empty, flag], &[flag, "--unloaded"]);
    without("--on-top");
    let bare = folder("tool-frictionless");
    let mut robot = read_robot(ROBOT);
    robot.joints.iter_mut().for_each(|joint| joint.drive = Default::default());
    let bare = file(&bare, "bare.yaml", robot.to_yaml());
    fails(&[&bare, "--loaded", large, "--refresh-friction"], &["--refresh-friction", "no friction"]);
    without("--refresh-friction");
    fails(&[ROBOT, "--loaded", large, "--tools", "robots/tools", "--tolerance", "1,2"], &["--tolerance", "give three"]);
    fails(&[ROBOT, "--loaded", "no.csv"], &["no.csv", "check the path"]);
    // A robot with unknown links needs the unloaded log.
    fails(&["robots/kuka-lbr-med7.yaml", "--loaded", large], &["--unloaded", "identify"]);
    let bad = folder("tool-bad");
    file(&bad, "bad.yaml", "name: bad\nM: 1\n");
    fails(&[ROBOT, "--loaded", large, "--tools", &bad.display().to_string()], &["bad.yaml", "M without MS, I"]);
    file(&bad, "bad.yaml", "name: twice\nM: 1\nMS: [0, 0, 0]\nI: [1, 1, 1, 0, 0, 0]\n");
    file(&bad, "worse.yaml", "name: twice\nM: 1\nMS: [0, 0, 0]\nI: [1, 1, 1, 0, 0, 0]\n");
    fails(&[ROBOT, "--loaded", large, "--tools", &bad.display().to_string()], &["worse.yaml", "twice"]);
}
