//! The other side of a wall: a copy of the front, moved inward.

use glam::DVec3;
use rosto_mesh::{Topology, vertex_normals};

use crate::crossings::{crossings, crossings_of};
use crate::front::{Front, grown};

/// How far directions are smoothed, as shares of the thickness, and what is done where the wall goes through itself all the
/// same: one after the other until a wall is as thick as it should be.
const TRIES: [(f64, Mending); 4] =
    [(2.8, Mending::BendAndThin), (1.4, Mending::BendAndThin), (0.5, Mending::BendAndThin), (0.0, Mending::Thin)];

/// A wall that is nowhere thinner than this share of what was asked for is good enough.
const GOOD: f64 = 0.75;

/// A wall that has become thinner than this share of what was asked for is given up.
const THINNEST: f64 = 0.1;

/// What a round leaves of the thickness where the wall still goes through itself.
const THINNED: f64 = 0.85;

/// More sweeps make directions no smoother to speak of.
const MOST_SWEEPS: f64 = 400.0;

/// A direction that leans more than this away from the surface makes the way longer no further: 60°.
const LEAST_COSINE: f64 = 0.5;

/// Where the back of the wall lies, and how thick it is where it is thinnest.
pub(crate) struct Back {
    pub positions: Vec<DVec3>,
    pub thinnest: f64,
}

/// The triangles of the front, of its copy behind, and of the strip that joins their rims.
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

/// The way inward from each vertex.
struct Ways<'a> {
    front: &'a Front,
    normals: Vec<DVec3>,
    outward: Vec<DVec3>,
    shares: Vec<f64>,
}

/// The back of a wall of that thickness; none if it would go through itself or the front.
///
/// The back lies along the normals. Where it would go through something, the wall is thinned, or the directions are smoothed,
/// so that what lies beside each other goes the same way and keeps its order; that wall is taken which is thickest where it
/// is thinnest.
pub(crate) fn back(front: &Front, thickness: f64) -> Option<Back> {
    let mut best: Option<Back> = None;
    for (reach, mending) in TRIES {
        let found = Ways::smoothed(front, reach * thickness).mended(thickness, mending, THINNEST).ok();
        best = [best, found].into_iter().flatten().max_by(|one, other| one.thinnest.total_cmp(&other.thinnest));
        if best.as_ref().is_some_and(|best| best.thinnest >= GOOD * thickness) {
            break;
        }
    }
    best
}

/// The same, good enough everywhere, sooner given up.
///
/// # Errors
/// The vertices behind which there is no room, where most of the wall has some.
pub(crate) fn good_back(front: &Front, thickness: f64) -> Result<Back, Vec<bool>> {
    let mut tightest: Option<Vec<bool>> = None;
    for (reach, mending) in TRIES {
        let tight = match Ways::smoothed(front, reach * thickness).mended(thickness, mending, GOOD) {
            Ok(back) => return Ok(back),
            Err(tight) => tight,
        };
        let count = |tight: &Vec<bool>| tight.iter().filter(|tight| **tight).count();
        tightest = tightest.into_iter().chain([tight]).min_by_key(count);
    }
    Err(tightest.unwrap_or_default())
}

/// What is done where a wall goes through itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Mending {
    Thin,
    BendAndThin,
}

impl<'a> Ways<'a> {
    fn new(front: &'a Front) -> Self {
        let normals = vertex_normals(&front.topology, &front.positions);
        let outward = seen_from_all(&front.topology, &front.positions, &normals);
        Self { front, normals, outward, shares: vec![1.0; front.positions.len()] }
    }

    /// With directions that are smoothed as far as that.
    fn smoothed(front: &'a Front, reach: f64) -> Self {
        let sweeps = (reach / front.side).powi(2).min(MOST_SWEEPS);
        let mut ways = Self::new(front);
        (0..sweeps.ceil() as usize).for_each(|_| ways.bend(|_| true));
        ways
    }

    /// The wall, thinned wherever it goes through itself, but to no less than a share of its thickness; else the vertices where
    /// that is not enough.
    fn mended(mut self, thickness: f64, mending: Mending, least_share: f64) -> Result<Back, Vec<bool>> {
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
                marked = grown(&front.topology, &marked);
            }
            if mending == Mending::BendAndThin {
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
        let thinnest = self.thinnest(thickness);
        match thinnest > 0.0 {
            true => Ok(Back { thinnest, positions: positions.split_off(count) }),
            false => Err(vec![true; count]),
        }
    }

    fn length(&self, vertex: usize, thickness: f64) -> f64 {
        thickness * self.shares[vertex] / self.outward[vertex].dot(self.normals[vertex]).max(LEAST_COSINE)
    }

    fn ends(&self, thickness: f64) -> Vec<DVec3> {
        let places = self.front.positions.iter().enumerate();
        places.map(|(vertex, &place)| place - self.length(vertex, thickness) * self.outward[vertex]).collect()
    }

    fn thinnest(&self, thickness: f64) -> f64 {
        let across = |vertex: usize| self.length(vertex, thickness) * self.outward[vertex].dot(self.normals[vertex]);
        (0..self.shares.len()).map(across).fold(f64::INFINITY, f64::min)
    }

    /// Each direction as those around it are in the middle.
    fn bend(&mut self, is_marked: impl Fn(usize) -> bool) {
        let old = self.outward.clone();
        for vertex in (0..old.len()).filter(|&vertex| is_marked(vertex)) {
            let around: DVec3 = self.neighbours(vertex).map(|next| old[next]).sum();
            self.outward[vertex] = around.normalize_or(old[vertex]);
        }
    }

    /// Thins the wall there, and eases it into what is around.
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

/// For each vertex a direction that its triangles all face, if there is one: the middle of the narrowest cone around their
/// normals, approached step by step (Bădoiu & Clarkson 2003).
fn seen_from_all(topology: &Topology, positions: &[DVec3], start: &[DVec3]) -> Vec<DVec3> {
    const STEPS: usize = 24;
    let mut faces = vec![Vec::new(); positions.len()];
    for &corners in topology.triangles() {
        let [a, b, c] = corners.map(|corner| positions[corner as usize]);
        if let Some(normal) = (b - a).cross(c - a).try_normalize() {
            corners.iter().for_each(|&corner| faces[corner as usize].push(normal));
        }
    }
    let middle = |(faces, &start): (&Vec<DVec3>, &DVec3)| {
        (0..STEPS).fold(start, |direction, step| {
            let farthest = faces.iter().min_by(|one, other| one.dot(direction).total_cmp(&other.dot(direction)));
            let pulled = direction + *farthest.unwrap_or(&direction) / (step + 2) as f64;
            pulled.normalize_or(direction)
        })
    };
    faces.iter().zip(start).map(middle).collect()
}
