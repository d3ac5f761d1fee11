//! Random motors, on benches and in gyrostats, as scene files; they are reproducible by a seed.

use simulation::ensemble::draw::Draw;
use std::fmt::Write;

/// A sequence of random numbers for one scene.
pub struct Numbers {
    draw: Draw,
    next: usize,
}

impl Numbers {
    /// The numbers of a seed, for scenes of a name.
    pub fn new(seed: u64, name: &str) -> Self {
        Numbers { draw: Draw::new(1834, seed, name), next: 0 }
    }

    pub fn even(&mut self) -> f64 {
        self.next += 1;
        self.draw.even(self.next)
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.even()
    }

    /// A number whose logarithm is uniformly distributed.
    pub fn scale(&mut self, low: f64, high: f64) -> f64 {
        low * (high / low).powf(self.even())
    }
}

/// A scene: on a bench or in a gyrostat, with a synchronous or another motor, with arbitrary time constants of the
/// currents.
pub fn scene(seed: u64) -> String {
    let mut draw = Numbers::new(seed, "motor");
    let mut text = String::from("title = \"drawn\"\n");
    let gyrostat = draw.even() < 0.5;
    // writing to a String cannot fail
    let _ = match gyrostat {
        true => writeln!(
            text,
            "system = \"gyrostat\"\ngravity = \"9.81 m/s^2\"\n[carrier]\nmass = \"{} kg\"\ncentre = \"2 -1 {} mm\"\n\
             inertia = \"0.0096 0.0001 -0.0002; 0.0001 0.0102 0.0001; -0.0002 0.0001 0.0034 kg m^2\"\n[rotor]\nmass = \"{} kg\"\n\
             centre = \"0 9 72 mm\"\naxis = \"0 0.6 0.8\"\naxial = \"2.4e-4 kg m^2\"\ntransverse = \"1.5e-4 kg m^2\"",
            draw.between(1.0, 2.0),
            draw.between(30.0, 60.0),
            draw.between(0.2, 0.4)
        ),
        false => writeln!(text, "system = \"bench\"\n[rotor]\naxial = \"{} kg m^2\"", draw.scale(1e-4, 1e-3)),
    };
    let speed = draw.between(100.0, 200.0);
    let (l1, l2) = (draw.scale(1e-3, 5e-2), draw.scale(1e-5, 2e-3));
    let (r1, r2) = (l1 * draw.scale(20.0, 2e3), l2 * draw.scale(20.0, 2e4));
    let (a1, a2) = (draw.between(0.01, 0.03), (r2 * draw.scale(1e-5, 3e-3)).sqrt());
    let _ = writeln!(
        text,
        "[machine]\nmodel = \"multi_current\"\nfield_speed = \"{speed} rad/s\"\nb0 = \"{} N m\"\na1 = \"{a1} Wb\"\nl1 = \"{l1} H\"\n\
         r1 = \"{r1} ohm\"\na2 = \"{a2} Wb\"\nl2 = \"{l2} H\"\nr2 = \"{r2} ohm\"\nmu = \"1e-5 N m s\"\nf = \"{} N m s\"\nbars = {}",
        draw.scale(0.05, 0.3),
        draw.scale(1e-5, 2e-4),
        1 + (8.0 * draw.even()) as usize
    );
    let in_step = draw.even() < 0.7;
    let (lag, angle) = if in_step { (draw.between(-3.0, 3.0), 0.3) } else { (-speed * draw.even(), 3.0) };
    text += "[start]\n";
    if gyrostat {
        let mut push = || draw.between(-0.5, 0.5);
        let _ =
            writeln!(text, "angular_velocity = \"{} {} {} rad/s\"\nvertical = \"0 0.28 0.96\"", push(), push(), push());
    }
    let (angle, span) = (draw.between(-angle, angle), draw.scale(0.05, 0.5));
    let _ = writeln!(text, "rotor_angle = \"{angle} rad\"\nrotor_speed = \"{} rad/s\"", speed + lag);
    let _ = writeln!(text, "[run]\nspan = \"{span} s\"\noutputs = [\"angle\", \"rotor_speed\"]");
    text
}
