//! The engine as `chrome.mjs` times it: the crates of the page without its canvas, each step behind one call.
//!
//! Browsers round their clocks, so every call repeats its step as often as asked.

use std::hint::black_box;

use glam::DVec3;
use rosto_face::{Triangulation, canonical_positions_m};
use rosto_laplacian::{Constraints, LaplacianSystem, Operator, Response};
use rosto_mesh::{LoopSubdivision, Topology};
use rosto_studio::{CoordinateFrame, Document, EditSpec, Rest};
use wasm_bindgen::prelude::*;

const HANDLE: u32 = 1;
const ANCHORS: [u32; 2] = [10, 152];
const OFFSET_M: DVec3 = DVec3::new(0.01, 0.01, -0.01);

/// The canonical face, split four to one as often as asked, with a handle and two anchors.
#[wasm_bindgen]
pub struct Bench {
    topology: Topology,
    rest: Vec<DVec3>,
    edited: Vec<DVec3>,
    system: LaplacianSystem,
    response: Response,
    document: Document,
}

#[wasm_bindgen]
impl Bench {
    /// Triangles to factor.
    #[wasm_bindgen(constructor)]
    pub fn new(levels: u32) -> Result<Bench, JsError> {
        let cage = Triangulation::Canonical.topology();
        let dense = LoopSubdivision::new(&cage, levels);
        let rest = dense.apply(&canonical_positions_m());
        let system = LaplacianSystem::new(dense.topology(), &rest, Operator::UniformSymmetric)?;
        let response = system.respond(&constraints())?;
        let mut document = Document::new(Rest::new(cage, canonical_positions_m(), CoordinateFrame::Model))?;
        document.set_density(levels)?;
        document.hold(EditSpec { handles: vec![HANDLE], ..EditSpec::default() })?;
        document.preview(&[OFFSET_M])?;
        Ok(Self { topology: dense.topology().clone(), edited: rest.clone(), rest, system, response, document })
    }

    /// Number of vertices.
    #[wasm_bindgen(getter)]
    pub fn vertices(&self) -> usize {
        self.rest.len()
    }

    /// What is done once per mesh and operator.
    pub fn system(&mut self, times: u32) -> Result<(), JsError> {
        for _ in 0..times {
            self.system = LaplacianSystem::new(&self.topology, &self.rest, Operator::UniformSymmetric)?;
        }
        Ok(())
    }

    /// The response field of the handle and its anchors.
    pub fn select(&mut self, times: u32) -> Result<(), JsError> {
        for _ in 0..times {
            self.response = self.system.respond(&constraints())?;
        }
        Ok(())
    }

    /// An edit of the paper: response, and the mesh moved with it.
    pub fn edit(&mut self, times: u32) -> Result<(), JsError> {
        for _ in 0..times {
            self.select(1)?;
            self.tick(1);
        }
        Ok(())
    }

    /// The same from nothing: operator, factor, response, and the mesh moved.
    pub fn edit_from_nothing(&mut self, times: u32) -> Result<(), JsError> {
        for _ in 0..times {
            self.system(1)?;
            self.edit(1)?;
        }
        Ok(())
    }

    /// The mesh moved by one slider, with the response at hand.
    pub fn tick(&mut self, times: u32) {
        for _ in 0..times {
            self.response.displace(&self.rest, &[OFFSET_M], black_box(&mut self.edited));
        }
    }

    /// The same through the document, whose landmark moves the 468 of the cage and all that was added between them.
    pub fn preview(&mut self, times: u32) -> Result<(), JsError> {
        for _ in 0..times {
            self.document.preview(black_box(&[OFFSET_M]))?;
        }
        Ok(())
    }
}

fn constraints() -> Constraints<'static> {
    Constraints { handles: &[HANDLE], anchors: &ANCHORS, ..Default::default() }
}
