//! Files with certificates of verdicts, one for each paper, in a folder.

use crate::arguments::Format;
use crate::exit::Exit;
use crate::output::{Form, Maker, Writes};
use claims::certificate::{Certificate, CertificateFile, FORMAT};
use std::path::Path;

/// The folder of `--certificates`.
pub struct CertificateFolder<'a> {
    path: &'a Path,
    command: &'static str,
    force: bool,
}

impl<'a> CertificateFolder<'a> {
    /// The folder at a path; the command creates it where it is missing.
    ///
    /// # Errors
    /// The path exists and is not a folder.
    pub fn of(path: &'a Path, command: &'static str, force: bool) -> Result<Self, Exit> {
        if path.exists() && !path.is_dir() {
            return Err(Exit::refused(format!(
                "--certificates {}: this is a file; the name of a folder is accepted",
                path.display()
            )));
        }
        Ok(CertificateFolder { path, command, force })
    }

    /// Writes the certificates of a paper with its key, title and citation; writes nothing where there are no certificates.
    ///
    /// # Errors
    /// The file cannot be written, or has another origin.
    pub fn write(
        &self,
        [key, title, citation]: [&str; 3],
        claims: Vec<Certificate>,
        format: Format,
    ) -> Result<(), Exit> {
        if claims.is_empty() {
            return Ok(());
        }
        let writes = Writes { command: self.command, force: self.force, reads: Vec::new() };
        let output = writes.output(&self.path.join(format!("{key}.json")), &[Form::Certificates])?;
        let file = CertificateFile {
            made_by: Maker(self.command).generator(),
            format: FORMAT,
            paper: key.to_owned(),
            title: title.to_owned(),
            citation: citation.to_owned(),
            claims,
        };
        let text = serde_json::to_string(&file).map_err(Exit::refused)?;
        // the object stays open, since the seal is added as its last key
        output.write_text(text.strip_suffix('}').unwrap_or(&text))?.tell(format)
    }
}
