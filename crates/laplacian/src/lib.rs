//! Laplacian editing of triangle meshes: operators, constraints, factorisation, response fields, distortion measures.
//!
//! The type states the cost of an operation:
//!
//! | once per | type | cost |
//! |---|---|---|
//! | mesh and operator | [`LaplacianSystem`] | a sparse factorisation |
//! | handles and anchors | [`Response`] | a solve per handle |
//! | slider tick | [`Response::displace`] | `n` multiply-adds per handle |
//!
//! ```
//! use glam::DVec3;
//! use rosto_laplacian::{Constraints, ConstraintKind, LaplacianSystem, Operator};
//! use rosto_mesh::Topology;
//!
//! // A tent with four corners and a top. The top moves up; two opposite corners are anchors.
//! let topology = Topology::new(5, vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]])?;
//! let rest = [DVec3::X, DVec3::Y, -DVec3::X, -DVec3::Y, DVec3::Z];
//! let system = LaplacianSystem::new(&topology, &rest, Operator::UniformSymmetric)?;
//! let constrained = Constraints { handles: &[4], anchors: &[0, 2], kind: ConstraintKind::Hard, ..Default::default() };
//! let response = system.respond(&constrained)?;
//!
//! let mut edited = rest;
//! response.displace(&rest, &[DVec3::Z], &mut edited);
//! assert!(edited[4].distance(rest[4] + DVec3::Z) < 1e-12);
//! assert!(edited[0].distance(rest[0]) < 1e-12);
//! // By symmetry, the two free corners rise by the same amount.
//! assert!(edited[1].z > 0.0 && (edited[1].z - edited[3].z).abs() < 1e-12);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod anchored;
mod anchors;
mod constraints;
mod continuation;
mod dirichlet;
mod distortion;
mod error;
mod factor;
mod fairing;
mod falloff;
mod gauge_fixed;
mod geodesics;
mod operator;
mod peaks;
mod response;
mod rigid;
mod rotation;
mod saddle_point;
mod system;
mod weights;

pub use anchored::AnchoredSystem;
pub use anchors::random_anchors;
pub use constraints::{ConstraintKind, Constraints};
pub use continuation::Continuation;
pub use distortion::{Distortion, DistortionSummary, Extreme};
pub use error::LaplacianError;
pub use factor::Factor;
pub use fairing::Fairing;
pub use falloff::Falloff;
pub use geodesics::Geodesics;
pub use operator::Operator;
pub use peaks::{Peak, peaks};
pub use response::Response;
pub use rigid::{RigidEdit, RigidOptions, RigidSystem};
pub use system::LaplacianSystem;

use constraints::check_positions;

/// Runs the README's examples as doc-tests.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
pub struct Readme;
