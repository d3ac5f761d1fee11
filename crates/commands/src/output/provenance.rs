//! The origin of a result: the program, the scene with its hash, the method and the tolerance, so that the result can be reproduced.

use super::Maker;
use hmac_sha256::Hash;
use simulation::{Choice, methods};
use std::fmt::Display;
use std::path::Path;

/// The origin of a file that a command writes.
#[derive(Clone, Debug)]
pub struct Provenance {
    lines: Vec<String>,
}

impl Provenance {
    /// The origin of a file that follows from a scene alone; the hash is that of the file, as `sha256sum` prints it.
    pub fn of(maker: Maker, scene: &Path) -> Self {
        let hash = std::fs::read(scene).map(|bytes| Hash::hash(&bytes));
        let hash =
            hash.map_or_else(|_| "unknown".to_owned(), |hash| hash.iter().map(|byte| format!("{byte:02x}")).collect());
        let lines = vec![
            format!("made by: {}", maker.generator()),
            format!("scene: {}", scene.display()),
            format!("sha256 of the scene: {hash}"),
        ];
        // a value must not break its line
        Provenance { lines: lines.into_iter().map(|line| line.replace(['\n', '\r'], " ")).collect() }
    }

    /// Adds a fact, such as the method.
    #[must_use]
    pub fn with(mut self, name: &str, value: impl Display) -> Self {
        self.lines.push(format!("{name}: {value}").replace(['\n', '\r'], " "));
        self
    }

    /// Adds the method of a run, and its tolerance unless the steps are constant.
    #[must_use]
    pub fn of_run(self, choice: &Choice) -> Self {
        let told = self.with("method", methods::written(choice.method));
        match choice.method.steps() {
            Some(_) => told,
            None => told.with("tolerance", format!("{:e}", choice.tolerance)),
        }
    }

    /// The origin as comments with a sign.
    pub fn comment(&self, sign: &str) -> String {
        self.lines.iter().map(|line| format!("{sign} {line}\n")).collect()
    }

    /// The origin as a comment of SVG, in which two hyphens in a row are not allowed.
    pub fn markup(&self) -> String {
        format!("<!-- {} -->\n", self.line().replace("--", "- -").replace("--", "- -"))
    }

    /// The origin in one line.
    pub fn line(&self) -> String {
        self.lines.join("; ")
    }

    /// The origin, line by line.
    pub fn lines(&self) -> &[String] {
        &self.lines
    }
}
