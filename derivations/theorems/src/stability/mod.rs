//! The stability of steady motions: structural zero eigenvalues, characteristic polynomials, common properties of
//! motors, closed forms.

mod alphabet;
mod closed;
mod families;
mod foundations;
mod letters;
mod motors;

use claims::{Page, Paper};
use papers::konosevich2022::Letters;

/// The entry of the page in the ledger.
pub const PAPER: Paper = Paper {
    key: "stability",
    title: "Stability of the stationary motions of a gyrostat with a motor",
    citation: "The workbench's own page, in the letters of B. I. Konosevich, Yu. B. Konosevich 2022, section 6, whose paper leaves stability open. Theorems: E. J. Routh 1877; A. M. Lyapunov 1892; A. Ostrowski, H. Schneider 1962; E. E. Zajac 1964.",
    summary: r"Every motor enters the characteristic equation through one function, its operational stiffness $Z(z)$: $A'\det A\,z^2p_f(z)+Z(z)\det A^*p_c(z)=0$, where $p_f$ and $p_c$ belong to the classical gyrostats with a free rotor and with a rotor of constant speed ($Z=0$ and $Z=\infty$). Evenly spaced bars and their two equivalent windings have one $Z$. Without currents, $Z=K+dz$, the conditions of asymptotic stability ask for $K>0$, $d>0$ and for inequalities in which neither stands: stability does not depend on how strong the motor is. The energy at fixed integrals decides for every motor at once: what is stable by gyroscopic forces alone, at constant speed, a real motor makes unstable, unless it does not feel it. An upright gyrostat is held by its rotor along the vertical if $(A'\Omega)^2>\Gamma(\sqrt{A_1^*}+\sqrt{A_2^*})^2$, by a rotor across it never. On a circle of motions no tilt lowers the energy where $A_1^*>A_3^*$, and all members but those with $b=0$ are unstable at constant speed where $A_1^*<A_3^*$.",
    entries: &[
        "law",
        "zeros",
        "energy",
        "constant-speed",
        "motor",
        "currents",
        "damping",
        "axis",
        "balanced",
        "rest",
        "family",
    ],
    page,
};

/// The page with its claims, which are checked in the calling thread.
pub fn page() -> Page {
    let letters = Letters::default();
    let mut page = Page::of(PAPER.key, alphabet::dimension);
    foundations::claims(&mut page, &letters);
    motors::claims(&mut page, &letters);
    closed::claims(&mut page, &letters);
    families::claims(&mut page, &letters);
    page
}
