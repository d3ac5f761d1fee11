//! Corrections of several terms of one side at once: the side is compared term by term with the value that it must have.

use super::edit::Edit;
use super::ground::Ground;
use super::lost::{SOUGHT, signed};
use super::places::{Places, Summand};
use super::{exchanges, factors, terms};
use crate::change::EditKind;
use field::Rational;
use latex::read;
use std::collections::BTreeMap;
use std::ops::Range;
use symbolic::{Hypotheses, Node, Sym, coefficients, normal};

/// The largest number of missing terms.
const MOST_MISSING: usize = 16;

/// The largest number of terms of a side that is compared.
const MOST_SUMMANDS: usize = 48;

/// A polynomial: the coefficients of products of letters.
type Products = BTreeMap<Vec<(String, u32)>, Rational>;

/// A term with the factor by which it must be multiplied; zero for a superfluous term.
#[derive(Clone, Copy)]
struct Scaled {
    /// The index of the term in [`Places::summands`].
    summand: usize,
    by: Rational,
}

/// Terms with their factors, and the number of products of letters that are correct with these factors.
#[derive(Default)]
struct Choice {
    numbers: Vec<Scaled>,
    /// The number of correct products of letters.
    right: usize,
}

/// Edits of whole sides. A side is left out if less than half of its printed letters and numbers would remain, or if more would be new than
/// were printed.
pub(super) fn compared(ground: &impl Ground, places: &Places) -> Vec<Vec<Edit>> {
    let sides = places.summands.iter().filter(|summand| summand.number == 1 && summand.side.is_some());
    let of = |first: &Summand| {
        let side = Side { ground, places, span: places.sums[first.sum].clone(), sum: first.sum };
        side.corrections().unwrap_or_default()
    };
    let mut found: Vec<(usize, Vec<Edit>)> = sides.flat_map(of).collect();
    found.sort_by_key(|(size, _)| *size);
    found.into_iter().map(|(_, edits)| edits).collect()
}

struct Side<'a, G> {
    ground: &'a G,
    places: &'a Places,
    span: Range<usize>,
    sum: usize,
}

impl<G: Ground> Side<'_, G> {
    fn text(&self) -> &str {
        self.ground.text()
    }

    /// The formula after `edits`, with the letter [`SOUGHT`] added to this side: it stands for a missing term. `None` if the formula already contains
    /// this letter, edits overlap, or the edited text cannot be read.
    fn asked(&self, edits: &[Edit]) -> Option<latex::Statement> {
        let mut known = self.ground.known();
        if known.iter().any(|name| name == SOUGHT) {
            return None;
        }
        known.push(SOUGHT.to_owned());
        let end = self.span.end..self.span.end;
        let sought = Edit::new(EditKind::LostTerm, end, format!(" + {SOUGHT}"), String::new());
        let (text, _) = super::search::edited(self.text(), &[edits, &[sought]].concat())?;
        read(&text, &known).ok()
    }

    /// The edits of this side, each with the number of new letters and numbers.
    fn corrections(&self) -> Option<Vec<(usize, Vec<Edit>)>> {
        let lack = self.ground.lack(&self.asked(&[])?)?;
        let below = normal(lack, &Hypotheses::none()).ok()?.denominator();
        let mut lacking = products(lack * below)?;
        let inside = |summand: &&Summand| self.span.start <= summand.span.start && summand.span.end <= self.span.end;
        if self.places.summands.iter().filter(inside).count() > MOST_SUMMANDS {
            return None;
        }
        let mut scaled: Vec<Scaled> = Vec::new();
        let terms = self.terms_of(self.sum);
        // all terms are examined twice, since one wrong term can hide another
        for place in [&terms[..], &terms].concat() {
            let within = |of: &Range<usize>, term: &Range<usize>| term.start <= of.start && of.end <= term.end;
            let span = |summand: usize| &self.places.summands[summand].span;
            if scaled.iter().any(|one| within(span(one.summand), span(place))) {
                continue;
            }
            let chosen = self.scaled(place, lack, below, &lacking).numbers;
            for one in &chosen {
                let term = self.products(one.summand, lack, below)?;
                // the coefficients are updated, so that only one of two equal terms is removed
                for (product, number) in term {
                    let rest = lacking.entry(product).or_insert(Rational::new(0, 1));
                    *rest += number * (Rational::new(1, 1) - one.by);
                }
            }
            scaled.extend(chosen);
        }
        let edits: Vec<Edit> = scaled.iter().map(|one| self.edits(*one)).collect::<Option<Vec<_>>>()?.concat();
        let gone: Vec<&Range<usize>> = scaled
            .iter()
            .filter(|one| one.by == Rational::new(0, 1))
            .map(|one| &self.places.summands[one.summand].span)
            .collect();
        let (printed, kept) = (self.kept(&[]), self.kept(&gone));
        // if less than half of the printed formula remained, this would be a new formula and not a correction
        if 2 * kept < printed {
            return None;
        }
        let missing = self.ground.sought(&self.asked(&edits)?);
        let told = missing.into_iter().filter_map(|missing| {
            let terms = if missing == Sym::ZERO { Vec::new() } else { summands(missing) };
            let new = terms.iter().map(|term| letters(*term)).sum::<usize>();
            let is_short = new + scaled.len() < printed && terms.len() <= MOST_MISSING;
            is_short.then(|| (new, [edits.clone(), self.added(&terms)].concat()))
        });
        Some(told.filter(|(_, edits)| !edits.is_empty()).collect())
    }

    fn terms_of(&self, sum: usize) -> Vec<usize> {
        (0..self.places.summands.len()).filter(|&place| self.places.summands[place].sum == sum).collect()
    }

    /// The factor of a term, or of terms of a sum within it, for which most of its products of letters are correct.
    fn scaled(&self, place: usize, lack: Sym, below: Sym, lacking: &Products) -> Choice {
        let summand = &self.places.summands[place];
        let own = self.products(place, lack, below).filter(|own| !own.is_empty() && self.ground.goes_on());
        let Some(own) = own else { return Choice::default() };
        let (by, right) = most_frequent(&own, lacking);
        let numbers = if by == Rational::new(1, 1) { Vec::new() } else { vec![Scaled { summand: place, by }] };
        let mut best = Choice { numbers, right };
        let within = |of: &Range<usize>| summand.span.start <= of.start && of.end <= summand.span.end;
        for sum in (0..self.places.sums.len()).filter(|&sum| sum != summand.sum && within(&self.places.sums[sum])) {
            let terms = self.terms_of(sum);
            if best.right == own.len() || terms.len() < 2 {
                continue;
            }
            let parts: Vec<Choice> = terms.iter().map(|&term| self.scaled(term, lack, below, lacking)).collect();
            let right = parts.iter().map(|part| part.right).sum();
            if right > best.right {
                best = Choice { numbers: parts.into_iter().flat_map(|part| part.numbers).collect(), right };
            }
        }
        best
    }

    /// The contribution of a term to the side, multiplied by the denominator of the side.
    fn products(&self, place: usize, lack: Sym, below: Sym) -> Option<Products> {
        let none = Edit::new(EditKind::ExtraTerm, self.places.summands[place].span.clone(), "0", String::new());
        let without = self.ground.lack(&self.asked(&[none])?)?;
        products((without - lack) * below)
    }

    /// The edits that multiply a term by a number.
    fn edits(&self, Scaled { summand, by }: Scaled) -> Option<Vec<Edit>> {
        let (text, summand_is) = (self.text(), &self.places.summands[summand]);
        let sign = by.sign()?;
        if sign == 0 {
            return terms::away(self.places, text, |place, _| place == summand).pop().map(|edit| vec![edit]);
        }
        let by = if sign < 0 { -by } else { by };
        let turned = (sign < 0).then(|| exchanges::sign(summand_is, text));
        let factor = (by != Rational::new(1, 1)).then(|| self.multiplied(summand_is, by));
        Some(turned.into_iter().chain(factor).collect())
    }

    /// The edit that multiplies a term by a positive number, by changing its printed number if it has one.
    fn multiplied(&self, summand: &Summand, by: Rational) -> Edit {
        let text = self.text();
        let factor = factors::before(summand, &latex(by), text);
        let is_own = |(span, _): &&(Range<usize>, Rational)| summand.factors.contains(span);
        let printed =
            [&self.places.fractions, &self.places.numbers].into_iter().find_map(|all| all.iter().find(is_own));
        let Some((span, number)) = printed else { return factor };
        let product = *number * by;
        let (span, after) = match exchanges::factor_gone(span, self.places).filter(|_| product == Rational::new(1, 1)) {
            Some(gone) => (gone, String::new()),
            None => (span.clone(), latex(product)),
        };
        Edit::new(factor.kind, span, after, factor.words)
    }

    /// The number of letters and numbers of this side that remain.
    fn kept(&self, gone: &[&Range<usize>]) -> usize {
        let places = self.places;
        let stays = |at: &Range<usize>| {
            let within = |of: &Range<usize>| of.start <= at.start && at.end <= of.end;
            within(&self.span) && !gone.iter().any(|gone| within(gone))
        };
        let numbers = places.numbers.iter().map(|(span, _)| span);
        places.atoms.iter().map(|atom| &atom.span).chain(numbers).filter(|span| stays(span)).count()
    }

    /// The edits that add terms at the end of the side.
    fn added(&self, terms: &[Sym]) -> Vec<Edit> {
        let end = self.span.end;
        let edit = |term: &Sym| {
            let (sign, latex) = signed(*term);
            Edit::new(
                EditKind::LostTerm,
                end..end,
                format!(" {sign} {latex}"),
                format!("the missing term `{sign} {latex}`"),
            )
        };
        terms.iter().map(edit).collect()
    }
}

/// A positive number in LaTeX.
fn latex(number: Rational) -> String {
    let told = number.to_string();
    told.split_once('/').map_or(told.clone(), |(above, below)| format!(r"\frac{{{above}}}{{{below}}}"))
}

/// The most frequent ratio between the correct and the printed coefficients of a term's products of letters, and the number of products with this ratio.
fn most_frequent(own: &Products, lacking: &Products) -> (Rational, usize) {
    let one = Rational::new(1, 1);
    let mut votes: Vec<(Rational, usize)> = Vec::new();
    for (product, number) in own {
        let by = lacking.get(product).map_or(one, |lack| one + *lack / *number);
        match votes.iter_mut().find(|(known, _)| *known == by) {
            Some((_, count)) => *count += 1,
            None => votes.push((by, 1)),
        }
    }
    // of equally frequent ratios, 1 is preferred
    votes.into_iter().max_by_key(|(by, count)| (*count, *by == one)).unwrap_or((one, 0))
}

/// The products of letters of a polynomial with their coefficients; `None` if the expression is not a polynomial.
fn products(expression: Sym) -> Option<Products> {
    let form = normal(expression, &Hypotheses::none()).ok()?;
    let symbols = form.to_sym().leaves_of();
    let symbols: Vec<Sym> = symbols.into_iter().filter(|leaf| leaf.as_constant().is_none()).collect();
    let terms = coefficients(form.to_sym(), &symbols).ok()?;
    let one = |(exponents, value): (Vec<u32>, Sym)| {
        let powers = symbols.iter().zip(exponents).filter(|(_, power)| *power > 0);
        Some((powers.map(|(symbol, power)| (symbol.to_string(), power)).collect(), value.as_constant()?))
    };
    terms.into_iter().map(one).collect()
}

/// The terms of a sum with their signs.
fn summands(sum: Sym) -> Vec<Sym> {
    match sum.node() {
        Node::Sum(a, b) => [summands(a), summands(b)].concat(),
        Node::Difference(a, b) => {
            let behind = summands(b).into_iter().map(|term| -term);
            summands(a).into_iter().chain(behind).filter(|term| *term != Sym::ZERO).collect()
        }
        Node::Negation(a) => summands(a).into_iter().map(|term| -term).collect(),
        Node::Quotient(a, b) if summands(a).len() > 1 => {
            let of = |term: Sym| normal(term / b, &Hypotheses::none()).map_or(term / b, |form| form.to_sym());
            summands(a).into_iter().map(of).collect()
        }
        _ => vec![sum],
    }
}

/// The number of letters and numbers in an expression, without simplification.
pub(super) fn letters(expression: Sym) -> usize {
    let below: usize = expression.node().children().map(letters).sum();
    below.max(1)
}
