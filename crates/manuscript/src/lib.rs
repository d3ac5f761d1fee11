//! Judgement of a paper in a text file: the letters of its formulas with their meanings in a model, its claims as printed, and a finding on each claim.
//!
//! # Overview
//! This crate is for readers and authors who check the equations of a paper. The example below refutes and corrects a wrong sign.
//!
//! * [`PaperText`]: a file with `[letters]` and `[[claim]]`, and with the tables of its system or the name of the system's file;
//! * `letters`: the meaning of each letter in the symbols of the model;
//! * `motion`: the equations that hold along every motion: accelerations, multipliers, constraints, hypotheses;
//! * [`PaperText::judge`]: a [`Finding`] for each claim, with the derived side from the model; [`PaperText::findings`] also accepts papers with
//!   formulas that cannot be read;
//! * [`Correction`]: the smallest edit with which a refuted formula is proved;
//! * [`PeerEquations`]: equations of motion from another program, which are compared with those of the model.
//!
//! | kind of claim | statement |
//! |---|---|
//! | `equation of motion` | the printed equation holds along every motion: it is a combination of the model's equations |
//! | `linearised equation` | the printed equation holds to first order about a motion on which given letters are constant |
//! | `formula` | the printed value of a quantity is correct, identically or along every motion |
//! | `identity` | both sides are equal for all positions, speeds and accelerations that the constraints allow |
//! | `integral of motion` | the time derivative of the printed expression is zero along every motion |
//! | `inequality` | the inequality holds wherever its formula has a value |
//! | `equivalence` | two conditions imply each other |
//! | `steady motion` | the printed condition characterises the motions on which the listed letters are constant |
//! | `stability` | a steady motion is stable if and only if the inequality holds |
//! | `number` | the value of a quantity for given data agrees with every printed digit, by enclosures |
//!
//! # Example
//! ```
//! use dalembert_manuscript::PaperText;
//!
//! let text = r#"
//! title = "A pendulum in a textbook"
//! gravity = "-g*N.y"
//! parameters = { m = "kg", l = "m", g = "m/s^2" }
//! coordinates = { theta = "rad" }
//! bodies = { bob = { centre = "O + l*(sin(theta)*N.x - cos(theta)*N.y)", mass = "m" } }
//! letters = { 'l' = "l", 'g' = "g", '\theta' = "theta" }
//! [[claim]]
//! equation = "eq1"
//! kind = "equation of motion"
//! formula = 'l \ddot\theta - g \sin\theta = 0'
//! "#;
//! let paper = PaperText::parse("textbook.toml".as_ref(), text.to_owned()).expect("it is a paper");
//! let findings = paper.judge().expect("its formula is read");
//! assert_eq!(findings[0].judged.verdict, claims::Verdict::Refuted);
//! assert!(findings[0].corrections.iter().any(|one| one.formula == r"l \ddot\theta + g \sin\theta = 0"));
//! ```

mod admissible;
mod base_motion;
mod case_findings;
mod cases;
mod certificate;
mod change;
mod circle_forms;
mod circle_signs;
mod claim_text;
mod combination;
mod condition_products;
mod conditions;
mod consequence;
mod constraint_circles;
mod correction;
mod determinant;
mod dimensions;
mod display;
mod domains;
mod drawn_numbers;
mod energy_form;
mod equalities;
mod equation;
mod exact_points;
mod extent;
mod feedback;
mod finding;
mod half_turn;
mod half_turn_bounds;
mod ideal_membership;
mod implications;
mod inequalities;
mod inertia;
mod integrals;
mod judgement;
mod letter_forms;
mod letters;
mod line_signs;
mod linear_equations;
mod linear_motion;
mod linearisation;
mod lines;
mod lost_divisors;
mod minimum_certificate;
mod monotone_functions;
mod motion;
mod natural_domain;
mod numbers;
mod paper_findings;
mod paper_text;
mod passage;
mod peer_equations;
mod polynomial_factors;
mod polynomial_signs;
mod polynomial_terms;
mod position_letters;
mod premises;
mod presuppositions;
mod printed_decimal;
mod real_signs;
mod refutation;
mod resting_equations;
mod shortfall;
mod signs;
mod square_sums;
mod stability;
mod stability_region;
mod steadiness;
mod steady_conditions;
mod steady_motion;
mod steady_refutation;
mod turned_points;
mod verdict;

pub use change::{Change, Correction, EditKind, Search};
pub use claim_text::{ClaimText, Kind};
pub use correction::{LineCorrection, NotRead, line_corrections, theorem_corrections};
pub use finding::{Finding, Sides};
pub use paper_findings::{PaperFindings, UnjudgedClaim};
pub use paper_text::{PaperText, is_paper};
pub use peer_equations::{PeerEquation, PeerEquations, PeerFinding, TermDifference};
