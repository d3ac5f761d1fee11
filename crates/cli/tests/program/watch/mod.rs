//! The page of `watch`: its content, and the requests that its server answers.

mod browser;
mod page;
mod requests;

use crate::program;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Stdio};
use std::time::Duration;
use tempfile::TempDir;

/// The time limit for each event, longer than any takes on a busy machine.
const PATIENCE: Duration = Duration::from_secs(60);

const PENDULUM: &str = r#"title = "A <pendulum>"
gravity = "-g*N.y"
parameters = { m = "1 kg", l = "0.5 m", g = "9.81 m/s^2" }
coordinates = { theta = "rad" }
frames = { A = "N turned theta about z" }
bodies = { bob = { centre = "O - l*A.y", mass = "m" } }
start = { theta = "40 deg" }
run = { span = "1 s", samples = 50 }
"#;

/// A running `watch` with its file in a folder of this test.
struct Watched {
    child: Child,
    folder: TempDir,
    file: PathBuf,
    port: u16,
    /// The root of all paths, `/KEY/`.
    root: String,
}

impl Watched {
    fn of(name: &str, text: &str) -> Self {
        let folder = tempfile::tempdir().expect("a folder can be made");
        let file = folder.path().join(name);
        std::fs::write(&file, text).expect("it can be written");
        Watched::in_folder(folder, file)
    }

    fn in_folder(folder: TempDir, file: PathBuf) -> Self {
        let mut asked = program(&["watch"]);
        let mut child = asked.arg(&file).stdout(Stdio::piped()).spawn().expect("it starts");
        let mut line = String::new();
        BufReader::new(child.stdout.take().expect("it is piped")).read_line(&mut line).expect("it tells its address");
        let address = line.trim().strip_prefix("http://127.0.0.1:").unwrap_or_else(|| panic!("no address: {line}"));
        let (port, path) = address.split_once('/').expect("a path follows the port");
        let (port, root) = (port.parse().expect("a port is a number"), format!("/{path}"));
        Watched { child, folder, file, port, root }
    }

    fn save(&self, text: &str) {
        std::fs::write(&self.file, text).expect("it can be written");
    }

    fn connected(&self) -> TcpStream {
        let stream = TcpStream::connect(("127.0.0.1", self.port)).expect("it listens");
        stream.set_read_timeout(Some(PATIENCE)).expect("it can be set");
        stream
    }

    /// Sends a request and returns status and text of the answer. The head has no `Content-Length` line, which is added.
    fn ask(&self, head: &str, body: &str) -> (u16, String) {
        let mut stream = self.connected();
        let whole = format!("{head}Content-Length: {}\r\n\r\n{body}", body.len());
        stream.write_all(whole.as_bytes()).expect("it is read");
        answer(stream)
    }

    /// Sends a GET request for a path below the key.
    fn get(&self, path: &str) -> (u16, String) {
        self.ask(&self.head("GET", path), "")
    }

    fn head(&self, method: &str, path: &str) -> String {
        format!("{method} {}{path} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\n", self.root, self.port)
    }

    /// Moves sliders to values, and returns the status.
    fn move_to(&self, values: &Value) -> u16 {
        self.ask(&self.head("POST", "values"), &values.to_string()).0
    }

    fn events(&self) -> Events {
        let mut stream = self.connected();
        let head = self.head("GET", "events?since=0") + "\r\n";
        stream.write_all(head.as_bytes()).expect("it is read");
        Events { lines: BufReader::new(stream), page: Page::default() }
    }
}

impl Drop for Watched {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn answer(mut stream: TcpStream) -> (u16, String) {
    let mut bytes = Vec::new();
    // a server that refuses a request may close the connection before all is sent
    let _ = stream.read_to_end(&mut bytes);
    let text = String::from_utf8_lossy(&bytes).into_owned();
    let status = text.split(' ').nth(1).and_then(|status| status.parse().ok()).unwrap_or(0);
    (status, text)
}

/// The state of the page in its script.
#[derive(Default)]
struct Page {
    parts: BTreeMap<String, Value>,
    values: Value,
}

impl Page {
    fn text(&self, part: &str, key: &str) -> &str {
        self.parts.get(part).and_then(|part| part[key].as_str()).unwrap_or_default()
    }

    fn content(&self, part: &str) -> &str {
        self.text(part, "content")
    }

    fn is(&self, part: &str, state: &str) -> bool {
        self.text(part, "state") == state
    }
}

/// The stream of events that updates a page.
struct Events {
    lines: BufReader<TcpStream>,
    page: Page,
}

impl Events {
    /// Reads events until the page satisfies a condition.
    fn until(&mut self, what: &str, is_so: impl Fn(&Page) -> bool) -> &Page {
        while !is_so(&self.page) {
            let told = self.next().unwrap_or_else(|| panic!("it ended before: {what}; {:#?}", self.page.parts));
            for part in told["parts"].as_array().into_iter().flatten() {
                let id = part["part"].as_str().expect("a part has a name").to_owned();
                let known = self.page.parts.entry(id).or_insert_with(|| json!({}));
                for (key, value) in part.as_object().expect("a part is an object") {
                    known[key] = value.clone();
                }
            }
            if let Some(values) = told.get("values") {
                self.page.values = values.clone();
            }
        }
        &self.page
    }

    /// The next event; `None` at the end of the stream.
    fn next(&mut self) -> Option<Value> {
        loop {
            let mut line = String::new();
            let count = self.lines.read_line(&mut line).expect("news comes in time");
            if count == 0 || line.starts_with("event: end") {
                return None;
            }
            if let Some(data) = line.strip_prefix("data: ") {
                return Some(serde_json::from_str(data).expect("news is JSON"));
            }
        }
    }
}

/// Whether the program can start itself, which an emulated processor prevents.
fn is_own_processor() -> bool {
    let is_own = std::env::var_os("DALEMBERT_RUNNER").is_none();
    if !is_own {
        eprintln!("skipped: the program cannot start itself on an emulated processor");
    }
    is_own
}

fn copied(folder: &Path, from: &str) -> PathBuf {
    let to = folder.join(Path::new(from).file_name().expect("a file has a name"));
    std::fs::copy(crate::root().join(from), &to).expect("it can be copied");
    to
}
