//! Detection of torque laws that accelerate a rotor without bound.

use super::Machine;

/// The range of speeds in which a torque law accelerates the rotor increasingly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Driven {
    /// The speed phi' where the range begins, rad/s; zero if it contains every speed of its direction.
    pub beyond: f64,
    /// The power m phi' on the rotor at a speed within the range, W.
    pub power: f64,
    /// The speed of this power, rad/s.
    pub at: f64,
}

/// Exponents of two of multiples of the machine's own speed: at such speeds the highest power of the speed in a law
/// dominates.
const FAR: [i32; 3] = [20, 30, 40];

/// For negative and for positive speeds, the range in which a motor's torque law accelerates its rotor increasingly.
/// Negative friction has both; a torque that is even in the speed, such as that of a fan with a wrong sign, has one.
pub fn runaway(machine: &impl Machine<f64>) -> [Option<Driven>; 2] {
    [-1.0, 1.0].map(|direction| driven(machine, direction))
}

fn driven(machine: &impl Machine<f64>, direction: f64) -> Option<Driven> {
    let own = direction * machine.frame_speed().abs().max(1.0);
    let torque = |speed: f64| machine.torque_law(speed - machine.frame_speed(), speed);
    let [near, far, farther] = FAR.map(|power| own * f64::from(power).exp2());
    let drives = [near, far, farther].iter().all(|&speed| torque(speed) * speed > 0.0);
    // a constant torque, such as that of a weight, accelerates too, but not increasingly
    let harder = torque(farther).abs() > 2.0 * torque(far).abs() && torque(far).abs() > 2.0 * torque(near).abs();
    if !(drives && harder) {
        return None;
    }
    // the range begins between a speed far below the machine's own and one far above; bisection of their logarithms
    let (mut brakes, mut drives) = (own * f64::from(-FAR[0]).exp2(), near);
    if torque(brakes) * brakes > 0.0 {
        return Some(Driven { beyond: 0.0, power: torque(own) * own, at: own });
    }
    for _ in 0..64 {
        let middle = direction * (brakes * drives).sqrt();
        if torque(middle) * middle > 0.0 { drives = middle } else { brakes = middle }
    }
    Some(Driven { beyond: drives, power: torque(2.0 * drives) * 2.0 * drives, at: 2.0 * drives })
}
