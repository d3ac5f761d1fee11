//! Ensembles at the command line: killed, continued, refused.

use crate::{program, root};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::Duration;

fn ensemble(scene: &Path, out: &Path, more: &[&str]) -> Command {
    let mut command = program(&["ensemble"]);
    command.arg(scene).arg("--out").arg(out).args(more);
    command
}

fn run(scene: &Path, out: &Path, more: &[&str]) -> Output {
    ensemble(scene, out, more).output().expect("the program starts")
}

/// A folder of one test, deleted with this value.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("dalembert_ensemble_{}_{name}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder can be made");
        Folder(folder)
    }

    fn scene(&self, members: u32, change: [&str; 2]) -> PathBuf {
        let text = std::fs::read_to_string(root().join("scenes/ensembles/spread.toml")).expect("it is there");
        let text = text.replace("members = 10000", &format!("members = {members}")).replace(change[0], change[1]);
        let path = self.0.join(format!("scene{members}.toml"));
        std::fs::write(&path, text).expect("it can be written");
        path
    }

    fn read(&self, name: &str) -> String {
        std::fs::read_to_string(self.0.join(name)).expect("it was written")
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

const SAME: [&str; 2] = ["", ""];

/// A table with new hashes for its rows, as if another machine had written it.
fn sealed(table: &str) -> String {
    let row = |(number, line): (usize, &str)| {
        let Some((cells, _)) = line.rsplit_once(',').filter(|_| number > 0) else { return format!("{line}\n") };
        let hash = hmac_sha256::Hash::hash(cells.as_bytes());
        let digits: String = hash[..8].iter().map(|byte| format!("{byte:02x}")).collect();
        format!("{cells},{digits}\n")
    };
    table.lines().enumerate().map(row).collect()
}

#[test]
fn a_run_killed_again_and_again_ends_with_the_same_table() {
    let folder = Folder::new("killed");
    let scene = folder.scene(1200, SAME);
    let whole = run(&scene, &folder.0.join("whole.csv"), &["--threads", "1"]);
    assert!(whole.status.success(), "{}", String::from_utf8_lossy(&whole.stderr));
    let path = folder.0.join("killed.csv");
    let mut sizes = Vec::new();
    for pause in [30, 55, 80, 20, 130, 47, 99] {
        let mut child = ensemble(&scene, &path, &[]).stdout(Stdio::null()).spawn().expect("the program starts");
        std::thread::sleep(Duration::from_millis(pause));
        child.kill().and_then(|()| child.wait()).expect("it can be killed");
        let size = std::fs::metadata(&path).map_or(0, |data| data.len());
        // a row cut in the middle, as after a power failure
        if let Ok(file) = std::fs::OpenOptions::new().write(true).open(&path) {
            file.set_len(size - size.min(7)).expect("it can be cut");
        }
        sizes.push(size);
    }
    let last = run(&scene, &path, &[]);
    assert!(last.status.success(), "{}", String::from_utf8_lossy(&last.stderr));
    assert!(folder.read("killed.csv") == folder.read("whole.csv"), "{sizes:?}");
    assert_eq!(folder.read("whole.csv").lines().count(), 1201);
    // a finished table is unchanged, and more members are added to it
    let again = run(&scene, &path, &[]);
    assert!(String::from_utf8_lossy(&again.stdout).contains("the first 1200 were there already"));
    assert!(run(&folder.scene(1250, SAME), &path, &[]).status.success());
    assert!(folder.read("killed.csv").starts_with(&folder.read("whole.csv")));
    assert_eq!(folder.read("killed.csv").lines().count(), 1251);
}

#[test]
fn a_table_of_something_else_is_refused_and_left_alone() {
    let folder = Folder::new("foreign");
    let path = folder.0.join("table.csv");
    assert!(run(&folder.scene(20, SAME), &path, &[]).status.success());
    let before = folder.read("table.csv");
    let others = [
        (["seed = 1", "seed = 2"], "line 2: another ensemble: its law, data, span, tolerance or seed differ"),
        (["r1 = \"1.2 ohm\"", "r1 = \"1.3 ohm\""], "line 2: another ensemble"),
        (["span = \"0.5 s\"", "span = \"0.25 s\""], "line 2: another ensemble"),
        (["tolerance = 1e-9", "tolerance = 1e-8"], "line 2: another ensemble"),
        (["machine.r2", "machine.r1"], "line 1: these are not the columns of this ensemble's table"),
    ];
    for (change, message) in others {
        let output = run(&folder.scene(20, change), &path, &[]);
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.code() == Some(2) && said.contains(message), "{said}");
        assert_eq!(folder.read("table.csv"), before);
    }
    let output = run(&folder.scene(19, SAME), &path, &[]);
    assert!(String::from_utf8_lossy(&output.stderr).contains("there are more than the 19 members"));
    // `--force` starts the ensemble again
    let seed = folder.scene(21, ["seed = 1", "seed = 2"]);
    assert!(run(&seed, &path, &["--force"]).status.success());
    assert!(folder.read("table.csv") != before && folder.read("table.csv").lines().count() == 22);
}

/// Both ensembles draw the same data and start no member: no computed result distinguishes them.
#[test]
fn a_table_whose_last_member_never_started_is_told_from_that_of_another_scene() {
    let folder = Folder::new("unstarted");
    let path = folder.0.join("table.csv");
    let none = |members, span: &str| {
        let change = [
            "rotor.axial = { mean = \"2.4e-4 kg m^2\", deviation = \"0.2e-4 kg m^2\" }",
            "carrier.mass = { from = \"-2 kg\", to = \"-1 kg\" }",
        ];
        let scene = folder.scene(members, change);
        let text = std::fs::read_to_string(&scene).expect("it is there");
        std::fs::write(&scene, text.replace("span = \"0.5 s\"", span)).expect("it can be written");
        scene
    };
    let first = run(&none(5, "span = \"0.5 s\""), &path, &[]);
    assert!(String::from_utf8_lossy(&first.stdout).contains("0 reached the end, 5 did not"), "{first:?}");
    // the exit code of a run that stops
    assert_eq!(first.status.code(), Some(1));
    let before = folder.read("table.csv");
    let columns = before.lines().next().map_or(0, |line| line.split(',').count());
    assert!(before.lines().all(|line| line.contains('"') || line.split(',').count() == columns), "{before}");
    let other = run(&none(8, "span = \"0.25 s\""), &path, &[]);
    let said = String::from_utf8_lossy(&other.stderr);
    assert!(other.status.code() == Some(2) && said.contains("line 2: another ensemble"), "{said}");
    assert_eq!(folder.read("table.csv"), before);
    assert!(run(&none(8, "span = \"0.5 s\""), &path, &["--threads", "3"]).status.code() == Some(1));
    assert!(folder.read("table.csv").starts_with(&before));
}

/// The table of part `number` of 3.
fn part(folder: &Folder, scene: &Path, number: u32) -> PathBuf {
    let path = folder.0.join(format!("part{number}.csv"));
    let output = run(scene, &path, &["--part", &format!("{number}/3")]);
    assert!(output.status.success(), "{output:?}");
    path
}

/// Runs the command with a flag and tables: its exit code and its output.
fn of_tables(scene: &Path, flag: &str, tables: &[&PathBuf], more: &[&str]) -> (Option<i32>, String) {
    let output = program(&["ensemble"]).arg(scene).arg(flag).args(tables).args(more).output().expect("it starts");
    let told = [output.stdout, output.stderr].map(|said| String::from_utf8_lossy(&said).into_owned());
    (output.status.code(), told.concat())
}

#[test]
fn parts_are_joined_to_the_table_of_one_run_whatever_was_killed() {
    let folder = Folder::new("parts");
    let scene = folder.scene(20, SAME);
    assert!(run(&scene, &folder.0.join("whole.csv"), &[]).status.success());
    let parts: Vec<PathBuf> = (1..=3).map(|number| part(&folder, &scene, number)).collect();
    let [first, second, third] = &parts[..] else { panic!("three") };
    assert_eq!(of_tables(&scene, "--missing", &[first, second, third], &[]), (Some(0), String::new()));
    assert_eq!(of_tables(&scene, "--missing", &[third, first], &[]), (Some(1), "7-13\n".to_owned()));
    // a row that was cut counts as missing
    let text = std::fs::read_to_string(second).expect("it is there");
    std::fs::write(second, &text[..text.len() - 4]).expect("it can be written");
    assert_eq!(of_tables(&scene, "--missing", &[first, second, third], &[]), (Some(1), "13\n".to_owned()));
    let joined = folder.0.join("joined.csv");
    let out = ["--out", joined.to_str().expect("a name")];
    let (code, said) = of_tables(&scene, "--merge", &[first, second, third], &out);
    assert!(code == Some(2) && said.contains("no table has member 13") && !joined.exists(), "{said}");
    part(&folder, &scene, 2);
    // in any order, and with one table twice
    let (code, said) = of_tables(&scene, "--merge", &[third, second, first, second], &out);
    assert!(code == Some(0) && said.starts_with("20 members: 20 reached the end"), "{said}");
    assert_eq!(folder.read("joined.csv"), folder.read("whole.csv"));
    assert!(run(&scene, &joined, &[]).status.success(), "it is a table like any other");
    // an edited row is not overwritten
    let whole = folder.read("joined.csv");
    let edited = whole.replacen(",0.", ",0.9", 3);
    std::fs::write(&joined, &edited).expect("it can be written");
    let (code, said) = of_tables(&scene, "--merge", &[first, second, third], &out);
    assert!(code == Some(2) && said.contains("it was edited since") && folder.read("joined.csv") == edited, "{said}");
    // the table of a run with more members is not overwritten
    let more = folder.scene(21, SAME);
    std::fs::remove_file(&joined).expect("it is there");
    assert!(run(&more, &joined, &[]).status.success());
    let longer = folder.read("joined.csv");
    let (code, said) = of_tables(&scene, "--merge", &[first, second, third], &out);
    assert!(code == Some(2) && said.contains("would be lost") && folder.read("joined.csv") == longer, "{said}");
    assert_eq!(of_tables(&scene, "--merge", &[first, second, third], &[&out[..], &["--force"]].concat()).0, Some(0));
    assert_eq!(of_tables(&scene, "--merge", &[first, second, third], &out).0, Some(0));
    assert_eq!(folder.read("joined.csv"), whole);
}

#[test]
fn tables_that_do_not_belong_together_are_not_joined() {
    let folder = Folder::new("unlike");
    let scene = folder.scene(9, SAME);
    let parts: Vec<PathBuf> = (1..=3).map(|number| part(&folder, &scene, number)).collect();
    let [first, second, third] = &parts[..] else { panic!("three") };
    let joined = folder.0.join("joined.csv");
    let out = ["--out", joined.to_str().expect("a name")];
    let refused = |tables: &[&PathBuf], why: &str| {
        let (code, said) = of_tables(&scene, "--merge", tables, &out);
        assert!(code == Some(2) && said.contains(why) && !joined.exists(), "{said}");
    };
    let text = std::fs::read_to_string(second).expect("it is there");
    let write = |text: &str| std::fs::write(second, text).expect("it can be written");
    // a changed digit in the middle of a row
    write(&text.replacen(",0.", ",0.9", 1));
    refused(&[first, second, third], "line 2");
    let end = text.lines().nth(1).and_then(|row| row.split(',').rev().nth(2)).expect("a row has cells");
    write(&text.replacen(&format!(",{end},"), &format!(",9{end},"), 1));
    refused(&[first, second, third], "line 2: this row was edited since it was written");
    write(&sealed(&text.replace("-fused", "-other").replace("-unfused", "-other")));
    refused(&[first, second, third], "whose last digits may differ");
    assert_eq!(of_tables(&scene, "--missing", &[first, second, third], &["--any-processor"]).0, Some(0));
    assert_eq!(
        of_tables(&scene, "--merge", &[first, second, third], &[&out[..], &["--any-processor"]].concat()).0,
        Some(0)
    );
    std::fs::remove_file(&joined).expect("it was written");
    write(&text);
    // the output is one of the tables that are read
    let own = ["--out", first.to_str().expect("a name"), "--force"];
    let (code, said) = of_tables(&scene, "--merge", &[first, second, third], &own);
    assert!(code == Some(2) && said.contains("reads this file"), "{said}");
    let lost = folder.0.join("lost.csv");
    refused(&[first, second, &lost], "lost.csv");
    let seed = folder.scene(10, ["seed = 1", "seed = 2"]);
    let (code, said) = of_tables(&seed, "--missing", &[first], &[]);
    assert!(code == Some(2) && said.contains("line 2: another ensemble"), "{said}");
}

#[test]
fn a_table_with_an_edited_row_is_neither_continued_nor_replaced() {
    let folder = Folder::new("edited");
    let (scene, path) = (folder.scene(5, SAME), folder.0.join("table.csv"));
    assert!(run(&scene, &path, &[]).status.success());
    let table = folder.read("table.csv");
    let row = table.lines().nth(3).expect("it has rows");
    let state = row.split(',').rev().nth(2).expect("a row has cells");
    let edited = table.replace(row, &row.replace(&format!(",{state},"), ",0.125,"));
    std::fs::write(&path, &edited).expect("it can be written");
    for scene in [&scene, &folder.scene(6, SAME)] {
        let output = run(scene, &path, &[]);
        let said = String::from_utf8_lossy(&output.stderr);
        let why = "line 4: this row was edited since it was written";
        assert!(output.status.code() == Some(2) && said.contains(why) && folder.read("table.csv") == edited, "{said}");
    }
    // a note at the end is not the incomplete row of a killed run
    let noted = format!("{table}checked by hand");
    std::fs::write(&path, &noted).expect("it can be written");
    let output = run(&folder.scene(6, SAME), &path, &[]);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(said.contains("line 7: this incomplete line") && folder.read("table.csv") == noted, "{said}");
    assert!(run(&scene, &path, &["--force"]).status.success() && folder.read("table.csv") == table);
}

#[test]
fn a_part_goes_on_in_its_own_table_alone() {
    let folder = Folder::new("part");
    let scene = folder.scene(9, SAME);
    let second = part(&folder, &scene, 2);
    let output = run(&scene, &second, &["--part", "1/3"]);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.code() == Some(2) && said.contains("line 2: member 4 belongs to another part"), "{said}");
    let output = run(&scene, &second, &[]);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(said.contains("line 2: member 4 stands in the place of member 1"), "{said}");
    for (wrong, why) in [("4/3", "a part and the number of all parts"), ("1/10", "the ensemble has 9 members")] {
        let output = run(&scene, &folder.0.join("wrong.csv"), &["--part", wrong]);
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(
            output.status.code() == Some(2) && said.contains(why) && !folder.0.join("wrong.csv").exists(),
            "{said}"
        );
    }
    let output = run(&scene, &folder.0.join("wrong.csv"), &["--any-processor"]);
    assert!(
        String::from_utf8_lossy(&output.stderr).contains("--any-processor is for --merge and --missing"),
        "{output:?}"
    );
}

#[test]
fn rows_that_another_processor_rounded_are_told_apart() {
    let folder = Folder::new("rounded");
    let path = folder.0.join("table.csv");
    let scene = folder.scene(3, SAME);
    assert!(run(&scene, &path, &[]).status.success());
    let table = folder.read("table.csv");
    let other = if table.contains("-unfused,") { ["-unfused,", "-fused,"] } else { ["-fused,", "-unfused,"] };
    std::fs::write(&path, sealed(&table.replace(other[0], other[1]))).expect("it can be written");
    let output = run(&scene, &path, &[]);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.code() == Some(2) && said.contains("whose last digits may differ"), "{said}");
}

#[cfg(unix)]
#[test]
fn a_table_that_is_deleted_or_replaced_while_it_is_written_is_an_error() {
    let folder = Folder::new("deleted");
    let scene = folder.scene(1_000_000, SAME);
    for replaced in [false, true] {
        let path = folder.0.join(format!("table{replaced}.csv"));
        let mut child = ensemble(&scene, &path, &[]);
        let child = child.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().expect("the program starts");
        while !path.exists() {}
        std::fs::remove_file(&path).expect("it is there");
        if replaced {
            std::fs::write(&path, "another's").expect("it can be written");
        }
        let output = child.wait_with_output().expect("it ends");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.code() == Some(2) && said.contains("was deleted, replaced or changed"), "{said}");
        assert_eq!(path.exists(), replaced);
    }
}

#[cfg(unix)]
#[test]
fn a_pipe_or_a_device_is_no_table_to_continue() {
    let folder = Folder::new("pipe");
    let output = run(&folder.scene(3, SAME), Path::new("/dev/null"), &[]);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.code() == Some(2) && said.contains("a file is accepted"), "{said}");
}
