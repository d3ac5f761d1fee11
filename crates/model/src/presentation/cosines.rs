//! Direction cosines of free frames, as letters: equations hold these, and not the quaternions that they are made of.

use crate::{Trace, Turn};
use symbolic::Sym;

const AXES: [&str; 3] = ["x", "y", "z"];

/// A direction cosine.
#[derive(Clone, Debug)]
pub struct Cosine {
    /// `F.Rxy`
    pub letter: Sym,
    /// The scalar product in the words of a model: `N.x . F.y`.
    pub meaning: String,
    /// The expression in the quaternion.
    pub value: Sym,
}

/// The direction cosines of every free frame.
pub(crate) fn cosines(trace: &Trace<'_>) -> Vec<Cosine> {
    let mut all = Vec::new();
    for frame in &trace.model.frames {
        let Some((parent, Turn::Free { number })) = frame.parent else { continue };
        let (name, parent) = (&frame.name, &trace.model.frames[parent.0].name);
        let latex = Sym::symbol(name).latex();
        for (row, of_parent) in trace.cosines[number].iter().zip(AXES) {
            for (&value, own) in row.iter().zip(AXES) {
                all.push(Cosine {
                    letter: Sym::named(
                        &format!("{name}.R{of_parent}{own}"),
                        &format!("R_{{{latex},{of_parent}{own}}}"),
                    ),
                    meaning: format!("{parent}.{of_parent} . {name}.{own}"),
                    value,
                });
            }
        }
    }
    all
}
