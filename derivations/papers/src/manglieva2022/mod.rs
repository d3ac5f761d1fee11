//! Zh. Kh. Manglieva, Zh. Kh. Beknazarov: on the motion of systems that contain nonholonomic nonideal constraints.
//! Novateur Publication, 2022 (a monograph, in Russian).
//!
//! # Overview
//! The monograph's paragraphs in order, each in one or several files of claims. The left-hand side of every claim is
//! derived from the rod, the steered rod, the ladder and the governors in `systems/`, given by masses, constraints,
//! contacts and charts. The right-hand side is that of the paper. Where the paper treats an arbitrary system, the
//! claims are proved for constraints that are arbitrary to second order, in three or four coordinates with masses
//! (`general.rs`).
//!
//! The coordinates y of sections 1.1 and 1.3 (task 1) point downwards: a supporting floor makes R_y and lambda
//! negative. The signs of the paper's laws of friction belong to the opposite axis.
//!
//! The available text is damaged in places. A formula whose symbols are all meaningful is judged as printed, including
//! lost dots, factors and signs, and its correction restores them: (2.18), (3.3), (3.14), (3.25). A symbol without
//! meaning in its place is restored: m2 for m1 in (1.4); the index of y1 in (1.24); m2 in the weight before (1.94); g^2
//! for 2g and the index of alpha_0 in (1.109); delta x for the printed delta x' in (2.3); J3 for J2 in (3.28); u1 for
//! n1 in (3.36). Where the text allows two interpretations both are given: the side from which a guide pushes, the sign
//! of the rim's force. Every affected row states this in its `reading`.
//!
//! # Key results
//! With the extended method the constraint forces are indeed independent of friction, for all masses and also for
//! nonholonomic systems, and Gauss' principle holds even if friction depends on the accelerations. The normal reactions
//! of rough curves are different from these forces, and do depend on friction. The laws (1.22), (1.23), (1.40), (1.82)
//! give friction in the direction of the velocity on a floor. Lagrange's equation of the steered rod, (1.95), (1.96),
//! (1.99), loses the friction at its second point, while (1.98) is correct. The ladder leaves the wall at cos alpha =
//! 2/3 cos alpha_0, not at twice that value.
//!
//! For the friction governors of chapter 3 the programme and its quadrature are correct. Friction has the wrong sign in
//! the force that maintains the speed, and the second governor moves in the opposite direction. Two of the six
//! coefficients of the rim's characteristic polynomial are correct, if the sign of the rim's force is that in Z; (3.17)
//! has the other sign, with which no motion with positive data is stable at a prescribed speed. The condition of
//! controllability is J2 M1/R != n rho M2, not rho' != 0. Riccati's equation needs a final condition.

mod alphabet;
mod alphabet3;
mod elastic;
mod general;
mod governor;
mod ladder;
mod released;
mod rod;
mod section11_extended;
mod section11_lagrange;
mod section11_law;
mod section11_painleve;
mod section12_lagrange;
mod section12_redundant;
mod section13_friction;
mod section13_ladder;
mod section13_lagrange;
mod section13_motion;
mod section13_quadrature;
mod section13_rest;
mod section13_smooth;
mod section21;
mod section22;
mod section22_law;
mod section31_elastic;
mod section31_equations;
mod section31_governor2;
mod section31_hurwitz;
mod section31_programme;
mod section31_stability;
mod section32_bellman;
mod section32_control;
mod section32_released;
mod steered;
mod work;

pub use alphabet::{dimension, letter};

use claims::Page;
use claims::Paper;
use elastic::ElasticLetters;
use governor::GovernorLetters;
use ladder::LadderLetters;
use released::ReleasedLetters;
use rod::RodLetters;
use steered::SteeredLetters;

/// The paper.
pub const PAPER: Paper = Paper {
    key: "manglieva2022",
    title: "Manglieva & Beknazarov 2022: constraints with friction",
    citation: "Zh. Kh. Manglieva, Zh. Kh. Beknazarov: On the motion of systems that contain nonholonomic nonideal constraints. Novateur Publication, 2022 (in Russian)",
    summary: r"Systems with friction after Painlevé: reactions are split into forces of constraint and friction by combining constraints, with virtual displacements proportional to the forces of friction (Painlevé) or to these over the masses (extended). The extended method does make the forces of constraint independent of friction, for nonholonomic systems too, and Gauss' principle holds with it. The examples are printed with many errors: in the laws of friction the sign belongs to an axis upwards while $y$ points downwards, Lagrange's equation of the steered rod misses the friction at its second point, the quadrature of the ladder has the wrong exponent and its condition of detachment the wrong factor. For the friction governors of chapter 3 the programme of the wheel and its quadrature are right; the force that keeps the speed has friction with the wrong sign, the second governor moves the other way, the rim's force has one sign in (3.17) and the other in $Z$, the condition of controllability is $J_2M_1/R\ne n\rho_0M_2$, and Riccati's equation is given a wrong end.",
    entries: &[
        "eq1.1",
        "eq1.2",
        "eq1.3",
        "eq1.4",
        "eq1.5",
        "eq1.6",
        "eq1.7",
        "eq1.8",
        "eq1.9",
        "eq1.10",
        "eq1.11",
        "eq1.12",
        "eq1.13",
        "eq1.14",
        "eq1.15",
        "eq1.16",
        "eq1.17",
        "eq1.18",
        "eq1.19",
        "eq1.20",
        "eq1.21",
        "eq1.22",
        "eq1.23",
        "eq1.24",
        "eq1.25",
        "eq1.26",
        "eq1.27",
        "eq1.28",
        "eq1.29",
        "eq1.30",
        "eq1.31",
        "eq1.32",
        "eq1.33",
        "eq1.34",
        "eq1.35",
        "eq1.36",
        "eq1.37",
        "eq1.38",
        "eq1.39",
        "eq1.40",
        "eq1.41",
        "eq1.42",
        "eq1.43",
        "eq1.44",
        "eq1.45",
        "eq1.46",
        "eq1.47",
        "eq1.48",
        "eq1.49",
        "eq1.50",
        "eq1.51",
        "eq1.52",
        "eq1.53",
        "eq1.54",
        "eq1.55",
        "eq1.56",
        "eq1.57",
        "eq1.58",
        "eq1.59",
        "eq1.60",
        "eq1.61",
        "eq1.62",
        "eq1.63",
        "eq1.64",
        "eq1.65",
        "eq1.66",
        "eq1.67",
        "eq1.68",
        "eq1.69",
        "eq1.70",
        "eq1.71",
        "eq1.72",
        "eq1.73",
        "eq1.74",
        "eq1.75",
        "eq1.76",
        "eq1.77",
        "eq1.78",
        "eq1.79",
        "eq1.80",
        "eq1.81",
        "eq1.82",
        "eq1.83",
        "eq1.84",
        "eq1.85",
        "eq1.86",
        "eq1.87",
        "eq1.88",
        "eq1.89",
        "eq1.90",
        "eq1.91",
        "eq1.92",
        "eq1.93",
        "eq1.94",
        "eq1.95",
        "eq1.96",
        "eq1.97",
        "eq1.98",
        "eq1.99",
        "eq1.100",
        "eq1.101",
        "eq1.102",
        "eq1.103",
        "eq1.104",
        "eq1.105",
        "eq1.106",
        "eq1.107",
        "eq1.108",
        "eq1.109",
        "eq1.110",
        "eq2.1",
        "eq2.2",
        "eq2.3",
        "eq2.4",
        "eq2.5",
        "eq2.6",
        "eq2.7",
        "eq2.8",
        "eq2.9",
        "eq2.10",
        "eq2.11",
        "eq2.12",
        "eq2.13",
        "eq2.14",
        "eq2.15",
        "eq2.16",
        "eq2.17",
        "eq2.18",
        "eq2.19",
        "eq2.20",
        "eq2.21",
        "eq2.22",
        "eq3.1",
        "eq3.2",
        "eq3.3",
        "eq3.4",
        "eq3.5",
        "eq3.6",
        "eq3.7",
        "eq3.8",
        "eq3.9",
        "eq3.10",
        "eq3.11",
        "eq3.12",
        "eq3.13",
        "eq3.14",
        "eq3.15",
        "eq3.16",
        "eq3.17",
        "eq3.18",
        "eq3.19",
        "eq3.20",
        "eq3.21",
        "eq3.22",
        "eq3.23",
        "eq3.24",
        "eq3.25",
        "eq3.26",
        "eq3.27",
        "eq3.28",
        "eq3.29",
        "eq3.30",
        "eq3.31",
        "eq3.32",
        "eq3.33",
        "eq3.34",
        "eq3.35",
        "eq3.36",
        "eq3.37",
        "section1.1-painleve",
        "section1.1-extended",
        "section1.3-integral",
        "section1.3-static",
        "section1.3-ladder-quadrature",
        "section1.3-ladder-ideal",
        "section2.1-independence",
        "section2.2-gauss",
        "section3.1-control-force",
        "section3.1-persidskii",
        "section3.1-governor2",
        "section3.1-quintic",
        "section3.1-hurwitz",
        "section3.2-controllability",
        "section3.2-bellman",
    ],
    page,
};

/// All claims of the paper.
pub fn page() -> Page {
    let mut page = Page::of(PAPER.key, dimension);
    let rod = RodLetters::default();
    section11_painleve::claims(&mut page, &rod);
    section11_extended::claims(&mut page, &rod);
    section11_law::claims(&mut page, &rod);
    section11_lagrange::claims(&mut page, &rod);
    section12_lagrange::claims(&mut page);
    section12_redundant::claims(&mut page);
    let steered = SteeredLetters::default();
    section13_friction::claims(&mut page, &steered);
    section13_motion::claims(&mut page, &steered);
    section13_lagrange::claims(&mut page, &steered);
    section13_rest::claims(&mut page, &steered);
    let ladder = LadderLetters::default();
    section13_ladder::claims(&mut page, &ladder);
    section13_quadrature::claims(&mut page, &ladder);
    section13_smooth::claims(&mut page, &ladder);
    section21::claims(&mut page);
    section22::claims(&mut page);
    section22_law::claims(&mut page, &rod);
    chapter3(&mut page);
    page
}

/// The claims on the friction governors.
fn chapter3(page: &mut Page) {
    let drum = GovernorLetters::with_drum();
    section31_equations::claims(page, &drum);
    section31_programme::claims(page, &drum);
    section31_governor2::claims(page, &GovernorLetters::with_discs());
    let elastic = ElasticLetters::default();
    section31_elastic::claims(page, &elastic);
    section31_stability::claims(page, &elastic);
    let released = ReleasedLetters::default();
    section32_released::claims(page, &released);
    section32_control::claims(page, &released);
    section32_bellman::claims(page, &released);
}
