use rosto_stage::FrameUniforms;

use crate::Gpu;
use crate::pipelines::Pipelines;

/// Uniform buffer of a frame.
#[derive(Debug)]
pub(crate) struct FrameOnGpu {
    buffer: wgpu::Buffer,
    pub bindings: wgpu::BindGroup,
}

impl FrameOnGpu {
    pub fn new(gpu: &Gpu, pipelines: &Pipelines) -> Self {
        let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("frame"),
            size: size_of::<FrameUniforms>() as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let bindings = gpu.bind_group(&pipelines.frame_layout, [buffer.as_entire_binding()]);
        Self { buffer, bindings }
    }

    pub fn write(&self, gpu: &Gpu, uniforms: &FrameUniforms) {
        gpu.queue.write_buffer(&self.buffer, 0, bytemuck::bytes_of(uniforms));
    }
}
