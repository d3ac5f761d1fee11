//! Renamed coordinates: coordinates whose equations are unchanged except for the name.

use model::Model;

/// Pairs of old and new names.
pub(super) type Renamed = Vec<(String, String)>;

/// Removed coordinates paired with added ones, in their order; empty unless their numbers and dimensions agree.
pub(super) fn candidates([old, new]: [&Model; 2]) -> Renamed {
    let without = |these: &Model, those: &Model| {
        let is_new = |name: &String| those.coordinates.iter().all(|other| other.name != *name);
        let own = these.coordinates.iter().filter(|own| is_new(&own.name));
        own.map(|own| (own.name.clone(), own.dimension)).collect::<Vec<_>>()
    };
    let (gone, come) = (without(old, new), without(new, old));
    let is_alike = gone.len() == come.len() && gone.iter().zip(&come).all(|((_, a), (_, b))| a == b);
    if !is_alike {
        return Vec::new();
    }
    gone.into_iter().zip(come).map(|((old, _), (new, _))| (old, new)).collect()
}

/// A text in which old names, as whole words, are replaced by new ones.
pub(super) fn with_new_names(text: &str, renamed: &Renamed) -> String {
    let mut out = String::with_capacity(text.len());
    let mut word = String::new();
    for letter in text.chars().chain(['\0']) {
        if letter.is_alphanumeric() || letter == '_' {
            word.push(letter);
            continue;
        }
        let new = renamed.iter().find(|(old, _)| *old == word).map_or(&word, |(_, new)| new);
        out.push_str(new);
        word.clear();
        if letter != '\0' {
            out.push(letter);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::with_new_names;

    #[test]
    fn whole_words_are_renamed() {
        let renamed = vec![("x".to_owned(), "s".to_owned()), ("s".to_owned(), "x".to_owned())];
        assert_eq!(with_new_names("k*x - max*x'' + s", &renamed), "k*s - max*s'' + x");
    }
}
