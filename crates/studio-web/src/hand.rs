use glam::DVec3;
use rosto_face::{Language, Region, canonical_positions_m, mirror_of};
use rosto_studio::{FaceSlider, Subject};

use crate::names::landmark_label;

/// What a click or a drag takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum Hand {
    #[default]
    Landmark,
    Region,
}

/// What the visitor has chosen to move.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Selection {
    Landmark(u32),
    Region(Region),
}

/// An edit in progress.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) enum Moving {
    #[default]
    Nothing,
    /// What is selected, by an offset from where the last commit left it.
    Selection { offset_mm: DVec3 },
    /// A ready-made slider, by an amount from where the last commit left it.
    Slider { slider: FaceSlider, by_mm: f64 },
}

impl Selection {
    /// The landmarks that move together.
    pub fn handles(self) -> Vec<u32> {
        match self {
            Self::Landmark(landmark) => vec![landmark],
            Self::Region(region) => region.vertices(),
        }
    }

    /// The landmark that carries the gizmo and the name: that of a region is the one nearest to its middle.
    pub fn middle(self) -> u32 {
        match self {
            Self::Landmark(landmark) => landmark,
            Self::Region(region) => middle(region),
        }
    }

    pub fn subject(self) -> Subject {
        match self {
            Self::Landmark(landmark) => Subject::Landmark(landmark),
            Self::Region(region) => Subject::Region(region),
        }
    }
}

/// What the page calls a subject: landmarks bring their number along.
pub(crate) fn subject_label(subject: Subject, language: Language) -> String {
    match subject {
        Subject::Landmark(landmark) => landmark_label(landmark, language),
        other => other.name(language),
    }
}

/// Of a region that is its own mirror image, a landmark on the midline.
fn middle(region: Region) -> u32 {
    let is_whole = region.mirrored() == region;
    let vertices = region.vertices();
    let canonical_m = canonical_positions_m();
    let place = |vertex: u32| canonical_m[vertex as usize];
    let centre = vertices.iter().map(|&vertex| place(vertex)).sum::<DVec3>() / vertices.len() as f64;
    let distance = |vertex: &u32| place(*vertex).distance(centre);
    let candidates = vertices.iter().copied().filter(|&vertex| !is_whole || mirror_of(vertex) == vertex);
    candidates.min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middle_of_a_region_is_part_of_it_and_on_the_midline_where_the_region_is() {
        for region in Region::ALL {
            let middle = Selection::Region(region).middle();
            assert!(region.vertices().contains(&middle), "{region:?}");
            assert_eq!(mirror_of(middle) == middle, region.mirrored() == region, "{region:?}");
        }
    }
}
