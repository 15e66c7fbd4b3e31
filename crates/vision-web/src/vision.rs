use js_sys::{Error, Function, Uint8Array};
use rosto::{FaceFinder, FaceMesh, FindOptions, Format, LandmarkNetwork, Limits, Photo, PhotoEdit, PhotoRequest};
use rosto::{SavedFace, TextureSize, decode};
use rosto_face::{FaceModel, MAX_PICTURE_SIDE_PX, Triangulation};
use rosto_landmarks::Follower;
use tsify::Ts;
use wasm_bindgen::prelude::*;

use crate::error::{self, Result, require};
use crate::file_options::FileOptions;
use crate::messages::{FaceRequest, OpenedFile, PrintedBody, RawPicture, WrittenFile, received, sent};
use crate::opened::{self, Decoded};
use crate::paper::PaperRun;
use crate::pictures::Pictures;
use crate::progress::{Progress, Step};

/// Opens photos and saved faces, writes files, and follows one face in a camera stream. Create it once.
#[wasm_bindgen]
#[derive(Default)]
pub struct Vision {
    finder: Option<FaceFinder>,
    follower: Follower,
    pictures: Pictures,
    /// The texture that was made last, with its photos and their pictures.
    texture: Option<(FaceKey, Photo)>,
}

/// Photos and pictures of a request.
type FaceKey = (String, Vec<String>);

#[wasm_bindgen]
impl Vision {
    /// Creates a worker without networks, which reopens and writes faces but finds none.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        console_error_panic_hook::set_once();
        Self::default()
    }

    /// Loads the detector and the landmark network with attention from their ONNX files.
    ///
    /// # Errors
    /// Throws `networks-damaged`.
    #[wasm_bindgen(js_name = loadNetworks)]
    pub fn load_networks(&mut self, detector: &[u8], landmarks: &[u8]) -> Result<()> {
        let finder = FaceFinder::new(detector, LandmarkNetwork::Attention(landmarks)).map_err(error::of_landmarks)?;
        self.finder = Some(finder);
        Ok(())
    }

    /// Opens a photo (the bytes of a JPEG, PNG or WebP file), GLB or project, and keeps its pictures as `KEY/0`,
    /// `KEY/1` and so on; a photo has one. Finds up to `max_faces` faces in a photo, the most prominent first. Calls
    /// `report` at the start of each stage with the overall fraction done, 0 to 1. If the browser has converted the
    /// photo, `original` is the file (HEIC, AVIF) from which the lens data is read.
    ///
    /// # Errors
    /// Throws `not-a-picture`, `unsupported-format`, `damaged-picture`, `too-many-bytes`, `too-many-pixels`,
    /// `foreign-glb`, `damaged-glb`, `bad-project`, `not-a-face`, `other-version`, `bad-face`, `networks-damaged` or
    /// `internal`. A photo without a face is not an error.
    pub fn open(
        &mut self,
        key: &str,
        bytes: &[u8],
        #[wasm_bindgen(js_name = maxFaces)] max_faces: u32,
        #[wasm_bindgen(
            unchecked_param_type = "(stage: \"decode\" | \"detect\" | \"landmarks\", fraction: number) => void"
        )]
        report: &Function,
        original: Option<Box<[u8]>>,
    ) -> Result<Ts<OpenedFile>> {
        let progress = Progress::new(report);
        progress.report(Step::Decoding);
        let decoded = opened::decoded(bytes, original.as_deref())?;
        let faces = match &decoded {
            Decoded::Photo(photo) => self.find(photo, max_faces, &progress)?,
            Decoded::Saved(_) => Vec::new(),
        };
        progress.report(Step::Finishing);
        let names = self.pictures.keep(key, decoded.pictures());
        sent(&match &decoded {
            Decoded::Photo(photo) => opened::of_photo(photo, faces, &names),
            Decoded::Saved(reopened) => opened::of_saved(reopened, &names)?,
        })
    }

    /// Whether a picture is kept.
    pub fn has(&self, picture: &str) -> bool {
        self.pictures.has(picture)
    }

    /// Keeps the pictures of a file again, after a restart or when they were dropped. The pictures of the last six
    /// files are kept.
    ///
    /// # Errors
    /// Throws the errors of a file in [`Self::open`].
    pub fn keep(&mut self, key: &str, bytes: &[u8], original: Option<Box<[u8]>>) -> Result<()> {
        let decoded = opened::decoded(bytes, original.as_deref())?;
        self.pictures.keep(key, decoded.pictures());
        Ok(())
    }

    /// A kept picture, scaled down to at most 2048 px.
    ///
    /// # Errors
    /// Throws `internal` if it is not kept.
    pub fn picture(&mut self, picture: &str) -> Result<Ts<RawPicture>> {
        let photo = self.pictures.get(picture)?;
        let is_small = photo.width().max(photo.height()) <= MAX_PICTURE_SIDE_PX;
        sent(&RawPicture::of(&if is_small { photo } else { photo.scaled_down(MAX_PICTURE_SIDE_PX) }))
    }

    /// The whole-face texture, at most as large as a texture size's id says.
    ///
    /// # Errors
    /// Throws `bad-choice`, or an error of the face as in [`Self::write`].
    pub fn texture(&mut self, face: Ts<FaceRequest>, size: &str) -> Result<Ts<RawPicture>> {
        let (face, size) = (received(&face)?, require(TextureSize::from_id(size))?);
        let mut mesh = self.mesh(&face)?;
        let picture = RawPicture::of(mesh.texture(size.px()).map_err(error::of_request)?);
        self.keep_texture(face, mesh);
        sent(&picture)
    }

    /// Writes a face in a format. Sidecar files, and the main file in an archive, are called `name`.
    ///
    /// # Errors
    /// Throws `bad-choice`, `bad-face`, `bad-history`, `other-version`, `too-thick` (with the thickest possible wall as
    /// `maxMm`), `no-body`, `surface-alone`, `cannot-export`, or `internal` for a picture that is not kept.
    pub fn write(
        &mut self,
        face: Ts<FaceRequest>,
        format: &str,
        options: Ts<FileOptions>,
        name: &str,
    ) -> Result<Ts<WrittenFile>> {
        let (face, format, options) =
            (received(&face)?, require(Format::from_id(format))?, received(&options)?.read()?);
        let mut mesh = self.mesh(&face)?;
        let written = mesh.write(format, &options, name).map_err(error::of_request)?;
        self.keep_texture(face, mesh);
        let extension = format.bundle_extension(options.base_colour);
        let media_type = if extension == format.id() { format.media_type() } else { "application/zip" };
        sent(&WrittenFile {
            bytes: Uint8Array::from(written.bundled(name, format).as_slice()),
            extension: extension.to_owned(),
            media_type: media_type.to_owned(),
        })
    }

    /// Writes a face with its lossless photo as a project file.
    ///
    /// # Errors
    /// See [`Self::write`].
    #[wasm_bindgen(js_name = writeProject)]
    pub fn write_project(&mut self, face: Ts<FaceRequest>) -> Result<Vec<u8>> {
        self.mesh(&received(&face)?)?.write_project().map_err(error::of_request)
    }

    /// The body for printing and its measures, before it is written; undefined if only the surface is exported.
    ///
    /// # Errors
    /// See [`Self::write`].
    pub fn print(&self, face: Ts<FaceRequest>, options: Ts<FileOptions>) -> Result<Option<Ts<PrintedBody>>> {
        let (face, rosto::FileOptions { print, .. }) = (received(&face)?, received(&options)?.read()?);
        let mesh = FaceMesh::reopen(saved(&face)?).map_err(error::of_request)?;
        let printed = mesh.printed(print).map_err(error::of_request)?;
        printed.map(|printed| sent(&PrintedBody::of(&printed, print.solid))).transpose()
    }

    /// Creates the paper's experiment on the unedited face: `runs` random choices of vertices and anchors per method,
    /// with seeds from `seed`.
    ///
    /// # Errors
    /// Throws `bad-face` or `cannot-solve`.
    pub fn paper(&self, face: Ts<FaceRequest>, runs: u32, seed: u32) -> Result<PaperRun> {
        let face = FaceModel::from_photos(saved(&received(&face)?)?.photos, Triangulation::Tessellation);
        PaperRun::new(&face.map_err(|reason| error::of_request(reason.into()))?, runs.max(1), seed)
    }

    /// Applies the edits to the lead photo, in any size (the bytes of a JPEG, PNG or WebP file). `falloff_band` is the
    /// width of the band in which the warp fades out, as a share of the face's longer side.
    ///
    /// # Errors
    /// Throws an error of the photo as in [`Self::open`], or of the face as in [`Self::write`].
    #[wasm_bindgen(js_name = editedPhoto)]
    pub fn edited_photo(
        &self,
        face: Ts<FaceRequest>,
        bytes: &[u8],
        #[wasm_bindgen(js_name = falloffBand)] falloff_band: f64,
    ) -> Result<Ts<RawPicture>> {
        let saved = saved(&received(&face)?)?;
        let edit = saved.edits.as_ref().and_then(|edits| edits.photo_edit.as_deref());
        let edit = edit.map(PhotoEdit::from_json).transpose().map_err(error::of_request)?.unwrap_or_default();
        let mesh = FaceMesh::reopen(saved).map_err(error::of_request)?;
        let photo = decode(bytes, &Limits::default()).map_err(error::of_photo)?;
        let request = PhotoRequest { photo: &photo, mesh: &mesh, falloff_band, edit };
        sent(&RawPicture::of(&request.image().map_err(error::of_request)?.photo))
    }

    /// Follows a face into the next frame of a camera stream. Returns its 478 × (x/W, y/H, z/W), smoothed over time, or
    /// `undefined` without a face. `rgba` is the frame row by row; alpha is ignored. `time_ms` is the frame's time, from
    /// any origin.
    ///
    /// # Errors
    /// Throws `damaged-picture` if there are not four bytes per pixel, `networks-damaged` or `internal`.
    pub fn follow(
        &mut self,
        rgba: &[u8],
        width: u32,
        height: u32,
        #[wasm_bindgen(js_name = time_ms)] time_ms: f64,
    ) -> Result<Option<Vec<f32>>> {
        let frame = Photo::from_rgbx(width, height, rgba).map_err(error::of_photo)?;
        let finder = self.finder.as_ref().ok_or_else(no_networks)?;
        let face = finder.follow(&mut self.follower, &frame, time_ms).map_err(error::of_landmarks)?;
        Ok(face.map(|face| face.landmarks.concat()))
    }

    /// Forgets the followed face, before another camera stream.
    #[wasm_bindgen(js_name = stopFollowing)]
    pub fn stop_following(&mut self) {
        self.follower = Follower::default();
    }
}

impl Vision {
    fn find(&self, photo: &Photo, max_faces: u32, progress: &Progress<'_>) -> Result<Vec<rosto_landmarks::Face>> {
        let finder = self.finder.as_ref().ok_or_else(no_networks)?;
        let options = FindOptions { max_faces: max_faces as usize, ..FindOptions::default() };
        let found = finder.find_with_progress(photo, &options, |stage| progress.report(Step::Finding(stage)));
        Ok(found.map_err(error::of_landmarks)?.faces)
    }

    /// The face of a request, with its pictures and the texture made for them before.
    fn mesh(&mut self, face: &FaceRequest) -> Result<FaceMesh> {
        let mut saved = saved(face)?;
        self.pictures.give(&face.pictures, &mut saved.photos)?;
        let texture = self
            .texture
            .as_ref()
            .filter(|((photos, pictures), _)| (photos, pictures) == (&face.photos, &face.pictures));
        let mesh = FaceMesh::reopen(saved).map_err(error::of_request)?;
        Ok(mesh.with_texture(texture.map(|(_, texture)| texture.clone())))
    }

    fn keep_texture(&mut self, face: FaceRequest, mesh: FaceMesh) {
        if let Some(texture) = mesh.into_texture() {
            self.texture = Some(((face.photos, face.pictures), texture));
        }
    }
}

/// The face of a request, without pictures.
fn saved(face: &FaceRequest) -> Result<SavedFace> {
    SavedFace::from_json(&face.photos, face.edits.as_deref()).map_err(|reason| error::of_request(reason.into()))
}

fn no_networks() -> Error {
    error::internal("the networks are not loaded")
}
