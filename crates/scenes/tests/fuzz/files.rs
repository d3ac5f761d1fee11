//! Whole files.

use super::{Drawn, changed};
use derivations::scene::{Choice, Smooth};
use scenes::conformance::conform;
use scenes::regulator::regulated;
use scenes::{ModelScene, regimes};
use std::time::{Duration, Instant};

const TEXTS: [&str; 14] = [
    EVERYTHING,
    MACHINE,
    MOTORS,
    BALL,
    include_str!("../../../../scenes/models/cart_pole.toml"),
    include_str!("../../../../scenes/models/leaning_ladder.toml"),
    include_str!("../../../../scenes/models/geared_motor.toml"),
    include_str!("../../../../scenes/models/bouncing_ball.toml"),
    include_str!("../../../../scenes/models/dry_friction.toml"),
    include_str!("../../../../scenes/models/double_pendulum.toml"),
    include_str!("../../../../scenes/models/rolling_disc.toml"),
    include_str!("../../../../scenes/models/slider_crank.toml"),
    include_str!("../../../../scenes/models/cart_with_two_links.toml"),
    include_str!("../../../../scenes/models/chaplygin_sleigh.toml"),
];

/// A ball on a rough slope in space, beside a rough wall.
const BALL: &str = r#"
title = "A ball"
gravity = "-g*N.z"

[parameters]
m = "0.17 kg"
r = "30 mm"
g = "9.81 m/s^2"
mu = "0.2"
a = "0.1 rad"

[coordinates]
x = "m"
y = "m"
z = "m"

[frames]
B = "N free"
S = "N turned a about y"

[points]
G = "O + x*S.x + y*S.y + z*S.z"
P = "G - r*S.z"

[bodies.ball]
frame = "B"
centre = "G"
mass = "m"
inertia = { principal = ["2/5*m*r^2", "2/5*m*r^2", "2/5*m*r^2"] }

[[contact]]
name = "cloth"
of = "ball at P"
through = "O"
normal = "S.z"
friction = "mu"
restitution = "0.5"

[[contact]]
name = "wall"
of = "ball at G + r*S.x"
through = "O + (0.2 m)*S.x"
normal = "-S.x"
friction = "mu"

[outputs]
slip = "norm(sliding(cloth))"
T = "friction(cloth) . N.x"

[start]
z = "30 mm"
"x'" = "1 m/s"
"y'" = "0.5 m/s"
"B.wx" = "-30 rad/s"

[run]
span = "0.3 s"
"#;

/// Windings, diodes, a freewheel, a contact, a regulator.
const MACHINE: &str = r#"
title = "A machine"
gravity = "-g*N.y"

[parameters]
m = "2 kg"
J = "1e-3 kg m^2"
L = "10 mH"
M = "4 mH"
R = "2 ohm"
k = "0.05 V s"
U = "12 V"
g = "9.81 m/s^2"
mu = "0.3"
e = "0.5"

[coordinates]
theta = "rad"
load = "rad"
x = "m"
y = "m"
q = "C"

[points]
C = "O + x*N.x + y*N.y"

[bodies]
block = { centre = "C", mass = "m" }
wheel = { turns = "load", inertia = "J" }
rotor = { turns = "theta", inertia = "J" }

[energies]
coenergy = "L/2*q'^2 + M*q'*motor.i"
dissipation = "R/2*q'^2"

[inputs]
u = "N"

[[force]]
along = "q"
is = "U*sin((300 rad/s)*t)"

[[force]]
along = "x"
is = "u"

[[drive]]
name = "motor"
turns = "theta"
torque = "-(1e-4 N m s)*motor.speed"

[[drive.winding]]
inductance = "L"
resistance = "R"
supply = "U"
motional = "k"

[[diode]]
name = "D"
current = "q'"
drop = "(0.7 V)"

[[freewheel]]
name = "F"
speed = "load' - theta'"

[[contact]]
name = "floor"
of = "block"
through = "O"
normal = "N.y"
friction = "mu"
restitution = "e"

[regulator]
inputs = ["u"]
cost = "(x/(1 m))^2 + (u/(1 N))^2"
horizon = "0.1 s"

[outputs]
blocked = "reaction(D)"
pressure = "reaction(floor)"

[start]
y = "0.1 m"
"x'" = "0.5 m/s"

[run]
span = "0.2 s"
samples = 5
"#;

/// Motors of the program and in their own letters, a shaft in space, charges without inductances.
const MOTORS: &str = r#"
title = "Motors"

[parameters]
A = "0.4 kg m^2"
J = "1e-3 kg m^2"
U = "10 V"
R = "1 kohm"
C = "1 uF"

[coordinates]
s = "rad"
theta = "rad"
q = "C"
p = "C"
z = "rad"

[frames]
F = "N free"
W = "F turned s about x"

[bodies.satellite]
frame = "F"
inertia = { principal = ["A", "A", "2*A"] }

[bodies.disc]
turns = "theta"
inertia = "J"

[energies]
potential = "q^2/(2*C)"
dissipation = "R/2*(p' - q')^2 + R/2*p'^2"

[[force]]
along = "p"
is = "U*cos((300 rad/s)*t)"

[[constraint]]
name = "integral"
zero = "z' - ((100 rad/s) - theta')"

[[drive]]
name = "wheel"
between = ["satellite", "W"]
inertia = "J"

[drive.machine]
model = "brushed"
voltage = "24 V"
flux = "45 mWb"
inductance = "2 mH"
resistance = "0.6 ohm"
f = "1e-4 N m s"

[[drive]]
name = "motor"
turns = "theta"
ratio = "3"
torque = "(1e-3 N m)*z"

[drive.machine]
model = "text"
field_speed = "50 rad/s"
field_energy = "-b*cos(g)"
moment_law = "-f*phi' - k*g'"

[drive.machine.parameters]
b = "0.1 N m"
f = "1e-3 N m s"
k = "2e-3 N m s"
l = "3 mH"
r = "2 ohm"

[[drive.machine.winding]]
inductance = "l"
resistance = "r"
flux = "(0.05 Wb)*cos(g)"

[outputs]
current = "wheel.i"
torque = "motor.torque"

[start]
"F.wy" = "0.3 rad/s"

[run]
span = "0.05 s"
samples = 5
"#;

/// A little of everything that the language has.
const EVERYTHING: &str = r#"
title = "Everything"
gravity = "-g*N.y"

[parameters]
m = "2 kg"
l = "0.5 m"
F = "3 N"
g = "9.81 m/s^2"

[coordinates]
x = "m"
theta = "rad"

[speeds]
v = "velocity(rod) . A.x"
w = "theta' + v/l"

[definitions]
reach = "l*sin(theta) + l*tanh(theta)*exp(-theta^2)"

[frames]
A = "N turned theta about z"

[points]
C = "O + x*N.x"
P = "C - l*A.y"

[bodies.cart]
centre = "C"
mass = "m"

[bodies.rod]
frame = "A"
centre = "P"
mass = "m"
inertia = "m*l^2/12"

[inputs]
u = { unit = "N", value = "if(t < (0.1 s), F, 0) + F*table(t, (0 s), 0, (1 s), 1)" }

[[force]]
on = "cart"
is = "(u - F/10*sign(x'))*N.x"

[[force]]
between = ["ground at O + (2 m)*N.y", "rod"]
is = "-F*min(distance(P, O + (2 m)*N.y)/l, 2)"

[[torque]]
between = ["ground", "rod"]
is = "-(0.1 N m s)*theta'*N.z"

[energies]
potential = "F*l*abs(x/l)"

[[constraint]]
name = "led"
zero = "theta - atan2(x, l)"
programmed = { gains = ["(2 1/s)", "(1 1/s^2)"] }

[[event]]
name = "wall"
when = "x - (0.1 m)"
direction = "up"
set = { "x'" = "-0.5*x'" }

[[event]]
when = "x + l"
end = true

[outputs]
width = "max(reach, ln(1 + (x/l)^2)*l)"
led = "reaction(led)"
slip = "v' - l*w'"
height = "(P - O) . N.y"

[start]
theta = "0.3 rad"
x = "guess 0.01 m"

[run]
span = "0.3 s"
samples = 5
"#;

/// Pages of the process that are in memory, in MB; none where nobody counts them.
fn resident() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmRSS"))?;
    line.split_whitespace().nth(1)?.parse::<f64>().ok().map(|kilobytes| kilobytes / 1024.0)
}

/// The longest that one file may take, from text to the end of a run that is given a tenth of a second.
const LONGEST: Duration = Duration::from_secs(5);

#[test]
fn whatever_stands_in_a_file_it_is_read_or_refused_with_reasons() {
    let rounds = std::env::var("FUZZ_ROUNDS").ok().and_then(|rounds| rounds.parse().ok()).unwrap_or(4_000);
    let mut drawn = Drawn(36);
    let (mut read, mut refused, mut longest) = (0, 0, Duration::ZERO);
    for round in 0..rounds {
        if round % 10_000 == 0 && rounds > 10_000 {
            println!("{round}: {:?} MB, {read} read, {refused} refused, longest {longest:?}", resident());
        }
        let text = changed(TEXTS[round % TEXTS.len()], &mut drawn);
        let begin = Instant::now();
        match ModelScene::parse("scene.toml", &text) {
            Ok(scene) => {
                read += 1;
                assert!(scene.start.iter().all(|number| number.is_finite()), "{text}");
                let choice = Choice { samples: 4, allowed: Duration::from_millis(100), ..scene.run().choice() };
                let trajectory = scene.problem(choice.axes).simulate(&choice, |_| {});
                assert!(trajectory.outcome.state.iter().all(|number| number.is_finite()), "{text}");
                if let Ok(found) = regimes((*scene.model).clone()) {
                    let values = found.regimes.iter().flat_map(|regime| &regime.margins).map(|margin| margin.value);
                    assert!(values.into_iter().all(f64::is_finite), "{text}");
                }
                assert_eq!(conform(&scene.model).len(), 7, "{text}");
                if let Ok(found) = regulated(&scene, Duration::from_millis(100)) {
                    let numbers = found.gains.iter().chain(found.value.iter()).chain([&found.predicted]);
                    assert!(numbers.copied().all(f64::is_finite), "{text}");
                }
            }
            Err(error) => {
                refused += 1;
                assert!(!error.issues.is_empty() && !error.to_string().is_empty(), "{text}");
            }
        }
        longest = longest.max(begin.elapsed());
        assert!(begin.elapsed() < LONGEST, "{:?}\n{text}", begin.elapsed());
    }
    println!("{rounds}: {:?} MB, {read} read, {refused} refused, longest {longest:?}", resident());
    assert!(read > 200 && refused > 200, "{read} {refused}");
}

/// Each model has decimals of its own with seventeen digits, in powers and products of hundreds of digits. Exact, their constants would
/// take 6 KB a model and stay.
#[test]
fn long_constants_leave_memory_flat() {
    let text = |k: usize| {
        let digits = format!("{:.16}", 1.2 + k as f64 * 1.234567891234567e-5);
        format!(
            "title = \"A mass\"\n[parameters]\nm = \"2 kg\"\n[coordinates]\nx = \"m\"\n\
             [bodies.b]\ncentre = \"O + x*N.x\"\nmass = \"m\"\n\
             [[force]]\non = \"b\"\nis = \"(1 N)*({digits}^40 - {digits}^39*{digits})*N.x - (1 N)*(x/(1 m))*{digits}^23/{digits}^21*N.x\"\n\
             [start]\nx = \"1 m\"\n[run]\nspan = \"1 s\"\n"
        )
    };
    let (warm, all) = (200, 2_200);
    let mut before = None;
    for k in 0..all {
        if k == warm {
            before = resident();
        }
        let scene = ModelScene::parse("scene.toml", &text(k)).unwrap_or_else(|error| panic!("{error}"));
        let mut rates = [0.0; 2];
        integrators::Ode::<f64>::rates(&*scene.system, 0.0, &[1.0, 0.0], &mut rates);
        let digit = 1.2 + k as f64 * 1.234567891234567e-5;
        assert!((rates[1] + digit * digit / 2.0).abs() < 1e-11, "{k}: {rates:?}");
    }
    let (Some(before), Some(after)) = (before, resident()) else { return };
    let per_model = (after - before) * 1024.0 / (all - warm) as f64;
    println!("{per_model} KB a model");
    assert!(per_model < 1.5, "{per_model} KB a model stay");
}
