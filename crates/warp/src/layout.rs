use glam::DVec2;

use crate::WarpError;
use crate::cells::Cells;

/// What of a picture leads, and how far the rest gives way.
#[derive(Debug, Clone, Copy)]
pub struct Subject<'a> {
    /// Width and height of the picture in px.
    pub size_px: [u32; 2],
    /// Points that know where they go. Those outside the picture lead nothing.
    pub points_px: &'a [DVec2],
    /// How far beyond them the picture gives way.
    pub ring_px: f64,
    /// What is to stay as it is.
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
    /// It goes where one of the subject's points goes; by less at the edge of the picture, which stays.
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
}

/// A lattice this many times finer than the subject is long tells the eye's corner from the brow's.
const NODES_ALONG: f64 = 28.0;
/// And there are at least so many nodes across the ring, the last of which stay.
const NODES_ACROSS: f64 = 6.0;
/// So many layers of nodes stay within the ring's border: value and slope are zero there.
const LAYERS_THAT_STAY: f64 = 2.0;
/// Shares of the lattice's spacing: nodes keep so far from points, and points from each other.
const ROOM: f64 = 0.55;
const LEAST_APART: f64 = 0.05;
/// So many spacings from the picture's edge, points begin to move by less.
const TAPER: f64 = 2.0;

impl Layout {
    pub(crate) fn of(subject: &Subject<'_>) -> Result<Self, WarpError> {
        if !(subject.ring_px > 0.0 && subject.ring_px.is_finite()) {
            return Err(WarpError::Ring { ring_px: subject.ring_px });
        }
        let size_px = DVec2::from(subject.size_px.map(f64::from));
        let is_inside = |point: &DVec2| point.cmpge(DVec2::ZERO).all() && point.cmple(size_px).all();
        let inside: Vec<DVec2> = subject.points_px.iter().copied().filter(is_inside).collect();
        if inside.len() < 3 {
            return Err(WarpError::TooFewPoints { inside: inside.len(), points: subject.points_px.len() });
        }
        let (low, high) = inside.iter().fold((inside[0], inside[0]), |(l, h), point| (l.min(*point), h.max(*point)));
        let spacing = ((high - low).max_element() / NODES_ALONG).min(subject.ring_px / NODES_ACROSS).max(1.0);
        let reach = DVec2::splat(subject.ring_px + spacing);
        let around = [(low - reach).max(DVec2::ZERO), (high + reach).min(size_px)];
        let mut plan =
            Plan { subject, size_px, spacing, around, cells: Cells::over(around, spacing), laid: Vec::new() };
        plan.lay_points();
        plan.lay_lattice();
        plan.lay_edges();
        plan.keep();
        Ok(plan.joined())
    }
}

/// A layout on its way.
struct Plan<'a> {
    subject: &'a Subject<'a>,
    size_px: DVec2,
    spacing: f64,
    around: [DVec2; 2],
    cells: Cells,
    laid: Vec<(DVec2, Tie)>,
}

impl Plan<'_> {
    fn lay_points(&mut self) {
        for (point, &place) in self.subject.points_px.iter().enumerate() {
            let from_edge = place.min(self.size_px - place).min_element();
            let is_apart = || self.cells.distance(place, LEAST_APART * self.spacing) == f64::INFINITY;
            if from_edge > 0.0 && is_apart() {
                let share = smooth_step(from_edge / (TAPER * self.spacing));
                self.cells.add(place);
                self.laid.push((place, Tie::Follows { point, share }));
            }
        }
    }

    /// Rows of equilateral triangles.
    fn lay_lattice(&mut self) {
        let [low, high] = self.around;
        let row_height = self.spacing * 0.75_f64.sqrt();
        for row in 0..=((high.y - low.y) / row_height) as u32 {
            let shift = 0.5 * f64::from(row % 2);
            for column in 0..=((high.x - low.x) / self.spacing) as u32 {
                let step = DVec2::new((f64::from(column) + shift) * self.spacing, f64::from(row) * row_height);
                self.lay_node(low + step);
            }
        }
    }

    fn lay_node(&mut self, place: DVec2) {
        let from_edge = place.min(self.size_px - place).min_element();
        let from_subject = self.from_subject(place);
        if from_edge > ROOM * self.spacing && from_subject > ROOM * self.spacing && from_subject.is_finite() {
            let gives_way = from_subject < self.subject.ring_px - LAYERS_THAT_STAY * self.spacing;
            self.laid.push((place, if gives_way { Tie::Free } else { Tie::Stays }));
        }
    }

    /// The picture's edge stays a straight line.
    fn lay_edges(&mut self) {
        let size = self.size_px;
        let corners = [DVec2::ZERO, DVec2::new(size.x, 0.0), size, DVec2::new(0.0, size.y)];
        for (from, to) in [(0, 1), (1, 2), (2, 3), (3, 0)].map(|(from, to)| (corners[from], corners[to])) {
            let steps = (from.distance(to) / self.spacing).ceil();
            let places = (0..steps as u32).map(|step| from.lerp(to, f64::from(step) / steps));
            let near: Vec<DVec2> = places.filter(|&place| self.from_subject(place).is_finite()).collect();
            self.laid.extend(near.into_iter().map(|place| (place, Tie::Stays)));
        }
    }

    /// Every triangle that a dab touches stays.
    fn keep(&mut self) {
        let margin = self.spacing;
        let kept = self.subject.kept;
        for (place, tie) in &mut self.laid {
            if kept.iter().any(|dab| dab.centre_px.distance(*place) < dab.radius_px + margin) {
                *tie = Tie::Stays;
            }
        }
    }

    fn joined(self) -> Layout {
        let (points, ties): (Vec<DVec2>, Vec<Tie>) = self.laid.into_iter().unzip();
        let places: Vec<_> = points.iter().map(|place| delaunator::Point { x: place.x, y: place.y }).collect();
        let corners = delaunator::triangulate(&places).triangles;
        let triangles = corners.as_chunks::<3>().0.iter().map(|corners| corners.map(|corner| corner as u32));
        Layout { triangles: triangles.collect(), points, ties }
    }

    /// Infinity for what is beyond the ring.
    fn from_subject(&self, place: DVec2) -> f64 {
        self.cells.distance(place, self.subject.ring_px + self.spacing)
    }
}

fn smooth_step(share: f64) -> f64 {
    let share = share.clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}
