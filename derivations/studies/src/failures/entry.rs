//! An entry of the catalogue of failures: scene, thresholds, trials of all methods.

use super::{Exact, Trial};
use reader::SceneError;
use simulation::models::Modelled;
use std::borrow::Cow;
use std::fmt;
use std::path::{Path, PathBuf};

/// A way in which numerical methods fail.
#[derive(Clone, Copy, Debug)]
pub struct Failing {
    /// The name on the command line.
    pub name: &'static str,
    /// The failure, in one line.
    pub title: &'static str,
    /// The file in the folder of scenes.
    pub scene: &'static str,
    /// The theory of the failure; LaTeX between dollar signs.
    pub why: &'static str,
    /// The remedy, in a sentence.
    pub advice: &'static str,
    /// The condition that a trial must meet.
    pub asked: &'static str,
    pub(super) measure: fn(&Path) -> Result<Found, NotFound>,
}

/// The measured results of an entry.
#[derive(Clone, Debug)]
pub struct Found {
    pub thresholds: Vec<Threshold>,
    /// The program's message when the failure happens; plain text.
    pub diagnosis: String,
    pub trials: Vec<Trial>,
}

/// A threshold at which a failure begins, by theory and by runs.
#[derive(Clone, Debug)]
pub struct Threshold {
    /// The quantity that has this threshold, and the method.
    pub of: Cow<'static, str>,
    /// The formula by theory; LaTeX between dollar signs.
    pub formula: Cow<'static, str>,
    /// The value of the formula for the scene's data.
    pub exact: Exact,
    /// The unit; empty for a pure number.
    pub unit: Cow<'static, str>,
    /// The threshold measured by runs; `None` where they showed none.
    pub measured: Option<f64>,
    pub within: Within,
}

/// The accuracy of a measured threshold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Within {
    /// A relative error of one over this number; an absolute error if the threshold is zero.
    Share(u32),
    /// A factor, for thresholds of the size of rounding.
    Factor(u32),
}

/// The reason why an entry was not measured.
#[derive(Clone, Debug)]
pub enum NotFound {
    Scene(SceneError),
    /// The scene cannot show this failure.
    Unsuitable {
        scene: PathBuf,
        what: String,
        accepted: &'static str,
    },
    /// The time limit was reached, or the user interrupted.
    BrokenOff {
        scene: PathBuf,
    },
}

impl Failing {
    /// Measures the entry on its scene in a folder of scenes.
    ///
    /// # Errors
    /// [`NotFound`] where the scene is unsuitable or the measurement is interrupted.
    pub fn measure(&self, folder: &Path) -> Result<Found, NotFound> {
        (self.measure)(&folder.join(self.scene))
    }
}

impl Threshold {
    /// Whether the measured threshold agrees with theory to the accuracy of the measurement.
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
    /// The error for a scene without a datum.
    pub(super) fn without(scene: &Path, datum: &str, accepted: &'static str) -> Self {
        NotFound::unsuitable(scene, format!("nothing in it is called `{datum}`"), accepted)
    }

    /// The error for a scene of another kind.
    pub(super) fn unsuitable(scene: &Path, what: impl Into<String>, accepted: &'static str) -> Self {
        NotFound::Unsuitable { scene: scene.to_owned(), what: what.into(), accepted }
    }
}

/// The values of parameters of a text model, by name.
///
/// # Errors
/// [`NotFound`] with the first parameter that the model does not have.
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
