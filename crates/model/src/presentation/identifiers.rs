//! Identifiers of symbols in a target language.

use symbolic::Sym;

/// Returns a distinct identifier for each symbol, different from all `words` of the language.
pub(super) fn identifiers(letters: &[Sym], words: &str) -> Vec<String> {
    let mut taken: Vec<String> = words.split_whitespace().map(str::to_owned).collect();
    let mut all = Vec::with_capacity(letters.len());
    for letter in letters {
        let mut name = letter.identifier().unwrap_or_else(|| "_".to_owned());
        while taken.contains(&name) {
            name.push('_');
        }
        taken.push(name.clone());
        all.push(name);
    }
    all
}
