//! Section 6: the drive of a crank mechanism. The paper gives its constraint and no equations.

use super::alphabet::{int, letters};
use claims::{Condition, Line, Page};
use field::{Analytic, Tangent};
use symbolic::Sym;

pub fn claims(page: &mut Page) {
    page.section("6. Electromechanical drive");
    page.claim("section6-drive", "model", "supply, alternating-current motor, rectifier, direct-current motor and crank mechanism under gravity: 9 equations of the first order with 9 unknowns, made with MAPLE 7 and integrated by Euler's method with $h=0.01$")
        .note("The equations, the data and the scale of the figures are not in the text. A model of such a drive is this workbench's own, and none of its numbers can be compared with the figures.")
        .defines([]);
    let [crank, slider, radius, length] = letters(["q⁶", "q⁷", "rᶜ", "l"]);
    let point = crank.circle();
    let printed = (slider - radius * point.cos).powi(2) + (radius * point.sin).powi(2);
    // places of crank pin and slider, and their distance
    let pin = [radius * point.cos, radius * point.sin];
    let distance = (pin[0] - slider).powi(2) + pin[1].powi(2);
    page.claim(
        "section6-drive",
        "constraint",
        r"$(q^7-r\cos q^6)^2+(r\sin q^6)^2=l^2$: the rod joins the crank pin and a slider on the line through the axis",
    )
    .holds([Line::equation(distance - length * length, printed, length * length)]);
    let moving = |x: Sym| Tangent::variable(x);
    let gap = |angle: Tangent<Sym>, place: Tangent<Sym>| {
        let (r, at) = (Tangent::fixed(radius), angle.circle());
        (place - r * at.cos) * (place - r * at.cos) + r * at.sin * (r * at.sin)
    };
    let by_crank = gap(moving(crank), Tangent::fixed(slider)).slope;
    let by_slider = gap(Tangent::fixed(crank), moving(slider)).slope;
    let offset = slider - radius * point.cos;
    page.claim("section6-drive", "row", r"its row is $(2q^7r\sin q^6,\ 2(q^7-r\cos q^6))$").follows([
        Condition::Equal(by_crank, int(2) * slider * radius * point.sin),
        Condition::Equal(by_slider, int(2) * offset),
    ]);
    page.claim("section6-drive", "regular", r"which vanishes nowhere if the rod is longer than the crank: $q^7=r\cos q^6$ asks for $r^2-l^2=r^2\cos^2q^6\ge0$")
        .given([Condition::Equal(printed, length * length), Condition::Zero(offset)])
        .by_combination([(
            Condition::Equal(radius * radius - length * length, (radius * point.cos).powi(2)),
            vec![],
            vec![(0, int(1)), (1, -offset)],
        )]);
}
