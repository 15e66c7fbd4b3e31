//! The back of a wall: a copy of the front, offset inward.

use glam::DVec3;
use rosto_mesh::{Topology, vertex_normals};

use crate::crossings::{crossings, crossings_of};
use crate::front::{Front, dilated};

/// Smoothing radius of the directions, relative to the thickness, and the repair of self-intersections; tried in turn
/// until the wall is thick enough.
const TRIES: [(f64, Repair); 4] =
    [(2.8, Repair::BendAndThin), (1.4, Repair::BendAndThin), (0.5, Repair::BendAndThin), (0.0, Repair::Thin)];

/// Smallest acceptable thickness, relative to the requested one.
const GOOD: f64 = 0.75;

/// Thickness, relative to the requested one, below which a wall is given up.
const MIN_SHARE: f64 = 0.1;

/// Factor by which a round thins the wall where it still intersects itself.
const THINNED: f64 = 0.85;

/// Further sweeps hardly change the directions.
const MAX_SWEEPS: f64 = 400.0;

/// Cosine of the angle (60°) between direction and normal beyond which the offset is not lengthened further.
const MIN_COSINE: f64 = 0.5;

/// Positions of the back, and the thickness at each vertex.
pub(crate) struct Back {
    pub positions: Vec<DVec3>,
    pub thickness: Vec<f64>,
}

impl Back {
    fn thinnest(&self) -> f64 {
        least(&self.thickness)
    }
}

fn least(lengths: &[f64]) -> f64 {
    lengths.iter().copied().fold(f64::INFINITY, f64::min)
}

/// Triangles of the front, the back and the strip between their rims.
pub(crate) fn joined(front: &Front) -> Vec<[u32; 3]> {
    let behind = |vertex: u32| vertex + front.positions.len() as u32;
    let mut triangles = front.topology.triangles().to_vec();
    triangles.extend(front.topology.triangles().iter().map(|&[a, b, c]| [c, b, a].map(behind)));
    for (at, &a) in front.rim.iter().enumerate() {
        let b = front.rim[(at + 1) % front.rim.len()];
        triangles.extend([[b, a, behind(a)], [b, behind(a), behind(b)]]);
    }
    triangles
}

/// Offset directions of the vertices.
struct Offsets<'a> {
    front: &'a Front,
    normals: Vec<DVec3>,
    outward: Vec<DVec3>,
    shares: Vec<f64>,
}

/// The back of a wall of the given thickness; `None` if it would intersect itself or the front.
///
/// The back is offset along the normals. At intersections, the wall is thinned or the directions are smoothed, so that
/// neighbouring vertices keep their order. Returns the attempt with the largest minimum thickness.
pub(crate) fn back(front: &Front, thickness: f64) -> Option<Back> {
    let mut best: Option<Back> = None;
    for (radius, repair) in TRIES {
        let found = Offsets::smoothed(front, radius * thickness).repaired(thickness, repair, MIN_SHARE).ok();
        best = [best, found].into_iter().flatten().max_by(|one, other| one.thinnest().total_cmp(&other.thinnest()));
        if best.as_ref().is_some_and(|best| best.thinnest() >= GOOD * thickness) {
            break;
        }
    }
    best
}

/// Like [`back`], but requires a good thickness everywhere, and gives up earlier.
///
/// # Errors
/// The vertices behind which there is no room, from the attempt with the fewest.
pub(crate) fn good_back(front: &Front, thickness: f64) -> Result<Back, Vec<bool>> {
    let mut tightest: Option<Vec<bool>> = None;
    for (radius, repair) in TRIES {
        let tight = match Offsets::smoothed(front, radius * thickness).repaired(thickness, repair, GOOD) {
            Ok(back) => return Ok(back),
            Err(tight) => tight,
        };
        let count = |tight: &Vec<bool>| tight.iter().filter(|tight| **tight).count();
        tightest = tightest.into_iter().chain([tight]).min_by_key(count);
    }
    Err(tightest.unwrap_or_default())
}

/// Repair of a wall that intersects itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Repair {
    Thin,
    BendAndThin,
}

impl<'a> Offsets<'a> {
    fn new(front: &'a Front) -> Self {
        let normals = vertex_normals(&front.topology, &front.positions);
        let outward = visible_directions(&front.topology, &front.positions, &normals);
        Self { front, normals, outward, shares: vec![1.0; front.positions.len()] }
    }

    /// Smooths the directions over about `radius`.
    fn smoothed(front: &'a Front, radius: f64) -> Self {
        let sweeps = (radius / front.side).powi(2).min(MAX_SWEEPS);
        let mut offsets = Self::new(front);
        (0..sweeps.ceil() as usize).for_each(|_| offsets.bend(|_| true));
        offsets
    }

    /// Repairs the wall where it intersects itself, thinning it to no less than `least_share`. Otherwise returns the
    /// vertices where that is not enough.
    fn repaired(mut self, thickness: f64, repair: Repair, least_share: f64) -> Result<Back, Vec<bool>> {
        let front = self.front;
        let triangles = joined(front);
        let count = front.positions.len();
        let mut positions = [front.positions.as_slice(), &self.ends(thickness)].concat();
        let mut pairs = crossings(&triangles, &positions);
        let mut round = 0;
        while !pairs.is_empty() {
            let mut marked = vec![false; count];
            for &triangle in pairs.as_flattened() {
                triangles[triangle as usize].iter().for_each(|&corner| marked[corner as usize % count] = true);
            }
            for _ in 0..=round / 4 {
                marked = dilated(&front.topology, &marked);
            }
            if repair == Repair::BendAndThin {
                self.bend(|vertex| marked[vertex]);
            }
            self.thin(&marked);
            if self.shares.iter().any(|&share| share < least_share) {
                return Err(self.shares.iter().map(|&share| share < least_share).collect());
            }
            positions.truncate(count);
            positions.extend(self.ends(thickness));
            let moved =
                |triangle: u32| triangles[triangle as usize].iter().any(|&corner| marked[corner as usize % count]);
            pairs = crossings_of(&triangles, &positions, moved);
            round += 1;
        }
        let across = self.across(thickness);
        match least(&across) > 0.0 {
            true => Ok(Back { thickness: across, positions: positions.split_off(count) }),
            false => Err(vec![true; count]),
        }
    }

    fn length(&self, vertex: usize, thickness: f64) -> f64 {
        thickness * self.shares[vertex] / self.outward[vertex].dot(self.normals[vertex]).max(MIN_COSINE)
    }

    fn ends(&self, thickness: f64) -> Vec<DVec3> {
        let positions = self.front.positions.iter().enumerate();
        positions.map(|(vertex, &position)| position - self.length(vertex, thickness) * self.outward[vertex]).collect()
    }

    /// Thickness along the normals.
    fn across(&self, thickness: f64) -> Vec<f64> {
        let across = |vertex: usize| self.length(vertex, thickness) * self.outward[vertex].dot(self.normals[vertex]);
        (0..self.shares.len()).map(across).collect()
    }

    /// Replaces each selected direction by the mean of its neighbours.
    fn bend(&mut self, is_marked: impl Fn(usize) -> bool) {
        let old = self.outward.clone();
        for vertex in (0..old.len()).filter(|&vertex| is_marked(vertex)) {
            let around: DVec3 = self.neighbours(vertex).map(|next| old[next]).sum();
            self.outward[vertex] = around.normalize_or(old[vertex]);
        }
    }

    /// Thins the wall at the marked vertices, and smooths the thickness there.
    fn thin(&mut self, marked: &[bool]) {
        let marked_vertices = || (0..marked.len()).filter(|&vertex| marked[vertex]);
        marked_vertices().for_each(|vertex| self.shares[vertex] *= THINNED);
        let old = self.shares.clone();
        for vertex in marked_vertices() {
            let (sum, count) =
                self.neighbours(vertex).fold((0.0, 0.0), |(sum, count), next| (sum + old[next], count + 1.0));
            self.shares[vertex] = old[vertex].min(sum / count);
        }
    }

    fn neighbours(&self, vertex: usize) -> impl Iterator<Item = usize> + '_ {
        self.front.topology.neighbours(vertex as u32).iter().map(|&next| next as usize)
    }
}

/// For each vertex, a direction in front of all its triangles, if there is one: the axis of the narrowest cone around
/// their normals, approximated iteratively (Bădoiu & Clarkson 2003).
fn visible_directions(topology: &Topology, positions: &[DVec3], start: &[DVec3]) -> Vec<DVec3> {
    const STEPS: usize = 24;
    let mut faces = vec![Vec::new(); positions.len()];
    for &corners in topology.triangles() {
        let [a, b, c] = corners.map(|corner| positions[corner as usize]);
        if let Some(normal) = (b - a).cross(c - a).try_normalize() {
            corners.iter().for_each(|&corner| faces[corner as usize].push(normal));
        }
    }
    let axis = |(faces, &start): (&Vec<DVec3>, &DVec3)| {
        (0..STEPS).fold(start, |direction, step| {
            let farthest = faces.iter().min_by(|one, other| one.dot(direction).total_cmp(&other.dot(direction)));
            let pulled = direction + *farthest.unwrap_or(&direction) / (step + 2) as f64;
            pulled.normalize_or(direction)
        })
    };
    faces.iter().zip(start).map(axis).collect()
}
