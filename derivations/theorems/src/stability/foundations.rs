//! The law and its variation, the structural zero eigenvalues, the energy, and the polynomial for constant rotor speed.

use super::alphabet::{letter, vector};
use super::letters::{free, kept, stationary, unit_vectors};
use claims::{Condition, Page};
use field::{Circle, Scalar, Tangent};
use machines::synchronous::Synchronous;
use mechanics::rotation::{adjugate, determinant};
use motor::ConstantSpeed;
use nalgebra::Vector3;
use papers::konosevich2022::{self as paper, Letters};
use studies::stationary::energies::Energies;
use studies::stationary::stability::linear::{Linear, missing, variation};
use studies::stationary::stability::reduced::Reduced;
use studies::stationary::stability::state::{State, StationaryState};
use symbolic::Sym;

use Condition::{Equal, NonZero, Zero};

pub fn claims(page: &mut Page, s: &Letters) {
    page.section("Stability: law, zero roots, energy");
    law(page, s);
    zeros(page, s);
    page.section("Stability: the classical gyrostats");
    reduced(page, s);
    energy(page, s);
    polynomial(page, s);
}

fn law(page: &mut Page, s: &Letters) {
    let g = s.in_axes_of_a_star();
    let energies = Energies::of(&g);
    let (all, spin) = energies.momenta(s.w, s.dphi);
    let [of_points, of_rotor] = g.angular_momentum(s.w, s.dphi);
    page.claim("law", "momenta", r"The gyrostat's momenta $\partial T/\partial\omega$ and $\partial T/\partial\dot\varphi'$, from the energies, are the angular momentum $x$ of all mass points about $O$, and that of the rotor about its axis. The equations that are linearised are those of the theorem of angular momentum")
        .under(&s.unit_axis)
        .follows((0..3).map(|i| Equal(all[i], of_points[i])).chain([Equal(spin, of_rotor.dot(&s.l))]));
}

/// One instant of any motion, with any motor: the motor occurs neither in the equations of the carrier nor in that of
/// the vertical.
fn zeros(page: &mut Page, s: &Letters) {
    let energies = Energies::of(&s.in_axes_of_a_star());
    let any = Synchronous { field_speed: s.omega_field, b0: s.b0, f: paper::letter("f") };
    let state = State {
        w: s.w,
        v: s.nu,
        rotor_speed: s.dphi,
        slip: s.dphi - s.omega_field,
        angle: s.angle(),
        currents: Vec::new(),
    };
    let vertical = vector("δν̇");
    let rates: Vec<Sym> = s.dw.iter().chain(vertical.iter()).copied().chain([s.dgamma, s.ddphi]).collect();
    let missing = missing(&energies, &any, &state, &rates);
    let of_carrier = Vector3::new(missing[0], missing[1], missing[2]);
    let of_vertical = Vector3::new(missing[3], missing[4], missing[5]);
    let moving = s.nu.zip_map(&vertical, Tangent::moving);
    let (all, _) = energies.momenta(s.w.zip_map(&s.dw, Tangent::moving), Tangent::moving(s.dphi, s.ddphi));
    page.claim("zeros", "vertical", r"The gyrostat with any motor at any state and rates has $\frac12(\nu\cdot\nu)^{\textstyle\cdot}=\nu\cdot(\dot\nu-\nu\times\omega)$: $|\nu|$ is an integral, and gives the first approximation a zero root where its differential does not vanish")
        .in_words()
        .follows([Equal(moving.dot(&moving).slope.half(), s.nu.dot(&of_vertical))]);
    let values = all.map(|x| x.value);
    page.claim("zeros", "momentum", r"The gyrostat with any motor at any state and rates has $(x\cdot\nu)^{\textstyle\cdot}=\nu\cdot(\dot x+\omega\times x-\Gamma e\times\nu)+x\cdot(\dot\nu-\nu\times\omega)$, whatever the moment on the rotor: $x\cdot\nu$ is an integral, independent of $|\nu|$ because $\partial(x\cdot\nu)/\partial\omega=A^*\nu\ne0$, and gives a second zero root")
        .under(&s.unit_axis)
        .follows([Equal(all.dot(&moving).slope, s.nu.dot(&of_carrier) + values.dot(&of_vertical))]);
    let (_, spin) = energies.momenta(s.w.zip_map(&s.dw, Tangent::moving), Tangent::moving(s.dphi, s.ddphi));
    let drive = motor::torque_and_current_rates(&any, s.angle(), s.dphi - s.omega_field, &[], &mut []);
    page.claim("zeros", "rotor", r"$\dot p'$, $p'=\partial T/\partial\dot\varphi'$, is the torque on the rotor. For a free rotor $p'$ is an integral, which gives a third zero root")
        .in_words()
        .follows([Equal(spin.slope, missing[7] + drive)]);
}

/// The symbols, independent of z, of a deviation (d nu, eta, d gamma, d gamma') and their rates.
struct Deviation {
    vertical: Vector3<Sym>,
    turning: Vector3<Sym>,
    angle: Sym,
    slip: Sym,
}

impl Deviation {
    fn letters(dot: &str) -> Self {
        let [angle, slip] = if dot.is_empty() { ["δγ", "δγ̇"] } else { ["δγ̇", "δγ̈"] }.map(letter);
        let dotted = !dot.is_empty();
        Deviation {
            vertical: vector(if dotted { "δν̇" } else { "δν" }),
            turning: vector(if dotted { "η̇" } else { "η" }),
            angle,
            slip,
        }
    }

    /// The deviation of the state, with d omega = w0 d nu + eta.
    fn state(&self, w0: Sym) -> Vec<Sym> {
        let w = self.vertical * w0 + self.turning;
        w.iter().chain(self.vertical.iter()).copied().chain([self.angle, self.slip]).collect()
    }
}

fn place(s: &Letters) -> StationaryState<Sym> {
    StationaryState { speed: s.omega0, vertical: s.nu, rotor_speed: s.omega_field, angle: s.angle() }
}

fn reduced(page: &mut Page, s: &Letters) {
    let machine = Synchronous { field_speed: s.omega_field, b0: s.b0, f: paper::letter("f") };
    let (y, dy) = (Deviation::letters(""), Deviation::letters("dot"));
    let found = variation(&stationary(s), &machine, &place(s), &y.state(s.omega0), &dy.state(s.omega0));
    let carrier = kept(s);
    let turning = s.nu.cross(&y.turning);
    let expected = carrier.tensor * (dy.turning + (dy.vertical - turning) * s.omega0)
        - s.nu.cross(&(carrier.stiffness() * y.vertical))
        - carrier.gyroscopic().cross(&y.turning)
        + s.l * (s.axial * dy.slip)
        - s.l.cross(&s.nu) * (s.axial * s.omega0 * y.slip);
    let vertical = dy.vertical - turning;
    page.claim("law", "variation", r"A stationary motion, $\Gamma e=\lambda\nu-\omega^0x$, with $\delta\omega=\omega^0\delta\nu+\eta$ has the variation $\delta\dot\nu=\nu\times\eta$, $A^*\dot\eta=\nu\times H\delta\nu+n\times\eta-A'(l\,\delta\ddot\gamma-\omega^0l\times\nu\,\delta\dot\gamma)$ with $H=\lambda-\omega^{0\,2}A^*$, $n=\kappa-\omega^0\operatorname{tr}A^*\nu$, $\kappa=2\omega^0A^*\nu+A'\Omega l$")
        .in_words()
        .follows((0..3).map(|i| Equal(found[i], expected[i])).chain((0..3).map(|i| Equal(found[3 + i], vertical[i]))));
    let moment = s.angle().cos * s.b0 * y.angle + paper::letter("f") * y.slip;
    page.claim("law", "rotor", r"The variation of the rotor's equation at a stationary motion, for the synchronous motor without currents, is $A'(l\cdot\delta\dot\omega+\delta\ddot\gamma)=-b_0\cos\gamma^0\delta\gamma-f\,\delta\dot\gamma$")
        .in_words()
        .under(&s.unit_axis)
        .follows([Equal(
            found[7],
            (s.l.dot(&(dy.vertical * s.omega0 + dy.turning)) + dy.slip) * s.axial + moment,
        )]);
}

fn energy(page: &mut Page, s: &Letters) {
    let machine = Synchronous { field_speed: s.omega_field, b0: s.b0, f: paper::letter("f") };
    let linear = Linear::at(&stationary(s), &machine, &place(s), false);
    let y = Deviation::letters("");
    let state = y.state(s.omega0);
    let form = |matrix: &[Vec<Sym>]| {
        let rows = matrix.iter().zip(&state).map(|(row, &own)| {
            row.iter().zip(&state).fold(Sym::ZERO, |sum, (&entry, &other)| sum + entry * own * other)
        });
        rows.fold(Sym::ZERO, |sum, row| sum + row)
    };
    let carrier = kept(s);
    let kinetic =
        (carrier.tensor * y.turning).dot(&y.turning) + s.axial * y.slip * (Sym::int(2) * s.l.dot(&y.turning) + y.slip);
    let potential = (carrier.stiffness() * y.vertical).dot(&y.vertical) + s.b0 * s.angle().cos * y.angle.powi(2);
    page.claim("energy", "second-variation", r"The second variation of $G=E-\Omega p'-\omega^0x\cdot\nu+\frac12\lambda\nu\cdot\nu$ at a stationary motion is $2T(\eta,\delta\dot\gamma)+\delta\nu\cdot H\delta\nu+b_0\cos\gamma^0\delta\gamma^2$ (synchronous motor without currents). The terms are twice the kinetic energy of $\eta$, $\delta\dot\gamma$, and forms of the tilt and of the angle alone")
        .in_words()
        .under(&unit_vectors(s))
        .follows([Equal(form(&linear.energy), kinetic + potential)]);
    let along = linear.integrals[1].iter().zip(&state).fold(Sym::ZERO, |sum, (&slope, &own)| sum + slope * own);
    // eta shifted along nu such that x.nu is conserved under the tilt
    let twice = |eta: Vector3<Sym>| {
        (carrier.tensor * eta).dot(&eta) + s.axial * y.slip * (Sym::int(2) * s.l.dot(&eta) + y.slip)
    };
    let tilted = carrier.coupling().dot(&y.vertical);
    let kept_momentum = s.nu.dot(&(carrier.tensor * y.turning + s.l * (s.axial * y.slip))) + tilted;
    let share = tilted / carrier.weight();
    let stiff = (carrier.stiffness() * y.vertical).dot(&y.vertical);
    page.claim("energy", "fixed-momentum", r"$x\cdot\nu$ is kept where $\nu\cdot(A^*\eta+A'l\,\delta\dot\gamma)+\kappa\cdot\delta\nu=0$. There the second variation of $G$ is $2T(\eta',\delta\dot\gamma)+Q(\delta\nu)+b_0\cos\gamma^0\delta\gamma^2$ with $\eta'=\eta+\nu\,(\kappa\cdot\delta\nu)/\nu\cdot A^*\nu$ and $Q=\delta\nu\cdot H\delta\nu+(\kappa\cdot\delta\nu)^2/\nu\cdot A^*\nu$. These are forms of variations that do not depend on each other, the first a kinetic energy. At fixed integrals it is definite if and only if $b_0\cos\gamma^0>0$ and $Q$ is positive definite on the plane across $\nu$")
        .in_words()
        .under(&unit_vectors(s))
        .given([Zero(kept_momentum), NonZero(carrier.weight())])
        .by_combination([
            (Equal(along, kept_momentum), vec![], vec![]),
            (
                Equal(
                    twice(y.turning) + stiff,
                    twice(y.turning + s.nu * share) + stiff + tilted.powi(2) / carrier.weight(),
                ),
                vec![],
                vec![(0, -(share + share))],
            ),
        ]);
    let (kept, free) = (kept(s), free(s));
    let quadratic = |carrier: &Reduced<Sym>| {
        (carrier.stiffness() * y.vertical).dot(&y.vertical)
            + carrier.coupling().dot(&y.vertical).powi(2) / carrier.weight()
    };
    let lead = s.l.dot(&y.vertical) * s.omega0 * kept.weight() - s.l.dot(&s.nu) * kept.coupling().dot(&y.vertical);
    page.claim("energy", "free-rotor", r"The form $Q$ of a free rotor ($A$ in the place of $A^*$, $p'$ in that of $A'\Omega$) exceeds that of a rotor of constant speed by $A'\,(\omega^0l\cdot\delta\nu\;\nu\cdot A^*\nu-l\cdot\nu\;\kappa\cdot\delta\nu)^2/(\nu\cdot A\nu\;\nu\cdot A^*\nu)\ge0$. Where $Q$ is positive at constant speed it is so with a free rotor")
        .in_words()
        .under(&unit_vectors(s))
        .follows([Equal(
            quadratic(&free) - quadratic(&kept),
            s.axial * lead.powi(2) / (kept.weight() * free.weight()),
        )]);
}

fn polynomial(page: &mut Page, s: &Letters) {
    let z = letter("z");
    let carrier = kept(s);
    let machine = ConstantSpeed { speed: s.omega_field };
    let circle = Circle { cos: Sym::int(1), sin: Sym::ZERO };
    let place = StationaryState { angle: circle, ..place(s) };
    let eta = vector("η");
    let tilt = s.nu.cross(&eta) / z;
    let w = tilt * s.omega0 + eta;
    let y: Vec<Sym> = w.iter().chain(tilt.iter()).copied().collect();
    let dy: Vec<Sym> = y.iter().map(|&one| z * one).collect();
    let found = variation(&stationary(s), &machine, &place, &y, &dy);
    let reduced = carrier.pencil(z) * eta;
    page.claim("constant-speed", "pencil", r"With $\delta\nu=\nu\times\eta/z$ the variation of a rotor of constant speed is $K(z)\eta=0$, $K=z^2A^*-z[n]-[\nu]H[\nu]$, $[a]b=a\times b$")
        .in_words()
        .follows((0..3).map(|i| Equal(z * found[i], reduced[i])));
    let [det, a, b] = carrier.polynomial();
    page.claim("constant-speed", "polynomial", r"A rotor of constant speed has $\det K=z^2\det A^*\,p_c(z)$, $p_c=z^4+a_cz^2+b_c$: $\det A^*a_c=-\operatorname{tr}(\operatorname{adj}A^*[\nu]H[\nu])+n\cdot A^*n$, $\det A^*b_c=(\nu\cdot A^*\nu)(\nu\cdot\operatorname{adj}H\,\nu)+(\nu\times\kappa)\cdot H(\nu\times\kappa)$. There are only even powers, so that roots come in pairs $z,-z$, and the first approximation alone does not show stability")
        .in_words()
        .under(&s.unit_vertical)
        .follows([Equal(
            determinant(&carrier.pencil(z)),
            z.powi(2) * (det * z.powi(4) + a * z.powi(2) + b),
        )]);
    let form = carrier.energy();
    page.claim("constant-speed", "energy", r"A rotor of constant speed has $\det A^*b_c=(\nu\cdot A^*\nu)\det Q$ with the determinant of $Q$ on the plane across $\nu$: $b_c<0$ where $Q$ has one negative square there, $b_c>0$ where it has none or two")
        .in_words()
        .under(&s.unit_vertical)
        .follows([Equal(carrier.weight() * (adjugate(&form) * s.nu).dot(&s.nu), b)]);
}
