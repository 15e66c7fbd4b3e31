use glam::DVec3;
use rosto_mesh::{Surface, Topology};

use crate::front::{Front, farthest};
use crate::{SolidError, flat, wall};

/// How an open surface is closed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Closing {
    /// By a copy of it that lies so many metres further in, and a strip between their rims: a mask.
    Thickness {
        /// How thick the wall is, in metres, wherever it can be.
        thickness_m: f64,
    },
    /// By walls straight back, along −Z, to a plane so many metres behind its deepest point: a relief that stands by itself.
    FlatBack {
        /// How much there is behind the deepest point, in metres.
        thickness_m: f64,
    },
}

/// A closed body: every side has two triangles, which wind counter-clockwise as seen from outside, and no triangle goes
/// through another one.
///
/// The surface's vertices come first, in its order, and then those behind; its triangles come first, too, with what closes its
/// openings behind them.
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
    /// Closes a surface of one piece, such as a face, that has one rim or more. The longest stays the rim of the front; the
    /// others are openings (eyes, a mouth), and are closed by as little area as can be.
    ///
    /// A surface that goes through itself is smoothed there until it does not ([`Self::moved_m`]). A wall is bent and thinned
    /// where it would go through itself, as behind a sharp ridge ([`Self::thinnest_m`]).
    ///
    /// # Errors
    /// [`SolidError`] if the surface is not one, goes through itself beyond mending, or cannot have such a wall.
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

    /// With what lies behind the front.
    pub(crate) fn with_back(front: Front, back: wall::Back) -> Result<Self, SolidError> {
        let triangles = wall::joined(&front);
        Self::of(front, triangles, back.positions, back.thinnest)
    }

    /// The same, moved from where the surface was before it was softened.
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

    /// The triangles.
    pub fn topology(&self) -> &Topology {
        &self.topology
    }

    /// A position in metres for each vertex.
    pub fn positions_m(&self) -> &[DVec3] {
        &self.positions_m
    }

    /// How many vertices are the surface's own: the first ones.
    pub fn front_vertices(&self) -> usize {
        self.front_vertices
    }

    /// How many triangles are the front's: the first ones.
    pub fn front_triangles(&self) -> usize {
        self.front_triangles
    }

    /// How thick it is where its wall is thinnest, measured across the front at its vertices, in metres; behind the deepest
    /// point where the back is flat. Between the vertices of a coarse mesh it may be thinner by a quarter.
    pub fn thinnest_m(&self) -> f64 {
        self.thinnest_m
    }

    /// How far a vertex of the surface was moved at most, in metres, because the surface went through itself or was softened; 0
    /// where neither was needed.
    pub fn moved_m(&self) -> f64 {
        self.moved_m
    }

    /// What it encloses, in m³: `Σ a·(b × c) / 6` over its triangles, by the divergence theorem.
    pub fn volume_m3(&self) -> f64 {
        // Seen from a point of its own, however far away it lies.
        let origin = self.positions_m[0];
        let part = |corners: &[u32; 3]| {
            let [a, b, c] = corners.map(|corner| self.positions_m[corner as usize] - origin);
            a.dot(b.cross(c))
        };
        self.topology.triangles().iter().map(part).sum::<f64>() / 6.0
    }

    /// The sides of the box around it, in metres.
    pub fn size_m(&self) -> DVec3 {
        let [low, high] = [DVec3::min, DVec3::max].map(|end| self.positions_m.iter().copied().reduce(end));
        high.unwrap_or_default() - low.unwrap_or_default()
    }

    /// What it weighs in g when it is all of a material of that density in g/cm³ ([`PLA_G_PER_CM3`]); a print with a
    /// sparse filling weighs less.
    pub fn mass_g(&self, density_g_per_cm3: f64) -> f64 {
        const CM3_PER_M3: f64 = 1e6;
        self.volume_m3() * CM3_PER_M3 * density_g_per_cm3
    }
}

/// The density of polylactide, which most home printers melt, in g/cm³.
pub const PLA_G_PER_CM3: f64 = 1.24;

/// Whether it is a length above zero.
pub(crate) fn check(thickness_m: f64) -> Result<(), SolidError> {
    match thickness_m > 0.0 && thickness_m.is_finite() {
        true => Ok(()),
        false => Err(SolidError::Thickness { thickness_m }),
    }
}

/// The most that works below what does not, by halving, then between what works and what does not; 0 if nothing does.
fn thickest(front: &Front, too_thick_m: f64) -> f64 {
    const HALVINGS: usize = 4;
    const CLOSER: usize = 2;
    let works = |thickness_m: &f64| wall::back(front, *thickness_m).is_some();
    let halves = (0..HALVINGS).scan(too_thick_m, |thickness_m, _| {
        *thickness_m /= 2.0;
        Some(*thickness_m)
    });
    let Some(found) = halves.into_iter().find(works) else { return 0.0 };
    let closer = |[low, high]: [f64; 2], _| {
        let middle = low.midpoint(high);
        if works(&middle) { [middle, high] } else { [low, middle] }
    };
    (0..CLOSER).fold([found, 2.0 * found], closer)[0]
}
