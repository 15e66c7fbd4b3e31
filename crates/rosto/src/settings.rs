//! Text forms of edit settings, on the command line and in Python.

use rosto_studio::{AnchorKind, ConstraintKind};

use crate::Error;

/// Parses an anchor rule: `random`, with seed 0, `oval`, `pins`, or `outside:RADIUS` in the text's unit.
///
/// # Errors
/// [`Error::UnknownChoice`], or [`Error::Invalid`] for a radius that is negative or not finite.
pub fn anchor_rule(text: &str) -> Result<AnchorKind, Error> {
    match text.split_once(':') {
        None if text == "random" => Ok(AnchorKind::Random { seed: 0 }),
        None if text == "oval" => Ok(AnchorKind::Oval),
        None if text == "pins" => Ok(AnchorKind::PinsOnly),
        Some(("outside", radius)) => match radius.parse() {
            Ok(radius) if (0.0..f64::INFINITY).contains(&radius) => Ok(AnchorKind::Outside { radius }),
            _ => Err(Error::invalid("radius", radius, "a length of 0 or more")),
        },
        _ => Err(Error::unknown("anchors", text, &["random", "oval", "outside:RADIUS", "pins"])),
    }
}

/// Parses a constraint: `exact`, or the weight of a soft one.
///
/// # Errors
/// [`Error::Invalid`].
pub fn constraint(text: &str) -> Result<ConstraintKind, Error> {
    let weight: Option<f64> = text.parse().ok();
    match (text, weight) {
        ("exact", _) => Ok(ConstraintKind::Hard),
        (_, Some(weight)) if weight > 0.0 && weight.is_finite() => Ok(ConstraintKind::Soft { weight }),
        _ => Err(Error::invalid("constraint", text, "\"exact\" or a positive weight")),
    }
}

/// Parses the corners of a card in any order, in px of the upright photo: `10,20 95,20 95,74 10,74`.
///
/// # Errors
/// [`Error::Invalid`].
pub fn card_px(text: &str) -> Result<[[f64; 2]; 4], Error> {
    let number = |text: &str| text.parse::<f64>().ok().filter(|number| number.is_finite());
    let corner = |text: &str| text.split_once(',').and_then(|(x, y)| Some([number(x)?, number(y)?]));
    let corners: Option<Vec<[f64; 2]>> = text.split_whitespace().map(corner).collect();
    let corners = corners.and_then(|corners| corners.try_into().ok());
    corners.ok_or_else(|| Error::invalid("card-px", text, "four corners in px, such as 10,20 95,20 95,74 10,74"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn constraints_and_anchor_rules_parse() {
        assert_eq!(constraint("exact"), Ok(ConstraintKind::Hard));
        assert_eq!(constraint("2.5"), Ok(ConstraintKind::Soft { weight: 2.5 }));
        assert!(["0", "-1", "inf", "firm"].iter().all(|text| constraint(text).is_err()));
        assert_eq!(anchor_rule("outside:30"), Ok(AnchorKind::Outside { radius: 30.0 }));
        assert_eq!(anchor_rule("oval"), Ok(AnchorKind::Oval));
        assert!(["outside", "outside:nan", "outside:inf", "everything"].iter().all(|text| anchor_rule(text).is_err()));
    }
}
