use glam::DVec2;

use crate::layout::Tie;

/// Changes offsets until no triangle of a flat triangulation is turned over.
///
/// Each triangle that would fold pushes its corners apart, by the least way that gives it back the area it is to keep (one
/// Newton step on the area, as position-based dynamics does it); a corner goes by the mean of what its triangles ask. A point
/// that went over others is not freed so: what is folded still becomes more like what is beside it, too, as heat spreads, since
/// an offset that all neighbours share folds nothing. What is folded even then takes all offsets back by one share.
pub(crate) struct Unfolding {
    /// Those that can move.
    triangles: Vec<Flat>,
    /// For each vertex, where its triangles begin in `at_vertices`.
    starts: Vec<usize>,
    at_vertices: Vec<u32>,
    stays: Vec<bool>,
    work: Work,
}

/// A triangle before anything moved: two of its edges, from its first corner, and twice its area.
struct Flat {
    corners: [u32; 3],
    edges: [DVec2; 2],
    doubled_area: f64,
}

/// What is folded, and room to work in: a tick allocates nothing.
#[derive(Default)]
struct Work {
    folded: Vec<u32>,
    corners: Vec<u32>,
    wanted: Vec<DVec2>,
    /// What folds nothing, before it is smoothed.
    whole: Vec<DVec2>,
    /// For each vertex, the sum of what its triangles ask of it, and how many do.
    asked: Vec<(DVec2, u32)>,
}

/// A triangle keeps at least this share of its area, so that what is in it can still be seen.
const LEAST_AREA: f64 = 0.12;
/// What is pushed apart gets a little more, so that it need not be again.
const PUSHED_AREA: f64 = 0.15;
/// A corner goes so much further than the mean of what is asked of it: triangles that ask the same would wait for each other.
const EAGERNESS: f64 = 1.5;
/// Rounds of pushing, from which on every second one spreads, and of halving.
const ROUNDS: usize = 140;
const SPREAD_FROM: usize = 70;
const HALVINGS: usize = 24;
/// How often creases are smoothed, and the rounds of pushing after each time.
const POLISHINGS: usize = 6;
const PUSHES_AFTER: usize = 12;

impl Unfolding {
    pub(crate) fn new(triangles: &[[u32; 3]], places: &[DVec2], ties: &[Tie]) -> Self {
        let stays: Vec<bool> = ties.iter().map(|tie| *tie == Tie::Stays).collect();
        let can_move = |corners: &&[u32; 3]| corners.iter().any(|&corner| !stays[corner as usize]);
        let triangles: Vec<Flat> =
            triangles.iter().filter(can_move).map(|&corners| Flat::new(corners, places)).collect();
        let (starts, at_vertices) = by_vertex(&triangles, places.len());
        let work = Work { asked: vec![(DVec2::ZERO, 0); places.len()], ..Work::default() };
        Self { triangles, starts, at_vertices, stays, work }
    }

    pub(crate) fn folds(&self, offsets: &[DVec2]) -> bool {
        (0..self.triangles.len() as u32).any(|triangle| self.is_folded(triangle, offsets))
    }

    pub(crate) fn limit(&mut self, offsets: &mut [DVec2]) {
        let mut work = std::mem::take(&mut self.work);
        self.limit_in(&mut work, offsets);
        self.work = work;
    }

    fn limit_in(&self, work: &mut Work, offsets: &mut [DVec2]) {
        work.folded.clear();
        work.folded.extend((0..self.triangles.len() as u32).filter(|&triangle| self.is_folded(triangle, offsets)));
        if work.folded.is_empty() {
            return;
        }
        work.wanted.clear();
        work.wanted.extend_from_slice(offsets);
        for round in 0..ROUNDS {
            match round >= SPREAD_FROM && round % 2 == 0 {
                true => self.spread(work, offsets),
                false => self.push(work, offsets),
            }
            self.find_folded(work, offsets);
            if work.folded.is_empty() {
                break;
            }
        }
        match work.folded.is_empty() {
            true => self.polish(work, offsets),
            false => self.shorten(offsets),
        }
    }

    /// Whether it is turned over, or as good as.
    fn is_folded(&self, triangle: u32, offsets: &[DVec2]) -> bool {
        let flat = &self.triangles[triangle as usize];
        let [ab, ac] = flat.after(offsets);
        ab.perp_dot(ac) * flat.doubled_area.signum() < LEAST_AREA * flat.doubled_area.abs()
    }

    /// Corners of what is folded go by what their triangles ask.
    fn push(&self, work: &mut Work, offsets: &mut [DVec2]) {
        let Work { folded, corners, asked, .. } = work;
        corners.clear();
        for flat in folded.iter().map(|&triangle| &self.triangles[triangle as usize]) {
            for (corner, push) in flat.corners.into_iter().zip(flat.pushes(offsets, &self.stays)) {
                let (sum, count) = &mut asked[corner as usize];
                (*sum, *count) = (*sum + push, *count + 1);
                corners.push(corner);
            }
        }
        sort_once(corners);
        for &vertex in corners.iter() {
            let (sum, count) = std::mem::take(&mut asked[vertex as usize]);
            offsets[vertex as usize] += sum * (EAGERNESS / f64::from(count));
        }
    }

    /// What was pushed lies in creases: offsets around it become more alike, as long as that can be done without a fold.
    fn polish(&self, work: &mut Work, offsets: &mut [DVec2]) {
        for _ in 0..POLISHINGS {
            work.whole.clear();
            work.whole.extend_from_slice(offsets);
            work.corners.clear();
            let pushed = offsets.iter().zip(&work.wanted).zip(0..).filter(|((now, wanted), _)| now != wanted);
            work.corners.extend(pushed.map(|(_, vertex)| vertex));
            self.spread_at(work, offsets);
            for _ in 0..PUSHES_AFTER {
                self.find_folded(work, offsets);
                if work.folded.is_empty() {
                    break;
                }
                self.push(work, offsets);
            }
            if !work.folded.is_empty() {
                offsets.copy_from_slice(&work.whole);
                return;
            }
        }
    }

    /// Corners of what is folded go half the way to the mean of their triangles' corners.
    fn spread(&self, work: &mut Work, offsets: &mut [DVec2]) {
        let Work { folded, corners, .. } = &mut *work;
        corners.clear();
        corners.extend(folded.iter().flat_map(|&triangle| self.triangles[triangle as usize].corners));
        sort_once(corners);
        self.spread_at(work, offsets);
    }

    fn spread_at(&self, work: &mut Work, offsets: &mut [DVec2]) {
        let Work { corners, asked, .. } = work;
        corners.retain(|&vertex| !self.stays[vertex as usize]);
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

    /// Only beside the corners that went can anything have changed.
    fn find_folded(&self, work: &mut Work, offsets: &[DVec2]) {
        let Work { folded, corners, .. } = work;
        folded.clear();
        folded.extend(corners.iter().flat_map(|&vertex| self.triangles_at(vertex)));
        sort_once(folded);
        folded.retain(|&triangle| self.is_folded(triangle, offsets));
    }

    fn triangles_at(&self, vertex: u32) -> &[u32] {
        &self.at_vertices[self.starts[vertex as usize]..self.starts[vertex as usize + 1]]
    }

    /// The largest share of all offsets that folds nothing; at none of them nothing is folded.
    fn shorten(&self, offsets: &mut [DVec2]) {
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
    fn new(corners: [u32; 3], places: &[DVec2]) -> Self {
        let [a, b, c] = corners.map(|corner| places[corner as usize]);
        Self { corners, edges: [b - a, c - a], doubled_area: doubled_area([a, b, c]) }
    }

    /// Its edges with these offsets.
    fn after(&self, offsets: &[DVec2]) -> [DVec2; 2] {
        let [a, b, c] = self.corners.map(|corner| offsets[corner as usize]);
        [self.edges[0] + (b - a), self.edges[1] + (c - a)]
    }

    /// The least ways of its corners, but for those that stay, that bring it to the area it is to have, as far as that grows
    /// with them.
    fn pushes(&self, offsets: &[DVec2], stays: &[bool]) -> [DVec2; 3] {
        let [ab, ac] = self.after(offsets);
        let missing = PUSHED_AREA * self.doubled_area - ab.perp_dot(ac);
        let slopes = [(ac - ab).perp(), -ac.perp(), ab.perp()];
        let free = [0, 1, 2].map(|k| if stays[self.corners[k] as usize] { DVec2::ZERO } else { slopes[k] });
        let steepness: f64 = free.iter().map(|slope| slope.length_squared()).sum();
        // What is no longer a triangle has no slope to go by: nothing goes further than it is long, or was.
        let longest = [ab, ac, self.edges[0], self.edges[1]].map(DVec2::length).into_iter().fold(0.0, f64::max);
        free.map(|slope| (slope * (missing / steepness.max(f64::MIN_POSITIVE))).clamp_length_max(longest))
    }

    /// Whether it is not folded with so much of the offsets.
    fn fits_at(&self, share: f64, offsets: &[DVec2]) -> bool {
        let [a, b, c] = self.corners.map(|corner| offsets[corner as usize] * share);
        let after = (self.edges[0] + (b - a)).perp_dot(self.edges[1] + (c - a));
        after * self.doubled_area.signum() >= LEAST_AREA * self.doubled_area.abs()
    }
}

/// The triangles at each vertex, and where they begin.
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

fn sort_once(values: &mut Vec<u32>) {
    values.sort_unstable();
    values.dedup();
}

/// Twice the area with its sign.
pub(crate) fn doubled_area([a, b, c]: [DVec2; 3]) -> f64 {
    (b - a).perp_dot(c - a)
}
