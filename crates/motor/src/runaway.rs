//! Torque laws that accelerate a rotor without bound.

use super::Machine;

/// A speed beyond which a torque law drives the rotor ever harder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Driven {
    /// phi', rad/s; zero where the law drives at every speed of its direction
    pub beyond: f64,
    /// m phi' at some speed beyond, W: the power that the law gives the rotor
    pub power: f64,
    /// the speed of this power, rad/s
    pub at: f64,
}

/// Powers of two times the machine's own speed from which on the highest power of the speed in a law outweighs the others.
const FAR: [i32; 3] = [20, 30, 40];

/// The directions, backwards and forwards, in which a motor's torque law drives its rotor ever harder: negative friction drives
/// in both, a law that is even in the speed, such as that of a fan, in one.
pub fn runaway(machine: &impl Machine<f64>) -> [Option<Driven>; 2] {
    [-1.0, 1.0].map(|direction| driven(machine, direction))
}

fn driven(machine: &impl Machine<f64>, direction: f64) -> Option<Driven> {
    let own = direction * machine.frame_speed().abs().max(1.0);
    let torque = |speed: f64| machine.torque_law(speed - machine.frame_speed(), speed);
    let [near, far, farther] = FAR.map(|power| own * f64::from(power).exp2());
    let drives = [near, far, farther].iter().all(|&speed| torque(speed) * speed > 0.0);
    // a constant torque drives too, as a weight does, but not harder
    let harder = torque(farther).abs() > 2.0 * torque(far).abs() && torque(far).abs() > 2.0 * torque(near).abs();
    if !(drives && harder) {
        return None;
    }
    // the driving begins between a speed far below the machine's own and one far above; their ratio is halved until it
    // is found
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
