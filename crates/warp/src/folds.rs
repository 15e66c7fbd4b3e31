use glam::DVec2;

use crate::layout::Role;

/// Reduces offsets until no triangle of a planar triangulation is folded.
///
/// Each folded triangle pushes its corners by the smallest displacement that restores its minimum area: one Newton step
/// on the area, as in position-based dynamics. A corner moves by the mean of its triangles' corrections. Triangles that
/// stay folded, because a point crossed others, also average their offsets with their neighbours' (diffusion): equal
/// offsets cannot fold. If folds remain, all offsets are scaled by one factor.
pub(crate) struct FoldRemoval {
    /// Triangles with at least one movable corner.
    triangles: Vec<Flat>,
    /// Start of each vertex's triangles in `at_vertices`.
    starts: Vec<usize>,
    at_vertices: Vec<u32>,
    is_fixed: Vec<bool>,
    scratch: Scratch,
}

/// A triangle at rest: its edges from the first corner, and twice its signed area.
struct Flat {
    corners: [u32; 3],
    edges: [DVec2; 2],
    doubled_area: f64,
}

/// Folded triangles and scratch buffers, so that a tick does not allocate.
#[derive(Default)]
struct Scratch {
    folded: Vec<u32>,
    corners: Vec<u32>,
    targets: Vec<DVec2>,
    /// Last offsets without folds.
    unfolded: Vec<DVec2>,
    /// Per vertex: the sum of its triangles' corrections, and their number.
    asked: Vec<(DVec2, u32)>,
}

/// Minimum share of its area that a triangle keeps, so that its content stays visible.
const MIN_AREA: f64 = 0.12;
/// Area after a correction; the margin avoids repeated corrections.
const PUSHED_AREA: f64 = 0.15;
/// Over-relaxation factor. Without it, triangles with the same correction converge slowly.
const OVER_RELAXATION: f64 = 1.5;
/// Iterations; from `SPREAD_FROM` on, push and diffusion alternate. `HALVINGS` are bisection steps of the scale.
const ROUNDS: usize = 140;
const SPREAD_FROM: usize = 70;
const HALVINGS: usize = 24;
/// Smoothing passes over creases, and push iterations after each.
const SMOOTHING_PASSES: usize = 6;
const PUSHES_PER_PASS: usize = 12;

impl FoldRemoval {
    pub(crate) fn new(triangles: &[[u32; 3]], positions: &[DVec2], roles: &[Role]) -> Self {
        let is_fixed: Vec<bool> = roles.iter().map(|role| *role == Role::Fixed).collect();
        let can_move = |corners: &&[u32; 3]| corners.iter().any(|&corner| !is_fixed[corner as usize]);
        let triangles: Vec<Flat> =
            triangles.iter().filter(can_move).map(|&corners| Flat::new(corners, positions)).collect();
        let (starts, at_vertices) = by_vertex(&triangles, positions.len());
        let scratch = Scratch { asked: vec![(DVec2::ZERO, 0); positions.len()], ..Scratch::default() };
        Self { triangles, starts, at_vertices, is_fixed, scratch }
    }

    pub(crate) fn folds(&self, offsets: &[DVec2]) -> bool {
        (0..self.triangles.len() as u32).any(|triangle| self.is_folded(triangle, offsets))
    }

    pub(crate) fn limit(&mut self, offsets: &mut [DVec2]) {
        let mut scratch = std::mem::take(&mut self.scratch);
        self.limit_in(&mut scratch, offsets);
        self.scratch = scratch;
    }

    fn limit_in(&self, scratch: &mut Scratch, offsets: &mut [DVec2]) {
        scratch.folded.clear();
        scratch.folded.extend((0..self.triangles.len() as u32).filter(|&triangle| self.is_folded(triangle, offsets)));
        if scratch.folded.is_empty() {
            return;
        }
        scratch.targets.clear();
        scratch.targets.extend_from_slice(offsets);
        for round in 0..ROUNDS {
            match round >= SPREAD_FROM && round % 2 == 0 {
                true => self.spread(scratch, offsets),
                false => self.push(scratch, offsets),
            }
            self.find_folded(scratch, offsets);
            if scratch.folded.is_empty() {
                break;
            }
        }
        match scratch.folded.is_empty() {
            true => self.smooth(scratch, offsets),
            false => self.scale_down(offsets),
        }
    }

    /// Whether the triangle is inverted or below its minimum area.
    fn is_folded(&self, triangle: u32, offsets: &[DVec2]) -> bool {
        let flat = &self.triangles[triangle as usize];
        let [ab, ac] = flat.after(offsets);
        ab.perp_dot(ac) * flat.doubled_area.signum() < MIN_AREA * flat.doubled_area.abs()
    }

    /// Moves the corners of folded triangles by the mean of their corrections.
    fn push(&self, scratch: &mut Scratch, offsets: &mut [DVec2]) {
        let Scratch { folded, corners, asked, .. } = scratch;
        corners.clear();
        for flat in folded.iter().map(|&triangle| &self.triangles[triangle as usize]) {
            for (corner, push) in flat.corners.into_iter().zip(flat.pushes(offsets, &self.is_fixed)) {
                let (sum, count) = &mut asked[corner as usize];
                (*sum, *count) = (*sum + push, *count + 1);
                corners.push(corner);
            }
        }
        sort_unique(corners);
        for &vertex in corners.iter() {
            let (sum, count) = std::mem::take(&mut asked[vertex as usize]);
            offsets[vertex as usize] += sum * (OVER_RELAXATION / f64::from(count));
        }
    }

    /// Smooths creases: averages corrected offsets with their neighbours' while no triangle folds.
    fn smooth(&self, scratch: &mut Scratch, offsets: &mut [DVec2]) {
        for _ in 0..SMOOTHING_PASSES {
            scratch.unfolded.clear();
            scratch.unfolded.extend_from_slice(offsets);
            scratch.corners.clear();
            let pushed = offsets.iter().zip(&scratch.targets).zip(0..).filter(|((now, targets), _)| now != targets);
            scratch.corners.extend(pushed.map(|(_, vertex)| vertex));
            self.spread_at(scratch, offsets);
            for _ in 0..PUSHES_PER_PASS {
                self.find_folded(scratch, offsets);
                if scratch.folded.is_empty() {
                    break;
                }
                self.push(scratch, offsets);
            }
            if !scratch.folded.is_empty() {
                offsets.copy_from_slice(&scratch.unfolded);
                return;
            }
        }
    }

    /// Moves the corners of folded triangles halfway to the mean offset around them.
    fn spread(&self, scratch: &mut Scratch, offsets: &mut [DVec2]) {
        let Scratch { folded, corners, .. } = &mut *scratch;
        corners.clear();
        corners.extend(folded.iter().flat_map(|&triangle| self.triangles[triangle as usize].corners));
        sort_unique(corners);
        self.spread_at(scratch, offsets);
    }

    fn spread_at(&self, scratch: &mut Scratch, offsets: &mut [DVec2]) {
        let Scratch { corners, asked, .. } = scratch;
        corners.retain(|&vertex| !self.is_fixed[vertex as usize]);
        for &vertex in corners.iter() {
            asked[vertex as usize].0 = 0.5 * (self.mean(vertex, offsets) - offsets[vertex as usize]);
        }
        for &vertex in corners.iter() {
            offsets[vertex as usize] += std::mem::take(&mut asked[vertex as usize].0);
        }
    }

    fn mean(&self, vertex: u32, offsets: &[DVec2]) -> DVec2 {
        let triangles = self.triangles_at(vertex);
        let corners = triangles.iter().flat_map(|&triangle| self.triangles[triangle as usize].corners);
        corners.map(|corner| offsets[corner as usize]).sum::<DVec2>() / (3 * triangles.len()) as f64
    }

    /// Updates the folded triangles; only those at moved corners can have changed.
    fn find_folded(&self, scratch: &mut Scratch, offsets: &[DVec2]) {
        let Scratch { folded, corners, .. } = scratch;
        folded.clear();
        folded.extend(corners.iter().flat_map(|&vertex| self.triangles_at(vertex)));
        sort_unique(folded);
        folded.retain(|&triangle| self.is_folded(triangle, offsets));
    }

    fn triangles_at(&self, vertex: u32) -> &[u32] {
        &self.at_vertices[self.starts[vertex as usize]..self.starts[vertex as usize + 1]]
    }

    /// Scales all offsets by the largest factor without folds, found by bisection. Zero offsets do not fold.
    fn scale_down(&self, offsets: &mut [DVec2]) {
        let (mut fits, mut folds) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            let share = 0.5 * (fits + folds);
            match self.triangles.iter().all(|flat| flat.fits_at(share, offsets)) {
                true => fits = share,
                false => folds = share,
            }
        }
        offsets.iter_mut().for_each(|offset| *offset *= fits);
    }
}

impl Flat {
    fn new(corners: [u32; 3], positions: &[DVec2]) -> Self {
        let [a, b, c] = corners.map(|corner| positions[corner as usize]);
        Self { corners, edges: [b - a, c - a], doubled_area: doubled_area([a, b, c]) }
    }

    /// Edges after the offsets are applied.
    fn after(&self, offsets: &[DVec2]) -> [DVec2; 2] {
        let [a, b, c] = self.corners.map(|corner| offsets[corner as usize]);
        [self.edges[0] + (b - a), self.edges[1] + (c - a)]
    }

    /// Smallest displacements of the movable corners that restore the area, to first order.
    fn pushes(&self, offsets: &[DVec2], is_fixed: &[bool]) -> [DVec2; 3] {
        let [ab, ac] = self.after(offsets);
        let missing = PUSHED_AREA * self.doubled_area - ab.perp_dot(ac);
        let slopes = [(ac - ab).perp(), -ac.perp(), ab.perp()];
        let free = [0, 1, 2].map(|k| if is_fixed[self.corners[k] as usize] { DVec2::ZERO } else { slopes[k] });
        let steepness: f64 = free.iter().map(|slope| slope.length_squared()).sum();
        // A degenerate triangle has no gradient; its edge lengths bound the step.
        let max_step = [ab, ac, self.edges[0], self.edges[1]].map(DVec2::length).into_iter().fold(0.0, f64::max);
        free.map(|slope| (slope * (missing / steepness.max(f64::MIN_POSITIVE))).clamp_length_max(max_step))
    }

    /// Whether the triangle is not folded at this share of the offsets.
    fn fits_at(&self, share: f64, offsets: &[DVec2]) -> bool {
        let [a, b, c] = self.corners.map(|corner| offsets[corner as usize] * share);
        let after = (self.edges[0] + (b - a)).perp_dot(self.edges[1] + (c - a));
        after * self.doubled_area.signum() >= MIN_AREA * self.doubled_area.abs()
    }
}

/// Triangles at each vertex and their start indices (compressed adjacency).
fn by_vertex(triangles: &[Flat], vertices: usize) -> (Vec<usize>, Vec<u32>) {
    let mut starts = vec![0; vertices + 1];
    let corners =
        || triangles.iter().zip(0..).flat_map(|(flat, triangle)| flat.corners.map(|corner| (corner, triangle)));
    corners().for_each(|(corner, _)| starts[corner as usize + 1] += 1);
    (0..vertices).for_each(|vertex| starts[vertex + 1] += starts[vertex]);
    let (mut next, mut at_vertices) = (starts.clone(), vec![0; 3 * triangles.len()]);
    for (corner, triangle) in corners() {
        at_vertices[next[corner as usize]] = triangle;
        next[corner as usize] += 1;
    }
    (starts, at_vertices)
}

fn sort_unique(values: &mut Vec<u32>) {
    values.sort_unstable();
    values.dedup();
}

/// Twice the signed area.
pub(crate) fn doubled_area([a, b, c]: [DVec2; 3]) -> f64 {
    (b - a).perp_dot(c - a)
}
