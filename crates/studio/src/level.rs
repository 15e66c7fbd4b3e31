use glam::DVec3;
use rosto_face::{FaceModel, LANDMARK_COUNT, OVAL, crowded_landmarks, opening_edges};
use rosto_laplacian::{
    AnchoredSystem, ConstraintKind, Constraints, Geodesics, LaplacianError, LaplacianSystem, Operator, Response,
};
use rosto_mesh::{LoopSubdivision, Topology};

use crate::mirror::MirrorTable;
use crate::{Expression, Expressions, StudioError};

/// Coordinate frame of a document's positions.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CoordinateFrame {
    /// The face model's frame, with the mirror plane x = 0.
    Model,
    /// Any other frame, such as a picture's; it has no mirror plane.
    Other,
}

/// The mesh that a document starts from (its cage).
#[derive(Debug, Clone)]
pub struct Rest {
    topology: Topology,
    positions: Vec<DVec3>,
    /// The number of landmarks of a face, which are the first vertices; 0 for any other mesh.
    landmark_count: usize,
    oval: Vec<u32>,
    /// Edges at which lids and lips border the openings.
    creases: Vec<[u32; 2]>,
    /// Landmarks that denser meshes do not interpolate but round off.
    rounded: Vec<u32>,
    mirror: Option<MirrorTable>,
}

impl Rest {
    /// A mesh that is not a face, in any unit. It has no mirror pairs.
    pub fn of_mesh(topology: Topology, positions: Vec<DVec3>) -> Self {
        let (oval, creases, rounded) = (longest_boundary(&topology), Vec::new(), Vec::new());
        Self { topology, positions, landmark_count: 0, oval, creases, rounded, mirror: None }
    }

    /// A face whose vertices are the landmarks, in any unit. In the model's frame, it has mirror pairs. Subdivision
    /// preserves the edges of lids and lips.
    ///
    /// # Panics
    /// If the topology does not have 468 vertices.
    pub fn of_landmarks(topology: Topology, positions: Vec<DVec3>, frame: CoordinateFrame) -> Self {
        assert_eq!(topology.vertex_count(), LANDMARK_COUNT, "one vertex for each landmark");
        Self {
            topology,
            positions,
            landmark_count: LANDMARK_COUNT,
            oval: OVAL.to_vec(),
            creases: opening_edges(),
            rounded: crowded_landmarks(),
            mirror: (frame == CoordinateFrame::Model).then(MirrorTable::of_landmarks),
        }
    }

    /// The mesh of a face, in its model's frame, in metres.
    pub fn of_face(face: &FaceModel) -> Self {
        Self::of_landmarks(face.topology().clone(), face.positions_m().to_vec(), CoordinateFrame::Model)
    }
}

fn longest_boundary(topology: &Topology) -> Vec<u32> {
    topology.boundary_loops().into_iter().next().unwrap_or_default()
}

/// One subdivision level of a document's mesh, with its factorisations.
pub(crate) struct Level {
    rest: Rest,
    /// Built when an operator is first used.
    systems: Vec<(Operator, LaplacianSystem)>,
    /// Factorisation for the latest anchors, if there are many; consecutive handles often share them.
    anchored: Option<Anchored>,
    geodesics: Option<Geodesics>,
    /// Map to the next level; built with it.
    finer: Option<LoopSubdivision>,
    /// Displacements by expressions.
    expression_cache: ExpressionCache,
}

/// Displacements of one level by expressions, computed on demand. They depend only on the mesh at rest.
#[derive(Default)]
pub(crate) struct ExpressionCache {
    /// Present on the cage only.
    pub(crate) solver: Option<Expressions>,
    pub(crate) expressions: Vec<(Expression, Vec<DVec3>)>,
}

impl ExpressionCache {
    /// Displacement of each vertex by an expression at weight 1, if computed.
    pub(crate) fn displacements(&self, expression: Expression) -> Option<&[DVec3]> {
        self.expressions
            .iter()
            .find(|(cached, _)| *cached == expression)
            .map(|(_, displacements)| displacements.as_slice())
    }
}

struct Anchored {
    operator: Operator,
    constraint: ConstraintKind,
    anchors: Vec<u32>,
    system: AnchoredSystem,
}

impl Level {
    pub(crate) fn new(rest: Rest) -> Self {
        Self {
            rest,
            systems: Vec::new(),
            anchored: None,
            geodesics: None,
            finer: None,
            expression_cache: ExpressionCache::default(),
        }
    }

    pub(crate) fn topology(&self) -> &Topology {
        &self.rest.topology
    }

    /// Positions before any edit.
    pub(crate) fn rest(&self) -> &[DVec3] {
        &self.rest.positions
    }

    /// The landmarks' positions before any edit; empty unless the mesh is a face.
    pub(crate) fn landmarks(&self) -> &[DVec3] {
        &self.rest.positions[..self.rest.landmark_count]
    }

    pub(crate) fn oval(&self) -> &[u32] {
        &self.rest.oval
    }

    pub(crate) fn mirror(&self) -> Result<&MirrorTable, StudioError> {
        self.rest.mirror.as_ref().ok_or(StudioError::NoMirror)
    }

    pub(crate) fn system(&mut self, operator: Operator) -> Result<&LaplacianSystem, LaplacianError> {
        let found = self.systems.iter().position(|(of, _)| *of == operator);
        let index = match found {
            Some(index) => index,
            None => {
                let system = LaplacianSystem::new(&self.rest.topology, &self.rest.positions, operator)?;
                self.systems.push((operator, system));
                self.systems.len() - 1
            }
        };
        Ok(&self.systems[index].1)
    }

    /// Response of each vertex to handles. Reuses the factorisation if operator, constraint and anchors are unchanged.
    pub(crate) fn respond(
        &mut self,
        operator: Operator,
        constraints: &Constraints<'_>,
    ) -> Result<Response, LaplacianError> {
        let (constraint, anchors) = (constraints.kind, constraints.anchors);
        let is_for =
            |one: &Anchored| one.operator == operator && one.constraint == constraint && one.anchors == anchors;
        if !self.anchored.as_ref().is_some_and(is_for) {
            let system = self.system(operator)?.anchored(constraints)?;
            self.anchored = system.map(|system| Anchored { operator, constraint, anchors: anchors.to_vec(), system });
        }
        match &self.anchored {
            Some(anchored) => anchored.system.respond(constraints),
            None => self.system(operator)?.respond(constraints),
        }
    }

    /// Distance of each vertex from `sources` along the surface at rest.
    pub(crate) fn distances(&mut self, sources: &[u32]) -> Result<Vec<f64>, LaplacianError> {
        let geodesics = match self.geodesics.take() {
            Some(geodesics) => geodesics,
            None => Geodesics::new(&self.rest.topology, &self.rest.positions)?,
        };
        self.geodesics.insert(geodesics).distances(sources)
    }

    /// The next level: each triangle is split into four.
    pub(crate) fn subdivided(&mut self) -> Self {
        let step = LoopSubdivision::creased(&self.rest.topology, &self.rest.creases, 1).rounding(&self.rest.rounded);
        let topology = step.topology().clone();
        let rest = Rest {
            positions: step.interpolate(&self.rest.positions),
            landmark_count: self.rest.landmark_count,
            oval: longest_boundary(&topology),
            creases: step.creases().to_vec(),
            rounded: self.rest.rounded.clone(),
            mirror: self.rest.mirror.as_ref().and_then(|mirror| mirror.subdivided(&self.rest.topology)),
            topology,
        };
        self.finer = Some(step);
        Self::new(rest)
    }

    pub(crate) fn expression_cache(&self) -> &ExpressionCache {
        &self.expression_cache
    }

    pub(crate) fn expression_cache_mut(&mut self) -> &mut ExpressionCache {
        &mut self.expression_cache
    }

    /// The map to the next level.
    pub(crate) fn finer(&self) -> &LoopSubdivision {
        self.finer.as_ref().expect("invariant: built together with the next level")
    }
}
