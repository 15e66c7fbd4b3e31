use glam::{DVec2, DVec3};
use rosto_laplacian::{Continuation, Operator};
use rosto_mesh::Topology;

use crate::coarse::Coarse;
use crate::folds::Unfolding;
use crate::layout::{Layout, Tie};
use crate::{Subject, WarpError};

/// A picture that follows points in it. Made once for where the points are; [`Self::follow`] is what a slider's tick costs.
pub struct Warp {
    warp_mesh: WarpMesh,
    ties: Vec<Tie>,
    surroundings: Option<Surroundings>,
    coarse: Coarse,
    unfolding: Unfolding,
    /// No offset is longer than the picture's diagonal: its squares stay finite.
    longest_px: f64,
    offsets_px: Vec<DVec2>,
    limited_px: f64,
}

/// The part of a picture that moves, as triangles. What lies outside of them stays.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct WarpMesh {
    /// Where its points are in the picture, in px.
    pub from_px: Vec<DVec2>,
    /// Where they go.
    pub to_px: Vec<DVec2>,
    /// Its triangles, which cover each place once, before and after.
    pub triangles: Vec<[u32; 3]>,
}

/// The part of the triangulation that gives way, with as much of what is known around it as it takes to go on smoothly.
struct Surroundings {
    /// Points of the warp mesh.
    points: Vec<u32>,
    /// Indices into `points` of those that know where they go.
    known: Vec<u32>,
    continuation: Continuation,
    known_values: Vec<f64>,
    values: Vec<f64>,
}

impl Warp {
    /// Lays the triangulation over the picture and factors what gives way.
    ///
    /// # Errors
    /// [`WarpError::TooFewPoints`] or [`WarpError::FalloffBand`].
    pub fn new(subject: &Subject<'_>) -> Result<Self, WarpError> {
        let layout = Layout::of(subject)?;
        let coarse = Coarse::new(&layout);
        let Layout { points, ties, triangles, .. } = layout;
        let topology = Topology::new(points.len(), triangles)?;
        let surroundings = Surroundings::new(&topology, &points, &ties)?;
        let unfolding = Unfolding::new(topology.triangles(), &points, &ties);
        let warp_mesh = WarpMesh { to_px: points.clone(), from_px: points, triangles: topology.triangles().to_vec() };
        let offsets_px = vec![DVec2::ZERO; ties.len()];
        let longest_px = DVec2::from(subject.size_px.map(f64::from)).length();
        Ok(Self { warp_mesh, ties, surroundings, coarse, unfolding, longest_px, offsets_px, limited_px: 0.0 })
    }

    /// Lets each of the subject's points go to its target, in px of the picture. One whose target is no place stays.
    ///
    /// # Panics
    /// If there is not one target for each of the subject's points.
    pub fn follow(&mut self, points_px: &[DVec2], targets_px: &[DVec2]) {
        self.lead(points_px, targets_px);
        self.limited_px = 0.0;
        if self.unfolding.folds(&self.offsets_px) {
            self.coarse.unfold(&mut self.offsets_px);
            self.unfolding.limit(&mut self.offsets_px);
            self.limited_px = self.behind_px(points_px, targets_px);
        }
        self.put();
    }

    /// The same, but what lies between may fold: for a picture in which the points have gone there already.
    ///
    /// # Panics
    /// As [`Self::follow`].
    pub fn carry(&mut self, points_px: &[DVec2], targets_px: &[DVec2]) {
        self.lead(points_px, targets_px);
        self.limited_px = 0.0;
        self.put();
    }

    fn lead(&mut self, points_px: &[DVec2], targets_px: &[DVec2]) {
        assert_eq!(points_px.len(), targets_px.len(), "one target for each point");
        for at in 0..self.ties.len() {
            self.offsets_px[at] = self.wanted(self.ties[at], points_px, targets_px).unwrap_or_default();
        }
        if let Some(surroundings) = &mut self.surroundings {
            surroundings.give_way(&mut self.offsets_px);
        }
    }

    /// The longest way by which a point that leads stays behind the one that it was to go.
    fn behind_px(&self, points_px: &[DVec2], targets_px: &[DVec2]) -> f64 {
        let behind = |(offset, tie): (&DVec2, &Tie)| Some(self.wanted(*tie, points_px, targets_px)?.distance(*offset));
        self.offsets_px.iter().zip(&self.ties).filter_map(behind).fold(0.0, f64::max)
    }

    /// None of what nobody leads.
    fn wanted(&self, tie: Tie, points_px: &[DVec2], targets_px: &[DVec2]) -> Option<DVec2> {
        match tie {
            Tie::Follows { point, share } => {
                Some(bounded(targets_px[point] - points_px[point], self.longest_px) * share)
            }
            Tie::Stays | Tie::Free => None,
        }
    }

    fn put(&mut self) {
        for ((to, from), offset) in self.warp_mesh.to_px.iter_mut().zip(&self.warp_mesh.from_px).zip(&self.offsets_px) {
            *to = *from + *offset;
        }
    }

    /// The part of the picture that moves.
    pub fn warp_mesh(&self) -> &WarpMesh {
        &self.warp_mesh
    }

    /// By how much a point stays behind where it was to go at most, in px, so that nothing folds. What lies beside what stays
    /// was to go less far.
    pub fn limited_px(&self) -> f64 {
        self.limited_px
    }
}

impl WarpMesh {
    /// The same in a part of the picture that begins at a place of it and is so many times as large.
    pub fn cut(&self, corner_px: DVec2, scale: f64) -> Self {
        let cut = |places: &[DVec2]| places.iter().map(|place| (*place - corner_px) * scale).collect();
        Self { from_px: cut(&self.from_px), to_px: cut(&self.to_px), triangles: self.triangles.clone() }
    }
}

impl Surroundings {
    /// None where nothing gives way.
    fn new(topology: &Topology, points: &[DVec2], ties: &[Tie]) -> Result<Option<Self>, WarpError> {
        let is_free: Vec<bool> = ties.iter().map(|tie| *tie == Tie::Free).collect();
        if !is_free.contains(&true) {
            return Ok(None);
        }
        let is_near = grown(topology, &grown(topology, &is_free));
        let near: Vec<u32> = (0..points.len() as u32).filter(|&point| is_near[point as usize]).collect();
        let mut place_of = vec![u32::MAX; points.len()];
        near.iter().zip(0..).for_each(|(&point, place)| place_of[point as usize] = place);
        let inside =
            topology.triangles().iter().filter(|corners| corners.iter().all(|&corner| is_near[corner as usize]));
        let triangles = inside.map(|corners| corners.map(|corner| place_of[corner as usize])).collect();
        let part = Topology::new(near.len(), triangles)?;
        let places: Vec<DVec3> = near.iter().map(|&point| points[point as usize].extend(0.0)).collect();
        let known: Vec<u32> = (0..near.len() as u32).filter(|&place| !is_free[near[place as usize] as usize]).collect();
        let continuation = Continuation::new(&part, &places, Operator::CotangentMass, &known)?;
        let (known_values, values) = (vec![0.0; known.len()], vec![0.0; near.len()]);
        Ok(Some(Self { points: near, known, continuation, known_values, values }))
    }

    /// Fills in the offsets of what gives way.
    fn give_way(&mut self, offsets_px: &mut [DVec2]) {
        for axis in [0, 1] {
            for (value, &place) in self.known_values.iter_mut().zip(&self.known) {
                *value = offsets_px[self.points[place as usize] as usize][axis];
            }
            self.continuation.continued(&self.known_values, &mut self.values);
            for (&point, value) in self.points.iter().zip(&self.values) {
                offsets_px[point as usize][axis] = *value;
            }
        }
    }
}

/// None where it is no number.
fn bounded(offset: DVec2, longest: f64) -> DVec2 {
    if offset.is_nan() { DVec2::ZERO } else { offset.clamp(DVec2::splat(-longest), DVec2::splat(longest)) }
}

/// These vertices and all their neighbours.
fn grown(topology: &Topology, vertices: &[bool]) -> Vec<bool> {
    let is_beside = |vertex: u32| topology.neighbours(vertex).iter().any(|&other| vertices[other as usize]);
    (0..vertices.len() as u32).map(|vertex| vertices[vertex as usize] || is_beside(vertex)).collect()
}
