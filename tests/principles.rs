//! Systems with constraints: every principle gives the same motion.

use derivations::systems::rod::{GuidedRod, Rod};
use field::{Analytic, Tangent};
use mechanics::constrained::contacts::{Closed, Sides};
use mechanics::constrained::multipliers::multipliers;
use mechanics::constrained::{Charted, State, System, kinetic_energy};
use mechanics::differentiate::along;
use mechanics::lagrange::lagrange;
use symbolic::{Hypotheses, Sym, symbols};

#[test]
fn multipliers_and_lagrange_agree_for_the_rod() {
    let [m, m1, l, g, f] = symbols(["m", "m1", "l", "g", "f"]);
    let rod: GuidedRod<Sym> =
        Closed(Rod { guided: m, free: m1, length: l, gravity: g, friction: f, sides: Sides::Two });
    let [x, theta, dx, dtheta] = symbols(["x", "theta", "x'", "theta'"]);
    let moving = along([x, theta], [dx, dtheta]);
    let place = rod.place(Tangent::fixed(Sym::ZERO), moving);
    let at = State { time: Sym::ZERO, place: place.map(|p| p.value), velocity: place.map(|p| p.slope) };
    let reaction = multipliers::<_, _, 4, 2>(&rod, &at, rod.force(&at)).expect("the constraints are independent");
    // theta'' from x1'' - x'' = -l sin theta theta'' - l cos theta theta'^2
    let point = theta.circle();
    let ddx = reaction.acceleration[0];
    let ddtheta = (reaction.acceleration[2] - ddx + l * point.cos * dtheta * dtheta) / (-l * point.sin);
    let residual = lagrange(
        |q, dq| {
            let moving: [_; 2] = std::array::from_fn(|i| Tangent::moving(q[i], dq[i]));
            let place = rod.place(Tangent::fixed(num_traits::Zero::zero()), moving);
            let energy = kinetic_energy(rod.masses(), place.map(|p| p.slope));
            let at = State {
                time: num_traits::Zero::zero(),
                place: place.map(|p| p.value),
                velocity: place.map(|p| p.slope),
            };
            let force = rod.force(&at);
            (0..4).fold(energy, |sum, i| sum + force[i] * place[i].value)
        },
        [x, theta],
        [dx, dtheta],
        [ddx, ddtheta],
    );
    for r in residual {
        assert!(Hypotheses::none().equal(r, Sym::ZERO).is_zero(), "{r}");
    }
}
