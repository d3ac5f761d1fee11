//! Exact thresholds by theory.

use algebra::real::Root;
use field::Rational;
use std::fmt;

/// An exact number.
#[derive(Clone, Debug)]
pub enum Exact {
    Number(Rational),
    /// A real root of a polynomial with integer coefficients.
    Root(Root),
    /// A number times a real root.
    Times(Rational, Root),
    /// A transcendental threshold: the formula with its data, and its value.
    Formula(String, f64),
}

impl Exact {
    /// A float within one unit in the last place.
    pub fn value(&self) -> f64 {
        match self {
            Exact::Number(number) => number.to_f64(),
            Exact::Root(root) => root.to_f64(),
            Exact::Times(factor, root) => factor.to_f64() * root.to_f64(),
            Exact::Formula(_, value) => *value,
        }
    }

    /// A threshold from a root, if there is one.
    pub(super) fn root(found: Option<Root>) -> Option<Self> {
        found.map(|root| root.as_rational().map_or(Exact::Root(root), Exact::Number))
    }

    /// A threshold from a number times a root, if there is one.
    pub(super) fn times(factor: Rational, found: Option<Root>) -> Option<Self> {
        found.map(|root| root.as_rational().map_or(Exact::Times(factor, root), |root| Exact::Number(factor * root)))
    }
}

impl fmt::Display for Exact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Exact::Number(number) => number.fmt(f),
            Exact::Formula(text, _) => f.write_str(text),
            Exact::Times(factor, root) => write!(f, "{factor} ({})", Exact::Root(root.clone())),
            Exact::Root(root) => match small(root).as_deref() {
                Some(&[c, b, a]) => surd(f, [a, b, c], root.to_f64()),
                _ => polynomial(f, root),
            },
        }
    }
}

/// The integer coefficients of the root's polynomial, if they are small enough.
fn small(root: &Root) -> Option<Vec<i128>> {
    let integers = root.polynomial().integers()?;
    // halved range, so that the discriminant fits too
    let fits = |n: &i128| n.unsigned_abs() < 1 << 60;
    integers.iter().map(|n| n.to_string().parse().ok().filter(fits)).collect()
}

/// Writes the root (p + q sqrt(n)) / d of a quadratic equation.
fn surd(f: &mut fmt::Formatter<'_>, [a, b, c]: [i128; 3], value: f64) -> fmt::Result {
    let (mut inside, mut outside) = (b * b - 4 * a * c, 1);
    for square in (2..1000).rev() {
        while inside % (square * square) == 0 {
            (inside, outside) = (inside / (square * square), outside * square);
        }
    }
    let common = gcd(gcd(b, outside), 2 * a);
    let (p, q, d) = (-b / common, outside / common, 2 * a / common);
    let (p, d) = (p * d.signum(), d.abs());
    // the sign of the root with this value
    let sign = if (value * d as f64) < p as f64 { "-" } else { "+" };
    let root = if q == 1 { format!("sqrt({inside})") } else { format!("{q} sqrt({inside})") };
    let above = match (p, sign) {
        (0, "-") => format!("-{root}"),
        (0, _) => root,
        _ => format!("({p} {sign} {root})"),
    };
    if d == 1 { f.write_str(&above) } else { write!(f, "{above}/{d}") }
}

fn gcd(a: i128, b: i128) -> i128 {
    if b == 0 { a.abs().max(1) } else { gcd(b, a % b) }
}

/// Writes the polynomial, and the index of the root among its real roots.
fn polynomial(f: &mut fmt::Formatter<'_>, root: &Root) -> fmt::Result {
    let all = root.polynomial().real_roots();
    let place = all.iter().filter(|other| other.compare(root).is_lt()).count() + 1;
    match all.len() {
        1 => f.write_str("the real root of")?,
        count => write!(f, "real root {place} of {count} of")?,
    }
    let integers = root.polynomial().integers().unwrap_or_default();
    let down = integers.last().is_some_and(|lead| lead.to_string().starts_with('-'));
    for (power, n) in integers.iter().enumerate().rev() {
        let text = n.to_string();
        let (negative, size) = text.strip_prefix('-').map_or((false, text.as_str()), |size| (true, size));
        let sign = if negative == down { "+" } else { "-" };
        if size == "0" {
            continue;
        }
        let sign = if power + 1 == integers.len() && sign == "+" { String::new() } else { format!("{sign} ") };
        let power = match power {
            0 => String::new(),
            1 => "x".to_owned(),
            _ => format!("x^{power}"),
        };
        let factor = if size == "1" && !power.is_empty() { "" } else { size };
        let space = if factor.is_empty() || power.is_empty() { "" } else { " " };
        write!(f, " {sign}{factor}{space}{power}")?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::Exact;
    use algebra::real::Polynomial;

    #[test]
    fn quadratic_numbers_are_written_as_roots_and_others_by_their_polynomial() {
        let written = |coefficients: &[i64]| {
            let roots = Polynomial::from_integers(coefficients.iter().copied()).real_roots();
            roots.into_iter().map(|root| Exact::root(Some(root)).map_or(String::new(), |it| it.to_string())).collect()
        };
        let found: [Vec<String>; 3] = [&[4, -6, 1][..], &[-2, 0, 25], &[-24, 12, -4, 1]].map(written);
        assert_eq!(found[0], ["(3 - sqrt(5))", "(3 + sqrt(5))"]);
        assert_eq!(found[1], ["-sqrt(2)/5", "sqrt(2)/5"]);
        assert_eq!(found[2], ["the real root of x^3 - 4 x^2 + 12 x - 24"]);
    }
}
