//! Fuzz tests of scene files. Each file is read, or refused with a message and its place; each accepted scene runs, or gives the reason why it
//! stopped. Nothing panics or takes long.
//!
//! `FUZZ_ROUNDS=100000 cargo test --test fuzz -- --nocapture` runs more rounds and prints the resident memory every 10,000 rounds.

mod files;
mod free_frames;
mod members;
mod texts;

/// Texts that replace a part of a file.
const PIECES: [&str; 94] = [
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
    "[[diode]]\ncurrent = \"q'\"\n",
    "[[freewheel]]\nspeed = \"theta'\"\n",
    "drop = \"(1 V)\"\n",
    "[[contact]]\nof = \"block\"\nthrough = \"O\"\nnormal = \"N.x\"\n",
    "[regulator]\ncost = \"(theta/(1 rad))^2 + (u/(1 N))^2\"\n",
    "horizon = \"1 s\"\n",
    "last = \"(x/(1 m))^2\"\n",
    "displaced = { theta = \"1 deg\" }\n",
    "[energies]\ncoenergy = \"(1 H)*q'^2/2\"\n",
    "motor.i",
    "reaction(D)",
    "touching = true\n",
];

/// A deterministic generator of pseudo-random numbers (linear congruential).
struct Drawn(u64);

impl Drawn {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 33) as usize) % bound
    }
}

/// A random offset in bytes at the boundary of a character.
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
