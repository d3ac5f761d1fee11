//! Exact expressions: equations of motion are proved, printed and compiled in this field.
//!
//! # Overview
//! The crate is for programs that prove or print formulas. The example proves an identity on the unit sphere and refutes another one.
//! A [`Sym`] is a `Copy` handle into a hash-consed expression graph of the current thread. It implements the
//! workbench's scalar traits: a law that is evaluated over `f64` can also be evaluated over `Sym`, which records its operations.
//!
//! Angles occur through their cosine and sine, and a root is a generator with a known square. Expressions are therefore quotients of
//! polynomials modulo rewriting rules ([`Hypotheses`]), and it is decidable whether such a quotient vanishes:
//!
//! * [`decide`] forms a common denominator, stored as a product of known factors, and examines the numerator;
//! * [`normal`] computes the normal form, [`Tape`] a straight-line program, [`Formulas`] a list of operations for interval enclosures;
//! * [`linear`] solves linear equations, [`dimension`] computes the physical dimension;
//! * [`parse`] reads the printed notation.
//!
//! ```
//! use field::{Analytic, Scalar};
//! use dalembert_symbolic::{Decision, Hypotheses, Sym, normal, symbols};
//!
//! let [l1, l2, l3, x] = symbols(["l1", "l2", "l3", "x"]);
//! let unit = Hypotheses::none().unit_vector([l1, l2, l3]);
//! assert!(unit.equal((l1 * l1 + l2 * l2) / (Sym::int(1) - l3), Sym::int(1) + l3).is_zero());
//!
//! let Decision::NonZero(witness) = unit.equal(l1 + l2, l3) else { unreachable!() };
//! assert_eq!(witness.to_string(), "-1/11 at l1 = 6/11, l2 = 2/11, l3 = 9/11");
//!
//! let half = (x / Sym::int(2)).circle();
//! let form = normal(half.sin * half.cos / half.cos.powi(3), &Hypotheses::none()).unwrap();
//! assert_eq!(form.to_string(), "sin(x/2)/cos(x/2)^2");
//! ```
//!
//! # Limits
//! Exponents up to 127, 160 generators, a million terms; beyond these limits the decision is [`Decision::GaveUp`].
//! Sines and cosines of fractions of one angle (x/2 and x/3) are reduced to those of a common part (x/6). No other relation between transcendental
//! functions is used. Rules rewrite powers of single symbols; pass any other relation, with its cofactor, to [`decide_modulo`].

mod analytic;
mod angles;
mod calculus;
mod coefficients;
mod differential;
mod dimension;
mod evaluate;
mod exact_turns;
mod formulas;
mod fraction;
mod graph;
pub mod linear;
mod operators;
mod parse;
mod print;
mod prove;
mod sym;
mod tape;

pub use analytic::HIGHEST_MULTIPLE;
pub use angles::{substitute_in_angles, with_sums_of_angles};
pub use calculus::{Derivation, substitute_all};
pub use coefficients::{NotPolynomial, coefficients, degree, univariate};
pub use differential::{Differential, Weighted};
pub use dimension::{Dimension, Mismatch, dimension};
pub use evaluate::Unbound;
pub use formulas::Formulas;
pub use fraction::Fraction;
pub use graph::{Node, Sym, apart};
pub use parse::{NotExpression, Reason, Vocabulary, parse, parse_in};
pub use prove::{
    Decision, Hypotheses, Identity, IdentityTest, NormalForm, NotNormal, Proof, Refused, Witness, decide,
    decide_modulo, differs_from_zero, identified, normal,
};
pub use sym::symbols;
pub use tape::{Algebraic, Language, Operation, Program, Propagation, Register, Source, Statements, Tape, Untapeable};
