use glam::DVec2;
use rosto_face::{Camera, LANDMARK_COUNT, lids_of};
use rosto_studio::{DEFAULT_FALLOFF_BAND, PhotoWarp};
use rosto_warp::{Dab, WarpMesh};

use super::OpenFace;
use crate::strokes::Strokes;

/// Settings of the edits in the photo, and the warp that shows them.
pub struct PhotoEdit {
    pub(super) seen_from_m: Option<f64>,
    pub(super) strokes: Strokes,
    falloff_band: f64,
    warp: Option<PhotoWarp>,
    /// Incremented with each new warp, so that callers can detect a change.
    version: u32,
    is_stale: bool,
}

impl Default for PhotoEdit {
    fn default() -> Self {
        Self {
            seen_from_m: None,
            strokes: Strokes::default(),
            falloff_band: DEFAULT_FALLOFF_BAND,
            warp: None,
            version: 0,
            is_stale: true,
        }
    }
}

impl PhotoEdit {
    /// The initial state for another photo of the same face.
    pub(super) fn of_next_photo(before: &Self) -> Self {
        Self { falloff_band: before.falloff_band, version: before.version, ..Self::default() }
    }

    /// View distance of the photo in metres; `None` is the original distance.
    pub fn seen_from_m(&self) -> Option<f64> {
        self.seen_from_m
    }

    /// The protected parts of the photo.
    pub fn strokes(&self) -> &Strokes {
        &self.strokes
    }

    /// Falloff band around the face, as a share of the face's longer side.
    pub fn falloff_band(&self) -> f64 {
        self.falloff_band
    }

    /// The moved part of the photo, in its px, and the version of the warp. `None` before the first
    /// [`OpenFace::update_photo_warp`], or if too little of the face is in its photo.
    pub fn warp_mesh(&self) -> Option<(&WarpMesh, u32)> {
        self.warp.as_ref().map(|warp| (warp.warp_mesh(), self.version))
    }

    /// Whether the next [`OpenFace::update_photo_warp`] needs a factorisation.
    pub fn needs_factorisation(&self) -> bool {
        self.is_stale
    }

    /// Greatest distance, in px of the photo, by which the photo lags behind the mesh to avoid folds.
    pub fn limited_px(&self) -> f64 {
        self.warp.as_ref().map_or(0.0, PhotoWarp::limited_px)
    }

    /// Marks the warp as stale after a change of the mesh or its camera.
    pub(super) fn invalidate(&mut self) {
        self.is_stale = true;
    }
}

/// The face in its photo.
impl OpenFace {
    /// The photo edit.
    pub fn photo(&self) -> &PhotoEdit {
        &self.photo
    }

    /// The camera from which the photo is shown.
    pub fn seen_by(&self) -> Camera {
        self.photo.seen_from_m.map_or(*self.model.camera(), |distance_m| self.model.seen_from(distance_m))
    }

    /// Updates the photo's warp to the current edits: one solve per axis. The first update, and one after a
    /// change of the mesh, the falloff band or the strokes, needs a factorisation.
    pub fn update_photo_warp(&mut self) {
        if std::mem::take(&mut self.photo.is_stale) {
            let protected: Vec<Dab> = self.photo.strokes.dabs().copied().collect();
            // A face outside its photo does not drive a warp.
            self.photo.warp = PhotoWarp::new(&self.model, &self.document, self.photo.falloff_band, &protected).ok();
            self.photo.version += 1;
        }
        let seen_by = self.seen_by();
        if let Some(warp) = &mut self.photo.warp {
            warp.follow(self.document.rest(), self.document.positions(), self.model.camera(), &seen_by);
        }
    }

    /// Positions of the landmarks, and of the irises if found, in the edited photo, as shares of its size. Irises move
    /// with their lids.
    pub fn landmarks_in_edited_photo(&self) -> Vec<DVec2> {
        let size_px = DVec2::from(self.model.photo_size_px().map(f64::from));
        let (original, seen_by) = (self.model.camera(), self.seen_by());
        let rest = &self.document.rest()[..LANDMARK_COUNT];
        let displacement = |vertex: usize| {
            let positions = (original.project(rest[vertex]), seen_by.project(self.document.positions()[vertex]));
            positions.0.zip(positions.1).map_or(DVec2::ZERO, |(before, after)| after - before) / size_px
        };
        let found = self.model.landmarks();
        let detected = |point: usize| DVec2::new(found[point][0].into(), found[point][1].into());
        (0..found.len())
            .map(|point| match point.checked_sub(LANDMARK_COUNT) {
                None => detected(point) + displacement(point),
                Some(iris) => detected(point) + 0.5 * lids_of(iris).map(displacement).into_iter().sum::<DVec2>(),
            })
            .collect()
    }

    pub(crate) fn set_falloff_band(&mut self, falloff_band: f64) {
        if self.photo.falloff_band != falloff_band {
            self.photo.falloff_band = falloff_band;
            self.photo.invalidate();
        }
    }

    pub(crate) fn set_seen_from(&mut self, distance_m: Option<f64>) {
        self.photo.seen_from_m = distance_m;
    }

    /// Changes the strokes that protect the photo.
    pub(crate) fn change_strokes(&mut self, change: impl FnOnce(&mut Strokes)) {
        change(&mut self.photo.strokes);
        self.photo.invalidate();
    }

    /// The edits of the photo alone, for files; `None` if there are none.
    pub(crate) fn saved_photo_edit(&self) -> Option<rosto::PhotoEdit> {
        let PhotoEdit { seen_from_m, strokes, .. } = &self.photo;
        let edit = rosto::PhotoEdit { seen_from_m: *seen_from_m, strokes: strokes.done().to_vec() };
        (edit != rosto::PhotoEdit::default()).then_some(edit)
    }

    pub(crate) fn restore_photo_edit(&mut self, edit: rosto::PhotoEdit) {
        self.restore_photo(edit.seen_from_m, Strokes::new(edit.strokes));
    }

    /// Restores view distance and strokes.
    pub(super) fn restore_photo(&mut self, seen_from_m: Option<f64>, strokes: Strokes) {
        (self.photo.seen_from_m, self.photo.strokes) = (seen_from_m, strokes);
        self.photo.invalidate();
    }
}
