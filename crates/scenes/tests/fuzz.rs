//! Files that nobody meant: whatever stands in them, they are read or refused with a message at a place, and nothing panics.

use scenes::{ModelScene, parse_ensemble};

const TEXTS: [&str; 5] = [
    include_str!("../../../scenes/models/double_pendulum.toml"),
    include_str!("../../../scenes/models/rolling_disc.toml"),
    include_str!("../../../scenes/models/slider_crank.toml"),
    include_str!("../../../scenes/models/cart_with_two_links.toml"),
    include_str!("../../../scenes/models/chaplygin_sleigh.toml"),
];

/// Pieces that take the place of a part of a text.
const PIECES: [&str; 48] = [
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

#[test]
fn whatever_stands_in_a_file_it_is_read_or_refused_with_reasons() {
    let mut drawn = Drawn(36);
    let (mut read, mut refused) = (0, 0);
    for round in 0..4_000 {
        let text = changed(TEXTS[round % TEXTS.len()], &mut drawn);
        match ModelScene::parse("scene.toml", &text) {
            Ok(scene) => {
                read += 1;
                assert!(scene.start.iter().all(|number| number.is_finite()), "{text}");
            }
            Err(error) => {
                refused += 1;
                assert!(!error.issues.is_empty() && !error.to_string().is_empty(), "{text}");
            }
        }
    }
    assert!(read > 200 && refused > 200, "{read} {refused}");
}

#[test]
fn whatever_varies_a_member_starts_or_says_why() {
    let text = TEXTS[2].to_owned()
        + "\n[ensemble]\nmembers = 4\n[ensemble.vary]\nparameters.l = { from = \"0.1 m\", to = \"0.4 m\" }\n\
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
