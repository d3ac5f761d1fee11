//! Files that nobody meant: whatever stands in them, they are read or refused with a message at a place, what is read runs or says why
//! it stops, and nothing panics or takes long.
//!
//! `FUZZ_ROUNDS=100000 cargo test --test fuzz -- --nocapture` tries more of them, and prints the resident memory every 10,000.

use derivations::scene::{Choice, Smooth};
use scenes::{ModelScene, parse_ensemble};
use std::time::{Duration, Instant};

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

const TEXTS: [&str; 8] = [
    EVERYTHING,
    include_str!("../../../scenes/models/bouncing_ball.toml"),
    include_str!("../../../scenes/models/dry_friction.toml"),
    include_str!("../../../scenes/models/double_pendulum.toml"),
    include_str!("../../../scenes/models/rolling_disc.toml"),
    include_str!("../../../scenes/models/slider_crank.toml"),
    include_str!("../../../scenes/models/cart_with_two_links.toml"),
    include_str!("../../../scenes/models/chaplygin_sleigh.toml"),
];

/// Pieces that take the place of a part of a text.
const PIECES: [&str; 82] = [
    "v",
    "w'",
    "velocity(P) . A.x",
    "[speeds]\nu = \"x'\"\n",
    "0",
    "-1",
    "1e300",
    "1e-300",
    "nan",
    "theta",
    "x'",
    "x''",
    "t",
    "N",
    "O",
    "N.x",
    "N.w",
    "ground",
    "O + ",
    " . ",
    "cross(",
    ")",
    "(",
    "^",
    "^64",
    "^(1/2)",
    "velocity(",
    "rate(",
    " at ",
    " in ",
    "kg",
    "m",
    "rad",
    "N m",
    "\"",
    "[",
    "]",
    "=",
    "\n",
    "*",
    "/",
    "-",
    "sqrt(",
    "norm(",
    "distance(P, P)",
    "free",
    " turned ",
    " about z",
    "guess ",
    "é",
    "\u{0}",
    "zero = \"0\"\n",
    "if(",
    "if(t < (1 s), ",
    " < ",
    " >= ",
    ", ",
    "sign(",
    "abs(",
    "min(",
    "max(",
    "table(t, (0 s), 0, (1 s), 1)",
    "exp(",
    "ln(",
    "tanh(",
    "acos(",
    "atan2(",
    "reaction(led)",
    "joint_force(rod)",
    "unit(",
    "N.x",
    "angular_velocity(A)",
    "[[event]]\nwhen = \"x\"\nend = true\n",
    "[[event]]\nwhen = \"t - (0.1 s)\"\nset = { \"x'\" = \"0\" }\n",
    "direction = \"down\"\n",
    "set = { x = \"0\" }\n",
    "[inputs]\nv = { unit = \"N\", value = \"t*(1 N/s)\" }\n",
    "[[force]]\nbetween = [\"ground at O\", \"P\"]\nis = \"(1 N)\"\n",
    "[[torque]]\non = \"A\"\nis = \"(1 N m)*N.z\"\n",
    "[[constraint]]\nzero = \"theta\"\n",
    "programmed = { gains = [\"(1 1/s)\"] }\n",
    "[energies]\nkinetic = \"(1 kg)*x'^2\"\n",
];

/// Numbers that are drawn the same way each time.
struct Drawn(u64);

impl Drawn {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as usize) % bound
    }
}

/// A place between two letters.
fn place(text: &str, drawn: &mut Drawn) -> usize {
    let mut at = drawn.below(text.len() + 1);
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

fn changed(text: &str, drawn: &mut Drawn) -> String {
    let mut text = text.to_owned();
    for _ in 0..1 + drawn.below(3) {
        let (a, b) = (place(&text, drawn), place(&text, drawn));
        let short = a.min(b)..a.max(b).min(a.min(b) + 12);
        match drawn.below(4) {
            0 => text.insert_str(a, PIECES[drawn.below(PIECES.len())]),
            1 if text.is_char_boundary(short.end) => text.replace_range(short, PIECES[drawn.below(PIECES.len())]),
            2 => {
                let mut lines: Vec<&str> = text.lines().collect();
                let (from, to) = (drawn.below(lines.len()), drawn.below(lines.len()));
                lines.insert(to, lines[from]);
                text = lines.join("\n");
            }
            _ => {
                let mut lines: Vec<&str> = text.lines().collect();
                lines.remove(drawn.below(lines.len()));
                text = lines.join("\n");
            }
        }
    }
    text
}

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

/// A free body on a spring with members; every command reads it.
const FREE: &str = r#"
title = "A free body"
gravity = "-g*N.z"

[parameters]
m = "2 kg"
l = "0.5 m"
J = "0.3 kg m^2"
g = "9.81 m/s^2"

[coordinates]
z = "m"
y = "m"

[speeds]
p = "F.wx"
q = "F.w . A.y"
r = "F.wz - F.wy"
n = "velocity(stone) . A.z"

[frames]
F = "N free"
A = "F turned (30 deg) about x"

[points]
P = "O + z*N.z + y*N.y"
Q = "P + l*A.x"

[bodies.stone]
frame = "F"
centre = "P"
mass = "m"
inertia = { axes = "A", principal = ["J", "J", "1.5*J"] }

[[force]]
between = ["ground at O + l*N.x", "stone at Q"]
is = "-(30 N/m)*(distance(O + l*N.x, Q) - l)"

[[constraint]]
name = "slide"
zero = "y - l*(F.x . N.y)"

[outputs]
slip = "reaction(slide) + (1 N/rad)*F.wx*(1 s)"

[start]
F = "20 deg about z, then 5 deg about y"
"F.wz" = "2 rad/s"
q = "0.3 rad/s"
y = "guess 0.1 m"

[run]
span = "1 s"

[ensemble]
members = 2

[ensemble.vary]
start.F = { mean = "0 0 0 deg", deviation = "5 5 5 deg" }
start."F.wx" = { from = "-1 rad/s", to = "1 rad/s" }
start.q = { from = "-1 rad/s", to = "1 rad/s" }
parameters.l = { from = "0.4 m", to = "0.6 m" }
"#;

/// Linear equations, rest, code and members of files with a free frame, whatever stands in them.
#[test]
fn free_frames_are_taken_by_every_command_or_refused() {
    use model::{MatrixForm, QuasiPrinciple, QuasiVelocities, Trace, principles::Principle};
    use scenes::linearisation::VariedEquations;
    let sound = ModelScene::parse("scene.toml", FREE).unwrap_or_else(|error| panic!("{error}"));
    assert!(sound.model.warnings.is_empty());
    let rounds = std::env::var("FUZZ_ROUNDS").ok().and_then(|rounds| rounds.parse().ok()).unwrap_or(600);
    let mut drawn = Drawn(38);
    let (mut linear, mut written, mut started, mut rested) = (0, 0, 0, 0);
    for _ in 0..rounds {
        let text = changed(FREE, &mut drawn);
        if let Ok(scene) = parse_ensemble("scene.toml", &text) {
            started += (1..=scene.members.min(2)).filter(|number| scene.member(*number).is_ok()).count();
        }
        let Ok(scene) = ModelScene::parse("scene.toml", &text) else { continue };
        if let Ok(equations) = VariedEquations::of(&scene.model, &[])
            && let Ok(found) = equations.linearised(equations.point(0.0, &scene.start))
        {
            linear += 1;
            let size = found.coordinates.len() + found.speeds.len();
            assert_eq!(found.a.shape(), (size, size), "{text}");
            assert!(found.a.iter().all(|entry| entry.is_finite()), "{text}");
        }
        rested += usize::from(scenes::equilibrium_of(&scene.model).is_ok());
        written += symbolic::apart(|| {
            let trace = Trace::of(&scene.model);
            let form = MatrixForm::of(&trace, Principle::VirtualPower).ok();
            if !scene.model.quasi_velocities.is_empty() {
                let quasi = QuasiVelocities::of(&trace).unwrap_or_else(|faults| panic!("{faults:?}\n{text}"));
                let form = MatrixForm::in_quasi_velocities(&trace, &quasi, QuasiPrinciple::Hamel).ok();
                form.and_then(|form| model::code(&trace, &form, symbolic::Language::C).ok());
            }
            form.is_some_and(|form| model::code(&trace, &form, symbolic::Language::C).is_ok()) as usize
        });
    }
    println!("{linear} linear, {written} written, {started} members, {rested} at rest");
    assert!(linear > 50 && written > 50 && started > 50, "{linear} {written} {started}");
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

#[test]
fn whatever_varies_a_member_starts_or_says_why() {
    let text = include_str!("../../../scenes/models/slider_crank.toml").to_owned()
        + "\n[ensemble]\nmembers = 4\n[ensemble.vary]\nparameters.l = { from = \"0.01 m\", to = \"0.06 m\" }\n\
        start.theta = { mean = \"0 rad\", deviation = \"1 rad\" }\nstart.\"phi'\" = { values = \"1 2 3 4 rad/s\" }\n";
    let sound = with_guess(&text);
    let mut drawn = Drawn(37);
    let (mut started, mut stopped, mut refused) = (0, 0, 0);
    for _ in 0..1_000 {
        match parse_ensemble("scene.toml", &changed(&sound, &mut drawn)) {
            Ok(scene) => {
                for number in 1..=scene.members.min(4) {
                    match scene.member(number) {
                        Ok(member) => {
                            started += 1;
                            assert!(member.state.iter().all(|number| number.is_finite()), "{sound}");
                        }
                        Err(why) => {
                            stopped += 1;
                            assert!(!why.to_string().contains("NaN"), "{why}");
                        }
                    }
                }
            }
            Err(error) => {
                refused += 1;
                assert!(!error.issues.is_empty() && !error.to_string().is_empty(), "{error}");
            }
        }
    }
    assert!(started > 100 && stopped > 50 && refused > 100, "{started} {stopped} {refused}");
}

/// The slider where the loop puts it.
fn with_guess(text: &str) -> String {
    text.replace("s = \"0.4 m\"", "s = \"guess 0.4 m\"")
}
