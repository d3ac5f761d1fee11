//! The theorems on completeness of the steady motions, in the notation of section 6 of Konosevich & Konosevich 2022.

use claims::{Condition, Page, Paper};
use field::{Circle, Scalar};
use machines::synchronous::Synchronous;
use motor::torque_and_current_rates;
use nalgebra::{Matrix3, Vector3};
use papers::konosevich2022::{Letters, dimension, letter};
use studies::stationary::energies::{Energies, Kept};
use symbolic::Sym;

use Condition::{Equal, NonZero, Zero};

/// The entry of the page in the ledger.
pub const PAPER: Paper = Paper {
    key: "stationary",
    title: "All stationary motions of a gyrostat with a motor",
    citation: "The workbench's own page. The conditions are those of B. I. Konosevich, Yu. B. Konosevich 2022, section 6; the equation for the multiplier is that of trust regions (J. J. More, D. C. Sorensen 1983).",
    summary: r"For a given angular velocity $\omega$ the stationary directions are the critical points of $W=\frac12\omega^2\,\nu\cdot M\nu+\omega\,h\cdot\nu+G\cdot\nu$ on the sphere. With a multiplier $\lambda$ they are the real roots of one polynomial in $\lambda$, in general of degree six: one below and one above all eigenvalues of $\omega^2M$, none or two in each gap. Where $b=\omega h+G$ is orthogonal to an eigenspace, pairs, circles or the sphere come in addition. The number of roots gives the kind of each point: minimum, saddle, maximum. With the vertical momentum given, $\omega$ is eliminated too. Folds, where two motions merge, are common roots of two polynomials; between them the number of motions is constant.",
    entries: &["gradient", "multiplier", "gaps", "beyond", "kind", "momentum", "idle", "motor"],
    page,
};

pub fn page() -> Page {
    let letters = Letters::default();
    let mut page = Page::of(PAPER.key, dimension);
    page.section("All stationary motions: the conditions");
    gradient(&mut page, &letters);
    momentum(&mut page, &letters);
    motor(&mut page, &letters);
    page.section("All stationary motions: how many, and of which kind");
    let multipliers = Multipliers::new();
    multiplier(&mut page, &letters, &multipliers);
    gaps(&mut page, &multipliers);
    beyond(&mut page, &multipliers);
    kind(&mut page, &letters, &multipliers);
    page.section("All stationary motions: directions of the cone that carry none");
    idle(&mut page, &letters);
    page
}

/// The conditions in two forms: critical points of W, and the equations of motion of the bodies.
fn gradient(page: &mut Page, s: &Letters) {
    let g = s.in_axes_of_a_star();
    let energies = Energies::of(&g);
    let (tensor, share) = energies.quadratic(Kept::RelativeSpeed);
    let slope = tensor * s.nu * s.omega0.powi(2) + share * (s.omega_field * s.omega0) + energies.weight;
    let residual = g.by_momentum(&s.stationary(s.omega_field, Sym::ZERO));
    let tangential = slope.cross(&s.nu);
    page.claim("gradient", "relative-speed", r"For a rotor that keeps its relative speed $\Omega$, the residuals of the carrier's equations of motion, from the mass points, at $\omega^0\nu$ are $\nu\times\operatorname{grad}W$ with $W=T(\omega^0\nu,\Omega)-V(\nu)$, from the energies")
        .under(&s.unit_axis)
        .follows((0..3).map(|i| Equal(-residual[i], tangential[i])));
    let speed = letter("φ̇′");
    let (tensor, share) = energies.quadratic(Kept::Momentum);
    let own = energies.axial * speed + energies.mixed.dot(&s.nu) * s.omega0;
    let slope = tensor * s.nu * s.omega0.powi(2) + share * (own * s.omega0) + energies.weight;
    let residual = g.by_momentum(&s.stationary(speed, Sym::ZERO));
    let tangential = slope.cross(&s.nu);
    page.claim("gradient", "own-momentum", r"For a free rotor, which keeps $p'=\partial T/\partial\dot\varphi'$ (Routh), the residuals of the carrier's equations of motion at $\omega^0\nu$ are $\nu\times(\omega^{0\,2}M\nu+\omega^0h+\Gamma e)$ with $M=T_{\omega\omega}-T_{\omega\varphi}T_{\varphi\omega}/T_{\varphi\varphi}$, and $h=p'\,T_{\omega\varphi}/T_{\varphi\varphi}$")
        .under(&s.unit_axis)
        .follows((0..3).map(|i| Equal(-residual[i], tangential[i])));
    let reduced = g.reduced_tensor();
    page.claim(
        "gradient",
        "tensor",
        r"Routh's tensor $T_{\omega\omega}-T_{\omega\varphi}T_{\varphi\omega}/T_{\varphi\varphi}$ is $A$, that of all masses without the rotor's moment about its axis",
    )
    .in_words()
    .under(&s.unit_axis)
    .follows((0..3).flat_map(|i| (0..3).map(move |j| Equal(tensor[(i, j)], reduced[(i, j)]))));
}

/// The angular momentum about the vertical in a steady motion.
fn momentum(page: &mut Page, s: &Letters) {
    let g = s.in_axes_of_a_star();
    let lambda = letter("λ");
    let spin = s.axial * s.omega_field;
    let weight = s.e * s.big_gamma;
    let carried = g.angular_momentum(s.nu * s.omega0, s.omega_field)[0].dot(&s.nu);
    let printed = s.a_star.component_mul(&s.nu).dot(&s.nu) * s.omega0 + spin * s.l.dot(&s.nu);
    page.claim("momentum", "vertical", r"The angular momentum of the mass points about the vertical at $\omega^0\nu$ is $\omega^0\,\nu\cdot A^*\nu + A'\Omega\,l\cdot\nu$")
        .under(&s.unit_axis)
        .follows([Equal(carried, printed)]);
    let equation: Vector3<Sym> = Vector3::from_fn(|i, _| {
        (s.omega0.powi(2) * s.a_star[i] - lambda) * s.nu[i] + s.omega0 * spin * s.l[i] + weight[i]
    });
    page.claim(
        "momentum",
        "by-the-multiplier",
        r"The vertical angular momentum of a stationary motion with the multiplier $\lambda$ satisfies $\omega^0\,x\cdot\nu = \lambda - \Gamma\,e\cdot\nu$",
    )
    .given((0..3).map(|i| Zero(equation[i])))
    .given([Zero(s.nu.dot(&s.nu) - Sym::int(1))])
    .by_combination([(
        Equal(s.omega0 * printed, lambda - weight.dot(&s.nu)),
        vec![],
        vec![(0, s.nu.x), (1, s.nu.y), (2, s.nu.z), (3, lambda)],
    )]);
}

/// Pull-out: two angles merge (saddle-node bifurcation).
fn motor(page: &mut Page, s: &Letters) {
    let f = letter("f");
    let machine = Synchronous { field_speed: s.omega_field, b0: s.b0, f };
    let angle = s.angle();
    let moment = torque_and_current_rates(&machine, angle, Sym::ZERO, &[], &mut []);
    let turned = Circle { cos: -angle.cos, sin: angle.sin };
    page.claim(
        "motor",
        "branches",
        r"A synchronous motor has the stationary angles $\gamma^0$ and $\pi-\gamma^0$, since its torque without slip is equal at both",
    )
    .in_words()
    .follows([Equal(torque_and_current_rates(&machine, turned, Sym::ZERO, &[], &mut []), moment)]);
    let point = Circle { cos: letter("c"), sin: letter("s") };
    let moment = torque_and_current_rates(&machine, point, Sym::ZERO, &[], &mut []);
    page.claim("motor", "pull-out", r"The two stationary angles of a synchronous motor merge where $\cos\gamma=0$, with $M=0$ at $(f\Omega)^2=b_0^2$ (pull-out). For $|f\Omega|>|b_0|$ there is no root of $M=-f\Omega-b_0\sin\gamma$")
        .given([Zero(point.cos), Zero(moment), Zero(point.defect())])
        .by_combination([(
            Equal((f * s.omega_field).powi(2), s.b0.powi(2)),
            vec![],
            vec![
                (0, s.b0.powi(2) * -point.cos),
                (1, s.b0 * point.sin - f * s.omega_field),
                (2, s.b0.powi(2)),
            ],
        )]);
}

/// The equations (alpha_i - lambda) nu_i + delta_i = 0 in the principal axes, solved for nu.
struct Multipliers {
    lambda: Sym,
    alpha: Vector3<Sym>,
    delta: Vector3<Sym>,
    /// The direction nu_i = delta_i / (lambda - alpha_i).
    direction: Vector3<Sym>,
}

impl Multipliers {
    fn new() -> Self {
        let lambda = letter("λ");
        let vector = |stem: &str| Vector3::from_fn(|i, _| letter(&format!("{stem}{}", i + 1)));
        let (alpha, delta) = (vector("α"), vector("δ"));
        let direction = Vector3::from_fn(|i, _| delta[i] / (lambda - alpha[i]));
        Multipliers { lambda, alpha, delta, direction }
    }

    fn excess(&self) -> Sym {
        self.direction.dot(&self.direction) - Sym::int(1)
    }
}

/// Each root lambda gives one direction nu.
fn multiplier(page: &mut Page, s: &Letters, m: &Multipliers) {
    let symmetric =
        Matrix3::from_fn(|i, j| if i == j { m.alpha[i] - m.lambda } else { letter(["δ1", "δ2", "δ3"][3 - i - j]) });
    let b = Vector3::new(letter("α1"), letter("α2"), letter("α3"));
    let adjugate = mechanics::rotation::adjugate(&symmetric);
    let determinant = mechanics::rotation::determinant(&symmetric);
    let solved = symmetric * (adjugate * b) - b * determinant;
    page.claim("multiplier", "adjugate", r"For a symmetric $K$ with any components and any $b$, $(K-\lambda)\,\mathrm{adj}(K-\lambda)\,b = \det(K-\lambda)\,b$. Where the determinant is not zero $\nu=-\mathrm{adj}(K-\lambda)b/\det(K-\lambda)$ is the only solution of $(K-\lambda)\nu+b=0$, and $|\nu|=1$ is $|\mathrm{adj}(K-\lambda)b|^2=\det(K-\lambda)^2$")
        .in_words()
        .follows(solved.iter().map(|&x| Zero(x)));
    let residual = Vector3::from_fn(|i, _| (m.alpha[i] - m.lambda) * m.direction[i] + m.delta[i]);
    page.claim("multiplier", "direction", r"In the principal axes of $K=\omega^{0\,2}A^*$ with the moments $\alpha_i$, $(K-\lambda)\nu+\delta=0$ has the solution $\nu_i=\delta_i/(\lambda-\alpha_i)$")
        .in_words()
        .follows(residual.iter().map(|&x| Zero(x)));
    let own = s.nu;
    page.claim(
        "multiplier",
        "different",
        r"Each direction, $(K-\lambda)\nu+\delta=0$ with $|\nu|=1$, has one multiplier $\lambda=\nu\cdot(K\nu+\delta)$, here in the principal axes of $K$",
    )
    .given((0..3).map(|i| Zero((m.alpha[i] - m.lambda) * own[i] + m.delta[i])))
    .given([Zero(own.dot(&own) - Sym::int(1))])
    .by_combination([(
        Equal(m.lambda, m.alpha.component_mul(&own).dot(&own) + m.delta.dot(&own)),
        vec![],
        vec![(0, -own.x), (1, -own.y), (2, -own.z), (3, -m.lambda)],
    )]);
}

/// There is one root beyond either end of the spectrum, and none or two in each gap between eigenvalues.
fn gaps(page: &mut Page, m: &Multipliers) {
    let fourth = (0..3).fold(Sym::ZERO, |sum, i| sum + m.delta[i].powi(2) / (m.lambda - m.alpha[i]).powi(4));
    let curvature = m.excess().diff(m.lambda).diff(m.lambda);
    page.claim("gaps", "convex", r"$|\nu|^2=\sum\delta_i^2/(\lambda-\alpha_i)^2$ is convex in $\lambda$ between its poles: $\frac{d^2}{d\lambda^2}\sum\delta_i^2/(\lambda-\alpha_i)^2=6\sum\delta_i^2/(\lambda-\alpha_i)^4>0$. Since it grows without bound at each pole (all $\delta_i\ne0$), $|\nu|^2=1$ has in each gap between poles no root, two, or one double")
        .in_words()
        .follows([Equal(curvature, Sym::int(6) * fourth)]);
    let slope = (0..3).fold(Sym::ZERO, |sum, i| sum + m.delta[i].powi(2) / (m.lambda - m.alpha[i]).powi(3));
    page.claim("gaps", "monotonic", r"$|\nu|^2=\sum\delta_i^2/(\lambda-\alpha_i)^2$ is monotonic in $\lambda$ beyond its first and beyond its last pole: its derivative is $-2\sum\delta_i^2/(\lambda-\alpha_i)^3$, whose terms have one sign there. Since it grows without bound at these poles and tends to zero at infinity, $|\nu|^2=1$ has one root beyond either end")
        .in_words()
        .follows([Equal(m.excess().diff(m.lambda), -(Sym::int(2) * slope))]);
}

/// The eigenvalues whose eigenspace is orthogonal to delta.
fn beyond(page: &mut Page, m: &Multipliers) {
    let z = letter("ν3");
    let at = [(m.delta.z, Sym::ZERO), (m.lambda, m.alpha.z)];
    let direction = Vector3::new(m.direction.x.substitute(&at), m.direction.y.substitute(&at), z);
    let residual = Vector3::from_fn(|i, _| ((m.alpha[i] - m.lambda) * direction[i] + m.delta[i]).substitute(&at));
    page.claim("beyond", "pair", r"Where $\delta$ is orthogonal to an eigenvector of $K$, $\delta_3=0$, and $\lambda=\alpha_3$, $(K-\lambda)\nu+\delta=0$ leaves the component $\nu_3$ free. $|\nu|=1$ then gives $\nu_3=\pm\sqrt{1-\nu_1^2-\nu_2^2}$, which is a pair where that is real")
        .in_words()
        .follows(residual.iter().map(|&x| Zero(x)));
    let at = [(m.delta.y, Sym::ZERO), (m.delta.z, Sym::ZERO), (m.alpha.y, m.alpha.z), (m.lambda, m.alpha.z)];
    let direction = Vector3::new(m.direction.x.substitute(&at), letter("ν2"), z);
    let residual = Vector3::from_fn(|i, _| ((m.alpha[i] - m.lambda) * direction[i] + m.delta[i]).substitute(&at));
    page.claim("beyond", "circle", r"Where $\delta$ is orthogonal to the eigenspace of a double eigenvalue $\lambda$ of $K$, $(K-\lambda)\nu+\delta=0$ leaves $\nu_2$ and $\nu_3$ free but for $|\nu|=1$, which gives a circle")
        .in_words()
        .follows(residual.iter().map(|&x| Zero(x)));
}

/// Minimum, saddle or maximum, depending on the position of lambda among the alpha_i.
fn kind(page: &mut Page, s: &Letters, m: &Multipliers) {
    let quotient = (0..3).fold(Sym::ZERO, |sum, i| sum + m.direction[i].powi(2) / (m.alpha[i] - m.lambda));
    page.claim("kind", "slope", r"$\frac12\frac{d|\nu|^2}{d\lambda}=\nu\cdot(K-\lambda)^{-1}\nu$ for $\nu=-(K-\lambda)^{-1}\delta$, in the principal axes of $K$")
        .in_words()
        .follows([Equal(m.excess().diff(m.lambda), Sym::int(2) * quotient)]);
    let (x, y) = (s.l, s.e);
    let h = m.alpha.map(|a| a - m.lambda);
    let form = |a: &Vector3<Sym>, b: &Vector3<Sym>| a.component_mul(&h).dot(b);
    let across = x.cross(&y);
    let cofactors = Vector3::new(h.y * h.z, h.z * h.x, h.x * h.y);
    page.claim("kind", "tangent-plane", r"The determinant of $H=K-\lambda$ on the plane of two vectors $l$, $e$ is $(l\times e)\cdot\mathrm{adj}H\,(l\times e)$, in the principal axes of $K$. On the tangent plane at a unit vector $\nu$ it is $\det H\;\nu\cdot H^{-1}\nu$, which where $\det H\ne0$ vanishes with $d|\nu|^2/d\lambda$ (stationary/kind/slope)")
        .in_words()
        .follows([Equal(
            form(&x, &x) * form(&y, &y) - form(&x, &y).powi(2),
            across.component_mul(&cofactors).dot(&across),
        )]);
}

/// Points of the spherical curve to which no rotation belongs.
fn idle(page: &mut Page, s: &Letters) {
    let tilt = s.a_star.component_mul(&s.nu).cross(&s.nu);
    let volume = s.nu.dot(&s.l.cross(&s.e));
    let (first, second) = (s.e.cross(&s.nu), s.nu.cross(&s.l));
    page.claim("idle", "principal", r"Where $S^*=V^*=0$ but $\Pi^*\ne0$, $t=A^*\nu\times\nu$ is orthogonal to $\nu$, $l$ and $e$, which are independent. Then $t=0$, so that $\nu$ is a principal direction")
        .given([Zero(s.l.dot(&tilt)), Zero(s.e.dot(&tilt)), NonZero(volume)])
        .by_combination((0..3).map(|i| (Zero(tilt[i]), vec![2], vec![(0, first[i]), (1, second[i])])));
    let force = tilt * s.omega0.powi(2)
        + s.l.cross(&s.nu) * (s.axial * s.omega_field * s.omega0)
        + s.e.cross(&s.nu) * s.big_gamma;
    page.claim("idle", "no-rotation", r"About a principal direction, $A^*\nu\times\nu=0$, with $\Gamma\Pi^*\ne0$ there is no rotation: (6.5) needs $\Gamma\Pi^*=0$ there")
        .given((0..3).map(|i| Zero(tilt[i])))
        .given((0..3).map(|i| Zero(force[i])))
        .by_combination([(
            Zero(s.big_gamma * volume),
            vec![],
            (0..3).map(|i| (i, -(s.l[i] * s.omega0.powi(2)))).chain((0..3).map(|i| (3 + i, s.l[i]))).collect(),
        )]);
}
