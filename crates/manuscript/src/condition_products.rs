//! Proofs by products of conditions. If a sum of products of nonnegative expressions vanishes identically although one product is positive, no point
//! satisfies all conditions.

use crate::natural_domain::natural_domain;
use crate::polynomial_terms::{Terms, difference, product, terms};
use algebra::linear::nonnegative_combination;
use claims::Condition;
use claims::certificate::{self, Relations};
use field::Rational;
use std::collections::BTreeSet;
use symbolic::{Hypotheses, Node, Sym, normal};

/// The largest number of factors of a product.
const MOST_FACTORS: usize = 3;

/// The largest number of conditions with which products of two factors are formed; [`MOST_FOR_THREE`] for three factors.
const MOST_FOR_TWO: usize = 14;
const MOST_FOR_THREE: usize = 9;

/// The origin of a nonnegative factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Origin {
    /// The expression of the condition with this index.
    Condition(usize),
    /// The square of the expression of the condition with this index.
    Square(usize),
    /// A square root.
    Root(Sym),
    /// The square of a letter, a root, a cosine or a sine.
    SquareOf(Sym),
}

/// A positive number times nonnegative factors.
pub(crate) struct Product {
    pub number: Rational,
    pub of: Vec<Origin>,
}

impl Product {
    /// The product in the form of certificates, in which the indices of conditions begin at `before`.
    pub fn told(&self, before: usize, relations: &mut Relations) -> certificate::Product {
        let number = relations.recorder.place(Sym::constant(self.number));
        let mut told = certificate::Product { number, ..certificate::Product::default() };
        for origin in &self.of {
            match *origin {
                Origin::Condition(place) => told.of.push(before + place),
                Origin::Square(place) => told.of.extend([before + place; 2]),
                Origin::Root(root) => told.roots.push(relations.recorder.place(root)),
                Origin::SquareOf(letter) => told.squares.push(relations.recorder.place(letter)),
            }
        }
        told
    }
}

/// A polynomial that is nonnegative where the conditions hold.
#[derive(Clone)]
struct Factor {
    terms: Terms,
    /// Whether the polynomial is positive there.
    is_strict: bool,
    of: Vec<Origin>,
    /// The ratio of the polynomial to the product of its origins; `None` where the denominator of a condition contains letters.
    scale: Option<Rational>,
}

impl Factor {
    fn times(&self, other: &Self) -> Option<Self> {
        let terms = product(&self.terms, &other.terms)?;
        let scale = self.scale.zip(other.scale).map(|(a, b)| a * b);
        let of = [&self.of[..], &other.of].concat();
        Some(Factor { terms, is_strict: self.is_strict && other.is_strict, of, scale })
    }
}

/// Whether products of the conditions prove that no point satisfies all of them.
pub(crate) fn exclude_each_other(conditions: &[Condition]) -> bool {
    contradiction(conditions).is_some()
}

/// Products, one of them positive where all conditions hold, whose sum vanishes identically; `None` if none are found.
fn contradiction(conditions: &[Condition]) -> Option<Vec<(Rational, Factor)>> {
    let Polynomials { factors, zeros } = Polynomials::of(conditions);
    (1..=MOST_FACTORS).find_map(|count| {
        let fits = match count {
            1 => true,
            2 => factors.len() <= MOST_FOR_TWO,
            _ => factors.len() <= MOST_FOR_THREE,
        };
        if fits { sum_with_a_positive_term(products(&factors, count), &zeros) } else { None }
    })
}

/// Whether products of the conditions prove that an expression is nonnegative (positive if `is_strict`) where they hold.
pub(crate) fn show(expression: Sym, is_strict: bool, conditions: &[Condition]) -> bool {
    exclude_each_other(&with_opposite(expression, is_strict, conditions))
}

/// The products of such a proof, and the conditions to which their indices refer; the last condition is the negated conclusion.
pub(crate) fn proof(
    expression: Sym,
    is_strict: bool,
    conditions: &[Condition],
) -> Option<(Vec<Condition>, Vec<Product>)> {
    let all = with_opposite(expression, is_strict, conditions);
    let found = contradiction(&all)?.into_iter();
    let told = |(number, Factor { of, scale, .. })| Some(Product { number: number * scale?, of });
    let products = found.map(told).collect::<Option<Vec<Product>>>()?;
    Some((all, products))
}

fn with_opposite(expression: Sym, is_strict: bool, conditions: &[Condition]) -> Vec<Condition> {
    let opposite = Sym::ZERO - expression;
    let against = if is_strict { Condition::NotNegative(opposite) } else { Condition::Positive(opposite) };
    [conditions, &natural_domain(&[expression]), &[against]].concat()
}

/// The conditions as polynomials in their letters, cosines, sines and roots.
struct Polynomials {
    factors: Vec<Factor>,
    /// Polynomials that vanish.
    zeros: Vec<Terms>,
}

impl Polynomials {
    fn of(conditions: &[Condition]) -> Self {
        let mut open: Vec<(Condition, Origin)> =
            conditions.iter().enumerate().map(|(place, condition)| (*condition, Origin::Condition(place))).collect();
        let mut letters: Vec<Sym> = Vec::new();
        let mut place = 0;
        let mut known: Vec<(Condition, Origin, Whole)> = Vec::new();
        while let Some(&(condition, origin)) = open.get(place) {
            place += 1;
            let Some(whole) = Whole::of(condition.expression()) else { continue };
            for leaf in whole.polynomial.leaves_of().into_iter().filter(|leaf| leaf.as_constant().is_none()) {
                // the cosine and the sine of an angle are both added
                let together = match leaf.node() {
                    Node::Cos(angle) | Node::Sin(angle) => {
                        let circle = angle.circle_as_written();
                        vec![circle.cos, circle.sin]
                    }
                    _ => vec![leaf],
                };
                for leaf in together.into_iter().filter(|leaf| !letters.contains(leaf)).collect::<Vec<_>>() {
                    letters.push(leaf);
                    if let Node::Root(inside) = leaf.node() {
                        open.push((Condition::NotNegative(leaf), Origin::Root(leaf)));
                        open.push((Condition::NotNegative(inside), Origin::SquareOf(leaf)));
                    }
                }
            }
            known.push((condition, origin, whole));
        }
        let zeros = letters.iter().filter_map(|&leaf| own_equality(leaf, &letters)).collect();
        let mut found = Polynomials { factors: Vec::new(), zeros };
        let mut with_sign: BTreeSet<usize> = BTreeSet::new();
        for (condition, origin, Whole { polynomial, scale }) in known {
            let Some(terms) = terms(polynomial, &letters) else { continue };
            let of = |terms: Terms, is_strict: bool| Factor { terms, is_strict, of: vec![origin], scale };
            match (condition, origin) {
                (Condition::Positive(_), _) => found.factors.push(of(terms, true)),
                (Condition::NotNegative(_), _) => found.factors.push(of(terms, false)),
                (Condition::NonZero(_), Origin::Condition(place)) => {
                    let scale = scale.map(|scale| scale * scale);
                    let square = product(&terms, &terms);
                    let of = vec![Origin::Square(place)];
                    found.factors.extend(square.map(|terms| Factor { terms, is_strict: true, of, scale }));
                }
                (Condition::Zero(_) | Condition::Equal(..), _) => found.zeros.push(terms),
                _ => {}
            }
            if let (Condition::Positive(_) | Condition::NotNegative(_), Some(letter)) =
                (condition, letters.iter().position(|letter| *letter == polynomial))
            {
                with_sign.insert(letter);
            }
        }
        for letter in (0..letters.len()).filter(|letter| !with_sign.contains(letter)) {
            let mut exponents = vec![0; letters.len()];
            exponents[letter] = 2;
            let one = Rational::new(1, 1);
            let terms = Terms::from([(exponents, one)]);
            if found.factors.iter().all(|factor| factor.terms != terms) {
                let of = vec![Origin::SquareOf(letters[letter])];
                found.factors.push(Factor { terms, is_strict: false, of, scale: Some(one) });
            }
        }
        found
    }
}

/// A polynomial with the sign of an expression, wherever the expression has a value.
struct Whole {
    polynomial: Sym,
    /// The ratio of the polynomial to the expression; `None` where the denominator contains letters.
    scale: Option<Rational>,
}

impl Whole {
    fn of(expression: Sym) -> Option<Self> {
        let form = normal(expression, &Hypotheses::none()).ok()?;
        let (above, below) = (form.numerator(), form.denominator());
        let polynomial = normal(above * below, &Hypotheses::none()).ok()?.to_sym();
        Some(Whole { polynomial, scale: below.as_constant().map(|below| below * below) })
    }
}

/// The relation root² - radicand = 0, or cos² + sin² - 1 = 0, as a polynomial. It is built directly, since its normal form is zero.
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

/// All products of up to `count` factors, with repetition.
fn products(factors: &[Factor], count: usize) -> Vec<Factor> {
    let mut all: Vec<Factor> = Vec::new();
    // each product with the index of its last factor
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

/// Positive multiples of products, one of them a positive product, whose sum with multiples of `zeros` vanishes identically; `None` if none exist.
fn sum_with_a_positive_term(products: Vec<Factor>, zeros: &[Terms]) -> Option<Vec<(Rational, Factor)>> {
    let mut known = products.iter().map(|product| &product.terms).chain(zeros).flat_map(|terms| terms.keys());
    let unit = vec![0; known.next().map_or(0, Vec::len)];
    let (zero, one) = (Rational::new(0, 1), Rational::new(1, 1));
    let plain = |terms: Terms| Factor { terms, is_strict: false, of: Vec::new(), scale: Some(one) };
    let number = Factor { is_strict: true, ..plain(Terms::from([(unit.clone(), one)])) };
    // an equality may be multiplied by any monomial, with either sign
    let multipliers: BTreeSet<Vec<u32>> = products
        .iter()
        .flat_map(|product| product.terms.keys())
        .filter(|powers| powers.iter().sum::<u32>() <= 2)
        .cloned()
        .chain([unit])
        .collect();
    let multiples = zeros
        .iter()
        .flat_map(|zero| multipliers.iter().filter_map(|powers| product(zero, &Terms::from([(powers.clone(), one)]))));
    let signed = multiples.flat_map(|terms| {
        let opposite = terms.iter().map(|(powers, value)| (powers.clone(), -*value)).collect();
        [terms, opposite].map(plain)
    });
    let signed: Vec<Factor> = signed.collect();
    let all: Vec<Factor> = products.into_iter().chain([number]).chain(signed.iter().cloned()).collect();
    let monomials: BTreeSet<&Vec<u32>> = all.iter().flat_map(|each| each.terms.keys()).collect();
    let column = |each: &Factor| {
        let entries = monomials.iter().map(|powers| each.terms.get(*powers).copied().unwrap_or(zero));
        entries.chain([Rational::new(i64::from(each.is_strict), 1)]).collect::<Vec<_>>()
    };
    let columns: Vec<Vec<Rational>> = all.iter().map(column).collect();
    let mut target = vec![zero; monomials.len()];
    target.push(one);
    let numbers = nonnegative_combination(&columns, &target)?;
    let own = all.len() - signed.len();
    let told = numbers.into_iter().zip(all).take(own).filter(|(number, _)| number.sign() == Some(1));
    Some(told.collect())
}
