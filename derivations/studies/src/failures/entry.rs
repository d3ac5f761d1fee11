//! One way in which methods fail: its scene, its thresholds, what survives.

use super::{Exact, Trial};
use reader::SceneError;
use simulation::models::Modelled;
use std::borrow::Cow;
use std::fmt;
use std::path::{Path, PathBuf};

/// A way in which methods fail.
#[derive(Clone, Copy, Debug)]
pub struct Failing {
    /// As the command line calls it.
    pub name: &'static str,
    /// What goes wrong, in a line.
    pub title: &'static str,
    /// The file in the folder of scenes.
    pub scene: &'static str,
    /// Why it must happen: LaTeX between dollar signs.
    pub why: &'static str,
    /// What to do, in a sentence.
    pub advice: &'static str,
    /// What is asked of what is tried.
    pub asked: &'static str,
    pub(super) measure: fn(&Path) -> Result<Found, NotFound>,
}

/// What was found on the scene.
#[derive(Clone, Debug)]
pub struct Found {
    pub thresholds: Vec<Threshold>,
    /// What the program says where it happens; LaTeX-free.
    pub diagnosis: String,
    pub trials: Vec<Trial>,
}

/// Where it begins.
#[derive(Clone, Debug)]
pub struct Threshold {
    /// What is at the threshold, and of which method.
    pub of: Cow<'static, str>,
    /// Theory's formula: LaTeX between dollar signs.
    pub formula: Cow<'static, str>,
    /// The same with the scene's data.
    pub exact: Exact,
    /// Empty for a pure number.
    pub unit: Cow<'static, str>,
    /// By runs; `None` where they showed no edge.
    pub measured: Option<f64>,
    pub within: Within,
}

/// What a measurement can tell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Within {
    /// One part in so many; of a threshold that is zero, of one.
    Share(u32),
    /// A factor, where theory is the size of rounding.
    Factor(u32),
}

/// Why a way was not measured.
#[derive(Clone, Debug)]
pub enum NotFound {
    Scene(SceneError),
    /// The scene is not of the kind that fails in this way.
    Unsuitable {
        scene: PathBuf,
        what: String,
        accepted: &'static str,
    },
    /// Its time is over, or the user asked for the end.
    BrokenOff {
        scene: PathBuf,
    },
}

impl Failing {
    /// Measures it on its scene in a folder.
    ///
    /// # Errors
    /// [`NotFound`].
    pub fn measure(&self, folder: &Path) -> Result<Found, NotFound> {
        (self.measure)(&folder.join(self.scene))
    }
}

impl Threshold {
    /// Whether the measured threshold is theory's, as far as the measurement can tell.
    pub fn agrees(&self) -> bool {
        let theory = self.exact.value();
        self.measured.is_some_and(|measured| match self.within {
            Within::Share(parts) => {
                let size = if theory == 0.0 { 1.0 } else { theory.abs() };
                (measured - theory).abs() * f64::from(parts) <= size
            }
            Within::Factor(most) => {
                let ratio = measured / theory;
                ratio <= f64::from(most) && ratio * f64::from(most) >= 1.0
            }
        })
    }
}

impl NotFound {
    /// A scene that says nothing of a datum.
    pub(super) fn without(scene: &Path, datum: &str, accepted: &'static str) -> Self {
        NotFound::unsuitable(scene, format!("nothing in it is called `{datum}`"), accepted)
    }

    /// A scene of another kind.
    pub(super) fn unsuitable(scene: &Path, what: impl Into<String>, accepted: &'static str) -> Self {
        NotFound::Unsuitable { scene: scene.to_owned(), what: what.into(), accepted }
    }
}

/// Data of a scene whose system is written in it, by their names.
///
/// # Errors
/// The first that it does not have.
pub(super) fn data<const N: usize>(
    scene: &dyn Modelled,
    path: &Path,
    names: [&str; N],
    accepted: &'static str,
) -> Result<[f64; N], NotFound> {
    let mut found = [0.0; N];
    for (value, name) in found.iter_mut().zip(names) {
        *value = scene.value(name).ok_or_else(|| NotFound::without(path, name, accepted))?;
    }
    Ok(found)
}

impl From<SceneError> for NotFound {
    fn from(error: SceneError) -> Self {
        NotFound::Scene(error)
    }
}

impl fmt::Display for Within {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Within::Share(parts) => write!(f, "to 1/{parts}"),
            Within::Factor(most) => write!(f, "within a factor of {most}"),
        }
    }
}

impl fmt::Display for NotFound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NotFound::Scene(error) => error.fmt(f),
            NotFound::Unsuitable { scene, what, accepted } => {
                write!(f, "{}: {what}; {accepted} is accepted", scene.display())
            }
            NotFound::BrokenOff { scene } => write!(f, "{}: broken off before it was measured", scene.display()),
        }
    }
}

impl std::error::Error for NotFound {}
