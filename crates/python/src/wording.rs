//! Messages of the command line, reworded for Python.

use dalembert::reader::SceneError;

/// Options in messages, and the arguments of Python that replace them.
const ARGUMENTS: [(&str, &str); 8] = [
    ("--range ", "range of "),
    ("--seconds", "`seconds`"),
    ("--boxes ", "boxes="),
    ("--motion for ", "`motions` of "),
    ("--motion", "`motions`"),
    ("--unknown with ", "`unknowns` with "),
    ("--unknown forces", "`unknowns`"),
    ("--unknown", "`unknowns`"),
];

/// The faults of a text, reworded for Python.
pub fn of_python(mut error: SceneError) -> SceneError {
    for issue in &mut error.issues {
        issue.title = in_python(&issue.title);
        issue.label = in_python(&issue.label);
        issue.help = issue.help.take().map(|help| in_python(&help));
    }
    error
}

/// A message reworded: `--range "x=-1..1"` becomes ranges={"x": (-1, 1)}, `--motion "x = 2*t"` becomes motions={"x": "2*t"}.
pub fn in_python(said: &str) -> String {
    let range = |text: &str| {
        let (name, ends) = text.split_once('=')?;
        let (from, to) = ends.split_once("..")?;
        Some(format!("ranges={{\"{name}\": ({from}, {to})}}"))
    };
    let motion = |text: &str| {
        let (name, is) = text.split_once(" = ")?;
        Some(format!("motions={{\"{name}\": \"{is}\"}}"))
    };
    let said = quoted(&quoted(said, "--range \"", range), "--motion \"", motion);
    ARGUMENTS.iter().fold(said, |told, (option, argument)| told.replace(option, argument))
}

/// The message with an option and its quoted value replaced, wherever `words` returns a replacement.
fn quoted(said: &str, option: &str, words: impl Fn(&str) -> Option<String>) -> String {
    let mut parts = said.split(option);
    let mut told = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        match part.split_once('"').and_then(|(value, rest)| Some((words(value)?, rest))) {
            Some((value, rest)) => told += &format!("{value}{rest}"),
            None => told += &format!("{option}{part}"),
        }
    }
    told
}
