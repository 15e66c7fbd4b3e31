use glam::DVec3;
use rosto_face::{Region, canonical_positions_m, mirror_of};
use rosto_studio::{EditTarget, Expression, FaceSlider};

use crate::ShapePart;

rosto_mesh::named! {
    /// Kind of selection made by a click or a drag.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum SelectionMode {
        /// The region around the landmark.
        #[default]
        Region = "region",
        /// One landmark.
        Landmark = "landmark",
        /// Any vertex of the displayed mesh; at density 0, the landmarks.
        Point = "point",
    }
}

/// The vertices that the user has selected to move.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Selection {
    /// One landmark.
    Landmark(u32),
    /// All landmarks of a region.
    Region(Region),
    /// A vertex of a denser mesh.
    Point {
        /// Subdivision level, from 1.
        level: u32,
        /// The vertex.
        vertex: u32,
    },
}

/// An edit in progress; amounts are relative to the last commit.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) enum Moving {
    #[default]
    Nothing,
    /// The selection, by an offset.
    Selection { offset_mm: DVec3 },
    /// A ready-made slider, by an amount.
    Slider { slider: FaceSlider, by_mm: f64 },
    /// An expression, and its partner if both sides take part, each with the change of its weight.
    Expression { expression: (Expression, f64), partner: Option<(Expression, f64)> },
}

impl Selection {
    /// Subdivision level of the mesh that is edited; denser ones follow.
    pub fn level(self) -> u32 {
        match self {
            Self::Landmark(_) | Self::Region(_) => 0,
            Self::Point { level, .. } => level,
        }
    }

    /// The vertices that move together.
    pub fn handles(self) -> Vec<u32> {
        match self {
            Self::Landmark(vertex) | Self::Point { vertex, .. } => vec![vertex],
            Self::Region(region) => region.vertices(),
        }
    }

    /// The vertex that carries the gizmo and the name; of a region, the landmark nearest to its centre.
    pub fn centre(self) -> u32 {
        match self {
            Self::Landmark(vertex) | Self::Point { vertex, .. } => vertex,
            Self::Region(region) => centre(region),
        }
    }

    /// The part of the face in which it lies.
    pub fn part(self) -> ShapePart {
        match self {
            Self::Region(region) => ShapePart::of(region),
            _ => Region::containing(self.centre()).first().map_or(ShapePart::Face, |region| ShapePart::of(*region)),
        }
    }

    /// How far its place differs between people, in mm.
    pub fn spread_mm(self) -> f64 {
        match self {
            Self::Region(region) => region.spread_mm(),
            Self::Landmark(_) | Self::Point { level: 0, .. } => spread_mm_at(self.centre()),
            Self::Point { .. } => SPREAD_MM,
        }
    }

    /// The target of edits of this selection.
    pub fn target(self) -> EditTarget {
        match self {
            Self::Landmark(landmark) => EditTarget::Landmark(landmark),
            Self::Region(region) => EditTarget::Region(region),
            Self::Point { level, vertex } => EditTarget::Point { level, vertex },
        }
    }
}

/// Spread of a point without a region.
const SPREAD_MM: f64 = 5.0;

/// Spread of the smallest region around a landmark.
fn spread_mm_at(landmark: u32) -> f64 {
    Region::containing(landmark).first().map_or(SPREAD_MM, |region| region.spread_mm())
}

/// The landmark nearest to a region's centre; on the midline if the region is symmetric.
fn centre(region: Region) -> u32 {
    let is_symmetric = region.mirrored() == region;
    let vertices = region.vertices();
    let canonical_m = canonical_positions_m();
    let position = |vertex: u32| canonical_m[vertex as usize];
    let centre = vertices.iter().map(|&vertex| position(vertex)).sum::<DVec3>() / vertices.len() as f64;
    let distance = |vertex: &u32| position(*vertex).distance(centre);
    let candidates = vertices.iter().copied().filter(|&vertex| !is_symmetric || mirror_of(vertex) == vertex);
    candidates.min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_centre_of_a_region_is_in_it_and_on_the_midline_of_symmetric_regions() {
        for region in Region::ALL {
            let centre = Selection::Region(region).centre();
            assert!(region.vertices().contains(&centre), "{region:?}");
            assert_eq!(mirror_of(centre) == centre, region.mirrored() == region, "{region:?}");
        }
    }
}
