//! URDF and MJCF to robot files: compared with the trees themselves, and on files from many
//! sources.

use std::path::{Path, PathBuf};

use denavit::exchange::import::{REQUIRED, import};
use denavit::exchange::tree::Tree;
use denavit::exchange::{ImportOptions, Imported, ModelFormat, Neighbours, Snap, export, onto, urdf};
use denavit::model::rigid_body::Numeric;
use denavit::model::rigid_body::random::Family;
use denavit::numerics::prng::Random;
use dh_codegen::arm::param::standard_values;
use dh_codegen::robot::effects::{JointSpring, TimeDelay};
use dh_codegen::robot::{Inertia, JointKind, Robot};
use nalgebra::{Matrix3, Vector3};

const ARM: &str = include_str!("import/arm.urdf");

fn gripping(tip: &str) -> ImportOptions {
    ImportOptions { tip: Some(tip.into()), at: vec![("grip".into(), 0.03)], ..ImportOptions::default() }
}

/// Kinetic and potential energy of a tree's bodies by differences of their poses, J.
fn energies(tree: &Tree, base: usize, gravity: &Vector3<f64>, at: &dyn Fn(f64) -> Vec<f64>) -> [f64; 2] {
    let h = 1e-5;
    let [before, now, after] = [-h, 0.0, h].map(|t| tree.poses(base, &at(t)));
    let mut sum = [0.0; 2];
    for (k, body) in tree.bodies.iter().enumerate() {
        let (Some(inertia), Some(now), Some(a), Some(b)) = (&body.inertia, now[k], before[k], after[k]) else {
            continue;
        };
        let (m, tensor) = (inertia.m, Matrix3::from(inertia.tensor()));
        let first = Vector3::from(inertia.ms);
        let rate = (b.rotation - a.rotation) / (2.0 * h) * now.rotation.transpose();
        let w = now.rotation.tr_mul(&Vector3::new(rate[(2, 1)], rate[(0, 2)], rate[(1, 0)]));
        let v = now.rotation.tr_mul(&((b.origin - a.origin) / (2.0 * h)));
        sum[0] += 0.5 * (m * v.dot(&v) + 2.0 * v.cross(&w).dot(&first) + w.dot(&(tensor * w)));
        let weighed = now.origin * m + now.rotation * first;
        sum[1] -= gravity.dot(&weighed);
    }
    sum
}

/// Checks that the table has the energies of the tree's bodies, and its tip.
fn check_energies(text: &str, options: &ImportOptions) -> Imported {
    let made = import(text, options).unwrap_or_else(|e| panic!("{e}"));
    assert!(made.error.position < 1e-11 && made.error.rotation < 1e-11, "{:?}", made.error);
    let tree = urdf::tree(text, &mut Snap::new(1e-9)).unwrap();
    let base = tree.body(&made.base).unwrap();
    // Gravity in the axes of the base, with all joints above it at zero.
    let at_zero = tree.poses(tree.body("base").unwrap(), &vec![0.0; tree.joints.len()]);
    let gravity = at_zero[base].unwrap().rotation.tr_mul(&Vector3::from(tree.gravity));
    let numeric = Numeric::new(&made.robot);
    let phi = standard_values(&made.robot).unwrap();
    // Fixed links count in the tree's sum alone: only changes by the joints are
    // compared.
    let held: Vec<(usize, f64)> =
        made.held.iter().map(|(name, q)| (tree.joints.iter().position(|j| j.name == *name).unwrap(), *q)).collect();
    let moving: Vec<usize> = made
        .robot
        .moving()
        .iter()
        .map(|&row| tree.joints.iter().position(|j| j.name == made.robot.joints[row].name).unwrap())
        .collect();
    let mut random = Random::new(5);
    let mut offset = None;
    for _ in 0..20 {
        let (q, dq) = (random.vector(moving.len(), 2.0), random.vector(moving.len(), 2.0));
        let at = |t: f64| {
            let mut all = vec![0.0; tree.joints.len()];
            held.iter().for_each(|&(j, q)| all[j] = q);
            moving.iter().zip(q.iter().zip(&dq)).for_each(|(&j, (q, dq))| all[j] = q + t * dq);
            all
        };
        let [kinetic, potential] = energies(&tree, base, &gravity, &at);
        let found = numeric.kinetic_energy(&q, &dq, &phi);
        assert!((kinetic - found).abs() < 1e-6 * (1.0 + found), "{kinetic} {found}");
        let difference = potential - numeric.potential_energy(&q, &phi);
        let first = *offset.get_or_insert(difference);
        assert!((difference - first).abs() < 1e-9 * (1.0 + potential.abs()), "{difference} {first}");
    }
    made
}

#[test]
fn the_table_moves_as_the_tree_does() {
    let made = check_energies(ARM, &gripping("flange"));
    let cases: Vec<Neighbours> = made.neighbours.iter().map(|(case, _)| *case).collect();
    use Neighbours::*;
    // The line of a prismatic joint may be shifted: it passes through the previous frame.
    assert_eq!(cases, [Crossing, Parallel, AntiParallel, Skew, Crossing, Parallel]);
    let robot = &made.robot;
    assert_eq!(robot.name, "sample-arm");
    assert_eq!(robot.joints[3].alpha.pi_multiple.map(|(p, q)| (p.abs(), q)), Some((1, 1)), "anti-parallel is pi");
    assert_eq!(robot.joints[5].kind, JointKind::Prismatic);
    assert_eq!(robot.joints[1].alpha.quarter_turns().map(i64::abs), Some(1));
    assert_eq!(robot.joints[0].drive.viscous_friction, Some(2.0));
    assert_eq!(robot.joints[0].limits.torque, Some(100.0));
    assert_eq!(robot.base, None, "one row leads from the base link to the first joint");
    assert_eq!(made.held, [("grip".to_string(), 0.03)]);
    assert!(made.bodies[6].contains(&"finger".to_string()) && made.bodies[3].contains(&"cover".to_string()));
}

#[test]
fn axes_on_one_line_have_no_length_between_them() {
    for (axis, half_turns) in [("0 0 1", 0), ("0 0 -1", 1)] {
        let turned = format!("xyz=\"0 0 0.1\" rpy=\"0 0 0.4\"/><axis xyz=\"{axis}\"/>");
        let text = ARM.replacen("xyz=\"0 0 0.1\" rpy=\"1.5707963267948966 0 0\"/><axis xyz=\"0 0 1\"/>", &turned, 1);
        let made = check_energies(&text, &gripping("flange"));
        assert_eq!(made.neighbours[0].0, Neighbours::OneLine);
        let row = &made.robot.joints[1];
        assert_eq!((row.alpha.pi_multiple.map(|(p, q)| (p.abs(), q)), row.d.value), (Some((half_turns, 1)), 0.0));
    }
}

#[test]
fn any_link_can_be_the_base() {
    for base in ["base", "l1", "cover", "l5"] {
        check_energies(ARM, &ImportOptions { base: Some(base.into()), ..gripping("flange") });
    }
    // A rotated and shifted first joint needs a base pose.
    let turned = ARM.replacen("xyz=\"0 0 0.3\" rpy=\"0 0 0\"", "xyz=\"0.1 0.2 0.3\" rpy=\"0.3 -0.5 0.2\"", 1);
    assert!(check_energies(&turned, &gripping("flange")).robot.base.is_some());
}

#[test]
fn axes_off_parallel_by_rounding_stay_near_the_arm() {
    let rounded = ARM.replacen("xyz=\"0.4 0 0.05\"", "xyz=\"0.4 0 0.05\" rpy=\"3.14159 0 0\"", 1);
    let made = check_energies(&rounded, &gripping("flange"));
    assert!(made.neighbours.iter().any(|(case, _)| *case == Neighbours::NearlyParallel));
    assert_eq!(made.robot.joints.len(), 8, "one row that does not move");
    assert!(made.robot.joints.iter().all(|j| j.d.value.abs() < 1.0 && j.r.value.abs() < 1.0));
    // Rounded to pi at the user's request, which shows in the error.
    let made = import(&rounded, &ImportOptions { snap: 1e-5, ..gripping("flange") }).unwrap();
    assert_eq!(made.robot.joints.len(), 7);
    assert_eq!(made.snap.count, 1);
    assert!(made.error.position > REQUIRED && made.error.position < 1e-5, "{:?}", made.error);
}

#[test]
fn what_the_file_does_not_say_stays_unknown() {
    let bare = ARM.replacen(
        "<limit lower=\"-2\" upper=\"2\" velocity=\"3\" effort=\"30\"/>",
        "<limit lower=\"0\" upper=\"0\" velocity=\"0\" effort=\"0\"/>",
        1,
    );
    let bare = bare.replacen(
        "<inertial><mass value=\"0.8\"/><inertia ixx=\"0.001\" iyy=\"0.001\" izz=\"0.001\"/></inertial>",
        "",
        1,
    );
    let made = import(&bare, &gripping("flange")).unwrap();
    let limits = &made.robot.joints[3].limits;
    assert_eq!((limits.position, limits.velocity, limits.torque), (None, None, None));
    assert!(made.robot.links[5].is_none());
    for words in [
        "limits of position of `opposed`",
        "largest speed of `opposed`",
        "largest torque of `opposed`",
        "`slide` moves",
    ] {
        assert!(made.unknown.iter().any(|s| s.contains(words)), "{words}: {:?}", made.unknown);
    }
    let impossible = ARM.replacen("ixx=\"0.003\"", "ixx=\"0.3\"", 1);
    let made = import(&impossible, &gripping("flange")).unwrap();
    assert!(made.impossible.len() == 1 && made.impossible[0].contains("`l4`"), "{:?}", made.impossible);
}

#[test]
fn every_refusal_says_what_where_and_how_to_go_on() {
    let with = |from: &str, to: &str| ARM.replacen(from, to, 1);
    let grip = "<parent link=\"l7\"/><child link=\"finger\"/>";
    let cases: [(String, &[&str]); 13] = [
        (with("<link name=\"flange\"/>", "<link name=\"flange\"/><link name=\"l1\"/>"), &["13:24", "two links `l1`"]),
        (with("value=\"4\"", "value=\"4,0\""), &["5:", "`4,0` is no finite number", "mass.value"]),
        (with("value=\"4\"", "value=\"nan\""), &["`nan`"]),
        (with("<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 0 0\"/>"), &["axis has no length", "joint \"turn\""]),
        (with("<axis xyz=\"0 0 1\"/>", "<axis xyz=\"0 1\"/>"), &["2 number(s)", "write 3"]),
        (with("type=\"revolute\"", "type=\"hinge\""), &["`hinge` is no type of joint"]),
        (with("<parent link=\"l1\"/>", "<parent link=\"none\"/>"), &["no link `none`"]),
        (with("type=\"revolute\"", "type=\"floating\""), &["`turn` is floating", "--base l1"]),
        (with("type=\"revolute\"", "type=\"planar\""), &["`turn` is planar"]),
        (with("effort=\"60\"/>", "effort=\"60\"/><mimic joint=\"turn\"/>"), &["`parallel` follows `turn`", "mimic"]),
        (with("value=\"4\"", "value=\"${m}\""), &["xacro", "ros2 run xacro xacro"]),
        (
            with(
                "</robot>",
                "<joint name=\"loop\" type=\"fixed\"><parent link=\"l1\"/><child link=\"l3\"/></joint></robot>",
            ),
            &["closed loop", "`loop`", "l3"],
        ),
        (with("</robot>", ""), &["no well-formed XML"]),
    ];
    for (text, words) in cases {
        let said = import(&text, &gripping("flange")).unwrap_err().in_file("arm.urdf");
        words.iter().for_each(|w| assert!(said.contains(w), "no `{w}` in {said}"));
    }
    // Eight joints lead to the finger, the only such leaf; a second finger makes two, and the link
    // that carries both may be the arm's end.
    assert_eq!(import(ARM, &ImportOptions::default()).unwrap().tip, "finger");
    let two = ARM.replacen("</robot>", "<link name=\"thumb\"/><joint name=\"oppose\" type=\"revolute\"><parent link=\"l7\"/><child link=\"thumb\"/></joint></robot>", 1);
    let two = import(&two, &ImportOptions::default()).unwrap_err().to_string();
    assert!(two.contains("moving joints: l7 (7), finger (8), thumb (8)") && two.contains("--tip"), "{two}");
    let free = import(ARM, &ImportOptions { at: vec![], ..gripping("flange") }).unwrap_err().to_string();
    assert!(free.contains("--at grip=0.01") && free.contains("--at zero"), "{free}");
    let follows = ARM.replacen(grip, &format!("{grip}<mimic joint=\"slide\"/>"), 1);
    let follows =
        import(&follows, &ImportOptions { at_zero: true, at: vec![], ..gripping("flange") }).unwrap_err().to_string();
    assert!(follows.contains("`grip`") && follows.contains("`slide`"), "{follows}");
    let unknown = import(ARM, &gripping("flang")).unwrap_err().to_string();
    assert!(unknown.contains("no link `flang`") && unknown.contains("flange"), "{unknown}");
}

/// A second finger, which slides beside the first or follows it: the arm ends before both.
#[test]
fn the_fingers_of_a_gripper_end_no_arm() {
    let finger = |more: &str| {
        let joint = format!(
            "<link name=\"thumb\"/><joint name=\"oppose\" type=\"prismatic\"><parent link=\"l7\"/><child link=\"thumb\"/>\
             <axis xyz=\"0 1 0\"/><limit lower=\"0.01\" upper=\"0.04\"/>{more}</joint></robot>"
        );
        // Without the flange there are only fingers behind the last link.
        let arm = ARM.replacen("<link name=\"flange\"/>", "", 1);
        let from = arm.find("<joint name=\"flange joint\"").unwrap_or_else(|| panic!("{arm}"));
        let to = from + arm[from..].find("</joint>").unwrap() + "</joint>".len();
        (arm[..from].to_string() + &arm[to..]).replacen("</robot>", &joint, 1)
    };
    let mimic = finger("<mimic joint=\"grip\" multiplier=\"-1\"/>");
    let asked = import(&mimic, &ImportOptions::default()).unwrap_err().to_string();
    assert!(asked.contains("which ends at `l7`") && asked.contains("--at grip=0.01"), "{asked}");
    let held = ImportOptions { at: vec![("grip".into(), 0.03)], ..ImportOptions::default() };
    let made = import(&mimic, &held).unwrap();
    assert_eq!((made.tip.as_str(), made.robot.dof()), ("l7", 7));
    assert!(made.notes.iter().any(|n| n.contains("`grip` and `oppose` move the fingers")), "{:?}", made.notes);
}

#[test]
fn a_link_with_two_parents_is_a_loop_wherever_it_hangs() {
    let hung = |parents: [&str; 2]| {
        let joint = |parent: &str, k: usize| {
            format!(
                "<joint name=\"strut{k}\" type=\"fixed\"><parent link=\"{parent}\"/><child link=\"strut\"/></joint>"
            )
        };
        let more = format!("<link name=\"strut\"/>{}{}</robot>", joint(parents[0], 1), joint(parents[1], 2));
        import(&ARM.replacen("</robot>", &more, 1), &gripping("flange"))
    };
    for parents in [["base", "l3"], ["l3", "base"], ["l1", "finger"]] {
        let said = hung(parents).unwrap_err().to_string();
        assert!(said.contains("`strut1` and `strut2` both move the link `strut`: a closed loop"), "{said}");
    }
}

#[test]
fn orientations_as_quaternions_are_those_of_angles() {
    let angles = ARM.replacen("rpy=\"1.5707963267948966 0 0\"", "rpy=\"0.3 -0.4 1.2\"", 1);
    let [(sr, cr), (sp, cp), (sy, cy)] = [0.3f64, -0.4, 1.2].map(|a| (0.5 * a).sin_cos());
    let q = [
        sr * cp * cy - cr * sp * sy,
        cr * sp * cy + sr * cp * sy,
        cr * cp * sy - sr * sp * cy,
        cr * cp * cy + sr * sp * sy,
    ];
    let q = q.map(|c| (2.0 * c).to_string()).join(" ");
    let quaternion = angles.replacen("rpy=\"0.3 -0.4 1.2\"", &format!("quat_xyzw=\"{q}\""), 1);
    let [a, b] = [&angles, &quaternion].map(|text| Numeric::new(&import(text, &gripping("flange")).unwrap().robot));
    let mut random = Random::new(3);
    let at = random.vector(a.dof(), 2.0);
    assert!((a.tool(&at) - b.tool(&at)).amax() < 1e-12);
    let none = angles.replacen("rpy=\"0.3 -0.4 1.2\"", "quat_xyzw=\"0 0 0 0\"", 1);
    let said = import(&none, &gripping("flange")).unwrap_err().to_string();
    assert!(said.contains("no length"), "{said}");
}

#[test]
fn files_that_no_arm_needs_are_refused_at_once() {
    let far = ARM.replacen("xyz=\"0 0 0.3\"", "xyz=\"0 0 1e300\"", 1);
    let attributes: String = (0..100_000).map(|k| format!(" a{k}=\"1\"")).collect();
    let crowded = ARM.replacen("<link name=\"flange\"/>", &format!("<link name=\"flange\"{attributes}/>"), 1);
    let long = ARM.replacen("</robot>", &format!("<!--{}--></robot>", "x".repeat(9 << 20)), 1);
    for (text, words) in [(far, "beyond any arm"), (crowded, "attributes"), (long, "more than the 8388608")] {
        let said = import(&text, &gripping("flange")).unwrap_err().to_string();
        assert!(said.contains(words), "{said}");
    }
    let model = |body: &str| format!("<mujoco><worldbody><body name=\"a\">{body}<joint/></body></worldbody></mujoco>");
    let said = import(&model("<geom class=\"steel\" size=\"1\"/>"), &ImportOptions::default()).unwrap_err().to_string();
    assert!(said.contains("there is no default class `steel`"), "{said}");
}

/// Folder with files from many sources, beside a checkout.
fn corpus() -> Option<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data/urdf");
    folder.is_dir().then_some(folder)
}

fn urdf_files(folder: &Path, into: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            urdf_files(&path, into);
        } else if path.extension().is_some_and(|e| e == "urdf") {
            into.push(path);
        }
    }
}

/// Result of importing a file in one line. If several links end the longest chain the first is
/// taken, and joints beside it are at zero.
fn outcome(text: &str) -> String {
    let mut options = ImportOptions { at_zero: true, ..ImportOptions::default() };
    let mut chosen = "";
    for _ in 0..3 {
        match import(text, &options) {
            Ok(made) => {
                // More only if angles of the file were rounded to exact ones, which the report
                // states.
                let allowed = if made.snap.largest > 1e-10 { 10.0 * REQUIRED } else { REQUIRED };
                assert!(made.error.position <= allowed && made.error.rotation <= allowed, "{:?}", made.error);
                let rows = made.robot.joints.len() - made.robot.dof();
                let rows = if rows > 0 { format!(", {rows} rows between") } else { String::new() };
                return format!("{} joints to {}{chosen}{rows}", made.robot.dof(), made.tip);
            }
            Err(error) => {
                let said = error.to_string();
                let list = said.split_once(" moving joints: ").and_then(|(_, rest)| rest.split([',', ';', '(']).next());
                match list {
                    Some(first) => (options.tip, chosen) = (Some(first.trim().to_string()), " (of several)"),
                    None => {
                        return format!(
                            "refused: {}",
                            said.lines().next().unwrap_or_default().split("; ").next().unwrap_or_default()
                        );
                    }
                }
            }
        }
    }
    "refused twice".into()
}

#[test]
fn files_of_many_makers_are_converted_or_refused_for_a_reason() {
    let Some(folder) = corpus() else {
        eprintln!("skipped: there is no folder ../shared/data/urdf beside this checkout");
        return;
    };
    let mut files = Vec::new();
    urdf_files(&folder, &mut files);
    files.sort();
    let mut table = String::new();
    for file in &files {
        let text = String::from_utf8_lossy(&std::fs::read(file).unwrap()).into_owned();
        table += &format!("{}: {}\n", file.strip_prefix(&folder).unwrap().display(), outcome(&text));
    }
    let kept = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/import/files.txt");
    if std::env::var_os("DENAVIT_REGENERATE").is_some() {
        std::fs::write(&kept, &table).unwrap();
    }
    let expected = std::fs::read_to_string(&kept).unwrap();
    for (now, before) in table.lines().zip(expected.lines()) {
        assert_eq!(now, before, "DENAVIT_REGENERATE=1 writes tests/import/files.txt again");
    }
    assert_eq!(table.lines().count(), expected.lines().count());
}

/// Torques and positions computed by MuJoCo 4.0 for `arm.xml` (`mj_inverse` without constraints,
/// with Coulomb friction and without the spring): classes, degrees, shapes, two joints in one body.
#[test]
fn mjcf_means_what_mujoco_means() {
    let text = include_str!("import/arm.xml");
    let options = ImportOptions { tip: Some("grasp".into()), at_zero: true, ..ImportOptions::default() };
    let made = import(text, &options).unwrap();
    assert!(made.error.position < 1e-12, "{:?}", made.error);
    assert_eq!(made.held.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>(), ["left", "right"]);
    assert_eq!(made.robot.joints[0].limits.torque, Some(100.0));
    assert_eq!(made.robot.joints[4].limits.torque, Some(12.0));
    assert_eq!(made.robot.joints[4].drive.effects[0].name(), "joint_spring");
    let (numeric, phi) = (Numeric::new(&made.robot), standard_values(&made.robot).unwrap());
    type Known = ([f64; 5], [f64; 5], [f64; 5], [f64; 5], [f64; 3]);
    let states: [Known; 2] = [
        (
            [0.4, -0.7, 0.12, 1.1, -0.3],
            [0.5, -1.0, 0.2, 1.5, -0.8],
            [1.0, 2.0, -0.5, 3.0, -4.0],
            [15.032846452211327, 5.133812185156977, 8.685014115282653, 0.3401638839776428, -0.3134884701773615],
            [0.8249131177589047, 0.16138586452833403, 0.37333443971254665],
        ),
        (
            [-1.2, 0.9, 0.25, -2.0, 0.6],
            [-1.1, 0.4, -0.3, 0.7, 1.9],
            [-2.0, 1.5, 0.8, -3.0, 2.5],
            [7.350561226520478, 6.339456158763107, 8.141940211173495, 0.29422625222970844, 0.4053203480239429],
            [0.7076498111991123, 0.03824434873436118, 0.10427676331882554],
        ),
    ];
    for (q, dq, ddq, torques, place) in states {
        let found = numeric.inverse_dynamics(&q, &dq, &ddq, &phi);
        for (a, b) in found.iter().zip(torques) {
            assert!((a - b).abs() < 1e-11, "{found} {torques:?}");
        }
        let tool = numeric.tool(&q);
        assert!((0..3).all(|i| (tool[(i, 3)] - place[i]).abs() < 1e-12), "{tool} {place:?}");
    }
}

#[test]
fn what_mjcf_has_and_an_arm_has_not_is_refused_by_name() {
    let text = include_str!("import/arm.xml");
    let options = ImportOptions { tip: Some("grasp".into()), at_zero: true, ..ImportOptions::default() };
    let cases: [(&str, &str, &[&str]); 6] = [
        ("<joint name=\"spin\" axis", "<joint name=\"spin\" type=\"ball\" axis", &["`spin` is ball", "--base"]),
        ("<worldbody>", "<include file=\"rest.xml\"/><worldbody>", &["`include`", "mj_saveLastXML"]),
        (
            "<joint joint1",
            "<connect body1=\"hand\" body2=\"column\" anchor=\"0 0 0\"/><joint joint1",
            &["closed loop", "hand"],
        ),
        ("joint1=\"left\" joint2=\"right\"", "joint1=\"spin\" joint2=\"turn\"", &["`spin` follows `turn`"]),
        (
            "size=\"0.04\"/>\n        <geom type=\"box\"",
            "size=\"0.04 x\"/>\n        <geom type=\"box\"",
            &["22:61", "`x` is no finite number"],
        ),
        ("<joint name=\"shoulder\" axis=\"0 1 0\"", "<joint name=\"shoulder\" axis=\"0 0 0\"", &["axis has no length"]),
    ];
    for (from, to, words) in cases {
        let broken = text.replacen(from, to, 1);
        assert_ne!(broken, text, "{from}");
        let said = import(&broken, &options).unwrap_err().in_file("arm.xml");
        words.iter().for_each(|w| assert!(said.contains(w), "no `{w}` in {said}"));
    }
    // The inertia of a mesh is not known from the file.
    let mesh = text.replacen(
        "<geom type=\"ellipsoid\" size=\"0.03 0.04 0.05\" mass=\"0.7\"/>",
        "<geom type=\"mesh\" mesh=\"m\"/>",
        1,
    );
    let made = import(&mesh, &options).unwrap();
    assert!(made.robot.links[3].is_none() && made.unknown.iter().any(|s| s.contains("`slide`")), "{:?}", made.unknown);
}

/// Largest torque difference of both robots, joint by joint in the same order, at random states.
fn same_torques(one: &Robot, other: &Robot) -> f64 {
    let [a, b] = [one, other].map(|robot| (Numeric::new(robot), standard_values(robot).unwrap()));
    let (n, mut random, mut worst) = (one.dof(), Random::new(9), 0f64);
    for _ in 0..50 {
        let [q, dq, ddq] = [2.0, 2.0, 5.0].map(|size| random.vector(n, size));
        let [x, y] = [&a, &b].map(|(arm, phi)| arm.inverse_dynamics(&q, &dq, &ddq, phi));
        worst = worst.max((&x - y).amax() / (1.0 + x.amax()));
    }
    worst
}

/// The robot without entries that models cannot express: constant torques and, in URDF, rotors.
fn sayable(mut robot: Robot, rotors: bool) -> Robot {
    for joint in &mut robot.joints {
        joint.drive.offset = None;
        joint.drive.rotor_inertia = joint.drive.rotor_inertia.filter(|_| rotors);
    }
    robot
}

#[test]
fn what_is_exported_comes_back_with_equal_torques() {
    let mut random = Random::new(21);
    for case in 0..40 {
        let family = Family { base: 0.5, fixed: 0.15, upright: 1.0, rows: [1, 6], ..Family::default() };
        let robot = random.robot(&family);
        for format in [ModelFormat::Urdf, ModelFormat::Mjcf] {
            let robot = sayable(robot.clone(), format == ModelFormat::Mjcf);
            let made = export(&robot, format);
            let tip = robot
                .tool
                .as_ref()
                .map_or_else(|| format!("{}_link", robot.joints.last().unwrap().name), |t| t.name.clone());
            let options = ImportOptions { tip: Some(tip), ..ImportOptions::default() };
            let back = import(&made.text, &options).unwrap_or_else(|e| panic!("{case}: {e}\n{}", made.text));
            let worst = same_torques(&robot, &back.robot);
            assert!(worst < 1e-11, "{case}, {format:?}: {worst}");
        }
    }
}

#[test]
fn a_model_keeps_its_words_and_gets_the_numbers() {
    let made = import(ARM, &gripping("flange")).unwrap();
    let held = gripping("flange").at;
    let mut robot = made.robot.clone();
    for (k, link) in robot.links.iter_mut().enumerate() {
        let heavier = link.unwrap().to_array().map(|p| p * (1.1 + 0.1 * k as f64));
        *link = Some(Inertia::from_array(heavier));
    }
    robot.joints[1].drive.viscous_friction = Some(3.25);
    let written = onto(&robot, ARM, &held).unwrap();
    assert!(written.text.contains("<!-- Every way in which") && written.text.contains("damping=\"3.25\""));
    let back = import(&written.text, &gripping("flange")).unwrap();
    let worst = same_torques(&robot, &back.robot);
    assert!(worst < 1e-11, "{worst}\n{:?}", written.left_out);
    // Equal numbers leave the text unchanged, whatever the rounding on the way there and back.
    let same = onto(&made.robot, ARM, &held).unwrap().text;
    assert!(same.contains("ixx=\"0.01\" iyy=\"0.06\" izz=\"0.06\""), "{same}");
    let worst = same_torques(&made.robot, &import(&same, &gripping("flange")).unwrap().robot);
    assert!(worst < 1e-11, "{worst}");
    // Through MJCF: the model is then MuJoCo's.
    let model = export(&made.robot, ModelFormat::Mjcf).text.replacen("<worldbody>", "<worldbody><!-- ours -->", 1);
    let written = onto(&robot, &model, &[]).unwrap();
    assert!(written.text.contains("<!-- ours -->"));
    let options = ImportOptions { tip: Some("flange".into()), ..ImportOptions::default() };
    let back = import(&written.text, &options).unwrap();
    assert!(same_torques(&robot, &back.robot) < 1e-11);
    let other = ARM.replacen("xyz=\"0.4 0 0.05\"", "xyz=\"0.5 0 0.05\"", 1);
    let refused = onto(&robot, &other, &held).unwrap_err().to_string();
    assert!(refused.contains("do not move as the robot file's do"), "{refused}");
}

/// `time_delay` of each joint, s.
fn delays(robot: &Robot) -> Vec<f64> {
    robot.laws().iter().map(|law| law.delay).collect()
}

#[test]
fn delays_come_along_in_mjcf() {
    let mut robot = Random::new(3).robot(&Family { rows: [4, 4], fixed: 0.0, ..Family::default() });
    for (joint, delay) in robot.joints.iter_mut().zip([Some(0.04), Some(-0.0125), None, Some(0.0)]) {
        joint.actuated = true;
        joint.drive.effects = delay.map(|delay| TimeDelay { delay: Some(delay) }.into()).into_iter().collect();
    }
    robot.effects = vec![TimeDelay { delay: Some(0.01) }.into()];
    let made = export(&robot, ModelFormat::Mjcf);
    assert!(!made.left_out.iter().any(|s| s.contains("time_delay")), "{:?}", made.left_out);
    assert!(made.notes.iter().any(|s| s.contains("MuJoCo 3.5")), "{:?}", made.notes);
    assert!(made.text.contains("delay=\"0.05\" nsample=\"100\" interp=\"linear\""), "{}", made.text);
    let tip = made.text.split("<body name=\"").last().and_then(|t| t.split('"').next()).map(str::to_string);
    let options = ImportOptions { tip, ..ImportOptions::default() };
    let back = import(&made.text, &options).unwrap();
    assert_eq!(delays(&back.robot), delays(&robot));
    // URDF cannot express it.
    let urdf = export(&robot, ModelFormat::Urdf);
    assert!(urdf.left_out.iter().any(|s| s.contains("time_delay")) && urdf.notes.is_empty());
    // Into a model with delays, and into one without.
    for model in [made.text.clone(), without_delays(&made.text)] {
        robot.effects = vec![TimeDelay { delay: Some(-0.001) }.into()];
        let written = onto(&robot, &model, &[]).unwrap();
        assert_eq!(delays(&import(&written.text, &options).unwrap().robot), delays(&robot), "{}", written.text);
    }
    // A joint without a motor has no torque that could be delayed.
    robot.joints[2].actuated = false;
    let missing = format!("time_delay of `{}`", robot.joints[2].name);
    assert!(export(&robot, ModelFormat::Mjcf).left_out.iter().any(|s| s.starts_with(&missing)));
    let wrong = made.text.replacen("delay=\"0.05\"", "delay=\"-1\"", 1);
    let refused = import(&wrong, &options).unwrap_err().to_string();
    assert!(refused.contains("no delay is of -1 s"), "{refused}");
}

fn without_delays(model: &str) -> String {
    let (before, rest) = model.split_once("  <sensor>").unwrap();
    let (_, after) = rest.split_once("</sensor>\n").unwrap();
    before.to_string() + after
}

#[test]
fn springs_go_back_in_the_models_unit_of_angle() {
    let model = include_str!("import/arm.xml");
    let options = ImportOptions { tip: Some("grasp".into()), at_zero: true, ..ImportOptions::default() };
    let mut robot = import(model, &options).unwrap().robot;
    let spring = JointSpring { stiffness: Some(4.0), rest: Some(-0.25), ..JointSpring::default() };
    for joint in &mut robot.joints {
        joint.drive.effects = vec![spring.into()];
    }
    let written = onto(&robot, model, &[]).unwrap();
    let back = import(&written.text, &options).unwrap().robot;
    let read = |robot: &Robot| robot.laws().iter().map(|law| law.spring.unwrap().rest()).collect::<Vec<f64>>();
    let worst = read(&back).iter().map(|rest| (rest + 0.25).abs()).fold(0.0, f64::max);
    assert!(worst < 1e-15, "{worst}: {}", written.text);
}
