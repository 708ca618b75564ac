//! Tests that a generated crate is self-contained: no `std`, no allocation, and no reachable panic.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::path::Path;
use std::process::Command;

struct Counting;

thread_local! {
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

// SAFETY: forwards every call to the system's allocator.
#[allow(unsafe_code)]
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.with(|n| n.set(n.get() + 1));
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

#[test]
fn nothing_is_allocated() {
    use kuka_lwr4 as arm;
    let (q, phi) = ([0.3; arm::DOF], [0.1; arm::STANDARD]);
    let before = ALLOCATIONS.with(Cell::get);
    let beta = arm::base_parameters(&phi);
    let sums = [
        arm::frames(&q)[6][0][0],
        arm::tool_pose(&q)[0][0],
        arm::forward_kinematics(&q)[0][0],
        arm::jacobian(&q)[0][0],
        arm::tool_jacobian(&q)[0][0],
        arm::jacobian_dot_velocity(&q, &q)[0],
        arm::inverse_dynamics(&q, &q, &q, &phi)[0],
        arm::inverse_dynamics_base(&q, &q, &q, &beta)[0],
        arm::mass_matrix(&q, &beta)[0][0],
        arm::coriolis(&q, &q, &beta)[0],
        arm::gravity(&q, &beta)[0],
        arm::forward_dynamics(&q, &q, &q, &beta)[0],
        arm::regressor(&q, &q, &q)[0][0],
        arm::base_regressor(&q, &q, &q)[0][0],
        arm::gravity_regressor(&q)[0][0],
        arm::kinetic_energy_regressor(&q, &q)[0],
        arm::potential_energy_regressor(&q)[0],
        arm::payload_regressor(&q, &q, &q)[0][0],
        arm::inverse_kinematics(&arm::IK.forward(&q), &arm::ik::Query { near: Some(&q), ..Default::default() })
            .map_or(0.0, |s| s.as_slice().len() as f64),
        arm::IK.velocities(&q, &[0.1; 6], &arm::ik::Differential::default()).dq[0],
        arm::IK
            .approach(&arm::IK.forward(&q), &[0.2; arm::DOF], 1e-12, &arm::ik::Differential::default())
            .map_or(0.0, |s| s.map_or(0.0, |s| s.q[0])),
    ];
    let after = ALLOCATIONS.with(Cell::get);
    assert_eq!(after, before, "{sums:?}");
    drop(vec![0u8; 10]);
    assert!(ALLOCATIONS.with(Cell::get) > after, "the counter counts");
}

/// Links the kernels into a static library without `std` whose panic handler calls a function that
/// does not exist. If a panic were reachable, the program could not be linked.
#[test]
fn no_panic_can_be_reached() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("no_panic");
    manifest(&folder, "kuka-lwr4", &root.join("generated/kuka-lwr4"));
    let source = |body: &str| {
        format!(
            "#![no_std]\nuse kuka_lwr4::*;\nunsafe extern \"C\" {{ fn a_panic_is_reachable() -> !; }}\n#[panic_handler]\nfn panic(_: &core::panic::PanicInfo) -> ! {{ unsafe {{ a_panic_is_reachable() }} }}\n#[unsafe(no_mangle)]\npub extern \"C\" fn run(q: &[f64; DOF], phi: &[f64; STANDARD], beta: &[f64; BASE], i: usize) -> f64 {{ {body} }}\n"
        )
    };
    let all = "frames(q)[6][0][0] + tool_pose(q)[0][0] + forward_kinematics(q)[0][0] + jacobian(q)[0][0] + tool_jacobian(q)[0][0] + jacobian_dot_velocity(q, q)[0] + inverse_dynamics(q, q, q, phi)[0] + inverse_dynamics_base(q, q, q, beta)[0] + mass_matrix(q, beta)[0][0] + coriolis(q, q, beta)[0] + gravity(q, beta)[0] + forward_dynamics(q, q, q, beta)[0] + regressor(q, q, q)[0][0] + base_regressor(q, q, q)[0][0] + { let mut out = [[0.0; STANDARD]; DOF]; kernel::regressor::dense(&Trig::new(q), q, q, &mut out); out[6][83] } + gravity_regressor(q)[0][0] + kinetic_energy_regressor(q, q)[0] + potential_energy_regressor(q)[0] + payload_regressor(q, q, q)[0][0] + i as f64 + { let pose: [[f64; 4]; 3] = core::array::from_fn(|r| core::array::from_fn(|c| phi[4 * r + c])); let query = ik::Query { redundancy: phi[12], near: Some(q), ..Default::default() }; let found = inverse_kinematics(&pose, &query).map_or(0.0, |s| s.nearest(q).map_or(0.0, |s| s.q[0])); let plain = inverse_kinematics(&pose, &Default::default()).map_or(0.0, |s| s.safest().map_or(0.0, |s| s.q[1])); let options = ik::Differential { speeds: [Some(phi[13]); DOF], hold: phi[14], preferred: *q, near: phi[15], damping: phi[16] }; let speed = IK.velocities(q, &core::array::from_fn(|r| phi[17 + r]), &options).dq[0]; let there = IK.approach(&pose, q, phi[23], &options).map_or(0.0, |s| s.map_or(0.0, |s| s.q[2])); found + plain + speed + there }";
    assert!(links(&folder, &source(all)), "a kernel can panic");
    assert!(!links(&folder, &source("q[i] + phi[0] + beta[0]")), "the check must notice an index out of bounds");
}

/// Six revolute joints in general position.
const GENERAL: &str = "name: general\nconvention: modified\njoints:
  - { type: revolute, r: 0.3 }
  - { type: revolute, alpha: 1.2, d: 0.1, r: 0.11 }
  - { type: revolute, alpha: -0.8, d: 0.35, r: -0.07 }
  - { type: revolute, alpha: 1.1, d: 0.06, r: 0.31 }
  - { type: revolute, alpha: -1.3, d: 0.05, r: 0.09 }
  - { type: revolute, alpha: 0.9, d: 0.08, r: 0.12 }
";

/// The same for elimination: separate crates, since no robot of the repository uses it. Of the
/// second arm's seven joints one is locked, and two of the others are prismatic.
#[test]
fn no_panic_can_be_reached_by_elimination() {
    let more = "  - { type: prismatic, alpha: -1.0, d: 0.07, r: 0.1 }\n";
    let sliding = GENERAL.replacen("revolute, alpha: 1.2", "prismatic, alpha: 1.2", 1);
    let sliding = sliding.replacen("revolute, alpha: 1.1", "prismatic, alpha: 1.1", 1) + more;
    let ranges = "IK.locked_ranges(&pose).map_or(0.0, |r| r.map_or(0.0, |r| r.best.map_or(0.0, |b| b.0)))";
    for (name, text, also) in [("general", GENERAL, "0.0"), ("sliding", &sliding, ranges)] {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("no_panic_{name}"));
        // Beside it, as a generated crate is a workspace of its own.
        let arm = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}_crate"));
        let robot = dh_codegen::robot::Robot::from_yaml(text, &dh_codegen::robot::no_files).unwrap().robot;
        for (path, text) in dh_codegen::krate(&robot, text) {
            let file = arm.join(path);
            std::fs::create_dir_all(file.parent().unwrap()).unwrap();
            std::fs::write(file, text).unwrap();
        }
        manifest(&folder, "general", &arm);
        let source = format!(
            "#![no_std]\nuse general::*;\nunsafe extern \"C\" {{ fn a_panic_is_reachable() -> !; }}\n#[panic_handler]\nfn panic(_: &core::panic::PanicInfo) -> ! {{ unsafe {{ a_panic_is_reachable() }} }}\n#[unsafe(no_mangle)]\npub extern \"C\" fn run(q: &[f64; DOF], phi: &[f64; 13], _: &[f64; 1], _: usize) -> f64 {{ let pose: [[f64; 4]; 3] = core::array::from_fn(|r| core::array::from_fn(|c| phi[4 * r + c])); let query = ik::Query {{ redundancy: phi[12], near: Some(q), ..Default::default() }}; inverse_kinematics(&pose, &query).map_or(0.0, |s| s.nearest(q).map_or(0.0, |s| s.q[0])) + {also} }}\n"
        );
        assert!(links(&folder, &source), "the elimination can panic: {name}");
    }
}

fn manifest(folder: &Path, name: &str, path: &Path) {
    std::fs::create_dir_all(folder.join("src")).unwrap();
    let text = format!(
        "[package]\nname = \"no-panic\"\nversion = \"0.1.0\"\nedition = \"2024\"\n[lib]\ncrate-type = [\"staticlib\"]\n[dependencies]\n{name} = {{ path = {path:?} }}\n[profile.release]\npanic = \"abort\"\nopt-level = 3\nlto = true\ncodegen-units = 1\n[workspace]\n"
    );
    std::fs::write(folder.join("Cargo.toml"), text).unwrap();
}

fn links(folder: &Path, source: &str) -> bool {
    std::fs::write(folder.join("src/lib.rs"), source).unwrap();
    std::fs::write(folder.join("main.c"), "double run(void*, void*, void*, unsigned long);\nint main(int n, char **v) { double x[999]; return (int)run(x, x, x, n); }\n").unwrap();
    let target = folder.join("target");
    let built = Command::new(env!("CARGO"))
        .args(["build", "--release", "--quiet", "--target-dir"])
        .arg(&target)
        .current_dir(folder)
        .env_remove("RUSTFLAGS")
        .status()
        .unwrap();
    assert!(built.success(), "the library without std does not build");
    Command::new("cc")
        .args(["main.c", "-o", "main", "-Wl,--gc-sections", "target/release/libno_panic.a"])
        .current_dir(folder)
        .output()
        .unwrap()
        .status
        .success()
}
