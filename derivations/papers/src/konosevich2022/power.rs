//! Additional results: the power balance of every machine, and a Lyapunov function.

use super::alphabet::{current, letter};
use super::letters::Letters;
use super::section3::{WithFriction, decreasing, driven, excess_friction, friction};
use claims::{Condition, Page};
use field::{Circle, Tangent};
use machines::asynchronous::Asynchronous;
use machines::brushed::Brushed;
use machines::crossed_windings::CrossedWindings;
use machines::equivalent_windings::EquivalentWindings;
use machines::kloss::Kloss;
use machines::permanent_magnet::{Magnets, PermanentMagnet};
use machines::synchronous::Synchronous;
use mechanics::differentiate::along;
use motor::FreeRotor;
use motor::{Machine, electrical_power, is_fed, joule_heat, motional_torque, stored_energy, torque_and_current_rates};
use nalgebra::Vector3;
use symbolic::Sym;
use systems::gyrostat::forms::{Form, SecondForm};

use Condition::{Equal, NonZero, Positive};

pub fn claims(page: &mut Page, s: &Letters) {
    page.section("Beyond the paper: power");
    power(page, s);
    every_machine(page, s);
}

/// Claims on dE/dt of the bodies, of the circuits, and of both together.
fn power(page: &mut Page, s: &Letters) {
    let g = s.general();
    let moving = Vector3::from(along(s.w.into(), s.dw.into()));
    let rotor = Tangent::moving(s.dphi, s.ddphi);
    let nu = Vector3::from(along(s.nu.into(), s.nu.cross(&s.w).into()));
    let energy = g.kinetic_energy(moving, rotor) + g.potential_energy(nu);
    let residual = g.by_momentum(&s.motion());
    let along_motion = (0..3).fold(s.dphi * residual[3], |sum, i| sum + s.w[i] * residual[i]);
    page.claim("beyond-power", "bodies", r"$\frac{d}{dt}(T + V) = M\dot\varphi'$ along the motion, since the difference is $\omega\cdot$(carrier's equations) $+\ \dot\varphi'$(rotor's equation)")
        .in_words()
        .under(&s.unit_axis)
        .follows([Equal(energy.slope - s.torque * s.dphi, along_motion)]);
    circuits(page, s);
}

fn circuits(page: &mut Page, s: &Letters) {
    let bars = 3;
    let currents = s.currents(bars);
    let motor = s.motor(bars);
    let (moment, rates) = driven(motor.clone(), s, &currents);
    let machine = WithFriction { machine: motor, friction: friction(s.dgamma + s.omega_field) };
    let moving: Vec<Tangent<Sym>> = currents.iter().zip(&rates).map(|(&i, &rate)| Tangent::moving(i, rate)).collect();
    let stored = stored_energy(&machine, s.angle().moving(s.dgamma), &moving);
    let speed = s.dgamma + s.omega_field;
    let lost = joule_heat(&machine, &currents);
    let friction_power = friction(speed) * speed;
    let supplied = s.omega_field * (moment - friction(speed));
    page.claim("beyond-power", "balance", r"Three bars at any angles, with the circuits' energy $-b_0\cos\gamma + \frac12L_1x^2 + \frac12L_2\sum i_n^2$, have $\dot E = \Omega(M - M_2) + \dot\varphi'M_2 - \mu\dot\gamma^2 - R_1x^2 - R_2\sum i_n^2$. The terms are the supply of the turning field, friction and heat")
        .in_words()
        .follows([Equal(
            moment * speed + stored.slope,
            supplied + friction_power - letter("μ") * s.dgamma.powi(2) - lost,
        )]);
    page.claim("beyond-power", "falling", r"$W = E - \Omega A'p' + c_0\gamma$ has $\dot W = \dot\gamma\,\Delta M_2(\dot\gamma) - \mu\dot\gamma^2 - R_1x^2 - R_2\sum i_n^2$ with three bars at any angles, since $(A'p')' = M$. Where friction is dissipative, $W$ never grows")
        .in_words()
        .note(r"At fixed vertical momentum and fixed $\nu\cdot\nu$, $W$ is a Lyapunov function near a stationary motion where it has a strict minimum. In $\gamma$ this requires $b_0\cos\gamma > 0$, the family $\gamma^{(0)}$.")
        .follows([Equal(
            falling(s, bars),
            s.dgamma * excess_friction(s) - letter("μ") * s.dgamma.powi(2) - lost,
        )]);
    let secant = letter("κ");
    for (slug, name, moved) in [
        ("falling-strictly", r"$\dot\gamma\ne0$", s.dgamma),
        ("falling-strictly-excitation", r"the excitation's current $x\ne0$", letter("x")),
        ("falling-strictly-bar", r"the bar's current $i_1\ne0$", current(1)),
    ] {
        page.claim("beyond-power", slug, format!(r"$W = E - \Omega A'p' + c_0\gamma$ falls, $-\dot W > 0$, where {name}. The law is strictly decreasing, written as $\Delta M_2=-\kappa\dot\gamma$, $\kappa>0$, and one bar stands at any angle (further bars: beyond-power/bar)"))
            .given([secant, letter("R1"), letter("R2"), letter("μ")].map(Positive))
            .given([NonZero(moved)])
            .by_signs([Positive(-decreasing(s, falling(s, 1), secant))]);
    }
    page.claim("beyond-power", "bar", r"A further bar at any angle adds $-R_2i_n^2$ to $\dot W$ and nothing else, here the second and the third. With any number of bars $-\dot W>0$ unless $\dot\gamma$ and all currents vanish")
        .in_words()
        .follows([2, 3].map(|n| Equal(falling(s, n) - falling(s, n - 1), -(letter("R2") * current(n).powi(2)))));
    let potential = -(s.b0 * s.angle().cos);
    page.claim("beyond-power", "minimum", r"As a function of $\gamma$ the function $W$ has the slope $b_0\sin\gamma + c_0$ and the curvature $b_0\cos\gamma$, which is positive at $\gamma^{(0)}$ and negative at $\gamma^{(1)}$ (section6-gamma/ranges)")
        .in_words()
        .follows([
            Equal((potential + s.c0 * s.gamma).diff(s.gamma), s.b0 * s.angle().sin + s.c0),
            Equal((potential + s.c0 * s.gamma).diff(s.gamma).diff(s.gamma), s.b0 * s.angle().cos),
        ]);
}

/// The rate dW/dt of W = E - W_field A' p' + c0 g with bars at any angles, where d(A' p')/dt = M.
fn falling(s: &Letters, bars: u32) -> Sym {
    let (moment, rates) = driven(s.motor(bars), s, &s.currents(bars));
    let speed = s.dgamma + s.omega_field;
    let machine = WithFriction { machine: s.motor(bars), friction: friction(speed) };
    let moving: Vec<Tangent<Sym>> =
        s.currents(bars).into_iter().zip(rates).map(|(i, rate)| Tangent::moving(i, rate)).collect();
    let stored = stored_energy(&machine, s.angle().moving(s.dgamma), &moving);
    moment * speed + stored.slope - s.omega_field * moment - friction(s.omega_field) * s.dgamma
}

/// Claims on the power balance of each motor model: M phi' plus the rate of the stored energy equals supply, friction
/// and heat.
fn every_machine(page: &mut Page, s: &Letters) {
    let [k, f, pull_out, pull_out_slip] = ["k", "f", "Mk", "sk"].map(letter);
    let field_speed = s.omega_field;
    balance(page, s, "free-rotor", "A free rotor", &FreeRotor::default());
    balance(page, s, "asynchronous", "A linear asynchronous motor", &Asynchronous { field_speed, k, f });
    balance(page, s, "kloss", "An asynchronous motor after Kloss", &Kloss { field_speed, pull_out, pull_out_slip, f });
    balance(page, s, "synchronous", "A synchronous motor without currents", &Synchronous { field_speed, b0: s.b0, f });
    let windings = EquivalentWindings::new(s.windings(), 3, Circle::zero());
    balance(page, s, "equivalent-windings", "A motor with two equivalent windings", &windings);
    balance(page, s, "multi-current", "A motor with three bars at any angles", &s.motor(3));
    let [flux, inductance, resistance, voltage] = ["a1", "L1", "R1", "V"].map(letter);
    let crossed = CrossedWindings { field_speed, flux, inductance, resistance, f };
    balance(page, s, "crossed-windings", "A motor with two windings at right angles", &crossed);
    let magnets = Magnets { field_speed, voltage, flux, along: inductance, across: letter("L2"), resistance, f };
    let magnets = PermanentMagnet { magnets, pole_pairs: 2 };
    balance(page, s, "permanent-magnet", "A motor with magnets with two pairs of poles, in Park's axes,", &magnets);
    let brushed = Brushed { voltage, flux, inductance, resistance, f };
    balance(page, s, "brushed", "A motor with brushes on a constant voltage", &brushed);
    let form = SecondForm::new(s.a_star, s.l, s.axial, s.e * s.big_gamma);
    let (dw, reaction) = form.prescribed(s.w, s.nu, field_speed);
    let w = Vector3::from(along(s.w.into(), dw.into()));
    let nu = Vector3::from(along(s.nu.into(), s.nu.cross(&s.w).into()));
    let energy = form.energy(w, nu, Tangent::fixed(field_speed));
    page.claim("beyond-power", "constant-speed", r"At constant rotor speed $\dot E = \Omega M$ along the motion that the program integrates, with the reaction $M = A'\,l\cdot\dot\omega = (A'p')'$, so that $E - \Omega A'p'$ is conserved")
        .in_words()
        .follows([Equal(energy.slope, field_speed * reaction), Equal(reaction, s.axial * s.l.dot(&dw))]);
}

fn balance(page: &mut Page, s: &Letters, slug: &'static str, name: &str, machine: &impl Machine<Sym>) {
    let currents: Vec<Sym> = s.currents(3).into_iter().take(machine.windings()).collect();
    let mut rates = vec![Sym::ZERO; currents.len()];
    let moment = torque_and_current_rates(machine, s.angle(), s.dgamma, &currents, &mut rates);
    let moving: Vec<Tangent<Sym>> = currents.iter().zip(rates).map(|(&i, rate)| Tangent::moving(i, rate)).collect();
    let stored = stored_energy(machine, s.angle().moving(s.dgamma), &moving).slope;
    let speed = s.dgamma + machine.frame_speed();
    let law = machine.torque_law(s.dgamma, speed);
    let (sliding, supply) = (motional_torque(machine, &currents), electrical_power(machine, s.angle(), &currents));
    let says = match is_fed(machine) {
        true => format!(
            r"{name} has the power balance $M\dot\varphi' + \dot W_m = \Omega(M - \sum c_ki_k) + \dot\gamma\,m + \sum v_ki_k - \sum R_ki_k^2$. Here $W_m$ is the energy of the circuits, $m$ the law of friction and slip, $c_k$ the motional voltages per unit of speed, and $v_k$ the supply voltages"
        ),
        false => format!(
            r"{name} has the power balance $M\dot\varphi' + \dot W_m = \Omega M + \dot\gamma\,m - \sum R_ki_k^2$, with the energy $W_m$ of the circuits and the law $m$ of friction and slip"
        ),
    };
    page.claim("beyond-power", slug, says).in_words().follows([Equal(
        moment * speed + stored,
        machine.frame_speed() * (moment - sliding) + s.dgamma * law + supply - joule_heat(machine, &currents),
    )]);
}
