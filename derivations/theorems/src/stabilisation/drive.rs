//! The electromechanical drive: nine equations from its energies, and further theorems.

use super::alphabet::{letter, letters};
use claims::{Condition, Line, Page};
use field::{Analytic, Scalar, Tangent};
use mechanics::constrained::State;
use mechanics::constrained::energies::{Energies, Instant, Kinematics, Reducible};
use papers::mukharlyamov2007::drive::{balance, close_in_nine, voltage};
use symbolic::Sym;
use systems::crank_drive::{Circuit, CrankDrive};
use systems::crank_slider::CrankSlider;

use Condition::{Equal, NonZero, Zero};

/// The drive with a symbol for every datum.
fn drive() -> CrankDrive<Sym> {
    let [amplitude, frequency, l1, l2, mutual, r1, r2] = letters(["E0", "Ω", "L1", "L2", "M", "R1", "R2"]);
    let [forward, reverse, knee, c3, l4, r4, l5, r5] = letters(["Rf", "Rr", "i0", "C", "L4", "R4", "L5", "R5"]);
    let [motor, b6, b7, inertia, mass, crank, rod, weight] = letters(["K", "b6", "b7", "J", "m", "r", "l", "G"]);
    CrankDrive {
        circuit: Circuit {
            amplitude,
            frequency,
            l1,
            l2,
            mutual,
            r1,
            r2,
            forward,
            reverse,
            knee,
            c3,
            l4,
            r4,
            l5,
            r5,
            motor,
            b6,
            b7,
        },
        mechanism: CrankSlider { inertia, mass, crank, rod, weight },
    }
}

fn anywhere() -> State<Sym, 6> {
    State {
        time: letter("t"),
        place: letters(["q1", "q2", "q4", "q5", "q6", "q7"]),
        velocity: letters(["f1", "f2", "f4", "f5", "f6", "f7"]),
    }
}

pub fn claims(page: &mut Page) {
    page.section("The electromechanical drive");
    equations(page);
    diode(page);
    power(page);
    stabilised(page);
    minimal(page);
}

/// The voltage u(i) as printed in the paper.
fn printed_voltage(i: Sym) -> Sym {
    let [forward, reverse, knee] = letters(["Rf", "Rr", "i0"]);
    let root = (i.powi(2) + knee.powi(2)).sqrt();
    (reverse + forward).half() * i - (reverse - forward) * (root - knee + i.powi(2) / root) / Sym::int(4)
}

fn equations(page: &mut Page) {
    let (drive, at) = (drive(), anywhere());
    let instant = Instant::of(&drive, &at);
    let accelerations: [Sym; 6] = letters(["a1", "a2", "a4", "a5", "a6", "a7"]);
    let lambda = letter("λ");
    let residual: [Sym; 6] = std::array::from_fn(|i| {
        let inertia = (0..6).fold(Sym::ZERO, |sum, j| sum + instant.mass[i][j] * accelerations[j]);
        inertia - instant.force[i] - lambda * instant.kinematics.rows[0][i]
    });
    let Circuit { l1, l2, mutual, r1, r2, c3, l4, r4, l5, r5, motor, b6, b7, amplitude, frequency, .. } = drive.circuit;
    let CrankSlider { inertia, mass, crank, weight, .. } = drive.mechanism;
    let [_, _, q4, q5, q6, q7] = at.place;
    let [f1, f2, f4, f5, f6, f7] = at.velocity;
    let [a1, a2, a4, a5, a6, a7] = accelerations;
    let (plus, minus) = (printed_voltage((f4 + f2).half()), printed_voltage((f4 - f2).half()));
    let angle = q6.circle();
    let q3 = q4 - q5;
    let two = Sym::int(2);
    page.claim("drive", "equations", r"Lagrange's equations are those for the voltages around each loop, the moments about the axis and the forces on the slider. In them $q^3=q^4-q^5$, $u_\pm=u\left(\frac12(f^4\pm f^2)\right)$ are the voltages of the diodes, and the first windings are coupled by $M$")
        .holds([
            Line::equation(residual[0], l1 * a1 + mutual * a2, amplitude * (frequency * at.time).circle().sin - r1 * f1),
            Line::equation(residual[1], mutual * a1 + l2 * a2, -r2 * f2 - (plus - minus)),
            Line::equation(residual[2], l4 * a4, -q3 / c3 - r4 * f4 - (plus + minus)),
            Line::equation(residual[3], l5 * a5, q3 / c3 - r5 * f5 - motor * f6),
            Line::equation(residual[4], inertia * a6, motor * f5 - b6 * f6 - weight * angle.cos + two * lambda * crank * q7 * angle.sin),
            Line::equation(residual[5], mass * a7, -b7 * f7 + two * lambda * (q7 - crank * angle.cos)),
        ]);
    page.claim("drive", "nine", r"Of the drive's charges only $q^3=q^4-q^5$ acts. With $\dot q^3=f^4-f^5$ the equations close in nine unknowns $f^1,f^2,q^3,f^4,f^5,q^6,f^6,q^7,f^7$")
        .in_words()
        .follows(close_in_nine(&drive, &at));
    page.claim("drive", "closure", r"The drive's rod ties $q^7$ to $q^6$ as in Mukharlyamov 2007").defines([
        Line::equation(
            instant.kinematics.value[0],
            (q7 - crank * angle.cos).powi(2) + (crank * angle.sin).powi(2),
            drive.mechanism.rod.powi(2),
        ),
    ]);
}

fn diode(page: &mut Page) {
    let drive = drive();
    let [i, knee] = letters(["i", "i0"]);
    let [forward, reverse] = letters(["Rf", "Rr"]);
    let resistance = voltage(&drive, i).diff(i);
    let root = (i.powi(2) + knee.powi(2)).sqrt();
    let two = Sym::int(2);
    let (one, gap) = (Sym::int(1), reverse - forward);
    page.claim("diode", "resistance", r"The differential resistance $u'$ of a diode lies between $R_{\mathrm f}$ and $R_{\mathrm r}$. With $\sigma=i/\sqrt{i^2+i_0^2}$, $|\sigma|<1$, it is $R_{\mathrm f}+\frac14(R_{\mathrm r}-R_{\mathrm f})(1-\sigma)^2(2+\sigma)$, and $R_{\mathrm r}-\frac14(R_{\mathrm r}-R_{\mathrm f})(1+\sigma)^2(2-\sigma)$")
        .in_words()
        .given([NonZero(root)])
        .follows([
            Equal(resistance, forward + gap * (one - i / root).powi(2) * (two + i / root) / Sym::int(4)),
            Equal(resistance, reverse - gap * (one + i / root).powi(2) * (two - i / root) / Sym::int(4)),
        ]);
    page.claim("diode", "voltage", r"The voltage of a diode is the slope of its content").holds([Line::formula(
        voltage(&drive, i),
        letter("ui"),
        printed_voltage(i),
    )]);
    page.claim(
        "diode",
        "rest",
        r"A diode without current has the voltage $\frac14(R_{\mathrm r}-R_{\mathrm f})(i_0-\sqrt{i_0^2})$, which is zero for $i_0>0$. With $R_{\mathrm r}\ge R_{\mathrm f}$ and so $u'\ge R_{\mathrm f}$ (stabilisation/diode/resistance) it never gives energy, $u(i)\,i\ge R_{\mathrm f}i^2$",
    )
    .in_words()
    .follows([Equal(voltage(&drive, Sym::ZERO), gap * (knee - knee.powi(2).sqrt()) / Sym::int(4))]);
}

fn power(page: &mut Page) {
    let (drive, at) = (drive(), anywhere());
    let instant = Instant::of(&drive, &at);
    let accelerations = letters(["a1", "a2", "a4", "a5", "a6", "a7"]);
    page.claim("drive", "power", r"Along the drive's motion the energy of windings, capacitor, crank and slider changes at a rate equal to the source's power $Ef^1$, less the heat in resistances, diodes and bearings, plus the work $\lambda\dot f$ of the rod's reaction, which is zero where the constraint holds")
        .in_words()
        .follows([balance(&drive, &at, accelerations, letter("λ"))]);
    let entry = |i: usize, j: usize| instant.force[i].diff(at.velocity[j]);
    page.claim("drive", "coupling", "The drive's armature voltage per speed of the crank and the crank's moment per current are opposite, $-K$ and $K$, which is a gyroscopic coupling without work")
        .in_words()
        .follows([Equal(entry(3, 4), -drive.circuit.motor), Equal(entry(4, 3), drive.circuit.motor)]);
}

fn stabilised(page: &mut Page) {
    let (drive, at) = (drive(), anywhere());
    let wanted = letter("Y");
    let instant = Instant::of(&drive, &at);
    let led = instant.leading_to([wanted]);
    let acceleration = led.map_or([Sym::UNDEFINED; 6], |reaction| reaction.acceleration);
    // f'' along the motion, by differentiating f twice
    let time = Tangent::variable(at.time);
    let moved = State {
        time,
        place: std::array::from_fn(|i| Tangent::moving(at.place[i], at.velocity[i])),
        velocity: std::array::from_fn(|i| Tangent::moving(at.velocity[i], acceleration[i])),
    };
    let rate = Kinematics::of(&drive, &moved).rate[0];
    page.claim("drive", "stabilised", r"The multiplier that controls the violation $f$ of the drive's rod gives $\ddot f=Y$ for every $Y$, at any state of the drive, on the constraint or off it")
        .in_words()
        .follows([Equal(rate.slope, wanted)]);
}

fn minimal(page: &mut Page) {
    let drive = drive();
    let place = drive.place(letter("t"), letters(["q1", "q2", "q4", "q5", "q6"]));
    page.claim("drive", "chart", r"$q^7=r\cos q^6+\sqrt{l^2-r^2\sin^2q^6}$ keeps the constraint of the drive's rod, for every angle where the root is real")
        .in_words()
        .follows([Zero(drive.constraints(letter("t"), place)[0])]);
    let [h, r, l] = letters(["h", "R1", "L1"]);
    let grown = studies::stabilisation::schemes::Scheme::Euler.step([[-h * r / l]], [Sym::int(1)]);
    let factor = grown.map_or(Sym::UNDEFINED, |[f]| f);
    page.claim("drive", "step", r"Euler multiplies a current that decays through $R$ and $L$ by $\rho = 1-hR/L$ in each step. The current decays if and only if $h<2L/R$")
        .holds([Line::formula(factor, letter("ρ"), Sym::int(1) - h * r / l)]);
}
