//! Computes the inertias of the tools of `robots/tools/` from their geometry.
//!
//! The tool frame is in the face of the flange, z outwards; a roller's axis and the width of a
//! brush lie along x. The flange of the LWR is 0.078 m beyond its last frame. Sizes and masses are
//! those of commercial hardware, rounded. The reference is the paper's two rollers (section VI:
//! 0.35 m x 0.20 m, 0.2 kg; 0.33 m x 0.10 m, 0.1 kg). Wire and grip are ordinary, and the nap's
//! mass per metre accounts for the rest of the paper's mass. Tools are dry: a nap full of paint is
//! another body.

use dh_codegen::robot::{Angle, Inertia, Tool, ToolGeometry};

use super::shape::{Assembly, Axis};

/// Distance of the LWR's flange from its last frame, m (public URDF).
pub const FLANGE: f64 = 0.078;

/// Construction of a series of paint rollers: grip, bent wire, and a tube with nap that turns on
/// the wire's end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollerSeries {
    /// Prefix of the tools' names.
    pub name: &'static str,
    /// Length of the grip, m, its radius, m, and its mass, kg.
    pub grip: [f64; 3],
    /// Radius of the steel wire, m.
    pub wire: f64,
    /// Outer and inner radius of the tube with its nap, m.
    pub tube: [f64; 2],
    /// Mass of the tube per metre, kg/m.
    pub nap: f64,
    /// Distance between the tube's end and the wire beside it, m.
    pub clearance: f64,
}

/// Density of steel, kg/m^3.
const STEEL: f64 = 7850.0;

/// Series of the large roller: 6 mm wire, 48 mm tube.
pub const WALL_ROLLERS: RollerSeries = RollerSeries {
    name: "roller",
    grip: [0.13, 0.016, 0.042],
    wire: 0.003,
    tube: [0.024, 0.018],
    nap: 0.206,
    clearance: 0.015,
};

/// Series of the small roller: 5 mm wire, 30 mm tube.
pub const MINI_ROLLERS: RollerSeries = RollerSeries {
    name: "mini-roller",
    grip: [0.12, 0.011, 0.027],
    wire: 0.0025,
    tube: [0.015, 0.008],
    nap: 0.168,
    clearance: 0.010,
};

impl RollerSeries {
    /// Roller of this length (flange to the far side of the tube) and width (of the tube), m.
    pub fn roller(&self, length: f64, width: f64) -> Inertia {
        let [grip, radius, mass] = self.grip;
        let axle = length - self.tube[0];
        let side = -(0.5 * width + self.clearance);
        let bend = (axle - 0.06).max(grip); // the wire leaves the middle 6 cm before the axle
        let path = [[0.0, 0.0, grip], [0.0, 0.0, bend], [side, 0.0, bend], [side, 0.0, axle], [0.5 * width, 0.0, axle]];
        Assembly::new()
            .tube(mass, [radius, 0.0], grip, Axis::Z, [0.0, 0.0, 0.5 * grip])
            .wire(STEEL * std::f64::consts::PI * self.wire * self.wire, self.wire, &path)
            .tube(self.nap * width, self.tube, width, Axis::X, [0.0, 0.0, axle])
            .inertia
    }
}

/// Flat brush: handle and bristles of this width, m.
fn flat_brush(length: f64, width: f64) -> Inertia {
    let (ferrule, bristles) = (0.045, 0.055);
    let handle = length - ferrule - bristles;
    Assembly::new()
        .cuboid(700.0 * handle * 0.028 * 0.018, [0.028, 0.018, handle], [0.0, 0.0, 0.5 * handle]) // beech
        .cuboid(900.0 * ferrule * width * 0.016, [width, 0.016, ferrule], [0.0, 0.0, handle + 0.5 * ferrule])
        .cuboid(350.0 * bristles * width * 0.015, [width, 0.015, bristles], [0.0, 0.0, length - 0.5 * bristles])
        .inertia
}

/// Round brush of this width, m: handle, ferrule and bristles on one axis.
fn round_brush(length: f64, width: f64) -> Inertia {
    let (head, radius) = (0.07, 0.5 * width);
    let handle = length - head;
    Assembly::new()
        .tube(700.0 * std::f64::consts::PI * 1.44e-4 * handle, [0.012, 0.0], handle, Axis::Z, [0.0, 0.0, 0.5 * handle])
        .tube(
            500.0 * std::f64::consts::PI * radius * radius * head,
            [radius, 0.0],
            head,
            Axis::Z,
            [0.0, 0.0, length - 0.5 * head],
        )
        .inertia
}

/// Radiator brush: its head stands at an angle to the side, here a right angle.
fn radiator_brush(length: f64, width: f64) -> Inertia {
    Assembly::new()
        .tube(700.0 * std::f64::consts::PI * 1.21e-4 * length, [0.011, 0.0], length, Axis::Z, [0.0, 0.0, 0.5 * length])
        .cuboid(700.0 * 0.09 * width * 0.016, [width, 0.09, 0.016], [0.0, 0.045, length - 0.008])
        .inertia
}

/// Parallel gripper with two fingers, as used on arms of this size: body, two finger rails, two
/// fingers.
fn gripper() -> Inertia {
    Assembly::new()
        .cuboid(0.62, [0.10, 0.06, 0.085], [0.0, 0.0, 0.0425])
        .cuboid(0.07, [0.018, 0.03, 0.05], [0.042, 0.0, 0.11])
        .cuboid(0.07, [0.018, 0.03, 0.05], [-0.042, 0.0, 0.11])
        .inertia
}

/// Air sander with a disc of 150 mm: motor, head, disc, and the hose's end at the side.
fn sanding_disc() -> Inertia {
    Assembly::new()
        .tube(0.48, [0.032, 0.0], 0.085, Axis::Z, [0.0, 0.0, 0.0425])
        .tube(0.14, [0.075, 0.0], 0.014, Axis::Z, [0.0, 0.0, 0.092])
        .tube(0.06, [0.014, 0.010], 0.11, Axis::Y, [0.0, -0.085, 0.03])
        .inertia
}

/// Spray gun with its empty cup on top: body along z, cup beside it, nozzle at the end.
fn spray_gun() -> Inertia {
    Assembly::new()
        .cuboid(0.34, [0.035, 0.05, 0.15], [0.0, 0.0, 0.075])
        .tube(0.11, [0.045, 0.043], 0.12, Axis::Y, [0.0, 0.105, 0.10])
        .tube(0.05, [0.012, 0.0], 0.03, Axis::Z, [0.0, 0.0, 0.165])
        .inertia
}

/// Scraper: handle and steel blade of this width, m.
fn scraper(length: f64, width: f64) -> Inertia {
    let blade = 0.09;
    let handle = length - blade;
    Assembly::new()
        .cuboid(0.075, [0.03, 0.024, handle], [0.0, 0.0, 0.5 * handle])
        .cuboid(STEEL * blade * width * 0.0012, [width, 0.0012, blade], [0.0, 0.0, length - 0.5 * blade])
        .inertia
}

fn tool(name: String, inertia: Inertia, size: Option<[f64; 2]>) -> Tool {
    Tool {
        name,
        xyz: [0.0, 0.0, FLANGE],
        rpy: [Angle::zero(), Angle::zero(), Angle::zero()],
        inertia: Some(inertia),
        geometry: size.map(|[length, width]| ToolGeometry { length, width }),
    }
}

/// Source note in the first line of a tool file.
#[cfg(test)]
const SOURCE: &str = "geometry and density, by src/identify/tool/catalogue.rs; dry";

/// Tools of `robots/tools/`.
pub fn catalogue() -> Vec<Tool> {
    let mut tools = vec![
        tool("large-roller".into(), WALL_ROLLERS.roller(0.35, 0.20), Some([0.35, 0.20])),
        tool("small-roller".into(), MINI_ROLLERS.roller(0.33, 0.10), Some([0.33, 0.10])),
    ];
    let grids = [
        (WALL_ROLLERS, [0.30, 0.40, 0.50], [0.15, 0.18, 0.25]),
        (MINI_ROLLERS, [0.25, 0.35, 0.45], [0.06, 0.11, 0.16]),
    ];
    for (series, lengths, widths) in grids {
        for length in lengths {
            for width in widths {
                let name = format!("{}-{:.0}x{:.0}", series.name, 1e3 * length, 1e3 * width);
                tools.push(tool(name, series.roller(length, width), Some([length, width])));
            }
        }
    }
    tools.extend([
        tool("flat-brush-50".into(), flat_brush(0.24, 0.05), Some([0.24, 0.05])),
        tool("flat-brush-100".into(), flat_brush(0.26, 0.10), Some([0.26, 0.10])),
        tool("round-brush".into(), round_brush(0.28, 0.04), Some([0.28, 0.04])),
        tool("radiator-brush".into(), radiator_brush(0.36, 0.07), Some([0.36, 0.07])),
        tool("gripper".into(), gripper(), None),
        tool("sanding-disc".into(), sanding_disc(), Some([0.099, 0.15])),
        tool("spray-gun".into(), spray_gun(), None),
        tool("scraper".into(), scraper(0.22, 0.10), Some([0.22, 0.10])),
    ]);
    tools
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;
    use std::path::Path;

    /// Rewrites `robots/tools/`, and fails if a file differed from the builder's result.
    #[test]
    fn the_files_are_what_the_builder_makes() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("robots/tools");
        let tools = catalogue();
        let mut stale = Vec::new();
        for tool in &tools {
            let path = folder.join(format!("{}.yaml", tool.name));
            let text = tool.to_yaml(Some(SOURCE));
            if fs::read_to_string(&path).ok().as_deref() != Some(&text) {
                let _ = fs::create_dir_all(&folder);
                let _ = fs::write(&path, text);
                stale.push(tool.name.clone());
            }
        }
        assert!(stale.is_empty(), "rewritten: {stale:?}");
        let files = fs::read_dir(&folder)
            .unwrap()
            .filter(|f| f.as_ref().is_ok_and(|f| f.path().extension().is_some_and(|e| e == "yaml")));
        assert_eq!(files.count(), tools.len(), "a file of an unknown format");
    }

    #[test]
    fn every_tool_reads_back_and_is_a_body() {
        for tool in catalogue() {
            let (read, notes) = Tool::from_yaml(&tool.to_yaml(Some(SOURCE)), "file").unwrap();
            assert_eq!(read, tool);
            assert!(notes.is_empty(), "{notes:?}");
            tool.inertia.unwrap().physical().unwrap();
        }
        assert!(catalogue().len() >= 16);
    }

    /// The paper, section VI: 0.2 kg and 0.1 kg.
    #[test]
    fn the_paper_s_rollers_weigh_what_it_says() {
        let mass = |name: &str| catalogue().into_iter().find(|t| t.name == name).unwrap().inertia.unwrap().m;
        assert!((mass("large-roller") - 0.2).abs() < 5e-4, "{}", mass("large-roller"));
        assert!((mass("small-roller") - 0.1).abs() < 5e-4, "{}", mass("small-roller"));
    }
}
