use crate::{Gpu, ViewportError};

/// An upright sRGB picture, row by row from its top left, with opaque alpha.
#[derive(Debug, Clone, Copy)]
pub struct Picture<'a> {
    /// Width in px.
    pub width: u32,
    /// Height in px.
    pub height: u32,
    /// Red, green, blue and alpha of each pixel.
    pub rgba: &'a [u8],
}

const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8UnormSrgb;

/// Uploads a picture with all its smaller levels, each the mean of four pixels in linear light.
pub(crate) fn upload(
    gpu: &Gpu,
    shrink: &wgpu::RenderPipeline,
    picture: Picture<'_>,
) -> Result<wgpu::TextureView, ViewportError> {
    let Picture { width, height, rgba } = picture;
    let largest = gpu.largest_side_px();
    if width == 0 || height == 0 || width.max(height) > largest || rgba.len() != width as usize * height as usize * 4 {
        return Err(ViewportError::BadPicture { width, height, found: rgba.len() });
    }
    let size = wgpu::Extent3d { width, height, depth_or_array_layers: 1 };
    let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some("photo"),
        size,
        mip_level_count: size.max_mips(wgpu::TextureDimension::D2),
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: FORMAT,
        usage: wgpu::TextureUsages::TEXTURE_BINDING
            | wgpu::TextureUsages::COPY_DST
            | wgpu::TextureUsages::RENDER_ATTACHMENT,
        view_formats: &[],
    });
    let layout =
        wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(4 * width), rows_per_image: Some(height) };
    gpu.queue.write_texture(texture.as_image_copy(), rgba, layout, size);
    shrink_levels(gpu, shrink, &texture);
    Ok(texture.create_view(&wgpu::TextureViewDescriptor::default()))
}

/// One white pixel, for a mesh without a photo.
pub(crate) fn blank(gpu: &Gpu, shrink: &wgpu::RenderPipeline) -> Result<wgpu::TextureView, ViewportError> {
    upload(gpu, shrink, Picture { width: 1, height: 1, rgba: &[255; 4] })
}

pub(crate) fn sampler(gpu: &Gpu) -> wgpu::Sampler {
    gpu.device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("photo"),
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        mipmap_filter: wgpu::MipmapFilterMode::Linear,
        anisotropy_clamp: 8,
        ..Default::default()
    })
}

/// The pipeline that makes one level from the level before.
pub(crate) fn shrink_pipeline(gpu: &Gpu) -> wgpu::RenderPipeline {
    let module = gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("shrink"),
        source: wgpu::ShaderSource::Wgsl(crate::shaders::SHRINK.into()),
    });
    gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("shrink"),
        layout: None,
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some("vertex"),
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: Default::default(),
        depth_stencil: None,
        multisample: Default::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: Some("fragment"),
            compilation_options: Default::default(),
            targets: &[Some(FORMAT.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}

fn shrink_levels(gpu: &Gpu, shrink: &wgpu::RenderPipeline, texture: &wgpu::Texture) {
    let level = |base_mip_level| {
        texture.create_view(&wgpu::TextureViewDescriptor {
            base_mip_level,
            mip_level_count: Some(1),
            ..Default::default()
        })
    };
    let sampler = gpu.device.create_sampler(&wgpu::SamplerDescriptor {
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        ..Default::default()
    });
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    for smaller in 1..texture.mip_level_count() {
        let source = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("shrink"),
            layout: &shrink.get_bind_group_layout(0),
            entries: &[
                wgpu::BindGroupEntry { binding: 0, resource: wgpu::BindingResource::TextureView(&level(smaller - 1)) },
                wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::Sampler(&sampler) },
            ],
        });
        let target = level(smaller);
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("shrink"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &target,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations { load: wgpu::LoadOp::Clear(wgpu::Color::BLACK), store: wgpu::StoreOp::Store },
            })],
            ..Default::default()
        });
        pass.set_pipeline(shrink);
        pass.set_bind_group(0, &source, &[]);
        pass.draw(0..3, 0..1);
    }
    gpu.queue.submit([encoder.finish()]);
}
