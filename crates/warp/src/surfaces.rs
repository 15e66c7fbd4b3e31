use glam::{DVec2, DVec3};

use crate::cells::Cells;
use crate::layout::bounds;
use crate::seen;

/// What lies behind leads only so many times as far from what is before it as two rims do from each other: which of the two a
/// pixel shows there hangs on how exact the places are.
const BEHIND_TIMES: f64 = 2.0;

/// Cells along a surface, at most.
const MOST_CELLS: f64 = 64.0;

/// Which vertices of a surface can lead its picture: those that are [`seen`], but for what lies right beside another sheet of it.
///
/// Surfaces meet where rims touch, as closed lids and lips do, and where one lies before another, as a nose before a cheek. Points
/// of both that lie some px from each other go different ways, and where they were found is less exact than that: what is
/// between would go zigzag. So where rims are less than `apart_px` from each other, neither leads, and the picture gives way
/// between what is beside them; and what lies behind another sheet by more than `behind` leads only twice as far from it. Two
/// vertices are of one sheet if a way along edges, from one vertex that is seen to the next, joins them within that distance.
///
/// `triangles`, `places` and `behind` as for [`seen`], `apart_px` in px of the picture; one answer for each vertex.
pub fn leading(triangles: &[[u32; 3]], places: &[DVec3], behind: f64, apart_px: f64) -> Vec<bool> {
    let mut leads = seen(triangles, places, behind);
    let far_px = BEHIND_TIMES * apart_px;
    if !(far_px > 0.0 && far_px.is_finite()) {
        return leads;
    }
    let mut surfaces = Surfaces::new(triangles, places, &leads, far_px);
    for rim in std::mem::take(&mut surfaces.rims) {
        for other in surfaces.beside(rim, apart_px) {
            let nearer = surfaces.nearer(rim, other);
            leads[rim as usize] &= nearer > behind;
            leads[other as usize] &= nearer < -behind;
        }
        for other in surfaces.beside(rim, far_px) {
            let nearer = surfaces.nearer(rim, other);
            leads[rim as usize] &= nearer >= -behind;
            leads[other as usize] &= nearer <= behind;
        }
    }
    leads
}

/// The part of a surface that is seen.
struct Surfaces<'a> {
    places: &'a [DVec3],
    /// Those of each vertex that are seen, of one that is.
    neighbours: Vec<Vec<u32>>,
    /// Where it ends.
    rims: Vec<u32>,
    /// Its vertices by where they are.
    cells: Cells<u32>,
    /// Which search was the last to come to each vertex, and how many there were.
    found_by: Vec<u32>,
    searches: u32,
}

impl<'a> Surfaces<'a> {
    fn new(triangles: &[[u32; 3]], places: &'a [DVec3], is_seen: &[bool], far_px: f64) -> Self {
        let seen: Vec<u32> = (0..places.len() as u32).filter(|&vertex| is_seen[vertex as usize]).collect();
        let around = bounds(&seen.iter().map(|&vertex| places[vertex as usize].truncate()).collect::<Vec<_>>());
        let longest_px = (around[1] - around[0]).max_element();
        let cells = Cells::over(around, far_px.max(longest_px / MOST_CELLS));
        let (neighbours, found_by) = (vec![Vec::new(); places.len()], vec![0; places.len()]);
        let mut surfaces = Self { places, neighbours, rims: Vec::new(), cells, found_by, searches: 0 };
        let wholly_seen = surfaces.join(triangles, is_seen);
        for vertex in seen {
            surfaces.cells.add(surfaces.place(vertex), vertex);
            // Around a vertex in the middle of what is seen there are as many triangles as neighbours.
            if surfaces.neighbours[vertex as usize].len() > wholly_seen[vertex as usize] {
                surfaces.rims.push(vertex);
            }
        }
        surfaces
    }

    /// Notes what is beside each vertex; returns how many of its triangles are seen with all their corners.
    fn join(&mut self, triangles: &[[u32; 3]], is_seen: &[bool]) -> Vec<usize> {
        let mut wholly_seen = vec![0; self.places.len()];
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

    /// Vertices of other surfaces that lie so near to one: no way that stays as near leads there.
    fn beside(&mut self, vertex: u32, within_px: f64) -> Vec<u32> {
        self.search(vertex, within_px);
        let place = self.place(vertex);
        let near = self.cells.in_box([place - within_px, place + within_px]).map(|(_, other)| other);
        let is_beside = |other: &u32| {
            self.found_by[*other as usize] != self.searches && self.distance_px(vertex, *other) < within_px
        };
        near.filter(is_beside).collect()
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

    /// By how much one is nearer to the viewer than the other.
    fn nearer(&self, one: u32, other: u32) -> f64 {
        self.places[one as usize].z - self.places[other as usize].z
    }

    fn distance_px(&self, one: u32, other: u32) -> f64 {
        self.place(one).distance(self.place(other))
    }

    fn place(&self, vertex: u32) -> DVec2 {
        self.places[vertex as usize].truncate()
    }
}
