//! Names of letters as identifiers of a language.

use symbolic::Sym;

/// An identifier for each letter: none twice, none of a language's own words.
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
