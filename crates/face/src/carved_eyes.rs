//! Eyes as sculptors carve them, which look open in a material of one colour.

use std::collections::{HashMap, HashSet};

use glam::{DVec2, DVec3};
use rosto_mesh::Topology;

use crate::irises::POINTS_OF_AN_IRIS;
use crate::openings::{Opening, corners};
use crate::{FaceModel, LANDMARK_COUNT};

const EYES: [Opening; 2] = [Opening::RightEye, Opening::LeftEye];

/// Longest edge in a carved eye. All lengths are relative to the distance between the corners of the eye.
const EDGE: f64 = 0.016;
/// Largest number of times that the edges are halved.
const MAX_HALVINGS: usize = 7;

/// Radius of the iris, and that of the pupil.
const IRIS: f64 = 0.2;
const PUPIL: f64 = 0.085;
/// Width of the slopes from one depth to the next.
const SLOPE: f64 = 0.035;
/// Depths behind the lids: of the white, and further ones of the iris and the pupil.
const WHITE_DEPTH: f64 = 0.05;
const IRIS_DEPTH: f64 = 0.035;
const PUPIL_DEPTH: f64 = 0.08;
/// Heights of the opening at which an eye counts as closed, and from which it is carved fully.
const OPENS: [f64; 2] = [0.08, 0.16];
/// Places of an iris along the eye, from the outer corner; it does not pass the corners.
const ALONG: [f64; 2] = [0.25, 0.75];

/// Position of an iris in its eye: along the line from the outer to the inner corner, and above it, both relative to
/// their distance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Gaze(DVec2);

impl Gaze {
    /// The gaze of the right and the left eye, as in the lead photo; `None` for an eye without an iris.
    pub fn of_face(face: &FaceModel) -> [Option<Self>; 2] {
        let centre = |eye: usize| face.irises_m().get(eye * POINTS_OF_AN_IRIS).copied();
        [0, 1].map(|eye| Some(Self(Frame::new(EYES[eye], face.positions_m())?.place(centre(eye)?))))
    }
}

/// Depths to carve into the eyes of a mesh: the white lies behind the lids, the iris deeper, and the pupil deepest.
///
/// The mesh's vertices keep their indices; finer triangles in the eyes add some, halfway between others. Depths are
/// along −Z, so that a surface that is visible from +Z stays so. An eye that the mesh leaves open or that is closed is
/// not carved.
#[derive(Debug, Clone)]
pub struct CarvedEyes {
    topology: Topology,
    mesh_count: usize,
    /// The two vertices halfway between which each added vertex lies.
    midpoints: Vec<[u32; 2]>,
    eyes: Vec<Eye>,
}

#[derive(Debug, Clone)]
struct Eye {
    opening: Opening,
    gaze: Option<Gaze>,
    rim: Vec<u32>,
    inside: Vec<u32>,
}

impl CarvedEyes {
    /// Refines the eyes of a mesh that is a subdivision of `face`, the triangles of 468 landmarks, with its triangles in
    /// the order of their parents.
    ///
    /// # Panics
    /// If there is not one position per vertex.
    pub fn new(face: &[[u32; 3]], mesh: &Topology, positions_m: &[DVec3], gazes: [Option<Gaze>; 2]) -> Self {
        let parts = (mesh.triangles().len() / face.len().max(1)).max(1);
        let filled: Vec<Option<Opening>> = face.iter().map(Opening::filled_by).collect();
        let opening_of = |triangle: usize| filled.get(triangle / parts).copied().flatten();
        let mut refined = Refined { mesh_count: mesh.vertex_count(), midpoints: Vec::new() };
        let (mut by_parent, mut eyes) = (HashMap::new(), Vec::new());
        for (opening, gaze) in EYES.into_iter().zip(gazes) {
            let filling: Vec<usize> =
                (0..mesh.triangles().len()).filter(|&triangle| opening_of(triangle) == Some(opening)).collect();
            let Some(frame) = Frame::new(opening, positions_m).filter(|_| !filling.is_empty()) else { continue };
            let triangles = filling.iter().map(|&triangle| (triangle, mesh.triangles()[triangle])).collect();
            let (triangles, rim) = refined.halved(triangles, positions_m, EDGE * frame.width);
            let on_rim: HashSet<u32> = rim.iter().copied().collect();
            let mut inside: Vec<u32> = triangles.iter().flat_map(|(_, corners)| *corners).collect();
            inside.sort_unstable();
            inside.dedup();
            inside.retain(|vertex| !on_rim.contains(vertex));
            triangles.into_iter().for_each(|(parent, corners)| {
                by_parent.entry(parent).or_insert_with(Vec::new).push(corners);
            });
            eyes.push(Eye { opening, gaze, rim, inside });
        }
        let triangles = mesh.triangles().iter().enumerate();
        let triangles = triangles.flat_map(|(at, corners)| by_parent.remove(&at).unwrap_or_else(|| vec![*corners]));
        let count = mesh.vertex_count() + refined.midpoints.len();
        let topology = Topology::new(count, triangles.collect()).expect("invariant: a refined mesh is a mesh");
        Self { topology, mesh_count: mesh.vertex_count(), midpoints: refined.midpoints, eyes }
    }

    /// Triangles: those of the mesh in their order, each replaced by its parts.
    pub fn topology(&self) -> &Topology {
        &self.topology
    }

    /// The two vertices halfway between which each added vertex lies.
    pub fn midpoints(&self) -> &[[u32; 2]] {
        &self.midpoints
    }

    /// Depth of each vertex along −Z, in the unit of the mesh's positions.
    ///
    /// # Panics
    /// If there are fewer positions than mesh vertices.
    pub fn depths(&self, positions: &[DVec3]) -> Vec<f64> {
        let positions = self.refined(positions, |a, b| a.midpoint(b));
        let mut depths = vec![0.0; positions.len()];
        self.eyes.iter().for_each(|eye| eye.carve(&positions, &mut depths));
        depths
    }

    /// Colours, from those of the mesh.
    ///
    /// # Panics
    /// If there are fewer colours than mesh vertices.
    pub fn colours(&self, colours: &[[u8; 3]]) -> Vec<[u8; 3]> {
        self.refined(colours, |a, b| [0, 1, 2].map(|at| u8::midpoint(a[at], b[at])))
    }

    fn refined<T: Copy>(&self, values: &[T], middle: impl Fn(T, T) -> T) -> Vec<T> {
        let mut values = values[..self.mesh_count].to_vec();
        self.midpoints.iter().for_each(|&[a, b]| values.push(middle(values[a as usize], values[b as usize])));
        values
    }
}

impl Eye {
    fn carve(&self, positions_m: &[DVec3], depths_m: &mut [f64]) {
        let Some(frame) = Frame::new(self.opening, positions_m) else { return };
        let rim: Vec<DVec2> = self.rim.iter().map(|&vertex| frame.place(positions_m[vertex as usize])).collect();
        let highest = rim.iter().map(|at| at.y).fold(f64::NEG_INFINITY, f64::max);
        let lowest = rim.iter().map(|at| at.y).fold(f64::INFINITY, f64::min);
        let openness = smooth_step((highest - lowest - OPENS[0]) / (OPENS[1] - OPENS[0]));
        let middle = rim.iter().sum::<DVec2>() / rim.len() as f64;
        let gaze = self.gaze.map_or(middle, |Gaze(at)| DVec2::new(at.x.clamp(ALONG[0], ALONG[1]), at.y));
        for &vertex in &self.inside {
            let place = frame.place(positions_m[vertex as usize]);
            depths_m[vertex as usize] = openness * frame.width * depth(place, &rim, gaze);
        }
    }
}

/// Depth of a point of an eye behind the lids.
fn depth(at: DVec2, rim: &[DVec2], iris: DVec2) -> f64 {
    let sides = rim.iter().zip(rim.iter().cycle().skip(1));
    let from_lids = sides.map(|(a, b)| distance(at, *a, *b)).fold(f64::INFINITY, f64::min);
    let within = |radius: f64| smooth_step((radius - at.distance(iris)) / SLOPE + 0.5);
    smooth_step(from_lids / SLOPE) * (WHITE_DEPTH + IRIS_DEPTH * within(IRIS) + PUPIL_DEPTH * within(PUPIL))
}

/// Distance from a point to the segment from `a` to `b`.
fn distance(at: DVec2, a: DVec2, b: DVec2) -> f64 {
    let along = (at - a).dot(b - a) / a.distance_squared(b).max(f64::MIN_POSITIVE);
    at.distance(a.lerp(b, along.clamp(0.0, 1.0)))
}

/// 0 up to 0, 1 from 1, without a kink in between.
fn smooth_step(at: f64) -> f64 {
    let at = at.clamp(0.0, 1.0);
    at * at * (3.0 - 2.0 * at)
}

/// The plane of an eye, which contains both corners and faces +Z as far as possible.
struct Frame {
    outer: DVec3,
    along: DVec3,
    up: DVec3,
    width: f64,
}

impl Frame {
    /// `None` for an eye without a width.
    fn new(opening: Opening, positions_m: &[DVec3]) -> Option<Self> {
        debug_assert!(positions_m.len() >= LANDMARK_COUNT, "the landmarks come first");
        let [outer, inner] = corners(opening).map(|corner| positions_m[corner as usize]);
        let along = (inner - outer).try_normalize()?;
        let forward = DVec3::Z.reject_from_normalized(along).try_normalize()?;
        let up = forward.cross(along);
        Some(Self { outer, along, up: if up.y < 0.0 { -up } else { up }, width: inner.distance(outer) })
    }

    /// Position in the plane, relative to the outer corner and the width.
    fn place(&self, position: DVec3) -> DVec2 {
        let from = (position - self.outer) / self.width;
        DVec2::new(from.dot(self.along), from.dot(self.up))
    }
}

/// Vertices that are added to a mesh.
struct Refined {
    mesh_count: usize,
    midpoints: Vec<[u32; 2]>,
}

impl Refined {
    /// Halves edges inside the triangles that are longer than `longest`; those on their rim stay. Each triangle has the
    /// index of its parent. Also returns the rim.
    fn halved(
        &mut self,
        mut triangles: Vec<(usize, [u32; 3])>,
        positions_m: &[DVec3],
        longest: f64,
    ) -> (Vec<(usize, [u32; 3])>, Vec<u32>) {
        let mut positions_m = positions_m[..self.mesh_count].to_vec();
        positions_m.extend(std::iter::repeat_n(DVec3::ZERO, self.midpoints.len()));
        let directed: HashSet<[u32; 2]> = triangles.iter().flat_map(|(_, corners)| sides(*corners)).collect();
        let rim: HashMap<u32, u32> =
            directed.iter().filter(|[a, b]| !directed.contains(&[*b, *a])).map(|&[a, b]| (a, b)).collect();
        let is_rim = |[a, b]: [u32; 2]| rim.get(&a) == Some(&b) || rim.get(&b) == Some(&a);
        for _ in 0..MAX_HALVINGS {
            let is_long = |[a, b]: [u32; 2]| positions_m[a as usize].distance(positions_m[b as usize]) > longest;
            let all = triangles.iter().flat_map(|(_, corners)| sides(*corners));
            let long: Vec<[u32; 2]> = all.filter(|side| !is_rim(*side) && is_long(*side)).collect();
            if long.is_empty() {
                break;
            }
            let mut middles: HashMap<[u32; 2], u32> = HashMap::new();
            for [a, b] in long {
                middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                    self.midpoints.push([a.min(b), a.max(b)]);
                    positions_m.push(positions_m[a as usize].midpoint(positions_m[b as usize]));
                    positions_m.len() as u32 - 1
                });
            }
            let parts = |(parent, corners): &(usize, [u32; 3])| {
                let middles = sides(*corners).map(|[a, b]| middles.get(&[a.min(b), a.max(b)]).copied());
                let parent = *parent;
                split(*corners, middles).into_iter().map(move |corners| (parent, corners)).collect::<Vec<_>>()
            };
            triangles = triangles.iter().flat_map(parts).collect();
        }
        (triangles, cycle(&rim))
    }
}

/// Directed sides of a triangle.
fn sides([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

/// Parts of a triangle of which some sides have a midpoint.
fn split([a, b, c]: [u32; 3], [ab, bc, ca]: [Option<u32>; 3]) -> Vec<[u32; 3]> {
    match [ab, bc, ca] {
        [Some(ab), Some(bc), Some(ca)] => vec![[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]],
        [None, Some(bc), Some(ca)] => vec![[ca, bc, c], [a, b, bc], [a, bc, ca]],
        [Some(_), None, Some(_)] => split([b, c, a], [bc, ca, ab]),
        [Some(_), Some(_), None] => split([c, a, b], [ca, ab, bc]),
        [Some(ab), None, None] => vec![[a, ab, c], [ab, b, c]],
        [None, Some(_), None] => split([b, c, a], [bc, ca, ab]),
        [None, None, Some(_)] => split([c, a, b], [ca, ab, bc]),
        [None, None, None] => vec![[a, b, c]],
    }
}

/// The vertices of a closed chain of successors.
fn cycle(next: &HashMap<u32, u32>) -> Vec<u32> {
    let Some(&start) = next.keys().min() else { return Vec::new() };
    let follow = |at: &u32| next.get(at).copied().filter(|&at| at != start);
    std::iter::successors(Some(start), follow).take(next.len()).collect()
}
