use glam::{DVec2, DVec3, Vec3};
use rosto_mesh::vertex_normals;
use rosto_photo::{Photo, Sampler};

use crate::atlas::{Atlas, pitch};
use crate::depths::{Depths, LONGER_SIDE};
use crate::map::{AREA, CELLS, blurred, distances, mean_around, ramp};
use crate::trust::{Observation, trusted};
use crate::{Shot, Subject};

/// Side of the mesh that a layer's colours come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Side {
    /// The same side.
    Own,
    /// The opposite side, mirrored.
    Mirrored,
}

/// Minimum cosine of the viewing angle: near the background, and where only the mesh is close.
const MIN_COSINES: [f32; 2] = [0.22, 0.05];
/// Depth tolerance of visibility, as a share of the mesh's extent; about 1.5 mm on a face.
const BEHIND: f64 = 0.008;
/// Factor of the tolerance inside features, whose surface is less precise.
const BEHIND_IN_FEATURES: f64 = 4.0;
/// Levels of [`mean_around`] that smooth cosines inside features.
const AROUND: u32 = 3;
/// Fade towards hidden areas: start and end in cells.
const FADES: [f32; 2] = [3.0, 12.0];
/// Fade at the mesh's rim, where pixels mix with the background: start and end in cells.
const RIM_FADES: [f32; 2] = [1.0, 4.0];
/// Levels of [`mean_around`]; finer structures are detail.
const DETAIL: u32 = 3;

/// One side of the mesh as one photo shows it, resampled to the texture.
pub(crate) struct Layer {
    pub(crate) side: Side,
    /// Source position of each vertex, in px of the picture.
    pub(crate) positions_px: Vec<DVec2>,
    /// Colours in sRGB levels.
    pub(crate) colours: Vec<Vec3>,
    /// Colours without detail.
    pub(crate) low: Vec<Vec3>,
    /// Visibility and reliability, 0 to 1.
    pub(crate) presence: Vec<f32>,
    /// Cosine of the viewing angle.
    pub(crate) cosine: Vec<f32>,
}

/// A photo with the data that both of its layers share.
pub(crate) struct PreparedShot<'a> {
    subject: &'a Subject<'a>,
    shot: &'a Shot<'a>,
    /// The picture, scaled down to about one pixel per texel.
    pub(crate) picture: Photo,
    /// The picture, scaled down to about one pixel per cell.
    small: Photo,
    cosines: Vec<f64>,
    nearness: Vec<f64>,
    depths: Depths,
    /// Model length per pixel of the depth buffer.
    depth_pitch: f64,
    extent: f64,
}

impl<'a> PreparedShot<'a> {
    pub(crate) fn new(subject: &'a Subject<'a>, shot: &'a Shot<'a>, side_px: u32) -> Self {
        let positions = subject.positions;
        let normals = vertex_normals(subject.topology, positions);
        let cosines = normals.iter().zip(positions).map(|(normal, position)| normal.dot(shot.eye.from(*position)));
        let nearness: Vec<f64> = positions.iter().map(|position| shot.eye.nearness(*position)).collect();
        let positions_px = in_px(shot.uvs, shot.picture);
        let depths = Depths::new(subject.topology, &positions_px, &nearness);
        let low = positions.iter().copied().reduce(DVec3::min).unwrap_or_default();
        let extent = (positions.iter().copied().reduce(DVec3::max).unwrap_or_default() - low).max_element();
        let scaled = |side: f64| at_pitch(shot.picture, pitch(subject, &positions_px, side));
        let (picture, small) = (scaled(f64::from(side_px)), scaled(CELLS as f64));
        let depth_pitch = extent / LONGER_SIDE;
        Self { subject, shot, picture, small, cosines: cosines.collect(), nearness, depths, depth_pitch, extent }
    }

    /// Resamples one side. `features` is how far each cell belongs to a feature.
    pub(crate) fn layer(&self, atlas: &Atlas, side: Side, features: &[f32]) -> Layer {
        let uvs = self.of_side(side, self.shot.uvs);
        let spread_uvs = atlas.spread(&uvs);
        let cosine = atlas.spread(&self.of_side(side, &self.cosines));
        let cosine: Vec<f32> = cosine.into_iter().map(|cosine| cosine.unwrap_or_default() as f32).collect();
        let cosine = smooth_in_features(atlas, cosine, features);
        let nearness = atlas.spread(&self.of_side(side, &self.nearness));
        let is_seen = |cell: usize| match (spread_uvs[cell], nearness[cell]) {
            (Some(uv), Some(nearness)) => self.is_seen(uv, nearness, cosine[cell], features[cell]),
            _ => false,
        };
        let seen = majority(atlas, &(0..AREA).map(is_seen).collect::<Vec<bool>>());
        let colours = self.colours(&spread_uvs);
        let surrounded: Vec<bool> = spread_uvs.iter().map(|uv| uv.is_some_and(|uv| self.is_surrounded(uv))).collect();
        let observation = Observation { colours: &colours, cosine: &cosine, seen: &seen, surrounded: &surrounded };
        let usable = trusted(atlas, &observation, features);
        let presence = presence(atlas, &usable);
        let low = mean_around(&colours, &presence, DETAIL).0;
        Layer { side, positions_px: in_px(&uvs, &self.picture), colours, low, presence, cosine }
    }

    fn of_side<T: Copy>(&self, side: Side, values: &[T]) -> Vec<T> {
        match side {
            Side::Own => values.to_vec(),
            Side::Mirrored => self.subject.partners.iter().map(|&partner| values[partner as usize]).collect(),
        }
    }

    fn is_seen(&self, uv: DVec2, nearness: f64, cosine: f32, feature: f32) -> bool {
        let position_px = uv * size(self.shot.picture);
        let inside = (position_px.cmpge(DVec2::ONE) & position_px.cmple(size(self.shot.picture) - 1.0)).all();
        let min_cosine = if self.is_surrounded(uv) { MIN_COSINES[1] } else { MIN_COSINES[0] };
        if !inside || cosine < min_cosine {
            return false;
        }
        // Depth changes within a pixel of the depth buffer, depending on the slope.
        let cosine = f64::from(cosine.min(1.0));
        let slope = (1.0 - cosine * cosine).sqrt() / cosine;
        let behind = BEHIND * self.extent * (1.0 + (BEHIND_IN_FEATURES - 1.0) * f64::from(feature));
        self.depths.behind(position_px, nearness) <= behind + slope * self.depth_pitch
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

/// Smooths cosines in eyes and mouth, whose folds the mesh represents poorly.
fn smooth_in_features(atlas: &Atlas, cosine: Vec<f32>, features: &[f32]) -> Vec<f32> {
    let inside: Vec<f32> = (0..AREA).map(|cell| f32::from(u8::from(atlas.is_inside(cell)))).collect();
    let smooth = mean_around(&cosine, &inside, AROUND).0;
    let both = cosine.iter().zip(smooth).zip(features);
    both.map(|((cosine, smooth), feature)| cosine + (smooth - cosine) * feature).collect()
}

/// Removes specks by a majority filter.
fn majority(atlas: &Atlas, seen: &[bool]) -> Vec<bool> {
    let around = |is_some: &dyn Fn(usize) -> bool| {
        let map: Vec<f32> = (0..AREA).map(|cell| f32::from(u8::from(is_some(cell)))).collect();
        blurred(&map, 1, CELLS)
    };
    let (shares, all) = (around(&|cell| seen[cell]), around(&|cell| atlas.is_inside(cell)));
    (0..AREA).map(|cell| seen[cell] && 2.0 * shares[cell] > all[cell]).collect()
}

/// Fades towards unusable areas and, over a shorter distance, towards the mesh's rim.
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

/// The picture scaled down by `pitch`, if that is above 1.
fn at_pitch(photo: &Photo, pitch: f64) -> Photo {
    let longer = f64::from(photo.width().max(photo.height()));
    photo.scaled_down((longer / pitch.max(1.0)) as u32)
}
