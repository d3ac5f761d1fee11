//! The origin of a result, with which it can be reproduced: the program, the scene with its hash, the method and the tolerance.

use super::Maker;
use hmac_sha256::Hash;
use simulation::{Choice, methods};
use std::fmt::Display;
use std::path::Path;

/// The origin of an output file, as lines `name: value`.
#[derive(Clone, Debug)]
pub struct Provenance {
    lines: Vec<String>,
}

impl Provenance {
    /// The origin of a file that depends only on a scene. The hash is the SHA-256 of the scene's file, as `sha256sum` prints it.
    pub fn of(maker: Maker, scene: &Path) -> Self {
        let hash = std::fs::read(scene).map(|bytes| Hash::hash(&bytes));
        let hash =
            hash.map_or_else(|_| "unknown".to_owned(), |hash| hash.iter().map(|byte| format!("{byte:02x}")).collect());
        let lines = vec![
            format!("made by: {}", maker.generator()),
            format!("scene: {}", scene.display()),
            format!("sha256 of the scene: {hash}"),
        ];
        // a line end in a value would break the line
        Provenance { lines: lines.into_iter().map(|line| line.replace(['\n', '\r'], " ")).collect() }
    }

    /// Adds a line `name: value`, such as the method.
    #[must_use]
    pub fn with(mut self, name: &str, value: impl Display) -> Self {
        self.lines.push(format!("{name}: {value}").replace(['\n', '\r'], " "));
        self
    }

    /// Adds the method of a run, and its tolerance unless the method has constant steps.
    #[must_use]
    pub fn of_run(self, choice: &Choice) -> Self {
        let told = self.with("method", methods::written(choice.method));
        match choice.method.steps() {
            Some(_) => told,
            None => told.with("tolerance", format!("{:e}", choice.tolerance)),
        }
    }

    /// The origin as comment lines that begin with `sign`.
    pub fn comment(&self, sign: &str) -> String {
        self.lines.iter().map(|line| format!("{sign} {line}\n")).collect()
    }

    /// The origin as a comment of SVG, in which two successive hyphens are not allowed.
    pub fn markup(&self) -> String {
        format!("<!-- {} -->\n", self.line().replace("--", "- -").replace("--", "- -"))
    }

    /// The origin as one line.
    pub fn line(&self) -> String {
        self.lines.join("; ")
    }

    /// The lines of the origin.
    pub fn lines(&self) -> &[String] {
        &self.lines
    }
}
