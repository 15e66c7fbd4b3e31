use std::ops::RangeInclusive;

use glam::DVec2;

use crate::WarpError;
use crate::cells::Cells;

/// How far beyond its points a picture can give way, in shares of their box's longer side. A narrower falloff band would need a
/// lattice too fine to solve for, and a wider one too large.
pub const FALLOFF_BAND_SHARES: RangeInclusive<f64> = 0.05..=3.0;

/// What of a picture leads, and how far the rest gives way.
#[derive(Debug, Clone, Copy)]
pub struct Subject<'a> {
    /// Width and height of the picture in px.
    pub size_px: [u32; 2],
    /// Points that know where they go. Those outside the picture lead nothing.
    pub points_px: &'a [DVec2],
    /// How far beyond them the picture gives way: [`FALLOFF_BAND_SHARES`] of their box's longer side.
    pub falloff_band_px: f64,
    /// What is to stay as it is, byte for byte.
    pub kept: &'a [Dab],
}

/// A round dab of a brush.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dab {
    /// Its middle in px.
    pub centre_px: DVec2,
    /// Its radius in px.
    pub radius_px: f64,
}

/// What a point of the triangulation does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Tie {
    /// It goes where one of the subject's points goes; by less beside what stays.
    Follows {
        point: usize,
        share: f64,
    },
    Stays,
    /// It gives way.
    Free,
}

/// The triangulation: the subject's points, a lattice around and between them, and the edge of the picture.
pub(crate) struct Layout {
    pub points: Vec<DVec2>,
    pub ties: Vec<Tie>,
    pub triangles: Vec<[u32; 3]>,
    /// Of the lattice, in px.
    pub spacing: f64,
}

/// A lattice this many times finer than the subject is long tells the eye's corner from the brow's.
const NODES_ALONG: f64 = 28.0;
/// And there are at least so many nodes across the falloff band, the last of which stay.
const NODES_ACROSS: f64 = 6.0;
/// So many layers of nodes stay within the falloff band's border: value and slope are zero there.
const LAYERS_THAT_STAY: f64 = 2.0;
/// Shares of the lattice's spacing: nodes keep so far from points, and points from each other.
const ROOM: f64 = 0.55;
const LEAST_APART: f64 = 0.05;
/// So many spacings from what stays, points begin to move by less.
const TAPER: f64 = 2.0;

impl Layout {
    pub(crate) fn of(subject: &Subject<'_>) -> Result<Self, WarpError> {
        let mut plan = Plan::new(subject)?;
        plan.lay_points();
        plan.lay_lattice();
        plan.lay_edges();
        Ok(plan.joined())
    }
}

/// A layout on its way.
struct Plan<'a> {
    subject: &'a Subject<'a>,
    size_px: DVec2,
    spacing: f64,
    /// The middle of the points' box, on which the lattice is centred: a mirrored picture gets a mirrored one.
    middle: DVec2,
    /// What the lattice is laid over.
    around: [DVec2; 2],
    cells: Cells<()>,
    laid: Vec<(DVec2, Tie)>,
}

impl<'a> Plan<'a> {
    fn new(subject: &'a Subject<'a>) -> Result<Self, WarpError> {
        let size_px = DVec2::from(subject.size_px.map(f64::from));
        let [low, high] = box_inside(subject, size_px)?;
        let side = (high - low).max_element();
        let [least_px, most_px] = [FALLOFF_BAND_SHARES.start(), FALLOFF_BAND_SHARES.end()].map(|share| share * side);
        if !(least_px..=most_px).contains(&subject.falloff_band_px) {
            return Err(WarpError::FalloffBand { falloff_band_px: subject.falloff_band_px, least_px, most_px });
        }
        let spacing = (side / NODES_ALONG).min(subject.falloff_band_px / NODES_ACROSS);
        let reach = DVec2::splat(subject.falloff_band_px + spacing);
        let around = [(low - reach).max(DVec2::ZERO), (high + reach).min(size_px)];
        let cells = Cells::over(around, spacing);
        Ok(Self { subject, size_px, spacing, middle: 0.5 * (low + high), around, cells, laid: Vec::new() })
    }

    fn lay_points(&mut self) {
        for (point, &place) in self.subject.points_px.iter().enumerate() {
            let is_apart = || self.cells.distance(place, LEAST_APART * self.spacing) == f64::INFINITY;
            if self.away_from_edge(place) > 0.0 && is_apart() {
                let from_still = self.away_from_edge(place).min(self.away_from_kept(place));
                let share = smooth_step(from_still / (TAPER * self.spacing));
                self.cells.add(place, ());
                self.laid.push((place, if share > 0.0 { Tie::Follows { point, share } } else { Tie::Stays }));
            }
        }
    }

    /// Rows of equilateral triangles.
    fn lay_lattice(&mut self) {
        let step = DVec2::new(self.spacing, self.spacing * 0.75_f64.sqrt());
        let [low, high] = self.around.map(|end| (end - self.middle) / step);
        for row in low.y.floor() as i32..=high.y.ceil() as i32 {
            let shift = 0.5 * f64::from(row.rem_euclid(2));
            for column in (low.x - shift).floor() as i32..=high.x.ceil() as i32 {
                self.lay_node(self.middle + DVec2::new(f64::from(column) + shift, f64::from(row)) * step);
            }
        }
    }

    fn lay_node(&mut self, place: DVec2) {
        let room = ROOM * self.spacing;
        let from_subject = self.away_from_subject(place);
        if self.away_from_edge(place) > room && from_subject > room && from_subject.is_finite() {
            let is_within = from_subject < self.subject.falloff_band_px - LAYERS_THAT_STAY * self.spacing;
            let gives_way = is_within && self.away_from_kept(place) > 0.0;
            self.laid.push((place, if gives_way { Tie::Free } else { Tie::Stays }));
        }
    }

    /// The picture's edge stays a straight line.
    fn lay_edges(&mut self) {
        let size = self.size_px;
        let corners = [DVec2::ZERO, DVec2::new(size.x, 0.0), size, DVec2::new(0.0, size.y)];
        for (from, to) in [(0, 1), (1, 2), (2, 3), (3, 0)].map(|(from, to)| (corners[from], corners[to])) {
            let steps = (from.distance(to) / self.spacing).ceil();
            let places = (0..steps as u32).map(|step| from + (to - from) * (f64::from(step) / steps));
            let near: Vec<DVec2> = places.filter(|&place| self.away_from_subject(place).is_finite()).collect();
            self.laid.extend(near.into_iter().map(|place| (place, Tie::Stays)));
        }
    }

    fn joined(self) -> Layout {
        let (points, mut ties): (Vec<DVec2>, Vec<Tie>) = self.laid.iter().copied().unzip();
        let triangles = delaunay(&points);
        // What a triangle shows moves with each of its corners.
        let is_kept = |corners: &&[u32; 3]| self.is_kept(corners.map(|corner| points[corner as usize]));
        for &corner in triangles.iter().filter(is_kept).flatten() {
            ties[corner as usize] = Tie::Stays;
        }
        Layout { triangles, points, ties, spacing: self.spacing }
    }

    /// Whether a dab touches a triangle.
    fn is_kept(&self, corners: [DVec2; 3]) -> bool {
        let (low, high) = (corners[0].min(corners[1]).min(corners[2]), corners[0].max(corners[1]).max(corners[2]));
        self.subject.kept.iter().any(|dab| {
            let is_near = dab.centre_px.distance(dab.centre_px.clamp(low, high)) <= dab.radius_px;
            is_near && distance(dab.centre_px, corners) <= dab.radius_px
        })
    }

    fn away_from_edge(&self, place: DVec2) -> f64 {
        place.min(self.size_px - place).min_element()
    }

    /// How far a place is from what is kept.
    fn away_from_kept(&self, place: DVec2) -> f64 {
        let from = |dab: &Dab| dab.centre_px.distance(place) - dab.radius_px;
        self.subject.kept.iter().map(from).fold(f64::INFINITY, f64::min)
    }

    /// Infinity for what is beyond the falloff band.
    fn away_from_subject(&self, place: DVec2) -> f64 {
        self.cells.distance(place, self.subject.falloff_band_px + self.spacing)
    }
}

pub(crate) fn delaunay(points: &[DVec2]) -> Vec<[u32; 3]> {
    let places: Vec<_> = points.iter().map(|place| delaunator::Point { x: place.x, y: place.y }).collect();
    let corners = delaunator::triangulate(&places).triangles;
    corners.as_chunks::<3>().0.iter().map(|corners| corners.map(|corner| corner as u32)).collect()
}

/// The box of the points that lie in the picture.
fn box_inside(subject: &Subject<'_>, size_px: DVec2) -> Result<[DVec2; 2], WarpError> {
    let is_inside = |point: &&DVec2| point.cmpgt(DVec2::ZERO).all() && point.cmplt(size_px).all();
    let inside: Vec<DVec2> = subject.points_px.iter().filter(is_inside).copied().collect();
    let [low, high] = bounds(&inside);
    let is_extended = low != high;
    match inside.len() >= 3 && is_extended {
        true => Ok([low, high]),
        false => Err(WarpError::TooFewPoints { inside: inside.len(), points: subject.points_px.len() }),
    }
}

/// The box of some points; of none, a place.
pub(crate) fn bounds(points: &[DVec2]) -> [DVec2; 2] {
    let first = points.first().copied().unwrap_or_default();
    points.iter().fold([first; 2], |[low, high], point| [low.min(*point), high.max(*point)])
}

/// How far a place is from a triangle: 0 within it.
fn distance(place: DVec2, corners: [DVec2; 3]) -> f64 {
    let sides = [(0, 1), (1, 2), (2, 0)].map(|(from, to)| (corners[from], corners[to]));
    let turns = sides.map(|(from, to)| (to - from).perp_dot(place - from));
    if turns.iter().all(|turn| *turn >= 0.0) || turns.iter().all(|turn| *turn <= 0.0) {
        return 0.0;
    }
    let from_side = |(from, to): (DVec2, DVec2)| {
        let along = (place - from).dot(to - from) / (to - from).length_squared();
        place.distance(from.lerp(to, along.clamp(0.0, 1.0)))
    };
    sides.map(from_side).into_iter().fold(f64::INFINITY, f64::min)
}

fn smooth_step(share: f64) -> f64 {
    let share = share.clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}
