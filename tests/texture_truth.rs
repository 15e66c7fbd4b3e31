//! A head with a known texture, and rendered photos of it.

use glam::{DAffine3, DQuat, DVec2, DVec3};
use rosto_face::*;
use rosto_mesh::vertex_normals;
use rosto_photo::Sampler;
use rosto_studio::{CoordinateFrame, Document, Rest, SMOOTH_DENSITY};
use rosto_texture::spans;

use crate::faces::portrait_landmarks;
use crate::seeded::Seeded;

/// Distance from the camera to the head's centre.
pub const DISTANCE_M: f64 = 0.6;
/// Side of the rendered photos.
pub const SIZE_PX: u32 = 1024;
/// Depth tolerance of visibility.
const BEHIND_M: f64 = 0.002;

/// A head at rest and its texture.
pub struct Head {
    pub mesh: Document,
    pub landmarks_m: Vec<DVec3>,
    pub places_m: Vec<DVec3>,
    pub atlas_uvs: Vec<DVec2>,
    pub texture: Photo,
}

/// Observation of a face in a picture.
pub fn observed(picture: Photo, landmarks: &[[f32; 3]], lens: PhotoLens) -> Observation {
    Observation { found_lens: lens, lens, ..Observation::in_photo(&picture, landmarks.to_vec()) }
}

/// Model of a face in a picture.
pub fn face(picture: Photo, landmarks: &[[f32; 3]], lens: PhotoLens) -> FaceModel {
    FaceModel::new(observed(picture, landmarks, lens), Triangulation::Canonical).expect("the landmarks form a face")
}

impl Head {
    /// A head with the shape of a face, textured in canonical coordinates.
    pub fn new(landmarks_m: &[DVec3], texture: Photo) -> Self {
        let topology = Triangulation::Canonical.topology();
        let rest = Rest::of_landmarks(topology, landmarks_m.to_vec(), CoordinateFrame::Model);
        let mut mesh = Document::new(rest).expect("the mesh is valid");
        mesh.set_density(SMOOTH_DENSITY).expect("the density is in range");
        let (places_m, atlas_uvs) = (mesh.rest().to_vec(), mesh.from_cage(&canonical_uvs()));
        Self { mesh, landmarks_m: landmarks_m.to_vec(), places_m, atlas_uvs, texture }
    }

    /// The sample portrait's shape with a [`painted`] texture.
    pub fn painted(side_px: u32) -> Self {
        let blank = Photo::from_rgb(512, 512, vec![0; 512 * 512 * 3]).expect("three bytes per pixel");
        let shape = face(blank.clone(), &portrait_landmarks(), PhotoLens::Estimated);
        let bare = Self::new(shape.positions_m(), blank);
        let texture = painted(&bare, side_px);
        Self { texture, ..bare }
    }

    /// A camera in front of the head, which is turned to its own left.
    pub fn camera(&self, yaw_deg: f64) -> Camera {
        let middle_m = self.landmarks_m.iter().sum::<DVec3>() / LANDMARK_COUNT as f64;
        let rotation = DQuat::from_rotation_y(yaw_deg.to_radians());
        let translation = DVec3::NEG_Z * DISTANCE_M - rotation * middle_m;
        let focal_px = 2.3 * f64::from(SIZE_PX);
        Camera {
            lens: PhotoLens::Distance(DISTANCE_M),
            focal_px,
            principal_px: DVec2::splat(f64::from(SIZE_PX) / 2.0),
            px_per_m: focal_px / DISTANCE_M,
            distance_m: DISTANCE_M,
            distance_interval_m: [DISTANCE_M; 2],
            camera_from_model: DAffine3::from_rotation_translation(rotation, translation),
        }
    }

    /// Landmarks projected by a camera, in MediaPipe's convention.
    pub fn landmarks(&self, camera: &Camera) -> Vec<[f32; 3]> {
        let size = f64::from(SIZE_PX);
        let seen = |place_m: &DVec3| {
            let place_px = camera.project(*place_m).expect("the head is in front of the camera");
            let away_px = -(camera.towards_camera_m(*place_m) + DISTANCE_M) * camera.px_per_m;
            [place_px.x / size, place_px.y / size, away_px / size].map(|value| value as f32)
        };
        self.landmarks_m.iter().map(seen).collect()
    }

    /// Renders the head in front of a bright background with coloured blobs.
    pub fn photo(&self, camera: &Camera) -> Photo {
        let side = 2 * SIZE_PX as usize;
        let mut pixels: Vec<[u8; 3]> = (0..side * side).map(|i| background(i % side, i / side, side)).collect();
        let sampler = Sampler::new(&self.texture);
        let (atlas_px, texture_px) = (self.atlas_uvs.as_slice(), f64::from(self.texture.width()));
        self.drawn(camera, 2, |pixel, corners, shares| {
            let [a, b, c] = corners.map(|corner| atlas_px[corner as usize] * texture_px);
            pixels[pixel] = sampler.at(a * shares.x + b * shares.y + c * shares.z).map(|level| (level + 0.5) as u8);
        });
        let large = Photo::from_rgb(side as u32, side as u32, pixels.concat()).expect("three bytes per pixel");
        large.scaled_down(SIZE_PX)
    }

    /// Rasterises the head with a depth buffer at `scale` times the camera's resolution; calls `paint` for each pixel
    /// that passes the depth test. Returns the depth buffer.
    fn drawn(&self, camera: &Camera, scale: usize, mut paint: impl FnMut(usize, [u32; 3], DVec3)) -> Vec<f64> {
        let (side, scale) = (scale * SIZE_PX as usize, scale as f64);
        let mut nearest = vec![f64::NEG_INFINITY; side * side];
        let place_px = |corner: u32| camera.project(self.places_m[corner as usize]).unwrap_or(DVec2::NAN) * scale;
        let near_m = |corner: u32| camera.towards_camera_m(self.places_m[corner as usize]);
        for &corners in self.mesh.topology().triangles() {
            let places = corners.map(place_px);
            let near = DVec3::from(corners.map(near_m));
            let is_front = (places[1] - places[0]).perp_dot(places[2] - places[0]) < 0.0;
            for span in spans(places, [side; 2]).filter(|_| is_front) {
                for (column, shares) in span.pixels() {
                    let pixel = span.row * side + column;
                    if shares.dot(near) > nearest[pixel] {
                        nearest[pixel] = shares.dot(near);
                        paint(pixel, corners, shares);
                    }
                }
            }
        }
        nearest
    }

    /// Texels of a texture of `side_px` that a camera sees at an angle below about 80°.
    pub fn seen(&self, camera: &Camera, side_px: usize) -> Vec<bool> {
        let side = SIZE_PX as usize;
        let nearest = self.drawn(camera, 1, |_, _, _| ());
        let eye_m = camera.camera_from_model.inverse().translation;
        let normals = vertex_normals(self.mesh.topology(), &self.places_m);
        let mut seen = vec![false; side_px * side_px];
        self.over_the_texture(side_px, |texel, corners, shares| {
            let interpolated = |of: &[DVec3]| -> DVec3 {
                corners.iter().zip(shares.to_array()).map(|(corner, share)| of[*corner as usize] * share).sum()
            };
            let place_m = interpolated(&self.places_m);
            let front = interpolated(&normals).dot((eye_m - place_m).normalize());
            let at = camera.project(place_m).unwrap_or(DVec2::ZERO).as_uvec2();
            let before_m = nearest[at.y as usize * side + at.x as usize] - camera.towards_camera_m(place_m);
            seen[texel] = front > 0.17 && before_m < BEHIND_M;
        });
        seen
    }

    /// Calls `visit` for each texel covered by the head.
    pub fn over_the_texture(&self, side_px: usize, mut visit: impl FnMut(usize, [u32; 3], DVec3)) {
        for &corners in self.mesh.topology().triangles() {
            let places = corners.map(|corner| self.atlas_uvs[corner as usize] * side_px as f64);
            for span in spans(places, [side_px; 2]) {
                span.pixels().for_each(|(column, shares)| visit(span.row * side_px + column, corners, shares));
            }
        }
    }

    /// Share of each dense vertex in the regions.
    pub fn share_of(&self, regions: &[Region]) -> Vec<f64> {
        let mut marks = vec![0.0; LANDMARK_COUNT];
        regions.iter().flat_map(|region| region.vertices()).for_each(|vertex| marks[vertex as usize] = 1.0);
        self.mesh.from_cage(&marks)
    }

    /// Texels of skin, without eyes, eyebrows and lips.
    pub fn skin(&self, side_px: usize) -> Vec<bool> {
        use Region::{LeftBrow, LeftEye, Lips, RightBrow, RightEye};
        let features = self.share_of(&[RightEye, LeftEye, Lips, RightBrow, LeftBrow]);
        let mut skin = vec![false; side_px * side_px];
        self.over_the_texture(side_px, |texel, corners, _| {
            skin[texel] = corners.iter().all(|&corner| features[corner as usize].abs() < 0.02);
        });
        skin
    }

    /// The photo projected onto the mesh, regardless of visibility.
    pub fn projected(&self, face: &FaceModel, side_px: usize) -> Photo {
        let places = self.mesh.from_cage(face.uvs());
        let picture = face.picture().expect("the face has its picture");
        let (sampler, size) = (Sampler::new(picture), f64::from(picture.width()));
        let mut pixels = vec![[0; 3]; side_px * side_px];
        self.over_the_texture(side_px, |texel, corners, shares| {
            let [a, b, c] = corners.map(|corner| places[corner as usize] * size);
            pixels[texel] = sampler.at(a * shares.x + b * shares.y + c * shares.z).map(|level| (level + 0.5) as u8);
        });
        Photo::from_rgb(side_px as u32, side_px as u32, pixels.concat()).expect("three bytes per texel")
    }
}

/// White with coloured blobs next to the head.
fn background(x: usize, y: usize, side: usize) -> [u8; 3] {
    const BLOBS: [([f64; 2], [u8; 3]); 5] = [
        ([0.18, 0.45], [200, 30, 40]),
        ([0.82, 0.42], [20, 110, 40]),
        ([0.22, 0.72], [30, 60, 190]),
        ([0.8, 0.7], [20, 20, 24]),
        ([0.5, 0.95], [240, 200, 30]),
    ];
    let at = DVec2::new(x as f64, y as f64) / side as f64;
    let blob = BLOBS.iter().find(|(centre, _)| at.distance(DVec2::from(*centre)) < 0.13);
    blob.map_or([250, 250, 252], |(_, colour)| *colour)
}

/// Skin with pores, freckles, asymmetric light, eyes, eyebrows and lips.
fn painted(head: &Head, side_px: u32) -> Photo {
    let side = side_px as usize;
    let features: [(&[Region], DVec3); 4] = [
        (&[Region::RightEye, Region::LeftEye], DVec3::new(70.0, 50.0, 45.0)),
        (&[Region::RightBrow, Region::LeftBrow], DVec3::new(80.0, 55.0, 40.0)),
        (&[Region::Lips], DVec3::new(170.0, 80.0, 85.0)),
        (&[Region::RightCheek, Region::LeftCheek], DVec3::new(215.0, 140.0, 125.0)),
    ];
    let features = features.map(|(regions, colour)| (head.share_of(regions), colour));
    let mut seeded = Seeded::new(7);
    let mut freckle = || (DVec2::splat(0.5) + seeded.vector().truncate() * 0.48, 0.0025 + 0.0015 * seeded.signed());
    let freckles: Vec<(DVec2, f64)> = (0..160).map(|_| freckle()).collect();
    let mut pixels = vec![[0; 3]; side * side];
    head.over_the_texture(side, |texel, corners, shares| {
        let at = DVec2::new((texel % side) as f64 + 0.5, (texel / side) as f64 + 0.5) / side as f64;
        let mut colour = DVec3::new(208.0, 160.0, 136.0);
        for (share, feature) in &features {
            let share: f64 =
                corners.iter().zip(shares.to_array()).map(|(corner, of)| share[*corner as usize] * of).sum();
            colour = colour.lerp(*feature, 0.8 * share.clamp(0.0, 1.0));
        }
        let dark = freckles.iter().filter(|(centre, radius)| at.distance(*centre) < *radius).count();
        colour *= 0.8_f64.powi(dark.min(2) as i32);
        // Brighter on one side.
        colour *= 0.88 + 0.3 * (at.x - 0.5) * (1.0 - 0.5 * at.y) + 0.04 * (at.y - 0.5);
        colour *= 1.0 + 0.05 * grain(at * 90.0) + 0.04 * grain(at * 260.0);
        pixels[texel] = colour.to_array().map(|level| (level + 0.5) as u8);
    });
    Photo::from_rgb(side_px, side_px, pixels.concat()).expect("three bytes per texel")
}

/// Value noise, −1 to 1.
fn grain(at: DVec2) -> f64 {
    let cell = at.floor();
    let share = at - cell;
    let smooth = share * share * (DVec2::splat(3.0) - 2.0 * share);
    let value = |x: f64, y: f64| {
        let seed = ((cell.x + x) as i64 as u64).wrapping_mul(7919).wrapping_add(((cell.y + y) as i64 as u64) << 32);
        Seeded::new(seed).signed()
    };
    let along = |y: f64| value(0.0, y) + (value(1.0, y) - value(0.0, y)) * smooth.x;
    along(0.0) + (along(1.0) - along(0.0)) * smooth.y
}

/// Median and 95th percentile of the difference between two textures: mean over a texel's channels, in levels.
pub fn errors(truth: &Photo, found: &Photo, texels: &[bool]) -> [f64; 2] {
    let pairs = truth.pixels().as_chunks::<3>().0.iter().zip(found.pixels().as_chunks::<3>().0);
    let selected = pairs.zip(texels).filter(|(_, is)| **is).map(|(pair, _)| pair);
    let difference = |(a, b): (&[u8; 3], &[u8; 3])| (0..3).map(|i| f64::from(a[i].abs_diff(b[i]))).sum::<f64>() / 3.0;
    let mut errors: Vec<f64> = selected.map(difference).collect();
    errors.sort_by(f64::total_cmp);
    [0.5, 0.95].map(|share| errors.get((errors.len() as f64 * share) as usize).copied().unwrap_or(f64::NAN))
}
