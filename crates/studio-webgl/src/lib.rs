//! The page's façade once more, drawing through WebGL2: a module of its own, which only browsers without WebGPU download.

pub use rosto_studio_web::*;
