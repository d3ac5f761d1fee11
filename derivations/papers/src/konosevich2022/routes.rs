//! Additional results: the equations of motion by four principles are equal, in arbitrary axes.

use super::alphabet::letter;
use super::letters::Letters;
use claims::{Condition, Page};
use mechanics::differentiate::along;
use mechanics::rotation::{euler, euler_forms, vertical};
use nalgebra::Vector3;
use symbolic::Sym;
use systems::gyrostat::MotionInstant;

use Condition::Equal;

pub fn claims(page: &mut Page, s: &Letters) {
    page.section("Beyond the paper: four principles");
    let g = s.general();
    let by_momentum = g.by_momentum(&s.motion());
    let by_appell = g.by_appell(&s.motion());
    page.claim("beyond-routes", "appell", r"Appell's equations, from the accelerations of the mass points, are the theorem of angular momentum for the carrier and the rotor, for all data")
        .in_words()
        .under(&s.unit_axis)
        .follows((0..4).map(|i| Equal(by_appell[i], by_momentum[i])));

    let angles = ["ψ", "θ", "φ", "φ′"].map(letter);
    let motion = MotionInstant { vertical: vertical(&euler([angles[0], angles[1], angles[2]])), ..s.motion() };
    let at_angles = g.by_momentum(&motion);
    let by_hamel = g.by_hamel(angles, &motion);
    page.claim("beyond-routes", "hamel", r"The equations of Boltzmann and Hamel in the quasi-velocities $(\omega, \dot\varphi')$, with brackets from Euler's angles, are the theorem of angular momentum for the carrier and the rotor")
        .in_words()
        .under(&s.unit_axis)
        .follows((0..4).map(|i| Equal(by_hamel[i], at_angles[i])));
    lagrange(page, s);
}

/// Claims: Lagrange's equations in Euler angles are W^T times the equations of the carrier.
fn lagrange(page: &mut Page, s: &Letters) {
    let g = s.general();
    let angles = ["ψ", "θ", "φ", "φ′"].map(letter);
    let rates = [letter("ψ̇"), letter("θ̇"), letter("φ̇"), s.dphi];
    let accelerations = [letter("ψ̈"), letter("θ̈"), letter("φ̈"), s.ddphi];
    let by_lagrange = g.by_lagrange(angles, rates, accelerations, s.torque);

    let [position, velocity, acceleration] = [angles, rates, accelerations].map(|[a, b, c, _]| [a, b, c]);
    let forms = euler_forms(along(position, velocity));
    let moving = forms * Vector3::from(along(velocity, acceleration));
    let motion = MotionInstant {
        angular_velocity: moving.map(|x| x.value),
        angular_acceleration: moving.map(|x| x.slope),
        vertical: vertical(&euler(position)),
        ..s.motion()
    };
    let [x, y, z, rotor] = g.by_momentum(&motion);
    let expected = forms.map(|x| x.value).transpose() * Vector3::new(x, y, z);
    let expected: [Sym; 4] = [expected.x, expected.y, expected.z, rotor];
    page.claim("beyond-routes", "lagrange", r"Lagrange's equations of the second kind in Euler's angles are $W^T$ times the carrier's equations by angular momentum, where $\omega = W\dot q$; Lagrange's equation of the rotor is its equation by angular momentum")
        .in_words()
        .under(&s.unit_axis)
        .follows((0..4).map(|i| Equal(by_lagrange[i], expected[i])));
}
