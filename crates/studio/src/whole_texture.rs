use glam::{DVec2, DVec3};
use rosto_face::{
    Camera, FaceModel, LANDMARK_COUNT, Photo, Region, Triangulation, canonical_uvs, crowded_landmarks, opening_edges,
};
use rosto_mesh::{LoopSubdivision, Topology, Value};
use rosto_texture::{Eye, Plan, Subject, Texture, TextureError};

use crate::StudioError;
use crate::mirror::MirrorTable;

/// A texture is made for this density, and serves every other one: their places in it are the same to a fraction of a mm.
const DENSITY: u32 = 2;

/// The shortest side that a face is given, however few pixels its photos have of it.
const SHORTEST_SIDE_PX: u32 = 1024;

/// Texels there are, along a line, for each pixel of a photo: fewer would blur it, and more hold nothing.
const TEXELS_PER_PIXEL: f64 = 2.0;

/// Each comes from one photo alone: a gaze or a smile that was taken twice would be seen twice.
const WHOLES: [Region; 3] = [Region::RightEye, Region::LeftEye, Region::Lips];

/// A photo of a face, found in the model's frame.
#[derive(Debug, Clone, Copy)]
pub struct Shot<'a> {
    /// The upright picture.
    pub picture: &'a Photo,
    /// Where each of the 468 landmarks is in it, 0..=1, origin at the top left.
    pub uvs: &'a [DVec2],
    /// What it was taken by, in the model's frame.
    pub camera: &'a Camera,
}

/// A face's texture in the canonical face's coordinates ([`canonical_uvs`]), all around: what the photo does not show is the
/// other side's mirror image in the light of this side, and what neither shows is filled from around it.
///
/// It is made at rest, of the canonical triangulation, and so serves both triangulations, every density and every edit.
///
/// # Errors
/// [`StudioError::Texture`] if the side is no power of two within [`rosto_texture::SIDES_PX`].
pub fn whole_texture(face: &FaceModel, side_px: u32) -> Result<Texture, StudioError> {
    whole_texture_of(face, &[], side_px)
}

/// The same from further photos, too. The face's own says how bright it is.
///
/// # Errors
/// [`StudioError::Texture`] as well if there are more than [`rosto_texture::MOST_SHOTS`] photos in all, if one has not 468
/// places, or if one of them is not finite.
pub fn whole_texture_of(face: &FaceModel, others: &[Shot<'_>], side_px: u32) -> Result<Texture, StudioError> {
    others.iter().try_for_each(check)?;
    let pictures: Vec<&Photo> = [face.picture()].into_iter().chain(others.iter().map(|shot| shot.picture)).collect();
    let others: Vec<(&[DVec2], &Camera)> = others.iter().map(|shot| (shot.uvs, shot.camera)).collect();
    Ok(texture_plan(face, &others).texture(&pictures, side_px)?)
}

fn check(shot: &Shot<'_>) -> Result<(), TextureError> {
    let (what, expected, found) = ("places in a photo", LANDMARK_COUNT, shot.uvs.len());
    if found == expected { Ok(()) } else { Err(TextureError::WrongLength { what, expected, found }) }
}

/// What the same texture is made of but for the pixels of its photos, the face's own first: where each other photo has the 468
/// landmarks, and what it was taken by. A plan can be carried out elsewhere.
pub fn texture_plan(face: &FaceModel, others: &[(&[DVec2], &Camera)]) -> Plan {
    let dense = Dense::new();
    let positions = dense.interpolate(face.positions_m());
    let wholes = WHOLES.map(|region| dense.made_of(&region.vertices()));
    let subject = Subject {
        topology: &dense.topology,
        positions: &positions,
        atlas_uvs: &dense.interpolate(&canonical_uvs()),
        partners: &dense.partners,
        wholes: &wholes,
    };
    let mut plan = Plan::new(&subject);
    for (uvs, camera) in [(face.uvs(), face.camera())].into_iter().chain(others.iter().copied()) {
        plan.add(&dense.interpolate(uvs), eye(camera));
    }
    plan
}

/// How long the side of a face's texture is to be, in px, where it may be as long as `at_most_px`: a power of two that holds
/// all that the sharpest of the face's photos shows of it. A longer one would be slower to make and to load, and no sharper.
pub fn texture_side_px(face: &FaceModel, at_most_px: u32) -> u32 {
    let sharpest = face.views().iter().map(|view| pixels_per_side(&view.picture, &view.uvs)).fold(0.0, f64::max);
    let filled_px = (TEXELS_PER_PIXEL * sharpest).ceil() as u32;
    filled_px.checked_next_power_of_two().unwrap_or(at_most_px).clamp(SHORTEST_SIDE_PX.min(at_most_px), at_most_px)
}

/// How many pixels of a photo lie along the side of a texture of one to one, by the areas of what is seen of the face.
fn pixels_per_side(picture: &Photo, uvs: &[DVec2]) -> f64 {
    let size_px = DVec2::new(picture.width().into(), picture.height().into());
    let in_photo: Vec<DVec2> = uvs.iter().map(|uv| uv * size_px).collect();
    let in_texture = canonical_uvs();
    let triangles = Triangulation::Canonical.triangles();
    let areas = triangles.iter().map(|corners| (area(&in_photo, corners), area(&in_texture, corners)));
    let seen = areas.filter(|(photo, texture)| photo * texture > 0.0);
    let (photo, texture) = seen.fold((0.0, 0.0), |sum, one| (sum.0 + one.0, sum.1 + one.1));
    if texture == 0.0 { 0.0 } else { (photo / texture).sqrt() }
}

/// Twice the area of a triangle, with the sign of its winding.
fn area(places: &[DVec2], corners: &[u32; 3]) -> f64 {
    let [a, b, c] = corners.map(|corner| places[corner as usize]);
    (b - a).perp_dot(c - a)
}

/// The canonical triangulation, subdivided as documents subdivide it.
struct Dense {
    steps: Vec<LoopSubdivision>,
    topology: Topology,
    partners: Vec<u32>,
}

impl Dense {
    fn new() -> Self {
        let (mut steps, mut topology) = (Vec::new(), Triangulation::Canonical.topology());
        let (mut creases, mut mirror) = (opening_edges(), MirrorTable::of_landmarks());
        for _ in 0..DENSITY {
            let step = LoopSubdivision::creased(&topology, &creases, 1).rounding(&crowded_landmarks());
            mirror =
                mirror.subdivided(&topology).expect("invariant: the canonical triangulation is its own mirror image");
            (topology, creases) = (step.topology().clone(), step.creases().to_vec());
            steps.push(step);
        }
        let partners = (0..topology.vertex_count() as u32).map(|vertex| mirror.partner(vertex)).collect();
        Self { steps, topology, partners }
    }

    fn interpolate<T: Value>(&self, cage: &[T]) -> Vec<T> {
        self.steps.iter().fold(cage.to_vec(), |values, step| step.interpolate(&values))
    }

    /// The vertices that are made of these landmarks for the greater part.
    fn made_of(&self, landmarks: &[u32]) -> Vec<u32> {
        let mark = |landmark: u32| if landmarks.contains(&landmark) { 1.0 } else { 0.0 };
        let cage: Vec<f64> = (0..LANDMARK_COUNT as u32).map(mark).collect();
        let shares = self.steps.iter().fold(cage, |values, step| step.apply(&values));
        (0..).zip(shares).filter(|(_, share)| *share > 0.5).map(|(vertex, _)| vertex).collect()
    }
}

fn eye(camera: &Camera) -> Eye {
    let model_from_camera = camera.camera_from_model.inverse();
    if camera.focal_px.is_finite() {
        Eye::At(model_from_camera.translation)
    } else {
        Eye::Towards(model_from_camera.transform_vector3(DVec3::Z))
    }
}
