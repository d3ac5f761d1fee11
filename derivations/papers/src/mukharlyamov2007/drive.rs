//! The power balance of the electromechanical drive, and the charges on which its equations depend.

use claims::Condition;
use field::{Scalar, Tangent};
use mechanics::constrained::State;
use mechanics::constrained::energies::Instant;
use symbolic::Sym;
use systems::crank_drive::{Circuit, CrankDrive};

use Condition::{Equal, Zero};

/// The voltage of a diode: the derivative of its content with respect to the current.
pub fn voltage(drive: &CrankDrive<Sym>, current: Sym) -> Sym {
    drive.diode(Tangent::variable(current)).slope
}

/// The conditions that the equations depend on the charges only through q3 = q4 - q5: no force depends on q1, q2, nor
/// on q4 and q5 except by their difference.
pub fn close_in_nine(drive: &CrankDrive<Sym>, at: &State<Sym, 6>) -> Vec<Condition> {
    let instant = Instant::of(drive, at);
    let [q1, q2, q4, q5, ..] = at.place;
    let of_one = |i: usize| {
        let slope = |charge: Sym| instant.force[i].diff(charge);
        [Zero(slope(q1)), Zero(slope(q2)), Equal(slope(q4), -slope(q5))]
    };
    (0..6).flat_map(of_one).collect()
}

/// The condition on the rate of the energy along the motion, for any lambda: source power minus heat plus lambda f'.
pub fn balance(drive: &CrankDrive<Sym>, at: &State<Sym, 6>, accelerations: [Sym; 6], lambda: Sym) -> Condition {
    let instant = Instant::of(drive, at);
    let moving =
        |x: [Sym; 6], dx: [Sym; 6]| -> [Tangent<Sym>; 6] { std::array::from_fn(|k| Tangent::moving(x[k], dx[k])) };
    let (q, f) = (moving(at.place, at.velocity), moving(at.velocity, accelerations));
    let energy = drive.magnetic([f[0], f[1], f[2], f[3]])
        + drive.mechanism.kinetic([f[4], f[5]])
        + (q[2] - q[3]).squared().half() / Tangent::fixed(drive.circuit.c3)
        + drive.mechanism.potential(q[4]);
    // the sum of rates times Lagrange's equations
    let motion = (0..6).fold(Sym::ZERO, |sum, i| {
        let inertia = (0..6).fold(Sym::ZERO, |sum, j| sum + instant.mass[i][j] * accelerations[j]);
        sum + at.velocity[i] * (inertia - instant.force[i] - lambda * instant.kinematics.rows[0][i])
    });
    let source = drive.source(at.time) * at.velocity[0];
    Equal(energy.slope - motion, source - heat(drive, at.velocity) + lambda * instant.kinematics.rate[0])
}

/// The power dissipated in resistances, diodes and bearings, W.
pub fn heat(drive: &CrankDrive<Sym>, [f1, f2, f4, f5, f6, f7]: [Sym; 6]) -> Sym {
    let Circuit { r1, r2, r4, r5, b6, b7, .. } = drive.circuit;
    let (half_sum, half_gap) = ((f4 + f2).half(), (f4 - f2).half());
    r1 * f1.powi(2)
        + r2 * f2.powi(2)
        + r4 * f4.powi(2)
        + r5 * f5.powi(2)
        + b6 * f6.powi(2)
        + b7 * f7.powi(2)
        + Sym::int(2) * (half_sum * voltage(drive, half_sum) + half_gap * voltage(drive, half_gap))
}
