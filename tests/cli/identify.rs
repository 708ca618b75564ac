//! Tests of `denavit identify` on logs of a robot with known parameters.

use std::io::Write;
use std::sync::OnceLock;

use denavit::model::rigid_body::Numeric;
use denavit::numerics::prng::Random;
use dh_codegen::arm::{BaseParameters, param};
use serde_json::Value;

use super::*;

const ROBOT: &str = "robots/kuka-lwr4.yaml";
const NOISE: f64 = 0.005; // N m, standard deviation of the torque signal

/// A log of the robot in a periodic motion (five harmonics of 0.1 Hz per joint, within a rad or
/// so), 250 samples per second.
pub(super) fn record(seconds: usize, seed: u64) -> String {
    record_with(seconds, seed, |_, _, _| {})
}

/// The same with additional motor torques, as a function of velocities and accelerations.
fn record_with(seconds: usize, seed: u64, more: impl Fn(&[f64], &[f64], &mut [f64])) -> String {
    let robot = read_robot(ROBOT);
    let (arm, phi) = (Numeric::new(&robot), param::standard_values(&robot).unwrap());
    let (n, mut random) = (arm.dof(), Random::new(seed));
    let waves: Vec<Vec<[f64; 3]>> = (0..n)
        .map(|_| {
            (1..=5).map(|k| [random.even(0.45), 0.2 * std::f64::consts::PI * k as f64, random.even(3.0)]).collect()
        })
        .collect();
    let rest = random.vector(n, 0.8);
    let rows: Vec<Vec<f64>> = (0..250 * seconds)
        .map(|sample| {
            let t = sample as f64 / 250.0;
            let sum = |joint: &Vec<[f64; 3]>, derivative: i32| -> f64 {
                // The k-th derivative of a sine is a sine that leads by k quarter turns.
                let lead = std::f64::consts::FRAC_PI_2 * f64::from(derivative);
                joint.iter().map(|[a, w, phase]| a * w.powi(derivative) * (w * t + phase + lead).sin()).sum()
            };
            let q: Vec<f64> = waves.iter().zip(&rest).map(|(joint, rest)| rest + sum(joint, 0)).collect();
            let [dq, ddq] = [1, 2].map(|k| waves.iter().map(|joint| sum(joint, k)).collect::<Vec<f64>>());
            let mut tau: Vec<f64> = arm.inverse_dynamics(&q, &dq, &ddq, &phi).iter().copied().collect();
            more(&dq, &ddq, &mut tau);
            // The sum of three uniform draws is near enough to normal; each has the variance 1/3.
            let noisy = tau.iter().map(|tau| tau + NOISE * (random.even(1.0) + random.even(1.0) + random.even(1.0)));
            std::iter::once(t).chain(q.iter().copied()).chain(noisy).collect()
        })
        .collect();
    csv(&[vec!["t".to_string()], columns(&["q", "tau"], n)].concat(), &rows)
}

/// One run of the command for all tests, as it takes seconds.
struct Identified {
    folder: PathBuf,
    fit: String,
    validate: String,
    said: Value,
}

fn identified() -> &'static Identified {
    static ONCE: OnceLock<Identified> = OnceLock::new();
    ONCE.get_or_init(|| {
        let folder = folder("identify");
        let fit = file(&folder, "fit.csv", record(30, 1));
        let validate = file(&folder, "validate.csv", record(10, 2));
        let [out, report] = ["identified.yaml", "identified.html"].map(|f| folder.join(f).display().to_string());
        let more = ["--validate", &validate, "--out", &out, "--report", &report, "--json", "-"];
        let said = json(&[&["identify", ROBOT, &fit][..], &more].concat());
        Identified { folder, fit, validate, said }
    })
}

fn values(said: &Value) -> Vec<f64> {
    said["parameters"].as_array().unwrap().iter().map(|p| p["value"].as_f64().unwrap()).collect()
}

#[test]
fn an_unknown_column_is_one_line_on_standard_error() {
    let folder = folder("identify-unknown-column");
    let text: Vec<String> = record(10, 3)
        .lines()
        .enumerate()
        .map(|(k, l)| format!("{l},{}", if k == 0 { "mode" } else { "auto" }))
        .collect();
    let log = file(&folder, "mode.csv", text.join("\n") + "\n");
    let page = folder.join("page.html").display().to_string();
    for verb in
        [&["identify", ROBOT, &log, "--report", &page, "--json", "-"][..], &["force", ROBOT, &log, "--json", "-"]]
    {
        let run = denavit(verb);
        assert_eq!(run.status, Some(0), "{}", run.err);
        let told: Vec<&str> =
            run.err.lines().filter(|l| l.contains("mode.csv: warning:") && l.contains("mode (")).collect();
        assert_eq!(told.len(), 1, "{}", run.err);
    }
}

#[test]
fn the_parameters_of_the_robot_are_found() {
    let (said, robot) = (&identified().said, read_robot(ROBOT));
    let base = BaseParameters::new(&robot);
    let truth = base.values(&param::standard_values(&robot).unwrap());
    let found = said["parameters"].as_array().unwrap();
    assert_eq!(found.len(), truth.len());
    let mut sharp = 0;
    for ((parameter, base), truth) in found.iter().zip(&base.0).zip(truth) {
        assert_eq!(parameter["name"], base.name);
        let [value, std] = ["value", "std"].map(|key| parameter[key].as_f64().unwrap());
        let error = (value - truth).abs();
        // Allows for the bias of filter and differences in addition to the scatter: half a per
        // cent, or 2e-4 of a nearly zero parameter.
        assert!(error < 5.0 * std + 0.005 * truth.abs() + 2e-4, "{}: {value} +- {std}, is {truth}", base.name);
        if std < 0.003 * value.abs() {
            assert!(error < 0.01 * truth.abs(), "{}: {value} +- {std}, is {truth}", base.name);
            sharp += 1;
        }
    }
    // The others are nearly zero in this arm: products of inertia of symmetric links, and the
    // hand's.
    assert!(sharp >= 22, "only {sharp} are sharp");
}

/// The motor of joint 7 turns with joint 6: its three parameters are found, and written where the
/// file names the coupling.
#[test]
fn a_coupled_motor_is_identified() {
    let folder = folder("identify-coupled");
    let (ratio, [iam, fvm, fcm]) = (-0.5, [0.04, 0.3, 0.8]);
    let log = record_with(20, 11, |dq, ddq, tau| {
        let sign = (dq[6] + ratio * dq[5]).signum();
        tau[5] += ratio * (iam * ddq[6] + fvm * dq[6] + fcm * sign);
        tau[6] += ratio * (iam * ddq[5] + fvm * dq[5]) + fcm * sign;
    });
    let text = std::fs::read_to_string(ROBOT).unwrap();
    let friction = "viscous_friction: 0.08, coulomb_friction: 0.2 }";
    assert_eq!(text.matches(friction).count(), 1);
    let text = text.replace(friction, &format!("{friction}, gear_coupling: {{ joint: 6, KC: {ratio} }}"));
    let (robot, log) = (file(&folder, "coupled.yaml", text), file(&folder, "log.csv", log));
    let out = folder.join("out.yaml").display().to_string();
    let said = json(&["identify", &robot, &log, "--out", &out, "--json", "-"]);
    let found = said["parameters"].as_array().unwrap();
    for (name, truth) in [("IAM7", iam), ("FVM7", fvm), ("FCM7", fcm)] {
        let parameter = found.iter().find(|p| p["name"] == name).unwrap();
        let [value, std] = ["value", "std"].map(|key| parameter[key].as_f64().unwrap());
        // The sign of the motor's speed passes through the low-pass of the torques, as a joint's
        // own does; otherwise a fifth would be missing.
        assert!((value - truth).abs() < 3.0 * std + 0.02 * truth, "{name}: {value} +- {std}, is {truth}");
        assert!(std < 0.1 * truth, "{name}: {value} +- {std}");
    }
    let written = read_robot(&out);
    let effect = &written.joints[6].drive.effects[0];
    assert_eq!(effect.name(), "gear_coupling");
    for (key, truth) in [("joint", 6.0), ("KC", ratio), ("IAM", iam), ("FVM", fvm), ("FCM", fcm)] {
        let value = effect.get(key).unwrap();
        assert!((value - truth).abs() < 0.05 * truth.abs(), "{key}: {value}, is {truth}");
    }
}

#[test]
fn the_json_has_what_the_contract_lists() {
    let said = &identified().said;
    for parameter in said["parameters"].as_array().unwrap() {
        assert!(parameter["name"].is_string() && parameter["value"].is_f64());
        assert!(parameter["relative_std_percent"].is_f64(), "{parameter}");
    }
    for key in ["rms", "nrms"] {
        for set in ["fit", "validate"] {
            assert_eq!(numbers(&said[key][set]).len(), 7);
        }
    }
    let against = &said["consistent"]["against_plain"]["validate"];
    let [low, high] = [0, 1].map(|k| against["interval"][k].as_f64().unwrap());
    let percent = against["percent"].as_f64().unwrap();
    assert!(low <= percent && percent <= high && against["stretches"].as_u64().unwrap() > 3, "{against}");
    assert!(said["condition_number"].as_f64().unwrap() > 1.0);
    assert!(said["samples"].as_u64().unwrap() > 7000);
    // The low-pass removes most of the noise; its own error and that of the differences grow with
    // the torque.
    for set in ["fit", "validate"] {
        for (rms, torque) in numbers(&said["rms"][set]).iter().zip(numbers(&said["torque_rms"][set])) {
            assert!(*rms < NOISE + 0.0005 * torque, "{set}: {rms} of {torque}");
        }
    }
}

/// Base parameters of the written file: the plain ones if they are possible, else those of the
/// consistent bodies.
fn written(said: &Value) -> Vec<f64> {
    assert_eq!(said["consistent"]["written"], true);
    if said["consistent"]["written_is_plain"] == true { values(said) } else { values(&said["consistent"]) }
}

#[test]
fn the_robot_file_reads_back_and_predicts_the_same() {
    let run = identified();
    let out = run.folder.join("identified.yaml").display().to_string();
    assert_eq!(denavit(&["check", &out]).status, Some(0));
    let robot = read_robot(&out);
    let base = BaseParameters::new(&robot).values(&param::standard_values(&robot).unwrap());
    for (file, said) in base.iter().zip(written(&run.said)) {
        assert!((file - said).abs() < 1e-9 * (1.0 + said.abs()), "{file} {said}");
    }
    let mut random = Random::new(5);
    let states = csv(&columns(&["q", "dq", "ddq"], 7), &[random.vector(21, 1.5), random.vector(21, 1.5)]);
    let states = file(&run.folder, "states.csv", states);
    let eval = |robot: &str, quantity: &str| json(&["eval", robot, "--quantity", quantity, "--states", &states]);
    let (tau, w) = (eval(&out, "inverse_dynamics"), eval(ROBOT, "base_regressor"));
    for state in 0..2 {
        let (tau, w) = (numbers(&tau["values"][state]), numbers(&w["values"][state]));
        for (joint, row) in w.chunks(base.len()).enumerate() {
            let predicted: f64 = row.iter().zip(written(&run.said)).map(|(w, b)| w * b).sum();
            assert!((tau[joint] - predicted).abs() < 1e-8, "joint {joint}: {} {predicted}", tau[joint]);
        }
    }
}

#[test]
fn the_page_stands_alone_and_shows_every_joint_and_parameter() {
    let run = identified();
    let page = std::fs::read_to_string(run.folder.join("identified.html")).unwrap();
    for joint in 1..=7 {
        assert!(page.contains(&format!("<tr><th>{joint}<td>")), "joint {joint}");
    }
    for parameter in run.said["parameters"].as_array().unwrap() {
        assert!(page.contains(parameter["name"].as_str().unwrap()));
    }
    assert!(page.contains("fit.csv") && page.contains("validate.csv"));
    for outside in ["src=\"http", "src='http", "src=http", "<link", "@import", "fetch("] {
        assert!(!page.contains(outside), "{outside}");
    }
}

#[test]
fn a_gzipped_log_says_the_same() {
    let run = identified();
    let path = run.folder.join("fit.csv.gz");
    let mut packed = flate2::write::GzEncoder::new(std::fs::File::create(&path).unwrap(), flate2::Compression::fast());
    packed.write_all(&std::fs::read(&run.fit).unwrap()).unwrap();
    packed.finish().unwrap();
    let said = json(&["identify", ROBOT, &path.display().to_string(), "--validate", &run.validate, "--json", "-"]);
    assert_eq!(said["parameters"], run.said["parameters"]);
    assert_eq!(said["rms"], run.said["rms"]);
}

#[test]
fn without_json_the_result_is_told_in_words() {
    let run = identified();
    let told = denavit(&["identify", ROBOT, &run.fit]);
    assert_eq!(told.status, Some(0), "{}", told.err);
    assert!(told.out.contains("ZZ1R") && told.out.contains("FC7"), "{}", told.out);
}

/// First rows of a log.
fn head(log: &str, rows: usize) -> String {
    log.lines().take(rows + 1).map(|line| format!("{line}\n")).collect()
}

/// The robot file without its `links`.
fn without_links() -> String {
    let text = std::fs::read_to_string(ROBOT).unwrap();
    let (before, after) = text.split_once("\nlinks:").unwrap();
    let rest = after.lines().skip_while(|line| line.is_empty() || line.starts_with([' ', '#']));
    format!("{before}\n{}\n", rest.collect::<Vec<_>>().join("\n"))
}

#[test]
fn fewer_independent_equations_than_unknowns_are_underdetermined_and_write_nothing_without_a_prior() {
    let folder = folder("identify-underdetermined");
    let log = file(&folder, "short.csv", head(&record(30, 1), 125));
    let bare = file(&folder, "bare.yaml", without_links());
    let [out, page, said] = ["out.yaml", "page.html", "said.json"].map(|f| folder.join(f).display().to_string());
    let run = denavit(&["identify", &bare, &log, "--out", &out, "--report", &page, "--json", &said]);
    assert_eq!(run.status, Some(1), "{}", run.err);
    assert!(run.out.contains("Underdetermined") && run.out.contains("independent equations"), "{}", run.out);
    assert!(!run.out.contains("misses"), "{}", run.out);
    assert!(!std::path::Path::new(&out).exists());
    let said: Value = serde_json::from_str(&std::fs::read_to_string(&said).unwrap()).unwrap();
    assert_eq!(said["verdict"], "underdetermined");
    assert!(std::fs::read_to_string(&page).unwrap().contains("independent equations"));
    // Bodies near those of the file may be written.
    let run = denavit(&["identify", ROBOT, &log, "--out", &out]);
    assert_eq!(run.status, Some(1), "{}", run.err);
    assert!(run.err.contains("near the links"), "{}", run.err);
    let (file, prior) = (read_robot(&out), read_robot(ROBOT));
    for (link, prior) in file.links.iter().flatten().zip(prior.links.iter().flatten()) {
        let [link, prior] = [link.to_array(), prior.to_array()];
        assert!((link[0] - prior[0]).abs() < 2.0 * prior[0] + 0.1, "{link:?} {prior:?}");
    }
    // Long ones are not underdetermined.
    assert_eq!(identified().said["verdict"], "determined");
}

#[test]
fn currents_with_torque_constants_are_torques() {
    let folder = folder("identify-currents");
    let constants = [9.0, 8.0, 7.0, 6.0, 5.0, 4.0, 3.0];
    let run = identified();
    let text = std::fs::read_to_string(&run.fit).unwrap();
    let mut lines = text.lines();
    let header = lines.next().unwrap().replace("tau", "i");
    let rows: Vec<Vec<f64>> = lines
        .map(|line| {
            let cells = line.split(',').map(|cell| cell.parse::<f64>().unwrap());
            cells.enumerate().map(|(k, x)| if k > 7 { x / constants[k - 8] } else { x }).collect()
        })
        .collect();
    let log = file(&folder, "currents.csv", csv(&header.split(',').map(String::from).collect::<Vec<_>>(), &rows));
    let without = denavit(&["identify", ROBOT, &log]);
    assert_eq!(without.status, Some(2), "{}", without.err);
    assert!(without.err.contains("`torque_constant`") && without.err.contains("tau1"), "{}", without.err);
    let mut robot = read_robot(ROBOT);
    robot.joints.iter_mut().zip(constants).for_each(|(joint, k)| joint.drive.torque_constant = Some(k));
    let robot = file(&folder, "robot.yaml", robot.to_yaml());
    let plain = json(&["identify", ROBOT, &run.fit, "--consistent=never", "--json", "-"]);
    let currents = json(&["identify", &robot, &log, "--consistent=never", "--json", "-"]);
    for (a, b) in numbers(&plain["rms"]["fit"]).iter().zip(numbers(&currents["rms"]["fit"])) {
        assert!((a - b).abs() < 1e-6, "{a} {b}");
    }
    // Every verb that reads logs supports them.
    let forced = denavit(&["force", &robot, &log, "--json", "-"]);
    assert_eq!(forced.status, Some(0), "{}", forced.err);
    let tool = denavit(&["tool", &robot, "--loaded", &log, "--json", "-"]);
    assert_eq!(tool.status, Some(0), "{}", tool.err);
    // With neither torques nor currents, both options are named.
    let neither = file(&folder, "neither.csv", text.replace("tau", "x"));
    let neither = denavit(&["identify", ROBOT, &neither]);
    assert_eq!(neither.status, Some(2));
    for word in ["`tau1` is missing", "i1..i7", "`torque_constant`"] {
        assert!(neither.err.contains(word), "{}", neither.err);
    }
}

/// Every warning of the terminal is on the page and in the JSON.
#[test]
fn the_page_and_the_json_have_every_warning_of_the_terminal() {
    let folder = folder("identify-warnings");
    let log = file(&folder, "short.csv", head(&record(30, 1), 400));
    let [page, said] = ["page.html", "said.json"].map(|f| folder.join(f).display().to_string());
    let run = denavit(&["identify", ROBOT, &log, "--report", &page, "--json", &said]);
    let warnings: Vec<&str> = run.out.lines().filter_map(|line| line.strip_prefix("warning: ")).collect();
    assert!(warnings.iter().any(|w| w.contains("carry over to other motions")), "{}", run.out);
    let said: Value = serde_json::from_str(&std::fs::read_to_string(&said).unwrap()).unwrap();
    assert_eq!(strings(&said["warnings"]), warnings);
    let page = std::fs::read_to_string(&page).unwrap();
    let section = page.split(">Warnings</h2>").nth(1).unwrap().split("</section>").next().unwrap();
    assert_eq!(section.matches("<li class=warning>").count(), warnings.len());
    assert!(section.contains("carry over to other motions"));
    assert!(page.find(">Warnings</h2>") < page.find(">Torque error per joint</h2>"));
}

/// Friction of the wrong sign is impossible.
#[test]
fn impossible_drives_and_bodies_are_not_written() {
    let folder = folder("identify-impossible");
    let log = record_with(20, 21, |dq, _, tau| tau[2] -= 6.0 * dq[2].signum() + 4.0 * dq[2]);
    let log = file(&folder, "log.csv", log);
    let out = folder.join("out.yaml").display().to_string();
    let run = denavit(&["identify", ROBOT, &log, "--out", &out]);
    if run.status == Some(1) {
        assert!(run.err.contains("no robot file was written"), "{}", run.err);
        assert!(!std::path::Path::new(&out).exists());
    } else {
        assert!(run.out.contains("At their bound of 0"), "{}", run.out);
    }
    let said = denavit(&["identify", ROBOT, &log, "--consistent=never", "--json", "-"]);
    let said: Value = serde_json::from_str(&said.out).unwrap();
    assert!(strings(&said["at_bound"]).contains(&"FC3"), "{}", said["at_bound"]);
    let run = denavit(&["identify", ROBOT, &log, "--consistent=never", "--out", &out]);
    if run.status == Some(1) {
        assert!(run.err.contains("no links that could be built have the plain values"), "{}", run.err);
        assert!(!std::path::Path::new(&out).exists());
        return;
    }
    assert_eq!(run.status, Some(0), "{}", run.err);
    assert!(run.out.contains("came out negative") && run.out.contains("FC3"), "{}", run.out);
    assert_links_could_be_built(&out);
    for joint in read_robot(&out).joints {
        let drive = joint.drive;
        for level in [drive.rotor_inertia, drive.viscous_friction, drive.coulomb_friction].into_iter().flatten() {
            assert!(level >= 0.0, "{}: {level}", joint.name);
        }
    }
}

fn assert_links_could_be_built(robot: &str) {
    for (link, body) in (1..).zip(&read_robot(robot).links) {
        body.as_ref().unwrap().physical().unwrap_or_else(|why| panic!("link {link}: {why}"));
    }
}

/// Plain values are written with links that have them and could be built. None are written if the
/// torques are those of a negative inertia.
#[test]
fn plain_values_are_written_with_links_that_could_be_built_or_not_at_all() {
    let folder = folder("identify-plain");
    let right = file(&folder, "right.csv", record(20, 31));
    let [out, none] = ["out.yaml", "none.yaml"].map(|f| folder.join(f).display().to_string());
    let said = json(&["identify", ROBOT, &right, "--consistent=never", "--out", &out, "--json", "-"]);
    assert_links_could_be_built(&out);
    let again = json(&["identify", &out, &right, "--json", "-"]);
    for (a, b) in numbers(&again["rms"]["fit_before"]).iter().zip(numbers(&said["rms"]["fit"])) {
        assert!((a - b).abs() < 1e-4, "{a} {b}");
    }
    let wrong = record_with(20, 32, |_, ddq, tau| tau[6] -= 0.5 * ddq[6]);
    let wrong = file(&folder, "wrong.csv", wrong);
    // With weights, the other joints would determine link 7, and joint 7 would count as noisy.
    let run = denavit(&["identify", ROBOT, &wrong, "--consistent=never", "--ordinary", "--out", &none]);
    assert_eq!(run.status, Some(1), "{}{}", run.out, run.err);
    assert!(run.err.contains("no links that could be built have the plain values"), "{}", run.err);
    assert!(run.out.contains("ZZ7"), "{}", run.out);
    assert!(!std::path::Path::new(&none).exists());
}

/// A spring on joint 2 in the file: it is subtracted before the fit, and kept in the file.
#[test]
fn effects_of_the_file_are_taken_as_known() {
    let folder = folder("identify-effects");
    let mut robot = read_robot(ROBOT);
    let spring =
        dh_codegen::robot::effects::JointSpring { stiffness: Some(12.0), rest: Some(0.0), ..Default::default() };
    robot.joints[1].drive.effects.push(spring.into());
    let robot = file(&folder, "robot.yaml", robot.to_yaml());
    let log = file(&folder, "log.csv", sprung(record(12, 31), 2, 12.0));
    let out = folder.join("out.yaml").display().to_string();
    let said = json(&["identify", &robot, &log, "--out", &out, "--json", "-"]);
    assert!(said["warnings"].to_string().contains("taken as known: joint_spring of joint 2"), "{}", said["warnings"]);
    // The file is right, and the fit is as good as that of the arm without the spring.
    let [before, after] = ["fit_before", "fit"].map(|which| numbers(&said["rms"][which]));
    let plain = json(&["identify", ROBOT, &file(&folder, "plain.csv", record(12, 31)), "--json", "-"]);
    let plain = numbers(&plain["rms"]["fit"]);
    for joint in 0..7 {
        assert!(
            before[joint] < 1.5 * plain[joint] + 1e-3 && after[joint] < 1.1 * plain[joint] + 1e-4,
            "{before:?} {after:?} {plain:?}"
        );
    }
    let kept = read_robot(&out);
    assert_eq!(kept.joints[1].drive.effects[0].name(), "joint_spring");
    let not_used = file(
        &folder,
        "bare.yaml",
        without_links().replace("name: kuka-lwr4", "name: bare\neffects: { base_tilt: { roll: 0.5deg } }"),
    );
    let run = denavit(&["identify", &not_used, &log]);
    assert!(run.out.contains("not used: base_tilt"), "{}{}", run.out, run.err);
}

/// The log with the torque of a spring on a joint added.
fn sprung(log: String, joint: usize, stiffness: f64) -> String {
    let mut lines = log.lines();
    let header = lines.next().unwrap();
    let names: Vec<&str> = header.split(',').collect();
    let [q, tau] = ["q", "tau"].map(|name| names.iter().position(|n| *n == format!("{name}{joint}")).unwrap());
    let rows = lines.map(|line| {
        let mut cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        cells[tau] += stiffness * cells[q];
        cells.iter().map(f64::to_string).collect::<Vec<_>>().join(",")
    });
    std::iter::once(header.to_string()).chain(rows).collect::<Vec<_>>().join("\n") + "\n"
}

/// Torques of joints 2 and 4 exchanged: no sign change is advised.
#[test]
fn exchanged_torque_columns_are_named_and_no_negation_is_advised() {
    let folder = folder("identify-exchanged");
    let log = record(12, 41);
    let (header, rows) = log.split_once('\n').unwrap();
    let header = header.replace("tau2", "other").replace("tau4", "tau2").replace("other", "tau4");
    let log = file(&folder, "log.csv", format!("{header}\n{rows}"));
    let run = denavit(&["identify", ROBOT, &log]);
    let words = "the torque of joint 2 stands in `tau4`, the torque of joint 4 stands in `tau2`";
    assert!(run.out.contains(words), "{}{}", run.out, run.err);
    assert!(!run.out.contains("negate"), "{}", run.out);
}

/// Positions of joints 2 and 4 exchanged; as recorded, a cable that is most of joint 1's torque is
/// no other order.
#[test]
fn exchanged_position_columns_are_named() {
    let folder = folder("identify-positions");
    let log = record(12, 41);
    let (header, rows) = log.split_once('\n').unwrap();
    let exchanged = ["q2", "q4", "dq2", "dq4"]
        .iter()
        .fold(format!(",{header},"), |header, name| header.replace(&format!(",{name},"), &format!(",{name}?,")));
    let exchanged = [("q2", "q4"), ("q4", "q2"), ("dq2", "dq4"), ("dq4", "dq2")]
        .iter()
        .fold(exchanged, |header, (old, new)| header.replace(&format!("{old}?"), new));
    let exchanged = file(&folder, "exchanged.csv", format!("{}\n{rows}", exchanged.trim_matches(',')));
    let words = "the position of joint 2 stands in `q4`, the position of joint 4 stands in `q2`";
    let run = denavit(&["identify", ROBOT, &exchanged]);
    assert!(format!("{}{}", run.out, run.err).contains(words), "{}{}", run.out, run.err);
    let sprung = file(&folder, "sprung.csv", sprung(log, 1, 60.0));
    let run = denavit(&["identify", ROBOT, &sprung, "--consistent=never"]);
    assert!(!format!("{}{}", run.out, run.err).contains("stands in"), "{}{}", run.out, run.err);
}

#[test]
fn options_that_would_change_nothing_are_refused() {
    let log = &identified().fit;
    for (arguments, word) in [
        (&["--consistent=never", "--most-cost", "1"][..], "--most-cost"),
        (&["--consistent=never", "--prior", "none"], "--prior"),
        (&["--consistent=never", "--mass-total", "15"], "--mass-total"),
        (&["--cutoff", "0", "--order", "3"], "--order"),
        (&["--derivatives", "rest", "--dead-zone", "0.1"], "--dead-zone"),
    ] {
        let run = denavit(&[&["identify", ROBOT, log], arguments].concat());
        assert_eq!(run.status, Some(2), "{arguments:?}");
        assert!(run.err.contains(word), "{arguments:?}: {}", run.err);
    }
}

/// A validating log that was fitted when the file was made is reported.
#[test]
fn a_log_that_was_fitted_before_is_called_so() {
    let folder = folder("identify-before");
    let [a, b] = [51, 52].map(|seed| file(&folder, &format!("{seed}.csv"), record(8, seed)));
    let out = folder.join("out.yaml").display().to_string();
    assert_eq!(denavit(&["identify", ROBOT, &a, "--out", &out]).status, Some(0));
    let said = json(&["identify", &out, &b, "--validate", &a, "--json", "-"]);
    assert!(said["warnings"].to_string().contains("was fitted when the robot file was made"), "{}", said["warnings"]);
    let said = json(&["identify", ROBOT, &b, "--validate", &a, "--json", "-"]);
    assert!(!said["warnings"].to_string().contains("was fitted"), "{}", said["warnings"]);
}

/// A robot file with only the geometry does not explain most of a real arm's torque, whose columns
/// are right. The missing friction is reported, and no exchange of columns is advised.
#[test]
fn a_file_without_friction_is_told_what_it_lacks() {
    let place = folder("identify-geometry");
    let mut robot = read_robot("robots/staubli-tx40.yaml");
    robot.links.clear();
    robot.joints.iter_mut().for_each(|joint| joint.drive = Default::default());
    let bare = file(&place, "bare.yaml", robot.to_yaml());
    let log = "data/staubli-tx40/first.csv.gz";
    let run = denavit(&["identify", &bare, log, "--stride", "4"]);
    assert!(run.out.contains("of the torque unexplained"), "{}\n{}", run.out, run.err);
    assert!(run.out.contains("has no friction of this joint"), "{}", run.out);
    assert!(!run.out.contains("swapped"), "{}", run.out);
    // With friction only the wrist's coupling is missing; the trial of the columns is reported.
    let run = denavit(&["identify", "robots/staubli-tx40.yaml", log, "--stride", "4"]);
    assert!(!run.out.contains("swapped"), "{}", run.out);
}
