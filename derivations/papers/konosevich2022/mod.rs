//! B. I. Konosevich, Yu. B. Konosevich: the gyrostat with an electric motor, mathematical model and stationary motions.
//! Prikladnaya matematika i mekhanika 86 (2022), no. 6, 814-838 (in Russian).
//!
//! # Overview
//! The paper's sections in order, each a file of claims. The left side of every claim is derived from the bodies'
//! mass points or energies and from the motors' energies; the right side is the paper's.
//!
//! Damaged in the text at hand, and restored here: the third of the relations (6.5) (cyclic permutation of the first
//! two); `S* != 0 identically` in statements 5 and 6 (an inequality lost between commas); the prime of A' in "the
//! coefficient is written A'D" before (5.4); bold type of vectors throughout.
//!
//! # Key results
//! Refuted as printed: the sign of the angular velocity in statement 3D; that every direction (statement 3B), every
//! axis of the cone (3C), every solution of (7.4) and (7.7) (statements 5 and 6) is an axis of rotation; that the moment of
//! any asynchronous motor is dissipative about its working speed; that each of the relations (6.5) follows from the
//! other two; that D = 0 is excluded by definition. Each comes with an exact gyrostat and with what holds instead.

mod beyond;
mod damper;
pub mod gyrostats;
mod letters;
mod section2;
mod section3;
mod section4;
mod section5;
mod section6;
mod section7;
mod section8;

pub use letters::{Letters, dimension};

use claims::Page;

/// The page of the paper.
pub fn page() -> Page {
    let letters = Letters::new();
    let mut page = Page::of(
        "konosevich2022",
        "Konosevich, Konosevich 2022: gyrostat with an electric motor, model and stationary motions",
        dimension,
    );
    section2::claims(&mut page, &letters);
    section3::claims(&mut page, &letters);
    section4::claims(&mut page, &letters);
    section5::claims(&mut page, &letters);
    section6::claims(&mut page, &letters);
    section7::claims(&mut page, &letters);
    section8::claims(&mut page, &letters);
    damper::claims(&mut page, &letters);
    beyond::claims(&mut page, &letters);
    page
}
