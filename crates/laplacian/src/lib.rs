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
mod error;
mod factor;
mod grounded;
mod kernels;
mod operator;
mod region;
mod response;
mod system;
mod weights;

pub use anchors::random_anchors;
pub use constraints::{Constraints, Hold};
pub use error::LaplacianError;
pub use operator::Operator;
pub use region::Region;
pub use response::Response;
pub use system::LaplacianSystem;

use constraints::check_positions;
