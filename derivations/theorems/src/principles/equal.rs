//! The claims that all principles give equal accelerations for one system.

use claims::{Condition, Page};
use mechanics::constrained::classify::{Class, Unclassified, classify};
use mechanics::constrained::motion::Motion;
use mechanics::constrained::multipliers::{Reaction, multipliers};
use mechanics::constrained::newton::{Reactions, newton};
use mechanics::constrained::redundant::{Redundant, Split, accelerations};
use mechanics::constrained::{Charted, Constrained, appell, gauss, kinetic_energy, quasi, rates, second_kind};
use symbolic::Sym;

use Condition::{Equal, Zero};

/// A system at a general instant.
pub struct Case<Q, const N: usize, const C: usize, const K: usize, const R: usize> {
    /// The name of the entry in the page.
    pub entry: &'static str,
    /// The name as used in a sentence.
    pub name: &'static str,
    pub system: Q,
    /// The time, the chart's coordinates and its velocities (t, q, p).
    pub at: (Sym, [Sym; K], [Sym; R]),
    /// For each constraint, the index of the coordinate that it determines.
    pub dependent: [usize; C],
    /// The coefficients mu of the friction in the notation of the extended method: R^tau_i = sum mu_j m_i dx'_i/dp_j.
    pub friction: [Sym; R],
    /// Variations of the free accelerations.
    pub variations: [Sym; R],
}

impl<Q, const N: usize, const C: usize, const K: usize, const R: usize> Case<Q, N, C, K, R>
where
    Q: Charted<N, K, R, Given = Sym> + Constrained<N, C> + Reactions<N, C>,
{
    /// The motion of the system at the instant.
    pub fn motion(&self) -> Motion<Sym, N, R> {
        let (time, q, p) = self.at;
        Motion::at(&self.system, time, q, p)
    }

    /// The class of the constraints by Frobenius' theorem.
    ///
    /// # Errors
    /// [`Unclassified`] if the prover reaches no result.
    pub fn class(&self) -> Result<Class, Unclassified> {
        classify(&self.system, self.at.0, self.motion().state.place)
    }

    /// The accelerations by Lagrange's multipliers, under the given forces and additional ones. They are undefined if
    /// the equations cannot be solved; the claims about them then fail.
    pub fn by_multipliers(&self, others: [Sym; N]) -> Reaction<Sym, N, C> {
        let state = self.motion().state;
        let given: [Sym; N] = self.system.force(&state);
        let force = std::array::from_fn(|i| given[i] + others[i]);
        let undefined = Reaction { acceleration: [Sym::UNDEFINED; N], multipliers: [Sym::UNDEFINED; C] };
        multipliers(&self.system, &state, force).unwrap_or(undefined)
    }

    /// The claim that the chart satisfies the constraints.
    pub fn chart(&self, page: &mut Page) {
        let state = self.motion().state;
        let values = self.system.constraints(&state).map(|constraint| constraint.value());
        let first = rates::first_rates(&self.system, &state);
        page.claim(
            self.entry,
            "chart",
            format!("The coordinates and quasi-velocities of {} keep every constraint", self.name),
        )
        .in_words()
        .follows(values.into_iter().chain(first).map(Zero));
    }

    /// The claims that each principle which uses the chart or the reactions gives the same accelerations as Lagrange's
    /// multipliers.
    pub fn claims(&self, page: &mut Page) {
        let motion = self.motion();
        let force = self.system.force(&motion.state);
        let expected = self.by_multipliers([Sym::ZERO; N]).acceleration;
        let same = |found: [Sym; N]| (0..N).map(move |i| Equal(found[i], expected[i]));
        let moved = |rates: Option<[Sym; R]>| motion.acceleration(rates.unwrap_or([Sym::UNDEFINED; R]));
        let name = self.name;
        let pushed = newton(&self.system, &motion.state, force).map(|pushed| pushed.acceleration);
        page.claim(self.entry, "newton", format!("For {name}, Newton's equations, with each reaction acting where the body is touched, give the accelerations of Lagrange's equations with multipliers"))
            .in_words()
            .follows(same(pushed.unwrap_or([Sym::UNDEFINED; N])));
        page.claim(
            self.entry,
            "lagrange",
            format!(
                "For {name}, Lagrange's equations of the second kind (Maggi's, where a kinematic constraint is left) give the accelerations of Lagrange's equations with multipliers"
            ),
        )
        .in_words()
        .follows(same(moved(second_kind::rates(&self.system, self.at, force).ok())));
        page.claim(self.entry, "appell", format!(r"For {name}, Appell's equations, $\partial S'/\partial\dot p_j = Q'_j$, give the accelerations of Lagrange's equations with multipliers"))
            .in_words()
            .follows(same(moved(appell::rates(&self.system, &motion, force).ok())));
        self.combining(page, &motion);
    }

    /// The claims that the extended friction has no component along the constraints: the products of rows and fields
    /// are zero, and the multipliers do not change.
    fn combining(&self, page: &mut Page, motion: &Motion<Sym, N, R>) {
        let masses: [Sym; N] = self.system.masses();
        let friction = std::array::from_fn(|i| {
            (0..R).fold(Sym::ZERO, |sum, j| sum + self.friction[j] * masses[i] * motion.fields[j][i])
        });
        let (with, without) = (self.by_multipliers(friction), self.by_multipliers([Sym::ZERO; N]));
        page.claim(self.entry, "friction", format!(r"With the friction $R^\tau = \sum\mu_j\,m\,\partial\dot x/\partial p_j$, {} has the multipliers of the system without friction", self.name))
            .in_words()
            .follows((0..C).map(|k| Equal(with.multipliers[k], without.multipliers[k])));
    }

    /// Gauss' principle: the minimum over the admissible accelerations, with a proof that it is a minimum.
    pub fn gauss(&self, page: &mut Page) {
        let state = self.motion().state;
        let (masses, force) = (self.system.masses(), self.system.force(&state));
        let expected = self.by_multipliers([Sym::ZERO; N]).acceleration;
        let admissible =
            Split::<N, C, R>::new(self.dependent).and_then(|split| accelerations(&self.system, &split, &state).ok());
        let least = admissible.and_then(|admissible| gauss::least(masses, force, &admissible).ok());
        page.claim(self.entry, "gauss", format!("For {}, the stationary point of $Z = \\frac12\\sum m(\\ddot x - X/m)^2$ over the accelerations that the constraints admit (Gauss) is the acceleration given by Lagrange's equations with multipliers", self.name))
            .in_words()
            .follows((0..N).map(|i| Equal(least.unwrap_or([Sym::UNDEFINED; N])[i], expected[i])));
        let directions = admissible.map_or([[Sym::UNDEFINED; N]; R], |admissible| admissible.directions);
        let varied: [Sym; N] =
            std::array::from_fn(|i| (0..R).fold(Sym::ZERO, |sum, j| sum + self.variations[j] * directions[j][i]));
        let moved = std::array::from_fn(|i| expected[i] + varied[i]);
        let more = gauss::constraint(masses, force, moved) - gauss::constraint(masses, force, expected);
        page.claim(self.entry, "least", format!(r"For {}, the acceleration given by Lagrange's equations with multipliers is the minimum of $Z$ (Gauss): $Z(\ddot x+\delta)-Z(\ddot x) = \frac12\sum m\,\delta^2$ for every admissible $\delta$", self.name))
            .in_words()
            .follows([Equal(more, kinetic_energy(masses, varied))]);
    }

    /// Ideal scleronomic constraints do no work: the power of the forces equals the rate of the kinetic energy.
    pub fn energy(&self, page: &mut Page) {
        let state = self.motion().state;
        let (masses, force): ([Sym; N], [Sym; N]) = (self.system.masses(), self.system.force(&state));
        let acceleration = self.by_multipliers([Sym::ZERO; N]).acceleration;
        let power = (0..N).fold(Sym::ZERO, |sum, i| sum + (masses[i] * acceleration[i] - force[i]) * state.velocity[i]);
        page.claim(
            self.entry,
            "energy",
            format!("For {}, the reactions of Lagrange's multipliers do no work", self.name),
        )
        .in_words()
        .follows([Zero(power)]);
    }

    /// Shulgin's equations in redundant coordinates, with the missing term restored.
    pub fn shulgin(&self, page: &mut Page) {
        let motion = self.motion();
        let state = motion.state;
        let expected = self.by_multipliers([Sym::ZERO; N]).acceleration;
        let found = Split::<N, C, R>::new(self.dependent)
            .and_then(|split| Redundant::about(&self.system, split, state.time, state.place).ok())
            .and_then(|redundant| {
                let at = (state.time, state.place, redundant.free(state.velocity));
                let force = self.system.force(&state);
                let rates = quasi::rates(&redundant, at, force).ok()?;
                Some(Motion::at(&redundant, at.0, at.1, at.2).acceleration(rates))
            });
        page.claim(
            self.entry,
            "shulgin",
            format!(
                "For {}, Shulgin's equations in redundant coordinates, with the term that they lose added again, give the accelerations of Lagrange's equations with multipliers",
                self.name
            ),
        )
        .in_words()
        .follows((0..N).map(|i| Equal(found.unwrap_or([Sym::UNDEFINED; N])[i], expected[i])));
    }
}
