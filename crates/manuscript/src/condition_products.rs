//! Products of conditions with factors that are not negative: where their sum vanishes identically, although one of them is positive, no point
//! satisfies all conditions.

use crate::natural_domain::natural_domain;
use algebra::linear::nonnegative_combination;
use claims::Condition;
use field::Rational;
use std::collections::{BTreeMap, BTreeSet};
use symbolic::{Hypotheses, Node, Sym, coefficients, normal};

/// Factors of a product.
const MOST_FACTORS: usize = 3;

/// Conditions of which products of two, and of three factors are formed.
const MOST_FOR_TWO: usize = 14;
const MOST_FOR_THREE: usize = 9;

/// Longer polynomials, and those of a higher degree, are left out.
const MOST_TERMS: usize = 40;
const HIGHEST: u32 = 12;

/// Products of letters by their exponents, each with a number.
type Terms = BTreeMap<Vec<u32>, Rational>;

/// A polynomial that is not negative where the conditions hold.
#[derive(Clone)]
struct Factor {
    terms: Terms,
    /// Whether zero is excluded.
    is_strict: bool,
}

impl Factor {
    fn times(&self, other: &Self) -> Option<Self> {
        let terms = product(&self.terms, &other.terms)?;
        Some(Factor { terms, is_strict: self.is_strict && other.is_strict })
    }
}

/// Whether products of the conditions show that no point satisfies all of them.
pub(crate) fn exclude_each_other(conditions: &[Condition]) -> bool {
    let Polynomials { factors, zeros } = Polynomials::of(conditions);
    (1..=MOST_FACTORS).any(|count| {
        let fits = match count {
            1 => true,
            2 => factors.len() <= MOST_FOR_TWO,
            _ => factors.len() <= MOST_FOR_THREE,
        };
        fits && vanishes_with_a_positive_term(&products(&factors, count), &zeros)
    })
}

/// Whether an expression is not negative where the conditions hold, or positive where that is asked for.
pub(crate) fn show(expression: Sym, is_strict: bool, conditions: &[Condition]) -> bool {
    let opposite = Sym::ZERO - expression;
    let against = if is_strict { Condition::NotNegative(opposite) } else { Condition::Positive(opposite) };
    exclude_each_other(&[conditions, &natural_domain(&[expression]), &[against]].concat())
}

/// Conditions as polynomials in their letters, angles and roots.
struct Polynomials {
    factors: Vec<Factor>,
    /// Polynomials that vanish.
    zeros: Vec<Terms>,
}

impl Polynomials {
    fn of(conditions: &[Condition]) -> Self {
        let mut conditions = conditions.to_vec();
        let mut letters: Vec<Sym> = Vec::new();
        let mut place = 0;
        let mut known: Vec<(Condition, Sym)> = Vec::new();
        while let Some(&condition) = conditions.get(place) {
            place += 1;
            let Some(whole) = over_nothing(condition.expression()) else { continue };
            known.push((condition, whole));
            for leaf in whole.leaves_of().into_iter().filter(|leaf| leaf.as_constant().is_none()) {
                // an angle is told by its cosine and its sine together
                let together = match leaf.node() {
                    Node::Cos(angle) | Node::Sin(angle) => {
                        let circle = angle.circle_as_written();
                        vec![circle.cos, circle.sin]
                    }
                    _ => vec![leaf],
                };
                for leaf in together.into_iter().filter(|leaf| !letters.contains(leaf)).collect::<Vec<_>>() {
                    letters.push(leaf);
                    conditions.extend(own_conditions(leaf));
                }
            }
        }
        let zeros = letters.iter().filter_map(|&leaf| own_equality(leaf, &letters)).collect();
        let mut found = Polynomials { factors: Vec::new(), zeros };
        let mut with_sign: BTreeSet<usize> = BTreeSet::new();
        for (condition, whole) in known {
            let Some(terms) = terms(whole, &letters) else { continue };
            let of = |terms: Terms, is_strict: bool| Factor { terms, is_strict };
            match condition {
                Condition::Positive(_) => found.factors.push(of(terms, true)),
                Condition::NotNegative(_) => found.factors.push(of(terms, false)),
                Condition::NonZero(_) => found.factors.extend(product(&terms, &terms).map(|square| of(square, true))),
                Condition::Zero(_) | Condition::Equal(..) => found.zeros.push(terms),
            }
            if let (Condition::Positive(_) | Condition::NotNegative(_), Some(letter)) =
                (condition, letters.iter().position(|letter| *letter == whole))
            {
                with_sign.insert(letter);
            }
        }
        for letter in (0..letters.len()).filter(|letter| !with_sign.contains(letter)) {
            let mut exponents = vec![0; letters.len()];
            exponents[letter] = 2;
            let square = Factor { terms: Terms::from([(exponents, Rational::new(1, 1))]), is_strict: false };
            let is_known = found.factors.iter().any(|factor| factor.terms == square.terms);
            if !is_known {
                found.factors.push(square);
            }
        }
        found
    }
}

/// The polynomial that has the sign of an expression, wherever that has a value.
fn over_nothing(expression: Sym) -> Option<Sym> {
    let form = normal(expression, &Hypotheses::none()).ok()?;
    let whole = normal(form.numerator() * form.denominator(), &Hypotheses::none()).ok()?;
    Some(whole.to_sym())
}

/// The signs that a root has by itself.
fn own_conditions(leaf: Sym) -> Vec<Condition> {
    match leaf.node() {
        Node::Root(inside) => vec![Condition::NotNegative(leaf), Condition::NotNegative(inside)],
        _ => Vec::new(),
    }
}

/// The equality that ties a root to what stands below it, or the sine of an angle to its cosine. Normal forms would leave nothing of it.
fn own_equality(leaf: Sym, letters: &[Sym]) -> Option<Terms> {
    let square = |of: Sym| {
        let mut exponents = vec![0; letters.len()];
        exponents[letters.iter().position(|letter| *letter == of)?] = 2;
        Some(Terms::from([(exponents, Rational::new(1, 1))]))
    };
    match leaf.node() {
        Node::Root(inside) => {
            let form = normal(inside, &Hypotheses::none()).ok()?;
            let of = |part: Sym| terms(normal(part, &Hypotheses::none()).ok()?.to_sym(), letters);
            let below = product(&of(form.denominator())?, &square(leaf)?)?;
            Some(difference(below, &of(form.numerator())?))
        }
        Node::Sin(angle) => {
            let cosine = square(angle.circle_as_written().cos)?;
            let one = Terms::from([(vec![0; letters.len()], Rational::new(1, 1))]);
            let sine = square(leaf)?.into_iter().chain(cosine).collect();
            Some(difference(sine, &one))
        }
        _ => None,
    }
}

fn difference(mut from: Terms, other: &Terms) -> Terms {
    for (exponents, value) in other {
        *from.entry(exponents.clone()).or_insert_with(|| Rational::new(0, 1)) -= *value;
    }
    from.retain(|_, value| value.sign() != Some(0));
    from
}

/// A polynomial by the exponents of its letters; none where it is long.
fn terms(polynomial: Sym, letters: &[Sym]) -> Option<Terms> {
    let found = coefficients(polynomial, letters).ok().filter(|found| found.len() <= MOST_TERMS)?;
    let number = |value: Sym| {
        let value = normal(value, &Hypotheses::none()).ok()?.to_sym().as_constant()?;
        value.is_defined().then_some(value)
    };
    let all: Terms =
        found.into_iter().map(|(exponents, value)| Some((exponents, number(value)?))).collect::<Option<_>>()?;
    Some(all.into_iter().filter(|(_, value)| value.sign() != Some(0)).collect())
}

fn product(one: &Terms, other: &Terms) -> Option<Terms> {
    let mut all = Terms::new();
    for (exponents, value) in one {
        for (others, factor) in other {
            let powers: Vec<u32> = exponents.iter().zip(others).map(|(a, b)| a + b).collect();
            if powers.iter().sum::<u32>() > HIGHEST {
                return None;
            }
            let sum = all.entry(powers).or_insert_with(|| Rational::new(0, 1));
            *sum += *value * *factor;
        }
    }
    all.retain(|_, value| value.sign() != Some(0));
    (all.len() <= MOST_TERMS).then_some(all)
}

/// Products of up to so many factors, each of which may occur again.
fn products(factors: &[Factor], count: usize) -> Vec<Factor> {
    let mut all: Vec<Factor> = Vec::new();
    // with the place of the last factor
    let mut latest: Vec<(usize, Factor)> = factors.iter().cloned().enumerate().collect();
    for _ in 1..count {
        let longer = latest.iter().flat_map(|(last, product)| {
            (*last..factors.len()).filter_map(move |place| Some((place, product.times(&factors[place])?)))
        });
        let longer: Vec<(usize, Factor)> = longer.collect();
        all.extend(latest.into_iter().map(|(_, product)| product));
        latest = longer;
    }
    all.extend(latest.into_iter().map(|(_, product)| product));
    all
}

/// Whether a sum of products with factors that are not negative, one of them before a positive product, and of multiples of zeros vanishes
/// identically.
fn vanishes_with_a_positive_term(products: &[Factor], zeros: &[Terms]) -> bool {
    let mut known = products.iter().map(|product| &product.terms).chain(zeros).flat_map(|terms| terms.keys());
    let unit = vec![0; known.next().map_or(0, Vec::len)];
    let one = Factor { terms: Terms::from([(unit.clone(), Rational::new(1, 1))]), is_strict: true };
    // an equality times anything, with either sign
    let multipliers: BTreeSet<Vec<u32>> = products
        .iter()
        .flat_map(|product| product.terms.keys())
        .filter(|powers| powers.iter().sum::<u32>() <= 2)
        .cloned()
        .chain([unit])
        .collect();
    let multiples = zeros.iter().flat_map(|zero| {
        multipliers.iter().filter_map(|powers| product(zero, &Terms::from([(powers.clone(), Rational::new(1, 1))])))
    });
    let signed = multiples.flat_map(|terms| {
        let opposite = terms.iter().map(|(powers, value)| (powers.clone(), -*value)).collect();
        [terms, opposite].map(|terms| Factor { terms, is_strict: false })
    });
    let all: Vec<Factor> = products.iter().cloned().chain([one]).chain(signed).collect();
    let monomials: BTreeSet<&Vec<u32>> = all.iter().flat_map(|each| each.terms.keys()).collect();
    let zero = Rational::new(0, 1);
    let column = |each: &Factor| {
        let entries = monomials.iter().map(|powers| each.terms.get(*powers).copied().unwrap_or(zero));
        entries.chain([Rational::new(i64::from(each.is_strict), 1)]).collect::<Vec<_>>()
    };
    let columns: Vec<Vec<Rational>> = all.iter().map(column).collect();
    let mut target = vec![zero; monomials.len()];
    target.push(Rational::new(1, 1));
    nonnegative_combination(&columns, &target).is_some()
}
