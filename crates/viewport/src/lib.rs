//! The wgpu view of a mesh: camera, light, shading modes, picking.
