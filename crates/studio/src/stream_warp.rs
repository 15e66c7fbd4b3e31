use glam::{DVec2, DVec3};
use rosto_warp::{Subject, Warp, WarpMesh};

use crate::StudioError;
use crate::fading::smooth_step;
use crate::photo_warp::{STIFF_STRIP, driving_vertices, longer_side};

/// Edits of a face applied to consecutive frames of a camera stream.
///
/// The warp is set up and factored once and then reused. A similarity moves it to the face's current position, and the
/// remaining motion (an expression, a small turn) drives it as edits drive a photo. The edits then move it further. It
/// is set up again only when the face has turned or changed a lot.
#[derive(Default)]
pub struct StreamWarp {
    layout: Option<Layout>,
    warp_mesh: WarpMesh,
    version: u32,
}

/// The warp for one frame. Its px are shifted by the frame's size, so that positions outside the frame are inside the
/// layout.
struct Layout {
    /// Vertices that drive the warp.
    vertices: Vec<u32>,
    from_px: Vec<DVec2>,
    longer_side_px: f64,
    warp: Warp,
    /// Parameters that it was built for.
    key: LayoutKey,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct LayoutKey {
    vertex_count: usize,
    falloff_band: f64,
}

/// Similarity from layout px to frame px: `frame = turn · layout + shift`, with rotation and scale as a complex number.
#[derive(Debug, Clone, Copy)]
struct Similarity {
    turn: DVec2,
    shift: DVec2,
}

/// The layout is rebuilt when the face has changed by more than this share of its longer side (root mean square).
const MAX_CHANGE: f64 = 0.03;

/// Distance from the frame's edge at which the warp begins to taper, as a share of the falloff band.
const TAPER: f64 = 0.25;

impl StreamWarp {
    /// Warps the next frame, of `size_px`, so that the vertices move from `places` (px, y down, and metres towards the
    /// camera) to `targets_px`. `falloff_band` is a share of the face's longer side. Costs two solves.
    /// The first frame, and each frame after a large change of the face, also needs a factorisation and calls
    /// `skin` for the triangles.
    ///
    /// # Errors
    /// [`StudioError::Warp`] if too little of the face is visible.
    ///
    /// # Panics
    /// If the numbers of targets and places differ.
    pub fn follow(
        &mut self,
        skin: impl FnOnce() -> Vec<[u32; 3]>,
        positions: &[DVec3],
        targets_px: &[DVec2],
        size_px: [u32; 2],
        falloff_band: f64,
    ) -> Result<(), StudioError> {
        assert_eq!(positions.len(), targets_px.len(), "one target for each place");
        let key = LayoutKey { vertex_count: positions.len(), falloff_band };
        let similarity =
            self.layout.as_ref().filter(|layout| layout.key == key).and_then(|layout| layout.similarity(positions));
        let similarity = match similarity {
            Some(similarity) => similarity,
            None => self.build_layout(&skin(), positions, size_px, key)?,
        };
        if let Some(layout) = &mut self.layout {
            layout.update(similarity, positions, targets_px, size_px, &mut self.warp_mesh);
        }
        Ok(())
    }

    /// Leaves a frame without a face unwarped.
    pub fn reset(&mut self) {
        self.warp_mesh.to_px.clone_from(&self.warp_mesh.from_px);
    }

    /// The moved part of the frame, in its px, and the version of the layout; the triangles change only with the
    /// version.
    pub fn warp_mesh(&self) -> (&WarpMesh, u32) {
        (&self.warp_mesh, self.version)
    }

    fn build_layout(
        &mut self,
        skin: &[[u32; 3]],
        positions: &[DVec3],
        size_px: [u32; 2],
        key: LayoutKey,
    ) -> Result<Similarity, StudioError> {
        let aside = DVec2::from(size_px.map(f64::from));
        let (vertices, mut from_px) = driving_vertices(skin, positions);
        from_px.iter_mut().for_each(|position| *position += aside);
        let longer_side_px = longer_side(&from_px);
        let size_px = size_px.map(|side| side.saturating_mul(3));
        let subject = Subject {
            size_px,
            points_px: &from_px,
            falloff_band_px: key.falloff_band * longer_side_px,
            stiff_strip_px: STIFF_STRIP * longer_side_px,
            protected: &[],
        };
        let warp = Warp::new(&subject)?;
        self.warp_mesh.triangles.clone_from(&warp.warp_mesh().triangles);
        self.layout = Some(Layout { vertices, from_px, longer_side_px, warp, key });
        self.version += 1;
        Ok(Similarity { turn: DVec2::X, shift: -aside })
    }
}

impl Layout {
    /// Least-squares similarity from the layout to the frame; `None` if the residual is too large.
    fn similarity(&self, positions: &[DVec3]) -> Option<Similarity> {
        let count = self.vertices.len() as f64;
        let seen = || self.vertices.iter().map(|&vertex| positions[vertex as usize].truncate());
        let (from_mean, to_mean) = (self.from_px.iter().sum::<DVec2>() / count, seen().sum::<DVec2>() / count);
        let (mut product, mut square) = (DVec2::ZERO, 0.0);
        for (from, to) in self.from_px.iter().zip(seen()) {
            let (from, to) = (*from - from_mean, to - to_mean);
            product += conjugate(from).rotate(to);
            square += from.length_squared();
        }
        let turn = product / square;
        let similarity = Similarity { turn, shift: to_mean - turn.rotate(from_mean) };
        let residuals = self.from_px.iter().zip(seen()).map(|(from, to)| similarity.invert(to).distance_squared(*from));
        let changed = (residuals.sum::<f64>() / count).sqrt() / self.longer_side_px;
        (changed < MAX_CHANGE).then_some(similarity)
    }

    fn update(
        &mut self,
        similarity: Similarity,
        positions: &[DVec3],
        targets_px: &[DVec2],
        size_px: [u32; 2],
        warp_mesh: &mut WarpMesh,
    ) {
        let at: Vec<DVec2> =
            self.vertices.iter().map(|&vertex| similarity.invert(positions[vertex as usize].truncate())).collect();
        let to: Vec<DVec2> =
            self.vertices.iter().map(|&vertex| similarity.invert(targets_px[vertex as usize])).collect();
        self.warp.carry(&self.from_px, &at);
        warp_mesh.from_px.clear();
        warp_mesh.from_px.extend(self.warp.warp_mesh().to_px.iter().map(|&position| similarity.apply(position)));
        // Only the edits are limited against folds; the frame already contains the face's own motion.
        self.warp.follow(&at, &to);
        let layout = self.warp.warp_mesh();
        let displacements =
            layout.to_px.iter().zip(&layout.from_px).map(|(to, from)| similarity.turn.rotate(*to - *from));
        warp_mesh.to_px.clear();
        warp_mesh.to_px.extend(displacements.zip(&warp_mesh.from_px).map(|(displacement, from)| *from + displacement));
        let taper_px = TAPER * self.key.falloff_band * self.longer_side_px * similarity.turn.length();
        fix_edges(warp_mesh, DVec2::from(size_px.map(f64::from)), taper_px);
    }
}

impl Similarity {
    fn apply(&self, position: DVec2) -> DVec2 {
        self.turn.rotate(position) + self.shift
    }

    fn invert(&self, position: DVec2) -> DVec2 {
        conjugate(self.turn).rotate(position - self.shift) / self.turn.length_squared()
    }
}

fn conjugate(number: DVec2) -> DVec2 {
    DVec2::new(number.x, -number.y)
}

/// Keeps the frame's edge in place and clamps vertices outside the frame to it.
fn fix_edges(warp_mesh: &mut WarpMesh, size_px: DVec2, taper_px: f64) {
    for (from, to) in warp_mesh.from_px.iter_mut().zip(&mut warp_mesh.to_px) {
        let displacement = (*to - *from) * smooth_step(from.min(size_px - *from).min_element() / taper_px);
        *from = from.clamp(DVec2::ZERO, size_px);
        *to = (*from + displacement).clamp(DVec2::ZERO, size_px);
    }
}
