//! Derivation of the equations of motion of a file by a named principle, in matrix form.

use crate::readiness::{start_of, starting};
use crate::system_text::SystemText;
use model::principles::Principle;
use model::{Fault, MatrixForm, Model, QuasiPrinciple, QuasiVelocities, Trace};
use reader::SceneError;
use std::fmt;
use symbolic::Language;
use units::nearest;

/// A principle of mechanics with a name for commands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NamedPrinciple {
    /// Equations in the rates of all coordinates. For a system with quasi-velocities, virtual power, Appell and Hamel give equations
    /// along these.
    InRates(Principle),
    /// Equations along quasi-velocities: those of the file, or independent rates.
    AlongQuasiVelocities(QuasiPrinciple),
}

impl NamedPrinciple {
    /// All principles.
    pub fn all() -> Vec<Self> {
        let along = [QuasiPrinciple::Maggi, QuasiPrinciple::Shulgin].map(Self::AlongQuasiVelocities);
        Principle::ALL.map(Self::InRates).into_iter().chain(along).collect()
    }

    /// The name in commands.
    pub fn name(self) -> &'static str {
        match self {
            Self::InRates(principle) => principle.name(),
            Self::AlongQuasiVelocities(principle) => principle.name(),
        }
    }

    /// The principle with this name, in any case and with `_` or a space for `-`. `kane` and `jourdain` are names of virtual power.
    ///
    /// # Errors
    /// No principle has this name; the message lists the accepted names.
    pub fn of_name(name: &str) -> Result<Self, String> {
        let plain = name.to_lowercase().replace(['_', ' '], "-");
        if matches!(plain.as_str(), "kane" | "jourdain") {
            return Ok(Self::InRates(Principle::VirtualPower));
        }
        let names: Vec<&str> = Self::all().into_iter().map(Self::name).collect();
        Self::all().into_iter().find(|known| known.name() == plain).ok_or_else(|| {
            let near = nearest(&plain, names.iter().copied());
            let meant = near.map_or_else(String::new, |nearest| format!(" is `{nearest}` meant?"));
            format!("no principle is called `{name}`;{meant} accepted are {}", names.join(", "))
        })
    }

    /// The form of the principle along quasi-velocities; `None` if it has none.
    fn in_quasi_velocities(self) -> Option<QuasiPrinciple> {
        match self {
            Self::AlongQuasiVelocities(principle) => Some(principle),
            Self::InRates(Principle::VirtualPower) => Some(QuasiPrinciple::VirtualPower),
            Self::InRates(Principle::Appell) => Some(QuasiPrinciple::Appell),
            Self::InRates(Principle::Hamel) => Some(QuasiPrinciple::Hamel),
            Self::InRates(_) => None,
        }
    }

    /// The default principle for a model.
    pub fn usual(model: &Model) -> Self {
        let has_energy = model.energies.kinetic.is_some();
        Self::InRates(match model.quasi_velocities.is_empty() {
            false if has_energy || model.energies.coenergy.is_some() => Principle::Hamel,
            true if has_energy => Principle::Lagrange,
            _ => Principle::VirtualPower,
        })
    }
}

/// The reason for which no equations are derived.
#[derive(Debug)]
pub enum NotDerived {
    /// The file has errors.
    Text(SceneError),
    /// The principle does not apply, or the equations are too long.
    Refused(String),
}

impl fmt::Display for NotDerived {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Text(error) => write!(f, "{error}"),
            Self::Refused(why) => write!(f, "{why}"),
        }
    }
}

impl std::error::Error for NotDerived {}

impl From<SceneError> for NotDerived {
    fn from(error: SceneError) -> Self {
        NotDerived::Text(error)
    }
}

fn refused(why: impl fmt::Display) -> NotDerived {
    NotDerived::Refused(why.to_string())
}

/// Derived equations of motion.
pub struct Derived<'t, 'm> {
    /// The symbols of the model.
    pub trace: &'t Trace<'m>,
    /// The equations.
    pub form: MatrixForm,
    /// The principle of the derivation.
    pub principle: NamedPrinciple,
    /// True if the quasi-velocities do not determine the speeds at the start, where the equations then have no value.
    pub vanishes_at_start: bool,
}

/// Derives the equations of motion of a file and passes them to `show`, whose result is returned. Without a `principle` the default of
/// [`NamedPrinciple::usual`] applies. `code` says that the equations are printed as code.
///
/// # Errors
/// The file has errors, or the principle does not apply to its system.
pub fn derived<R: Send>(
    text: &SystemText,
    principle: Option<NamedPrinciple>,
    code: bool,
    show: impl FnOnce(&Derived<'_, '_>) -> R + Send,
) -> Result<R, NotDerived> {
    let mut model = text.for_equations()?;
    let principle = principle.unwrap_or_else(|| NamedPrinciple::usual(&model));
    let has_own = !model.quasi_velocities.is_empty();
    let quasi = match principle {
        NamedPrinciple::AlongQuasiVelocities(quasi) => Some(quasi),
        NamedPrinciple::InRates(_) => principle.in_quasi_velocities().filter(|_| has_own),
    };
    if let Some(quasi) = quasi {
        if !has_own || quasi == QuasiPrinciple::Shulgin {
            if model.constraints.is_empty() {
                return Err(refused(format!(
                    "{} does not apply: without constraints its equations are those of lagrange; accepted is lagrange, or a system with \
                     constraints",
                    quasi.name()
                )));
            }
            // the start selects the independent rates
            if let Ok(state) = start_of(&model) {
                model = starting(&model, &state);
            }
            model = model.along_independent_rates();
        }
        return in_quasi_velocities((&model, text), (principle, quasi), code, show);
    }
    let NamedPrinciple::InRates(in_rates) = principle else {
        return Err(refused("this principle needs quasi-velocities"));
    };
    // symbols belong to this graph alone, so `show` must run inside
    symbolic::apart(|| {
        let trace = Trace::of(&model);
        let form = MatrixForm::of(&trace, in_rates).map_err(refused)?.in_file(&model, &text.text);
        Ok(show(&Derived { trace: &trace, form, principle, vanishes_at_start: false }))
    })
}

/// Equations with more operations than this get letters for the derivatives by speeds, if that makes them shorter by a quarter.
const MOST_WITHOUT_LETTERS: f64 = 12_000.0;

fn in_quasi_velocities<R: Send>(
    (model, text): (&Model, &SystemText),
    (principle, quasi): (NamedPrinciple, QuasiPrinciple),
    code: bool,
    show: impl FnOnce(&Derived<'_, '_>) -> R + Send,
) -> Result<R, NotDerived> {
    symbolic::apart(|| {
        let trace = Trace::of(model);
        let start = start_of(model).ok();
        let written = |velocities: Result<QuasiVelocities<'_, '_>, Vec<Fault>>| {
            // independence was checked when the file was read, except for some branches
            let velocities = velocities.map_err(|_| refused("its quasi-velocities are not independent"))?;
            let form = MatrixForm::in_quasi_velocities(&trace, &velocities, quasi).map_err(refused)?;
            let form = match &start {
                Some(start) => form.with_start(&trace, start),
                None => form,
            };
            Ok::<MatrixForm, NotDerived>(form.in_file(model, &text.text))
        };
        let mut form = written(QuasiVelocities::of(&trace))?;
        let operations = form.written_operations();
        if quasi != QuasiPrinciple::Hamel && !code && operations > MOST_WITHOUT_LETTERS {
            let named = written(QuasiVelocities::named(&trace))?;
            if 4.0 * named.written_operations() < 3.0 * operations {
                form = named;
            }
        }
        let mut divisors = form.quasi.iter().flat_map(|quasi| &quasi.divisors);
        let vanishes_at_start = divisors.any(|divisor| divisor.vanishes_at_start == Some(true));
        Ok(show(&Derived { trace: &trace, form, principle, vanishes_at_start }))
    })
}

/// A notation in which equations are printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Notation {
    /// Plain text.
    Text,
    /// LaTeX.
    Latex,
    /// A Python program with SymPy.
    Sympy,
    /// Source code with common subexpressions.
    Code(Language),
}

/// Equations with more operations than this are printed as code only. A megabyte of text has two hundred thousand operations.
const MOST_WRITTEN: f64 = 1_000_000.0;

impl Derived<'_, '_> {
    /// The equations in a notation.
    ///
    /// # Errors
    /// The equations are too long for this notation.
    pub fn written(&self, notation: Notation) -> Result<String, String> {
        let Derived { trace, form, .. } = self;
        match notation {
            Notation::Text => Ok(model::text(trace, &self.for_reading()?)),
            Notation::Latex => Ok(model::latex(trace, &self.for_reading()?)),
            Notation::Sympy => {
                self.is_read()?;
                model::sympy(trace, form).map_err(|why| why.to_string())
            }
            Notation::Code(language) => model::code(trace, form, language).map_err(|why| why.to_string()),
        }
    }

    fn is_read(&self) -> Result<(), String> {
        match self.form.is_read() {
            true => Ok(()),
            false => Err(format!(
                "in these quasi-velocities the equations have {:.0e} operations, too many to be read; the formats c, python and rust \
                 write them as code, and the principle lagrange writes them in the rates of coordinates",
                self.form.written_operations()
            )),
        }
    }

    /// The equations without letters for common parts.
    ///
    /// # Errors
    /// The equations are too long to be read.
    pub fn for_reading(&self) -> Result<MatrixForm, String> {
        self.is_read()?;
        let read = self.form.for_reading();
        match read.written_operations() {
            operations if operations > MOST_WRITTEN => Err(format!(
                "these equations have {operations:.0e} operations where they are written out, too many to be read; the formats c, python \
                 and rust write every common part once; `[speeds]` makes equations of chains shorter"
            )),
            _ => Ok(read),
        }
    }
}
