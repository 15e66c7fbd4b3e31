//! Bodies of surfaces that are smoothed where sharp folds leave no room for a wall.

use glam::DVec3;
use rosto_mesh::Surface;

use crate::body::check;
use crate::front::Front;
use crate::{Body, Closing, SolidError, wall};

/// Distances from tight folds within which the surface is replaced by the smoothed one, in thicknesses, tried in turn.
/// New tight folds are added as they are found.
const WITHIN: [f64; 6] = [0.5, 0.5, 1.0, 1.0, 2.0, 4.0];

/// The same for a wall that is only just stable.
const STABLE_WITHIN: [f64; 2] = [0.5, 2.0];

/// Smallest thickness of a stable wall, relative to the requested one.
const STABLE: f64 = 0.5;

/// A surface and its smoothed version.
struct Smoothing<'a> {
    original: Surface<'a>,
    smoothed: &'a [DVec3],
    thickness_m: f64,
}

impl Body {
    /// Like [`Self::closed`], but uses a smoothed surface with the same triangles where sharp folds leave no room for a
    /// wall: around the folds if that is enough, otherwise everywhere ([`Self::moved_m`]).
    ///
    /// # Errors
    /// [`SolidError`] if neither surface can be closed.
    ///
    /// # Panics
    /// If there is not one smoothed position per vertex.
    pub fn closed_or_smoothed(surface: Surface<'_>, smoothed: &[DVec3], closing: Closing) -> Result<Self, SolidError> {
        let own = surface.positions();
        assert_eq!(smoothed.len(), own.len(), "one smoothed position per vertex");
        if smoothed == own {
            return Self::closed(surface, closing);
        }
        let whole = || Self::closed(Surface::new(surface.topology(), smoothed)?, closing);
        let body = match closing {
            Closing::Thickness { thickness_m } => {
                check(thickness_m)?;
                let smoothing = Smoothing { original: surface, smoothed, thickness_m };
                // The error of the smoothed surface, on which a larger thickness fits.
                let whole = || whole().or_else(|error| smoothing.unsmoothed().ok_or(error));
                smoothing.walled().map_or_else(whole, Ok)
            }
            Closing::FlatBack { .. } => Self::closed(surface, closing).or_else(|_| whole()),
        }?;
        Ok(body.moved_from(own))
    }
}

impl Smoothing<'_> {
    /// Smooths as little as leaves a wall of good thickness or, failing that, a stable one.
    fn walled(&self) -> Option<Body> {
        let mut tight = match self.well_walled(self.original.positions()).ok()? {
            Ok(body) => return Some(body),
            Err(tight) => tight,
        };
        for within in WITHIN {
            match self.well_walled(&self.blended(&tight, within)) {
                Ok(Ok(body)) => return Some(body),
                Ok(Err(new)) => tight.iter_mut().zip(new).for_each(|(tight, new)| *tight |= new),
                Err(_) => {}
            }
        }
        let is_stable = |body: &Body| body.thinnest_m() >= STABLE * self.thickness_m;
        STABLE_WITHIN.into_iter().find_map(|within| self.closed(&self.blended(&tight, within)).ok().filter(is_stable))
    }

    /// Closes the surface as it is, with a wall of any thickness.
    fn unsmoothed(&self) -> Option<Body> {
        let front = Front::new(self.original).ok()?;
        let back = wall::back(&front, self.thickness_m)?;
        Body::with_back(front, back, self.thickness_m).ok()
    }

    fn closed(&self, positions: &[DVec3]) -> Result<Body, SolidError> {
        let closing = Closing::Thickness { thickness_m: self.thickness_m };
        Body::closed(Surface::new(self.original.topology(), positions)?, closing)
    }

    /// Closes the surface with a wall of good thickness; otherwise returns the vertices behind which there is no room.
    fn well_walled(&self, positions: &[DVec3]) -> Result<Result<Body, Vec<bool>>, SolidError> {
        let front = Front::new(Surface::new(self.original.topology(), positions)?)?;
        Ok(match wall::good_back(&front, self.thickness_m) {
            Ok(back) => Ok(Body::with_back(front, back, self.thickness_m)?),
            Err(tight) => Err(tight),
        })
    }

    /// Blends in the smoothed surface: fully within `within` thicknesses of marked vertices, not at all beyond three
    /// times that.
    fn blended(&self, marked: &[bool], within: f64) -> Vec<DVec3> {
        let (own, within_m) = (self.original.positions(), within * self.thickness_m);
        let marked: Vec<DVec3> =
            own.iter().zip(marked).filter(|(_, marked)| **marked).map(|(position, _)| *position).collect();
        let share = |position: &DVec3| {
            let distance_m = marked.iter().map(|other| other.distance(*position)).fold(f64::INFINITY, f64::min);
            let near = ((3.0 - distance_m / within_m) / 2.0).clamp(0.0, 1.0);
            near * near * (3.0 - 2.0 * near)
        };
        own.iter().zip(self.smoothed).map(|(own, smoothed)| own.lerp(*smoothed, share(own))).collect()
    }
}
