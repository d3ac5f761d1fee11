//! Exact stability at constant rotor speed of every axis of the cone with a given angular velocity.

use super::reduced::{Fate, Reduced};
use crate::stationary::energies::Energies;
use crate::stationary::motions::Case;
use algebra::real::Enclosure;
use field::Rational;
use nalgebra::Vector3;
use symbolic::{Formulas, Unbound, symbols};

/// The deciding quantities as formulas of (w0, v, W).
pub struct Fates(Formulas);

/// The precisions tried, bits; a quantity whose sign is then still unknown counts as zero.
const BITS: [usize; 3] = [64, 256, 1024];

impl Fates {
    /// The formulas for a gyrostat with constant relative speed of the rotor.
    ///
    /// # Errors
    /// [`Unbound`], which cannot occur: the formulas are sums, products and quotients.
    pub fn of(energies: &Energies<Rational>) -> Result<Self, Unbound> {
        let unknowns = symbols(["w0", "v1", "v2", "v3", "W"]);
        let [speed, v1, v2, v3, rotor_speed] = unknowns;
        let motion = Reduced::kept(&energies.written(), speed, Vector3::new(v1, v2, v3), rotor_speed);
        Formulas::of(&motion.deciding(), &unknowns).map(Fates)
    }

    /// All isolated directions with the angular velocity w (rad/s), each with its stability; empty where w is
    /// undefined.
    pub fn at(&self, case: &Case, w: f64) -> Vec<(Vector3<f64>, Fate)> {
        let speed = Rational::exactly(w);
        let Some(all) = case.body.rotations(speed) else { return Vec::new() };
        let isolated = all.motions.iter().take(all.isolated());
        let fate = |v: [Enclosure; 3], bits: usize| -> Option<Fate> {
            let [v1, v2, v3] = v;
            let place = [Enclosure::rational(speed, bits)?, v1, v2, v3, case.value.enclosure(bits)];
            let values = self.0.values(&place, &Enclosure::integer(1, bits))?;
            let signs: Vec<i32> = values.iter().map(Enclosure::sign).collect::<Option<_>>()?;
            Some(Fate::by_signs(signs.try_into().ok()?))
        };
        let each = isolated.filter_map(|motion| {
            let decided = BITS.iter().find_map(|&bits| fate(motion.direction(bits)?, bits));
            let v = motion.direction(64)?.each_ref().map(Enclosure::to_f64);
            Some((Vector3::from(v), decided.unwrap_or(Fate::Edge)))
        });
        each.collect()
    }
}
