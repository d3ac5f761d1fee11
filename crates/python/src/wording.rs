//! Sentences for readers of a command line, in words of Python.

use dalembert::reader::SceneError;

/// Options as they stand in sentences, and the arguments in their place.
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

/// The faults of a text, in words of Python.
pub fn of_python(mut error: SceneError) -> SceneError {
    for issue in &mut error.issues {
        issue.title = in_python(&issue.title);
        issue.label = in_python(&issue.label);
        issue.help = issue.help.take().map(|help| in_python(&help));
    }
    error
}

/// A sentence: `--range "x=-1..1"` is ranges={"x": (-1, 1)}, `--motion "x = 2*t"` is motions={"x": "2*t"}.
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

/// A sentence with other words for an option and its value in quotes, where there are some.
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
