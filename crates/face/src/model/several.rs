//! One shape to several photos of one face.
//!
//! The photo in which the face looks at its camera the most leads: its landmarks stay on their rays, and the others tell how
//! deep they lie there.

mod beside;
mod drawn;
mod habits;
mod joint;
mod seat;
mod trust;

use super::fitting::{Fitted, Sight};
use crate::camera::Camera;
use crate::{FaceError, PhotoLens};
use beside::Beside;
use drawn::Rays;
pub use habits::drawn_out_m;
use joint::Joint;

/// What is known of one photo.
#[derive(Debug, Clone, Copy)]
pub(super) struct Known<'a> {
    pub(super) landmarks: &'a [[f32; 3]],
    pub(super) size_px: [u32; 2],
    pub(super) lens: PhotoLens,
}

/// How well a shape agrees with a photo: the distances in px between where its camera sees the landmarks that face it and
/// where they were found.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Reprojection {
    /// The root of the mean of their squares.
    pub rms_px: f64,
    /// Half of them are smaller.
    pub median_px: f64,
}

/// A photo that was left out: how well the shape that the others make agrees with it, with the camera put where it agrees best.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LeftOut {
    /// Which of the photos, in the order they were given in.
    pub photo: usize,
    /// The shape by the one that leads the others alone.
    pub by_one: Reprojection,
    /// The shape by all others.
    pub by_others: Reprojection,
}

/// The shape, and what sees it.
pub(super) struct Together {
    /// Which photo leads.
    pub(super) lead: usize,
    pub(super) fitted: Fitted,
    /// The cameras of the others, in the order that they were given in.
    pub(super) others: Vec<(usize, Camera, Reprojection)>,
}

/// A shape by some of the photos.
struct Shape {
    lead: usize,
    fitted: Fitted,
    /// What the others see of it, each with its number.
    others: Vec<(usize, Beside)>,
}

/// The photos as each shows the face alone.
struct Photos<'a> {
    known: &'a [Known<'a>],
    sights: Vec<Sight>,
    alone: Vec<Fitted>,
}

/// A photo whose face is as small as this beside the largest does not lead.
const SMALL: f64 = 0.5;
/// A face that seems to be off by so much in one photo, as a share of its size, is another one.
const MOST_APART_M: f64 = 0.006;

/// Fits one shape to 1 to [`MOST_PHOTOS`](crate::MOST_PHOTOS) photos.
pub(super) fn together(known: &[Known<'_>]) -> Result<Together, FaceError> {
    let photos = Photos::new(known)?;
    let all: Vec<usize> = (0..known.len()).collect();
    let Shape { lead, fitted, others } = photos.fit(&all)?;
    let drawn_m = Rays::of(&fitted).drawn_m();
    let others = others.into_iter().map(|(photo, beside)| {
        let reprojection = beside.reprojection(&drawn_m);
        let apart_m = reprojection.median_px / beside.seat.px_per_m;
        if apart_m > MOST_APART_M {
            let most_px = MOST_APART_M * beside.seat.px_per_m;
            return Err(FaceError::AnotherFace { photo, reprojection_px: reprojection.median_px, most_px });
        }
        let lens = photos.alone[photo].camera.lens;
        Ok((photo, beside.seat.camera(known[photo].size_px, lens, fitted.scale.error), reprojection))
    });
    let others = others.collect::<Result<_, _>>()?;
    Ok(Together { lead, fitted, others })
}

/// Leaves out each photo in turn; nothing where there are fewer than three, since the others then are one.
pub(super) fn left_out(known: &[Known<'_>]) -> Result<Vec<LeftOut>, FaceError> {
    if known.len() < 3 {
        return Ok(Vec::new());
    }
    let photos = Photos::new(known)?;
    (0..known.len()).map(|photo| photos.left_out(photo)).collect()
}

impl<'a> Photos<'a> {
    fn new(known: &'a [Known<'a>]) -> Result<Self, FaceError> {
        let in_photo = |photo| move |reason| FaceError::InPhoto { photo, reason: Box::new(reason) };
        let sight = |(photo, of): (usize, &Known<'_>)| Sight::new(of.landmarks, of.size_px).map_err(in_photo(photo));
        let sights: Vec<Sight> = known.iter().enumerate().map(sight).collect::<Result<_, _>>()?;
        let alone = sights.iter().zip(known).enumerate();
        let alone = alone.map(|(photo, (sight, of))| sight.fitted(of.lens).map_err(in_photo(photo)));
        Ok(Self { known, alone: alone.collect::<Result<_, _>>()?, sights })
    }

    /// The one of them that looks at its camera the most; the first of those that do alike.
    fn lead(&self, of: &[usize]) -> usize {
        let largest = of.iter().map(|&photo| self.sights[photo].frontal().1).fold(0.0, f64::max);
        let frontal = |photo: usize| match self.sights[photo].frontal() {
            (_, size) if size < SMALL * largest => f64::NEG_INFINITY,
            (frontal, _) => frontal,
        };
        of.iter().copied().reduce(|best, photo| if frontal(photo) > frontal(best) { photo } else { best }).unwrap_or(0)
    }

    /// The shape by these photos, by the one of them that leads, and the others' views of it.
    fn fit(&self, of: &[usize]) -> Result<Shape, FaceError> {
        const ROUNDS: usize = 3;
        let lead = self.lead(of);
        let sight = &self.sights[lead];
        let others: Vec<usize> = of.iter().copied().filter(|&photo| photo != lead).collect();
        let mut alone = self.alone[lead].clone();
        let mut shape = alone.clone();
        if others.is_empty() {
            return Ok(Shape { lead, fitted: shape, others: Vec::new() });
        }
        for _ in 0..ROUNDS {
            let rays = Rays::of(&alone);
            let mut besides = self.besides(&others, &alone)?;
            let nearer_m = Joint::new(&rays)?.settle(&mut besides)?;
            shape = sight.nearer(&alone, &nearer_m)?;
            let again = sight.as_large_as(&shape, &alone)?;
            if again.camera.focal_px == alone.camera.focal_px {
                break;
            }
            alone = again;
        }
        let mut besides = self.besides(&others, &shape)?;
        let drawn_m = Rays::of(&shape).drawn_m();
        besides.iter_mut().try_for_each(|beside| beside.settle(&drawn_m))?;
        Ok(Shape { lead, fitted: shape, others: others.into_iter().zip(besides).collect() })
    }

    /// The others before a shape, each direction counted once.
    fn besides(&self, others: &[usize], shape: &Fitted) -> Result<Vec<Beside>, FaceError> {
        let mut besides = others.iter().map(|&photo| self.beside(photo, shape)).collect::<Result<Vec<_>, _>>()?;
        beside::share_directions(&mut besides);
        Ok(besides)
    }

    fn beside(&self, photo: usize, shape: &Fitted) -> Result<Beside, FaceError> {
        let of = self.known[photo];
        Beside::new(&self.alone[photo], of.landmarks, of.size_px, shape)
    }

    fn left_out(&self, photo: usize) -> Result<LeftOut, FaceError> {
        let others: Vec<usize> = (0..self.known.len()).filter(|&other| other != photo).collect();
        let Shape { lead, fitted, .. } = self.fit(&others)?;
        let seen = |shape: &Fitted| {
            let mut beside = self.beside(photo, shape)?;
            let drawn_m = Rays::of(shape).drawn_m();
            beside.settle(&drawn_m)?;
            Ok(beside.reprojection(&drawn_m))
        };
        Ok(LeftOut { photo, by_one: seen(&self.alone[lead])?, by_others: seen(&fitted)? })
    }
}
