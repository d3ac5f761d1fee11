//! The residual violation of a stabilised constraint: each step violates the constraint by its own discretisation
//! error, which no gains remove.

use super::alphabet::{letter, letters};
use claims::{Condition, Page};
use field::{Analytic, Base, Over, Scalar};
use integrators::euler_step;
use mechanics::constrained::State;
use mechanics::constrained::energies::{Energies, Instant, Kinematics};
use mechanics::constrained::programmed::{Linear, Programme};
use symbolic::Sym;

use Condition::Equal;

/// A point of mass m on a circle of radius l, in Cartesian coordinates.
#[derive(Clone, Copy, Debug)]
struct Pendulum<P> {
    mass: P,
    gravity: P,
    length: P,
}

impl<P: Base> Energies<2, 1> for Pendulum<P> {
    type Given = P;

    fn lagrangian<S: Over<P> + Analytic>(&self, _time: S, [_, y]: [S; 2], [u, v]: [S; 2]) -> S {
        S::lift(self.mass) * ((u.squared() + v.squared()).half() - S::lift(self.gravity) * y)
    }

    fn dissipation<S: Over<P> + Analytic>(&self, _time: S, _q: [S; 2], _dq: [S; 2]) -> S {
        S::zero()
    }

    fn force<S: Over<P> + Analytic>(&self, _time: S, _q: [S; 2], _dq: [S; 2]) -> [S; 2] {
        [S::zero(); 2]
    }

    fn constraints<S: Over<P> + Analytic>(&self, _time: S, [x, y]: [S; 2]) -> [S; 1] {
        [x.squared() + y.squared() - S::lift(self.length).squared()]
    }
}

pub fn claims(page: &mut Page) {
    page.section("What remains of a violation");
    let [h, b, k] = letters(["h", "b", "k"]);
    let [x, y, u, v] = letters(["x", "y", "u", "v"]);
    let pendulum = Pendulum { mass: letter("m"), gravity: letter("g"), length: letter("l") };
    let law = Linear { damping: [[b]], stiffness: [[k]] };
    let at = |s: &[Sym]| State { time: Sym::ZERO, place: [s[0], s[1]], velocity: [s[2], s[3]] };
    let wanted = |state: &State<Sym, 2>| law.prescribed::<Sym>(state, &Kinematics::of(&pendulum, state).violation());
    let acceleration = |state: &State<Sym, 2>| {
        let led = Instant::of(&pendulum, state).leading_to(wanted(state));
        led.map_or([Sym::UNDEFINED; 2], |reaction| reaction.acceleration)
    };
    let rates = |_: Sym, s: &[Sym], ds: &mut [Sym]| {
        let [a, c] = acceleration(&at(s));
        ds.copy_from_slice(&[s[2], s[3], a, c]);
    };
    let (before, mut after) = ([x, y, u, v], [Sym::ZERO; 4]);
    euler_step(rates, Sym::ZERO, &before, h, &mut [Sym::ZERO; 4], &mut after);
    let [from, to] = [&before, &after].map(|s| Kinematics::of(&pendulum, &at(s)));
    let ([a, c], [led]) = (acceleration(&at(&before)), wanted(&at(&before)));
    let two = Sym::int(2);
    page.claim("floor", "euler", r"A point on a circle, $f=x^2+y^2-l^2$, stabilised by $\ddot f=-b\dot f-kf$, has after one step of Euler $f_1=f+h\dot f+h^2|v|^2$ and $\dot f_1=\dot f+h(-b\dot f-kf)+2h^2\,v\cdot\dot v$. This is a linear recursion with the gains, and a forcing without them")
        .in_words()
        .follows([
            Equal(to.value[0], from.value[0] + h * from.rate[0] + h.powi(2) * (u.powi(2) + v.powi(2))),
            Equal(to.rate[0], from.rate[0] + h * led + two * h.powi(2) * (u * a + v * c)),
        ]);
    // at the fixed point of the recursion: h f' = -h^2 |v|^2, k f = -b f' + ...
    let (speed, power) = (u.powi(2) + v.powi(2), letter("p"));
    let (rate, value) = (-h * speed, (b * h * speed + two * h * power) / k);
    page.claim("floor", "level", r"The recursion of stabilisation/floor/euler with a constant forcing rests at $\dot f=-h|v|^2$ and $f=h(b|v|^2+2\,v\cdot\dot v)/k$. With gains that go with the step, $b=\beta/h$ and $k=\kappa/h^2$, $f$ is $h^2\beta|v|^2/\kappa$ to leading order")
        .in_words()
        .follows([
            Equal(value + h * rate + h.powi(2) * speed, value),
            Equal(rate + h * (-b * rate - k * value) + two * h.powi(2) * power, rate),
        ]);
}
