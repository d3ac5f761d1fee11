//! Exact expressions: the field in which equations of motion are proved, printed and turned into straight-line code.
//!
//! # Overview
//! For programs that prove or print formulas. The example proves an identity on the unit sphere and refutes another one.
//! A [`Sym`] is a `Copy` handle into a hash-consed expression graph of the current thread. It implements the
//! workbench's scalar traits: a law that is evaluated over `f64` can also be evaluated over `Sym`, which records its operations.
//!
//! An angle is a point of the unit circle, and a root is a generator with a known square; expressions are therefore fractions of
//! polynomials modulo rewriting rules ([`Hypotheses`]). It is decidable whether such a fraction vanishes:
//!
//! * [`decide`] forms a common denominator, kept as a product of known factors, and examines the numerator;
//! * [`normal`] gives the normal form, [`Tape`] the straight-line program, [`Formulas`] the steps for enclosures;
//! * [`linear`] gives the unknowns of linear equations, [`dimension`] the physical dimension;
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
//! Sines and cosines of fractions of one angle (x/2 and x/3) are reduced to those of a common part; no other relation between transcendental
//! functions is used. Rules rewrite powers of single symbols; give any other relation to [`decide_modulo`], with its cofactor.

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
    decide_modulo, identified, normal,
};
pub use sym::symbols;
pub use tape::{Algebraic, Language, Operation, Program, Propagation, Register, Source, Statements, Tape, Untapeable};
