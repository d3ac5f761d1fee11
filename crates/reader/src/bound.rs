//! Bounds of data, and values beyond them that a file must ask for by name.

/// The values that a datum may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bound {
    /// Every number.
    Any,
    /// Above zero: masses, moments of inertia, inductances, lengths.
    Positive,
    /// Zero or above.
    NotNegative,
    /// Every number but zero: the law divides by it.
    NotZero,
    /// Above zero, unless a file allows less: zero for a superconductor, negative for a part that feeds a circuit.
    Resistance,
    /// Zero or above, unless a file allows less: negative friction feeds the motion.
    Friction,
}

/// Data that a file asks for in its key `allow`, because they are usually a mistake.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Allowed {
    pub zero_resistance: bool,
    pub negative_resistance: bool,
    pub negative_friction: bool,
    /// Windings whose currents stand in one law `motional`, and which do not induce in each other all the same.
    pub separate_fluxes: bool,
}

impl Allowed {
    /// The words of the key.
    pub const WORDS: [&'static str; 4] =
        [Self::ZERO_RESISTANCE, Self::NEGATIVE_RESISTANCE, Self::NEGATIVE_FRICTION, Self::SEPARATE_FLUXES];
    /// Allows a resistance of zero.
    pub const ZERO_RESISTANCE: &'static str = "zero resistance";
    /// Allows resistances below zero.
    pub const NEGATIVE_RESISTANCE: &'static str = "negative resistance";
    /// Allows coefficients of friction and damping below zero.
    pub const NEGATIVE_FRICTION: &'static str = "negative friction";
    /// Says that windings do not induce in each other.
    pub const SEPARATE_FLUXES: &'static str = "separate fluxes";

    /// All allowances: for data that no file gives.
    pub const ALL: Self =
        Allowed { zero_resistance: true, negative_resistance: true, negative_friction: true, separate_fluxes: true };

    /// Adds the allowance of a word; returns whether the word is known.
    pub fn add(&mut self, word: &str) -> bool {
        let asked = match word {
            Self::ZERO_RESISTANCE => &mut self.zero_resistance,
            Self::NEGATIVE_RESISTANCE => &mut self.negative_resistance,
            Self::NEGATIVE_FRICTION => &mut self.negative_friction,
            Self::SEPARATE_FLUXES => &mut self.separate_fluxes,
            _ => return false,
        };
        *asked = true;
        true
    }
}

impl Bound {
    /// Whether a value is within the bound; NaN never is.
    pub fn holds(self, value: f64, allowed: Allowed) -> bool {
        match self {
            Self::Any => !value.is_nan(),
            Self::Positive => value > 0.0,
            Self::NotNegative => value >= 0.0,
            Self::NotZero => value.abs() > 0.0,
            Self::Resistance if value < 0.0 => allowed.negative_resistance,
            Self::Resistance => value > 0.0 || value == 0.0 && allowed.zero_resistance,
            Self::Friction => value >= 0.0 || value < 0.0 && allowed.negative_friction,
        }
    }

    /// The fault of a value beyond the bound, reported after the name of the datum.
    pub fn broken(self) -> &'static str {
        match self {
            Self::Any => "must be a number",
            Self::Positive | Self::Resistance => "must be positive",
            Self::NotNegative | Self::Friction => "must not be negative",
            Self::NotZero => "must not be zero",
        }
    }

    /// The values that would be accepted in its place.
    pub fn accepted(self, value: f64) -> String {
        let asked = |word: &str| format!("; if it is meant, `allow = [\"{word}\"]` at the top of the file asks for it");
        match self {
            Self::Any => "a number is accepted".to_owned(),
            Self::Positive => "a positive value is accepted".to_owned(),
            Self::NotNegative => "zero or a positive value is accepted".to_owned(),
            Self::NotZero => "a value other than zero is accepted".to_owned(),
            Self::Resistance if value < 0.0 => {
                format!("a positive value is accepted{}", asked(Allowed::NEGATIVE_RESISTANCE))
            }
            Self::Resistance => format!("a positive value is accepted{}", asked(Allowed::ZERO_RESISTANCE)),
            Self::Friction => {
                format!("zero or a positive value is accepted{}", asked(Allowed::NEGATIVE_FRICTION))
            }
        }
    }
}
