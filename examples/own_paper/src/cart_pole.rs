//! Two equations of a textbook on the pole on a cart, one of them misprinted.
//!
//! The derived side comes from the bodies by a principle; the printed side is typed as it stands on the page.

use dalembert::claims::{Catalogue, Line, Page, Paper, submit};
use dalembert::field::{Analytic, Circle};
use dalembert::model::principles::Principle;
use dalembert::model::{BodySource, MatrixForm, Model, Source, Trace};
use dalembert::symbolic::{Dimension, Sym};

pub const PAPER: Paper = Paper {
    key: "cart_pole",
    title: "A textbook, the pole on a cart",
    citation: "A textbook, page 1.",
    summary: "The cart has the mass $M$, the bob of the pole the mass $m$; the angle is measured from the upright.",
    entries: &["eq1", "eq2"],
    page,
};

submit! {
    Catalogue { name: "own_paper", papers: &[&PAPER] }
}

/// The cart, and a bob at the end of the massless pole.
fn source() -> Source {
    let mut source = Source::default();
    source.parameters = vec![("M", "kg").into(), ("m", "kg").into(), ("l", "m").into(), ("g", "m/s^2").into()];
    source.coordinates = vec![("x", "m").into(), ("theta", "rad").into()];
    source.points = vec![
        ("C", "O + x*N.x").into(),
        ("B", "C + l*(sin(theta)*N.x + cos(theta)*N.y)").into(),
    ];
    source.bodies = vec![BodySource::particle("cart", "C", "M"), BodySource::particle("bob", "B", "m")];
    source.gravity = Some("-g*N.y".into());
    source
}

/// The dimension of each letter of the page, as powers of kg, m, s and A.
fn dimension(name: &str) -> Option<Dimension> {
    let [kg, m, s] = match name {
        "M" | "m" => [1, 0, 0],
        "l" | "x" => [0, 1, 0],
        "x'" => [0, 1, -1],
        "x''" | "g" => [0, 1, -2],
        "theta" => [0, 0, 0],
        "theta'" => [0, 0, -1],
        "theta''" => [0, 0, -2],
        _ => return None,
    };
    Some(Dimension::of(kg, m, s, 0))
}

/// The claims, in the order of the page.
pub fn page() -> Page {
    let mut page = Page::of(PAPER.key, dimension);
    let Ok(model) = Model::of(&source()) else { return page };
    let trace = Trace::of(&model);
    let Ok(form) = MatrixForm::of(&trace, Principle::Lagrange) else { return page };
    let [cart, m, l, g] = ["M", "m", "l", "g"].map(Sym::symbol);
    let ([_, theta], [_, turn], [push, spin]) =
        (pair(&form.coordinates), pair(&form.speeds), pair(&form.accelerations));
    let Circle { cos, sin } = theta.circle();
    // M q'' + h - Q
    let derived = |row: usize| {
        let inertia = form.mass[row].iter().zip([push, spin]).fold(form.inertia[row], |sum, (&m, a)| sum + m * a);
        inertia - form.forces[row]
    };
    let line = |row: usize, left: Sym| Line::equation(derived(row), left, Sym::ZERO);

    page.section("Equations of motion");
    page.claim("eq1", "cart", "the cart, without a force on it")
        .holds([line(0, (cart + m) * push + m * l * spin * cos - m * l * turn * turn * sin)]);
    page.claim("eq2", "pole", "the pole")
        .why("The weight drives the pole away from the upright: its sign is that of a pole that hangs.")
        .fails([line(1, m * l * l * spin + m * l * push * cos + m * g * l * sin)]);
    page.claim("eq2", "pole_corrected", "the pole, the angle from the upright")
        .holds([line(1, m * l * l * spin + m * l * push * cos - m * g * l * sin)]);
    page.correct();
    page
}

fn pair(all: &[Sym]) -> [Sym; 2] {
    [all[0], all[1]]
}
