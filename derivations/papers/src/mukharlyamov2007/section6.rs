//! Section 6: the drive of a crank mechanism. The paper gives its constraint but no equations; `systems/crank_drive.rs`
//! completes it.

use super::alphabet::{int, letter, letters};
use super::drive::{balance, close_in_nine, heat};
use claims::{Condition, Line, Page};
use field::{Analytic, Scalar, Tangent};
use mechanics::constrained::State;
use mechanics::constrained::energies::{self, Energies};
use symbolic::Sym;
use systems::crank_drive::{Circuit, CrankDrive};
use systems::crank_slider::CrankSlider;

pub fn claims(page: &mut Page) {
    page.section("6. Electromechanical drive");
    page.claim("section6-drive", "model", "The drive consists of supply, alternating-current motor, rectifier, direct-current motor and crank mechanism under gravity. Its 9 equations of the first order with 9 unknowns were made with MAPLE 7 and integrated by Euler's method with $h=0.01$. They are completed here as the system `crank_drive`")
        .note(r"The paper gives the parts and their order, gravity, the rod's constraint, the names $q^3,q^6,f^6,q^7,f^7$, the number of equations, the method and its step. Added here are a transformer that feeds the rectifier, four diodes, capacitor and choke, a motor with a constant field, viscous friction, the rod's mass shared between its ends, the electrical unknowns $f^1,f^2,q^3,f^4,f^5$, and all data. Equations, data and the scale of the figures are not in the text, so that no number can be compared with them.")
        .defines([]);
    constraint(page);
    completed(page);
}

fn constraint(page: &mut Page) {
    let [crank, slider, radius, length] = letters(["q⁶", "q⁷", "rᶜ", "l"]);
    let point = crank.circle();
    let printed = (slider - radius * point.cos).powi(2) + (radius * point.sin).powi(2);
    page.claim(
        "section6-drive",
        "constraint",
        r"$(q^7-r\cos q^6)^2+(r\sin q^6)^2=l^2$ ties the slider to the crank, where the rod joins the crank pin and a slider on the line through the axis",
    )
    .defines([Line::equation(printed - length * length, printed, length * length)]);
    let moving = |x: Sym| Tangent::variable(x);
    let gap = |angle: Tangent<Sym>, place: Tangent<Sym>| {
        let (r, at) = (Tangent::fixed(radius), angle.circle());
        (place - r * at.cos) * (place - r * at.cos) + r * at.sin * (r * at.sin)
    };
    let by_crank = gap(moving(crank), Tangent::fixed(slider)).slope;
    let by_slider = gap(Tangent::fixed(crank), moving(slider)).slope;
    let offset = slider - radius * point.cos;
    page.claim(
        "section6-drive",
        "row",
        r"The gradient of the rod's constraint by $(q^6,q^7)$ is $(2q^7r\sin q^6,\ 2(q^7-r\cos q^6))$",
    )
    .in_words()
    .follows([
        Condition::Equal(by_crank, int(2) * slider * radius * point.sin),
        Condition::Equal(by_slider, int(2) * offset),
    ]);
    page.claim("section6-drive", "regular", r"The gradient of the rod's constraint vanishes nowhere if the rod is longer than the crank, for on the constraint $q^7=r\cos q^6$ requires $r^2-l^2=r^2\cos^2q^6\ge0$")
        .in_words()
        .given([Condition::Equal(printed, length * length), Condition::Zero(offset)])
        .by_combination([(
            Condition::Equal(radius * radius - length * length, (radius * point.cos).powi(2)),
            vec![],
            vec![(0, int(1)), (1, -offset)],
        )]);
}

/// The drive with a symbol for every datum.
fn drive() -> CrankDrive<Sym> {
    let [l1, l2, l4, l5] = letters(["Lᵈ1", "Lᵈ2", "Lᵈ4", "Lᵈ5"]);
    let [r1, r2, r4, r5] = letters(["Rᵈ1", "Rᵈ2", "Rᵈ4", "Rᵈ5"]);
    let [amplitude, frequency, mutual, forward, reverse, knee] = letters(["E₀", "Ωᵈ", "Mᵈ", "Rᵈᶠ", "Rᵈʳ", "i₀"]);
    let [c3, motor, b6, b7] = letters(["Cᵈ", "Kᵈ", "b₆", "b₇"]);
    let [inertia, mass, crank, rod, weight] = letters(["Jᵈ", "mᵈ", "rᶜ", "l", "Gᵈ"]);
    let circuit = Circuit {
        amplitude,
        frequency,
        l1,
        l2,
        mutual,
        r1,
        r2,
        forward,
        reverse,
        knee,
        c3,
        l4,
        r4,
        l5,
        r5,
        motor,
        b6,
        b7,
    };
    CrankDrive { circuit, mechanism: CrankSlider { inertia, mass, crank, rod, weight } }
}

/// Claims on the completed drive.
fn completed(page: &mut Page) {
    let drive = drive();
    let at = State {
        time: letter("t"),
        place: letters(["qᵈ1", "qᵈ2", "qᵈ4", "qᵈ5", "q⁶", "q⁷"]),
        velocity: letters(["fᵈ1", "fᵈ2", "fᵈ4", "fᵈ5", "f⁶", "f⁷"]),
    };
    let [.., crank, slider] = at.place;
    let [radius, length] = letters(["rᶜ", "l"]);
    let point = crank.circle();
    page.claim("section6-drive", "closure", "The completed drive has the printed constraint").defines([
        Line::equation(
            drive.constraints(at.time, at.place)[0],
            (slider - radius * point.cos).powi(2) + (radius * point.sin).powi(2),
            length.powi(2),
        ),
    ]);
    page.claim("section6-drive", "nine", r"The completed drive has nine equations of the first order. With $q^3=q^4-q^5$, $\dot q^3=f^4-f^5$ they close in $f^1,f^2,q^3,f^4,f^5,q^6,f^6,q^7,f^7$, for no force depends on another charge")
        .in_words()
        .follows(close_in_nine(&drive, &at));
    let accelerations = letters(["ḟᵈ1", "ḟᵈ2", "ḟᵈ4", "ḟᵈ5", "ḟ⁶", "ḟ⁷"]);
    let supplied = drive.source(at.time) * at.velocity[0] - heat(&drive, at.velocity);
    page.claim("section6-drive", "power", r"In the completed drive the energy of windings, capacitor, crank and slider grows by $Ef^1$ less the heat in resistances, diodes and bearings, plus $\lambda\dot f$, which vanishes where the constraint holds. The program monitors runs of the drive by that power")
        .in_words()
        .follows([
            balance(&drive, &at, accelerations, letter("λᵈ")),
            Condition::Equal(energies::power(&drive, &at), supplied),
            Condition::Equal(
                energies::energy(&drive, &at),
                drive.magnetic([at.velocity[0], at.velocity[1], at.velocity[2], at.velocity[3]])
                    + drive.mechanism.kinetic([at.velocity[4], at.velocity[5]])
                    + (at.place[2] - at.place[3]).powi(2).half() / drive.circuit.c3
                    + drive.mechanism.potential(crank),
            ),
        ]);
}
