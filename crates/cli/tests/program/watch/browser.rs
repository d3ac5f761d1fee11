//! The page in a browser: the file is saved with an error and without one, a slider moves, and the page shows each state without errors.
//!
//! Chromium is controlled by its DevTools protocol over pipes: JSON messages, each ended by a zero byte.

use super::{PENDULUM, Watched, is_own_processor};
use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use tempfile::TempDir;

/// A browser with one page.
struct Browser {
    child: Child,
    /// The folder of its profile, deleted with this value.
    _folder: TempDir,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
    session: Value,
    count: u64,
    /// Errors of scripts and of the network, and violations of the page's security policy.
    complaints: Vec<String>,
}

impl Browser {
    /// Starts a browser; `None` if none is installed.
    fn start() -> Option<Self> {
        let names = ["chromium", "chromium-browser", "google-chrome"];
        let is_there = |name: &&str| Command::new(name).arg("--version").output().is_ok();
        let Some(name) = names.into_iter().find(is_there) else {
            eprintln!("skipped: there is no Chromium on this machine");
            return None;
        };
        let folder = tempfile::tempdir().expect("a folder can be made");
        // the DevTools protocol uses the file descriptors 3 and 4
        let line = format!(
            "exec {name} --headless --no-sandbox --disable-gpu --remote-debugging-pipe --window-size=1200,900 --user-data-dir='{}' \
             3<&0 4>&1 </dev/null >/dev/null 2>&1",
            folder.path().display()
        );
        let piped = Command::new("sh").args(["-c", &line]).stdin(Stdio::piped()).stdout(Stdio::piped()).spawn();
        let mut child = piped.expect("a shell starts");
        let (input, output) = (child.stdin.take().expect("it is piped"), child.stdout.take().expect("it is piped"));
        let (session, complaints) = (Value::Null, Vec::new());
        let mut browser =
            Browser { child, _folder: folder, input, output: BufReader::new(output), session, count: 0, complaints };
        let target = browser.ask("Target.createTarget", json!({ "url": "about:blank" }));
        let attached = browser.ask("Target.attachToTarget", json!({ "targetId": target["targetId"], "flatten": true }));
        browser.session = attached["sessionId"].clone();
        for domain in ["Runtime.enable", "Log.enable", "Page.enable"] {
            browser.ask(domain, json!({}));
        }
        Some(browser)
    }

    /// Sends a command and returns its result.
    fn ask(&mut self, method: &str, parameters: Value) -> Value {
        self.count += 1;
        let mut message = json!({ "id": self.count, "method": method, "params": parameters });
        if !self.session.is_null() {
            message["sessionId"] = self.session.clone();
        }
        write!(self.input, "{message}\0").and_then(|()| self.input.flush()).expect("the browser listens");
        loop {
            let mut bytes = Vec::new();
            self.output.read_until(0, &mut bytes).expect("the browser answers");
            bytes.pop();
            let told: Value = serde_json::from_slice(&bytes).expect("the browser answers in JSON");
            if told["id"] == self.count {
                assert!(told["error"].is_null(), "{method}: {told}");
                return told["result"].clone();
            }
            if matches!(
                told["method"].as_str(),
                Some("Runtime.consoleAPICalled" | "Runtime.exceptionThrown" | "Log.entryAdded")
            ) {
                self.complaints.push(told.to_string());
            }
        }
    }

    fn open(&mut self, address: &str) {
        self.ask("Page.navigate", json!({ "url": address }));
    }

    /// The value of an expression in the page.
    fn value(&mut self, expression: &str) -> Value {
        let asked = json!({ "expression": expression, "awaitPromise": true, "returnByValue": true });
        let told = self.ask("Runtime.evaluate", asked);
        assert!(told["exceptionDetails"].is_null(), "{expression}: {told}");
        told["result"]["value"].clone()
    }

    /// Waits until an expression is true in the page.
    fn until(&mut self, expression: &str) {
        const SECONDS: u32 = 60;
        let waited = format!(
            "new Promise((done) => {{ let left = {SECONDS} * 50; const look = () => ({expression}) ? done(true) : \
             --left ? setTimeout(look, 20) : done(document.body.innerText); look(); }})"
        );
        let found = self.value(&waited);
        assert_eq!(found, true, "{expression}");
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// A JavaScript condition: three parts of the page belong to the present text.
const DONE: &str =
    "['heading', 'motion', 'verdicts'].every((part) => document.getElementById(part)?.dataset.state === 'current')";

#[test]
fn a_browser_shows_a_text_its_fault_its_mending_and_a_slider_without_a_complaint() {
    if !is_own_processor() {
        return;
    }
    let Some(mut browser) = Browser::start() else { return };
    let watched = Watched::of("swing.toml", PENDULUM);
    let address = format!("http://127.0.0.1:{}{}", watched.port, watched.root);
    browser.open(&address);
    browser.until(DONE);
    assert_eq!(browser.value("document.title"), "A <pendulum>");
    assert_eq!(browser.value("document.querySelectorAll('#equations math').length > 3"), true);
    assert_eq!(browser.value("document.querySelectorAll('#motion svg').length"), 3);

    watched.save(&PENDULUM.replace("l*A.y", "ll*A.y"));
    browser.until("document.querySelector('#heading .fault').innerText.includes('swing.toml:6:')");
    let is_kept = "document.getElementById('motion').dataset.state === 'earlier' && document.querySelectorAll('#motion svg').length === 3";
    browser.until(is_kept);

    watched.save(&PENDULUM.replace("A <pendulum>", "Mended"));
    browser.until(&format!("document.title === 'Mended' && {DONE}"));
    assert_eq!(browser.value("document.querySelector('#heading .fault').innerText"), "");

    // a page that is opened later shows the sliders at their present values
    let reset = "document.querySelector('#values .reset')";
    assert_eq!(watched.move_to(&json!({ "parameters.l": 0.4 })), 200);
    browser.open(&address);
    let is_moved = "Number(document.querySelector('input[name=\"parameters.l\"]')?.value) === 0.4";
    browser.until(&format!("{is_moved} && !{reset}.disabled"));
    browser.value(&format!("{reset}.click()"));
    browser
        .until(&format!("{reset}.disabled && document.getElementById('lines').dataset.state === 'absent' && {DONE}"));

    browser.value("window.before = document.querySelector('#motion').innerHTML");
    let slide = "const slider = document.querySelector('input[name=\"parameters.l\"]'); slider.value = 0.25;
        slider.dispatchEvent(new Event('input', { bubbles: true })); slider.dispatchEvent(new Event('change', { bubbles: true }))";
    browser.value(slide);
    let changed = "document.querySelector('#motion').innerHTML !== before && document.getElementById('motion').dataset.state === 'current'";
    browser.until(&format!("{changed} && document.querySelector('#lines').innerText.includes('l = \"0.250 m\"')"));
    browser.value("document.querySelector('#values .reset').click()");
    browser.until("document.getElementById('lines').dataset.state === 'absent'");
    browser.until(
        "document.querySelector('#motion').innerHTML === before && document.querySelector('#values .reset').disabled",
    );
    assert_eq!(browser.complaints, Vec::<String>::new());
}

#[test]
fn a_saved_page_is_read_in_a_browser_without_a_complaint() {
    if !is_own_processor() {
        return;
    }
    let Some(mut browser) = Browser::start() else { return };
    let folder = tempfile::tempdir().expect("a folder can be made");
    let [scene, page] = ["swing.toml", "page.html"].map(|name| folder.path().join(name));
    std::fs::write(&scene, PENDULUM).expect("it can be written");
    let mut asked = crate::program(&["watch"]);
    let output = asked.arg(&scene).arg("--save").arg(&page).output().expect("it starts");
    assert!(output.status.success(), "{output:?}");
    browser.open(&format!("file://{}", page.display()));
    browser.until(&format!("document.readyState === 'complete' && {DONE}"));
    assert_eq!(browser.value("document.querySelector('#values fieldset').disabled"), true);
    assert_eq!(browser.complaints, Vec::<String>::new());
}
