use glam::DVec2;
use rosto_face::{Camera, LANDMARK_COUNT, lids_of};
use rosto_studio::{DEFAULT_FALLOFF_BAND, PhotoWarp};
use rosto_warp::{Dab, WarpMesh};

use super::OpenFace;
use crate::strokes::Strokes;

/// What is chosen of how a face's edits show in its photo, and the warp that shows them.
pub struct PhotoEdit {
    pub(super) seen_from_m: Option<f64>,
    pub(super) strokes: Strokes,
    falloff_band: f64,
    warp: Option<PhotoWarp>,
    /// Counts the warps that were made: whoever shows one knows by it whether it is another.
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
    /// For another photo of the same face.
    pub(super) fn of_next_photo(before: &Self) -> Self {
        Self { falloff_band: before.falloff_band, version: before.version, ..Self::default() }
    }

    /// From how far away the face is shown in its photo, in metres, if that is not how it was taken.
    pub fn seen_from_m(&self) -> Option<f64> {
        self.seen_from_m
    }

    /// What of the photo is kept as it is.
    pub fn strokes(&self) -> &Strokes {
        &self.strokes
    }

    /// How far around the face the photo gives way, as a share of the face's longer side.
    pub fn falloff_band(&self) -> f64 {
        self.falloff_band
    }

    /// What moves in the photo, in its px, and the number of the warp; none before the first [`OpenFace::follow_in_photo`], or
    /// where nothing of the face is in its photo.
    pub fn warp_mesh(&self) -> Option<(&WarpMesh, u32)> {
        self.warp.as_ref().map(|warp| (warp.warp_mesh(), self.version))
    }

    /// Whether the next [`OpenFace::follow_in_photo`] has to factor anew.
    pub fn waits(&self) -> bool {
        self.is_stale
    }

    /// By how much the photo stays behind the mesh at most, in px of the photo, so that nothing in it folds.
    pub fn limited_px(&self) -> f64 {
        self.warp.as_ref().map_or(0.0, PhotoWarp::limited_px)
    }

    /// The mesh or its camera is another one.
    pub(super) fn forget(&mut self) {
        self.is_stale = true;
    }
}

/// The face in its photo.
impl OpenFace {
    /// How the edits show in the photo.
    pub fn photo(&self) -> &PhotoEdit {
        &self.photo
    }

    /// The camera that sees the face as the photo shows it.
    pub fn seen_by(&self) -> Camera {
        self.photo.seen_from_m.map_or(*self.model.camera(), |distance_m| self.model.seen_from(distance_m))
    }

    /// Lets the photo follow the edits and the edit in progress: a back-substitution for each axis. The first time, and whenever
    /// the mesh, the falloff band or what is kept is another, a factorisation.
    pub fn follow_in_photo(&mut self) {
        if std::mem::take(&mut self.photo.is_stale) {
            let kept: Vec<Dab> = self.photo.strokes.dabs().copied().collect();
            // A face beside its photo leads nothing in it.
            self.photo.warp = PhotoWarp::new(&self.model, &self.document, self.photo.falloff_band, &kept).ok();
            self.photo.version += 1;
        }
        let seen_by = self.seen_by();
        if let Some(warp) = &mut self.photo.warp {
            warp.follow(self.document.rest(), self.document.positions(), self.model.camera(), &seen_by);
        }
    }

    /// Where the landmarks, and the irises if they were found, are in the photo as the edits show in it: shares of its size. The
    /// irises go along with their lids.
    pub fn landmarks_in_photo(&self) -> Vec<DVec2> {
        let size_px = DVec2::from(self.model.photo_size_px().map(f64::from));
        let (taken_by, seen_by) = (self.model.camera(), self.seen_by());
        let rest = &self.document.rest()[..LANDMARK_COUNT];
        let way = |vertex: usize| {
            let places = (taken_by.project(rest[vertex]), seen_by.project(self.document.positions()[vertex]));
            places.0.zip(places.1).map_or(DVec2::ZERO, |(before, after)| after - before) / size_px
        };
        let found = self.model.landmarks();
        let taken = |point: usize| DVec2::new(found[point][0].into(), found[point][1].into());
        (0..found.len())
            .map(|point| match point.checked_sub(LANDMARK_COUNT) {
                None => taken(point) + way(point),
                Some(iris) => taken(point) + 0.5 * lids_of(iris).map(way).into_iter().sum::<DVec2>(),
            })
            .collect()
    }

    pub(crate) fn set_falloff_band(&mut self, falloff_band: f64) {
        if self.photo.falloff_band != falloff_band {
            self.photo.falloff_band = falloff_band;
            self.photo.forget();
        }
    }

    pub(crate) fn set_seen_from(&mut self, distance_m: Option<f64>) {
        self.photo.seen_from_m = distance_m;
    }

    /// Changes what is kept of the photo.
    pub(crate) fn change_strokes(&mut self, change: impl FnOnce(&mut Strokes)) {
        change(&mut self.photo.strokes);
        self.photo.forget();
    }

    /// Data of the photo alone, as written by [`Self::photo_json`].
    pub(crate) fn restore_photo(&mut self, seen_from_m: Option<f64>, strokes: Strokes) {
        (self.photo.seen_from_m, self.photo.strokes) = (seen_from_m, strokes);
        self.photo.forget();
    }
}
