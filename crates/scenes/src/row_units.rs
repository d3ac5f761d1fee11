//! Units of the columns of a run.

/// The unit in which a run has a quantity that is written in another: m for mm, rad for deg.
pub(crate) fn coherent(unit: &str) -> String {
    match units::Unit::parse(unit) {
        Ok(parsed) if parsed.factors() == [1.0, 1.0] && unit != parsed.dimension().to_string() => unit.to_owned(),
        Ok(parsed) if parsed.dimension().is_number() && unit != "1" => "rad".to_owned(),
        Ok(parsed) => parsed.dimension().coherent(),
        Err(_) => unit.to_owned(),
    }
}

/// The unit of a rate: m/s, and m/s^2 of m/s.
pub(crate) fn rate_unit(unit: &str) -> String {
    let rate = format!("{unit}/s");
    match units::Unit::parse(&rate) {
        Ok(parsed) if unit.contains('/') => parsed.dimension().coherent(),
        _ => rate,
    }
}
