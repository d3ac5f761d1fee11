//! Facts about systems beyond their equations, attached to scenes by the key `known_as`: closed forms, theory, ends, smaller models.

pub mod crank_drive;
mod elastic_governor;
mod friction_governor;
pub mod governor_programme;
pub mod prescribed_top;
