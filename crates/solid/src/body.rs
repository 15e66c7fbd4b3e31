use std::f64::consts::FRAC_1_SQRT_2;

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
    thickness_m: Vec<f64>,
    /// Requested thickness of a wall; none for a flat back.
    wall_m: Option<f64>,
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
        Self::with_back(front, back, thickness_m)
    }

    /// Joins a front and its back.
    pub(crate) fn with_back(front: Front, back: wall::Back, wall_m: f64) -> Result<Self, SolidError> {
        let triangles = wall::joined(&front);
        Ok(Self { wall_m: Some(wall_m), ..Self::of(front, triangles, back.positions, back.thickness)? })
    }

    /// Records the displacement from the original, unsmoothed surface.
    pub(crate) fn moved_from(self, surface: &[DVec3]) -> Self {
        Self { moved_m: farthest(surface, &self.positions_m), ..self }
    }

    fn with_flat_back(front: Front, thickness_m: f64) -> Result<Self, SolidError> {
        let back = flat::back(&front, thickness_m).ok_or(SolidError::NoFlatBack)?;
        let triangles = back.joined(&front);
        let across_m = front.positions.iter().map(|position| position.z - back.plane).collect();
        Self::of(front, triangles, back.positions, across_m)
    }

    fn of(front: Front, triangles: Vec<[u32; 3]>, back: Vec<DVec3>, thickness_m: Vec<f64>) -> Result<Self, SolidError> {
        let (front_vertices, front_triangles) = (front.positions.len(), front.topology.triangles().len());
        let positions_m = [front.positions, back].concat();
        let topology = Topology::new(positions_m.len(), triangles)?;
        Ok(Self {
            topology,
            positions_m,
            front_vertices,
            front_triangles,
            thickness_m,
            wall_m: None,
            moved_m: front.moved,
        })
    }

    /// Replaces the front with a finer one of the same surface.
    pub(crate) fn with_front(
        &self,
        topology: Topology,
        positions_m: Vec<DVec3>,
        thickness_m: Vec<f64>,
        added_triangles: usize,
    ) -> Self {
        let front_triangles = self.front_triangles + added_triangles;
        Self { topology, positions_m, front_vertices: thickness_m.len(), front_triangles, thickness_m, ..*self }
    }

    /// Requested thickness of a wall, in metres; none for a flat back.
    pub(crate) fn wall_m(&self) -> Option<f64> {
        self.wall_m
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

    /// Thickness at each vertex of the front, in metres: along the normal for a wall, along Z for a flat back. Between
    /// the vertices of a coarse mesh, the wall may be up to a quarter thinner.
    pub fn thickness_m(&self) -> &[f64] {
        &self.thickness_m
    }

    /// Smallest of [`Self::thickness_m`].
    pub fn thinnest_m(&self) -> f64 {
        self.thickness_m.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// Share of the front's area, 0 to 1, where the wall is thinner than `least_m`. A triangle counts by its corners.
    pub fn thinner_share(&self, least_m: f64) -> f64 {
        let (mut thin_m2, mut all_m2) = (0.0, 0.0);
        for corners in &self.topology.triangles()[..self.front_triangles] {
            let thin = corners.iter().filter(|&&corner| self.thickness_m[corner as usize] < least_m).count();
            let area_m2 = self.normal_area_m2(corners).length();
            thin_m2 += area_m2 * thin as f64 / 3.0;
            all_m2 += area_m2;
        }
        thin_m2 / all_m2
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

    /// Area of the whole surface, in m².
    pub fn area_m2(&self) -> f64 {
        self.topology.triangles().iter().map(|corners| self.normal_area_m2(corners).length()).sum()
    }

    /// Area in m² that hangs over when the body is printed with this direction up: of triangles that face down at more
    /// than 45° and do not lie on the bed.
    pub fn overhang_m2(&self, up: DVec3) -> f64 {
        let up = up.normalize_or(DVec3::Z);
        let height = |corner: u32| self.positions_m[corner as usize].dot(up);
        let heights = self.positions_m.iter().map(|position| position.dot(up));
        let [low, high] = [f64::min, f64::max].map(|end| heights.clone().reduce(end).unwrap_or_default());
        let bed = low + ON_BED * (high - low);
        let hangs = |corners: &&[u32; 3]| corners.iter().any(|&corner| height(corner) > bed);
        let area_m2 = |corners: &[u32; 3]| {
            let normal = self.normal_area_m2(corners);
            let area_m2 = normal.length();
            if normal.dot(up) < -FRAC_1_SQRT_2 * area_m2 { area_m2 } else { 0.0 }
        };
        self.topology.triangles().iter().filter(hangs).map(area_m2).sum()
    }

    /// Mass in g of a print with usual settings: a shell of 1.2 mm and 15 % infill, in a material of the given density
    /// in g/cm³ ([`PLA_G_PER_CM3`]). The shell's volume is its area times its thickness, at most the whole volume.
    pub fn printed_mass_g(&self, density_g_per_cm3: f64) -> f64 {
        const CM3_PER_M3: f64 = 1e6;
        let volume_m3 = self.volume_m3();
        let shell_m3 = (self.area_m2() * SHELL_M).min(volume_m3);
        (shell_m3 + INFILL * (volume_m3 - shell_m3)) * CM3_PER_M3 * density_g_per_cm3
    }

    /// Normal of a triangle, as long as its area in m².
    fn normal_area_m2(&self, corners: &[u32; 3]) -> DVec3 {
        let [a, b, c] = corners.map(|corner| self.positions_m[corner as usize]);
        (b - a).cross(c - a) / 2.0
    }
}

/// Outer shell of a usual print, in metres: three lines of a 0.4-mm nozzle.
const SHELL_M: f64 = 0.001_2;

/// Usual density of the infill, relative to solid material.
const INFILL: f64 = 0.15;

/// Height up to which a triangle counts as lying on the bed, relative to the body's.
const ON_BED: f64 = 1e-6;

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
