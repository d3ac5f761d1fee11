//! `dalembert export`: writes a system for other simulators.

use crate::clock;
use crate::exit::{Exit, is_quiet, warn};
use crate::output::{Form, Format, Output, Provenance, Source, Writes};
use ::scenes::SystemText;
use ::scenes::exchange::{Program, program, unit};
use exchange::fmu::{Binary, NoBinary, Unit, Version};
use std::path::{Path, PathBuf};

/// The C compiler for the sources of a functional mock-up unit.
const COMPILER: &str = "cc";

/// The last part of the long help.
pub const HELP: &str = "\
A unit of FMI 3.0 or 2.0 serves model exchange and co-simulation:

  * its parameters can be changed;
  * its inputs are the inputs of the file that have no value;
  * its events are those of the file and the conditions
    of `if`, `sign`, `abs`, `min`, `max` and `table`;
  * it has directional derivatives;
  * it contains its sources, and a binary for this platform
    if the C compiler `cc` is found.

Not exported, with an error at the line of the file:

  * contacts, diodes, implicit laws;
  * with --fmu and --modelica also dry friction, since the body may stick.";

/// Arguments of `export`.
#[derive(clap::Args, Debug)]
pub struct Args {
    /// The scene, a file with `[coordinates]`
    #[arg(value_name = "SCENE.toml")]
    pub scene: PathBuf,
    #[command(flatten)]
    pub target: Target,
    /// The version of the standard of --fmu: 3, which is the default, or 2
    #[arg(long, value_name = "VERSION", value_parser = version)]
    pub fmi: Option<Version>,
    /// Replaces a file even if `export` did not write it
    #[arg(long)]
    pub force: bool,
}

/// The file to be written, exactly one.
#[derive(clap::Args, Debug)]
#[group(required = true, multiple = false)]
pub struct Target {
    /// A functional mock-up unit of FMI 3.0, or of FMI 2.0 with --fmi 2
    #[arg(long, value_name = "FILE.fmu")]
    pub fmu: Option<PathBuf>,
    /// A flat Modelica model with its events; its name is that of the file
    #[arg(long, value_name = "FILE.mo")]
    pub modelica: Option<PathBuf>,
    /// Rates and accelerations in C99, with the start
    #[arg(long, value_name = "FILE.c")]
    pub c: Option<PathBuf>,
    /// Rates and accelerations in Python over NumPy, with the start
    #[arg(long, value_name = "FILE.py")]
    pub python: Option<PathBuf>,
    /// Rates and accelerations in Rust, with the start
    #[arg(long, value_name = "FILE.rs")]
    pub rust: Option<PathBuf>,
    /// Rates and constraints as functions of CasADi, with the start
    #[arg(long, value_name = "FILE.py")]
    pub casadi: Option<PathBuf>,
}

fn version(text: &str) -> Result<Version, String> {
    match text {
        "2" | "2.0" => Ok(Version::Two),
        "3" | "3.0" => Ok(Version::Three),
        _ => Err("2 and 3 are accepted".to_owned()),
    }
}

/// Writes the requested file.
pub fn export(asked: &Args) -> Result<Exit, Exit> {
    let writes = Writes { command: "export", force: asked.force, reads: vec![&asked.scene] };
    let Target { fmu, modelica, c, python, rust, casadi } = &asked.target;
    let programs = [
        (modelica, Program::Modelica, Source::MODELICA),
        (c, Program::C, Source::C),
        (python, Program::Python, Source::PYTHON),
        (rust, Program::Rust, Source::RUST),
        (casadi, Program::Casadi, Source::PYTHON),
    ];
    let text = || SystemText::read(&asked.scene).map_err(Exit::from);
    let provenance = Provenance::of(writes.maker(), &asked.scene);
    if asked.fmi.is_some() && fmu.is_none() {
        return Err(Exit::refused("--fmi is the version of a functional mock-up unit: it is accepted with --fmu"));
    }
    let written = if let Some(path) = fmu {
        let output = writes.output(path, &[Form::Unit])?;
        let unit = unit(&text()?, &identifier(path), &provenance.line(), &writes.maker().generator())?;
        let unit = Unit { version: asked.fmi.unwrap_or_default(), ..unit };
        let binary = compiled(&output, &unit)?;
        output.write(|out| unit.write(out, binary.as_ref()))?
    } else {
        let found = programs.iter().find_map(|(path, program, source)| Some((path.as_deref()?, *program, *source)));
        let Some((path, target, source)) = found else {
            return Err(Exit::refused("one file to be written is accepted"));
        };
        let output = writes.output(path, &[Form::Program(source)])?;
        let (code, left_out) = program(&text()?, target, &identifier(path))?;
        if !is_quiet() {
            left_out.iter().for_each(|told| warn(&format!("warning: {}: {told}", asked.scene.display())));
        }
        output.write_text(&(provenance.comment(source.comment) + &code))?
    };
    written.tell(Format::Text)?;
    Ok(Exit::Done)
}

/// The compiled binary of a functional mock-up unit; `None`, with a warning, where no compiler is found.
fn compiled(output: &Output, unit: &Unit) -> Result<Option<Binary>, Exit> {
    let folder = tempfile::tempdir().map_err(Exit::refused)?;
    match Binary::of(unit, COMPILER, folder.path(), || clock::goes_on().is_continue()) {
        Ok(binary) => Ok(Some(binary)),
        Err(why @ NoBinary::NoCompiler(_)) => {
            if !is_quiet() {
                warn(&format!("warning: {}: {why}: the unit has its sources alone", output.path().display()));
            }
            Ok(None)
        }
        Err(why) => Err(Exit::refused(format!("{}: {why}", output.path().display()))),
    }
}

/// The name of a file without its extension, as an identifier.
fn identifier(path: &Path) -> String {
    let stem = path.file_stem().map_or_else(|| "system".to_owned(), |stem| stem.to_string_lossy().into_owned());
    let plain: String = stem.chars().map(|letter| if letter.is_ascii_alphanumeric() { letter } else { '_' }).collect();
    match plain.chars().next() {
        Some(first) if !first.is_ascii_digit() => plain,
        _ => format!("_{plain}"),
    }
}
