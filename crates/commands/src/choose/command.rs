//! The command line `dalembert run ...` for the chosen model and method.

use simulation::{Axes, methods};
use std::path::Path;
use studies::model_reduction::Line;

/// The words of the command that runs a line of the receipt: its model unless it is the default, its method, its tolerance, and its form
/// where the scene has several. `None` for a line without a choice.
pub fn of(scene: &Path, model: Option<&str>, place: usize, line: &Line, formed: bool) -> Option<Vec<String>> {
    let plan = &line.choice.as_ref()?.plan;
    let mut words = vec!["run".to_owned(), scene.display().to_string()];
    let mut option = |name: &str, value: &str| words.extend([name.to_owned(), value.to_owned()]);
    let smaller = line.asked_as.as_deref().filter(|_| place > 0);
    let both = match (model, smaller) {
        // another model of the motor replaces the requested one; a reduction of the requested model is appended to its name
        (Some(model), Some(smaller)) if smaller.contains(' ') => Some(format!("{model}; {smaller}")),
        (model, smaller) => smaller.or(model).map(str::to_owned),
    };
    if let Some(model) = both {
        option("--model", &model);
    }
    option("--method", &methods::written(plan.method));
    option("--tol", &format!("{:e}", plan.tolerance));
    if formed && plan.axes != Axes::First {
        option("--form", &plan.axes.to_string());
    }
    Some(words)
}

/// The words as one line for a shell, quoted where necessary.
pub fn typed(words: &[String]) -> String {
    let plain = |word: &str| word.chars().all(|letter| letter.is_alphanumeric() || "-_./:=+,@".contains(letter));
    let word = |word: &String| match plain(word) && !word.is_empty() {
        true => word.clone(),
        false => format!("'{}'", word.replace('\'', r"'\''")),
    };
    std::iter::once("dalembert".to_owned()).chain(words.iter().map(word)).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::typed;

    #[test]
    fn a_path_with_spaces_and_quotation_marks_is_one_word_of_a_shell() {
        let words = ["run", "a b's.toml", "--tol", "1e-4"].map(str::to_owned);
        assert_eq!(typed(&words), r"dalembert run 'a b'\''s.toml' --tol 1e-4");
    }
}
