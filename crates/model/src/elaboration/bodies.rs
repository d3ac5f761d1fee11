//! Bodies: first their motion; masses and moments of inertia after all names are known.

use super::{Elaborator, Sound};
use crate::{Body, BodyId, BodySource, Fault, FrameId, Inertia, InertiaSource, Text, Turn};
use symbolic::Dimension;

impl Elaborator<'_> {
    /// Adds a body with its frame and its centre of mass.
    pub(super) fn moved(&mut self, body: &BodySource) -> Sound<BodyId> {
        let frame = match (&body.turns, &body.frame) {
            (Some(turns), Some(_)) => {
                let title = format!("`turns` and `frame` both say how `{}` turns", body.name.text);
                return Err(Box::new(Fault::at(turns.span(), title, "twice", "one of them")));
            }
            (Some(turns), None) => {
                let angle = self.scalar_value(turns, "the angle of a turn", Some(Dimension::none()))?;
                self.judge_angle_text(turns);
                Some(self.new_frame(&body.name.text, FrameId::GROUND, Turn::About { axis: 2, angle }))
            }
            (None, Some(frame)) => Some(self.frame(frame)?),
            (None, None) => None,
        };
        let centre = match &body.centre {
            Some(centre) => Some(self.point(centre)?),
            None => None,
        };
        let (name, at) = (body.name.text.clone(), body.name.span());
        let first = match &body.inertia {
            Some(InertiaSource::Axial(axial)) => Some(axial),
            Some(InertiaSource::Tensor { entries, .. }) => entries.iter().flatten().next(),
            None => None,
        };
        let place = |text: Option<&Text>| text.map_or_else(|| at.clone(), Text::span);
        let (mass_at, inertia_at) = (place(body.mass.as_ref()), place(first));
        self.model.bodies.push(Body { name, frame, centre, mass: None, inertia: None, mass_at, inertia_at, at });
        Ok(BodyId(self.model.bodies.len() - 1))
    }

    /// Reads the masses and moments of inertia, after all names are known.
    pub(super) fn bodies(&mut self) {
        for body in &self.source.bodies {
            let of_inertia: Vec<&Text> = match &body.inertia {
                None => Vec::new(),
                Some(InertiaSource::Axial(axial)) => vec![axial],
                Some(InertiaSource::Tensor { entries, .. }) => entries.iter().flatten().collect(),
            };
            let texts = body.mass.iter().chain(of_inertia);
            let Some(place) = self.model.bodies.iter().position(|known| known.name == body.name.text) else {
                // the fault in its motion is already reported
                let missing: Sound<()> = Err(Box::new(Fault::consequence(body.name.span())));
                let _ = self.beside(missing, texts);
                continue;
            };
            let found = self.weighed(body);
            let found = self.beside(found, texts);
            if let Some((mass, inertia)) = self.kept(found) {
                (self.model.bodies[place].mass, self.model.bodies[place].inertia) = (mass, inertia);
            }
        }
        let has_energy = !self.source.energies.is_empty();
        let turns_a_rotor =
            self.source.drives.iter().any(|drive| drive.inertia.is_some() || !drive.windings.is_empty());
        if self.source.bodies.is_empty() && !has_energy && !turns_a_rotor {
            let accepted = "[bodies.NAME] with `mass` and `centre`, [energies], or a drive with an inertia";
            self.faults.push(Fault::at(
                0..0,
                "the system has no bodies and no energies",
                "nothing has inertia",
                accepted,
            ));
        }
    }

    fn weighed(&mut self, body: &BodySource) -> Sound<(Option<crate::ScalarId>, Option<Inertia>)> {
        let name = &body.name.text;
        let mass = match &body.mass {
            Some(mass) => Some(self.scalar_value(mass, "the mass", Some(Dimension::mass()))?),
            None => None,
        };
        let fault =
            |title: String, accepted: &str| Err(Box::new(Fault::at(body.name.span(), title, "this body", accepted)));
        if mass.is_some() && body.centre.is_none() {
            return fault(
                format!("the body `{name}` has a mass and no centre"),
                "`centre`, the point where its mass may stand",
            );
        }
        if mass.is_none() && body.inertia.is_none() {
            return fault(
                format!("the body `{name}` has no mass and no inertia"),
                "`mass` with `centre`, or `inertia`",
            );
        }
        let frame = self.model.bodies.iter().find(|known| known.name == *name).and_then(|known| known.frame);
        let needed = Some(Dimension::mass() * Dimension::length().power(field::Rational::new(2, 1)));
        let inertia = match (&body.inertia, frame) {
            (None, _) => None,
            (Some(_), None) => {
                return fault(format!("the body `{name}` has an inertia and does not turn"), "`frame` or `turns`");
            }
            (Some(InertiaSource::Axial(axial)), Some(_)) => {
                Some(Inertia::Axial(self.scalar_value(axial, "the moment of inertia", needed)?))
            }
            (Some(InertiaSource::Tensor { axes, entries }), Some(frame)) => {
                let axes = match axes {
                    Some(axes) => self.frame(axes)?,
                    None => frame,
                };
                let mut found = [None; 6];
                for (found, entry) in found.iter_mut().zip(entries.iter()) {
                    if let Some(entry) = entry {
                        *found = Some(self.scalar_value(entry, "a moment of inertia", needed)?);
                    }
                }
                Some(Inertia::Tensor { axes, entries: found })
            }
        };
        Ok((mass, inertia))
    }
}
