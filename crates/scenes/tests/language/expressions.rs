//! Operators, names, functions and units of expressions, as tables of the reference.

use model::expression::FUNCTIONS;
use std::fmt::Write;
use units::{Dimension, Unit};

/// A row of a table: spelling, meaning, and an example with quantities of the crane.
pub struct Written {
    pub name: &'static str,
    pub meaning: &'static str,
    pub example: &'static str,
}

const fn row(name: &'static str, meaning: &'static str, example: &'static str) -> Written {
    Written { name, meaning, example }
}

pub const OPERATORS: &[Written] = &[
    row(
        "a + b, a - b",
        "sum and difference of scalars or vectors of one dimension; a point plus a vector is a point, a point minus a point is a vector",
        "x + l*sin(a)",
    ),
    row("a*b", "product of scalars, or of a scalar and a vector; the sign `*` is always written", "m*l^2*a'"),
    row("a/b", "quotient by a scalar", "x/l"),
    row(
        "a^n",
        "power, with a number from -64 to 64 or a fraction in parentheses; the base is positive where n is no multiple of 1/2",
        "x^2 + l^(3/2)*(1 m)^(1/2)",
    ),
    row("-a", "the negative; it binds less tightly than a power: `-x^2` is `-(x^2)`", "-x^2"),
    row("a . b", "scalar product of vectors, with a space on both sides of the point", "(P - O) . N.y"),
    row(
        "a < b, a <= b, a > b, a >= b",
        "comparison of scalars of one dimension, as the first argument of `if`",
        "if(x <= l, x, l)",
    ),
    row(
        "(20 mm)",
        "a number with its unit, in parentheses within an expression; alone it needs none: `\"20 mm\"`",
        "x - (20 mm)",
    ),
    row("x', x''", "first and second rate of a coordinate; the first one of a quasi-velocity", "x'"),
    row("A.x, A.y, A.z", "unit vectors along the axes of a frame or of a body", "A.x . N.x"),
    row(
        "F.w, F.wx",
        "angular velocity of a free frame relative to its parent, a vector; its component along the axis x of F",
        "F.wx",
    ),
    row(
        "body at P",
        "the place of a body at a point, within `velocity` and `acceleration`",
        "velocity(load at P) . N.x",
    ),
    row(
        "P in A",
        "the motion as seen from a frame, within `velocity`, `acceleration`, `angular_velocity` and `rate`",
        "norm(velocity(P in A))",
    ),
];

pub const CONSTANTS: &[Written] = &[
    row("t", "the time", "t"),
    row("pi", "the number pi", "2*pi"),
    row("N", "the frame of the ground; its axes are N.x, N.y, N.z", "(P - O) . N.x"),
    row("O", "the origin, a point of the ground", "distance(O, C)"),
    row("kinetic_energy", "the kinetic energy of the system, in `[outputs]`", "kinetic_energy"),
    row("potential_energy", "the potential energy of the system, in `[outputs]`", "kinetic_energy + potential_energy"),
];

fn table(page: &mut String, head: [&str; 3], rows: &[Written]) {
    let [name, meaning, example] = head;
    // writing to a string cannot fail
    let _ = writeln!(page, "| {name} | {meaning} | {example} |\n|---|---|---|");
    for Written { name, meaning, example } in rows {
        let _ = writeln!(page, "| `{name}` | {meaning} | `{example}` |");
    }
}

/// Writes the section on operators and names.
pub fn operators(page: &mut String) {
    table(page, ["spelling", "meaning", "example"], OPERATORS);
    page.push_str("\n### Names with a meaning of their own\n\n");
    table(page, ["name", "meaning", "example"], CONSTANTS);
}

/// Writes the section on functions.
pub fn functions(page: &mut String) {
    page.push_str("| function | arguments | value | example |\n|---|---|---|---|\n");
    for function in &FUNCTIONS {
        let _ =
            writeln!(page, "| `{}` | {} | {} | `{}` |", function.name, function.of, function.gives, function.example);
    }
}

/// Writes the section on units.
pub fn units(page: &mut String) {
    let factor = |unit: &str| Unit::parse(unit).expect("a unit of the table").to_si(1.0);
    let dimension = |unit: &str| Some(Dimension::of(unit)).filter(|dimension| !dimension.is_number());
    let in_si = |unit: &str| match dimension(unit) {
        Some(dimension) => format!("{} {dimension}", factor(unit)),
        None => factor(unit).to_string(),
    };
    page.push_str("| unit | in SI units | prefixes |\n|---|---|---|\n");
    let prefixed = Unit::with_prefixes().map(|unit| (unit, "yes"));
    for (unit, prefixes) in prefixed.chain(Unit::without_prefixes().map(|unit| (unit, "no"))) {
        let _ = writeln!(page, "| `{unit}` | {} | {prefixes} |", in_si(unit));
    }
    page.push_str("\n| prefix | factor |\n|---|---|\n");
    for prefix in Unit::prefixes() {
        let _ = writeln!(page, "| `{prefix}` | {:e} |", factor(&format!("{prefix}m")));
    }
}

#[test]
fn a_constant_of_the_reference_is_a_name_with_a_meaning() {
    for name in ["t", "pi", "N", "O"] {
        assert!(model::is_reserved(name) && CONSTANTS.iter().any(|row| row.name == name), "{name}");
    }
}
