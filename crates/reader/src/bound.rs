//! Bounds of data, and the values outside the bounds that a file can allow explicitly.

/// The set of values that a datum may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bound {
    /// Every number except NaN.
    Any,
    /// Positive numbers: masses, moments of inertia, inductances, lengths.
    Positive,
    /// Numbers that are not negative.
    NotNegative,
    /// Numbers other than zero, since the law divides by the number.
    NotZero,
    /// Positive numbers. A file may allow zero (a superconductor) or negative numbers (a part that feeds the circuit).
    Resistance,
    /// Numbers that are not negative. A file may allow negative numbers: negative friction feeds energy into the motion.
    Friction,
}

/// Unusual data that a file allows with its key `allow`. They are errors otherwise, because they are usually mistakes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Allowed {
    pub zero_resistance: bool,
    pub negative_resistance: bool,
    pub negative_friction: bool,
    /// The windings of one law `motional` have no mutual inductance.
    pub separate_fluxes: bool,
}

impl Allowed {
    /// All words that the key `allow` accepts.
    pub const WORDS: [&'static str; 4] =
        [Self::ZERO_RESISTANCE, Self::NEGATIVE_RESISTANCE, Self::NEGATIVE_FRICTION, Self::SEPARATE_FLUXES];
    /// Allows a resistance of zero.
    pub const ZERO_RESISTANCE: &'static str = "zero resistance";
    /// Allows resistances below zero.
    pub const NEGATIVE_RESISTANCE: &'static str = "negative resistance";
    /// Allows coefficients of friction and damping below zero.
    pub const NEGATIVE_FRICTION: &'static str = "negative friction";
    /// Declares that the windings of one law `motional` have no mutual inductance.
    pub const SEPARATE_FLUXES: &'static str = "separate fluxes";

    /// All allowances, for data that do not come from a file.
    pub const ALL: Self =
        Allowed { zero_resistance: true, negative_resistance: true, negative_friction: true, separate_fluxes: true };

    /// Adds the allowance that `word` names. Returns whether the word is known.
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
    /// Returns whether the value satisfies the bound, including the allowances of the file; false for NaN.
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

    /// Returns the violated condition, which a message appends to the name of the datum: "must be positive".
    pub fn broken(self) -> &'static str {
        match self {
            Self::Any => "must be a number",
            Self::Positive | Self::Resistance => "must be positive",
            Self::NotNegative | Self::Friction => "must not be negative",
            Self::NotZero => "must not be zero",
        }
    }

    /// Returns a sentence that states the accepted values, and the word for `allow` that would accept `value`.
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
