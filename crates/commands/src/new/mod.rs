//! `dalembert new motor`: a motor that compiles and passes all checks, for its author to change.

mod names;

use crate::atomic_write;
use crate::exit::{Exit, print};
use clap::Subcommand;
use std::fs;
use std::path::{Path, PathBuf};

const MACHINE: &str = include_str!("machine.txt");
const TEST: &str = include_str!("test.txt");
const SCENE: &str = include_str!("scene.txt");
const TEXT: &str = include_str!("text.txt");

/// Arguments of `new`.
#[derive(clap::Args, Debug)]
pub struct Args {
    #[command(subcommand)]
    pub what: What,
}

#[derive(Debug, Subcommand)]
pub enum What {
    /// A motor that compiles and conforms: `derivations/machines/src/NAME.rs`, its two lines, a scene, a test
    Motor(Motor),
}

/// Arguments of `new motor`.
#[derive(clap::Args, Debug)]
pub struct Motor {
    /// Lower case letters, digits and _, as in `salient_pole`
    #[arg(value_name = "NAME")]
    pub name: String,
    /// Writes a scene with the motor's laws as text, instead of a Rust file
    #[arg(long)]
    pub text: bool,
    /// The folder of the project; with --text any folder
    #[arg(long, value_name = "FOLDER", default_value = ".")]
    pub project: PathBuf,
}

/// The file that lists the motors, as modules and as registered motors.
const LIST: &str = "derivations/machines/src/lib.rs";
const ENDS: [&str; 2] = ["\n\nmotor::submit! {", "\n        ],"];

/// A file to be created, with its text.
struct Begun {
    place: PathBuf,
    text: String,
}

/// Creates all files of the new motor, or none.
pub fn write(asked: &Args) -> Result<Exit, Exit> {
    let What::Motor(asked) = &asked.what;
    let name = asked.name.as_str();
    names::check_letters(name)?;
    let list = asked.project.join(LIST);
    let before = read(&list);
    let in_project = ENDS.iter().all(|end| before.contains(end));
    if !in_project && !asked.text {
        let folder = asked.project.display();
        return Err(Exit::refused(format!(
            "{folder} is not the project: there is no list of machines in {LIST}; its folder is accepted: --project FOLDER; \
             a motor as text, --text, needs no project"
        )));
    }
    let scene = scene_place(asked, in_project);
    let begun = begun(asked, &scene);
    for Begun { place, .. } in &begun {
        // a folder of this name could contain a module of the same name
        if place.exists() || (!asked.text && place.with_extension("").is_dir()) {
            let place = place.display();
            return Err(Exit::refused(format!("{place} exists; the name of a motor that does not exist is accepted")));
        }
    }
    names::check_free(name, &asked.project)?;
    for (written, Begun { place, text }) in begun.iter().enumerate() {
        if let Err(refused) = create(place, text) {
            begun[..written].iter().for_each(|begun| drop(fs::remove_file(&begun.place)));
            return Err(refused);
        }
    }
    if !asked.text {
        let lines = [format!("pub mod {name};"), format!("            &{name}::ENTRY,")];
        let after = lines.iter().zip(ENDS).fold(before, |text, (line, end)| with_line(&text, line, end));
        if let Err(error) = atomic_write::replace(&list, &after) {
            begun.iter().for_each(|begun| drop(fs::remove_file(&begun.place)));
            return Err(Exit::unwritable(&list, &error));
        }
    }
    let mut told: String = begun.iter().map(|begun| format!("wrote {}\n", begun.place.display())).collect();
    let scene = scene.display();
    told += &match asked.text {
        true => {
            format!("next: dalembert derive {scene}\n      dalembert conform {scene}\n      dalembert run {scene}\n")
        }
        false => format!(
            "added its lines to {}\nnext: cargo test --test {name}\n      cargo run --release -- conform {name}\n      \
             cargo run --release -- run {scene}\n",
            list.display()
        ),
    };
    if in_project {
        told += &format!("a scene in `scenes` is kept with its reference: dalembert reference {scene}\n");
    }
    print(&told)?;
    Ok(Exit::Done)
}

/// The path of the new scene: in the project's folder of scenes, or without a project in the given folder.
fn scene_place(asked: &Motor, in_project: bool) -> PathBuf {
    let folder = if in_project { "scenes/machines" } else { "" };
    asked.project.join(folder).join(&asked.name).with_extension("toml")
}

fn begun(asked: &Motor, scene: &Path) -> Vec<Begun> {
    let name = asked.name.as_str();
    let filled = |template: &str| template.replace("plain_name", name).replace("CamelName", &camel(name));
    if asked.text {
        return vec![Begun { place: scene.to_owned(), text: filled(TEXT) }];
    }
    vec![
        Begun {
            place: asked.project.join("derivations/machines/src").join(format!("{name}.rs")),
            text: filled(MACHINE),
        },
        Begun { place: scene.to_owned(), text: filled(SCENE) },
        Begun { place: asked.project.join("tests").join(format!("{name}.rs")), text: filled(TEST) },
    ]
}

/// The name of a type for the name of a motor: `SalientPole` for `salient_pole`.
fn camel(name: &str) -> String {
    let capital = |part: &str| {
        let mut letters = part.chars();
        letters.next().map_or_else(String::new, |first| first.to_ascii_uppercase().to_string() + letters.as_str())
    };
    name.split('_').map(capital).collect()
}

/// The text of a file; empty where it cannot be read.
fn read(place: &Path) -> String {
    fs::read_to_string(place).unwrap_or_default()
}

/// The text with a line inserted before the first occurrence of `end`.
fn with_line(text: &str, line: &str, end: &str) -> String {
    match text.split_once(end) {
        Some((before, after)) => format!("{before}\n{line}{end}{after}"),
        None => text.to_owned(),
    }
}

/// Creates a file, and its folder if it is missing.
fn create(place: &Path, text: &str) -> Result<(), Exit> {
    if let Some(folder) = place.parent() {
        fs::create_dir_all(folder).map_err(|error| Exit::unwritable(folder, &error))?;
    }
    atomic_write::create(place, text).map_err(|error| Exit::unwritable(place, &error))
}
