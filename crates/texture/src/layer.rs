use glam::{DVec2, DVec3, Vec3};
use rosto_mesh::vertex_normals;
use rosto_photo::{Photo, Sampler};

use crate::atlas::{Atlas, pitch};
use crate::depths::{Depths, LONGER_SIDE};
use crate::map::{AREA, CELLS, blurred, distances, mean_around, ramp};
use crate::trust::{Sight, trusted};
use crate::{Shot, Subject};

/// Which side of the mesh a layer shows on each.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Side {
    /// Its own.
    Own,
    /// The other one's mirror image.
    Mirrored,
}

/// A surface is seen if the cosine of the angle to its normal is more than this: beside what lies behind the mesh, and where
/// nothing but the mesh can be seen.
const LEAST_COSINES: [f32; 2] = [0.22, 0.05];
/// What lies less than this behind the nearest is seen all the same, in shares of the mesh's extent: some 1.5 mm of a face.
const BEHIND: f64 = 0.008;
/// So many times as far may it lie behind in a whole, whose surface is known less well.
const BEHIND_IN_WHOLES: f64 = 4.0;
/// And its cosines are those of what is around them: [`mean_around`]'s times.
const AROUND: u32 = 3;
/// What borders on what is not seen is given up, and what is a little further away fades, in cells.
const FADES: [f32; 2] = [3.0, 12.0];
/// At the mesh's rim, where a pixel of the photo is half of what lies behind, in cells.
const RIM_FADES: [f32; 2] = [1.0, 4.0];
/// What is finer than this blur is detail: [`blurred`]'s times.
const DETAIL: u32 = 3;

/// What one photo shows of one side of the mesh, laid out in the texture.
pub(crate) struct Layer {
    pub(crate) side: Side,
    /// Where each vertex takes its colour from, in px of the picture.
    pub(crate) places_px: Vec<DVec2>,
    /// The colours in sRGB levels.
    pub(crate) colours: Vec<Vec3>,
    /// The same without what is detail.
    pub(crate) low: Vec<Vec3>,
    /// How far each cell is seen and can be trusted: 0 to 1.
    pub(crate) presence: Vec<f32>,
    /// Cosine of the angle at which it is seen.
    pub(crate) cosine: Vec<f32>,
}

/// A photo with what both of its layers need.
pub(crate) struct Seen<'a> {
    subject: &'a Subject<'a>,
    shot: &'a Shot<'a>,
    /// The picture with about one pixel for each texel, or as it is where it has less.
    pub(crate) picture: Photo,
    /// The same for each cell.
    small: Photo,
    cosines: Vec<f64>,
    nearness: Vec<f64>,
    depths: Depths,
    /// Length of the mesh's positions that one pixel of the depth picture spans.
    depth_pitch: f64,
    extent: f64,
}

impl<'a> Seen<'a> {
    pub(crate) fn new(subject: &'a Subject<'a>, shot: &'a Shot<'a>, side_px: u32) -> Self {
        let positions = subject.positions;
        let normals = vertex_normals(subject.topology, positions);
        let cosines = normals.iter().zip(positions).map(|(normal, place)| normal.dot(shot.eye.from(*place)));
        let nearness: Vec<f64> = positions.iter().map(|place| shot.eye.nearness(*place)).collect();
        let places_px = in_px(shot.uvs, shot.picture);
        let depths = Depths::new(subject.topology, &places_px, &nearness);
        let low = positions.iter().copied().reduce(DVec3::min).unwrap_or_default();
        let extent = (positions.iter().copied().reduce(DVec3::max).unwrap_or_default() - low).max_element();
        let scaled = |side: f64| at_pitch(shot.picture, pitch(subject, &places_px, side));
        let (picture, small) = (scaled(f64::from(side_px)), scaled(CELLS as f64));
        let depth_pitch = extent / LONGER_SIDE;
        Self { subject, shot, picture, small, cosines: cosines.collect(), nearness, depths, depth_pitch, extent }
    }

    /// One side of it, laid out. `wholes` is how far each cell belongs to a whole.
    pub(crate) fn layer(&self, atlas: &Atlas, side: Side, wholes: &[f32]) -> Layer {
        let uvs = self.of_side(side, self.shot.uvs);
        let spread_uvs = atlas.spread(&uvs);
        let cosine = atlas.spread(&self.of_side(side, &self.cosines));
        let cosine: Vec<f32> = cosine.into_iter().map(|cosine| cosine.unwrap_or_default() as f32).collect();
        let cosine = smooth_in_wholes(atlas, cosine, wholes);
        let nearness = atlas.spread(&self.of_side(side, &self.nearness));
        let is_seen = |cell: usize| match (spread_uvs[cell], nearness[cell]) {
            (Some(uv), Some(nearness)) => self.is_seen(uv, nearness, cosine[cell], wholes[cell]),
            _ => false,
        };
        let seen = majority(atlas, &(0..AREA).map(is_seen).collect::<Vec<bool>>());
        let colours = self.colours(&spread_uvs);
        let surrounded: Vec<bool> = spread_uvs.iter().map(|uv| uv.is_some_and(|uv| self.is_surrounded(uv))).collect();
        let sight = Sight { colours: &colours, cosine: &cosine, seen: &seen, surrounded: &surrounded };
        let usable = trusted(atlas, &sight, wholes);
        let presence = presence(atlas, &usable);
        let low = mean_around(&colours, &presence, DETAIL).0;
        Layer { side, places_px: in_px(&uvs, &self.picture), colours, low, presence, cosine }
    }

    fn of_side<T: Copy>(&self, side: Side, values: &[T]) -> Vec<T> {
        match side {
            Side::Own => values.to_vec(),
            Side::Mirrored => self.subject.partners.iter().map(|&partner| values[partner as usize]).collect(),
        }
    }

    fn is_seen(&self, uv: DVec2, nearness: f64, cosine: f32, whole: f32) -> bool {
        let place_px = uv * size(self.shot.picture);
        let inside = (place_px.cmpge(DVec2::ONE) & place_px.cmple(size(self.shot.picture) - 1.0)).all();
        let least = if self.is_surrounded(uv) { LEAST_COSINES[1] } else { LEAST_COSINES[0] };
        if !inside || cosine < least {
            return false;
        }
        // Within a pixel of the depth picture, a slope goes on.
        let cosine = f64::from(cosine.min(1.0));
        let slope = (1.0 - cosine * cosine).sqrt() / cosine;
        let behind = BEHIND * self.extent * (1.0 + (BEHIND_IN_WHOLES - 1.0) * f64::from(whole));
        self.depths.behind(place_px, nearness) <= behind + slope * self.depth_pitch
    }

    fn is_surrounded(&self, uv: DVec2) -> bool {
        self.depths.is_surrounded(uv * size(self.shot.picture))
    }

    fn colours(&self, uvs: &[Option<DVec2>]) -> Vec<Vec3> {
        let (sampler, size) = (Sampler::new(&self.small), size(&self.small));
        let colour = |uv: DVec2| Vec3::from(sampler.at(uv * size)).clamp(Vec3::ZERO, Vec3::splat(255.0));
        uvs.iter().map(|uv| uv.map_or(Vec3::ZERO, colour)).collect()
    }
}

/// What fills an eye or a mouth, and lips that are open, lie in folds that the mesh tells little about.
fn smooth_in_wholes(atlas: &Atlas, cosine: Vec<f32>, wholes: &[f32]) -> Vec<f32> {
    let inside: Vec<f32> = (0..AREA).map(|cell| f32::from(u8::from(atlas.is_inside(cell)))).collect();
    let smooth = mean_around(&cosine, &inside, AROUND).0;
    let both = cosine.iter().zip(smooth).zip(wholes);
    both.map(|((cosine, smooth), whole)| cosine + (smooth - cosine) * whole).collect()
}

/// Without specks: what most of the mesh around them is.
fn majority(atlas: &Atlas, seen: &[bool]) -> Vec<bool> {
    let around = |is_some: &dyn Fn(usize) -> bool| {
        let map: Vec<f32> = (0..AREA).map(|cell| f32::from(u8::from(is_some(cell)))).collect();
        blurred(&map, 1, CELLS)
    };
    let (shares, all) = (around(&|cell| seen[cell]), around(&|cell| atlas.is_inside(cell)));
    (0..AREA).map(|cell| seen[cell] && 2.0 * shares[cell] > all[cell]).collect()
}

/// Fades towards what cannot be used, and less far towards where the mesh ends.
fn presence(atlas: &Atlas, usable: &[bool]) -> Vec<f32> {
    let outside: Vec<bool> = (0..AREA).map(|cell| !atlas.is_inside(cell)).collect();
    let lost: Vec<bool> = (0..AREA).map(|cell| !outside[cell] && !usable[cell]).collect();
    let faded = |sources: &[bool], [from, to]: [f32; 2]| -> Vec<f32> {
        distances(sources).into_iter().map(|distance| ramp(distance, from, to)).collect()
    };
    let (inner, rim) = (faded(&lost, FADES), faded(&outside, RIM_FADES));
    inner.into_iter().zip(rim).map(|(inner, rim)| inner * rim).collect()
}

fn size(photo: &Photo) -> DVec2 {
    DVec2::new(photo.width().into(), photo.height().into())
}

fn in_px(uvs: &[DVec2], photo: &Photo) -> Vec<DVec2> {
    uvs.iter().map(|uv| *uv * size(photo)).collect()
}

/// The picture scaled down by as much, if it is more than 1.
fn at_pitch(photo: &Photo, pitch: f64) -> Photo {
    let longer = f64::from(photo.width().max(photo.height()));
    photo.scaled_down((longer / pitch.max(1.0)) as u32)
}
