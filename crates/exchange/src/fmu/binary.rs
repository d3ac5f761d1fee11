//! The binary of a functional mock-up unit, compiled with the C compiler of this computer.

use super::{Unit, Version};
use std::env::consts::{ARCH, DLL_EXTENSION, OS};
use std::fmt;
use std::io;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

/// The length of the sources in bytes above which they are compiled with less optimisation.
const LONG: usize = 300_000;

/// A shared library for this platform.
#[derive(Clone, Debug)]
pub struct Binary {
    pub bytes: Vec<u8>,
}

/// The reason for which there is no binary.
#[derive(Debug)]
pub enum NoBinary {
    /// No compiler of this name is found.
    NoCompiler(String),
    /// The compiler rejects the sources; the text is its message.
    Refused(String),
    /// The compilation was stopped.
    BrokenOff,
    /// A file cannot be written or read.
    Failed(io::Error),
}

impl fmt::Display for NoBinary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoCompiler(name) => write!(f, "no C compiler `{name}` is found on this machine"),
            Self::Refused(said) => write!(f, "the C compiler refuses the sources: {said}"),
            Self::BrokenOff => write!(f, "the C compiler was broken off"),
            Self::Failed(error) => write!(f, "the binary is not written: {error}"),
        }
    }
}

impl From<io::Error> for NoBinary {
    fn from(error: io::Error) -> Self {
        NoBinary::Failed(error)
    }
}

impl Version {
    /// The name of this platform in the standard.
    fn platform(self) -> String {
        let system = if OS == "macos" { "darwin" } else { OS };
        match (self, ARCH, OS) {
            (Version::Two, "x86_64", "linux" | "macos") => format!("{system}64"),
            (Version::Two, "x86", "linux") => "linux32".to_owned(),
            (Version::Two, "x86_64", "windows") => "win64".to_owned(),
            (Version::Two, "x86", "windows") => "win32".to_owned(),
            // FMI 2.0 defines no names of other platforms
            _ => format!("{ARCH}-{system}"),
        }
    }
}

impl Unit {
    /// The path of the library in the folder `binaries`.
    pub(super) fn library(&self) -> String {
        format!("{}/{}.{DLL_EXTENSION}", self.version.platform(), self.identifier)
    }
}

impl Binary {
    /// Compiles a unit in an empty folder. The compilation is stopped when `goes_on`, which is called repeatedly, returns false.
    ///
    /// # Errors
    /// [`NoBinary`], where no compiler is found, it rejects the sources, it is stopped, or a file cannot be read or written.
    pub fn of(unit: &Unit, compiler: &str, folder: &Path, goes_on: impl Fn() -> bool) -> Result<Self, NoBinary> {
        for (name, text) in unit.sources() {
            std::fs::write(folder.join(name), text)?;
        }
        let (library, said) = (format!("unit.{DLL_EXTENSION}"), folder.join("said"));
        let mut command = Command::new(compiler);
        let optimised = if unit.source.len() > LONG { "-O1" } else { "-O2" };
        command.args([
            "-std=c99",
            optimised,
            "-fPIC",
            "-shared",
            "-fvisibility=hidden",
            "-ffp-contract=off",
            "-w",
            "-o",
            &library,
        ]);
        command
            .args([unit.version.main_source(), "-lm"])
            .current_dir(folder)
            .stdin(Stdio::null())
            .stdout(Stdio::null());
        command.stderr(std::fs::File::create(&said)?);
        let mut child = command.spawn().map_err(|error| match error.kind() {
            io::ErrorKind::NotFound => NoBinary::NoCompiler(compiler.to_owned()),
            _ => NoBinary::Failed(error),
        })?;
        let status = loop {
            if let Some(status) = child.try_wait()? {
                break status;
            }
            if !goes_on() {
                child.kill()?;
                child.wait()?;
                return Err(NoBinary::BrokenOff);
            }
            std::thread::sleep(Duration::from_millis(10));
        };
        if !status.success() {
            let said = std::fs::read_to_string(&said).unwrap_or_default();
            let first = said.lines().find(|line| line.contains("error")).unwrap_or_default();
            return Err(NoBinary::Refused(first.to_owned()));
        }
        Ok(Binary { bytes: std::fs::read(folder.join(library))? })
    }
}
