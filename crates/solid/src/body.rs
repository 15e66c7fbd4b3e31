use glam::DVec3;
use rosto_mesh::{Surface, Topology};

use crate::front::{Front, farthest};
use crate::{SolidError, flat, wall};

/// How an open surface is closed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Closing {
    /// Offsets a copy inward and joins the rims with a strip, as for a mask.
    Thickness {
        /// Wall thickness in metres; thinner where there is no room.
        thickness_m: f64,
    },
    /// Extends walls from the rim along −Z to a plane, as for a relief.
    FlatBack {
        /// Distance from the deepest point to the plane, in metres.
        thickness_m: f64,
    },
}

/// A closed body without self-intersections. Each edge has two triangles, counter-clockwise as seen from outside.
///
/// The surface's vertices come first, in their order, then those of the back. The surface's triangles come first too,
/// followed by those that fill its openings.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    topology: Topology,
    positions_m: Vec<DVec3>,
    front_vertices: usize,
    front_triangles: usize,
    thinnest_m: f64,
    moved_m: f64,
}

impl Body {
    /// Closes a connected surface, such as a face, with at least one rim.
    ///
    /// The longest rim is the rim of the front; the others are openings (eyes, mouth) and are filled with minimal area.
    /// Self-intersections of the surface are removed by smoothing ([`Self::moved_m`]). The wall is bent and thinned
    /// where it would intersect itself, as behind a sharp ridge ([`Self::thinnest_m`]).
    ///
    /// # Errors
    /// [`SolidError`] if the surface is not a disc with holes, its self-intersections cannot be removed, or the wall
    /// does not fit.
    pub fn closed(surface: Surface<'_>, closing: Closing) -> Result<Self, SolidError> {
        let (Closing::Thickness { thickness_m } | Closing::FlatBack { thickness_m }) = closing;
        check(thickness_m)?;
        let front = Front::new(surface)?;
        match closing {
            Closing::Thickness { .. } => Self::walled(front, thickness_m),
            Closing::FlatBack { .. } => Self::with_flat_back(front, thickness_m),
        }
    }

    fn walled(front: Front, thickness_m: f64) -> Result<Self, SolidError> {
        let back = wall::back(&front, thickness_m);
        let back = back.ok_or_else(|| SolidError::TooThick { thickness_m, most_m: thickest(&front, thickness_m) })?;
        Self::with_back(front, back)
    }

    /// Joins a front and its back.
    pub(crate) fn with_back(front: Front, back: wall::Back) -> Result<Self, SolidError> {
        let triangles = wall::joined(&front);
        Self::of(front, triangles, back.positions, back.thinnest)
    }

    /// Records the displacement from the original, unsmoothed surface.
    pub(crate) fn moved_from(self, surface: &[DVec3]) -> Self {
        Self { moved_m: farthest(surface, &self.positions_m), ..self }
    }

    fn with_flat_back(front: Front, thickness_m: f64) -> Result<Self, SolidError> {
        let back = flat::back(&front, thickness_m).ok_or(SolidError::NoFlatBack)?;
        let triangles = back.joined(&front);
        Self::of(front, triangles, back.positions, thickness_m)
    }

    fn of(front: Front, triangles: Vec<[u32; 3]>, back: Vec<DVec3>, thinnest_m: f64) -> Result<Self, SolidError> {
        let (front_vertices, front_triangles) = (front.positions.len(), front.topology.triangles().len());
        let positions_m = [front.positions, back].concat();
        let topology = Topology::new(positions_m.len(), triangles)?;
        Ok(Self { topology, positions_m, front_vertices, front_triangles, thinnest_m, moved_m: front.moved })
    }

    /// Triangles of the body.
    pub fn topology(&self) -> &Topology {
        &self.topology
    }

    /// Position of each vertex, in metres.
    pub fn positions_m(&self) -> &[DVec3] {
        &self.positions_m
    }

    /// Number of vertices of the surface, which come first.
    pub fn front_vertices(&self) -> usize {
        self.front_vertices
    }

    /// Number of triangles of the front, which come first.
    pub fn front_triangles(&self) -> usize {
        self.front_triangles
    }

    /// Smallest wall thickness in metres, measured along the normals at the front's vertices; for a flat back, that
    /// behind the deepest point. Between the vertices of a coarse mesh, the wall may be up to a quarter thinner.
    pub fn thinnest_m(&self) -> f64 {
        self.thinnest_m
    }

    /// Largest displacement of a surface vertex, in metres, by the removal of self-intersections or by smoothing; 0 if
    /// there was none.
    pub fn moved_m(&self) -> f64 {
        self.moved_m
    }

    /// Enclosed volume in m³: `Σ a·(b × c) / 6` over the triangles, by the divergence theorem.
    pub fn volume_m3(&self) -> f64 {
        // Relative to a vertex, so that the result does not lose precision far from the origin.
        let origin = self.positions_m[0];
        let part = |corners: &[u32; 3]| {
            let [a, b, c] = corners.map(|corner| self.positions_m[corner as usize] - origin);
            a.dot(b.cross(c))
        };
        self.topology.triangles().iter().map(part).sum::<f64>() / 6.0
    }

    /// Size of the bounding box, in metres.
    pub fn size_m(&self) -> DVec3 {
        let [low, high] = [DVec3::min, DVec3::max].map(|end| self.positions_m.iter().copied().reduce(end));
        high.unwrap_or_default() - low.unwrap_or_default()
    }

    /// Mass in g of a body of solid material with the given density in g/cm³ ([`PLA_G_PER_CM3`]). A print with sparse
    /// infill weighs less.
    pub fn mass_g(&self, density_g_per_cm3: f64) -> f64 {
        const CM3_PER_M3: f64 = 1e6;
        self.volume_m3() * CM3_PER_M3 * density_g_per_cm3
    }
}

/// Density of polylactide, a common material of 3D printers, in g/cm³.
pub const PLA_G_PER_CM3: f64 = 1.24;

/// Checks that the thickness is positive and finite.
pub(crate) fn check(thickness_m: f64) -> Result<(), SolidError> {
    match thickness_m > 0.0 && thickness_m.is_finite() {
        true => Ok(()),
        false => Err(SolidError::Thickness { thickness_m }),
    }
}

/// Largest thickness that works, found by halving and then bisection; 0 if none is found.
fn thickest(front: &Front, too_thick_m: f64) -> f64 {
    const HALVINGS: usize = 4;
    const BISECTIONS: usize = 2;
    let works = |thickness_m: &f64| wall::back(front, *thickness_m).is_some();
    let halves = (0..HALVINGS).scan(too_thick_m, |thickness_m, _| {
        *thickness_m /= 2.0;
        Some(*thickness_m)
    });
    let Some(found) = halves.into_iter().find(works) else { return 0.0 };
    let bisect = |[low, high]: [f64; 2], _| {
        let middle = low.midpoint(high);
        if works(&middle) { [middle, high] } else { [low, middle] }
    };
    (0..BISECTIONS).fold([found, 2.0 * found], bisect)[0]
}
