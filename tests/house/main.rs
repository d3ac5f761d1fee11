//! The rules of the house, the list of broken laws, and the instructions for contributors.

mod circles;
mod contributing;
mod features;
mod licences;
mod links;
mod mutants;
mod rules;
