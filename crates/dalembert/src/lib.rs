//! Derives, proves and runs equations of motion of mechanical and electromechanical systems.
//!
//! # Overview
//! * [`model`]: a system as data, its kinematics, the principles, the equations of motion;
//! * [`scenes`]: runs of systems given by text; [`simulation`]: runs, references, work-precision charts, ensembles;
//! * [`motor`]: electric motors; [`claims`]: equations of papers with their verdicts; [`manuscript`]: a paper as a
//!   file, with formulas read from LaTeX ([`latex`]);
//! * [`symbolic`], [`field`], [`algebra`], [`mechanics`], [`integrators`], [`units`], [`reader`]: the underlying
//!   crates.
//!
//! For Rust programs that use the workbench as a library. The feature `commands` adds every command of the program
//! `dalembert`, also for the motors and papers of the program that links it. The feature `content` adds the systems,
//! motors, papers and studies of the workbench.
//!
//! ```
//! use dalembert::model::principles::Principle;
//! use dalembert::model::{BodySource, MatrixForm, Model, Source, Trace, text};
//!
//! // a mass on a spring: m x'' = -k x
//! let mut source = Source::default();
//! source.parameters = vec![("m", "kg").into(), ("k", "N/m").into()];
//! source.coordinates = vec![("x", "m").into()];
//! source.points = vec![("P", "O + x*N.x").into()];
//! source.bodies = vec![BodySource::particle("bob", "P", "m")];
//! source.energies = vec![("potential", "k*x^2/2").into()];
//! let model = Model::of(&source).expect("it is sound");
//! let trace = Trace::of(&model);
//! let form = MatrixForm::of(&trace, Principle::Lagrange)?;
//! let equations = text(&trace, &form.for_reading());
//! assert!(equations.contains("M[x, x] = m"), "{equations}");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#[cfg(feature = "commands")]
pub use commands;
pub use {
    algebra, claims, field, integrators, latex, manuscript, mechanics, model, motor, reader, scenes, simulation,
    symbolic, units,
};
#[cfg(feature = "content")]
pub use {machines, papers, studies, systems, theorems};
