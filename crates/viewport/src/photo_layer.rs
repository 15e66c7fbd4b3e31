use glam::DVec2;
use wgpu::BindingResource::{Sampler, TextureView};

use crate::mesh::{check_length, filled};
use crate::pipelines::Pipelines;
use crate::{Gpu, PictureOnGpu, ViewportError, picture};

/// Picture with points that move.
#[derive(Debug, Clone, Copy)]
pub struct PhotoLayerInput<'a> {
    /// Size in px that the points refer to; the texture may be smaller.
    pub size_px: DVec2,
    /// Rest positions of the moving points.
    pub from_px: &'a [DVec2],
    /// Triangles of the points; outside them nothing moves.
    pub triangles: &'a [[u32; 3]],
    /// The texture.
    pub picture: &'a PictureOnGpu,
}

/// Photo layer in GPU memory: the moving triangles, and behind them the whole picture as two triangles.
#[derive(Debug)]
pub(crate) struct PhotoLayerOnGpu {
    corners: [DVec2; 4],
    from_px: Vec<DVec2>,
    /// Scratch: target and source of each point.
    points: Vec<[f32; 4]>,
    pub points_on_gpu: wgpu::Buffer,
    pub indices: wgpu::Buffer,
    pub index_count: u32,
    pub bindings: wgpu::BindGroup,
}

impl PhotoLayerOnGpu {
    pub fn new(gpu: &Gpu, pipelines: &Pipelines, input: &PhotoLayerInput<'_>) -> Self {
        let DVec2 { x: width, y: height } = input.size_px;
        let corners = [DVec2::ZERO, DVec2::new(width, 0.0), input.size_px, DVec2::new(0.0, height)];
        let whole = [[0, 1, 2], [0, 2, 3]];
        let moving = input.triangles.iter().map(|triangle| triangle.map(|corner| corner + corners.len() as u32));
        let triangles: Vec<[u32; 3]> = moving.chain(whole).collect();
        let points: Vec<[f32; 4]> =
            corners.iter().chain(input.from_px).map(|position| point(*position, *position)).collect();
        let sampler = picture::sampler(gpu);
        let resources = [TextureView(&input.picture.view), Sampler(&sampler)];
        Self {
            points_on_gpu: filled(gpu, bytemuck::cast_slice(&points), wgpu::BufferUsages::VERTEX),
            indices: filled(gpu, bytemuck::cast_slice(&triangles), wgpu::BufferUsages::INDEX),
            index_count: 3 * triangles.len() as u32,
            bindings: gpu.bind_group(&pipelines.photo_layer_layout, resources),
            corners,
            from_px: input.from_px.to_vec(),
            points,
        }
    }

    pub fn carry(&mut self, gpu: &Gpu, from_px: &[DVec2], to_px: &[DVec2]) -> Result<(), ViewportError> {
        check_length("positions", from_px.len(), self.from_px.len())?;
        self.from_px.copy_from_slice(from_px);
        self.follow(gpu, to_px)
    }

    pub fn follow(&mut self, gpu: &Gpu, to_px: &[DVec2]) -> Result<(), ViewportError> {
        check_length("positions", to_px.len(), self.from_px.len())?;
        let moving = &mut self.points[self.corners.len()..];
        for (own, (to, from)) in moving.iter_mut().zip(to_px.iter().zip(&self.from_px)) {
            *own = point(*to, *from);
        }
        gpu.queue.write_buffer(&self.points_on_gpu, 0, bytemuck::cast_slice(&self.points));
        Ok(())
    }
}

fn point(to_px: DVec2, from_px: DVec2) -> [f32; 4] {
    let ([to_x, to_y], [from_x, from_y]) = (to_px.as_vec2().to_array(), from_px.as_vec2().to_array());
    [to_x, to_y, from_x, from_y]
}
