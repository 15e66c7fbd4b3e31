use glam::{DVec2, DVec3};
use rosto_warp::{Subject, Warp, WarpMesh};

use crate::StudioError;
use crate::fading::smooth_step;
use crate::in_photo::{leading, longer_side};

/// The edits of a face in the frames of a camera stream, one after the other.
///
/// What gives way is laid out and factored once, and then carried along: a similarity takes the face to where it is, and what is
/// left of its motion (an expression, a small turn) leads the layout as edits lead a photo. From there the edits lead it further.
/// Only a face that has turned or changed a lot is laid out anew.
#[derive(Default)]
pub struct StreamWarp {
    laid: Option<Laid>,
    warp_mesh: WarpMesh,
    version: u32,
}

/// The layout, in px of the frame that it was made for, moved by its size: what leaves the frame is in it all the same.
struct Laid {
    /// Vertices of the mesh that lead.
    vertices: Vec<u32>,
    from_px: Vec<DVec2>,
    longer_side_px: f64,
    warp: Warp,
    /// What it was made for.
    of: Of,
}

#[derive(Debug, Clone, Copy, PartialEq)]
struct Of {
    vertex_count: usize,
    falloff_band: f64,
}

/// From px of the layout to px of a frame: `frame = turn · layout + shift`, the turn and the scale a complex number.
#[derive(Debug, Clone, Copy)]
struct Carried {
    turn: DVec2,
    shift: DVec2,
}

/// The layout is made anew when the face has changed by more than this share of its longer side (root of the mean square).
const MOST_CHANGED: f64 = 0.03;

/// So near to the frame's edge, in shares of the falloff band, what gives way begins to do so less.
const TAPER: f64 = 0.25;

impl StreamWarp {
    /// Lets the next frame, of `size_px`, follow vertices that it shows at `places` (px, y down, and metres towards the camera) to
    /// their targets, in px. Around them it gives way by `falloff band`, a share of the face's longer side. Two back-substitutions for each
    /// axis; the first time, and when the face has changed a lot, a factorisation, for which the triangles of its skin are asked
    /// for.
    ///
    /// # Errors
    /// [`StudioError::Warp`] where too little of the face is seen.
    ///
    /// # Panics
    /// If there is not one target for each place.
    pub fn follow(
        &mut self,
        skin: impl FnOnce() -> Vec<[u32; 3]>,
        places: &[DVec3],
        targets_px: &[DVec2],
        size_px: [u32; 2],
        falloff_band: f64,
    ) -> Result<(), StudioError> {
        assert_eq!(places.len(), targets_px.len(), "one target for each place");
        let of = Of { vertex_count: places.len(), falloff_band };
        let carried = self.laid.as_ref().filter(|laid| laid.of == of).and_then(|laid| laid.carried(places));
        let carried = match carried {
            Some(carried) => carried,
            None => self.lay(&skin(), places, size_px, of)?,
        };
        if let Some(laid) = &mut self.laid {
            laid.draw(carried, places, targets_px, size_px, &mut self.warp_mesh);
        }
        Ok(())
    }

    /// The frame has no face, and stays as it is.
    pub fn rest(&mut self) {
        self.warp_mesh.to_px.clone_from(&self.warp_mesh.from_px);
    }

    /// What of the frame moves, in its px, and the number of the layout: as long as that is the same, so are the triangles.
    pub fn warp_mesh(&self) -> (&WarpMesh, u32) {
        (&self.warp_mesh, self.version)
    }

    fn lay(&mut self, skin: &[[u32; 3]], places: &[DVec3], size_px: [u32; 2], of: Of) -> Result<Carried, StudioError> {
        let aside = DVec2::from(size_px.map(f64::from));
        let (vertices, mut from_px) = leading(skin, places);
        from_px.iter_mut().for_each(|place| *place += aside);
        let longer_side_px = longer_side(&from_px);
        let size_px = size_px.map(|side| side.saturating_mul(3));
        let subject =
            Subject { size_px, points_px: &from_px, falloff_band_px: of.falloff_band * longer_side_px, kept: &[] };
        let warp = Warp::new(&subject)?;
        self.warp_mesh.triangles.clone_from(&warp.warp_mesh().triangles);
        self.laid = Some(Laid { vertices, from_px, longer_side_px, warp, of });
        self.version += 1;
        Ok(Carried { turn: DVec2::X, shift: -aside })
    }
}

impl Laid {
    /// What takes the layout to the frame, by least squares; none if too much would be left.
    fn carried(&self, places: &[DVec3]) -> Option<Carried> {
        let count = self.vertices.len() as f64;
        let seen = || self.vertices.iter().map(|&vertex| places[vertex as usize].truncate());
        let (from_mean, to_mean) = (self.from_px.iter().sum::<DVec2>() / count, seen().sum::<DVec2>() / count);
        let (mut product, mut square) = (DVec2::ZERO, 0.0);
        for (from, to) in self.from_px.iter().zip(seen()) {
            let (from, to) = (*from - from_mean, to - to_mean);
            product += conjugate(from).rotate(to);
            square += from.length_squared();
        }
        let turn = product / square;
        let carried = Carried { turn, shift: to_mean - turn.rotate(from_mean) };
        let left = self.from_px.iter().zip(seen()).map(|(from, to)| carried.back(to).distance_squared(*from));
        let changed = (left.sum::<f64>() / count).sqrt() / self.longer_side_px;
        (changed < MOST_CHANGED).then_some(carried)
    }

    fn draw(
        &mut self,
        carried: Carried,
        places: &[DVec3],
        targets_px: &[DVec2],
        size_px: [u32; 2],
        warp_mesh: &mut WarpMesh,
    ) {
        let at: Vec<DVec2> =
            self.vertices.iter().map(|&vertex| carried.back(places[vertex as usize].truncate())).collect();
        let to: Vec<DVec2> = self.vertices.iter().map(|&vertex| carried.back(targets_px[vertex as usize])).collect();
        self.warp.carry(&self.from_px, &at);
        warp_mesh.from_px.clear();
        warp_mesh.from_px.extend(self.warp.warp_mesh().to_px.iter().map(|&place| carried.on(place)));
        // The edits alone are kept from folding: how the face itself moves, the frame has already.
        self.warp.follow(&at, &to);
        let laid = self.warp.warp_mesh();
        let ways = laid.to_px.iter().zip(&laid.from_px).map(|(to, from)| carried.turn.rotate(*to - *from));
        warp_mesh.to_px.clear();
        warp_mesh.to_px.extend(ways.zip(&warp_mesh.from_px).map(|(way, from)| *from + way));
        let taper_px = TAPER * self.of.falloff_band * self.longer_side_px * carried.turn.length();
        keep_edges(warp_mesh, DVec2::from(size_px.map(f64::from)), taper_px);
    }
}

impl Carried {
    fn on(&self, place: DVec2) -> DVec2 {
        self.turn.rotate(place) + self.shift
    }

    fn back(&self, place: DVec2) -> DVec2 {
        conjugate(self.turn).rotate(place - self.shift) / self.turn.length_squared()
    }
}

fn conjugate(number: DVec2) -> DVec2 {
    DVec2::new(number.x, -number.y)
}

/// The frame's edge stays, and what lies beyond it is brought onto it.
fn keep_edges(warp_mesh: &mut WarpMesh, size_px: DVec2, taper_px: f64) {
    for (from, to) in warp_mesh.from_px.iter_mut().zip(&mut warp_mesh.to_px) {
        let way = (*to - *from) * smooth_step(from.min(size_px - *from).min_element() / taper_px);
        *from = from.clamp(DVec2::ZERO, size_px);
        *to = (*from + way).clamp(DVec2::ZERO, size_px);
    }
}
