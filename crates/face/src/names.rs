use crate::areas::Area;
use crate::mirror_of;

mod table;

/// Identifier of a landmark: its anatomical name, such as `left-mouth-corner`, or its part and number, such as
/// `left-cheek-427`.
///
/// Identifiers are unique; sides are the subject's.
///
/// # Panics
/// If `landmark` is not below [`LANDMARK_COUNT`](crate::LANDMARK_COUNT).
pub fn landmark_id(landmark: u32) -> String {
    match anatomical(landmark) {
        Some(noun) => with_side(noun, landmark),
        None => format!("{}-{landmark}", part_id(landmark)),
    }
}

/// Identifier of the part of the face that contains a landmark, with its side, such as `left-cheek`.
///
/// # Panics
/// If `landmark` is not below [`LANDMARK_COUNT`](crate::LANDMARK_COUNT).
pub fn part_id(landmark: u32) -> String {
    with_side(Area::of(landmark).id(), landmark)
}

fn anatomical(landmark: u32) -> Option<&'static str> {
    let right = landmark.min(mirror_of(landmark));
    table::ANATOMICAL.iter().find(|(named, _)| u32::from(*named) == right).map(|(_, noun)| *noun)
}

/// Prefixes the side of a landmark; none on the midline.
fn with_side(noun: &str, landmark: u32) -> String {
    match landmark.cmp(&mirror_of(landmark)) {
        std::cmp::Ordering::Equal => noun.to_owned(),
        std::cmp::Ordering::Less => format!("right-{noun}"),
        std::cmp::Ordering::Greater => format!("left-{noun}"),
    }
}
