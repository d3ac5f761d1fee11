//! A reader of scene files in TOML that knows the position of every value.
//!
//! The crate is for authors of file formats with units. In the example the misspelt key `mas` is an error.
//!
//! * [`Table`]: a table of the file. The program reads its entries with their units and bounds. A key that the program never reads is an error;
//! * [`Quantity`]: the name, unit, meaning and [`Bound`] of a datum; a file can extend the bound ([`Allowed`]);
//! * [`Issue`]: an error at a position, with the accepted input; [`SceneError`] shows all errors of a file;
//! * [`Family`]: built-in systems with a common reader, each selected by its name in the file.
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
/// Registers [`KnownSystems`].
pub use inventory::submit;
pub use issue::{Issue, SceneError};
pub use quantity::Quantity;
pub use table::{At, NO_MUTUAL_INDUCTANCE, Table, in_unit};
