use glam::DVec3;
use rosto_face::{Region, canonical_positions_m, mirror_of};
use rosto_studio::{EditTarget, Expression, FaceSlider};

rosto_mesh::named! {
    /// What a click or a drag selects.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum SelectionMode {
        /// One landmark.
        #[default]
        Landmark = "landmark",
        /// The region around it.
        Region = "region",
        /// Any vertex of the mesh that is shown: at 468, the landmarks.
        Point = "point",
    }
}

/// What the visitor has chosen to move.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Selection {
    /// One landmark.
    Landmark(u32),
    /// All landmarks of a region.
    Region(Region),
    /// A vertex of the mesh subdivided so often, once or more.
    Point {
        /// How often.
        level: u32,
        /// Which of its vertices.
        vertex: u32,
    },
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
    /// An expression, and its partner if both sides take part, by an amount from where the last commit left each.
    Expression { expression: (Expression, f64), partner: Option<(Expression, f64)> },
}

impl Selection {
    /// How often the mesh is subdivided that is moved; denser ones follow.
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

    /// The vertex that carries the gizmo and the name: that of a region is the landmark nearest to its middle.
    pub fn middle(self) -> u32 {
        match self {
            Self::Landmark(vertex) | Self::Point { vertex, .. } => vertex,
            Self::Region(region) => middle(region),
        }
    }

    /// What the history calls it.
    pub fn target(self) -> EditTarget {
        match self {
            Self::Landmark(landmark) => EditTarget::Landmark(landmark),
            Self::Region(region) => EditTarget::Region(region),
            Self::Point { level, vertex } => EditTarget::Point { level, vertex },
        }
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
