use glam::{DVec2, DVec3};
use rosto_face::{
    Camera, FaceModel, LANDMARK_COUNT, Photo, Region, Triangulation, View, canonical_uvs, crowded_landmarks,
    opening_edges,
};
use rosto_mesh::{LoopSubdivision, Topology, Value};
use rosto_texture::{Eye, Shot, Subject, Texture, texture};

use crate::StudioError;
use crate::mirror::MirrorTable;

/// Density at which textures are made. They fit the other densities, whose texture coordinates differ by a fraction of
/// a mm.
const DENSITY: u32 = 2;

/// Minimum side of a face's texture, for photos with few pixels of it.
const SHORTEST_SIDE_PX: u32 = 1024;

/// Texels per photo pixel along a line: fewer would blur the photo, and more add no detail.
const TEXELS_PER_PIXEL: f64 = 2.0;

/// Regions taken from a single photo: a blend of two gazes or smiles would show both.
const WHOLES: [Region; 3] = [Region::RightEye, Region::LeftEye, Region::Lips];

/// Whole-face texture of a model's photos, in the canonical face's coordinates ([`canonical_uvs`]); the lead photo sets
/// the brightness. Areas that the photos do not show come from the other side, mirrored and adjusted to this side's
/// light; areas visible on neither side are filled from their surroundings.
///
/// It is made from the face at rest with the canonical triangulation, and fits both triangulations and any density and
/// edit.
///
/// # Errors
/// [`StudioError::NoPicture`] if a photo has no picture, [`StudioError::Texture`] if the side is not a power of two
/// within [`rosto_texture::SIDES_PX`].
pub fn whole_texture(face: &FaceModel, side_px: u32) -> Result<Texture, StudioError> {
    let pictures = face.views().iter().map(|view| view.observation.picture.as_ref());
    let pictures: Vec<&Photo> = pictures.collect::<Option<_>>().ok_or(StudioError::NoPicture)?;
    let dense = Dense::new();
    let wholes = WHOLES.map(|region| dense.made_of(&region.vertices()));
    let subject = Subject {
        topology: &dense.topology,
        positions: &rounded(dense.interpolate(face.positions_m())),
        atlas_uvs: &rounded_uvs(dense.interpolate(&canonical_uvs())),
        partners: &dense.partners,
        features: &wholes,
    };
    let uvs: Vec<Vec<DVec2>> = face.views().iter().map(|view| rounded_uvs(dense.interpolate(&view.uvs))).collect();
    let shots = face.views().iter().zip(&pictures).zip(&uvs);
    let shots: Vec<Shot<'_>> =
        shots.map(|((view, picture), uvs)| Shot { picture, uvs, eye: eye(&view.camera) }).collect();
    Ok(texture(&subject, &shots, side_px)?)
}

/// Rounds to single precision, so that differences in a mesh's last digits between machines do not change the texture.
fn rounded(positions: Vec<DVec3>) -> Vec<DVec3> {
    positions.into_iter().map(|position| position.as_vec3().as_dvec3()).collect()
}

fn rounded_uvs(uvs: Vec<DVec2>) -> Vec<DVec2> {
    uvs.into_iter().map(|uv| uv.as_vec2().as_dvec2()).collect()
}

/// Side length of a face's texture in px: the power of two that holds the detail of the face's sharpest photo, at most
/// `at_most_px`. `size_px` returns width and height of a photo's picture, if there is one. A longer side would cost time
/// and memory without adding detail.
pub fn texture_side_px(face: &FaceModel, size_px: impl Fn(&View) -> Option<[u32; 2]>, at_most_px: u32) -> u32 {
    let pictures = face.views().iter().filter_map(|view| Some(pixels_per_side(size_px(view)?, &view.uvs)));
    let sharpest = pictures.fold(0.0, f64::max);
    let filled_px = (TEXELS_PER_PIXEL * sharpest).ceil() as u32;
    filled_px.checked_next_power_of_two().unwrap_or(at_most_px).clamp(SHORTEST_SIDE_PX.min(at_most_px), at_most_px)
}

/// Number of photo pixels along the side of a unit texture, from the areas of the visible triangles.
fn pixels_per_side(size_px: [u32; 2], uvs: &[DVec2]) -> f64 {
    let size_px = DVec2::from(size_px.map(f64::from));
    let in_photo: Vec<DVec2> = uvs.iter().map(|uv| uv * size_px).collect();
    let in_texture = canonical_uvs();
    let triangles = Triangulation::Canonical.triangles();
    let areas = triangles.iter().map(|corners| (area(&in_photo, corners), area(&in_texture, corners)));
    let seen = areas.filter(|(photo, texture)| photo * texture > 0.0);
    let (photo, texture) = seen.fold((0.0, 0.0), |sum, one| (sum.0 + one.0, sum.1 + one.1));
    if texture == 0.0 { 0.0 } else { (photo / texture).sqrt() }
}

/// Twice the signed area of a triangle.
fn area(places: &[DVec2], corners: &[u32; 3]) -> f64 {
    let [a, b, c] = corners.map(|corner| places[corner as usize]);
    (b - a).perp_dot(c - a)
}

/// The canonical triangulation, subdivided as in a document.
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

    /// The vertices whose weight comes mostly from these landmarks.
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
        Eye::At(model_from_camera.translation.as_vec3().as_dvec3())
    } else {
        Eye::Towards(model_from_camera.transform_vector3(DVec3::Z).as_vec3().as_dvec3())
    }
}
