//! Theorems on a synchronous motor under load, in the notation of Konosevich & Konosevich 2022, with M for the load.

use claims::{Condition, Page, Paper};
use field::{Circle, Scalar};
use machines::multi_current::{MultiCurrent, Windings};
use machines::synchronous::Synchronous;
use motor::{Bench, Machine, joule_heat};
use nalgebra::{DMatrix, Vector3};
use papers::konosevich2022::{Letters, dimension, letter};
use studies::synchronism::energy::height;
use symbolic::{Hypotheses, Sym};
use systems::gyrostat::driven::Driven;
use systems::gyrostat::forms::{FirstForm, Form};

use Condition::{Equal, Positive, Zero};

/// The entry of the page in the ledger.
pub const PAPER: Paper = Paper {
    key: "synchronism",
    title: "Synchronism of a motor under load",
    citation: "The workbench's own page. The motors are those of B. I. Konosevich, Yu. B. Konosevich 2022, sections 3 and 4; the equation of the motor without currents is that of F. Tricomi 1933, the work along the separatrix V. K. Melnikov's 1963.",
    summary: r"A rotor under a further load $M$ keeps an angle where $b_0\sin\gamma=-(M+f\Omega)$. The angles on both branches merge at $\cos\gamma=0$, a fold: one eigenvalue passes through zero there, whatever the windings. $V=\frac12A'\dot\gamma^2-b_0\cos\gamma+\sum\frac12L_ki_k^2+(M+f\Omega)\gamma$ never grows, so that a rotor with less of it than both neighbouring balances stays between them. To the first order in friction a rotor can slip for ever from $M+f\Omega=\frac4\pi f\sqrt{b_0/A'}$ on. In a gyrostat the rotor moves as one with the moment of inertia $1/(1/A'+l\cdot A^{-1}l)$.",
    entries: &["fold", "energy", "separatrix", "carrier"],
    page,
};

pub fn page() -> Page {
    let letters = Letters::default();
    let mut page = Page::of(PAPER.key, dimension);
    page.section("Synchronism: pull-out");
    fold(&mut page, &letters);
    page.section("Synchronism: what holds, and what does not");
    energy(&mut page, &letters);
    separatrix(&mut page, &letters);
    page.section("Synchronism: the motor in a gyrostat");
    carrier(&mut page, &letters);
    page
}

/// The motor without currents, with friction f.
fn plain(s: &Letters) -> Bench<Sym, Synchronous<Sym>> {
    let machine = Synchronous { field_speed: s.omega_field, b0: s.b0, f: letter("f") };
    Bench { machine, axial: s.axial }
}

/// The motor with an excitation winding and bars, with friction f.
fn wound(s: &Letters, bars: u32) -> Bench<Sym, MultiCurrent<Sym>> {
    let windings = Windings { f: letter("f"), ..s.windings() };
    Bench { machine: MultiCurrent { windings, ..s.evenly_spaced(bars) }, axial: s.axial }
}

/// The state: angle, slip, x, i1, ...
fn state(s: &Letters, bars: u32) -> Vec<Sym> {
    [s.gamma, s.dgamma].into_iter().chain(s.currents(bars)).collect()
}

fn rates<M: Machine<Sym>>(bench: &Bench<Sym, M>, s: &Letters, state: &[Sym]) -> Vec<Sym> {
    let mut rates = vec![Sym::ZERO; state.len()];
    bench.rates_under(s.torque, state, &mut rates);
    rates
}

/// The determinant of the linearised equations at rest.
fn determinant(state: &[Sym], rates: &[Sym]) -> Sym {
    let at_rest: Vec<(Sym, Sym)> = state.iter().skip(1).map(|&y| (y, Sym::ZERO)).collect();
    let matrix = DMatrix::from_fn(state.len(), state.len(), |i, j| rates[i].diff(state[j]).substitute(&at_rest));
    laplace(&matrix)
}

/// The determinant by Laplace expansion along the first row.
fn laplace(matrix: &DMatrix<Sym>) -> Sym {
    if matrix.nrows() == 0 {
        return Sym::int(1);
    }
    (0..matrix.ncols()).filter(|&j| matrix[(0, j)] != Sym::ZERO).fold(Sym::ZERO, |sum, j| {
        let minor = laplace(&matrix.clone().remove_row(0).remove_column(j));
        let sign = if j.is_multiple_of(2) { Sym::int(1) } else { Sym::int(-1) };
        sum + sign * matrix[(0, j)] * minor
    })
}

fn fold(page: &mut Page, s: &Letters) {
    let bench = plain(s);
    let held = [s.gamma, Sym::ZERO];
    let angle = s.angle();
    let balance = rates(&bench, s, &held)[1] * s.axial + s.torque;
    page.claim("fold", "load", r"The load under which the rotor keeps an angle is $M(\gamma)=-b_0\sin\gamma-f\Omega$. Its slope is $-b_0\cos\gamma$, and its second derivative $b_0\sin\gamma$ is not zero where the slope is zero, so that each fold is a simple one, at which two angles merge")
        .in_words()
        .follows([
            Equal(balance, -(s.b0 * angle.sin) - letter("f") * s.omega_field),
            Equal(balance.diff(s.gamma), -(s.b0 * angle.cos)),
            Equal(balance.diff(s.gamma).diff(s.gamma), s.b0 * angle.sin),
        ]);
    let free = [s.gamma, s.dgamma];
    let law = rates(&bench, s, &free);
    let trace = law[0].diff(free[0]) + law[1].diff(free[1]);
    page.claim("fold", "exchange", r"For a synchronous motor without currents, linearised at a balance, the eigenvalues have the product $b_0\cos\gamma/A'$ and the sum $-f/A'$. With $f>0$ both are in the left half-plane where $\cos\gamma>0$, and one is positive where $\cos\gamma<0$, so that stability is exchanged at the fold")
        .in_words()
        .follows([
            Equal(determinant(&free, &law), s.b0 * angle.cos / s.axial),
            Equal(trace, -(letter("f") / s.axial)),
        ]);
    let (r1, l1, r2, l2) = (letter("R1"), letter("L1"), letter("R2"), letter("L2"));
    for (bars, slug) in [(1u32, "one-bar"), (2, "two-bars"), (3, "three-bars")] {
        let (bench, state) = (wound(s, bars), state(s, bars));
        let sign = if bars.is_multiple_of(2) { Sym::int(-1) } else { Sym::int(1) };
        let windings = r1 / l1 * (0..bars).fold(Sym::int(1), |product, _| product * (r2 / l2));
        page.claim("fold", slug, format!(r"With the excitation and $n_2={bars}$ the product of all eigenvalues is $\pm\frac{{b_0\cos\gamma}}{{A'}}\frac{{R_1}}{{L_1}}\left(\frac{{R_2}}{{L_2}}\right)^{{{bars}}}$. Currents and damping move no fold, for an eigenvalue is zero where $\cos\gamma=0$ only"))
            .in_words()
            .given([Positive(r2)])
            .follows([Equal(determinant(&state, &rates(&bench, s, &state)), sign * s.b0 * angle.cos / s.axial * windings)]);
    }
}

fn energy(page: &mut Page, s: &Letters) {
    for (bars, slug) in [(1u32, "one-bar"), (2, "two-bars"), (3, "three-bars")] {
        let (bench, state) = (wound(s, bars), state(s, bars));
        let law = rates(&bench, s, &state);
        let value = height(&bench, s.torque, &state);
        let rate = state.iter().zip(&law).fold(Sym::ZERO, |sum, (&y, &dy)| sum + value.diff(y) * dy);
        let loss = (letter("μ") + letter("f")) * s.dgamma.powi(2) + joule_heat(&bench.machine, &state[2..]);
        let at_rest: Vec<(Sym, Sym)> = state.iter().skip(1).map(|&y| (y, Sym::ZERO)).collect();
        let moving = stored(s, &state);
        page.claim("energy", slug, format!(r"Under a constant load, with the excitation and $n_2={bars}$, $\dot V=-(\mu+f)\dot\gamma^2-\sum R_ki_k^2$, and $V=V|_{{\dot\gamma=i=0}}(\gamma)+\frac12A'\dot\gamma^2+\sum\frac12L_ki_k^2$. A rotor whose $V$ is less than at both neighbouring balances therefore stays between them (that it comes to rest at the angle there is LaSalle's theorem, which is cited)"))
            .in_words()
            .follows([Equal(rate, -loss), Equal(value, value.substitute(&at_rest) + moving)]);
    }
}

/// The energy 1/2 A' g'^2 + sum 1/2 L_k i_k^2 as a function of (g, g', x, i1, ...).
fn stored(s: &Letters, state: &[Sym]) -> Sym {
    let inductances = std::iter::once("L1").chain(std::iter::repeat("L2")).map(letter);
    let squares = std::iter::once(s.axial).chain(inductances).zip(&state[1..]);
    squares.fold(Sym::ZERO, |sum, (inertia, &speed)| sum + inertia * speed.powi(2)).half()
}

fn separatrix(page: &mut Page, s: &Letters) {
    // half of the angle; w = sqrt(b0/A') is represented by its square
    let half = Circle { cos: letter("c"), sin: letter("s") };
    let (frequency, f) = (letter("Ω′"), letter("f"));
    let speed = Sym::int(2) * frequency * half.cos;
    let bench = plain(s);
    let energy = bench.machine.field_energy(half + half) + (s.axial * speed.powi(2)).half();
    page.claim("separatrix", "speed", r"Without friction and load $|\dot\gamma|=2\Omega'\cos\frac\gamma2$, $\Omega'^2=b_0/A'$, has the energy $b_0$ of the balance at $\gamma=\pi$. It is the motion that leaves the balance and comes back after a turn")
        .in_words()
        .under(&Hypotheses::none().on_circle(half))
        .given([Zero(s.axial * frequency.powi(2) - s.b0)])
        .by_combination([(Equal(energy, s.b0), vec![], vec![(0, Sym::int(2) * half.cos.powi(2))])]);
    // d/dg = (1/2) d/d(g/2)
    let primitive = |half: Circle<Sym>| Sym::int(4) * frequency * half.sin;
    let slope = Sym::int(4) * frequency * half.moving(Sym::int(1)).sin.slope;
    let quarter = |sign: i64| Circle { cos: Sym::ZERO, sin: Sym::int(sign) };
    page.claim("separatrix", "work", r"Along $|\dot\gamma|=2\Omega'\cos\frac\gamma2$, $\Omega'^2=b_0/A'$, friction takes $\int_{-\pi}^{\pi}f\,|\dot\gamma|\,d\gamma=8f\Omega'$. A drag $P=M+f\Omega$ gives $2\pi P$ in a turn. Both are equal at $P=\frac4\pi f\Omega'$, which to the first order in friction is the threshold of lasting slip (Melnikov's method, which is cited)")
        .in_words()
        .follows([
            Equal(slope.half(), speed),
            Equal(f * (primitive(quarter(1)) - primitive(quarter(-1))), Sym::int(8) * f * frequency),
        ]);
}

fn carrier(page: &mut Page, s: &Letters) {
    let weight = s.e * s.big_gamma;
    let form = FirstForm::new(s.a, s.l, s.axial, weight);
    let of = |moment: Sym| form.accelerations(s.w, s.nu, s.dphi, moment).1;
    let lightness = (0..3).fold(Sym::int(1) / s.axial, |sum, i| sum + s.l[i].powi(2) / s.a[i]);
    page.claim("carrier", "lightness", r"In a gyrostat the torque $M$ of motor and load gives the rotor, in any motion, the relative acceleration $\left(\frac1{A'}+l\cdot A^{-1}l\right)M$ in addition to that which it has without $M$. The rotor is lighter than on a bench, where it has $M/A'$")
        .in_words()
        .follows([Equal(of(s.torque) - of(Sym::ZERO), lightness * s.torque)]);
    let machine = Synchronous { field_speed: s.omega_field, b0: s.b0, f: letter("f") };
    // l along the third principal axis, which is vertical and contains the centre of mass
    let zero = Sym::ZERO;
    let upright = Vector3::new(zero, zero, Sym::int(1));
    let form = FirstForm::new(s.a, upright, s.axial, upright * s.big_gamma);
    let law = Driven::new(form, machine);
    let spin = letter("ω3");
    let at = [zero, zero, spin, zero, zero, Sym::int(1), s.gamma, s.dgamma];
    let mut found = [zero; 8];
    law.rates_under(s.torque, &at, &mut found);
    let light = Bench { axial: s.axial * s.a.z / (s.axial + s.a.z), ..plain(s) };
    let alone = rates(&light, s, &[s.gamma, s.dgamma]);
    page.claim("carrier", "upright", r"About a vertical rotor axis that is a principal axis and holds the centre of mass the carrier stays upright, and the motor is exactly one on a bench with the moment of inertia $A'A_3/(A'+A_3)$")
        .in_words()
        .given([Positive(s.axial), Positive(s.a.z)])
        .follows([
            Zero(found[0]),
            Zero(found[1]),
            Zero(found[3]),
            Zero(found[4]),
            Zero(found[5]),
            Equal(found[6], alone[0]),
            Equal(found[7], alone[1]),
        ]);
}
