//! Direction cosines of free frames, as symbols: equations contain these in place of quaternions.

use crate::{Trace, Turn};
use symbolic::Sym;

const AXES: [&str; 3] = ["x", "y", "z"];

/// A direction cosine of a free frame.
#[derive(Clone, Debug)]
pub struct Cosine {
    /// The symbol, such as `F.Rxy`.
    pub letter: Sym,
    /// The scalar product in the notation of a model: `N.x . F.y`.
    pub meaning: String,
    /// The expression in the components of the quaternion.
    pub value: Sym,
}

/// Returns the direction cosines of all free frames.
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
