//! Scene files: TOML with the place of every value, read table by table.
//!
//! * [`Table`]: the entries of a table as they are asked for, each with its unit and its bound; keys that nobody asks for are
//!   errors;
//! * [`Quantity`]: a datum with its unit, its meaning and the values that it may have ([`Bound`], [`Allowed`]);
//! * [`Issue`]: an error at a place, and the input accepted there; [`SceneError`] shows all errors of a file;
//! * [`Family`]: systems that are read in one way, each by its name in the file.
//!
//! ```
//! use dalembert_reader::tables;
//!
//! let read = tables("spring.toml", "stiffness = \"2 kN/m\"\nmas = \"3 kg\"", |top, _issues| {
//!     Some(top.scalar("stiffness", "of the spring", "N/m").value)
//! });
//! // nobody asked for `mas`
//! assert!(read.is_err_and(|error| error.to_string().contains("mas")));
//! ```

mod bound;
mod file;
mod issue;
mod quantity;
mod table;

pub use bound::{Allowed, Bound};
pub use file::{Family, KnownSystems, MODEL, Opening, knows, parse, read_text, tables};
/// Brings [`KnownSystems`].
pub use inventory::submit;
pub use issue::{Issue, SceneError};
pub use quantity::Quantity;
pub use table::{At, NO_MUTUAL_INDUCTANCE, Table, in_unit};
