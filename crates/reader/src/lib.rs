//! A reader of scene files in TOML that knows the place of every value.
//!
//! For authors of file formats with units. In the example the misspelt key `mas` is an error.
//!
//! * [`Table`]: a table, from which a program asks for entries with their units and bounds; a key that is never asked for is an
//!   error;
//! * [`Quantity`]: a datum with its unit, its meaning and the values that it may have ([`Bound`], [`Allowed`]);
//! * [`Issue`]: an error at a place, and the input accepted there; [`SceneError`] shows all errors of a file;
//! * [`Family`]: systems with a common reader, each selected by its name in the file.
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
