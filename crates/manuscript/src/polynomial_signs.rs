//! Signs of polynomials for all values of their letters: by squares and discriminants, and in one unknown by exact real roots.

use crate::half_turn::{is_half_turn, sign_of_number};
use crate::line_signs::number_between;
use crate::motion::Motion;
use crate::refutation::{Refutation, exact};
use algebra::real::{Polynomial, Root};
use claims::Condition;
use field::Rational;
use symbolic::{Hypotheses, Node, Sym, coefficients, normal, univariate};

/// The largest depth of nested completions of the square.
const DEPTH: usize = 4;

/// The largest number of terms of a polynomial that is examined.
const MOST_TERMS: usize = 200;

/// Known signs of letters.
#[derive(Clone, Default)]
struct Known {
    positive: Vec<Sym>,
    not_negative: Vec<Sym>,
    not_zero: Vec<Sym>,
}

impl Known {
    /// Whether a letter is nonnegative.
    fn is_up(&self, letter: &Sym) -> bool {
        self.positive.contains(letter) || self.not_negative.contains(letter)
    }

    fn is_apart(&self, letter: &Sym) -> bool {
        self.positive.contains(letter) || self.not_zero.contains(letter)
    }
}

/// Whether a quotient of polynomials is proved nonnegative where the conditions hold. `None` without a proof, otherwise whether it is positive.
pub(crate) fn shows(expression: Sym, conditions: &[Condition]) -> Option<bool> {
    // numbers are decided by enclosures elsewhere
    if expression.symbols_of().into_iter().all(is_half_turn) {
        return None;
    }
    let (expression, is_turned) = by_half_angles(expression);
    let (expression, known) = by_slacks(expression, conditions);
    let form = normal(expression, &Hypotheses::none()).ok()?;
    let of = |polynomial: Sym| is_at_least_zero(polynomial, &known, DEPTH);
    let is_strict = match of(form.denominator()) {
        Some(true) => of(form.numerator())?,
        _ if of(-form.denominator()) == Some(true) => of(-form.numerator())?,
        _ => return None,
    };
    // the tangent of half an angle has no value at the angle π, where positivity does not follow from a limit
    Some(is_strict && !is_turned)
}

/// The expression with cosines and sines replaced by tangents of half angles, and whether there were any.
fn by_half_angles(expression: Sym) -> (Sym, bool) {
    let mut known: Vec<(Sym, Sym)> = Vec::new();
    for leaf in expression.leaves_of() {
        let (Node::Cos(angle) | Node::Sin(angle)) = leaf.node() else { continue };
        let tangent = Sym::symbol(&format!("tangent of half of {angle}"));
        let square = tangent * tangent;
        let value = match leaf.node() {
            Node::Cos(_) => (Sym::ONE - square) / (Sym::ONE + square),
            _ => (tangent + tangent) / (Sym::ONE + square),
        };
        known.push((leaf, value));
    }
    (expression.substitute(&known), !known.is_empty())
}

/// Replaces letters, in each of which a condition is linear, by the value of the condition (a slack variable), whose sign is known.
fn by_slacks(mut expression: Sym, conditions: &[Condition]) -> (Sym, Known) {
    let mut signs = Known::default();
    let mut known: Vec<(Sym, Sym)> = Vec::new();
    let mut others: Vec<(Sym, bool)> = Vec::new();
    for condition in conditions {
        match *condition {
            Condition::NonZero(of) if of.symbol_name().is_some() => signs.not_zero.push(of),
            Condition::Positive(of) if of.symbol_name().is_some() => signs.positive.push(of),
            Condition::NotNegative(of) if of.symbol_name().is_some() => signs.not_negative.push(of),
            Condition::Positive(of) => others.push((of, true)),
            Condition::NotNegative(of) => others.push((of, false)),
            _ => {}
        }
    }
    for (place, (of, is_strict)) in others.into_iter().enumerate() {
        let of = of.substitute(&known);
        let free = |symbol: &Sym| !signs.is_up(symbol);
        let mut symbols = of.symbols_of();
        // letters without a known sign are replaced first
        symbols.sort_by_key(|symbol| !free(symbol));
        let solved = symbols.into_iter().filter(|symbol| free(symbol)).find_map(|symbol| {
            let terms = coefficients(of, &[symbol]).ok()?;
            let part = |power: u32| terms.iter().find(|(exponents, _)| exponents[0] == power).map(|(_, value)| *value);
            let factor = part(1)?.as_constant().filter(|_| terms.iter().all(|(exponents, _)| exponents[0] <= 1))?;
            let slack = Sym::symbol(&format!("slack {place}"));
            Some((symbol, (slack - part(0).unwrap_or(Sym::ZERO)) / Sym::constant(factor), slack))
        });
        if let Some((symbol, value, slack)) = solved {
            known.iter_mut().for_each(|(_, held)| *held = held.substitute(&[(symbol, value)]));
            known.push((symbol, value));
            if is_strict { &mut signs.positive } else { &mut signs.not_negative }.push(slack);
        }
    }
    expression = expression.substitute(&known);
    (expression, signs)
}

/// Whether a polynomial is proved nonnegative for letters with known signs. `None` without a proof, otherwise whether it is positive.
fn is_at_least_zero(polynomial: Sym, known: &Known, depth: usize) -> Option<bool> {
    let form = normal(polynomial, &Hypotheses::none()).ok()?;
    let polynomial = form.to_sym();
    if let Some(value) = polynomial.as_constant() {
        return value.sign().filter(|sign| *sign >= 0).map(|sign| sign > 0);
    }
    if let Some(sign) = sign_of_number(polynomial) {
        return (sign >= 0).then_some(sign > 0);
    }
    let symbols = polynomial.symbols_of();
    let terms = coefficients(polynomial, &symbols).ok().filter(|terms| terms.len() <= MOST_TERMS)?;
    let is_up = |(exponents, value): &(Vec<u32>, Sym)| {
        let even = exponents.iter().zip(&symbols).all(|(power, symbol)| power % 2 == 0 || known.is_up(symbol));
        even && value.as_constant().and_then(|value| value.sign()).is_some_and(|sign| sign > 0)
    };
    if terms.iter().all(is_up) {
        let is_strict = |(exponents, _): &(Vec<u32>, Sym)| {
            exponents.iter().zip(&symbols).all(|(power, symbol)| *power == 0 || known.is_apart(symbol))
        };
        return Some(terms.iter().any(is_strict));
    }
    by_roots(polynomial, &symbols, known).or_else(|| {
        let one = |symbol: &Sym| by_square(polynomial, *symbol, known, depth);
        if depth == 0 { None } else { symbols.iter().find_map(one) }
    })
}

/// The sign of `a s² + b s + c` by its discriminant, and of other polynomials in a letter by their coefficients.
fn by_square(polynomial: Sym, symbol: Sym, known: &Known, depth: usize) -> Option<bool> {
    let terms = coefficients(polynomial, &[symbol]).ok()?;
    let of =
        |power: u32| terms.iter().find(|(exponents, _)| exponents[0] == power).map_or(Sym::ZERO, |(_, value)| *value);
    let shown = |part: Sym| is_at_least_zero(part, known, depth - 1);
    let is_up = known.is_up(&symbol);
    if terms.len() > 1 && terms.iter().all(|(exponents, _)| is_up || exponents[0] % 2 == 0) {
        let signs: Option<Vec<(u32, bool)>> =
            terms.iter().map(|(exponents, value)| Some((exponents[0], shown(*value)?))).collect();
        if let Some(signs) = signs {
            return Some(signs.iter().any(|(power, is_strict)| *is_strict && (*power == 0 || known.is_apart(&symbol))));
        }
    }
    let degree = terms.iter().map(|(exponents, _)| exponents[0]).max()?;
    if degree != 2 {
        return None;
    }
    let leading = shown(of(2))?;
    let four = Sym::constant(Rational::new(4, 1));
    let discriminant = shown(four * of(2) * of(0) - of(1) * of(1))?;
    // where the leading coefficient vanishes, the discriminant implies that only the constant remains
    if leading { Some(discriminant) } else { shown(of(0)).map(|_| discriminant) }
}

/// The sign of a polynomial in one unknown, or of a homogeneous one in two, by real roots.
fn by_roots(polynomial: Sym, symbols: &[Sym], known: &Known) -> Option<bool> {
    let is_up = |symbol: &Sym| known.is_up(symbol);
    match symbols {
        [one] => {
            let signs = Signs::of(&univariate(polynomial, *one).ok()?, is_up(one))?;
            // if the letter may be zero, the value there is a limit of positive values and may vanish
            let is_closed = is_up(one) && !known.positive.contains(one);
            signs.negative.is_none().then_some(!signs.vanishes && !is_closed)
        }
        &[first, second] => {
            let degree = homogeneous(polynomial, symbols)?;
            // a function of the ratio of both letters; for an even degree the sign of the second letter has no effect
            let (first, second) = if is_up(&second) { (first, second) } else { (second, first) };
            if !is_up(&second) && degree % 2 == 1 {
                return None;
            }
            let ratio = polynomial.substitute(&[(second, Sym::ONE)]);
            let signs =
                Signs::of(&univariate(normal(ratio, &Hypotheses::none()).ok()?.to_sym(), first).ok()?, is_up(&first))?;
            let is_open = known.positive.contains(&second) && (!is_up(&first) || known.positive.contains(&first));
            signs.negative.is_none().then_some(is_open && !signs.vanishes)
        }
        _ => None,
    }
}

/// The degree of a homogeneous polynomial; `None` for other polynomials.
fn homogeneous(polynomial: Sym, symbols: &[Sym]) -> Option<u32> {
    let terms = coefficients(polynomial, symbols).ok()?;
    let mut degrees = terms.iter().map(|(exponents, _)| exponents.iter().sum::<u32>());
    let first = degrees.next()?;
    degrees.all(|degree| degree == first).then_some(first)
}

/// The signs of a polynomial in one unknown, on all real numbers or on the positive ones.
struct Signs {
    /// A number at which the polynomial is negative, if there is one.
    negative: Option<Rational>,
    vanishes: bool,
}

impl Signs {
    fn of(dense: &[Rational], is_positive: bool) -> Option<Self> {
        let zero = Rational::new(0, 1);
        // zero roots are removed, since zero is not positive
        let skipped = if is_positive { dense.iter().take_while(|c| **c == zero).count() } else { 0 };
        let dense = &dense[skipped..];
        let roots: Vec<Root> = Polynomial::from_rationals(dense)?.square_free().real_roots();
        let ends: Vec<[f64; 2]> = roots.iter().map(|root| root.enclosure(64).ends()).collect();
        if is_positive && ends.iter().any(|[low, high]| *low <= 0.0 && *high >= 0.0) {
            return None;
        }
        let inside: Vec<[f64; 2]> = ends.into_iter().filter(|[low, _]| !is_positive || *low > 0.0).collect();
        let mut samples = Vec::new();
        match (inside.first(), inside.last()) {
            (Some(first), Some(last)) => {
                samples.push(number_between(if is_positive { 0.0 } else { first[0] - 2.0 }, first[0])?);
                for pair in inside.windows(2) {
                    samples.push(number_between(pair[0][1], pair[1][0])?);
                }
                samples.push(number_between(last[1], last[1] + 2.0)?);
            }
            _ => samples.push(Rational::new(1, 1)),
        }
        let mut negative = None;
        for at in samples {
            let value = dense.iter().rev().fold(zero, |sum, c| sum * at + *c);
            if value.sign()? < 0 {
                negative = Some(at);
                break;
            }
        }
        Some(Signs { negative, vanishes: !inside.is_empty() })
    }
}

/// An exact point at which a polynomial in one letter, or a homogeneous one in two, is negative and the conditions hold.
pub(crate) fn negative_point(expression: Sym, conditions: &[Condition], motion: &Motion<'_, '_>) -> Option<Refutation> {
    let is_closed = motion.open.is_empty() && motion.hypotheses.statements().is_empty();
    if !is_closed || motion.undetermined(expression).is_some() {
        return None;
    }
    let form = normal(expression, &Hypotheses::none()).ok()?;
    let product = normal(form.numerator() * form.denominator(), &Hypotheses::none()).ok()?.to_sym();
    let symbols = product.symbols_of();
    if product.leaves_of().len() != symbols.len() || symbols.iter().any(|symbol| is_half_turn(*symbol)) {
        return None;
    }
    let is_positive = |symbol: Sym| conditions.contains(&Condition::Positive(symbol));
    let one = Sym::ONE;
    let (unknown, fixed) = match symbols[..] {
        [unknown] => (unknown, None),
        [first, second] if homogeneous(product, &symbols).is_some() => (first, Some(second)),
        _ => return None,
    };
    let line = fixed.map_or(product, |second| product.substitute(&[(second, one)]));
    let dense = univariate(normal(line, &Hypotheses::none()).ok()?.to_sym(), unknown).ok()?;
    let at = Signs::of(&dense, is_positive(unknown))?.negative?;
    let point: Vec<(Sym, Sym)> =
        [(unknown, Sym::constant(at))].into_iter().chain(fixed.map(|second| (second, one))).collect();
    let values = exact(&point);
    let is_negative = values.value(expression).is_some_and(|value| value.is_defined() && value.sign() == Some(-1));
    let holds = conditions.iter().all(|condition| condition.holds_at(&values) == Some(true));
    (is_negative && holds).then_some(Refutation { point, is_formal: false })
}
