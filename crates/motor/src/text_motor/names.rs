//! The names in expressions of a motor given by text: its parameters and currents.

use crate::text::{FIELD_SPEED, KnownMotion, Letters, is_taken};
use reader::{At, Bound, Issue, Quantity, Table};
use std::cell::RefCell;
use symbolic::Sym;
use units::Dimension;

/// The names of a file, including those whose faults were already reported.
#[derive(Default)]
pub struct Names {
    /// The parameters in the order of the file, after the frame speed.
    pub given: Vec<(Quantity, Dimension, f64)>,
    pub currents: Vec<String>,
    dimensions: Vec<(String, symbolic::Dimension)>,
    /// Names whose own entries are faulty and reported.
    broken: Vec<String>,
    /// Whether the table of parameters has a faulty name, which is reported.
    lost: bool,
    /// Unknown names that were already reported.
    told: RefCell<Vec<String>>,
}

impl Names {
    /// The names of a motor whose only parameter is the frame speed (rad/s).
    pub fn new(field_speed: f64) -> Self {
        let mut names = Names::default();
        names.add(FIELD_SPEED, Dimension::of(&FIELD_SPEED.unit), field_speed);
        names
    }

    fn add(&mut self, quantity: Quantity, dimension: Dimension, value: f64) {
        self.dimensions.push((quantity.name.to_string(), dimension.of_expressions()));
        self.given.push((quantity, dimension, value));
    }

    /// The symbols of an expression.
    pub fn letters(&self, motion: KnownMotion) -> Letters<'_> {
        Letters { parameters: &self.dimensions, currents: &self.currents, motion }
    }

    /// Whether an unknown name must be reported: once, and not if its own entry is faulty.
    pub fn is_news(&self, name: &str) -> bool {
        let known = self.lost || self.broken.iter().any(|broken| broken == name);
        let mut told = self.told.borrow_mut();
        if known || told.iter().any(|told| told == name) {
            return false;
        }
        told.push(name.to_owned());
        true
    }

    /// Whether the name is that of a parameter.
    pub fn is_parameter(&self, name: &str) -> bool {
        self.dimensions.iter().any(|(known, _)| known == name)
    }

    /// Records that the table of parameters has a faulty name.
    pub fn lose_parameters(&mut self) {
        self.lost = true;
    }

    /// Marks a faulty name and the valid names within it, as an expression would read them.
    fn break_name(&mut self, name: &str) {
        let parts = name.split(|letter: char| !(letter.is_alphanumeric() || letter == '_' || letter == '\''));
        self.broken.extend(parts.chain([name]).map(str::to_owned));
    }

    /// Reads the names of the currents; x, i1, i2, ... by default.
    pub fn read_currents(&mut self, windings: &mut [Table<'_>]) {
        for (k, table) in windings.iter_mut().enumerate() {
            let usual = if k == 0 { "x".to_owned() } else { format!("i{k}") };
            let given = table.optional_text("current", "name of the winding's current, as in \"id\"");
            let At { value, span } = given.unwrap_or_else(|| At { value: usual, span: table.span() });
            let wrong = match () {
                () if value.is_empty() => None,
                () if self.currents.contains(&value) => Some("another winding's current has this name"),
                () if is_taken(&value) || value == FIELD_SPEED.name => Some("this name has its meaning already"),
                () if ["angle", "slip", "rotor_speed"].contains(&&*value) => Some("a state has this name"),
                () if !is_name(&value) => Some("no name in an expression"),
                () => None,
            };
            if let Some(label) = wrong {
                self.break_name(&value);
                let issue = Issue::at(span, format!("`{value}` cannot name a current"), label);
                table.report(
                    issue.accepted("letters, digits and _ are accepted, a letter first, for each winding its own name"),
                );
            }
            self.currents.push(value);
        }
    }

    /// Reads the parameters of the file, of any dimension.
    pub fn read_parameters(&mut self, table: &mut Table<'_>) {
        for At { value: name, span } in table.keys() {
            let read = table.of_any_unit(&name);
            let wrong = match () {
                () if self.currents.contains(&name) => Some("a current has this name"),
                () if is_taken(&name) || name == FIELD_SPEED.name => Some("this name has its meaning already"),
                () if !is_name(&name) => Some("no name in an expression"),
                () => None,
            };
            match (wrong, read) {
                (Some(label), _) => {
                    self.break_name(&name);
                    let issue = Issue::at(span, format!("`{name}` cannot name a parameter"), label);
                    table.report(issue.accepted("letters, digits and _ are accepted, a letter first"));
                }
                (None, None) => self.break_name(&name),
                (None, Some(At { value: (value, dimension), .. })) => {
                    let (unit, meaning) = (dimension.coherent().into(), "parameter of the written motor".into());
                    let quantity = Quantity { name: name.into(), unit, meaning, bound: Bound::Any };
                    self.add(quantity, dimension, value);
                }
            }
        }
    }
}

/// Whether an expression reads the text as a single name.
fn is_name(text: &str) -> bool {
    symbolic::parse(text, &|name| Some(Sym::symbol(name))).ok().and_then(Sym::symbol_name).as_deref() == Some(text)
}
