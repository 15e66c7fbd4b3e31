//! δ-coordinates: operators, constraints, factorisation, response fields, distortion. Knows nothing of faces.
//!
//! What an operation costs is in its type:
//!
//! | once per | type | cost |
//! |---|---|---|
//! | mesh and operator | [`LaplacianSystem`] | a sparse factorisation |
//! | handles and anchors | [`Response`] | a back-substitution per handle |
//! | slider tick | [`Response::displace`] | `n` multiply-adds per handle |

mod anchors;
mod bordered;
mod constraints;
mod distortion;
mod eliminated;
mod error;
mod factor;
mod geodesics;
mod grounded;
mod kernels;
mod operator;
mod peaks;
mod region;
mod response;
mod rigid;
mod rotation;
mod system;
mod weights;

pub use anchors::random_anchors;
pub use constraints::{Constraints, Hold};
pub use distortion::{Distortion, DistortionSummary, Extreme};
pub use error::LaplacianError;
pub use factor::Factor;
pub use geodesics::Geodesics;
pub use operator::Operator;
pub use peaks::{Peak, peaks};
pub use region::Region;
pub use response::Response;
pub use rigid::{RigidEdit, RigidOptions, RigidSystem};
pub use system::LaplacianSystem;

use constraints::check_positions;
