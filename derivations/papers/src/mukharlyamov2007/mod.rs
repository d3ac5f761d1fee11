//! R. G. Mukharlyamov: control of the dynamics of systems with programmed constraints. 2007 (in Russian).
//!
//! # Overview
//! The paper's sections in order, each in one or several files of claims. The general theory is judged for systems that
//! are arbitrary to second order (`general.rs`), the analogies for a law of variable inertia
//! (`systems/variable_inertia.rs`), and section 7 for a body with a gyroscope, whose equations follow from its angular
//! momentum and its force function (`systems/variable_top.rs`, `top.rs`). The right-hand sides h, the torques, V and
//! its derivative are obtained from these by differentiation, with A(t), C(t), M(t), z_c(t) as dual numbers.
//!
//! Damaged in the available text and restored here: the index of lambda in (7); 4A for 4a in the first inequality;
//! f_3 = r - r_0 in V.
//!
//! # Key results
//! Multipliers for which violations satisfy any prescribed law exist and are given exactly by (10). The law (13) of the
//! violations is a prescription: it does not follow from the principle of d'Alembert and Lagrange. (19) has a wrong
//! symbol; h_1, h_2, h_3 and the torques of the variable mass lack terms; on the permanent rotation no torques preserve
//! the integrals (17) unless the data satisfy two conditions. (21) has a wrong sign. V has a wrong coefficient and
//! counts the field three times. The corrected V proves stability, but never asymptotic stability: the axial speed is
//! constant on every motion.

mod alphabet;
pub mod drive;
mod general;
mod section1;
mod section4;
mod section5;
mod section5_matrices;
mod section6;
mod section7_equations;
mod section7_inverse;
mod section7_lyapunov;
mod section7_moments;
mod section7_motion;
mod section7_stability;
mod top;

pub use alphabet::{dimension, letter};

use claims::Page;
use claims::Paper;
use top::TopLetters;

/// The paper.
pub const PAPER: Paper = Paper {
    key: "mukharlyamov2007",
    title: "Mukharlyamov 2007: programmed constraints",
    citation: "R. G. Mukharlyamov: Control of the dynamics of systems with programmed constraints. 2007 (in Russian)",
    summary: r"Multipliers are chosen such that violations of constraints obey an equation of their own, asymptotically stable. This is possible exactly, for geometric and kinematic constraints; the equation is a programme and does not follow from the principles of mechanics. For a symmetric body of variable mass with a gyroscope the moments are sought that keep given integrals: the printed formulas have a wrong letter, miss the rates of the moments of inertia, and fail on the permanent rotation that is studied with them. The function $V$ of the last section has a wrong coefficient and counts the Newtonian field three times; corrected it proves stability, and asymptotic stability is excluded by $\dot r=0$.",
    entries: &[
        "eq1",
        "eq2",
        "eq3",
        "eq4",
        "eq5",
        "eq6",
        "eq7",
        "eq8",
        "eq9",
        "eq10",
        "eq11",
        "eq12",
        "eq13",
        "eq14",
        "eq15",
        "eq16",
        "eq17",
        "eq18",
        "eq19",
        "eq20",
        "eq21",
        "eq22",
        "section5-instability",
        "section5-stability",
        "section6-drive",
        "section7-perturbations",
        "section7-h1",
        "section7-h2-h3",
        "section7-moments",
        "section7-lyapunov",
        "section7-stability",
    ],
    page,
};

/// All claims of the paper.
pub fn page() -> Page {
    let mut page = Page::of(PAPER.key, dimension);
    section1::claims(&mut page);
    section4::claims(&mut page);
    section5::claims(&mut page);
    section5_matrices::claims(&mut page);
    section6::claims(&mut page);
    let s = TopLetters::default();
    section7_equations::claims(&mut page, &s);
    section7_inverse::claims(&mut page, &s);
    section7_moments::claims(&mut page, &s);
    section7_motion::claims(&mut page, &s);
    section7_lyapunov::claims(&mut page, &s);
    section7_stability::claims(&mut page, &s);
    page
}
