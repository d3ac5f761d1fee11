//! The rules of the repository, the list of mutants, and the instructions for contributors.

mod circles;
mod contributing;
mod drawing;
mod features;
mod licences;
mod links;
mod mutants;
mod rules;
