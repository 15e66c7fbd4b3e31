use glam::{DVec2, DVec3};

use crate::cells::Cells;
use crate::layout::bounds;
use crate::seen;

/// Clearance behind an occluding surface, in multiples of the clearance between rims. It is larger, because small
/// errors of the positions decide which of the two a pixel shows.
const OCCLUDED_CLEARANCE: f64 = 2.0;

/// Maximum number of grid cells along the surface.
const MAX_CELLS: f64 = 64.0;

/// Vertices of a surface that can lead a warp: [`seen`], and not close to another part of the surface.
///
/// Parts of a surface meet where rims touch, such as closed lids and lips, and where one occludes another, such as the
/// nose in front of a cheek. There, vertices a few px apart move differently, and the positions are less precise than
/// that; the warp would zigzag between them. If two rims are closer than `apart_px`, neither leads, and the picture
/// between their neighbours is interpolated. A part that lies behind another by more than `behind` leads only from
/// twice that distance on. Two vertices belong to the same part if a path over visible vertices within that distance
/// connects them.
///
/// `triangles`, `positions` and `behind` are those of [`seen`]; `apart_px` is in px of the picture. Returns one value
/// per vertex.
pub fn leading(triangles: &[[u32; 3]], positions: &[DVec3], behind: f64, apart_px: f64) -> Vec<bool> {
    let mut leads = seen(triangles, positions, behind);
    let far_px = OCCLUDED_CLEARANCE * apart_px;
    if !(far_px > 0.0 && far_px.is_finite()) {
        return leads;
    }
    let mut surfaces = Surfaces::new(triangles, positions, &leads, far_px);
    for rim in std::mem::take(&mut surfaces.rims) {
        for other in surfaces.nearby_parts(rim, apart_px) {
            let nearer = surfaces.nearer(rim, other);
            leads[rim as usize] &= nearer > behind;
            leads[other as usize] &= nearer < -behind;
        }
        for other in surfaces.nearby_parts(rim, far_px) {
            let nearer = surfaces.nearer(rim, other);
            leads[rim as usize] &= nearer >= -behind;
            leads[other as usize] &= nearer <= behind;
        }
    }
    leads
}

/// The visible part of a surface.
struct Surfaces<'a> {
    positions: &'a [DVec3],
    /// Visible neighbours of each visible vertex.
    neighbours: Vec<Vec<u32>>,
    /// Boundary vertices of the visible part.
    rims: Vec<u32>,
    /// Visible vertices by position.
    cells: Cells<u32>,
    /// Last search that visited each vertex, and the number of searches.
    found_by: Vec<u32>,
    searches: u32,
}

impl<'a> Surfaces<'a> {
    fn new(triangles: &[[u32; 3]], positions: &'a [DVec3], is_seen: &[bool], far_px: f64) -> Self {
        let seen: Vec<u32> = (0..positions.len() as u32).filter(|&vertex| is_seen[vertex as usize]).collect();
        let around = bounds(&seen.iter().map(|&vertex| positions[vertex as usize].truncate()).collect::<Vec<_>>());
        let longest_px = (around[1] - around[0]).max_element();
        let cells = Cells::over(around, far_px.max(longest_px / MAX_CELLS));
        let (neighbours, found_by) = (vec![Vec::new(); positions.len()], vec![0; positions.len()]);
        let mut surfaces = Self { positions, neighbours, rims: Vec::new(), cells, found_by, searches: 0 };
        let wholly_seen = surfaces.join(triangles, is_seen);
        for vertex in seen {
            surfaces.cells.add(surfaces.position(vertex), vertex);
            // An interior vertex has as many triangles as neighbours.
            if surfaces.neighbours[vertex as usize].len() > wholly_seen[vertex as usize] {
                surfaces.rims.push(vertex);
            }
        }
        surfaces
    }

    /// Collects the neighbours; returns the number of fully visible triangles at each vertex.
    fn join(&mut self, triangles: &[[u32; 3]], is_seen: &[bool]) -> Vec<usize> {
        let mut wholly_seen = vec![0; self.positions.len()];
        for &[a, b, c] in triangles {
            let seen = [a, b, c].map(|corner| is_seen[corner as usize]);
            [a, b, c].iter().filter(|_| seen == [true; 3]).for_each(|&corner| wholly_seen[corner as usize] += 1);
            for (from, to) in [(a, b), (b, c), (c, a), (b, a), (c, b), (a, c)] {
                let around = &mut self.neighbours[from as usize];
                if is_seen[from as usize] && is_seen[to as usize] && !around.contains(&to) {
                    around.push(to);
                }
            }
        }
        wholly_seen
    }

    /// Vertices within the distance that no path within the distance reaches.
    fn nearby_parts(&mut self, vertex: u32, within_px: f64) -> Vec<u32> {
        self.search(vertex, within_px);
        let position = self.position(vertex);
        let near = self.cells.in_box([position - within_px, position + within_px]).map(|(_, other)| other);
        let is_other_part = |other: &u32| {
            self.found_by[*other as usize] != self.searches && self.distance_px(vertex, *other) < within_px
        };
        near.filter(is_other_part).collect()
    }

    fn search(&mut self, from: u32, within_px: f64) {
        self.searches += 1;
        self.found_by[from as usize] = self.searches;
        let mut open = vec![from];
        while let Some(at) = open.pop() {
            for &next in &self.neighbours[at as usize] {
                let is_new = self.found_by[next as usize] != self.searches;
                if is_new && self.distance_px(from, next) < within_px {
                    self.found_by[next as usize] = self.searches;
                    open.push(next);
                }
            }
        }
    }

    /// Depth difference, positive if `one` is nearer to the viewer.
    fn nearer(&self, one: u32, other: u32) -> f64 {
        self.positions[one as usize].z - self.positions[other as usize].z
    }

    fn distance_px(&self, one: u32, other: u32) -> f64 {
        self.position(one).distance(self.position(other))
    }

    fn position(&self, vertex: u32) -> DVec2 {
        self.positions[vertex as usize].truncate()
    }
}
