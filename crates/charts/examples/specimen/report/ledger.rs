//! Three invented papers with seventy claims.

use dalembert_charts::{ClaimRow, PaperSection, Verdict};

pub fn papers() -> Vec<PaperSection> {
    let paper = |id: &str, title: &str, citation: &str, claims: usize, offset: usize| PaperSection {
        id: id.into(),
        title: title.into(),
        citation: citation.into(),
        summary:
            "Every numbered equation of the paper in its order. Letters are the paper's own; $\\Gamma = m g c$, and \
                  $\\mathbf{l}$ is the axis of the rotor."
                .into(),
        claims: (0..claims).map(|position| claim(id, position, position + offset)).collect(),
    };
    vec![
        paper("doe2031", "Doe & Roe 2031, heavy gyrostat with a motor", "Invented Mechanics 12 (2031) 1–20", 40, 0),
        paper("poe2032", "Poe 2032, programmed constraints", "Imaginary Control 3 (2032) 44–51", 18, 3),
        paper("loe2033", "Loe 2033, constraints with friction", "Notional Friction 7 (2033) 9–17", 12, 7),
    ]
}

fn claim(paper: &str, position: usize, kind: usize) -> ClaimRow {
    let (section, number) = (position / 6 + 2, position % 6 + 1);
    let mut row = KINDS[kind % KINDS.len()]();
    row.id = format!("{paper}/eq{section}.{number}/{}", slug(&row.title));
    row.equation_label = format!("({section}.{number})");
    row
}

fn slug(title: &str) -> String {
    let words = title.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| word.len() > 2);
    words.take(3).collect::<Vec<_>>().join("-").to_lowercase()
}

const KINDS: [fn() -> ClaimRow; 12] = [
    momentum,
    balance,
    kinematics,
    torque,
    elimination,
    stationary,
    angular_speed,
    surface,
    bound,
    constraint,
    cone,
    unset,
];

fn row(verdict: Verdict, title: &str, latex: &[&str], evidence: &str) -> ClaimRow {
    ClaimRow {
        title: title.into(),
        verdict,
        latex: latex.iter().map(|line| (*line).to_owned()).collect(),
        evidence: evidence.into(),
        ..Default::default()
    }
}

fn texts(items: &[&str]) -> Vec<String> {
    items.iter().map(|item| (*item).to_owned()).collect()
}

fn pairs(items: &[(&str, &str)]) -> Vec<(String, String)> {
    items.iter().map(|(name, value)| ((*name).to_owned(), (*value).to_owned())).collect()
}

fn momentum() -> ClaimRow {
    row(
        Verdict::Definition,
        "moment of momentum of the gyrostat",
        &[r"\mathbf{x} = \mathbf{A}^{*}\boldsymbol{\omega} + A'(\dot\gamma + \Omega)\,\mathbf{l}"],
        "",
    )
}

fn balance() -> ClaimRow {
    let latex = r"A_1\dot\omega_1 = (A_2 - A_3)\omega_2\omega_3 + A'(\omega_1 l_1 + \omega_2 l_2 + \omega_3 l_3 + \dot\gamma + \Omega)(l_2\omega_3 - l_3\omega_2) + \Gamma(e_2\nu_3 - e_3\nu_2) - l_1 M \quad (1\;2\;3)";
    ClaimRow {
        requires: texts(&["$|\\mathbf{l}| = 1$", "the axes are principal axes of $\\mathbf{A}$"]),
        ..row(
            Verdict::Proved,
            "balance of moments, first form",
            &[latex],
            "normal form of the difference is 0; three mutated right sides are refuted; dimensions agree",
        )
    }
}

fn kinematics() -> ClaimRow {
    row(
        Verdict::Proved,
        "Poisson's equations for the vertical",
        &[
            r"\dot\nu_1 = \omega_3\nu_2 - \omega_2\nu_3,\quad \dot\nu_2 = \omega_1\nu_3 - \omega_3\nu_1,\quad \dot\nu_3 = \omega_2\nu_1 - \omega_1\nu_2",
        ],
        "normal form of each difference is 0",
    )
}

fn torque() -> ClaimRow {
    let correction = ClaimRow {
        requires: texts(&["$0 \\le s \\le 1$", "$s_{\\mathrm{k}} \\ne 0$"]),
        ..row(
            Verdict::Proved,
            "",
            &[
                r"M(s) = \frac{2 M_{\mathrm{k}}}{\dfrac{s}{s_{\mathrm{k}}} + \dfrac{s_{\mathrm{k}}}{s}} \le M_{\mathrm{k}}",
            ],
            "normal form of $M_{\\mathrm{k}} - M$ is a square over a positive denominator",
        )
    };
    ClaimRow {
        difference: Some(r"M - M_{\mathrm{k}} = \frac{49}{60}".into()),
        counterexample: pairs(&[
            ("$s$", "1/5"),
            ("$s_{\\mathrm{k}}$", "1/4"),
            ("$M_{\\mathrm{k}}$", "7/3"),
            ("left", "63/20"),
            ("right", "7/3"),
        ]),
        correction: Some(Box::new(correction)),
        note: "The printed formula has the sum of the squares where Kloss' formula has the sum of the ratios.".into(),
        ..row(
            Verdict::Refuted,
            "the torque of the asynchronous motor is bounded by its pull-out torque",
            &[r"M(s) = \frac{2 M_{\mathrm{k}}}{s^2 + s_{\mathrm{k}}^2} \le M_{\mathrm{k}}"],
            "an exact point of the domain violates it; found in 41 trials",
        )
    }
}

fn elimination() -> ClaimRow {
    let long = r"A'\ddot\gamma\left(1 - \frac{A' l_1^2}{A_1^{*}} - \frac{A' l_2^2}{A_2^{*}} - \frac{A' l_3^2}{A_3^{*}}\right) = \frac{A_2^{*} - A_3^{*}}{A_1^{*}} A' l_1 \omega_2\omega_3 + \frac{A_3^{*} - A_1^{*}}{A_2^{*}} A' l_2 \omega_3\omega_1 + \frac{A_1^{*} - A_2^{*}}{A_3^{*}} A' l_3 \omega_1\omega_2 - A'^2(\dot\gamma + \Omega)\left[\frac{l_1(l_2\omega_3 - l_3\omega_2)}{A_1^{*}} + \frac{l_2(l_3\omega_1 - l_1\omega_3)}{A_2^{*}} + \frac{l_3(l_1\omega_2 - l_2\omega_1)}{A_3^{*}}\right] + M";
    ClaimRow {
        requires: texts(&[
            "$A_1^{*} \\ne 0$",
            "$A_2^{*} \\ne 0$",
            "$A_3^{*} \\ne 0$",
            "$D = 1 - \\sum_i A' l_i^2 / A_i^{*} \\ne 0$",
        ]),
        ..row(
            Verdict::Proved,
            "the rotor's equation after eliminating the carrier's accelerations",
            &[long],
            "normal form of the difference is 0 over $\\mathbb{Q}(A^{*}, A', l)[\\omega, \\nu, \\dot\\gamma]$, 1 284 terms before cancellation",
        )
    }
}

fn stationary() -> ClaimRow {
    row(
        Verdict::Tested,
        "one of the three conditions follows from the other two",
        &[
            r"(A_2^{*} - A_3^{*})\,{\omega^0}^2\nu_2^0\nu_3^0 + A'\Omega\,\omega^0(l_2\nu_3^0 - l_3\nu_2^0) + \Gamma(e_2\nu_3^0 - e_3\nu_2^0) = 0",
        ],
        "held at 200 exact points; not a proof",
    )
}

fn angular_speed() -> ClaimRow {
    let printed = r"\omega^0 = \frac{A'\Omega}{\Delta^{*}}\left[(A_2^{*} - A_3^{*})\nu_2^0\nu_3^0(l_2\nu_3^0 - l_3\nu_2^0) + (A_3^{*} - A_1^{*})\nu_3^0\nu_1^0(l_3\nu_1^0 - l_1\nu_3^0) + (A_1^{*} - A_2^{*})\nu_1^0\nu_2^0(l_1\nu_2^0 - l_2\nu_1^0)\right]";
    let names = [
        "$A_1^{*}$",
        "$A_2^{*}$",
        "$A_3^{*}$",
        "$A'$",
        "$\\Omega$",
        "$l_1$",
        "$l_2$",
        "$l_3$",
        "$\\nu_1^0$",
        "$\\nu_2^0$",
        "$\\nu_3^0$",
    ];
    let values = ["3", "2", "7/5", "1/4", "150", "1/3", "2/3", "2/3", "-1764/4225", "-3367/4225", "1836/4225"];
    ClaimRow {
        counterexample: names.into_iter().zip(values).map(|(n, v)| (n.to_owned(), v.to_owned())).collect(),
        difference: Some(r"\frac{-2\,118\,375\,040\,000\,000}{318\,644\,812\,890\,625}\,A'\Omega".into()),
        correction: Some(Box::new(ClaimRow {
            requires: texts(&["$\\Delta^{*}(\\nu^0) \\ne 0$"]),
            ..row(
                Verdict::Proved,
                "",
                &[&printed.replacen("= \\frac", "= -\\frac", 1)],
                "normal form of the difference is 0",
            )
        })),
        ..row(
            Verdict::Refuted,
            "angular speed of the permanent rotation, and $\\omega^0(-\\nu) = -\\omega^0(\\nu)$",
            &[printed],
            "exact counterexample; the sides differ by the sign",
        )
    }
}

fn surface() -> ClaimRow {
    row(
        Verdict::Undecided,
        "the surface is irreducible for almost all parameters",
        &[
            r"\left\{(\mathbf{e}\times\nu)\cdot\mathbf{A}\nu\right\}^2\cdot\Gamma + \left(A'\Omega\right)^2\,[\mathbf{l}\,\mathbf{e}\,\nu]\left\{[\mathbf{l}\,\mathbf{e}\,\nu]\,\nu\cdot\mathbf{A}\nu - \ldots\right\} = 0",
        ],
        "factorisation over $\\mathbb{Q}$ stopped after 60 s with 14 200 terms",
    )
}

fn bound() -> ClaimRow {
    row(
        Verdict::Enclosed,
        "the discriminant is positive on the stated box",
        &[
            r"\int_0^{2\pi}\! \sqrt{1 - k^2\sin^2\varphi}\,\mathrm{d}\varphi \ge 5 \quad\text{for } 0 \le k \le \tfrac12",
        ],
        "4 096 interval boxes, smallest lower bound 5.87",
    )
}

fn constraint() -> ClaimRow {
    row(
        Verdict::Undefined,
        "multiplier of the programmed constraint",
        &[
            r"\lambda = \left(\frac{\partial f}{\partial q}\mathbf{M}^{-1}\frac{\partial f}{\partial q}^{\!\top}\right)^{-1}\left(\ddot{y} - \frac{\partial f}{\partial q}\mathbf{M}^{-1}\mathbf{Q}\right),\qquad \mathbf{M} = \begin{pmatrix} m_1 + m_2 & m_2 l\cos\theta \\ m_2 l\cos\theta & m_2 l^2 \end{pmatrix}",
        ],
        "the Jacobian printed vanishes identically: $f$ does not depend on $q$",
    )
}

fn cone() -> ClaimRow {
    let terms: Vec<_> = (1..=14).map(|i| format!(r"a_{{{i}}}\nu_1^{{{}}}\nu_2^{{{}}}", 8 - i % 8, i % 8)).collect();
    row(
        Verdict::Open,
        "the cone of axes has degree 8",
        &[&format!(
            r"\begin{{cases}} {} = 0, & \Gamma \ne 0 \\ V^{{*}} = 0, & \Gamma = 0 \end{{cases}}",
            terms.join(" + ")
        )],
        "not attempted: the statement needs a definition of degree",
    )
}

fn unset() -> ClaimRow {
    row(
        Verdict::Tested,
        "friction at the contact, with $\\mu < 1$ & <script>alert(1)</script> as text",
        &[r"\dot q_{\mathrm{t}} \ne 0 \implies F = -\mu\,|N|\,\frac{\dot q_{\mathrm{t}}}{|\dot q_{\mathrm{t}}|}"],
        "held in 12 sampled runs",
    )
}
