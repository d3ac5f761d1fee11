//! Models composed at random from parts of every kind.

use super::numbers::Drawn;

/// The parameters and coordinates of all models.
const HEAD: &str = r#"
[parameters]
m = "1.3 kg"
k = "4 N/m"
w = "1.1 rad/s"
l = "0.6 m"
v = "0.7 m/s"
g = "9.81 m/s^2"
[coordinates]
x = "m"
y = "m"
a = "rad"
b = "rad"
"#;

const GRAVITY: [&str; 4] = ["", "-g*N.z", "-g*N.y", "-g*(1 + t/(3 s))*N.z"];
const FRAMES: [&str; 3] = ["N turned 0*t*w about z", "N turned w*t about z", "N turned b about y"];
const CENTRES: [&str; 4] = [
    "O + x*H.x + y*H.y",
    "O + x*H.x + y*H.y + l*A.x",
    "O + x*N.x + y*H.y + (0.2 m)*sin(w*t)*N.z",
    "O + x*H.x + (0.3 m)*A.y + y*y/(1 m)*H.z",
];
const MASSES: [&str; 4] = ["m", "m", "m + (0.2 kg/s)*t", "m*(1 + x^2/(4 m^2))"];
const FORCES: [&str; 6] = [
    "[[force]]\non = \"one\"\nis = \"-k*x*N.x - (0.3 N s/m)*velocity(one)\"\n",
    "[[force]]\nbetween = [\"one at Q\", \"two\"]\nis = \"-k*(distance(Q, R) - l)\"\n",
    "[[force]]\nalong = \"y\"\nis = \"(0.5 N)*cos(a) - (0.2 N s/m)*y'\"\n",
    "[[torque]]\nbetween = [\"H\", \"one\"]\nis = \"-(0.3 N m s)*a'*A.z\"\n",
    "[energies]\npotential = \"k/2*(x - (0.2 m)*sin(w*t))^2\"\n",
    "[energies]\npotential = \"k/2*y^2\"\ndissipation = \"(0.4 N s/m)/2*x'^2\"\n",
];
const CONSTRAINTS: [&str; 12] = [
    "x - l*sin(a)",
    "y - (0.3 m)*cos(w*t)",
    "x' - v",
    "y' - l*a'*cos(b)",
    "x'*sin(a) - y'*cos(a)",
    "x'*sin(a) - y'*cos(a) - v*sin(w*t)",
    "x'^2 + y'^2 - v^2",
    "x'^2 - y'^2*(1 + x^2/(1 m^2))",
    "b' - a'*cos(a) - (0.3 rad/s)",
    "velocity(one at Q) . A.y",
    "(Q - O) . N.x - (0.4 m)",
    "a' - 2*b'",
];

/// Definitions of free frames, and constraints on such a frame.
const FREE: [&str; 2] = ["N free", "H free"];
const HOLDING: [&str; 5] = [
    "F.wz - (0.8 rad/s)*cos(w*t)",
    "velocity(three at S) . N.x",
    "velocity(three at S) . F.y - v",
    "F.wx*x/(1 m) - F.wy",
    "F.wx^2 - F.wy*F.wz",
];

/// Returns the text of the next model.
pub fn text(drawn: &mut Drawn) -> String {
    let mut chosen = |count: usize| ((drawn.number() + 1.0) / 2.0 * count as f64) as usize % count;
    let mut text = "title = \"Composed\"\n".to_owned();
    let gravity = GRAVITY[chosen(GRAVITY.len())];
    if !gravity.is_empty() {
        text += &format!("gravity = \"{gravity}\"\n");
    }
    text += HEAD;
    let (frame, centre) = (FRAMES[chosen(FRAMES.len())], CENTRES[chosen(CENTRES.len())]);
    text += &format!("[frames]\nH = \"{frame}\"\nA = \"H turned a about z\"\nB = \"N turned b about z\"\n");
    let free = (chosen(3) == 0).then(|| FREE[chosen(FREE.len())]);
    if let Some(free) = free {
        text += &format!("F = \"{free}\"\n");
    }
    text += &format!("[points]\nP = \"{centre}\"\nQ = \"P + l*A.x\"\nR = \"O + (2 m)*N.x + l*B.y\"\n");
    let mass = MASSES[chosen(MASSES.len())];
    let inertia = r#"{ xx = "m*l^2/3", yy = "m*l^2", zz = "m*l^2", xy = "m*l^2/9" }"#;
    let mut bodies = format!("[bodies.one]\nframe = \"A\"\ncentre = \"P\"\nmass = \"{mass}\"\ninertia = {inertia}\n");
    bodies += "[bodies.two]\nframe = \"B\"\ncentre = \"R\"\nmass = \"m\"\ninertia = \"m*l^2/2\"\n";
    if free.is_some() {
        let inertia = r#"{ xx = "m*l^2", yy = "2*m*l^2", zz = "m*l^2*(1 + t/(5 s))", yz = "m*l^2/7" }"#;
        text += "S = \"P + l*F.x\"\n";
        bodies += &format!("[bodies.three]\nframe = \"F\"\ncentre = \"S\"\nmass = \"m\"\ninertia = {inertia}\n");
        bodies += "[[torque]]\non = \"three\"\nis = \"-(0.2 N m s)*F.w + (0.1 N m)*N.y\"\n";
    }
    text += &bodies;
    let (one, other) = (chosen(FORCES.len()), chosen(FORCES.len()));
    text += FORCES[one];
    if one != other && !(FORCES[one].starts_with("[energies]") && FORCES[other].starts_with("[energies]")) {
        text += FORCES[other];
    }
    let first = chosen(CONSTRAINTS.len());
    let second = (first + 1 + chosen(CONSTRAINTS.len() - 1)) % CONSTRAINTS.len();
    let own = [first, second].map(|zero| CONSTRAINTS[zero]).into_iter().take(chosen(3));
    let holding = free.map(|_| HOLDING[chosen(HOLDING.len())]);
    for zero in own.chain(holding).collect::<Vec<_>>() {
        text += &format!("[[constraint]]\nzero = \"{zero}\"\n");
        if chosen(4) == 0 {
            let of_speeds = ["'", "velocity", "F.w"].iter().any(|rate| zero.contains(rate));
            let gains = if of_speeds { r#""(2 1/s)""# } else { r#""(2 1/s)", "(3 1/s^2)""# };
            text += &format!("programmed = {{ gains = [{gains}] }}\n");
        }
    }
    text
}
