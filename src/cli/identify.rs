//! `denavit identify`: identifies base parameters from logs, and writes the robot file with the
//! values.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use dh_codegen::arm::param::{self, Parameter};
use dh_codegen::robot::{EffectKind, Laws, Robot};

use super::Failure;
use super::delivery::deliver;
use super::files;
use super::known_effects::{FileEffects, without};
use super::logbook::{Logbook, Purpose};
use super::motors;
use super::prepare::{Preparation, against_limits, pass, warned};
use super::provenance::Provenance;
use super::torque_columns::Tried;
use crate::data::signal::{Derivatives, Motion, Prepare, Prepared};
use crate::identify::tool::Body;
use crate::identify::{
    AccumulatorSettings, Better, Bounds, BudgetCollector, Consistent, ConsistentError, ConsistentSettings, Essential,
    Extrapolation, Factors, Identification, IdentifyError, IdentifySettings, KnownEffects, LeftOutError, Preference,
    PriorBody, QrAccumulator, Reference, Trace, Tracer, buildable_links, consistent, extrapolation, geometric_bodies,
    left_out, nonnegative_drives, possible_bodies, prior_bodies, recover_standard, solve,
};
use crate::model::coupled::Coupled;
use crate::model::interpreted::Interpreted;
use crate::model::robot_edit;
use crate::model::{Arm, DriveTerm, LinkExtents, StandardParameter};
use crate::report;

/// Identify the base parameters from logs, validate them on others, and write the robot file with
/// the values in place.
///
/// Logs are low-passed forward and backward, positions are differentiated by central
/// differences, and the base regressor is fitted by least squares with each joint weighted by its
/// own noise. Drive parameters are identified where the robot file's `drive` has them (a value of 0
/// will do); a `gear_coupling` there brings its `IAM`, `FVM` and `FCM` along.
///
/// The robot file that is written has links that could be built (positive mass, possible tensor)
/// and nearly the same torques; what that costs is printed. What torques don't show comes from the
/// links of the robot file (`--prior cad`) or from the arm's geometry.
#[derive(Args)]
#[command(
    after_help = concat!(
        "Example:\n  denavit identify robots/kuka-iiwa14.yaml run1.csv run2.csv --validate run3.csv \\\n      --out identified.yaml --report identified.html",
        log_columns!()
    )
)]
pub(super) struct Identify {
    /// Robot file.
    robot: PathBuf,
    /// Logs to fit.
    #[arg(required = true, value_name = "LOG")]
    logs: Vec<PathBuf>,
    /// Logs to validate on; they are not used to fit. One that holds samples of another log is
    /// refused.
    #[arg(long, num_args = 1.., value_name = "LOG")]
    validate: Vec<PathBuf>,
    /// Robot file to write: the one that was read, with the identified values in place and what
    /// made them under `provenance`.
    #[arg(long, value_name = "ROBOT2")]
    out: Option<PathBuf>,
    /// Write the result as JSON; `-` for standard output.
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Write a page with torques, residuals, parameters and correlations.
    #[arg(long, value_name = "FILE.html")]
    report: Option<PathBuf>,
    /// Source of velocities and accelerations.
    #[arg(long, value_enum, default_value_t = Source::Position)]
    derivatives: Source,
    /// Ordinary least squares: do not weight joints by their noise.
    #[arg(long)]
    ordinary: bool,
    /// Leave out parameters that are not essential.
    #[arg(long)]
    essential: bool,
    /// Whether the links that are written must be possible bodies; without a value: `require`.
    #[arg(
        long,
        value_enum,
        default_value_t = Consistency::Auto,
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = "require"
    )]
    consistent: Consistency,
    /// Source of the bodies where torques don't determine them.
    #[arg(long, value_enum, default_value_t = PriorFrom::Cad)]
    prior: PriorFrom,
    /// Weight of these bodies: 1 means a relative standard deviation of about 100 %, 100 of 10 %.
    #[arg(long, default_value_t = 1.0, value_name = "WEIGHT")]
    prior_weight: f64,
    /// Mass of all links together, without the tool, kg.
    #[arg(long, value_name = "KG")]
    mass_total: Option<f64>,
    /// CSV with columns `link,what,low,high`: bounds on the mass (`M`, kg) or the centre of mass
    /// (`X`, `Y`, `Z`, m, in the link's frame) of a link.
    #[arg(long, value_name = "CSV")]
    bounds: Option<PathBuf>,
    /// By how much possible bodies may raise the weighted residual, beyond noise, before the data
    /// contradict physics, percent.
    #[arg(long, default_value_t = 25.0, value_name = "PERCENT")]
    most_cost: f64,
    #[command(flatten)]
    preparation: Preparation,
}

#[derive(Clone, Copy, ValueEnum)]
enum Source {
    /// Central differences of the low-passed positions.
    Position,
    /// The log's `dq` (and `ddq`).
    Recorded,
    /// Zero: static poses.
    Rest,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Consistency {
    /// Possible bodies; where the data do not allow them the plain values are shown, and no robot
    /// file is written.
    Auto,
    /// Possible bodies, or an error.
    Require,
    /// The plain values; rotor inertias and friction levels are not below zero. The robot file is
    /// written where links that could be built have these values.
    Never,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum PriorFrom {
    /// The links of the robot file.
    Cad,
    /// A guess from the arm's geometry, weighing a thousandth.
    None,
}

impl Identify {
    /// An identification with defaults for all options not given here.
    pub(super) fn plainly(
        robot: PathBuf,
        logs: Vec<PathBuf>,
        validate: Vec<PathBuf>,
        out: PathBuf,
        preparation: Preparation,
    ) -> Self {
        Self {
            robot,
            logs,
            validate,
            out: Some(out),
            json: None,
            report: None,
            derivatives: Source::Position,
            ordinary: false,
            essential: false,
            consistent: Consistency::Auto,
            prior: PriorFrom::Cad,
            prior_weight: 1.0,
            mass_total: None,
            bounds: None,
            most_cost: 25.0,
            preparation,
        }
    }

    pub(super) fn run(self, provenance: Provenance) -> Result<(), Failure> {
        self.check_options()?;
        let file = files::robot(&self.robot)?;
        files::check_outputs(
            &[("--out", &self.out), ("--json", &self.json), ("--report", &self.report)],
            file.read.iter().chain(&self.logs).chain(&self.validate).chain(&self.bounds),
        )?;
        self.with_setup(&file, |setup| {
            let solved = self.solved(setup, Logbook::of(&file.text))?;
            self.deliver(setup, &file, &solved, provenance)
        })
    }

    /// Identifies the robot for a verb that continues with it.
    ///
    /// # Errors
    /// Returns an error with the reason if there is no such robot.
    pub(super) fn model(&self, file: &files::RobotFile) -> Result<Model, Failure> {
        self.check_options()?;
        self.with_setup(file, |setup| {
            let solved = self.solved(setup, Logbook::of(&file.text))?;
            let out = self.out.as_ref().filter(|_| solved.writable);
            self.outcome(solved.underdetermined(), out, solved.refused(), &solved.unbuildable)?;
            let (robot, warnings) = (solved.robot(setup), solved.warnings(setup, true));
            let low_pass = Preparation::low_pass(&setup.prepare);
            Ok(Model { robot, found: solved.found, warnings, logbook: solved.logbook, low_pass })
        })
    }

    /// Calls `then` with the arm of a robot file and the preparation of its logs.
    pub(super) fn with_setup<T>(
        &self,
        file: &files::RobotFile,
        then: impl FnOnce(&Setup<'_>) -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        let why = "an identification takes the torque of every joint from the log";
        motors::on_every_joint(&self.robot, &file.robot, why)?;
        if self.prior == PriorFrom::None && file.robot.links.iter().all(Option::is_none) {
            return Err(Failure::input(format!(
                "{}: --prior none leaves the links of the robot file out, and it has none; leave the option out, too",
                self.robot.display()
            )));
        }
        let mut prepare = self.prepare(&file.robot)?;
        let bodies = Interpreted::new(&file.robot, &[]);
        let couplings = robot_edit::couplings(&file.robot);
        prepare.sums = couplings.iter().map(|(coupling, _)| coupling.velocity()).collect();
        let given: Vec<f64> = couplings.iter().flat_map(|(_, values)| *values).collect();
        let arm = Coupled::new(&bodies, couplings.into_iter().map(|(coupling, _)| coupling).collect());
        let prior = param::standard_values(&file.robot).map(|values| [values, given].concat());
        let effects = FileEffects::of(&file.robot, &[EffectKind::GearCoupling]);
        effects.iter().for_each(|effects| effects.prepare(&mut prepare));
        let known = effects.as_ref().and_then(|effects| effects.known(&arm, prior.as_deref(), prepare.filter));
        let known = known.as_ref();
        then(&Setup {
            robot: &file.robot,
            bodies: &bodies,
            arm: &arm,
            prior,
            prepare,
            effects: effects.as_ref(),
            known,
        })
    }

    /// Identifies, and determines what can be written.
    fn solved(&self, setup: &Setup<'_>, logbook: Logbook) -> Result<Solved, Failure> {
        let Setup { robot, bodies, arm, ref prepare, known, .. } = *setup;
        let prior = setup.prior.as_deref();
        let Read { fit, validate, mut prepared, logbook, parts } = self.read(arm, prepare, known, logbook)?;
        against_limits(&mut prepared, robot, prepare.keep)?;
        let solving = IdentifySettings {
            weighted: !self.ordinary,
            essential: self.essential.then(Essential::default),
            prior: setup.prior.clone(),
            ..IdentifySettings::default()
        };
        let mut found = solve(arm, &fit, &validate, &solving).map_err(unsolved)?;
        self.explain(&mut found, robot, arm, prepare, known)?;
        found.budget = parts.finish(arm, &found.values(), &found.fit.rms);
        let underdetermined = found.underdetermined().is_some();
        let carry = extrapolation(arm, bodies, &found);
        let possible = match self.consistent {
            Consistency::Never => None,
            _ => Some(self.bodies(robot, arm, bodies, &fit, &validate, &found)?),
        };
        if let (Consistency::Require, Some(Err(error))) = (self.consistent, &possible) {
            return Err(Failure::other(format!("no possible bodies: {error}")));
        }
        // If the plain solution is itself possible, the file gets bodies with exactly its base
        // parameters.
        let exact = match (self.consistent, &possible) {
            (Consistency::Auto, Some(Ok(_))) if self.prior_weight == 1.0 && !underdetermined => {
                let (prior, settings) = (self.prior_of(robot, bodies), self.settings(robot, arm)?);
                let same = possible_bodies(arm, &found.values(), &prior, &drives(robot), &settings);
                same.ok().filter(|same| same.exact).map(|same| same.standard)
            }
            _ => None,
        };
        let left_out = match &possible {
            Some(Ok(c)) if !underdetermined => self.left_out(robot, arm, bodies, &fit, &found, c, prior)?,
            _ => None,
        };
        // If the data determine nothing, only bodies near the file's own can be written.
        let complete = robot.links.len() == robot.joints.len() && robot.links.iter().all(Option::is_some);
        let near = self.prior == PriorFrom::Cad && complete && matches!(possible, Some(Ok(_)));
        let idle = possible.is_none() && !underdetermined && carry.says_nothing(&found);
        let logs = [&fit[..], &validate[..]];
        let (written, unbuildable) =
            self.to_write(robot, arm, bodies, logs, &found, &solving, possible.as_ref(), exact.as_deref())?;
        let nothing = matches!(possible, Some(Err(_))) || idle || !unbuildable.is_empty();
        let writable = !nothing && (!underdetermined || near);
        let exact = exact.is_some();
        Ok(Solved { found, prepared, logbook, carry, possible, exact, left_out, written, unbuildable, writable })
    }

    /// Writes files and text.
    fn deliver(
        &self,
        setup: &Setup<'_>,
        file: &files::RobotFile,
        solved: &Solved,
        provenance: Provenance,
    ) -> Result<(), Failure> {
        let (found, prepared, underdetermined) = (&solved.found, &solved.prepared, solved.underdetermined());
        let provenance = provenance
            .robot(&self.robot, file)
            .logs(&solved.logbook)
            .with("low-pass", Preparation::low_pass(&setup.prepare));
        let out = self.out.as_ref().filter(|_| solved.writable);
        let possible = solved.shown(out.is_some());
        let warnings = solved.warnings(setup, out.is_some());
        let page = || {
            let traces = self.traces(setup.arm, found, &setup.prepare, setup.known)?;
            let links = report::Links {
                now: links(setup.robot, Some(&solved.written.standard)),
                file: links(setup.robot, setup.prior.as_deref()),
                possible: possible.as_ref(),
            };
            Ok(report::identify_html(found, prepared, &warnings, &traces, Some(&links), &provenance.rows()))
        };
        let rewritten =
            || file.rewritten(&solved.robot(setup), out.unwrap_or(&self.robot), &provenance.run(Vec::new()));
        let json = || {
            let mut json = report::identify_json(found, prepared, &warnings, &provenance.rows());
            json["carry_over"] = report::extrapolation_json(&solved.carry);
            json["at_bound"] = solved.written.at_bound.clone().into();
            if let Some(possible) = &possible {
                json["consistent"] = report::consistent_json(possible);
            }
            json
        };
        let text = || {
            let shown = possible.as_ref().filter(|_| !underdetermined);
            let links = shown.map_or_else(String::new, |possible| report::consistent_text(found, possible));
            report::identify_text(found, prepared, &warnings) + &links
        };
        deliver(&provenance)
            .file(out, rewritten)?
            .try_file(self.report.as_ref(), page)?
            .json(self.json.as_ref(), json)?
            .text(text)?;
        self.outcome(underdetermined, out, solved.refused(), &solved.unbuildable)
    }

    /// Standard parameters for the robot file. Also returns the links (from 1) that no body can
    /// have, if there are no others with the plain values.
    #[allow(clippy::too_many_arguments)]
    fn to_write(
        &self,
        robot: &Robot,
        arm: &Coupled<'_>,
        reach: &dyn LinkExtents,
        [fit, validate]: [&[Factors]; 2],
        found: &Identification,
        solving: &IdentifySettings,
        possible: Option<&Result<Consistent, ConsistentError>>,
        exact: Option<&[f64]>,
    ) -> Result<(Written, Vec<usize>), Failure> {
        let floors = floors(robot, arm);
        if let Some(Ok(bodies)) = possible {
            return Ok((Written::bodies(exact.unwrap_or(&bodies.standard), arm, found, &floors), Vec::new()));
        }
        let mut written = Written::plain(arm, fit, validate, found, solving, &floors)?;
        if possible.is_some() || self.out.is_none() {
            return Ok((written, Vec::new()));
        }
        let (prior, settings) = (self.prior_of(robot, reach), self.settings(robot, arm)?);
        match buildable_links(arm, &written.standard, &prior, &settings) {
            Ok(standard) => written.standard = standard,
            Err(impossible) => return Ok((written, impossible)),
        }
        Ok((written, Vec::new()))
    }

    /// Determines the exit status: whether the requested file was written, and if not, why.
    fn outcome(
        &self,
        underdetermined: bool,
        out: Option<&PathBuf>,
        refused: bool,
        unbuildable: &[usize],
    ) -> Result<(), Failure> {
        let Some(path) = out else {
            let not_written = match underdetermined {
                true => {
                    return Err(Failure::other(
                        "the logs do not determine the parameters, so no robot file was written; record a longer motion of all joints",
                    ));
                }
                false if self.out.is_none() => return Ok(()),
                false if refused => {
                    "no possible bodies explain the logs (see the warning); `--most-cost 1000` takes the nearest ones, and --json has the plain values".to_string()
                }
                false if !unbuildable.is_empty() => {
                    let links: Vec<String> = unbuildable.iter().map(usize::to_string).collect();
                    format!(
                        "no links that could be built have the plain values (impossible: link {}); without `--consistent=never` links are fitted that could be \
                         built, and --json has the plain values",
                        links.join(", ")
                    )
                }
                false => "the plain values predict no joint's torque in other motions; record a richer motion".to_string(),
            };
            return Err(Failure::other(format!("no robot file was written, as {not_written}")));
        };
        match underdetermined {
            false => Ok(()),
            true => Err(Failure::other(format!(
                "the logs do not determine the parameters; {} has possible bodies near the links of {}, and no measurement",
                path.display(),
                self.robot.display()
            ))),
        }
    }

    /// Fit with physically consistent bodies. Invalid options are a failure; data without such
    /// bodies are a result.
    fn bodies(
        &self,
        robot: &Robot,
        arm: &Coupled<'_>,
        reach: &dyn LinkExtents,
        fit: &[Factors],
        validate: &[Factors],
        found: &Identification,
    ) -> Result<Result<Consistent, ConsistentError>, Failure> {
        let (settings, prior) = (self.settings(robot, arm)?, self.prior_of(robot, reach));
        match consistent(arm, fit, validate, found, &prior, &drives(robot), &settings) {
            Err(error @ ConsistentError::Bounds { .. }) => Err(Failure::input(error)),
            result => Ok(result),
        }
    }

    /// Cross-validation on the fitted logs, leaving out one part at a time, if the validating logs
    /// prefer the plain solution.
    #[allow(clippy::too_many_arguments)]
    fn left_out(
        &self,
        robot: &Robot,
        arm: &Coupled<'_>,
        reach: &dyn LinkExtents,
        fit: &[Factors],
        found: &Identification,
        bodies: &Consistent,
        file: Option<&[f64]>,
    ) -> Result<Option<Result<Preference, LeftOutError>>, Failure> {
        if bodies.against_plain.as_ref().is_none_or(|p| p.better() != Better::First) {
            return Ok(None);
        }
        let (settings, prior) = (self.settings(robot, arm)?, self.prior_of(robot, reach));
        Ok(Some(left_out(arm, fit, found, &prior, &drives(robot), &settings, file)))
    }

    fn settings(&self, robot: &Robot, arm: &dyn Arm) -> Result<ConsistentSettings, Failure> {
        Ok(ConsistentSettings {
            prior_weight: self.prior_weight,
            bounds: self.bounds(robot)?,
            carried: robot_edit::carried(robot),
            floors: floors(robot, arm),
            most_cost_percent: self.most_cost,
            ..ConsistentSettings::default()
        })
    }

    fn prior_of(&self, robot: &Robot, arm: &dyn LinkExtents) -> Vec<PriorBody> {
        match self.prior {
            PriorFrom::Cad => robot_edit::prior(robot, arm),
            PriorFrom::None => prior_bodies(&[], &geometric_bodies(&arm.ends())),
        }
    }

    /// Bounds from `--bounds` and `--mass-total`.
    fn bounds(&self, robot: &Robot) -> Result<Bounds, Failure> {
        let mut bounds = Bounds { total_mass: self.mass_total, ..Bounds::default() };
        let Some(path) = &self.bounds else { return Ok(bounds) };
        let text = files::text(path)?;
        for (line, row) in (1..).zip(text.lines()).skip(1).filter(|(_, row)| !row.trim().is_empty()) {
            let bad = |what: &str| {
                let place = format!("{}, line {line}: {what}", path.display());
                Failure::input(format!("{place}; a row is `link,what,low,high`, as `2,M,1.5,4` or `2,X,-0.1,0.1`"))
            };
            let cells: Vec<&str> = row.split(',').map(str::trim).collect();
            let &[link, what, low, high] = cells.as_slice() else { return Err(bad("not four columns")) };
            let number =
                |text: &str| text.parse::<f64>().ok().filter(|x| !x.is_nan()).ok_or_else(|| bad("not a number"));
            let range = [number(low)?, number(high)?];
            let link = link.parse::<usize>().ok().filter(|l| (1..=robot.joints.len()).contains(l));
            let link = link.ok_or_else(|| bad("no such link"))? - 1;
            match what {
                "M" => bounds.mass.push((link, range)),
                "X" | "Y" | "Z" => bounds.center.push((link, usize::from(what.as_bytes()[0] - b'X'), range)),
                _ => return Err(bad("`what` is none of M, X, Y, Z")),
            }
        }
        Ok(bounds)
    }

    fn prepare(&self, robot: &Robot) -> Result<Prepare, Failure> {
        let derivatives = match self.derivatives {
            Source::Position => Derivatives::FromPosition,
            Source::Recorded => Derivatives::Recorded,
            Source::Rest => Derivatives::AtRest,
        };
        Ok(Prepare { derivatives, ..self.preparation.prepare(robot)? })
    }

    /// Refuses options that are out of range, or have no effect with the others.
    fn check_options(&self) -> Result<(), Failure> {
        let plain = self.consistent == Consistency::Never;
        let defaults = [
            ("--prior", self.prior != PriorFrom::Cad),
            ("--prior-weight", self.prior_weight != 1.0),
            ("--mass-total", self.mass_total.is_some()),
            ("--bounds", self.bounds.is_some()),
            ("--most-cost", self.most_cost != 25.0),
        ];
        if let Some((option, _)) = defaults.iter().find(|(_, given)| plain && *given) {
            return Err(Failure::input(format!(
                "{option} is of possible bodies, and --consistent=never asks for none; leave one of the two out"
            )));
        }
        if !(self.prior_weight > 0.0 && self.prior_weight.is_finite()) {
            return Err(Failure::input(format!("--prior-weight {}: a number above 0", self.prior_weight)));
        }
        if self.most_cost.is_nan() || self.most_cost <= 0.0 {
            return Err(Failure::input(format!("--most-cost {}: percent, above 0", self.most_cost)));
        }
        let rest = matches!(self.derivatives, Source::Rest);
        self.preparation.check_options(rest.then_some("--derivatives rest takes every joint as standing"))
    }

    /// First pass over all logs. Torques of known effects are subtracted.
    fn read(
        &self,
        arm: &Coupled<'_>,
        prepare: &Prepare,
        known: Option<&KnownEffects<'_>>,
        logbook: Logbook,
    ) -> Result<Read, Failure> {
        let mut read = Read { logbook, ..Read::default() };
        let logs = self.logs.iter().map(|path| (Purpose::Fit, path));
        for (purpose, path) in logs.chain(self.validate.iter().map(|path| (Purpose::Validate, path))) {
            let mut stack = QrAccumulator::new(&path.display().to_string(), arm, AccumulatorSettings::default());
            let parts = &mut read.parts;
            let sink = |motion: &Motion| {
                let motion = without(known, motion);
                stack.absorb(&motion);
                (purpose == Purpose::Fit).then(|| parts.absorb(&motion));
            };
            let log = read.logbook.pass(purpose, path, arm.dof(), prepare, sink)?;
            read.prepared.push(warned(path, log));
            let factors = if purpose == Purpose::Fit { &mut read.fit } else { &mut read.validate };
            factors.push(stack.finish());
            let share = MOST_BATCHES / (read.fit.len() + read.validate.len());
            read.fit.iter_mut().chain(&mut read.validate).for_each(|log| log.shrink(share));
        }
        Ok(read)
    }

    /// Tries other orders and units of the torque columns if the torques may be misinterpreted.
    fn explain(
        &self,
        found: &mut Identification,
        robot: &Robot,
        arm: &dyn Arm,
        prepare: &Prepare,
        known: Option<&KnownEffects<'_>>,
    ) -> Result<(), Failure> {
        if !found.is_suspicious() {
            return Ok(());
        }
        let file: Option<Vec<f64>> = found.parameters.iter().map(|p| p.prior).collect();
        let file = file.filter(|values| values.iter().any(|v| *v != 0.0));
        let references: Vec<Reference<'_>> =
            std::iter::once(Reference::Fit).chain(file.as_ref().map(|beta| Reference::Model(beta))).collect();
        let mut tried = Tried::new(robot, prepare, known);
        for path in self.logs.iter().chain(&self.validate) {
            tried.log(path, arm, &references)?;
        }
        tried.tell(found);
        Ok(())
    }

    /// Torques over time for plots: a second pass with the identified parameters.
    fn traces(
        &self,
        arm: &dyn Arm,
        found: &Identification,
        prepare: &Prepare,
        known: Option<&KnownEffects<'_>>,
    ) -> Result<Vec<Trace>, Failure> {
        let beta = found.values();
        let logs = self.logs.iter().map(|p| (p, false)).chain(self.validate.iter().map(|p| (p, true)));
        logs.map(|(path, validates)| {
            let mut tracer = Tracer::new(&path.display().to_string(), validates, arm, &beta);
            pass(path, arm.dof(), prepare, |motion| tracer.absorb(&without(known, motion)))?;
            Ok(tracer.finish())
        })
        .collect()
    }
}

/// A robot file prepared for identification.
pub(super) struct Setup<'a> {
    pub(super) robot: &'a Robot,
    /// The arm without the gears' couplings.
    bodies: &'a Interpreted,
    pub(super) arm: &'a Coupled<'a>,
    /// Standard parameters of the file.
    prior: Option<Vec<f64>>,
    pub(super) prepare: Prepare,
    effects: Option<&'a FileEffects>,
    pub(super) known: Option<&'a KnownEffects<'a>>,
}

/// An identified robot.
pub(super) struct Model {
    pub(super) robot: Robot,
    pub(super) found: Identification,
    pub(super) warnings: report::Warnings,
    pub(super) logbook: Logbook,
    /// Description of the low-pass.
    pub(super) low_pass: String,
}

/// Result of an identification, and what of it can be written.
struct Solved {
    found: Identification,
    prepared: Vec<Prepared>,
    logbook: Logbook,
    carry: Extrapolation,
    /// Physically consistent bodies; `None` if not requested.
    possible: Option<Result<Consistent, ConsistentError>>,
    /// Whether the bodies of the file have exactly the identified base parameters.
    exact: bool,
    left_out: Option<Result<Preference, LeftOutError>>,
    written: Written,
    /// Links, from 1, that no body with the plain values can have.
    unbuildable: Vec<usize>,
    /// Whether there is a robot file to write.
    writable: bool,
}

impl Solved {
    fn underdetermined(&self) -> bool {
        self.found.underdetermined().is_some()
    }

    fn refused(&self) -> bool {
        matches!(self.possible, Some(Err(_)))
    }

    /// The robot with the identified values.
    fn robot(&self, setup: &Setup<'_>) -> Robot {
        let (own, coupled) = self.written.standard.split_at(setup.bodies.standard_parameters().len());
        robot_edit::with_couplings(robot_edit::with_values(setup.robot.clone(), own), coupled)
    }

    /// The bodies in the form for reports.
    fn shown(&self, written: bool) -> Option<report::Possible<'_>> {
        self.possible.as_ref().map(|result| report::Possible {
            result: result.as_ref(),
            written: written.then_some(result.is_ok()),
            plain: self.exact,
            left_out: self.left_out.as_ref(),
        })
    }

    fn warnings(&self, setup: &Setup<'_>, written: bool) -> report::Warnings {
        let possible = self.shown(written);
        let mut warnings = report::identify_warnings(&self.found, &self.prepared, Some(&self.carry), possible.as_ref());
        setup.effects.iter().for_each(|effects| warnings.push(effects.sentence(setup.known.is_some())));
        self.written.warning.iter().filter(|_| written).for_each(|text| warnings.push(text));
        warnings
    }
}

/// Largest number of batches kept per joint, over all logs: 50 MB for seven joints. Four logs keep
/// all of theirs.
const MOST_BATCHES: usize = 256;

/// Result of the first pass over the logs.
#[derive(Default)]
struct Read {
    fit: Vec<Factors>,
    validate: Vec<Factors>,
    prepared: Vec<Prepared>,
    logbook: Logbook,
    parts: BudgetCollector,
}

/// Standard parameters for the robot file.
struct Written {
    standard: Vec<f64>,
    /// Rotor inertias and friction levels at their lower bound.
    at_bound: Vec<String>,
    warning: Option<String>,
}

impl Written {
    /// Parameters of physically consistent bodies.
    fn bodies(standard: &[f64], arm: &dyn Arm, found: &Identification, floors: &[(usize, f64)]) -> Self {
        let least = |leader: StandardParameter| {
            let own = floors.iter().find(|(i, _)| arm.standard_parameters().get(*i) == Some(&leader));
            own.map_or(0.0, |(_, least)| *least)
        };
        let below = found.parameters.iter().filter(|p| p.leader.is_level() && p.value < least(p.leader));
        Self { standard: standard.to_vec(), at_bound: below.map(|p| p.name.clone()).collect(), warning: None }
    }

    /// Plain values, without impossible drives.
    fn plain(
        arm: &dyn Arm,
        fit: &[Factors],
        validate: &[Factors],
        found: &Identification,
        solving: &IdentifySettings,
        floors: &[(usize, f64)],
    ) -> Result<Self, Failure> {
        let bounded = nonnegative_drives(arm, fit, found, solving, floors).map_err(unsolved)?;
        let standard = recover_standard(arm, &bounded.base, solving.prior.as_deref()).map_err(Failure::other)?;
        let warning = (!bounded.held.is_empty()).then(|| report::held_text(&bounded, fit, validate));
        let mut at_bound = bounded.held;
        // Parameters that share a base parameter with others.
        let zero = arm.standard_parameters().iter().zip(&standard).filter(|(p, v)| p.is_rotor() && **v == 0.0);
        let alone =
            |p: StandardParameter| arm.base_parameters().iter().any(|b| b.leader == p && b.coefficients.len() == 1);
        at_bound.extend(zero.filter(|(p, _)| !alone(**p)).map(|(p, _)| p.to_string()));
        Ok(Self { standard, at_bound, warning })
    }
}

/// Lower bounds of friction levels that differ with direction, by standard parameter: friction must
/// brake in the weaker direction too.
fn floors(robot: &Robot, arm: &dyn Arm) -> Vec<(usize, f64)> {
    let rows = robot.moving().into_iter();
    let of = |(row, laws): (usize, Laws)| {
        let [level, viscous] = [laws.asymmetric.level(laws.rated), laws.asymmetric.viscous(laws.rated)];
        [(DriveTerm::FC, level), (DriveTerm::FV, viscous)]
            .map(|(term, least)| (StandardParameter::Drive(row, term), least.abs()))
    };
    let place = |(wanted, least): (StandardParameter, f64)| {
        Some((arm.standard_parameters().iter().position(|p| *p == wanted)?, least))
    };
    rows.zip(robot.laws()).flat_map(of).filter(|(_, least)| *least > 0.0).filter_map(place).collect()
}

/// Too few samples are a verdict on the data; other problems are those of the input.
fn unsolved(error: IdentifyError) -> Failure {
    match error {
        IdentifyError::TooFew { .. } => Failure::other(format!("underdetermined: {error}")),
        _ => Failure::input(error),
    }
}

/// Standard parameters as bodies, without the tool.
fn links(robot: &Robot, standard: Option<&[f64]>) -> Vec<Option<Body>> {
    let tool = robot_edit::carried(robot);
    let body = |link: usize| {
        let mut ten: [f64; 10] = standard?.get(10 * link..10 * link + 10)?.try_into().ok()?;
        for (_, carried) in tool.iter().filter(|(at, _)| *at == link) {
            ten.iter_mut().zip(carried).for_each(|(t, c)| *t -= c);
        }
        Body::new(&ten, &[0.0; 100])
    };
    (0..robot.joints.len()).map(body).collect()
}

/// The file's values of the drives, as standard parameters; zero for the links.
fn drives(robot: &Robot) -> Vec<f64> {
    let value = |p: &Parameter| match *p {
        Parameter::Drive(row, term) => param::drive_value(robot, row, term).unwrap_or(0.0),
        Parameter::Link(..) => 0.0,
    };
    let coupled = robot_edit::couplings(robot).into_iter().flat_map(|(_, values)| values);
    param::standard(robot).iter().map(value).chain(coupled).collect()
}
