//! Edits that replace one symbol: a sign, a function, an exponent, a letter, the dots of a rate, a number.

use super::edit::Edit;
use super::letter_rates::LetterRate;
use super::places::{Atom, Places, Summand};
use crate::change::EditKind;
use field::Rational;
use latex::Function;
use std::ops::Range;

/// The largest numerator and denominator of the numbers that replace printed numbers.
const MOST: i64 = 12;

/// All edits of one symbol, in the order of the formula.
pub(super) fn exchanges(places: &Places, text: &str, rates: &[LetterRate]) -> Vec<Edit> {
    let mut all = signs(places, text);
    all.extend(functions(places, text));
    all.extend(exponents(places, text));
    for atom in &places.atoms {
        all.extend(dots(atom, text, rates));
        all.extend(others(atom, text, rates));
    }
    all.extend(powers_of_rates(places, text, rates));
    all.extend(scripts(places, text, rates));
    all.extend(superfluous_numbers(places, text));
    all.extend(numbers(places, text));
    all.extend(letters_for_numbers(places, text, rates));
    all
}

/// Edits of the relation of an inequality: with equality included, or in the other direction.
pub(super) fn relations(text: &str) -> Vec<Edit> {
    const LOOSE: [(&str, &str); 4] = [(r"\lt", r"\leq"), (r"\gt", r"\geq"), ("<", r"\leq"), (">", r"\geq")];
    const TURNED: [(&str, &str); 10] = [
        (r"\leqslant", r"\geqslant"),
        (r"\geqslant", r"\leqslant"),
        (r"\leq", r"\geq"),
        (r"\geq", r"\leq"),
        (r"\le", r"\ge"),
        (r"\ge", r"\le"),
        (r"\lt", r"\gt"),
        (r"\gt", r"\lt"),
        ("<", ">"),
        (">", "<"),
    ];
    let is_whole = |at: usize, from: &str| {
        !from.starts_with('\\') || !text[at + from.len()..].starts_with(|letter: char| letter.is_ascii_alphabetic())
    };
    let of = |kind: EditKind, (from, to): (&'static str, &'static str)| {
        text.match_indices(from)
            .filter(move |(at, _)| is_whole(*at, from))
            .map(move |(at, _)| Edit::new(kind, at..at + from.len(), to, format!("`{to}` for `{from}`")))
    };
    let loose = LOOSE.into_iter().flat_map(|pair| of(EditKind::Strictness, pair));
    loose.chain(TURNED.into_iter().flat_map(|pair| of(EditKind::Direction, pair))).collect()
}

/// The description of a term: `the second term of the right side`, or the term itself.
pub(super) fn told(summand: &Summand, text: &str) -> String {
    const ORDINALS: [&str; 6] = ["first", "second", "third", "fourth", "fifth", "sixth"];
    match (summand.side, ORDINALS.get(summand.number - 1)) {
        (Some(side @ 0..=1), _) if summand.count == 1 => format!("the {} side", ["left", "right"][side]),
        (Some(side @ 0..=1), Some(ordinal)) => format!("the {ordinal} term of the {} side", ["left", "right"][side]),
        _ => format!("the term `{}`", &text[summand.span.clone()]),
    }
}

/// Edits that change the sign of a term.
pub(super) fn signs(places: &Places, text: &str) -> Vec<Edit> {
    // printed signs come first, since a wrong sign is usually printed; the sign of a letter that the formula defines comes last
    let rank = |summand: &Summand| if summand.sign.is_some() { 0 } else { 1 + usize::from(places.is_told(summand)) };
    let of = |wanted: usize| {
        let chosen = move |summand: &&Summand| rank(summand) == wanted && &text[summand.span.clone()] != "0";
        places.summands.iter().filter(chosen).map(|summand| sign(summand, text))
    };
    (0..=2).flat_map(of).collect()
}

/// The edit that changes the sign of a term.
pub(super) fn sign(summand: &Summand, text: &str) -> Edit {
    let (span, after) = match summand.sign {
        Some((at, '-')) if summand.number == 1 => (at..at + 1, ""),
        Some((at, '-')) => (at..at + 1, "+"),
        Some((at, _)) => (at..at + 1, "-"),
        None => (summand.span.start..summand.span.start, "-"),
    };
    let around = span.start..summand.span.end;
    let words = format!("the sign of {}", told(summand, text));
    Edit { around, ..Edit::new(EditKind::Sign, span, after, words) }
}

fn functions(places: &Places, text: &str) -> Vec<Edit> {
    let others = |function: Function| -> &[&str] {
        match function {
            Function::Sin => &[r"\cos"],
            Function::Cos => &[r"\sin"],
            Function::Tan => &[r"\cot"],
            Function::Cot => &[r"\tan"],
            Function::Sinh => &[r"\cosh"],
            Function::Cosh => &[r"\sinh"],
            _ => &[],
        }
    };
    let of = |other: &str, before: &str, call: &super::places::Call| {
        let words = format!("`{other}` for `{before}` of `{}`", &text[call.argument.clone()]);
        Edit::new(EditKind::Function, call.command.clone(), other, words)
    };
    let each = places.calls.iter();
    each.flat_map(|call| others(call.function).iter().map(move |other| of(other, &text[call.command.clone()], call)))
        .collect()
}

fn exponents(places: &Places, text: &str) -> Vec<Edit> {
    let mut all = Vec::new();
    let mut add = |span: Range<usize>, after: String, words: String| {
        all.push(Edit::new(EditKind::Exponent, span, after, words));
    };
    for power in &places.powers {
        let script = &text[power.script.clone()];
        for change in [-1, 1, -2, 2] {
            let after = match power.exponent + change {
                ..=0 => continue,
                1 => String::new(),
                exponent => {
                    format!("^{{{exponent}}}").replace("^{2}", "^2").replace("^{3}", "^3").replace("^{4}", "^4")
                }
            };
            let words = match after.as_str() {
                "" => format!("no exponent `{script}`"),
                after => format!("the exponent `{after}` for `{script}`"),
            };
            add(power.script.clone(), after, words);
        }
    }
    let atoms = places.atoms.iter().filter(|atom| !atom.is_powered).map(|atom| (atom.span.end, &atom.span));
    let calls = places.calls.iter().filter(|call| !call.is_powered).map(|call| (call.command.end, &call.command));
    for (at, of) in atoms.chain(calls) {
        for exponent in ["^2", "^3"] {
            let of = &text[of.clone()];
            add(at..at, exponent.to_owned(), format!("the exponent `{exponent}` of `{of}`"));
        }
    }
    all
}

fn dots(atom: &Atom, text: &str, rates: &[LetterRate]) -> Vec<Edit> {
    let of = |order: u32| rates.iter().find(|rate| rate.name == atom.name && rate.order == order);
    let orders = [atom.order.checked_sub(1), Some(atom.order + 1)];
    let edit = |rate: &LetterRate| {
        let words = format!("`{}` for `{}`", rate.latex, &text[atom.span.clone()]);
        Edit::new(EditKind::Dot, atom.span.clone(), rate.latex.as_str(), words)
    };
    orders.into_iter().flatten().filter_map(of).map(edit).collect()
}

/// Edits that replace the square of a rate by the second rate, or the second rate by the square.
fn powers_of_rates(places: &Places, text: &str, rates: &[LetterRate]) -> Vec<Edit> {
    let rate = |atom: &Atom, order: u32| rates.iter().find(|rate| rate.name == atom.name && rate.order == order);
    let edit = |span: Range<usize>, after: String| {
        let words = format!("`{after}` for `{}`", &text[span.clone()]);
        Edit::new(EditKind::Dot, span, after, words)
    };
    let of = |atom: &Atom| match (atom.order, square_of(atom, places)) {
        (1, Some(script)) => rate(atom, 2).map(|rate| edit(atom.span.start..script.end, rate.latex.clone())),
        (2, None) if !atom.is_powered => rate(atom, 1).map(|rate| edit(atom.span.clone(), format!("{}^2", rate.latex))),
        _ => None,
    };
    places.atoms.iter().filter_map(of).collect()
}

/// The exponent of an atom if it is 2.
fn square_of<'a>(atom: &Atom, places: &'a Places) -> Option<&'a Range<usize>> {
    let is_its_own = |power: &&super::places::Raised| power.exponent == 2 && power.script.start == atom.span.end;
    places.powers.iter().find(is_its_own).map(|power| &power.script)
}

/// Edits that replace an exponent by a subscript, `J^2` by `J_2`, or a subscript by an exponent.
fn scripts(places: &Places, text: &str, rates: &[LetterRate]) -> Vec<Edit> {
    let known = |name: &str| rates.iter().any(|rate| rate.order == 0 && rate.name == name);
    let edit = |span: Range<usize>, after: String| {
        let words = format!("`{after}` for `{}`", &text[span.clone()]);
        Edit::new(EditKind::Letter, span, after, words)
    };
    let mut all = Vec::new();
    for atom in places.atoms.iter().filter(|atom| atom.order == 0) {
        let power = places.powers.iter().find(|power| power.script.start == atom.span.end);
        if let Some(power) = power.filter(|_| atom.is_powered) {
            let name = format!("{}_{{{}}}", atom.name, power.exponent);
            if known(&name) {
                all.push(edit(atom.span.start..power.script.end, name));
            }
        } else if let Some((base, below)) = atom.name.strip_suffix('}').and_then(|name| name.split_once("_{"))
            && !atom.is_powered
            && known(base)
            && below.parse::<u32>().is_ok_and(|exponent| exponent > 1)
        {
            all.push(edit(atom.span.clone(), format!("{base}^{{{below}}}")));
        }
    }
    all
}

/// Edits that replace a letter or rate by another of the same dimension.
fn others(atom: &Atom, text: &str, rates: &[LetterRate]) -> Vec<Edit> {
    let Some(own) = rates.iter().find(|rate| rate.name == atom.name && rate.order == atom.order) else {
        return Vec::new();
    };
    let fits = |rate: &&LetterRate| rate.name != atom.name && rate.dimension == own.dimension;
    let edit = |rate: &LetterRate| {
        let words = format!("`{}` for `{}`", rate.latex, &text[atom.span.clone()]);
        Edit::new(EditKind::Letter, atom.span.clone(), rate.latex.as_str(), words)
    };
    rates.iter().filter(fits).map(edit).collect()
}

fn numbers(places: &Places, text: &str) -> Vec<Edit> {
    let mut values: Vec<(i64, i64)> = Vec::new();
    for below in 1..=MOST {
        for above in 1..=MOST {
            if gcd(above, below) == 1 {
                values.push((above, below));
            }
        }
    }
    // small numbers come first
    values.sort_by_key(|(above, below)| (above + below, *below));
    let mut all = Vec::new();
    let is_of_fraction =
        |span: &Range<usize>| places.fractions.iter().any(|(of, _)| of.start <= span.start && span.end <= of.end);
    for (span, printed) in places.numbers.iter().chain(&places.fractions) {
        let before = &text[..span.start];
        // in `\frac12` an argument without braces is a single digit
        let is_bare = before.trim_end().ends_with("frac") || before.ends_with(|letter: char| letter.is_ascii_digit());
        let is_part = is_of_fraction(span) && places.numbers.iter().any(|(number, _)| number == span);
        let fits = |&(above, below): &(i64, i64)| {
            let is_new = Rational::new(above, below) != *printed && *printed != Rational::new(0, 1);
            // in the numerator or denominator of a fraction, only integers are tried
            is_new && (below == 1 || !is_part)
        };
        for &(above, below) in values.iter().filter(|value| fits(value)) {
            let plain = if below == 1 { above.to_string() } else { format!(r"\frac{{{above}}}{{{below}}}") };
            let after = if is_bare && (plain.len() > 1) { format!("{{{plain}}}") } else { plain.clone() };
            let words = format!("the number `{plain}` for `{}`", &text[span.clone()]);
            // a factor 1 is left out where the product has other factors
            let gone = if plain == "1" { factor_gone(span, places) } else { None };
            all.extend(gone.map(|gone| Edit::new(EditKind::Number, gone, "", words.clone())));
            all.push(Edit::new(EditKind::Number, span.clone(), after, words));
        }
    }
    all
}

/// Edits that replace a number which is a whole side by zero.
fn superfluous_numbers(places: &Places, text: &str) -> Vec<Edit> {
    let is_number = |span: &Range<usize>| {
        let mut all = places.numbers.iter().chain(&places.fractions);
        all.any(|(number, value)| number == span && *value != Rational::new(0, 1))
    };
    let is_side = |summand: &&Summand| summand.side.is_some() && summand.count == 1 && is_number(&summand.span);
    let edit = |summand: &Summand| {
        let start = summand.sign.map_or(summand.span.start, |(at, _)| at);
        let words = format!("the number `0` for `{}`", &text[start..summand.span.end]);
        Edit::new(EditKind::Number, start..summand.span.end, "0", words)
    };
    places.summands.iter().filter(is_side).map(edit).collect()
}

/// The range of a factor together with the product sign next to it; `None` for a factor that stands alone.
pub(super) fn factor_gone(factor: &Range<usize>, places: &Places) -> Option<Range<usize>> {
    let mut places_of = places.summands.iter().filter_map(|summand| {
        let place = summand.factors.iter().position(|one| one == factor)?;
        match place.checked_sub(1) {
            Some(before) => Some(summand.factors[before].end..factor.end),
            None => summand.factors.get(1).map(|next| factor.start..next.start),
        }
    });
    places_of.next()
}

/// Edits that replace a number by a letter.
fn letters_for_numbers(places: &Places, text: &str, rates: &[LetterRate]) -> Vec<Edit> {
    let edit = |span: &Range<usize>, rate: &LetterRate| {
        let words = format!("`{}` for `{}`", rate.latex, &text[span.clone()]);
        Edit::new(EditKind::Letter, span.clone(), rate.latex.as_str(), words)
    };
    let printed = places.numbers.iter().filter(|(_, value)| *value != Rational::new(0, 1));
    printed.flat_map(|(span, _)| rates.iter().filter(|rate| rate.order == 0).map(|rate| edit(span, rate))).collect()
}

pub(super) fn gcd(a: i64, b: i64) -> i64 {
    if b == 0 { a } else { gcd(b, a % b) }
}
