//! Constraint stabilisation with discrete time steps: the stability region of the gains for each method, and a
//! stabilised drive.

mod alphabet;
mod drive;
mod floor;
mod gains;

use claims::{Page, Paper};

/// The entry of the page in the ledger.
pub const PAPER: Paper = Paper {
    key: "stabilisation",
    title: "Stabilised constraints in steps",
    citation: "The workbench's own page. The method is that of J. Baumgarte: Stabilization of constraints and integrals of motion in dynamical systems (1972); the drive is that of R. G. Mukharlyamov: Control of the dynamics of systems with programmed constraints (2007), section 6, which prints no equations.",
    summary: r"A stabilised constraint obeys $\ddot y+b\dot y+ky=0$. What a method makes of it depends on $\beta=hb$ and $\kappa=h^2k$ alone, and the gains for which the discrete error decays are a region of that plane, exactly: a triangle for Euler, three polynomials for the classical Runge-Kutta method, the whole quadrant for backward Euler and the implicit midpoint rule. Euler and the midpoint rule have gains with which an error is gone after two steps, Runge and Kutta's after one. What remains is the method's own error, which no gains remove.",
    entries: &["inside", "euler", "runge-kutta", "backward-euler", "midpoint", "kinematic", "best", "floor"],
    page,
};

/// The page with its claims.
pub fn page() -> Page {
    let mut page = Page::of(PAPER.key, alphabet::dimension);
    gains::claims(&mut page);
    floor::claims(&mut page);
    drive::claims(&mut page);
    page
}
