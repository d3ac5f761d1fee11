//! B. I. Konosevich, Yu. B. Konosevich: the gyrostat with an electric motor, mathematical model and steady motions.
//! Prikladnaya matematika i mekhanika 86 (2022), no. 6, 814-838 (in Russian).
//!
//! # Overview
//! The paper's sections in order, each in a file of claims. The left-hand side of every claim is derived from mass
//! points or energies of the bodies and from the energies of the motors; the right-hand side is that of the paper.
//!
//! Damaged in the available text and restored here: the third of the relations (6.5) (cyclic permutation of the first
//! two); `S* != 0 identically` before and in statement 6 (a formula lost before a comma); the prime of A' in "the
//! coefficient is written A'D" before (5.4); bold type of vectors throughout.
//!
//! # Key results
//! Refuted as printed: the sign of the angular velocity in statement 3D; the assertion that every direction (statement
//! 3B), every axis of the cone (3C), every solution of (7.4) and (7.7) (statements 5 and 6) is an axis of rotation; the
//! assertion that the torque of any asynchronous motor is dissipative near its working speed; the independence of the
//! relations (6.5), each of which follows from the other two. D = 0 is excluded by definition. Each refutation has an
//! exact gyrostat and a corrected statement.

mod alphabet;
mod beyond;
mod damper;
mod derivation;
pub mod gyrostats;
mod letters;
mod power;
mod relations;
mod routes;
mod section2;
mod section3;
mod section4;
mod section5;
mod section6;
mod section7_balanced;
mod section7_heavy;
mod section8;

pub use alphabet::{dimension, letter};
pub use letters::Letters;

use claims::Page;
use claims::Paper;

/// The paper.
pub const PAPER: Paper = Paper {
    key: "konosevich2022",
    title: "Konosevich & Konosevich 2022: gyrostat with an electric motor",
    citation: "B. I. Konosevich, Yu. B. Konosevich: Gyrostat with an electric motor: mathematical model and stationary motions. Prikladnaya matematika i mekhanika 86 (2022) 6, 814-838",
    summary: r"A heavy gyrostat with a fixed point, whose rotor is the rotor of an electric motor: models of the motor, equations of motion in the principal axes of the tensor $A$ (without the rotor's moment about its own axis) and of $A^*$ (with it), and the conditions of stationary motions. The equations hold as printed. The sign of the angular velocity in statement 3D is wrong; several statements say of all directions, axes or angular velocities what the original conditions (6.5) grant only to some.",
    entries: &[
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
        "eq3.1",
        "eq3.2",
        "eq3.3",
        "eq3.4",
        "eq4.1",
        "eq4.2",
        "eq4.3",
        "eq4.4",
        "eq4.5",
        "eq4.6",
        "eq4.7",
        "eq5.1",
        "eq5.2",
        "eq5.3",
        "eq5.4",
        "eq6.1",
        "eq6.2",
        "eq6.3",
        "eq6.4",
        "eq6.5",
        "eq7.1",
        "eq7.2",
        "eq7.3",
        "eq7.4",
        "eq7.5",
        "eq7.6",
        "eq7.7",
        "eq7.8",
        "eq7.9",
        "eq7.10",
        "eq7.11",
        "eq7.12",
        "eq8.1",
        "eq8.2",
        "eq8.3",
        "statement1",
        "statement2",
        "remark1",
        "remark2",
        "remark3",
        "section3-motors",
        "section5.1",
        "section5.2-det",
        "section5.2-singular",
        "section6-gamma",
        "section6-currents",
        "forms-agree",
        "statement3A",
        "statement3B",
        "statement3C",
        "statement3D",
        "statement3E",
        "section7.1-staude",
        "statement4",
        "statement5",
        "statement6",
        "statement7",
        "section7.2-degree",
        "section8.1",
        "section8.2",
    ],
    page,
};

/// All claims of the paper.
pub fn page() -> Page {
    let letters = Letters::default();
    let mut page = Page::of(PAPER.key, dimension);
    section2::claims(&mut page, &letters);
    section3::claims(&mut page, &letters);
    section4::claims(&mut page, &letters);
    section5::claims(&mut page, &letters);
    section6::claims(&mut page, &letters);
    section7_balanced::claims(&mut page, &letters);
    section7_heavy::claims(&mut page, &letters);
    section8::claims(&mut page, &letters);
    routes::claims(&mut page, &letters);
    damper::claims(&mut page, &letters);
    power::claims(&mut page, &letters);
    beyond::claims(&mut page, &letters);
    page
}
