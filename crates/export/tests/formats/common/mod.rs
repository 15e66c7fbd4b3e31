//! A test face, and a reader of GLB containers.

use std::sync::LazyLock;

use glam::DVec2;
use rosto_export::{BaseColour, GlbOptions, Model, Picture, SavedEdits, SavedFace};
use rosto_face::{FaceModel, LANDMARK_COUNT, Observation, Photo, PhotoLens, Triangulation, canonical_uvs};
use serde_json::Value;

pub const SIDE: u32 = 300;

/// A gradient whose colour encodes the position: red increases to the right, green downwards.
pub fn gradient() -> Photo {
    let level = |at: u32| (at * 255 / (SIDE - 1)) as u8;
    let pixels = (0..SIDE).flat_map(|y| (0..SIDE).flat_map(move |x| [level(x), level(y), 60])).collect();
    Photo::from_rgb(SIDE, SIDE, pixels).unwrap()
}

/// The canonical face, projected flat over the centre of the gradient.
pub fn face(triangulation: Triangulation) -> FaceModel {
    let depths = rosto_face::canonical_positions_m();
    let landmarks: Vec<[f32; 3]> = (0..LANDMARK_COUNT)
        .map(|v| {
            let uv = canonical_uvs()[v] * 0.5 + 0.2;
            [uv.x as f32, uv.y as f32, -depths[v].z as f32 * 3.0]
        })
        .collect();
    let observation = Observation::in_photo(&gradient(), landmarks).with_lens(PhotoLens::Parallel);
    FaceModel::new(observation, triangulation).unwrap()
}

/// The face that a file was written from, or that was read from one.
pub fn rebuilt(saved: SavedFace) -> FaceModel {
    let triangulation = saved.edits.unwrap().triangulation;
    FaceModel::from_photos(saved.photos, triangulation).unwrap()
}

/// A power of two, as for a real whole-face texture.
const WHOLE_SIDE: u32 = 256;

/// A whole-face texture with its UVs; its colours differ from the photo's.
static WHOLE: LazyLock<(Photo, Vec<DVec2>)> = LazyLock::new(|| {
    let pixels = (0..WHOLE_SIDE).flat_map(|y| (0..WHOLE_SIDE).flat_map(move |x| [30, x as u8, y as u8])).collect();
    (Photo::from_rgb(WHOLE_SIDE, WHOLE_SIDE, pixels).unwrap(), canonical_uvs())
});

/// The face with a whole-face texture.
pub fn model(face: &FaceModel) -> Model<'_> {
    let (pixels, uvs) = &*WHOLE;
    Model { whole: Some(Picture { pixels, uvs }), ..Model::of_face(face) }
}

/// Options for a GLB with the photo as its texture.
pub fn by_photo() -> GlbOptions<'static> {
    GlbOptions { base_colour: BaseColour::Photo, ..GlbOptions::default() }
}

/// Edits with this history, on the landmarks.
pub fn edits(face: &FaceModel, history: Option<&str>) -> SavedEdits {
    SavedEdits { history: history.map(str::to_owned), ..SavedEdits::none(face.triangulation(), 0) }
}

/// A parsed GLB.
pub struct Glb {
    pub json: Value,
    pub binary: Vec<u8>,
}

impl Glb {
    pub fn read(bytes: &[u8]) -> Self {
        let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
        assert_eq!((&bytes[..4], word(4), word(8)), (b"glTF".as_slice(), 2, bytes.len()));
        let json_end = 20 + word(12);
        assert_eq!((&bytes[16..20], &bytes[json_end + 4..json_end + 8]), (b"JSON".as_slice(), b"BIN\0".as_slice()));
        assert_eq!(json_end + 8 + word(json_end), bytes.len());
        Self { json: serde_json::from_slice(&bytes[20..json_end]).unwrap(), binary: bytes[json_end + 8..].to_vec() }
    }

    pub fn view(&self, index: usize) -> &[u8] {
        let view = &self.json["bufferViews"][index];
        let (start, length) = (view["byteOffset"].as_u64().unwrap(), view["byteLength"].as_u64().unwrap());
        &self.binary[start as usize..(start + length) as usize]
    }

    pub fn attribute(&self, name: &str) -> usize {
        self.json["meshes"][0]["primitives"][0]["attributes"][name].as_u64().unwrap() as usize
    }

    pub fn floats<const N: usize>(&self, accessor: usize) -> Vec<[f32; N]> {
        let view = self.json["accessors"][accessor]["bufferView"].as_u64().unwrap() as usize;
        let number = |bytes: &[u8]| f32::from_le_bytes(bytes.try_into().unwrap());
        let all: Vec<f32> = self.view(view).chunks_exact(4).map(number).collect();
        all.chunks_exact(N).map(|row| row.try_into().unwrap()).collect()
    }
}
