//! A repeated statement of the paper: the work of reactions with friction "differs from zero on every virtual
//! displacement".

use super::alphabet::{exact, indexed};
use super::general::dot;
use claims::{Condition, Page};
use symbolic::Sym;

use Condition::{NonZero, Positive, Zero};

/// Claims that refute the statement for every displacement, and its correction, for one constraint in three
/// coordinates: a point on a rough plane x1 = 0, with friction along x2, displaced along x3.
pub fn nowhere_zero(page: &mut Page, entry: &'static str, says: &str) {
    let (gradient, reaction, displacement): ([Sym; 3], [Sym; 3], [Sym; 3]) =
        (indexed("f#"), indexed("R#"), indexed("δx#"));
    let masses: [Sym; 3] = indexed("m#");
    let weighted = std::array::from_fn(|i| reaction[i] / masses[i]);
    let positive = masses.map(Positive);
    page.claim(entry, "every-displacement", format!("As printed in ({}), {says} for every virtual displacement", entry.trim_start_matches("eq")))
        .given(positive)
        .given([
            Zero(dot(gradient, displacement)),
            Zero(dot(gradient, weighted)),
            NonZero(dot(reaction, reaction)),
            NonZero(dot(displacement, displacement)),
        ])
        .why("With two degrees of freedom or more the work, linear in the displacement, vanishes on some displacements, as for a point on a rough plane that is moved across its friction.")
        .refuted(
            [NonZero(dot(reaction, displacement))],
            exact([
                ("m1", 1, 1), ("m2", 1, 1), ("m3", 1, 1), ("f1", 1, 1), ("f2", 0, 1), ("f3", 0, 1),
                ("R1", 0, 1), ("R2", 1, 1), ("R3", 0, 1), ("δx1", 0, 1), ("δx2", 0, 1), ("δx3", 1, 1),
            ]),
        );
    let place = entry.trim_start_matches("eq");
    own_displacement(page, entry, &format!("In the place of ({place}), the work of friction differs from zero"));
    page.correct();
}

/// Claims on the work for the displacement R^tau / m: the sum of (R^tau)^2 / m.
pub fn own_displacement(page: &mut Page, entry: &'static str, says: &str) {
    let (masses, reaction): ([Sym; 3], [Sym; 3]) = (indexed("m#"), indexed("R#"));
    let displaced = std::array::from_fn(|i| reaction[i] / masses[i]);
    let on = r"on the displacement $\delta x_\gamma=R^\tau_\gamma\delta t/m_\gamma$ that friction itself points to, where it is positive";
    page.claim(entry, "own-displacement", format!("{says} {on}"))
        .given(masses.map(Positive))
        .given([NonZero(dot(reaction, reaction))])
        .by_signs([Positive(dot(reaction, displaced))]);
}
