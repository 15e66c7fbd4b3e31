//! The history as JSON text, in project files, crash recovery and the `extras` of a GLB.
//!
//! ```json
//! {"rosto": "history", "version": 1, "entries": [
//!   {"label": "nose tip", "switch": "on", "move": {
//!     "level": 0, "handles": [4], "offsets": [[0, 0, 0.01]], "operator": "L_s", "constraint": {"soft": 1},
//!     "anchors": {"kind": "oval", "pins": []}, "influence": "whole", "mirror": "on", "details": "kept"}},
//!   {"label": "symmetrise", "switch": "off", "symmetrise": {"share": 0.5}},
//!   {"label": "jawOpen", "switch": "on", "express": {"expression": "jawOpen", "weight": 0.6}}]}
//! ```
//! `constraint` is `{"soft": weight}` or `"exact"`; `kind` is `"oval"`, `"pins"`, `{"random": seed}` or `{"outside":
//! radius}`; `influence` is `"whole"` or `{"within": radius}`; `details` is `"kept"` or `"turned"`. Offsets and radii
//! are in the document's unit. Numbers are read back as the same `f64`, so that a replay gives the same bytes.

mod read;
mod write;

pub use read::{ProjectError, from_json};
pub use write::to_json;

/// Version of the format that [`to_json`] writes and [`from_json`] reads.
pub const VERSION: u64 = 1;
