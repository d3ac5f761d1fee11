use super::{Form, Writes, apart, each_row};
use std::fs;
use std::path::{Path, PathBuf};

/// A temporary folder with a scene and a table of another program.
struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Self {
        let folder = Folder(tempfile::tempdir().expect("a folder can be made"));
        fs::write(folder.at("scene.toml"), "a scene").expect("it can be written");
        fs::write(folder.at("others.csv"), "time,x\n0,1\n").expect("it can be written");
        folder
    }

    fn at(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn read(&self, name: &str) -> String {
        fs::read_to_string(self.at(name)).expect("it is there")
    }
}

fn table() -> [Form; 1] {
    [Form::Table("time [s],x [m]".to_owned())]
}

fn writes(reads: &Path, force: bool) -> Writes<'_> {
    Writes { command: "run", force, reads: vec![reads] }
}

/// Writes a table, or returns the reason for a refusal.
fn write(writes: &Writes<'_>, path: &Path) -> Result<(), String> {
    let said = |ending| format!("{ending:?}");
    let output = writes.output(path, &table()).map_err(said)?;
    output.write_text("# made by: dalembert run, version 9\ntime [s],x [m]\n0,2\n").map(drop).map_err(said)
}

#[test]
fn a_table_of_our_own_is_replaced_and_that_of_another_only_by_force() {
    let folder = Folder::new();
    let scene = folder.at("scene.toml");
    for _ in 0..2 {
        assert_eq!(write(&writes(&scene, false), &folder.at("own.csv")), Ok(()));
    }
    let refused = write(&writes(&scene, false), &folder.at("others.csv")).expect_err("it is another's");
    assert!(refused.contains("is no table of `dalembert run`") && refused.contains("--force"), "{refused}");
    assert_eq!(folder.read("others.csv"), "time,x\n0,1\n");
    assert_eq!(write(&writes(&scene, true), &folder.at("others.csv")), Ok(()));
    assert_eq!(folder.read("others.csv"), folder.read("own.csv"));
}

#[test]
fn a_file_that_was_edited_or_lost_its_seal_is_replaced_by_force_alone() {
    let folder = Folder::new();
    let scene = folder.at("scene.toml");
    let page = "<meta name=\"generator\" content=\"dalembert run, version 9\">\n<p>old</p>\n";
    let reference = "# Reference of x: so\n# Made by: dalembert run x, version 9\ndigits = 20 # old\n";
    for (name, form, content) in [
        ("a.csv", table()[0].clone(), "# made by: dalembert run, version 9\ntime [s],x [m]\n0,\"old\"\n"),
        ("a.html", Form::Page, page),
        ("a.reference", Form::Reference, reference),
        // the seal closes this object
        ("a.json", Form::Certificates, "{\"made_by\":\"dalembert run, version 9\",\"x\":\"old\""),
    ] {
        let (path, forms) = (folder.at(name), [form]);
        let write = |force: bool| {
            let said = |ending| format!("{ending:?}");
            let output = writes(&scene, force).output(&path, &forms).map_err(said)?;
            output.write_text(content).map(drop).map_err(said)
        };
        assert_eq!((write(false), write(false)), (Ok(()), Ok(())), "{name}");
        let made = folder.read(name);
        for edited in [made.replace("old", "new"), format!("{made}\n"), made.trim_end().to_owned()] {
            fs::write(&path, &edited).expect("it can be written");
            let refused = write(false).expect_err(name);
            assert!(refused.contains("it was edited since") && refused.contains("--force"), "{refused}");
            assert_eq!(folder.read(name), edited);
        }
        assert_eq!((write(true), folder.read(name)), (Ok(()), made), "{name}");
        fs::write(&path, content).expect("it can be written");
        let refused = write(false).expect_err(name);
        assert!(refused.contains("it was edited, or written by an earlier version"), "{refused}");
        assert_eq!(folder.read(name), content);
    }
}

#[test]
fn a_reference_of_an_earlier_version_needs_no_seal() {
    let folder = Folder::new();
    let (scene, path) = (folder.at("scene.toml"), folder.at("a.reference"));
    fs::write(&path, "# Reference of x: so\n# Made by: dalembert run x\ndigits = 20\n").expect("it can be written");
    let output = writes(&scene, false).output(&path, &[Form::Reference]).expect("it is our own");
    assert!(output.write_text("digits = 21\n").is_ok() && folder.read("a.reference").starts_with("digits = 21\n"));
}

#[test]
fn the_table_of_an_ensemble_is_our_own_if_every_row_ends_with_its_hash() {
    let folder = Folder::new();
    let (scene, path) = (folder.at("scene.toml"), folder.at("ensemble.csv"));
    let heading = "member,x,row_sha256";
    let admitted = |rows: &str| {
        fs::write(&path, format!("{heading}\n{rows}")).expect("it can be written");
        writes(&scene, false).output(&path, &[Form::Rows(heading.to_owned())]).is_ok()
    };
    let row = each_row::sealed("1,0.5");
    assert!(admitted("") && admitted(&format!("{row}\n")) && !admitted(&format!("{row}\n2,0.")));
    assert!(!admitted(&format!("{}\n", row.replace("0.5", "0.6"))) && !admitted("1,0.5\n"));
}

#[test]
fn what_is_read_is_never_written_by_any_name() {
    let folder = Folder::new();
    let read = folder.at("read.csv");
    fs::write(&read, "time [s],x [m]\n").expect("it can be written");
    fs::hard_link(&read, folder.at("hard.csv")).expect("links can be made");
    let names = ["read.csv", "hard.csv", "./read.csv"].map(|name| folder.at(name));
    for name in names {
        for force in [false, true] {
            let refused = write(&writes(&read, force), &name).expect_err("it is read");
            assert!(refused.contains("reads this file"), "{}: {refused}", name.display());
        }
    }
    assert_eq!(folder.read("read.csv"), "time [s],x [m]\n");
}

#[test]
fn the_end_of_a_name_must_be_that_of_a_form() {
    let folder = Folder::new();
    let scene = folder.at("scene.toml");
    for name in ["table.png", "table", "table.svg", ".csv", "table.csv.bak"] {
        let refused = write(&writes(&scene, true), &folder.at(name)).expect_err(name);
        assert!(refused.contains("writes .csv files only"), "{name}: {refused}");
    }
    let forms = [Form::Picture, Form::Page];
    for (name, form) in [("a.svg", Form::Picture), ("a.HTML", Form::Page), ("a.htm", Form::Page)] {
        let output = writes(&scene, false).output(&folder.at(name), &forms).expect(name);
        assert_eq!(*output.form(), form);
    }
}

#[test]
fn folders_are_made_when_a_file_is_written() {
    let folder = Folder::new();
    let (scene, path) = (folder.at("scene.toml"), folder.at("no/such/folder/table.csv"));
    let output = writes(&scene, false).output(&path, &table()).expect("it is accepted");
    assert!(!folder.at("no").exists());
    assert!(output.write_text("").is_ok() && path.exists());
}

#[test]
fn a_file_that_came_meanwhile_is_left_alone_and_the_work_is_kept() {
    let folder = Folder::new();
    let (scene, path) = (folder.at("scene.toml"), folder.at("table.csv"));
    let output = writes(&scene, false).output(&path, &table()).expect("it is accepted");
    fs::write(&path, "another's").expect("it can be written");
    let refused = output.write_text("mine").err().map(|ending| format!("{ending:?}")).unwrap_or_default();
    assert!(refused.contains("was created meanwhile"), "{refused}");
    assert_eq!(folder.read("table.csv"), "another's");
    let kept = fs::read_dir(folder.0.path()).expect("it is there").filter_map(|entry| Some(entry.ok()?.path()));
    let kept: Vec<PathBuf> = kept.filter(|path| path.extension().is_some_and(|end| end == "part")).collect();
    assert_eq!(kept.len(), 1);
    assert_eq!(fs::read(&kept[0]).expect("it is there"), b"mine");
}

#[test]
fn two_outputs_are_two_files() {
    let folder = Folder::new();
    let scene = folder.at("scene.toml");
    let output = |name: &str| writes(&scene, false).output(&folder.at(name), &table()).expect("it is accepted");
    let (one, same, other) = (output("a.csv"), output("./a.csv"), output("b.csv"));
    assert!(apart(Some(&one), Some(&same)).is_err() && apart(Some(&one), Some(&other)).is_ok());
    assert!(apart(Some(&one), None).is_ok());
}

#[test]
fn pictures_pages_and_references_are_known_by_their_marks() {
    let folder = Folder::new();
    let scene = folder.at("scene.toml");
    let mark = "<meta name=\"generator\" content=\"dalembert run, version 9\">";
    let reference = "# Reference of x: so\n# Made by: dalembert run x\n";
    for (name, form, own) in [
        ("a.svg", Form::Picture, "<svg></svg>"),
        ("a.html", Form::Page, mark),
        ("a.reference", Form::Reference, reference),
    ] {
        let (path, forms) = (folder.at(name), [form]);
        let write = |command: &'static str| {
            let writes = Writes { command, force: false, reads: vec![&scene] };
            writes.output(&path, &forms).and_then(|output| output.write_text(own)).is_ok()
        };
        assert!(write("run") && write("run") && !write("chart"), "{name}");
        fs::write(&path, format!("not ours {own}").replace("dalembert", "another")).expect("it can be written");
        assert!(!write("run"), "{name}");
    }
}

#[cfg(unix)]
#[test]
fn links_are_followed_and_stay() {
    use std::os::unix::fs::symlink;
    let folder = Folder::new();
    let scene = folder.at("scene.toml");
    symlink(&scene, folder.at("to_scene.csv")).expect("links can be made");
    assert!(write(&writes(&scene, true), &folder.at("to_scene.csv")).is_err());
    assert_eq!(folder.read("scene.toml"), "a scene");
    symlink(folder.at("nothing.csv"), folder.at("to_nothing.csv")).expect("links can be made");
    assert!(write(&writes(&scene, true), &folder.at("to_nothing.csv")).is_err());
    write(&writes(&scene, false), &folder.at("own.csv")).expect("it can be written");
    symlink(folder.at("own.csv"), folder.at("link.csv")).expect("links can be made");
    let older = writes(&scene, false).output(&folder.at("own.csv"), &table()).expect("it is our own");
    assert!(older.write_text("# made by: dalembert run, version 8\ntime [s],x [m]\nold\n").is_ok());
    write(&writes(&scene, false), &folder.at("link.csv")).expect("it is our own");
    assert!(fs::symlink_metadata(folder.at("link.csv")).expect("it is there").is_symlink());
    assert!(folder.read("own.csv").ends_with("0,2\n"));
}

#[cfg(unix)]
#[test]
fn a_device_is_written_to_and_a_pipe_that_nobody_reads_is_refused() {
    let folder = Folder::new();
    let scene = folder.at("scene.toml");
    assert_eq!(write(&writes(&scene, false), Path::new("/dev/null")), Ok(()));
    assert!(!fs::metadata("/dev/null").expect("it is there").is_file());
    let pipe = folder.at("pipe");
    let made = std::process::Command::new("mkfifo").arg(&pipe).status();
    if !made.is_ok_and(|made| made.success()) {
        return eprintln!("skipped: there is no `mkfifo` on this machine");
    }
    let refused = write(&writes(&scene, false), &pipe).expect_err("nobody reads");
    assert!(refused.contains("nobody reads"), "{refused}");
    let reader = std::thread::spawn({
        let pipe = pipe.clone();
        move || fs::read_to_string(pipe)
    });
    assert_eq!(write(&writes(&scene, false), &pipe), Ok(()));
    let read = reader.join().expect("it ends").expect("it can be read");
    assert_eq!(read, "# made by: dalembert run, version 9\ntime [s],x [m]\n0,2\n");
    let refused = writes(&scene, false).continued(&pipe);
    assert!(refused.is_err());
}
