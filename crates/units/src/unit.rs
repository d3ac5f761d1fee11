//! Units of measurement: their factors to SI units and their dimensions.

use std::fmt;

/// A physical dimension: the exponents of kg, m, s and A. Angles are pure numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimension {
    exponents: [i32; 4],
}

/// A unit, equal to `times / per` of the coherent SI unit of its dimension. Two factors are stored because 1/1000 is not a binary fraction:
/// `50 mm` and `0.05 m` are then equal bit for bit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    times: f64,
    per: f64,
    dimension: Dimension,
}

/// The reason why a text is not a unit.
#[derive(Clone, Debug, PartialEq)]
pub enum NoUnit {
    /// No unit has this name. `nearest` is the most similar known name.
    Unknown { name: String, nearest: Option<&'static str> },
    /// Hertz is rejected because it may mean revolutions or radians per second.
    Hertz,
    /// A factor follows a slash, as in `kg/m s`: it may belong to the denominator or to the numerator.
    AmbiguousSlash { after: String },
    /// An exponent is not an integer from -9 to 9, or a sign or a parenthesis is misplaced.
    Malformed { part: String },
}

const NUMBER: [i32; 4] = [0, 0, 0, 0];
const VOLT: [i32; 4] = [1, 2, -3, -1];

/// Units that accept prefixes: (name, times, per, exponents of kg, m, s and A). The gram is listed in place of the kilogram, which is formed with a prefix.
const NAMED: &[(&str, f64, f64, [i32; 4])] = &[
    ("m", 1.0, 1.0, [0, 1, 0, 0]),
    ("g", 1.0, 1e3, [1, 0, 0, 0]),
    ("s", 1.0, 1.0, [0, 0, 1, 0]),
    ("A", 1.0, 1.0, [0, 0, 0, 1]),
    ("N", 1.0, 1.0, [1, 1, -2, 0]),
    ("J", 1.0, 1.0, [1, 2, -2, 0]),
    ("W", 1.0, 1.0, [1, 2, -3, 0]),
    ("V", 1.0, 1.0, VOLT),
    ("Wb", 1.0, 1.0, [1, 2, -2, -1]),
    ("T", 1.0, 1.0, [1, 0, -2, -1]),
    ("H", 1.0, 1.0, [1, 2, -2, -2]),
    ("ohm", 1.0, 1.0, [1, 2, -3, -2]),
    ("C", 1.0, 1.0, [0, 0, 1, 1]),
    ("F", 1.0, 1.0, [-1, -2, 4, 2]),
    ("Pa", 1.0, 1.0, [1, -1, -2, 0]),
    ("rad", 1.0, 1.0, NUMBER),
];

/// Units without prefixes: (name, times, per, exponents of kg, m, s and A).
const PLAIN: &[(&str, f64, f64, [i32; 4])] = &[
    ("min", 60.0, 1.0, [0, 0, 1, 0]),
    ("h", 3600.0, 1.0, [0, 0, 1, 0]),
    ("day", 86_400.0, 1.0, [0, 0, 1, 0]),
    ("bar", 1e5, 1.0, [1, -1, -2, 0]),
    ("in", 254.0, 1e4, [0, 1, 0, 0]),
    ("ft", 3048.0, 1e4, [0, 1, 0, 0]),
    ("lb", 45_359_237.0, 1e8, [1, 0, 0, 0]),
    ("lbf", 44_482_216_152_605.0, 1e13, [1, 1, -2, 0]),
    ("deg", std::f64::consts::PI, 180.0, NUMBER),
    ("rev", std::f64::consts::TAU, 1.0, NUMBER),
    ("rpm", std::f64::consts::TAU, 60.0, [0, 0, -1, 0]),
    ("1", 1.0, 1.0, NUMBER),
];

const PREFIXES: &[(&str, f64, f64)] =
    &[("n", 1.0, 1e9), ("u", 1.0, 1e6), ("m", 1.0, 1e3), ("c", 1.0, 1e2), ("k", 1e3, 1.0), ("M", 1e6, 1.0)];

/// The units that messages propose. The first unit of each dimension is the coherent one.
const USUAL: &[&str] = &[
    "kg", "g", "m", "mm", "cm", "s", "ms", "min", "rad", "deg", "rad/s", "rpm", "deg/s", "rev/s", "m/s", "km/h",
    "m/s^2", "N", "kN", "N m", "N mm", "kN m", "J", "N m s", "J s", "kg m^2", "g cm^2", "ohm", "mohm", "H", "mH", "uH",
    "Wb", "V s", "mWb", "A", "mA", "V", "W",
];

impl Unit {
    /// Reads a product of powers of units, such as `kg m^2/s` or `N/(m s)`. Spaces around the slash are optional. An empty text gives the unit 1.
    ///
    /// # Errors
    /// A name is unknown or ambiguous (`Hz`, a factor after a slash), or an exponent or a parenthesis is malformed.
    pub fn parse(text: &str) -> Result<Self, NoUnit> {
        let spaced = text.replace(['*', '\u{b7}'], " ");
        let (unit, rest) = product(&spaced, MOST_NESTED)?;
        if rest.is_empty() { Ok(unit) } else { Err(NoUnit::Malformed { part: rest.to_owned() }) }
    }

    /// Returns the names of all units that accept a prefix.
    pub fn with_prefixes() -> impl Iterator<Item = &'static str> {
        NAMED.iter().map(|(name, ..)| *name)
    }

    /// Returns the names of all units that do not accept a prefix.
    pub fn without_prefixes() -> impl Iterator<Item = &'static str> {
        PLAIN.iter().map(|(name, ..)| *name)
    }

    /// Returns all prefixes: `n`, `u`, `m`, `c`, `k`, `M`.
    pub fn prefixes() -> impl Iterator<Item = &'static str> {
        PREFIXES.iter().map(|(prefix, ..)| *prefix)
    }

    /// Converts a number in this unit to SI units.
    pub fn to_si(self, number: f64) -> f64 {
        number * self.times / self.per
    }

    /// Returns `[times, per]`: the unit is `times / per` of the coherent SI unit.
    pub fn factors(self) -> [f64; 2] {
        [self.times, self.per]
    }

    /// Returns the dimension of the unit.
    pub fn dimension(self) -> Dimension {
        self.dimension
    }

    fn multiply(&mut self, factor: Unit, exponent: i32) {
        let (times, per) = if exponent < 0 { (factor.per, factor.times) } else { (factor.times, factor.per) };
        for _ in 0..exponent.abs() {
            self.times *= times;
            self.per *= per;
        }
        for (sum, own) in self.dimension.exponents.iter_mut().zip(factor.dimension.exponents) {
            *sum += own * exponent;
        }
    }
}

impl Dimension {
    /// Returns the dimension of a unit, or that of a pure number if the text is not a valid unit. Use this function only for units that are constants of a program.
    pub fn of(unit: &str) -> Self {
        Unit::parse(unit).map_or(Dimension { exponents: NUMBER }, Unit::dimension)
    }

    /// Returns the exponents of kg, m, s and A.
    pub fn exponents(self) -> [i32; 4] {
        self.exponents
    }

    /// Converts the dimension to the type that symbolic expressions use.
    pub fn of_expressions(self) -> symbolic::Dimension {
        let [kg, m, s, a] = self.exponents.map(i64::from);
        symbolic::Dimension::of(kg, m, s, a)
    }

    /// Returns the coherent SI unit as a text that [`Unit::parse`] reads; `1` for a pure number.
    pub fn coherent(self) -> String {
        match self.usual().first() {
            Some(usual) if !self.is_number() => (*usual).to_owned(),
            _ if self.is_number() => "1".to_owned(),
            _ => self.to_string(),
        }
    }

    /// Returns whether this is the dimension of a pure number.
    pub fn is_number(self) -> bool {
        self.exponents == NUMBER
    }

    /// Returns the common units of this dimension, the coherent one first; empty for an uncommon dimension.
    pub fn usual(self) -> Vec<&'static str> {
        USUAL.iter().copied().filter(|unit| Dimension::of(unit) == self).collect()
    }
}

/// The largest allowed depth of nested parentheses.
const MOST_NESTED: usize = 8;

/// Reads a product up to the end of the text or to the closing parenthesis. Returns the unit and the unread rest.
fn product(text: &str, nested: usize) -> Result<(Unit, &str), NoUnit> {
    let mut product = Unit { times: 1.0, per: 1.0, dimension: Dimension { exponents: NUMBER } };
    let (mut rest, mut is_first, mut divided) = (text.trim_start(), true, false);
    while !rest.is_empty() && !rest.starts_with(')') {
        let below = rest.strip_prefix('/');
        let at = below.unwrap_or(rest).trim_start();
        if below.is_some() && is_first {
            return Err(NoUnit::Malformed { part: rest.to_owned() });
        }
        let ends = |letter: char| letter.is_whitespace() || matches!(letter, '/' | '(' | ')');
        let (factor, exponent, after) = match at.strip_prefix('(') {
            Some(inner) => {
                if nested == 0 || inner.trim_start().starts_with(')') {
                    return Err(NoUnit::Malformed { part: at.chars().take(16).collect() });
                }
                let (factor, after) = self::product(inner, nested - 1)?;
                let after = after.strip_prefix(')').ok_or_else(|| NoUnit::Malformed { part: at.to_owned() })?;
                let raised = &after[..after.find(ends).unwrap_or(after.len())];
                (factor, exponent(raised)?, &after[raised.len()..])
            }
            None => {
                let word = &at[..at.find(ends).unwrap_or(at.len())];
                if below.is_none() && divided {
                    return Err(NoUnit::AmbiguousSlash { after: word.to_owned() });
                }
                let (factor, exponent) = power(word)?;
                (factor, exponent, &at[word.len()..])
            }
        };
        if below.is_none() && divided {
            return Err(NoUnit::AmbiguousSlash { after: at[..at.len() - after.len()].to_owned() });
        }
        product.multiply(factor, if below.is_some() { -exponent } else { exponent });
        (is_first, divided, rest) = (false, divided || below.is_some(), after.trim_start());
    }
    Ok((product, rest))
}

/// Reads the exponent after a closing parenthesis: `^2`, or an empty text for 1.
fn exponent(text: &str) -> Result<i32, NoUnit> {
    let number = text.strip_prefix('^').and_then(|number| number.parse().ok());
    let number = if text.is_empty() { Some(1) } else { number };
    number.filter(|number| (-9..=9).contains(number)).ok_or_else(|| NoUnit::Malformed { part: format!("){text}") })
}

/// Reads a unit with an optional exponent: `kg`, `m^2`, `s^-1`.
fn power(part: &str) -> Result<(Unit, i32), NoUnit> {
    let malformed = || NoUnit::Malformed { part: part.to_owned() };
    let (name, exponent) = match part.split_once('^') {
        None => (part, 1),
        Some((name, exponent)) => (name, exponent.parse::<i32>().map_err(|_| malformed())?),
    };
    if name.is_empty() || !(-9..=9).contains(&exponent) {
        return Err(malformed());
    }
    Ok((named(name)?, exponent))
}

fn named(name: &str) -> Result<Unit, NoUnit> {
    let exact = |name: &str| NAMED.iter().find(|(known, ..)| *known == name);
    let unit =
        |&(_, times, per, exponents): &(&str, f64, f64, _)| Unit { times, per, dimension: Dimension { exponents } };
    let name = match name {
        "\u{3a9}" | "\u{2126}" | "Ohm" => "ohm",
        "\u{b0}" => "deg",
        other => other,
    };
    if let Some(known) = PLAIN.iter().find(|(known, ..)| *known == name).or_else(|| exact(name)) {
        return Ok(unit(known));
    }
    for (prefix, times, per) in PREFIXES {
        if let Some(known) = name.strip_prefix(prefix).and_then(exact) {
            let known = unit(known);
            return Ok(Unit { times: known.times * times, per: known.per * per, ..known });
        }
    }
    if name == "Hz" || name == "kHz" {
        return Err(NoUnit::Hertz);
    }
    let single = USUAL.iter().copied().filter(|unit| !unit.contains([' ', '/', '^']));
    Err(NoUnit::Unknown { name: name.to_owned(), nearest: crate::nearest(name, single) })
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_number() {
            return write!(f, "a pure number");
        }
        let powers = ["kg", "m", "s", "A"].iter().zip(self.exponents).filter(|(_, e)| *e != 0);
        let words: Vec<String> =
            powers.map(|(name, e)| if e == 1 { (*name).to_owned() } else { format!("{name}^{e}") }).collect();
        write!(f, "{}", words.join(" "))
    }
}

impl fmt::Display for NoUnit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown { name, .. } if name.starts_with(|first: char| first.is_ascii_digit()) => {
                write!(f, "`{name}` is no number, such as `9.81` or `1e-3` with a point, and no unit")
            }
            Self::Unknown { name, nearest: Some(nearest) } => {
                write!(f, "no unit is called `{name}`; is `{nearest}` meant?")
            }
            Self::Unknown { name, nearest: None } => write!(f, "no unit is called `{name}`"),
            Self::Hertz => write!(f, "`Hz` may be turns or radians a second; write `rev/s` or `rad/s`"),
            Self::AmbiguousSlash { after } => {
                write!(f, "`{after}` stands after a slash: above or below the line? Write `/{after}` or put it first")
            }
            Self::Malformed { part } => write!(f, "`{part}` is no power of a unit; written so: `m^2`, `s^-1`"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Unit;

    #[test]
    fn units_beside_si_have_their_defined_values() {
        for (text, si) in [
            ("h", 3600.0),
            ("day", 86_400.0),
            ("bar", 1e5),
            ("in", 0.0254),
            ("ft", 0.3048),
            ("lb", 0.453_592_37),
            ("lbf", 4.448_221_615_260_5),
            ("km / h", 1.0 / 3.6),
            ("lbf ft", 4.448_221_615_260_5 * 0.3048),
            ("N / m", 1.0),
            ("kg m^2/ s^2", 1.0),
        ] {
            let found = Unit::parse(text).unwrap_or_else(|wrong| panic!("{text}: {wrong}")).to_si(1.0);
            assert!((found - si).abs() <= 1e-15 * si, "{text}: {found}");
        }
        for wrong in [
            "kg / m s",
            "N/(m s",
            "N/m)",
            "N/(m/s) s",
            "(m s)^x",
            "/s",
            "m//s",
            "m/",
            "()^",
            "kg ()",
            "((((((((((m))))))))))",
        ] {
            assert!(Unit::parse(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_product_in_parentheses_is_one_factor() {
        for (text, other) in [
            ("m^3/(kg s^2)", "m^3/kg/s^2"),
            ("N/( m s )", "N/m/s"),
            ("kN/(m/s)", "kN s/m"),
            ("(m/s)^2", "m^2/s^2"),
            ("1/(ohm m)", "1/ohm/m"),
            ("N m/(rad/s)", "N m s"),
            ("J/(kg (m/s)^2)", "J/kg/m^2/s^-2"),
        ] {
            assert_eq!(Unit::parse(text), Unit::parse(other), "{text}");
            assert!(Unit::parse(text).is_ok(), "{text}");
        }
    }
}
