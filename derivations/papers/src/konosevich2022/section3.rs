//! Section 3: the motors: torques and currents from the energies by Lagrange-Maxwell, and statements on their signs.

use super::alphabet::{current, letter, number};
use super::letters::Letters;
use claims::{Condition, Line, Page, Point};
use field::{Circle, Over, Rational};
use machines::kloss::Kloss;
use machines::multi_current::MultiCurrent;
use machines::synchronous::Synchronous;
use motor::{Machine, RotorState, torque_and_current_rates};
use num_traits::Zero;
use symbolic::Sym;

/// A machine with the paper's friction: an arbitrary function M2 of the relative speed.
pub struct WithFriction<M> {
    pub machine: M,
    /// The friction torque M2(phi'), N m.
    pub friction: Sym,
}

impl<M: Machine<Sym>> Machine<Sym> for WithFriction<M> {
    fn rotor(&self) -> RotorState {
        self.machine.rotor()
    }

    fn frame_speed(&self) -> Sym {
        self.machine.frame_speed()
    }
    fn windings(&self) -> usize {
        self.machine.windings()
    }
    fn inductance(&self, winding: usize) -> Sym {
        self.machine.inductance(winding)
    }
    fn resistance(&self, winding: usize) -> Sym {
        self.machine.resistance(winding)
    }
    fn linkage<S: Over<Sym>>(&self, winding: usize, angle: Circle<S>) -> S {
        self.machine.linkage(winding, angle)
    }
    fn field_energy<S: Over<Sym>>(&self, angle: Circle<S>) -> S {
        self.machine.field_energy(angle)
    }
    fn torque_law<S: Over<Sym>>(&self, slip: S, speed: S) -> S {
        self.machine.torque_law(slip, speed) + S::lift(self.friction)
    }
}

/// The torque and the rates of the currents of a machine with the friction M2(g' + W).
pub fn driven<M: Machine<Sym>>(machine: M, s: &Letters, currents: &[Sym]) -> (Sym, Vec<Sym>) {
    let machine = WithFriction { machine, friction: friction(s.dgamma + s.omega_field) };
    let mut rates = vec![Sym::zero(); currents.len()];
    let moment = torque_and_current_rates(&machine, s.angle(), s.dgamma, currents, &mut rates);
    (moment, rates)
}

/// M2 as an arbitrary function of the speed.
pub fn friction(speed: Sym) -> Sym {
    Sym::function("M2", speed)
}

/// The excess dM2(g') = M2(g' + W) - M2(W), where c0 = -M2(W).
pub fn excess_friction(s: &Letters) -> Sym {
    friction(s.dgamma + s.omega_field) - friction(s.omega_field)
}

pub fn claims(page: &mut Page, s: &Letters) {
    page.section("3. Models of the motor");
    currentless(page, s);
    signs(page, s);
    for (bars, alone) in [(1, "one-bar"), (2, "two-bars"), (3, "three-bars"), (6, "six-bars")] {
        multi_current(page, s, bars, alone);
    }
    asynchronous(page, s);
}

fn currentless(page: &mut Page, s: &Letters) {
    let machine = Synchronous { field_speed: s.omega_field, b0: s.b0, f: Sym::zero() };
    let (moment, _) = driven(machine, s, &[]);
    let c0 = -friction(s.omega_field);
    page.claim(
        "eq3.1",
        "moment",
        r"The torque of the synchronous motor is (3.1), from $U = -b_0\cos\gamma$ and friction, with $\Delta M_2 = M_2(\dot\gamma+\Omega) + c_0$ and $c_0 = -M_2(\Omega)$",
    )
    .holds([Line::formula(moment, s.torque, excess_friction(s) - s.b0 * s.angle().sin - c0)]);
}

/// Claims on (3.2) and c0 > 0. A decreasing function has secants of negative slope: M2(u) - M2(v) = -kappa (u - v),
/// kappa > 0.
fn signs(page: &mut Page, s: &Letters) {
    let secant = letter("κ");
    page.claim(
        "eq3.2",
        "dissipative",
        r"$\dot\gamma\,\Delta M_2 < 0$ for a strictly decreasing law, written as $\Delta M_2 = -\kappa\dot\gamma$, $\kappa>0$",
    )
    .given([Condition::Positive(secant), Condition::NonZero(s.dgamma)])
    .note("Strictness is needed: a law that is constant between two speeds makes the product zero.")
    .by_signs([Condition::Positive(-(s.dgamma * decreasing(s, excess_friction(s), secant)))]);
    page.claim("eq3.2", "at-synchronism", r"At synchronism $\Delta M_2(0) = 0$")
        .follows([Condition::Zero(excess_friction(s).substitute(&[(s.dgamma, Sym::ZERO)]))]);
    page.claim(
        "section3-motors",
        "c0-positive",
        r"$c_0 = -M_2(\Omega) > 0$ for an odd decreasing law, $M_2(0)=0$, written as $M_2(\Omega) = -\kappa\Omega$, $\kappa>0$",
    )
    .given([Condition::Positive(secant), Condition::Positive(s.omega_field)])
    .by_signs([Condition::Positive(
        (-friction(s.omega_field)).substitute(&[(friction(s.omega_field), -(secant * s.omega_field))]),
    )]);
}

/// An expression with M2(g' + W) replaced by the secant M2(W) - kappa g'.
pub fn decreasing(s: &Letters, e: Sym, secant: Sym) -> Sym {
    e.substitute(&[(friction(s.dgamma + s.omega_field), friction(s.omega_field) - secant * s.dgamma)])
}

fn multi_current(page: &mut Page, s: &Letters, bars: u32, slug: &'static str) {
    let (moment, rates) = driven(s.motor(bars), s, &s.currents(bars));
    let gamma = s.angle();
    let angles = s.motor(bars).bars;
    let bar_sum = (1..=bars).zip(&angles).fold(Sym::ZERO, |sum, (n, &bar)| sum + current(n) * (gamma + bar).cos);
    let printed = -(letter("μ") * s.dgamma) + excess_friction(s)
        - letter("a1") * letter("x") * gamma.sin
        - letter("a2") * bar_sum
        - s.b0 * gamma.sin
        + friction(s.omega_field);
    let rotor = Line::equation(s.axial * s.ddgamma - moment, s.axial * s.ddgamma, printed);
    page.claim("eq3.3", slug, format!("The equations of Lagrange and Maxwell give (3.3), the equations of rotor and currents, for the motor alone with $n_2 = {bars}$"))
        .holds([rotor].into_iter().chain(current_equations(s, bars, &rates)));
    page.claim("eq3.4", slug, format!(r"The torque of the motor with $n_2 = {bars}$ is (3.4), from the fluxes $a_1\cos\gamma$ and $-a_2\sin(\gamma+t_n)$ with any angles $t_n$ (the paper: $-\pi/4+2\pi n/n_2$)"))
        .holds([Line::formula(moment, s.torque, printed)]);
}

/// The equations of the currents, the last of (3.3) and (4.7), with the derived rates.
pub fn current_equations(s: &Letters, bars: u32, rates: &[Sym]) -> Vec<Line> {
    let gamma = s.angle();
    let line = |inductance: Sym, name: Sym, rate: Sym, right: Sym| {
        Line::equation(inductance * (name - rate), inductance * name, right)
    };
    let excitation = -(letter("R1") * letter("x")) + letter("a1") * s.dgamma * gamma.sin;
    let mut lines = vec![line(letter("L1"), letter("ẋ"), rates[0], excitation)];
    for (n, bar) in (1..=bars).zip(s.motor(bars).bars) {
        let name = Sym::named(&format!("i̇{n}"), &format!(r"\dot i_{{{n}}}"));
        let right = -(letter("R2") * current(n)) + letter("a2") * s.dgamma * (gamma + bar).cos;
        lines.push(line(letter("L2"), name, rates[n as usize], right));
    }
    lines
}

/// Claims on the asynchronous motor.
fn asynchronous(page: &mut Page, s: &Letters) {
    let [k, f, kappa] = ["k", "f", "κ"].map(letter);
    let omega = s.omega_field;
    page.claim("section3-motors", "working-speed", r"$M(0) = k\Omega > 0$ and $-M(\Omega) = \kappa\Omega > 0$ with $M_1(0) = k\Omega$, $M_1(\Omega) = 0$, $M_2(0) = 0$, $M_2(\Omega) = -\kappa\Omega$. By the intermediate value theorem (not proved here), a continuous $M$ then vanishes at a working speed $\Omega' \in (0,\Omega)$")
        .given([k, kappa, omega].map(Condition::Positive))
        .note(r"The condition $M_1(0) > -M_2(0)$ of the paper is $M_1(0) > 0$, since an odd law of friction vanishes at rest.")
        .by_signs([Condition::Positive(k * omega), Condition::Positive(kappa * omega)]);
    let working = k * omega / (k + f);
    page.claim(
        "section3-motors",
        "linear",
        r"If the torques are linear in the speed, $\Omega' = k\Omega/(k+f)$ lies between $0$ and $\Omega$, and $-\dot\gamma M > 0$ near $\Omega'$",
    )
    .given([k, f, omega].map(Condition::Positive))
    .given([Condition::NonZero(s.dgamma)])
    .by_signs([
        Condition::Positive(working),
        Condition::Positive(omega - working),
        Condition::Positive(-(s.dgamma * linear_moment(s, working + s.dgamma))),
    ]);
    kloss(page, s);
}

fn linear_moment(s: &Letters, speed: Sym) -> Sym {
    let [k, f] = ["k", "f"].map(letter);
    k * (s.omega_field - speed) - f * speed
}

/// Claims on the sign of torques that are not monotonic.
fn kloss(page: &mut Page, s: &Letters) {
    let [pull_out, critical, f] = ["Mk", "sk", "f"].map(letter);
    let machine = Kloss { field_speed: s.omega_field, pull_out, pull_out_slip: critical, f };
    let moment_at = |speed: Sym| machine.torque_law(speed - s.omega_field, speed);
    let without_friction = Kloss { f: Sym::ZERO, ..machine };
    let omega = s.omega_field;
    let slip_moment = |slip: Sym| without_friction.torque_law(slip, slip + omega);
    page.claim(
        "section3-motors",
        "slip-sign",
        r"The torque of Kloss' motor without friction has the sign opposite to $\dot\varphi' - \Omega$",
    )
    .given([pull_out, critical, omega].map(Condition::Positive))
    .given([Condition::NonZero(s.dgamma)])
    .by_signs([Condition::Positive(-(s.dgamma * slip_moment(s.dgamma)))]);

    // the speeds W/2, 2W/3, 5W/6 are working speeds for s_k = 1/6, M_k = 5/6 f W
    let working = number(1, 2) * omega;
    page.claim("section3-motors", "dissipative", r"$\dot\gamma M(\dot\gamma) < 0$ for all $\dot\gamma \neq 0$ about a working speed $\Omega'$ of any asynchronous motor, as judged for Kloss' motor with $\Omega' = \Omega/2$")
        .given([pull_out, critical, f, omega].map(Condition::Positive))
        .given([Condition::Zero(moment_at(working)), Condition::NonZero(s.dgamma)])
        .why("Kloss' torque falls beyond the critical slip, and friction can balance it at three speeds. Between two of them the torque drives the rotor away from the working speed.")
        .refuted(
            [Condition::Positive(-(s.dgamma * moment_at(working + s.dgamma)))],
            Point::of([
                (omega, Rational::new(6, 1)),
                (f, Rational::new(1, 1)),
                (critical, Rational::new(1, 6)),
                (pull_out, Rational::new(5, 1)),
                (s.dgamma, Rational::new(3, 2)),
            ]),
        );
    let [drop, friction_secant] = [letter("k"), letter("κ")];
    page.claim("section3-motors", "dissipative-if-decreasing", r"$\dot\gamma M(\dot\gamma) < 0$ for $\dot\gamma \neq 0$ if $M_1$ decreases too. The secants are $M_1(\Omega'+\dot\gamma)-M_1(\Omega') = -k\dot\gamma$ and $M_2(\Omega'+\dot\gamma)-M_2(\Omega') = -\kappa\dot\gamma$")
        .given([drop, friction_secant].map(Condition::Positive))
        .given([Condition::NonZero(s.dgamma)])
        .by_signs([Condition::Positive(-(s.dgamma * (-(drop * s.dgamma) - friction_secant * s.dgamma)))]);
    page.correct();
}

/// The paper's motor with replaced coupling constants, for the remarks of section 6.
pub fn motor_with(s: &Letters, bars: u32, replacements: &[(Sym, Sym)]) -> MultiCurrent<Sym> {
    let motor = s.motor(bars);
    MultiCurrent { windings: motor.windings.map(|p| p.substitute(replacements)), bars: motor.bars }
}
