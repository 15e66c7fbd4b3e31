use glam::{DVec2, DVec3};
use rosto_laplacian::Continuation;
use rosto_mesh::Topology;

use crate::coarse::Coarse;
use crate::folds::FoldRemoval;
use crate::layout::{Layout, Role};
use crate::{Subject, WarpError};

/// A warp of a picture, prepared for the points' positions at rest. [`Self::follow`] is the cost per tick.
pub struct Warp {
    warp_mesh: WarpMesh,
    roles: Vec<Role>,
    falloff: Option<FalloffSystem>,
    coarse: Coarse,
    fold_removal: FoldRemoval,
    /// Bound on offsets, the picture's diagonal, so that squared lengths stay finite.
    max_offset_px: f64,
    offsets_px: Vec<DVec2>,
    limited_px: f64,
}

/// The moving part of a picture, as triangles. Pixels outside do not change.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct WarpMesh {
    /// Positions at rest, in px.
    pub from_px: Vec<DVec2>,
    /// Warped positions, in px.
    pub to_px: Vec<DVec2>,
    /// Triangles, which do not overlap before or after the warp.
    pub triangles: Vec<[u32; 3]>,
}

/// The free part of the triangulation and two rings of fixed points around it, which set value and slope.
struct FalloffSystem {
    /// Indices of its points in the warp mesh.
    points: Vec<u32>,
    /// Indices into `points` of the fixed ones.
    fixed: Vec<u32>,
    continuation: Continuation,
    /// All x, then all y, of the fixed points and of all points.
    fixed_values: Vec<f64>,
    values: Vec<f64>,
}

/// Edges from the first nodes beyond the gaps between the subject's points to its outline.
const LAYERS_TO_OUTLINE: usize = 3;

impl Warp {
    /// Triangulates the picture and factorises the system of the falloff band.
    ///
    /// # Errors
    /// [`WarpError::TooFewPoints`] or [`WarpError::FalloffBand`].
    pub fn new(subject: &Subject<'_>) -> Result<Self, WarpError> {
        let mut layout = Layout::of(subject)?;
        let coarse = Coarse::new(&layout);
        let topology = Topology::new(layout.points.len(), std::mem::take(&mut layout.triangles))?;
        let falloff = FalloffSystem::new(&topology, &layout)?;
        let Layout { points, roles, .. } = layout;
        let fold_removal = FoldRemoval::new(topology.triangles(), &points, &roles);
        let warp_mesh = WarpMesh { to_px: points.clone(), from_px: points, triangles: topology.triangles().to_vec() };
        let offsets_px = vec![DVec2::ZERO; roles.len()];
        let max_offset_px = DVec2::from(subject.size_px.map(f64::from)).length();
        Ok(Self { warp_mesh, roles, falloff, coarse, fold_removal, max_offset_px, offsets_px, limited_px: 0.0 })
    }

    /// Moves each of the subject's points to its target, in px of the picture, without folds. Points with a NaN target
    /// stay.
    ///
    /// # Panics
    /// If the numbers of points and targets differ.
    pub fn follow(&mut self, points_px: &[DVec2], targets_px: &[DVec2]) {
        self.lead(points_px, targets_px);
        self.limited_px = 0.0;
        if self.fold_removal.folds(&self.offsets_px) {
            self.coarse.unfold(&mut self.offsets_px);
            self.fold_removal.limit(&mut self.offsets_px);
            self.limited_px = self.shortfall_px(points_px, targets_px);
        }
        self.apply();
    }

    /// Like [`Self::follow`], but allows folds, for a picture whose points have already moved.
    ///
    /// # Panics
    /// If the numbers of points and targets differ.
    pub fn carry(&mut self, points_px: &[DVec2], targets_px: &[DVec2]) {
        self.lead(points_px, targets_px);
        self.limited_px = 0.0;
        self.apply();
    }

    fn lead(&mut self, points_px: &[DVec2], targets_px: &[DVec2]) {
        assert_eq!(points_px.len(), targets_px.len(), "expected one target per point");
        for at in 0..self.roles.len() {
            self.offsets_px[at] = self.target_offset(self.roles[at], points_px, targets_px).unwrap_or_default();
        }
        if let Some(falloff) = &mut self.falloff {
            falloff.interpolate(&mut self.offsets_px);
        }
    }

    /// Largest distance of a leading point from its target.
    fn shortfall_px(&self, points_px: &[DVec2], targets_px: &[DVec2]) -> f64 {
        let shortfall =
            |(offset, role): (&DVec2, &Role)| Some(self.target_offset(*role, points_px, targets_px)?.distance(*offset));
        self.offsets_px.iter().zip(&self.roles).filter_map(shortfall).fold(0.0, f64::max)
    }

    /// Target offset of a point that leads.
    fn target_offset(&self, role: Role, points_px: &[DVec2], targets_px: &[DVec2]) -> Option<DVec2> {
        match role {
            Role::Moved { point, share } => {
                Some(bounded(targets_px[point] - points_px[point], self.max_offset_px) * share)
            }
            Role::Fixed | Role::Free => None,
        }
    }

    fn apply(&mut self) {
        for ((to, from), offset) in self.warp_mesh.to_px.iter_mut().zip(&self.warp_mesh.from_px).zip(&self.offsets_px) {
            *to = *from + *offset;
        }
    }

    /// The warped triangulation.
    pub fn warp_mesh(&self) -> &WarpMesh {
        &self.warp_mesh
    }

    /// Largest distance in px by which fold removal keeps a point from its target. Near fixed areas, targets are
    /// already reduced.
    pub fn limited_px(&self) -> f64 {
        self.limited_px
    }
}

impl WarpMesh {
    /// The warp mesh of a part of the picture that starts at `corner_px` and is scaled by `scale`.
    pub fn cut(&self, corner_px: DVec2, scale: f64) -> Self {
        let transformed =
            |positions: &[DVec2]| positions.iter().map(|position| (*position - corner_px) * scale).collect();
        Self { from_px: transformed(&self.from_px), to_px: transformed(&self.to_px), triangles: self.triangles.clone() }
    }
}

impl FalloffSystem {
    /// Returns `None` without free points.
    fn new(topology: &Topology, layout: &Layout) -> Result<Option<Self>, WarpError> {
        let Layout { points, roles, tension, .. } = layout;
        let is_free: Vec<bool> = roles.iter().map(|role| *role == Role::Free).collect();
        if !is_free.contains(&true) {
            return Ok(None);
        }
        let is_near = dilated(topology, &dilated(topology, &is_free));
        let near: Vec<u32> = (0..points.len() as u32).filter(|&point| is_near[point as usize]).collect();
        let mut index_of = vec![u32::MAX; points.len()];
        near.iter().zip(0..).for_each(|(&point, index)| index_of[point as usize] = index);
        let inside =
            topology.triangles().iter().filter(|corners| corners.iter().all(|&corner| is_near[corner as usize]));
        let triangles = inside.map(|corners| corners.map(|corner| index_of[corner as usize])).collect();
        let part = Topology::new(near.len(), triangles)?;
        let positions: Vec<DVec3> = near.iter().map(|&point| points[point as usize].extend(0.0)).collect();
        let fixed: Vec<u32> = (0..near.len() as u32).filter(|&index| !is_free[near[index as usize] as usize]).collect();
        let tension: Vec<f64> = near.iter().map(|&point| tension[point as usize]).collect();
        let is_hinged = hinged(topology, layout);
        let hinged: Vec<u32> = (0..near.len() as u32).filter(|&i| is_hinged[near[i as usize] as usize]).collect();
        let continuation = Continuation::under_tension(&part, &positions, &tension, &hinged, &fixed)?;
        let (fixed_values, values) = (vec![0.0; 2 * fixed.len()], vec![0.0; 2 * near.len()]);
        Ok(Some(Self { points: near, fixed, continuation, fixed_values, values }))
    }

    /// Interpolates the offsets of the free points.
    fn interpolate(&mut self, offsets_px: &mut [DVec2]) {
        for (axis, values) in self.fixed_values.chunks_exact_mut(self.fixed.len()).enumerate() {
            for (value, &index) in values.iter_mut().zip(&self.fixed) {
                *value = offsets_px[self.points[index as usize] as usize][axis];
            }
        }
        self.continuation.continued(&self.fixed_values, &mut self.values);
        for (axis, values) in self.values.chunks_exact(self.points.len()).enumerate() {
            for (&point, value) in self.points.iter().zip(values) {
                offsets_px[point as usize][axis] = *value;
            }
        }
    }
}

/// The subject's outline if it has a stiff strip, which then does not continue the slopes of the subject.
fn hinged(topology: &Topology, layout: &Layout) -> Vec<bool> {
    let beyond = (0..LAYERS_TO_OUTLINE).fold(layout.is_beyond.clone(), |beyond, _| dilated(topology, &beyond));
    let is_stiff = |(role, tension): (&Role, &f64)| matches!(role, Role::Moved { .. }) && *tension > 0.0;
    beyond
        .iter()
        .zip(layout.roles.iter().zip(&layout.tension))
        .map(|(beyond, point)| *beyond && is_stiff(point))
        .collect()
}

/// Clamps an offset; zero for NaN.
fn bounded(offset: DVec2, max_offset: f64) -> DVec2 {
    if offset.is_nan() { DVec2::ZERO } else { offset.clamp(DVec2::splat(-max_offset), DVec2::splat(max_offset)) }
}

/// These vertices and their neighbours.
fn dilated(topology: &Topology, vertices: &[bool]) -> Vec<bool> {
    let has_neighbour = |vertex: u32| topology.neighbours(vertex).iter().any(|&other| vertices[other as usize]);
    (0..vertices.len() as u32).map(|vertex| vertices[vertex as usize] || has_neighbour(vertex)).collect()
}
