//! Knowledge of systems beyond their equations, attached to scenes by the key `known_as`: closed forms, theory,
//! margins, reduced models.

pub mod crank_drive;
mod elastic_governor;
mod friction_governor;
pub mod governor_programme;
pub mod prescribed_top;
