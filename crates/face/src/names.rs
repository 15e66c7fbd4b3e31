use crate::areas::Area;
use crate::mirror_of;

mod table;

/// The landmark's name for files and programs: anatomical where it has one, such as `left-mouth-corner`, else its part of
/// the face and its number, such as `left-cheek-425`. No two landmarks share a name; sides are the subject's.
///
/// # Panics
/// If `landmark` is not below [`LANDMARK_COUNT`](crate::LANDMARK_COUNT).
pub fn landmark_id(landmark: u32) -> String {
    match anatomical(landmark) {
        Some(noun) => beside(noun, landmark),
        None => format!("{}-{landmark}", part_id(landmark)),
    }
}

/// The part of the face that the landmark lies in, with its side, such as `left-cheek`.
///
/// # Panics
/// If `landmark` is not below [`LANDMARK_COUNT`](crate::LANDMARK_COUNT).
pub fn part_id(landmark: u32) -> String {
    beside(Area::of(landmark).id(), landmark)
}

fn anatomical(landmark: u32) -> Option<&'static str> {
    let right = landmark.min(mirror_of(landmark));
    table::ANATOMICAL.iter().find(|(of, _)| u32::from(*of) == right).map(|(_, noun)| *noun)
}

/// With the side that a landmark is on; none on the midline.
fn beside(noun: &str, landmark: u32) -> String {
    match landmark.cmp(&mirror_of(landmark)) {
        std::cmp::Ordering::Equal => noun.to_owned(),
        std::cmp::Ordering::Less => format!("right-{noun}"),
        std::cmp::Ordering::Greater => format!("left-{noun}"),
    }
}
