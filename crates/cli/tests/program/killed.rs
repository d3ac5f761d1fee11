//! Programs that are killed or interrupted: a file is either the old or the complete new one, and contains the results printed before.

use crate::{program, run, temporary};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::Duration;

/// A folder of one test, deleted with this value.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let folder = temporary(name);
        std::fs::create_dir_all(&folder).expect("a folder can be made");
        Folder(folder)
    }

    /// Whether the program is writing the file, or has replaced it.
    fn is_written(&self, old: &str, name: &str) -> bool {
        let part = |entry: std::io::Result<std::fs::DirEntry>| {
            entry.is_ok_and(|entry| entry.file_name() != name && entry.metadata().is_ok_and(|data| data.len() > 0))
        };
        std::fs::read_dir(&self.0).expect("it is there").any(part)
            || std::fs::metadata(self.0.join(name)).is_ok_and(|data| data.len() != old.len() as u64)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn ends(child: &mut Child) -> bool {
    child.try_wait().expect("it can be asked").is_some()
}

/// A pseudo-random number in [0, 1) from the seed, which is advanced.
fn drawn(seed: &mut u64) -> f64 {
    *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*seed >> 11) as f64 / (1u64 << 53) as f64
}

/// The content of the file before the program writes it.
const OLD: &str = "what was there before\n";

/// Kills a program `times` times at random instants up to `within` milliseconds, and `times` times while it writes its file. Each time
/// the file must be the old or the complete new one.
fn kill(arguments: &[&str], name: &str, (times, within): (usize, f64), whole: impl Fn(&[u8]) -> bool) {
    let folder = Folder::new(&format!("killed_{name}"));
    let path = folder.0.join(name);
    let mut seed = 20_220_715;
    let mut left = 0;
    for turn in 0..2 * times {
        std::fs::write(&path, OLD).expect("it can be written");
        let mut asked = program(arguments);
        let mut child = asked.arg(&path).stdout(Stdio::piped()).stderr(Stdio::null()).spawn().expect("it starts");
        let pause = Duration::from_micros((1e3 * within * drawn(&mut seed)) as u64);
        if turn % 2 == 0 {
            std::thread::sleep(pause);
        } else {
            while !folder.is_written(OLD, name) && !ends(&mut child) {}
            std::thread::sleep(pause / 20);
        }
        child.kill().expect("it can be killed");
        let told = child.wait_with_output().expect("it ended").stdout;
        let found = std::fs::read(&path).expect("a file is there at all times");
        assert!(found == OLD.as_bytes() || whole(&found), "{arguments:?}, killed after {pause:?}: torn");
        let announced = String::from_utf8_lossy(&told).contains(&*path.to_string_lossy());
        assert!(!announced || whole(&found), "{arguments:?}, killed after {pause:?}: told, and not there");
        left += usize::from(found == OLD.as_bytes());
        for entry in std::fs::read_dir(&folder.0).expect("it is there") {
            std::fs::remove_file(entry.expect("it can be read").path()).expect("it is a file");
        }
    }
    assert!(left > 0, "{arguments:?} was never killed in time");
}

/// A test whether a picture or page ends with `end` and its hash.
fn is_sealed(end: &str) -> impl Fn(&[u8]) -> bool {
    let before = format!("{end}\n<!-- sha256 of the lines above: ");
    move |found| {
        let text = String::from_utf8_lossy(found);
        let last = text.split_once(&before).map(|(_, last)| last);
        last.is_some_and(|last| last.len() == 64 + " -->\n".len() && last.ends_with(" -->\n"))
    }
}

/// The file that the program writes if it is not killed. It is computed here, since its last digits may depend on the processor.
fn undisturbed(arguments: &[&str], name: &str) -> Vec<u8> {
    let path = temporary(name);
    assert!(run(&[arguments, &[&path.to_string_lossy()]].concat()).status.success());
    let written = std::fs::read(&path).expect("it was written");
    std::fs::remove_file(&path).expect("it is there");
    written
}

#[test]
fn a_table_is_whole_whenever_its_run_is_killed() {
    let arguments = ["run", "scenes/bench.toml", "--samples", "50000", "--force", "--out"];
    let table = undisturbed(&arguments, "whole.csv");
    kill(&arguments, "table.csv", (4, 400.0), |found| found == table);
}

#[test]
fn pages_pictures_and_references_are_whole_whenever_their_program_is_killed() {
    let scene = "scenes/closed_forms/unloaded_motor.toml";
    kill(&["chart", scene, "--seconds", "1", "--force", "--out"], "page.html", (2, 400.0), is_sealed("</html>"));
    kill(&["choose", scene, "--seconds", "1", "--force", "--out"], "models.svg", (4, 20.0), is_sealed("</svg>"));
    let arguments = ["reference", scene, "--force", "--out"];
    let reference = undisturbed(&arguments, "whole.reference");
    kill(&arguments, "again.reference", (4, 10.0), |found| found == reference);
}

/// Sends Ctrl-C to the command with `--out` as soon as the program handles the signal.
#[cfg(target_os = "linux")]
fn interrupted(arguments: &[&str], out: &Path) -> Output {
    interrupt(program(arguments).arg("--out").arg(out))
}

/// Starts a program, and sends Ctrl-C as soon as the program handles the signal.
#[cfg(target_os = "linux")]
pub fn interrupt(asked: &mut Command) -> Output {
    const SIGINT: u64 = 1 << 1;
    let mut child = asked.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts");
    let listens = |child: &Child| {
        let status = std::fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap_or_default();
        let caught = status.lines().find_map(|line| line.strip_prefix("SigCgt:"));
        caught.and_then(|caught| u64::from_str_radix(caught.trim(), 16).ok()).is_some_and(|caught| caught & SIGINT != 0)
    };
    while !listens(&child) && !ends(&mut child) {}
    let sent = Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(sent.is_ok_and(|sent| sent.success()), "it was not running any more");
    child.wait_with_output().expect("it ends")
}

#[cfg(target_os = "linux")]
#[test]
fn a_run_that_is_interrupted_keeps_what_there_is() {
    let path = temporary("interrupted.csv");
    let arguments = ["run", "scenes/bench.toml", "--method", "runge_kutta_4:10000000", "--samples", "100000"];
    let output = interrupted(&arguments, &path);
    let told = String::from_utf8_lossy(&output.stdout);
    let table = crate::table_at(&path);
    std::fs::remove_file(&path).expect("it is there");
    assert_eq!(output.status.code(), Some(130), "{told}");
    assert!(told.contains("stopped              interrupted; the last good state is at t = "), "{told}");
    let columns = table.lines().next().map_or(0, |line| line.split(',').count());
    assert!(columns > 3 && table.ends_with('\n') && table.lines().count() < 100_000);
    assert!(table.lines().all(|line| line.split(',').count() == columns));
}

#[cfg(target_os = "linux")]
#[test]
fn an_ensemble_that_is_interrupted_says_where_it_goes_on() {
    let path = temporary("interrupted_ensemble.csv");
    let output = interrupted(&["ensemble", "scenes/ensembles/spread.toml", "--threads", "1"], &path);
    let told = String::from_utf8_lossy(&output.stdout);
    let table = std::fs::read_to_string(&path).expect("it was written");
    std::fs::remove_file(&path).expect("it is there");
    assert_eq!(output.status.code(), Some(130), "{told}");
    let next = format!("the same command continues with member {}\n", table.lines().count());
    assert!(told.ends_with(&next) && table.ends_with('\n'), "{told}");
}

/// Members that run alone, since their law changes at a condition, and longer than Ctrl-C takes.
#[cfg(target_os = "linux")]
const LONG_MEMBERS: &str = "title = \"A spring that is harder on one side\"\n[parameters]\nk = \"1 N/m\"\n[coordinates]\nx = \"m\"\n\
    [energies]\nkinetic = \"(1 kg)*x'^2/2\"\npotential = \"k*x^2/2 + if(x > (0 m), k, 0)*x^2\"\n[start]\nx = \"1 m\"\n[run]\nspan = \"10000 s\"\n\
    [ensemble]\nmembers = 3\n[ensemble.vary]\nparameters.k = { from = \"1 N/m\", to = \"2 N/m\" }\n";

#[cfg(target_os = "linux")]
#[test]
fn a_member_that_is_interrupted_has_no_row() {
    let (scene, path) = (temporary("long_members.toml"), temporary("long_members.csv"));
    std::fs::write(&scene, LONG_MEMBERS).expect("it is written");
    let output = interrupted(&["ensemble", &scene.display().to_string()], &path);
    let told = String::from_utf8_lossy(&output.stdout);
    let table = std::fs::read_to_string(&path).expect("it was written");
    for path in [&scene, &path] {
        std::fs::remove_file(path).expect("it is there");
    }
    assert_eq!(output.status.code(), Some(130), "{told}");
    assert_eq!(table.lines().count(), 1, "{table}");
    assert!(told.ends_with("the same command continues with member 1\n"), "{told}");
}
