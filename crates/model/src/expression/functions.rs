//! The functions of the language: one table for messages, for the parser, and for the reference in the book.

/// A function that expressions may call.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NamedFunction {
    /// The name in expressions.
    pub name: &'static str,
    /// The call in messages.
    pub usage: &'static str,
    /// A description of the arguments.
    pub of: &'static str,
    /// A description of the value.
    pub gives: &'static str,
    /// A scalar example with the symbols of the crane in the language reference.
    pub example: &'static str,
}

const NUMBER: &str = "a scalar without dimension";
const ANGLE: &str = "an angle";
const ONE: &str = "one scalar";
const IN_OUTPUTS: &str = "a body, only in `[outputs]`";
const CONTACT: &str = "a named contact, only in `[outputs]`";

const fn function(name: &'static str, usage: &'static str, of: &'static str, gives: &'static str) -> NamedFunction {
    NamedFunction { name, usage, of, gives, example: "" }
}

impl NamedFunction {
    const fn such_as(self, example: &'static str) -> Self {
        NamedFunction { example, ..self }
    }
}

/// Every function of the language.
///
/// ```
/// use dalembert_model::expression::FUNCTIONS;
///
/// assert!(FUNCTIONS.iter().any(|function| function.name == "atan2"));
/// ```
pub const FUNCTIONS: [NamedFunction; 37] = [
    function("sin", ONE, ANGLE, "the sine").such_as("sin(a)"),
    function("cos", ONE, ANGLE, "the cosine").such_as("cos(a)"),
    function("tan", ONE, ANGLE, "the tangent").such_as("tan(a)"),
    function("asin", ONE, NUMBER, "the angle from -pi/2 to pi/2 with this sine").such_as("asin(x/(4 m))"),
    function("acos", ONE, NUMBER, "the angle from 0 to pi with this cosine").such_as("acos(x/(4 m))"),
    function("atan", ONE, NUMBER, "the angle from -pi/2 to pi/2 with this tangent").such_as("atan(x/l)"),
    function("atan2", "atan2(y, x) of two scalars", "two scalars of one dimension", "the angle of the point (x, y)")
        .such_as("atan2(x, l)"),
    function("exp", ONE, NUMBER, "the exponential").such_as("exp(-t/(1 s))"),
    function("ln", ONE, "a positive scalar without dimension", "the natural logarithm").such_as("ln(l/(1 m))"),
    function("log", ONE, "a positive scalar without dimension", "the natural logarithm, as `ln`")
        .such_as("log(l/(1 m))"),
    function("sinh", ONE, NUMBER, "the hyperbolic sine").such_as("sinh(x/l)"),
    function("cosh", ONE, NUMBER, "the hyperbolic cosine").such_as("cosh(x/l)"),
    function("tanh", ONE, NUMBER, "the hyperbolic tangent").such_as("tanh(x/l)"),
    function("sqrt", ONE, "a scalar that is not negative", "the square root").such_as("sqrt(g*l)"),
    function("abs", "abs(a), sign(a) of a scalar", "a scalar", "the absolute value").such_as("abs(a')"),
    function("sign", "abs(a), sign(a) of a scalar", "a scalar", "1 or -1; of a speed in a force, dry friction")
        .such_as("sign(x')"),
    function("min", "min(a, b), max(a, b) of two scalars", "two scalars of one dimension", "the lesser one")
        .such_as("min(x, l)"),
    function("max", "min(a, b), max(a, b) of two scalars", "two scalars of one dimension", "the greater one")
        .such_as("max(x, l)"),
    function(
        "if",
        "if(t < (2 s), a, b)",
        "a comparison by `<`, `<=`, `>` or `>=`, and two scalars of one dimension",
        "the first where the comparison holds, else the second",
    )
    .such_as("if(t < (1 s), x, l)"),
    function(
        "table",
        "table(x, x1, y1, x2, y2, ...)",
        "a scalar x and at least two points (x1, y1), (x2, y2) with ascending x",
        "straight lines through the points, constant outside",
    )
    .such_as("table(t, (0 s), 0, (1 s), 2)"),
    function("dot", "dot(a, b), cross(a, b) of two vectors", "two vectors", "the scalar product, also `a . b`")
        .such_as("dot(P - O, N.y)"),
    function("cross", "dot(a, b), cross(a, b) of two vectors", "two vectors", "the vector product")
        .such_as("cross(P - C, N.x) . N.z"),
    function("norm", "norm(a), unit(a) of a vector", "a vector", "the length").such_as("norm(P - O)"),
    function("unit", "norm(a), unit(a) of a vector", "a vector", "the vector of length 1 along it")
        .such_as("unit(P - C) . N.x"),
    function("distance", "distance(P, Q) of two points", "two points", "their distance").such_as("distance(O, P)"),
    function(
        "velocity",
        "velocity(P), velocity(disc at P), velocity(P in B)",
        "a point, a body, or a body `at` a point; `in` a frame",
        "the velocity, a vector, seen from the ground or from the frame",
    )
    .such_as("velocity(load at P) . N.x"),
    function(
        "acceleration",
        "acceleration(P), acceleration(disc at P), acceleration(P in B)",
        "a point, a body, or a body `at` a point; `in` a frame",
        "the acceleration, a vector, seen from the ground or from the frame",
    )
    .such_as("acceleration(P in A) . A.x"),
    function(
        "angular_velocity",
        "angular_velocity(B), angular_velocity(B in A) of a frame or a body",
        "a frame or a body; `in` a frame",
        "the angular velocity, a vector, relative to the ground or to the frame",
    )
    .such_as("angular_velocity(load in N) . N.z"),
    function(
        "rate",
        "rate(e) of a scalar, rate(v in B) of a vector",
        "a scalar, or a vector `in` a frame, of coordinates, speeds and the time",
        "the derivative with respect to the time",
    )
    .such_as("rate(x*sin(a))"),
    function(
        "reaction",
        ONE,
        "a named constraint, or this and the number of an entry of its list; a contact, a diode or a freewheel, only in `[outputs]`",
        "the reaction: a scalar, or a vector of a constraint that is a vector",
    )
    .such_as("reaction(path)"),
    function(
        "friction",
        "friction(floor), gap(floor), sliding(floor) of a named [[contact]]",
        CONTACT,
        "the force of friction: a scalar, in space a vector",
    )
    .such_as("friction(wall)"),
    function("gap", "friction(floor), gap(floor), sliding(floor) of a named [[contact]]", CONTACT, "the gap")
        .such_as("gap(wall)"),
    function(
        "sliding",
        "friction(floor), gap(floor), sliding(floor) of a named [[contact]]",
        CONTACT,
        "the sliding velocity: a scalar, in space a vector",
    )
    .such_as("sliding(wall)"),
    function(
        "joint_force",
        "joint_force(disc), joint_torque(disc) of a body",
        IN_OUTPUTS,
        "the force of its joint on the body, a vector",
    )
    .such_as("norm(joint_force(load))"),
    function(
        "joint_torque",
        "joint_force(disc), joint_torque(disc) of a body",
        IN_OUTPUTS,
        "the torque of its joint on the body, a vector",
    )
    .such_as("joint_torque(load) . N.z"),
    function(
        "momentum",
        "momentum(theta) of a coordinate, dT/d(theta'); momentum(F.wx) of a free frame, dT/d(F.wx); momentum(bob) of a body, a vector",
        "a coordinate, a component `F.wx` of a free frame's angular velocity, or a body, only in `[outputs]`",
        "the derivative of the kinetic energy with respect to the rate of the coordinate, or to the component; of a body the mass times the velocity of its centre of mass, a vector",
    )
    .such_as("momentum(a)"),
    function(
        "angular_momentum",
        "angular_momentum(disc) about the centre of mass, angular_momentum(disc, P) about a point",
        "a body, or a body and a point, only in `[outputs]`",
        "the angular momentum about the centre of mass or about the point, a vector; velocities are those seen from the ground",
    )
    .such_as("angular_momentum(load, O) . N.z"),
];

/// Returns the usage of a function for messages.
pub(crate) fn usage(name: &str) -> &'static str {
    FUNCTIONS.iter().find(|function| function.name == name).map_or(ONE, |function| function.usage)
}
