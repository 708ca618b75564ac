//! `denavit new`: writes a robot file to fill in.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::Failure;
use super::delivery::deliver;
use super::files;
use super::provenance::Provenance;
use crate::report::{RobotTemplate, robot_template};

/// Write a commented robot file for an arm of n joints, to fill in.
///
/// The file is valid and has example lengths and limits. A URDF or MJCF model of the arm saves the
/// work: see `denavit import`.
#[derive(Args)]
#[command(
    after_help = "Examples:\n  denavit new my-arm --joints 6 --out my-arm.yaml\n  denavit new gantry --joints PPR --out gantry.yaml"
)]
pub(super) struct New {
    /// Name of the robot.
    name: String,
    /// How many joints, all revolute; or their kinds from base to tip, R and P: PPR.
    #[arg(long, value_name = "N|KINDS", value_parser = kinds)]
    joints: Kinds,
    /// Convention of the DH table.
    #[arg(long, value_enum, default_value_t = Convention::Modified)]
    convention: Convention,
    /// Robot file to write; `-` for standard output.
    #[arg(long, value_name = "FILE")]
    out: PathBuf,
    /// Replace a file that is there.
    #[arg(long)]
    force: bool,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Convention {
    /// Khalil and Kleinfinger: frame i on axis i.
    Modified,
    /// Denavit and Hartenberg: frame i on axis i+1.
    Standard,
}

/// For each joint, whether it is revolute.
#[derive(Clone)]
struct Kinds(Vec<bool>);

/// Largest number of joints of a new robot file.
const MOST: usize = 30;

fn kinds(text: &str) -> Result<Kinds, String> {
    let turns: Vec<bool> = match text.parse::<usize>() {
        Ok(n) => vec![true; n.min(MOST + 1)],
        Err(_) => text
            .chars()
            .map(|c| match c {
                'R' | 'r' => Ok(true),
                'P' | 'p' => Ok(false),
                _ => Err("a number of joints, or a letter for each: R turns, P slides".to_string()),
            })
            .collect::<Result<_, _>>()?,
    };
    if (1..=MOST).contains(&turns.len()) { Ok(Kinds(turns)) } else { Err(format!("from 1 to {MOST} joints")) }
}

impl New {
    pub(super) fn run(self, provenance: Provenance) -> Result<(), Failure> {
        let out = Some(self.out.clone());
        files::check_outputs(&[("--out", &out)], [])?;
        if self.out.is_file() && !self.force {
            let shown = self.out.display();
            return Err(Failure::input(format!(
                "{shown} is there already; choose another name, or replace it with --force"
            )));
        }
        let standard = self.convention == Convention::Standard;
        let text = robot_template(&RobotTemplate { name: &self.name, turns: &self.joints.0, standard });
        if let Err(problems) = dh_codegen::robot::Robot::from_yaml(&text, &dh_codegen::robot::no_files) {
            return Err(Failure::input(problems.in_file("the new file").to_string()));
        }
        let shown = self.out.display();
        deliver(&provenance)
            .file(Some(&self.out), || &text)?
            .only_text(|| format!("wrote {shown}; fill in the table, then run `denavit check {shown}`\n"))
    }
}
