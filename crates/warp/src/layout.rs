use std::ops::RangeInclusive;

use glam::DVec2;

use crate::WarpError;
use crate::cells::Cells;

/// Range of the falloff band's width, as a share of the longer side of the points' bounding box. A narrower band needs
/// too fine a lattice, a wider one too large a lattice.
pub const FALLOFF_BAND_SHARES: RangeInclusive<f64> = 0.05..=3.0;

/// Maximum width of the stiff strip, as a share of the falloff band; the rest must have room for the strain.
pub const MAX_STRIP_SHARE: f64 = 0.4;

/// Points that lead a warp, and the parameters of the area around them.
#[derive(Debug, Clone, Copy)]
pub struct Subject<'a> {
    /// Width and height of the picture in px.
    pub size_px: [u32; 2],
    /// Leading points in px. Points outside the picture are ignored.
    pub points_px: &'a [DVec2],
    /// Width of the falloff band in px, within [`FALLOFF_BAND_SHARES`] of the longer side of the points' bounding box.
    pub falloff_band_px: f64,
    /// Width in px of the stiff strip: what lies next to the points moves with them, nearly rigidly, and the rest of the
    /// falloff band takes the strain. At most [`MAX_STRIP_SHARE`] of the falloff band is used; 0 for no strip.
    pub stiff_strip_px: f64,
    /// Protected circles, whose pixels do not change.
    pub protected: &'a [Dab],
}

/// A circle painted with the brush.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dab {
    /// Centre in px.
    pub centre_px: DVec2,
    /// Radius in px.
    pub radius_px: f64,
}

/// Behaviour of a point of the triangulation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Role {
    /// Moves with one of the subject's points, reduced by `share` near fixed areas.
    Moved {
        point: usize,
        share: f64,
    },
    Fixed,
    /// Interpolated.
    Free,
}

/// Triangulation of the subject's points, a lattice around and between them, and the picture's border.
pub(crate) struct Layout {
    pub points: Vec<DVec2>,
    pub roles: Vec<Role>,
    pub triangles: Vec<[u32; 3]>,
    /// Tension of the falloff band at each point, in px⁻².
    pub tension: Vec<f64>,
    /// Whether each point lies beyond the gaps between the subject's points.
    pub is_beyond: Vec<bool>,
    /// Lattice spacing in px.
    pub spacing: f64,
}

/// Lattice nodes along the subject; enough to separate the eye's corner from the eyebrow's.
const NODES_ALONG: f64 = 28.0;
/// Minimum number of nodes across the falloff band.
const NODES_ACROSS: f64 = 6.0;
/// Layers of fixed nodes at the outer border, where value and slope must be zero.
const FIXED_LAYERS: f64 = 2.0;
/// Minimum distance of nodes from points, and of points from each other, in lattice spacings.
const NODE_CLEARANCE: f64 = 0.55;
const POINT_CLEARANCE: f64 = 0.05;
/// Distance from fixed areas within which displacements taper off, in lattice spacings.
const TAPER: f64 = 2.0;
/// Ratio of the stiff strip's width to the length over which it bends.
const STIFFNESS: f64 = 16.0;
/// Distance from the subject from which a node lies beyond the gaps between its points, in lattice spacings.
const GAP: f64 = 2.0;
/// Share of the stiff strip's width from which its tension fades to zero.
const FADES_FROM: f64 = 0.5;

impl Layout {
    pub(crate) fn of(subject: &Subject<'_>) -> Result<Self, WarpError> {
        let mut plan = Plan::new(subject)?;
        plan.lay_points();
        plan.lay_lattice();
        plan.lay_edges();
        Ok(plan.finish())
    }
}

/// A layout under construction.
struct Plan<'a> {
    subject: &'a Subject<'a>,
    size_px: DVec2,
    spacing: f64,
    /// Centre of the points' bounding box and of the lattice, so that a mirrored picture gets a mirrored layout.
    centre: DVec2,
    /// Area of the lattice.
    area: [DVec2; 2],
    cells: Cells<()>,
    laid: Vec<(DVec2, Role)>,
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
        let margin = DVec2::splat(subject.falloff_band_px + spacing);
        let area = [(low - margin).max(DVec2::ZERO), (high + margin).min(size_px)];
        let cells = Cells::over(area, spacing);
        Ok(Self { subject, size_px, spacing, centre: 0.5 * (low + high), area, cells, laid: Vec::new() })
    }

    fn lay_points(&mut self) {
        for (point, &position) in self.subject.points_px.iter().enumerate() {
            let is_apart = || self.cells.distance(position, POINT_CLEARANCE * self.spacing) == f64::INFINITY;
            if self.distance_to_edge(position) > 0.0 && is_apart() {
                let clearance = self.distance_to_edge(position).min(self.distance_to_protected(position));
                let share = smooth_step(clearance / (TAPER * self.spacing));
                self.cells.add(position, ());
                self.laid.push((position, if share > 0.0 { Role::Moved { point, share } } else { Role::Fixed }));
            }
        }
    }

    /// Adds a lattice of equilateral triangles.
    fn lay_lattice(&mut self) {
        let step = DVec2::new(self.spacing, self.spacing * 0.75_f64.sqrt());
        let [low, high] = self.area.map(|end| (end - self.centre) / step);
        for row in low.y.floor() as i32..=high.y.ceil() as i32 {
            let shift = 0.5 * f64::from(row.rem_euclid(2));
            for column in (low.x - shift).floor() as i32..=high.x.ceil() as i32 {
                self.lay_node(self.centre + DVec2::new(f64::from(column) + shift, f64::from(row)) * step);
            }
        }
    }

    fn lay_node(&mut self, position: DVec2) {
        let clearance = NODE_CLEARANCE * self.spacing;
        let from_subject = self.distance_to_subject(position);
        if self.distance_to_edge(position) > clearance && from_subject > clearance && from_subject.is_finite() {
            let is_within = from_subject < self.subject.falloff_band_px - FIXED_LAYERS * self.spacing;
            let is_free = is_within && self.distance_to_protected(position) > 0.0;
            self.laid.push((position, if is_free { Role::Free } else { Role::Fixed }));
        }
    }

    /// Adds fixed nodes along the picture's border, which stays straight.
    fn lay_edges(&mut self) {
        let size = self.size_px;
        let corners = [DVec2::ZERO, DVec2::new(size.x, 0.0), size, DVec2::new(0.0, size.y)];
        for (from, to) in [(0, 1), (1, 2), (2, 3), (3, 0)].map(|(from, to)| (corners[from], corners[to])) {
            let steps = (from.distance(to) / self.spacing).ceil();
            let positions = (0..steps as u32).map(|step| from + (to - from) * (f64::from(step) / steps));
            let near: Vec<DVec2> =
                positions.filter(|&position| self.distance_to_subject(position).is_finite()).collect();
            self.laid.extend(near.into_iter().map(|position| (position, Role::Fixed)));
        }
    }

    fn finish(self) -> Layout {
        let (points, mut roles): (Vec<DVec2>, Vec<Role>) = self.laid.iter().copied().unzip();
        let triangles = delaunay(&points);
        // A pixel depends on all corners of its triangle.
        let is_protected = |corners: &&[u32; 3]| self.is_protected(corners.map(|corner| points[corner as usize]));
        for &corner in triangles.iter().filter(is_protected).flatten() {
            roles[corner as usize] = Role::Fixed;
        }
        let tension = points.iter().map(|&point| self.tension(point)).collect();
        let is_beyond = points.iter().map(|&point| self.distance_to_subject(point) > GAP * self.spacing).collect();
        Layout { triangles, points, roles, tension, is_beyond, spacing: self.spacing }
    }

    /// High next to the leading points, zero beyond the stiff strip.
    fn tension(&self, position: DVec2) -> f64 {
        let width_px = self.subject.stiff_strip_px.clamp(0.0, MAX_STRIP_SHARE * self.subject.falloff_band_px);
        let beyond = self.distance_to_subject(position) / width_px;
        let faded = smooth_step((beyond - FADES_FROM) / (1.0 - FADES_FROM));
        if width_px > 0.0 { (STIFFNESS / width_px).powi(2) * (1.0 - faded) } else { 0.0 }
    }

    /// Whether a protected circle intersects the triangle.
    fn is_protected(&self, corners: [DVec2; 3]) -> bool {
        let (low, high) = (corners[0].min(corners[1]).min(corners[2]), corners[0].max(corners[1]).max(corners[2]));
        self.subject.protected.iter().any(|dab| {
            let is_near = dab.centre_px.distance(dab.centre_px.clamp(low, high)) <= dab.radius_px;
            is_near && distance(dab.centre_px, corners) <= dab.radius_px
        })
    }

    fn distance_to_edge(&self, position: DVec2) -> f64 {
        position.min(self.size_px - position).min_element()
    }

    /// Distance to the nearest protected circle; negative inside.
    fn distance_to_protected(&self, position: DVec2) -> f64 {
        let from = |dab: &Dab| dab.centre_px.distance(position) - dab.radius_px;
        self.subject.protected.iter().map(from).fold(f64::INFINITY, f64::min)
    }

    /// Distance to the nearest leading point; infinity beyond the falloff band.
    fn distance_to_subject(&self, position: DVec2) -> f64 {
        self.cells.distance(position, self.subject.falloff_band_px + self.spacing)
    }
}

pub(crate) fn delaunay(points: &[DVec2]) -> Vec<[u32; 3]> {
    let positions: Vec<_> = points.iter().map(|position| delaunator::Point { x: position.x, y: position.y }).collect();
    let corners = delaunator::triangulate(&positions).triangles;
    corners.as_chunks::<3>().0.iter().map(|corners| corners.map(|corner| corner as u32)).collect()
}

/// Bounding box of the points inside the picture.
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

/// Bounding box; zero-sized at the origin without points.
pub(crate) fn bounds(points: &[DVec2]) -> [DVec2; 2] {
    let first = points.first().copied().unwrap_or_default();
    points.iter().fold([first; 2], |[low, high], point| [low.min(*point), high.max(*point)])
}

/// Distance to a triangle; 0 inside.
fn distance(position: DVec2, corners: [DVec2; 3]) -> f64 {
    let sides = [(0, 1), (1, 2), (2, 0)].map(|(from, to)| (corners[from], corners[to]));
    let turns = sides.map(|(from, to)| (to - from).perp_dot(position - from));
    if turns.iter().all(|turn| *turn >= 0.0) || turns.iter().all(|turn| *turn <= 0.0) {
        return 0.0;
    }
    let from_side = |(from, to): (DVec2, DVec2)| {
        let along = (position - from).dot(to - from) / (to - from).length_squared();
        position.distance(from.lerp(to, along.clamp(0.0, 1.0)))
    };
    sides.map(from_side).into_iter().fold(f64::INFINITY, f64::min)
}

fn smooth_step(share: f64) -> f64 {
    let share = share.clamp(0.0, 1.0);
    share * share * (3.0 - 2.0 * share)
}
