//! The motor in the characteristic equation: one function of z, which interpolates between the two classical gyrostats.

use super::alphabet::{letter, vector};
use super::letters::{free, kept, stationary, unit_vectors};
use claims::{Condition, Page};
use field::{Circle, Scalar, Tangent};
use machines::asynchronous::Asynchronous;
use machines::equivalent_windings::EquivalentWindings;
use machines::synchronous::Synchronous;
use mechanics::rotation::determinant;
use motor::{Machine, torque_and_current_rates};
use nalgebra::{Matrix3, Matrix4};
use papers::konosevich2022::{self as paper, Letters};
use studies::stationary::stability::linear::variation;
use studies::stationary::stability::state::StationaryState;
use symbolic::Sym;

use Condition::{Equal, NonZero, Positive, Zero};

pub fn claims(page: &mut Page, s: &Letters) {
    page.section("Stability: motors");
    motor(page, s);
    currents(page, s);
    damping(page);
}

/// The operational stiffness Z(z): the torque opposite to a deviation exp(z t) of the rotor's angle, including the
/// effect of its currents.
fn stiffness(machine: &impl Machine<Sym>, angle: Circle<Sym>, z: Sym) -> Sym {
    let windings = machine.windings();
    let (moved, slip) = (angle.moving(Sym::int(1)), Tangent::moving(Sym::ZERO, z));
    let rates = |currents: &[Tangent<Sym>]| {
        let mut rates = vec![Tangent::fixed(Sym::ZERO); windings];
        let moment = torque_and_current_rates(machine, moved, slip, currents, &mut rates);
        (moment.slope, rates)
    };
    let (_, induced) = rates(&vec![Tangent::fixed(Sym::ZERO); windings]);
    // with the rotor at rest each current decays independently
    let some = paper::letter("x");
    let mut fading = vec![Tangent::fixed(Sym::ZERO); windings];
    let moving = vec![Tangent::moving(Sym::ZERO, some); windings];
    torque_and_current_rates(machine, angle.map(Tangent::fixed), Tangent::fixed(Sym::ZERO), &moving, &mut fading);
    // z i = induced + own i
    let current = |(induced, own): (&Tangent<Sym>, &Tangent<Sym>)| {
        Tangent::moving(Sym::ZERO, induced.slope / (z - own.slope / some))
    };
    let currents: Vec<Tangent<Sym>> = induced.iter().zip(&fading).map(current).collect();
    -rates(&currents).0
}

fn motor(page: &mut Page, s: &Letters) {
    let z = letter("z");
    let machine = Synchronous { field_speed: s.omega_field, b0: s.b0, f: paper::letter("f") };
    let eta = vector("η");
    let gamma = letter("δγ");
    let tilt = s.nu.cross(&eta) / z;
    let w = tilt * s.omega0 + eta;
    let y: Vec<Sym> = w.iter().chain(tilt.iter()).copied().chain([gamma, z * gamma]).collect();
    let dy: Vec<Sym> = y.iter().map(|&one| z * one).collect();
    let place = StationaryState { speed: s.omega0, vertical: s.nu, rotor_speed: s.omega_field, angle: s.angle() };
    let found = variation(&stationary(s), &machine, &place, &y, &dy);
    let lever = s.l.cross(&s.nu) * s.omega0;
    let (above, below) = (s.l * z - lever, s.l * z + lever);
    let (kept, free) = (kept(s), free(s));
    let carrier = kept.pencil(z) * eta + above * (s.axial * z.powi(2) * gamma);
    let of_motor = stiffness(&machine, s.angle(), z);
    let rotor = s.axial * (below.dot(&eta) + z.powi(2) * gamma) + of_motor * gamma;
    page.claim("motor", "pencil", r"With the synchronous motor without currents the variation of a stationary motion is $K\eta+A'z^2(zl-\omega^0l\times\nu)\delta\gamma=0$, $A'(zl+\omega^0l\times\nu)\cdot\eta+(A'z^2+Z)\delta\gamma=0$, where the motor adds its operational stiffness $Z(z)=-\delta M/\delta\gamma$ alone")
        .in_words()
        .under(&unit_vectors(s))
        .follows((0..3).map(|i| Equal(z * found[i], carrier[i])).chain([Equal(found[7], rotor)]));
    let generic = Matrix3::from_fn(|i, j| letter(&format!("k{}{}", i + 1, j + 1)));
    let (u, v) = (vector("v"), vector("w"));
    let (axial, stiff) = (s.axial, letter("Z"));
    let bordered = Matrix4::from_fn(|i, j| match (i, j) {
        (3, 3) => axial * z.powi(2) + stiff,
        (3, _) => axial * v[j],
        (_, 3) => axial * z.powi(2) * u[i],
        _ => generic[(i, j)],
    });
    page.claim("motor", "lemma", r"For any matrix $K$ and vectors $v$, $w$, $\det\begin{pmatrix}K&A'z^2v\\A'w^T&A'z^2+Z\end{pmatrix}=A'z^2\det(K-A'vw^T)+Z\det K$")
        .in_words()
        .follows([Equal(
            expanded(&bordered),
            axial * z.powi(2) * determinant(&(generic - u * v.transpose() * axial)) + stiff * determinant(&generic),
        )]);
    let left = kept.pencil(z) - above * below.transpose() * s.axial;
    let right = free.pencil(z);
    page.claim("motor", "between", r"$K-A'(zl-\omega^0l\times\nu)(zl+\omega^0l\times\nu)^T=K_f$, that of the free rotor ($A$ and $A'(\Omega+\omega^0l\cdot\nu)$ for $A^*$ and $A'\Omega$). By stability/motor/lemma the characteristic equation with a motor of the stiffness $Z$ is $A'z^2\det K_f+Z\det K=0$, that is $A'\det A\,z^2p_f(z)+Z(z)\det A^*p_c(z)=0$. The free rotor has $Z=0$")
        .in_words()
        .under(&unit_vectors(s))
        .follows((0..9).map(|k| Equal(left[(k / 3, k % 3)], right[(k / 3, k % 3)])));
    let difference = free.pulled_back() - kept.pulled_back();
    page.claim("motor", "unfelt", r"With the rotor along the vertical, $l=\nu$, $[\nu]H[\nu]$ of the free rotor is that of constant speed: the rotor feels no tilt")
        .in_words()
        .given((0..3).map(|i| Zero(s.l[i] - s.nu[i])))
        .by_combination((0..9).map(|entry| {
            // the difference is w0^2 A' (l x nu)(l x nu)^T
            let (row, i) = (entry / 3, entry % 3);
            let m = s.l.cross(&s.nu);
            let factor = s.omega0.powi(2) * s.axial * m[row];
            let [j, k] = [(i + 1) % 3, (i + 2) % 3];
            (Zero(difference[(row, i)]), vec![], vec![(j, factor * s.nu[k]), (k, -(factor * s.nu[j]))])
        }));
    crossing(page);
}

/// The condition for a change of the verdict along a family.
fn crossing(page: &mut Page) {
    let [square, of_kept, of_free] = ["σ", "pc", "pf"].map(letter);
    let [front, real, imaginary] = ["J", "X", "Y"].map(letter);
    page.claim("motor", "crossing", r"On the imaginary axis, $z=iy$, $s=-y^2$, the polynomials $p_c$ and $p_f$ are real, and of the characteristic equation $A'D\,sp_f+Zp_c=0$, $D=\det A/\det A^*$, both parts vanish. Where the motor damps, $\operatorname{Im}Z\ne0$, a root on the axis is therefore one of $p_c$ and of $sp_f$")
        .given([
            Zero(front * square * of_free + real * of_kept),
            Zero(imaginary * of_kept),
            NonZero(imaginary),
            NonZero(front),
        ])
        .by_combination([
            (Zero(of_kept), vec![2], vec![(1, Sym::int(1))]),
            (Zero(square * of_free), vec![2, 3], vec![(0, imaginary), (1, -real)]),
        ]);
}

/// The determinant by expansion along the last row.
fn expanded(m: &Matrix4<Sym>) -> Sym {
    (0..4).fold(Sym::ZERO, |sum, column| {
        let others: Vec<usize> = (0..4).filter(|j| *j != column).collect();
        let minor = determinant(&Matrix3::from_fn(|i, j| m[(i, others[j])]));
        let term = m[(3, column)] * minor;
        if column % 2 == 1 { sum + term } else { sum - term }
    })
}

fn currents(page: &mut Page, s: &Letters) {
    let z = letter("z");
    let (k, f) = (paper::letter("k"), paper::letter("f"));
    let slipping = Asynchronous { field_speed: s.omega_field, k, f };
    page.claim("currents", "asynchronous", r"The asynchronous motor without currents has $Z=(k+f)z$")
        .in_words()
        .follows([Equal(stiffness(&slipping, s.angle(), z), (k + f) * z)]);
    let in_step = Synchronous { field_speed: s.omega_field, b0: s.b0, f };
    page.claim("currents", "synchronous", r"The synchronous motor without currents has $Z=b_0\cos\gamma^0+fz$")
        .in_words()
        .follows([Equal(stiffness(&in_step, s.angle(), z), s.b0 * s.angle().cos + f * z)]);
    let w = s.windings();
    let relaxing = |bars: i64| {
        s.b0 * s.angle().cos
            + w.mu * z
            + (w.a1 * s.angle().sin).powi(2) * z / (w.r1 + w.l1 * z)
            + w.a2.powi(2) * Sym::ratio(bars, 2) * z / (w.r2 + w.l2 * z)
    };
    for (bars, slug) in [(3, "three-bars"), (4, "four-bars"), (6, "six-bars")] {
        page.claim("currents", slug, format!(r"The synchronous motor with the currents of the excitation and of {bars} evenly spaced bars has $Z=b_0\cos\gamma^0+\mu z+a_1^2\sin^2\gamma^0\,z/(R_1+L_1z)+\frac{{{bars}}}2a_2^2\,z/(R_2+L_2z)$, in which the bars are one term, whatever the angle"))
            .in_words()
            .follows([Equal(stiffness(&s.evenly_spaced(bars), s.angle(), z), relaxing(bars.into()))]);
        let bar = -Circle::exact_turn(1, 8).unwrap_or(Circle::zero());
        let lumped = EquivalentWindings::new(s.windings(), bars as usize, bar);
        let slug =
            ["three-lumped", "four-lumped", "six-lumped"][[3, 4, 6].iter().position(|n| *n == bars).unwrap_or(0)];
        page.claim(
            "currents",
            slug,
            format!(r"The two windings that are equivalent to {bars} evenly spaced bars have the $Z$ of these"),
        )
        .in_words()
        .follows([Equal(stiffness(&lumped, s.angle(), z), relaxing(bars.into()))]);
    }
    let y = letter("y");
    let bars = s.evenly_spaced(3);
    let odd = (stiffness(&bars, s.angle(), z) - stiffness(&bars, s.angle(), -z)).half();
    let lag = |slope: Sym, square: Sym| {
        let of = |strength: Sym, r: Sym, l: Sym| strength * r / (r.powi(2) - l.powi(2) * square);
        w.mu + of(slope.powi(2), w.r1, w.l1) + of(w.a2.powi(2) * Sym::ratio(3, 2), w.r2, w.l2)
    };
    page.claim("currents", "lagging", r"The odd part of $Z$ with the currents of the excitation and of three bars, which on the axis is $i\operatorname{Im}Z$, is $\frac12(Z(z)-Z(-z))=z\,(\mu+a_1^2\sin^2\gamma^0R_1/(R_1^2-L_1^2z^2)+\frac32a_2^2R_2/(R_2^2-L_2^2z^2))$")
        .in_words()
        .follows([Equal(odd, z * lag(w.a1 * s.angle().sin, z.powi(2)))]);
    let resisting = [y, w.mu, w.a2, w.r1, w.r2, w.l1, w.l2];
    page.claim("currents", "damps", r"With the currents of the excitation and of three bars $\operatorname{Im}Z(iy)$, from stability/currents/lagging, is positive for $y>0$, for every $\psi_1'=-a_1\sin\gamma^0$. Every winding with a resistance damps")
        .in_words()
        .given(resisting.map(Positive))
        .by_signs([Positive(y * lag(letter("ψ"), -y.powi(2)))]);
    let still = relaxing(3);
    let without = [(w.l1, Sym::ZERO), (w.l2, Sym::ZERO)];
    let limit = symbolic::substitute_all(&[still], &without).first().copied().unwrap_or(Sym::UNDEFINED);
    let damping = w.mu + (w.a1 * s.angle().sin).powi(2) / w.r1 + w.a2.powi(2) * Sym::ratio(3, 2) / w.r2;
    page.claim("currents", "without-inductance", r"With $L_1=L_2=0$ the $Z$ of stability/currents/three-bars is $b_0\cos\gamma^0+dz$ with $d=\mu+a_1^2\sin^2\gamma^0/R_1+\frac32a_2^2/R_2$, that of a model without currents with the damping $d$")
        .in_words()
        .follows([Equal(limit, s.b0 * s.angle().cos + damping * z)]);
}

/// The Hurwitz minors of A'D z^2 p_f + (K + d z) p_c.
fn damping(page: &mut Page) {
    let [ac, bc, af, bf, axial, k, d] = ["ac", "bc", "af", "bf", "J", "K", "d"].map(letter);
    let minors = mechanics::stability::hurwitz([
        d / axial,
        af + k / axial,
        d * ac / axial,
        bf + k * ac / axial,
        d * bc / axial,
        k * bc / axial,
    ]);
    let between = ac * af - ac.powi(2) + bc - bf;
    let resultant = (bf - bc).powi(2) + (af - ac) * (af * bc - ac * bf);
    page.claim("damping", "minors", r"Without currents, $A'Dz^2p_f+(K+dz)p_c$ with $D=\det A/\det A^*$, the first, third and fifth minor of Hurwitz are $d/A'D$, $(d/A'D)^2(a_ca_f-a_c^2+b_c-b_f)$ and $-(d/A'D)^3b_cR$ with the resultant $R=(b_f-b_c)^2+(a_f-a_c)(a_fb_c-a_cb_f)$ of $p_c$ and $p_f$ in $z^2$. The stiffness $K$ occurs in none of them, and $d$ only as a factor")
        .in_words()
        .follows([
            Equal(minors[0], d / axial),
            Equal(minors[2], (d / axial).powi(2) * between),
            Equal(minors[4], -(d / axial).powi(3) * bc * resultant),
            Equal(minors[5], minors[4] * k * bc / axial),
        ]);
    let by_slip = mechanics::stability::hurwitz([d / axial, af, d * ac / axial, bf, d * bc / axial]);
    page.claim("damping", "asynchronous", "The first, third and fifth minor of Hurwitz of a motor by slip, $A'Dzp_f+dp_c$, are those of a synchronous motor without currents, $A'Dz^2p_f+(K+dz)p_c$ (stability/damping/minors). By the criterion of Liénard and Chipart, which is cited, the latter is asymptotically stable if and only if $K>0$ and the former is asymptotically stable")
        .in_words()
        .follows([0, 2, 4].map(|place| Equal(by_slip[place], minors[place])));
}
