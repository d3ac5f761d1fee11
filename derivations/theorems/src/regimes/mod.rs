//! Contact regimes with dry friction: existence and uniqueness of motion.

mod alphabet;
mod contact;
mod ladder;
mod ladder_rest;
mod rods;
mod sliders;

use claims::{Page, Paper};

/// The entry of the page in the ledger.
pub const PAPER: Paper = Paper {
    key: "regimes",
    title: "Regimes of contacts with friction",
    citation: "The workbench's own page. The questions are those of P. Painleve: Lecons sur le frottement (1895), F. Klein: Zu Painleves Kritik der Coulombschen Reibungsgesetze (1909), and P. Appell: Traite de mecanique rationnelle (the ladder).",
    summary: r"At a state, the accelerations of contacts are affine in their reactions, $a = b + W\lambda$, and Coulomb's law leaves a few regimes, each with its margins. One contact is determined under every load if and only if both slips have a positive determinant $W_{nn} \mp fW_{nt}$. Critical friction and its minimum follow in closed form: $4/3$ for the uniform rod. The uniform ladder in motion is determined under every load if and only if both coefficients are below $4/3$, while the sum of both contacts alone would allow $\sqrt2$; at rest it never is where both contacts are rough: some load lets it stay or slide up where $\tan\alpha>1/f_A$, or slide down where $\tan\alpha<f_B$, whatever the friction and the moment of inertia.",
    entries: &[
        "contact-moving",
        "contact-rest",
        "painleve-rod",
        "rod",
        "uniform-rod",
        "sliders",
        "ladder-minors",
        "ladder-moving",
        "ladder-rest",
    ],
    page,
};

/// The page with its claims.
pub fn page() -> Page {
    let mut page = Page::of(PAPER.key, alphabet::dimension);
    contact::claims(&mut page);
    rods::claims(&mut page);
    sliders::claims(&mut page);
    ladder::claims(&mut page);
    ladder_rest::claims(&mut page);
    page
}
