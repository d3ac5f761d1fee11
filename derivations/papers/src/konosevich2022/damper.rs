//! Additional results: the bars of the damper winding, their equivalent windings, and their torque at constant slip.

use super::alphabet::{current, letter, number, one};
use super::letters::Letters;
use super::section3::driven;
use claims::{Condition, Page};
use field::{Analytic, Circle};
use machines::equivalent_windings::EquivalentWindings;
use motor::Machine;
use symbolic::Sym;

use Condition::{Equal, NonZero, Positive, Zero};

pub fn claims(page: &mut Page, s: &Letters) {
    page.section("Beyond the paper: the damper");
    for (bars, slug) in [(1, "one-bar"), (2, "two-bars"), (3, "three-bars"), (4, "four-bars"), (6, "six-bars")] {
        reduction(page, s, bars, slug);
    }
    every_number(page, s);
    other_modes(page, s);
    constant_slip(page, s);
}

/// Claims: the motor with N bars and its equivalent have equal torque, and the equivalent currents j_k = sum_n i_n (u_n
/// . d_k) / w satisfy the equivalent equations, where d_k are the axes of the equivalent windings and w is sqrt(N) or
/// sqrt(N/2).
fn reduction(page: &mut Page, s: &Letters, bars: u32, slug: &'static str) {
    let motor = s.evenly_spaced(bars);
    let bar = motor.bars.last().copied().unwrap_or(Circle::zero());
    let lines = if bars < 3 { 1 } else { 2 };
    let weight = number(i64::from(bars), lines).sqrt();
    let equivalent = EquivalentWindings::new(s.windings(), bars as usize, bar);
    let quarter = Circle { cos: Sym::ZERO, sin: one() };
    let axes = [bar, bar + quarter];
    let currents = s.currents(bars);
    let (moment, rates) = driven(motor.clone(), s, &currents);
    let combine = |values: &[Sym], axis: Circle<Sym>| {
        motor.bars.iter().zip(values).fold(Sym::ZERO, |sum, (bar, &i)| sum + i * (*bar - axis).cos) / weight
    };
    let lump = |values: &[Sym]| -> Vec<Sym> {
        let lumped = axes.iter().take(lines as usize).map(|&axis| combine(&values[1..], axis));
        std::iter::once(values[0]).chain(lumped).collect()
    };
    let (same_moment, same_rates) = driven(equivalent.clone(), s, &lump(&currents));
    let lumped_rates = lump(&rates);
    let says = if lines == 1 {
        format!(
            r"With $n_2={bars}$ all bars lie along one line, and the torque and the rates of the currents are those of one winding with the flux $a_2\sqrt{{{bars}}}$"
        )
    } else {
        format!(
            r"With $n_2={bars}$ the torque and the rates of the currents are those of two equal windings at right angles with the flux $a_2\sqrt{{{bars}/2}}$"
        )
    };
    page.claim("beyond-damper", slug, says).in_words().follows(
        std::iter::once(Equal(moment, same_moment))
            .chain(lumped_rates.iter().zip(&same_rates).map(|(&a, &b)| Equal(a, b))),
    );
    debug_assert_eq!(equivalent.windings(), 1 + lines as usize);
}

/// Claims for every N: the sum of u_n u_n^T over evenly spaced bars, by induction on the sum of the doubled angles.
fn every_number(page: &mut Page, s: &Letters) {
    let bar = |name: &str| Circle { cos: letter(&format!("c{name}")), sin: letter(&format!("s{name}")) };
    // half of the doubled step, h = 2 pi/N, and the doubled angle after n steps
    let (half, at) = (bar("h"), bar("n"));
    let step = half + half;
    let next = at + step;
    // closed form of sum_{k=1..n} cos(k 2h) at the doubled angle n 2h: (sin(n 2h + h) - sin h) / (2 sin h)
    let cosines = |end: Circle<Sym>| ((end + half).sin - half.sin) / (number(2, 1) * half.sin);
    let sines = |end: Circle<Sym>| (half.cos - (end + half).cos) / (number(2, 1) * half.sin);
    page.claim("beyond-damper", "sums", r"$\sum_{k=1}^n\cos 2kh = \frac{\sin(2n+1)h - \sin h}{2\sin h}$ and $\sum_{k=1}^n\sin 2kh = \frac{\cos h - \cos(2n+1)h}{2\sin h}$, by induction over $n$: beginning and step. At $h = 2\pi/N$, $n = N$ the angle $2nh=4\pi$ is that of the beginning, where both sums are zero. The denominator vanishes for $N=1$ and $N=2$ only")
        .in_words()
        .under(&symbolic::Hypotheses::none().on_circle(half).on_circle(at))
        .given([NonZero(half.sin)])
        .follows([
            Zero(cosines(Circle::zero())),
            Zero(sines(Circle::zero())),
            Equal(cosines(next) - cosines(at), next.cos),
            Equal(sines(next) - sines(at), next.sin),
        ]);
    // the dyad of a bar in terms of its doubled angle
    let t = bar("t");
    let doubled = t + t;
    page.claim("beyond-damper", "dyad", r"$u u^T = \frac12\left(1 + \begin{pmatrix}\cos2t&\sin2t\\ \sin2t&-\cos2t\end{pmatrix}\right)$ for a bar's direction $u=(\cos t,\sin t)$. Summed over evenly spaced bars, by claim beyond-damper/sums, $\sum u_nu_n^T$ is $\frac N2$ times the unit matrix for every $N\ge3$")
        .in_words()
        .under(&symbolic::Hypotheses::none().on_circle(t))
        .follows([
            Equal(t.cos * t.cos, (one() + doubled.cos) / number(2, 1)),
            Equal(t.cos * t.sin, doubled.sin / number(2, 1)),
            Equal(t.sin * t.sin, (one() - doubled.cos) / number(2, 1)),
        ]);
    // closure of the equations for arbitrary angles, bar by bar: the total sums are sums of these
    let gamma = s.angle();
    let (a2, l2, r2, i) = (letter("a2"), letter("L2"), letter("R2"), current(1));
    let rate = (a2 * s.dgamma * (gamma + t).cos - r2 * i) / l2;
    page.claim("beyond-damper", "closure", r"A bar at any angle $t$ with the direction $u=(\cos t,\sin t)$ has the torque $-a_2\,(i\,u)\cdot(\cos\gamma,-\sin\gamma)$, and $L_2(i\,u)' = -R_2\,i\,u + a_2\dot\gamma\,uu^T(\cos\gamma,-\sin\gamma)$. Summed over the bars, the damper acts through $\sum i_nu_n$ alone, for any angles and any $N$")
        .in_words()
        .under(&symbolic::Hypotheses::none().on_circle(t))
        .follows([
            Equal(-(a2 * i * (gamma + t).cos), -(a2 * (i * t.cos * gamma.cos - i * t.sin * gamma.sin))),
            Equal(
                l2 * rate * t.cos,
                -(r2 * i * t.cos) + a2 * s.dgamma * (t.cos * t.cos * gamma.cos - t.cos * t.sin * gamma.sin),
            ),
            Equal(
                l2 * rate * t.sin,
                -(r2 * i * t.sin) + a2 * s.dgamma * (t.sin * t.cos * gamma.cos - t.sin * t.sin * gamma.sin),
            ),
        ]);
}

/// Claims: the other combinations of currents decay freely: one for N = 2 and N = 3 (the sum), two for N = 4.
fn other_modes(page: &mut Page, s: &Letters) {
    let mut decays = Vec::new();
    for (bars, modes) in
        [(2u32, vec![vec![1, 1]]), (3, vec![vec![1, 1, 1]]), (4, vec![vec![1, 0, 1, 0], vec![0, 1, 0, 1]])]
    {
        let currents = s.currents(bars);
        let (_, rates) = driven(s.evenly_spaced(bars), s, &currents);
        for mode in modes {
            let along =
                |values: &[Sym]| mode.iter().zip(&values[1..]).fold(Sym::ZERO, |sum, (&m, &i)| sum + number(m, 1) * i);
            decays.push(Equal(along(&rates), -(letter("R2") / letter("L2") * along(&currents))));
        }
    }
    page.claim("beyond-damper", "other-modes", r"Combinations of currents that are orthogonal to the bars' directions feel no field and die out as $e^{-R_2t/L_2}$: $i_1+i_2$ for $n_2=2$, $i_1+i_2+i_3$ for 3, $i_1+i_3$ and $i_2+i_4$ for 4")
        .in_words()
        .follows(decays);
}

/// Claims: at constant slip the damper winding is an asynchronous motor after Kloss.
fn constant_slip(page: &mut Page, s: &Letters) {
    let (a2, l2, r2) = (letter("a2"), letter("L2"), letter("R2"));
    let slip = s.dgamma;
    let gamma = s.angle();
    let norm = r2.powi(2) + (l2 * slip).powi(2);
    let steady = |bar: Circle<Sym>| {
        let p = gamma + bar;
        a2 * slip * (r2 * p.cos + l2 * slip * p.sin) / norm
    };
    let motor = s.motor(1);
    let currents = [Sym::ZERO, steady(motor.bars[0])];
    let (_, rates) = driven(motor, s, &currents);
    page.claim("beyond-damper", "constant-slip", r"At constant $\dot\gamma$ the equation of a bar at any angle $t_n$ has the solution $i_n = a_2\dot\gamma\,\frac{R_2\cos(\gamma+t_n) + L_2\dot\gamma\sin(\gamma+t_n)}{R_2^2 + L_2^2\dot\gamma^2}$")
        .in_words()
        .given([Positive(r2)])
        .follows([Equal(rates[1], currents[1].diff(s.gamma) * slip)]);
    for (bars, slug) in [(3u32, "kloss-three"), (4, "kloss-four"), (6, "kloss-six")] {
        let motor = s.evenly_spaced(bars);
        let moment = motor.bars.iter().fold(Sym::ZERO, |sum, &bar| sum - a2 * steady(bar) * (gamma + bar).cos);
        page.claim("beyond-damper", slug, format!(r"At constant $\dot\gamma$ the torque of $n_2={bars}$ evenly spaced bars is constant and is that of Kloss with the critical slip $R_2/L_2$: $-\frac{{n_2}}2\,\frac{{a_2^2R_2\dot\gamma}}{{R_2^2+L_2^2\dot\gamma^2}}$"))
            .in_words()
            .follows([Equal(moment, -(number(bars.into(), 2) * a2.powi(2) * r2 * slip / norm))]);
    }
    let single = s.evenly_spaced(1).bars[0];
    let moment = -(a2 * steady(single) * (gamma + single).cos);
    let double = (gamma + single) + (gamma + single);
    page.claim(
        "beyond-damper",
        "pulsating",
        r"At constant $\dot\gamma$ the torque of one bar is $-\frac{a_2^2\dot\gamma}{2(R_2^2+L_2^2\dot\gamma^2)}(R_2+R_2\cos2p+L_2\dot\gamma\sin2p)$ with $p=\gamma+t_1$. The torque pulsates with the angle $2p$ about its mean",
    )
    .in_words()
    .follows([Equal(
        moment,
        -(a2.powi(2) * slip / (number(2, 1) * norm) * (r2 + r2 * double.cos + l2 * slip * double.sin)),
    )]);
}
