//! Fuzz targets: one function for each reader. Each panics where a promise is broken, and returns
//! the reader's message, by which new behaviour is recognised.

use std::fmt::Write;
use std::sync::LazyLock;

use denavit::data::log::{
    Acceptance, Block, Mapping, Quantity, Reading, SourceJoint, each_block, open_table, open_with, propose,
};
use denavit::data::signal::{Prepare, each_motion};
use denavit::exchange::{ImportOptions, ModelFormat, export, import};
use denavit::identify::RecordingFactor;
use denavit::model::Arm;
use denavit::model::interpreted::Interpreted;
use denavit::report::{plan_of_json, trajectory_of_json, uncertainty_of_json};
use denavit::simulate::{Request, SimulationFile};
use dh_codegen::robot::{Problems, Robot, Tool, files_of_runs, no_files};

/// Largest length kept of a reader's message.
const SAID: usize = 400;

fn said(of: impl std::fmt::Display) -> String {
    let mut text = String::new();
    let _ = write!(text, "{of}");
    text.truncate((0..=SAID.min(text.len())).rev().find(|&i| text.is_char_boundary(i)).unwrap_or(0));
    text
}

fn problems(problems: &Problems) -> String {
    assert!(!problems.0.is_empty(), "refused without a reason");
    for problem in &problems.0 {
        assert!(!problem.what.is_empty() && !problem.mend.is_empty(), "{problem:?}");
    }
    said(&problems.0[0].what)
}

/// A robot without the blanks in its expressions, which the writer removes.
fn same(robot: &Robot) -> String {
    let blanks = [" ", "\\t", "\\n", "\\r"];
    blanks.iter().fold(format!("{robot:?}"), |text, blank| text.replace(blank, ""))
}

/// A robot file; if it can be read, it is written and read back unchanged.
pub fn robot(bytes: &[u8]) -> String {
    // Every name refers to an existing file with rows of tools.
    let files = |_: &str| Ok(include_str!("../../robots/tools/gripper.yaml").to_string());
    let reading = match Robot::from_bytes(bytes, &files) {
        Ok(reading) => reading,
        Err(found) => return problems(&found),
    };
    assert!(reading.robot.dof() > 0);
    let text = reading.robot.to_yaml();
    let again = match Robot::from_yaml(&text, &files) {
        Ok(again) => again.robot,
        Err(found) => panic!("what was written is refused: {found}\n{text}"),
    };
    assert_eq!(same(&again), same(&reading.robot), "{text}");
    files_of_runs(&String::from_utf8_lossy(bytes));
    for format in [ModelFormat::Urdf, ModelFormat::Mjcf] {
        export(&again, format);
    }
    format!("read: {} {} {}", again.joints.len(), again.constants.len(), reading.notes.len())
}

/// A tool file; if it can be read, it is written and read back unchanged.
pub fn tool(bytes: &[u8]) -> String {
    let Ok(text) = std::str::from_utf8(bytes) else { return "no text".into() };
    match Tool::from_yaml(text, "tool") {
        Ok((tool, _)) => {
            let written = tool.to_yaml(None);
            let again = Tool::from_yaml(&written, "tool").unwrap_or_else(|e| panic!("{e}\n{written}")).0;
            assert_eq!(again, tool, "{written}");
            "read".into()
        }
        Err(found) => problems(&found),
    }
}

static PLANAR: LazyLock<Robot> = LazyLock::new(|| {
    let text = include_str!("../../robots/planar2r.yaml");
    Robot::from_yaml(text, &no_files).unwrap_or_else(|e| panic!("{e}")).robot
});

/// A file of effects and settings for a simulation.
pub fn simulation(bytes: &[u8]) -> String {
    let Ok(text) = std::str::from_utf8(bytes) else { return "no text".into() };
    match SimulationFile::from_yaml(text, &PLANAR) {
        Ok(file) => {
            file.apply(&mut Request::default());
            format!("read: {:?}", file.settings().collect::<Vec<_>>())
        }
        Err(found) => problems(&found),
    }
}

/// A robot file in which one number, one law and one constant are the input.
pub fn expression(bytes: &[u8]) -> String {
    let text = String::from_utf8_lossy(bytes).replace(['"', '\\', '\n', '\r'], " ");
    let number = format!(
        "name: a\nconvention: modified\nconstants: {{ L: 2, K: \"{text}\" }}\njoints: [ {{ type: revolute, d: \"{text}\", alpha: \"{text}\" }} ]\n"
    );
    let law = format!(
        "name: a\nconvention: modified\njoints: [ {{ type: revolute, drive: {{ law: \"{text}\", unit: N m }} }}, {{ type: revolute }} ]\n"
    );
    [number, law].map(|file| robot(file.as_bytes())).join(" ")
}

/// A mapping of channels, applied to a file with some.
pub fn mapping(bytes: &[u8]) -> String {
    let Ok(text) = std::str::from_utf8(bytes) else { return "no text".into() };
    match Mapping::from_yaml(text) {
        Ok(mapping) => {
            let header = ["stamp", "q1", "q2", "/j/position[0]", "/j/position/elbow", "effort_1", "effort_2", "t"];
            match (Reading { mapping: Some(mapping), joints: joints() }).layout("log", &header) {
                Ok((layout, _)) => format!("read: {}", layout.roles.len()),
                Err(e) => said(e),
            }
        }
        Err(found) => problems(&found),
    }
}

fn joints() -> Vec<SourceJoint> {
    ["shoulder", "elbow"].map(|n| SourceJoint { name: n.into(), sign: 1.0, offset: 0.0 }).to_vec()
}

/// A log in any format, read as each verb does: its channels, its rows, and the motion of its
/// joints.
pub fn log(bytes: &[u8]) -> String {
    let mut all = String::new();
    for reading in [Reading::default(), Reading { mapping: None, joints: joints() }] {
        match open_table("log", bytes, &reading).and_then(|mut table| table.summarise()) {
            Ok(channels) => {
                let proposal = propose(&channels, &reading.joints);
                let _ = write!(all, "{} {} ", channels.len(), proposal.reasons.len());
            }
            Err(e) => all += &said(e),
        }
    }
    let reading = Reading { mapping: None, joints: joints() };
    for keep in [Acceptance::default(), Acceptance::all()] {
        let mut cells = 0;
        let done = open_with("log", bytes, &reading).and_then(|mut source| {
            each_block(&mut *source, Quantity::Tau, keep, |columns, starts| {
                assert!(columns.iter().all(|c| c.len() == columns[0].len()), "columns of unequal length");
                assert!(columns.iter().flatten().all(|x| x.is_finite()), "a row that passed is not finite");
                assert!(starts.iter().all(|&s| s <= columns[0].len()));
                cells += columns.iter().map(Vec::len).sum::<usize>();
                Ok(())
            })
        });
        all += &done.map_or_else(said, |passed| format!("read: {} {}", passed.findings.len(), cells > 0));
        let prepare = Prepare { reading: reading.clone(), keep, ..Prepare::default() };
        let motion = open_with("log", bytes, &reading)
            .map(|mut source| each_motion(&mut *source, 2, &prepare, |motion| assert!(motion.picks().len() < 1 << 24)));
        all += &match motion {
            Ok(Ok(prepared)) => format!("motion: {}", prepared.segments),
            Ok(Err(e)) => said(e),
            Err(e) => said(e),
        };
    }
    all
}

/// Rows of a table, with a check that no block has more rows than requested.
pub fn table(bytes: &[u8]) -> String {
    let mut table = match open_table("log", bytes, &Reading::default()) {
        Ok(table) => table,
        Err(e) => return said(e),
    };
    let all: Vec<usize> = (0..table.names().len()).filter(|&i| table.is_numeric(i)).collect();
    if let Err(e) = table.select(&all, all.first().copied().unwrap_or(0)) {
        return said(e);
    }
    let mut block = Block::default();
    loop {
        block.clear(all.len());
        if let Err(e) = table.next_rows(100, &mut block) {
            return said(e);
        }
        assert!(block.len() <= 100 && block.columns.iter().all(|c| c.len() == block.len()));
        if block.is_empty() {
            return format!("{} columns", all.len());
        }
    }
}

/// URDF or MJCF; the imported robot is written and read back.
pub fn model(bytes: &[u8]) -> String {
    let Ok(text) = std::str::from_utf8(bytes) else { return "no text".into() };
    let made = match import(text, &ImportOptions { at_zero: true, ..ImportOptions::default() }) {
        Ok(made) => made,
        Err(e) => return said(e),
    };
    let written = made.robot.to_yaml();
    match Robot::from_yaml(&written, &no_files) {
        Ok(again) => assert_eq!(again.robot, made.robot, "{written}"),
        Err(found) => panic!("what was imported is refused: {found}\n{written}"),
    }
    format!("read: {} {}", made.robot.joints.len(), made.notes.len())
}

/// A motion given by coefficients.
pub fn trajectory(bytes: &[u8]) -> String {
    let Ok(value) = serde_json::from_slice(bytes) else { return "no JSON".into() };
    match trajectory_of_json(&value) {
        Ok(motion) => {
            for share in [-1.0, 0.0, 0.3, 1.0, 2.0] {
                assert_eq!(motion.at(share * motion.duration()).q.len(), motion.dof());
            }
            denavit::simulate::Trajectory::of_motion(&motion).map_or_else(said, |_| "read".into())
        }
        Err(e) => said(e),
    }
}

/// A painting plan.
pub fn plan(bytes: &[u8]) -> String {
    let Ok(value) = serde_json::from_slice(bytes) else { return "no JSON".into() };
    plan_of_json(&value).map_or_else(said, |_| "read".into())
}

static PLANAR_ARM: LazyLock<Interpreted> = LazyLock::new(|| Interpreted::new(&PLANAR, &[]));

/// Uncertainty from an identification. If it can be read it is a covariance: finite, with a
/// non-negative diagonal, and no entry larger than the two on the diagonal permit.
pub fn identified(bytes: &[u8]) -> String {
    let Ok(value) = serde_json::from_slice(bytes) else { return "no JSON".into() };
    let base = PLANAR_ARM.base_parameters();
    match uncertainty_of_json(&value, base, PLANAR_ARM.dof()) {
        Ok(known) => {
            let (n, c) = (base.len(), &known.covariance);
            assert!(c.len() == n * n && c.iter().chain(&known.noise).all(|x| x.is_finite()), "{c:?}");
            for (i, k) in (0..n).flat_map(|i| (0..n).map(move |k| (i, k))) {
                let most = (c[i * n + i] * c[k * n + k]).sqrt();
                assert!(c[i * n + i] >= 0.0 && c[i * n + k].abs() <= 1.001 * most + 1e-300, "{i} {k} {c:?}");
            }
            format!("read: {}", known.open.len())
        }
        Err(e) => said(e),
    }
}

/// Factors of a recording; if they can be read, they are written unchanged.
pub fn factor(bytes: &[u8]) -> String {
    match RecordingFactor::from_bytes("factor", bytes) {
        Ok(factor) => {
            assert_eq!(factor.to_bytes(), bytes);
            "read".into()
        }
        Err(e) => said(e),
    }
}
