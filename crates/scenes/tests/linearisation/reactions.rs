//! Linear equations of outputs that depend on reactions: derivatives along the constraints.

use super::{linear, scene};
use dalembert_scenes::start_of;

/// A bob on a circle x^2 + y^2 = l^2, released at rest at 60 degrees from the vertical: the tension at rest is m g cos(a), and its derivative along
/// the circle is compared.
#[test]
fn the_slope_of_a_tension_is_that_of_its_closed_form() {
    let text = "title = \"pendulum\"\ngravity = \"-g*N.y\"\n[parameters]\nm = \"2 kg\"\nl = \"1 m\"\ng = \"9.81 m/s^2\"\n\
                [coordinates]\nx = \"m\"\ny = \"m\"\n[points]\nP = \"O + x*N.x + y*N.y\"\n[bodies.bob]\ncentre = \"P\"\nmass = \"m\"\n\
                [[constraint]]\nname = \"rod\"\nzero = \"distance(O, P) - l\"\n[outputs]\ntension = \"reaction(rod)\"\n\
                [start]\nx = \"0.8660254037844386 m\"\ny = \"guess -0.5 m\"\n[run]\nspan = \"1 s\"\n";
    let model = scene(text).model;
    let state = start_of(&model).unwrap_or_else(|issue| panic!("{}", issue.title));
    let (_, found) = linear(&model, &state, &[]);
    // lambda = -m g cos(a) = m g y/l at rest
    let place = found.coordinates[0];
    let slope = [-state[0] / state[1], 1.0][place];
    let expected = 2.0 * 9.81 * slope;
    assert!((found.c[(0, 0)].abs() - expected.abs()).abs() < 1e-9, "{} and {expected}", found.c);
}
