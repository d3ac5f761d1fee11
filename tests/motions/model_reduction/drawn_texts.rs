//! Random text models of many kinds, reproducible by a seed.

use super::drawn::Numbers;

/// The number of kinds, which are generated in turn.
pub const KINDS: u64 = 14;

/// A scene and the name of its kind.
pub fn scene(seed: u64) -> (&'static str, String) {
    let draw = &mut Numbers::new(seed, "text");
    match seed % KINDS {
        0 => ("motor with a small inductance", motor(draw)),
        1 => ("pendulum on a stiff spring", stiff_spring(draw)),
        2 => ("systems apart", apart(draw)),
        3 => ("masses in a row", row(draw)),
        4 => ("double pendulum", double_pendulum(draw)),
        5 => ("driven pendulum with drag", driven(draw)),
        6 => ("creeping mass", creeping(draw)),
        7 => ("rotor that slides", cyclic(draw)),
        8 => ("symmetric start", symmetric(draw)),
        9 => ("dry friction", friction(draw)),
        10 => ("two circuits", circuits(draw)),
        11 => ("free body", free_body(draw)),
        12 => ("masses on a stiff spring", joined(draw)),
        _ => ("motor against dry friction", rubbing_motor(draw)),
    }
}

fn run(span: f64, outputs: &str) -> String {
    format!("[run]\nspan = \"{span} s\"\noutputs = [{outputs}]\n")
}

fn motor(draw: &mut Numbers) -> String {
    let (l, r) = (draw.scale(1e-6, 1e-2), draw.between(0.3, 3.0));
    format!(
        "title = \"motor\"\n[parameters]\nJ = \"{} kg m^2\"\nR = \"{r} ohm\"\nL = \"{l} H\"\nk = \"0.1 V s\"\nU = \"{} V\"\nc = \"{} N m s\"\n\
         [coordinates]\ntheta = \"rad\"\n[bodies.rotor]\nturns = \"theta\"\ninertia = \"J\"\n\
         [[torque]]\non = \"rotor\"\nis = \"-c*theta'*N.z - (0.01 N m)*sin(theta)*N.z\"\n\
         [[drive]]\nturns = \"theta\"\nmodel = \"text\"\n[[drive.winding]]\ninductance = \"L\"\nresistance = \"R\"\nsupply = \"U\"\nmotional = \"k\"\n{}",
        draw.scale(1e-4, 1e-2),
        draw.between(5.0, 30.0),
        draw.scale(1e-7, 1e-3),
        run(draw.between(0.3, 3.0), "\"theta'\"")
    )
}

fn stiff_spring(draw: &mut Numbers) -> String {
    let k = draw.scale(1e2, 1e7);
    let c = draw.scale(1e-2, 3.0) * k.sqrt();
    format!(
        "title = \"spring\"\n[parameters]\nm = \"1 kg\"\nM = \"{} kg\"\nl = \"0.5 m\"\nk = \"{k} N/m\"\nc = \"{c} N s/m\"\n\
         [coordinates]\nx = \"m\"\nphi = \"rad\"\n[points]\nA = \"O + x*N.x\"\nB = \"A + l*(sin(phi)*N.x - cos(phi)*N.y)\"\n\
         [bodies.cart]\ncentre = \"A\"\nmass = \"M\"\n[bodies.bob]\ncentre = \"B\"\nmass = \"m\"\n\
         [[force]]\non = \"cart\"\nis = \"(-k*x - c*x')*N.x\"\n[[force]]\non = \"bob\"\nis = \"-m*(9.81 m/s^2)*N.y\"\n\
         [start]\nphi = \"{} rad\"\n{}",
        draw.between(0.5, 3.0),
        draw.between(0.2, 1.5),
        run(draw.between(2.0, 8.0), "\"phi\"")
    )
}

fn apart(draw: &mut Numbers) -> String {
    let short = draw.scale(3e-3, 1.0);
    format!(
        "title = \"apart\"\n[parameters]\nl = \"1 m\"\ns = \"{short} m\"\n[coordinates]\na = \"rad\"\nb = \"rad\"\n[points]\n\
         A = \"O + l*(sin(a)*N.x - cos(a)*N.y)\"\nB = \"O + s*(sin(b)*N.x - cos(b)*N.y)\"\n\
         [bodies.one]\ncentre = \"A\"\nmass = \"1 kg\"\n[bodies.two]\ncentre = \"B\"\nmass = \"1 kg\"\n\
         [[force]]\non = \"one\"\nis = \"-(9.81 N)*N.y\"\n[[force]]\non = \"two\"\nis = \"-(9.81 N)*N.y\"\n\
         [start]\na = \"{} rad\"\nb = \"{} rad\"\n{}",
        draw.between(0.3, 2.0),
        draw.between(0.3, 2.0),
        run(draw.between(2.0, 8.0), "\"a\"")
    )
}

fn row(draw: &mut Numbers) -> String {
    let stiff = draw.scale(10.0, 1e6);
    format!(
        "title = \"row\"\n[parameters]\nk = \"10 N/m\"\nK = \"{stiff} N/m\"\nC = \"{} N s/m\"\nm = \"1 kg\"\nn = \"{} kg\"\nF = \"{} N\"\n\
         [coordinates]\nx = \"m\"\nu = \"m\"\n[points]\nA = \"O + x*N.x\"\nB = \"A + u*N.x\"\n\
         [bodies.one]\ncentre = \"A\"\nmass = \"m\"\n[bodies.two]\ncentre = \"B\"\nmass = \"n\"\n\
         [[force]]\non = \"one\"\nis = \"-k*x*N.x - (0.3 N/m^3)*x^3*N.x\"\n\
         [[force]]\nbetween = [\"one\", \"two\"]\nis = \"-K*u - C*u'\"\n\
         [[force]]\non = \"two\"\nis = \"F*cos(t*(2 rad/s))*N.x\"\n[start]\nx = \"{} m\"\n{}",
        draw.scale(0.1, 2.0) * stiff.sqrt(),
        draw.scale(1e-3, 1.0),
        draw.between(0.0, 2.0),
        draw.between(0.1, 1.0),
        run(draw.between(3.0, 10.0), "\"x\"")
    )
    .replace("between = [\"one\", \"two\"]\nis = \"-K*u - C*u'\"", "on = \"two\"\nis = \"(-K*u - C*u')*N.x\"\n[[force]]\non = \"one\"\nis = \"(K*u + C*u')*N.x\"")
}

fn double_pendulum(draw: &mut Numbers) -> String {
    format!(
        "title = \"double\"\n[parameters]\nl = \"1 m\"\ns = \"{} m\"\nm = \"{} kg\"\n[coordinates]\na = \"rad\"\nb = \"rad\"\n[points]\n\
         A = \"O + l*(sin(a)*N.x - cos(a)*N.y)\"\nB = \"A + s*(sin(b)*N.x - cos(b)*N.y)\"\n\
         [bodies.one]\ncentre = \"A\"\nmass = \"1 kg\"\n[bodies.two]\ncentre = \"B\"\nmass = \"m\"\n\
         [[force]]\non = \"one\"\nis = \"-(9.81 N)*N.y\"\n[[force]]\non = \"two\"\nis = \"-m*(9.81 m/s^2)*N.y\"\n\
         [start]\na = \"{} rad\"\nb = \"{} rad\"\n{}",
        draw.scale(0.05, 1.0),
        draw.scale(1e-6, 1.0),
        draw.between(0.1, 1.0),
        draw.between(-1.0, 1.0),
        run(draw.between(2.0, 5.0), "\"a\"")
    )
}

fn driven(draw: &mut Numbers) -> String {
    format!(
        "title = \"driven\"\n[parameters]\nl = \"1 m\"\nc = \"{} N s/m\"\nd = \"{} N s^3/m^3\"\nF = \"{} N\"\n[coordinates]\na = \"rad\"\n[points]\n\
         A = \"O + l*(sin(a)*N.x - cos(a)*N.y)\"\n[bodies.one]\ncentre = \"A\"\nmass = \"1 kg\"\n\
         [[force]]\non = \"one\"\nis = \"-(9.81 N)*N.y - c*velocity(A) - d*l^2*a'^2*velocity(A)\"\n\
         [[force]]\non = \"one\"\nis = \"F*sin(t*(3 rad/s))*N.x\"\n[start]\na = \"{} rad\"\n{}",
        draw.scale(1e-8, 1.0),
        draw.scale(1e-9, 0.1),
        draw.scale(1e-8, 1.0),
        draw.between(0.3, 2.0),
        run(draw.between(2.0, 10.0), "\"a\", \"a'\"")
    )
}

fn creeping(draw: &mut Numbers) -> String {
    let m = draw.scale(1e-6, 1.0);
    format!(
        "title = \"creeping\"\n[parameters]\nm = \"{m} kg\"\nk = \"5 N/m\"\nc = \"{} N s/m\"\n[coordinates]\nx = \"m\"\n[points]\nA = \"O + x*N.x\"\n\
         [bodies.b]\ncentre = \"A\"\nmass = \"m\"\n[[force]]\non = \"b\"\nis = \"(-k*x - c*x' + (1 N)*sin(t*(2 rad/s)))*N.x\"\n\
         [start]\nx = \"{} m\"\n{}",
        draw.between(1.0, 5.0),
        draw.between(-1.0, 1.0),
        run(draw.between(2.0, 10.0), "\"x\"")
    )
}

fn cyclic(draw: &mut Numbers) -> String {
    format!(
        "title = \"slides\"\n[parameters]\nm = \"{} kg\"\nJ = \"1 kg m^2\"\nk = \"{} N/m\"\n[coordinates]\nturn = \"rad\"\nr = \"m\"\nz = \"m\"\n\
         [energies]\nkinetic = \"J*turn'^2/2 + m*(r'^2 + r^2*turn'^2)/2 + (1 kg)*z'^2/2\"\npotential = \"k*(r - (1 m))^2/2 + (9.81 N)*z\"\n\
         [start]\nr = \"1.2 m\"\n\"turn'\" = \"{} rad/s\"\n{}",
        draw.scale(0.01, 1.0),
        draw.scale(5.0, 500.0),
        draw.between(0.5, 3.0),
        run(draw.between(2.0, 10.0), "\"r\", \"turn'\"")
    )
}

fn symmetric(draw: &mut Numbers) -> String {
    format!(
        "title = \"symmetric\"\n[parameters]\nl = \"1 m\"\nk = \"{} N/m\"\n[coordinates]\na = \"rad\"\nb = \"rad\"\nc = \"rad\"\n\
         [energies]\nkinetic = \"(1 kg)*l^2*(a'^2 + b'^2 + c'^2 + a'*b'*sin(b)*sin(c)/2)/2\"\n\
         potential = \"-(9.81 N)*l*(cos(a) + cos(b) + cos(c)) + k*l^2*sin(b)^2*sin(a)^2/2\"\n\
         [start]\na = \"{} rad\"\n{}",
        draw.scale(1.0, 1e4),
        draw.between(0.3, 2.0),
        run(draw.between(2.0, 8.0), "\"a\", \"b\"")
    )
}

fn friction(draw: &mut Numbers) -> String {
    format!(
        "title = \"friction\"\n[parameters]\nk = \"50 N/m\"\nF = \"{} N\"\nc = \"{} N s/m\"\n[coordinates]\nx = \"m\"\n[points]\nA = \"O + x*N.x\"\n\
         [bodies.b]\ncentre = \"A\"\nmass = \"1 kg\"\n[[force]]\non = \"b\"\nis = \"(-k*x - F*sign(x') - c*x')*N.x\"\n\
         [start]\nx = \"1 m\"\n{}",
        draw.scale(1e-8, 10.0),
        draw.scale(1e-6, 10.0),
        run(draw.between(1.0, 5.0), "\"x\"")
    )
}

fn circuits(draw: &mut Numbers) -> String {
    let l = draw.scale(1e-6, 1.0);
    format!(
        "title = \"circuits\"\n[parameters]\nL = \"1 H\"\nl = \"{l} H\"\nM = \"{} H\"\nR = \"2 ohm\"\nr = \"{} ohm\"\nC = \"{} F\"\n\
         [coordinates]\nq = \"C\"\np = \"C\"\n[energies]\nkinetic = \"L*q'^2/2 + l*p'^2/2 + M*q'*p'\"\npotential = \"q^2/(2*C)\"\n\
         dissipation = \"R*q'^2/2 + r*p'^2/2\"\n[[force]]\nalong = \"q\"\nis = \"(5 V)*cos(t*(10 rad/s))\"\n{}",
        0.5 * l.sqrt(),
        draw.scale(0.1, 100.0),
        draw.scale(1e-3, 1.0),
        run(draw.between(1.0, 5.0), "\"q\"")
    )
}

fn free_body(draw: &mut Numbers) -> String {
    format!(
        "title = \"body\"\n[coordinates]\nx = \"m\"\n[frames]\nF = \"N free\"\n[points]\nG = \"O + x*N.x\"\n\
         [bodies.b]\nframe = \"F\"\ncentre = \"G\"\nmass = \"1 kg\"\ninertia = {{ axes = \"F\", principal = [\"1 kg m^2\", \"{} kg m^2\", \"1.9 kg m^2\"] }}\n\
         [[force]]\non = \"b\"\nis = \"-({} N/m)*x*N.x\"\n[start]\nx = \"0.1 m\"\n\"F.wx\" = \"{} rad/s\"\n\"F.wy\" = \"{} rad/s\"\n{}",
        draw.between(1.0, 2.5),
        draw.scale(1.0, 1e5),
        draw.between(0.2, 2.0),
        draw.between(0.2, 2.0),
        run(draw.between(2.0, 8.0), "\"F.wx\", \"F.wz\"")
    )
}

fn joined(draw: &mut Numbers) -> String {
    format!(
        "title = \"joined\"\n[parameters]\nm = \"{} kg\"\nM = \"{} kg\"\nk = \"{} N/m\"\nK = \"{} N/m\"\nL = \"0.3 m\"\n\
         [coordinates]\nx = \"m\"\ny = \"m\"\n[bodies.a]\ncentre = \"O + x*N.x\"\nmass = \"m\"\n\
         [bodies.b]\ncentre = \"O + y*N.x\"\nmass = \"M\"\n[energies]\npotential = \"k*x^2/2 + (0.3 N/m^3)*x^4\"\n\
         [[force]]\nbetween = [\"a\", \"b\"]\nis = \"-K*(sqrt((y - x)^2) - L)\"\n[start]\nx = \"{} m\"\ny = \"{} m\"\n{}",
        draw.between(0.5, 2.0),
        draw.between(0.5, 2.0),
        draw.between(1.0, 10.0),
        draw.scale(1e3, 1e8),
        0.2,
        0.5 + 1e-4 * draw.between(-1.0, 1.0),
        run(draw.between(3.0, 10.0), "\"x\"")
    )
}

fn rubbing_motor(draw: &mut Numbers) -> String {
    format!(
        "title = \"rubbing\"\n[parameters]\nJ = \"0.01 kg m^2\"\nL = \"{} H\"\nF = \"{} N m\"\n[coordinates]\nphi = \"rad\"\nq = \"C\"\n\
         [energies]\nkinetic = \"J*phi'^2/2 + L*q'^2/2\"\n[[force]]\nalong = \"q\"\n\
         is = \"(12 V)*sin(t*({} rad/s)) - (1 ohm)*q' - (0.1 V s)*phi'\"\n[[force]]\nalong = \"phi\"\n\
         is = \"(0.1 V s)*q' - F*sign(phi')\"\n{}",
        draw.scale(1e-7, 1e-2),
        draw.scale(1e-9, 0.3),
        draw.between(1.0, 5.0),
        run(draw.between(2.0, 5.0), "\"phi\"")
    )
}
