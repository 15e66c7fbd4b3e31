//! A body of a surface that gives way where sharp folds leave no room for a wall behind them.

use glam::DVec3;
use rosto_mesh::Surface;

use crate::body::check;
use crate::front::Front;
use crate::{Body, Closing, SolidError, wall};

/// Where there is no room for a wall, all of the softer surface is taken within so many thicknesses, one after the other until
/// there is; where there still is none, from then on, too.
const WITHIN: [f64; 6] = [0.5, 0.5, 1.0, 1.0, 2.0, 4.0];

/// The same for a wall that is firm and no more.
const FIRM_WITHIN: [f64; 2] = [0.5, 2.0];

/// A wall that is nowhere thinner than this share of what was asked for is firm.
const FIRM: f64 = 0.5;

/// A surface as it is, and the same softer.
struct Softening<'a> {
    firm: Surface<'a>,
    softer: &'a [DVec3],
    thickness_m: f64,
}

impl Body {
    /// As [`Self::closed`]; where sharp folds leave no room for a wall behind them, the surface gives way to a softer one of the
    /// same triangles: around the folds if that is enough, else everywhere ([`Self::moved_m`]).
    ///
    /// # Errors
    /// [`SolidError`] if neither can be closed so.
    ///
    /// # Panics
    /// If the softer surface has not one position for each vertex.
    pub fn closed_or_smoothed(surface: Surface<'_>, softer: &[DVec3], closing: Closing) -> Result<Self, SolidError> {
        let own = surface.positions();
        assert_eq!(softer.len(), own.len(), "one softer place for each vertex");
        if softer == own {
            return Self::closed(surface, closing);
        }
        let whole = || Self::closed(Surface::new(surface.topology(), softer)?, closing);
        let body = match closing {
            Closing::Thickness { thickness_m } => {
                check(thickness_m)?;
                let partly = Softening { firm: surface, softer, thickness_m }.walled();
                partly.map_or_else(|| whole().or_else(|_| Self::closed(surface, closing)), Ok)
            }
            Closing::FlatBack { .. } => Self::closed(surface, closing).or_else(|_| whole()),
        }?;
        Ok(body.moved_from(own))
    }
}

impl Softening<'_> {
    /// The body with as little softened as leaves a good wall or, where there can be none, a firm one.
    fn walled(&self) -> Option<Body> {
        let mut tight = match self.well_walled(self.firm.positions()).ok()? {
            Ok(body) => return Some(body),
            Err(tight) => tight,
        };
        for within in WITHIN {
            match self.well_walled(&self.softened(&tight, within)) {
                Ok(Ok(body)) => return Some(body),
                Ok(Err(still)) => tight.iter_mut().zip(still).for_each(|(tight, still)| *tight |= still),
                Err(_) => {}
            }
        }
        let is_firm = |body: &Body| body.thinnest_m() >= FIRM * self.thickness_m;
        FIRM_WITHIN.into_iter().find_map(|within| self.closed(&self.softened(&tight, within)).ok().filter(is_firm))
    }

    fn closed(&self, positions: &[DVec3]) -> Result<Body, SolidError> {
        let closing = Closing::Thickness { thickness_m: self.thickness_m };
        Body::closed(Surface::new(self.firm.topology(), positions)?, closing)
    }

    /// With a wall that is thick enough everywhere; else the vertices behind which there is no room for one.
    fn well_walled(&self, positions: &[DVec3]) -> Result<Result<Body, Vec<bool>>, SolidError> {
        let front = Front::new(Surface::new(self.firm.topology(), positions)?)?;
        Ok(match wall::good_back(&front, self.thickness_m) {
            Ok(back) => Ok(Body::with_back(front, back)?),
            Err(tight) => Err(tight),
        })
    }

    /// The softer surface within so many thicknesses of vertices that are marked, none of it three times as far away.
    fn softened(&self, marked: &[bool], within: f64) -> Vec<DVec3> {
        let (own, within_m) = (self.firm.positions(), within * self.thickness_m);
        let marked: Vec<DVec3> =
            own.iter().zip(marked).filter(|(_, marked)| **marked).map(|(place, _)| *place).collect();
        let share = |place: &DVec3| {
            let distance_m = marked.iter().map(|other| other.distance(*place)).fold(f64::INFINITY, f64::min);
            let near = ((3.0 - distance_m / within_m) / 2.0).clamp(0.0, 1.0);
            near * near * (3.0 - 2.0 * near)
        };
        own.iter().zip(self.softer).map(|(own, softer)| own.lerp(*softer, share(own))).collect()
    }
}
