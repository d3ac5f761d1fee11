//! All principles of mechanics give equal accelerations for every system; some of them hold only under conditions,
//! which are stated.
//!
//! # Overview
//! * [`cases`]: the systems, each a [`Case`] at a general instant;
//! * `equal`: for one system, the accelerations by every principle compared with those by Lagrange's multipliers;
//! * `combining`, `friction`: Painleve's method of combining constraints, and Gauss' principle with friction, as
//!   theorems in which masses, rows of constraints and reactions are symbols;
//! * `lost`: the term that is missing if constraints are substituted into the energy;
//! * `museum`: published errors, each with the missing term;
//! * `programmed`: constraint stabilisation (Baumgarte and generalisations), and the drift without it.
//!
//! # Key results
//! Gauss' principle with the law of friction substituted is valid if the friction is that of the extended
//! decomposition, and invalid if it is the friction of the contact. Painleve's own condition leaves the multipliers
//! unchanged if and only if the mass matrix commutes with the projector onto the virtual displacements. Substituting a
//! nonintegrable constraint into the energy loses a term, unless the momentum that multiplies the brackets is zero.

mod alphabet;
mod any;
pub mod cases;
mod combining;
mod equal;
mod friction;
mod lost;
mod museum;
mod programmed;

pub use alphabet::{dimension, letter};
pub use equal::Case;

use claims::Page;
use claims::Paper;

/// The entry of the page in the ledger.
pub const PAPER: Paper = Paper {
    key: "principles",
    title: "The principles of mechanics, equal on every system",
    citation: "This workbench's own page: theorems that its systems rest on",
    summary: r"Lagrange's equations of both kinds, Newton's with reactions, Appell's, Shulgin's and Gauss' principle as a minimisation are derived from one description of a system, and are shown equal as rational functions on nine systems: geometric and kinematic constraints, one that is nonlinear in the velocities, two that contain the time. The method of combining constraints is stated as theorems on masses, constraints and reactions: what exists, what is unique, what does not depend on friction. Gauss' principle with friction holds with the law of friction substituted for the extended choice of displacements, and fails for the contact's own force. Faults that are widely read are kept with the terms that they lose. Multipliers that lead violated constraints by a prescribed law do so exactly; that they exist follows from the principles, the law does not.",
    entries: &[
        "rod",
        "steered-rod",
        "ladder",
        "disc",
        "knife-edge",
        "governor",
        "governor-discs",
        "swing",
        "kept-speed",
        "combining",
        "gauss-friction",
        "shulgin",
        "museum",
        "programmed",
    ],
    page,
};

/// The page with its claims.
pub fn page() -> Page {
    let mut page = Page::of(PAPER.key, dimension);
    holonomic(&mut page);
    nonholonomic(&mut page);
    combining::claims(&mut page);
    friction::claims(&mut page);
    lost::claims(&mut page);
    museum::claims(&mut page);
    programmed::claims(&mut page);
    page
}

fn holonomic(page: &mut Page) {
    page.section("Every principle: geometric constraints");
    let (rod, ladder, swing) = (cases::rod(), cases::ladder(), cases::swing());
    rod.chart(page);
    rod.claims(page);
    rod.gauss(page);
    rod.shulgin(page);
    rod.energy(page);
    ladder.chart(page);
    ladder.claims(page);
    ladder.gauss(page);
    ladder.shulgin(page);
    ladder.energy(page);
    swing.chart(page);
    swing.claims(page);
    swing.gauss(page);
    swing.shulgin(page);
}

fn nonholonomic(page: &mut Page) {
    page.section("Every principle: kinematic constraints");
    let (steered, sleigh, point) = (cases::steered_rod(), cases::knife_edge(), cases::prescribed_speed_point());
    steered.chart(page);
    steered.claims(page);
    steered.gauss(page);
    steered.shulgin(page);
    steered.energy(page);
    sleigh.chart(page);
    sleigh.claims(page);
    sleigh.gauss(page);
    sleigh.shulgin(page);
    sleigh.energy(page);
    point.chart(page);
    point.claims(page);
    point.gauss(page);
    cases::disc().chart(page);
    let disc = cases::disc_in_axes();
    disc.claims(page);
    disc.gauss(page);
    disc.shulgin(page);
    disc.energy(page);
    let drum = "Every principle: the friction governor";
    let discs = "Every principle: the friction governor between two discs";
    for (section, governor) in [(drum, cases::governor()), (discs, cases::governor_between_discs())] {
        page.section(section);
        governor.chart(page);
        governor.claims(page);
        governor.gauss(page);
        governor.shulgin(page);
        governor.energy(page);
    }
}
