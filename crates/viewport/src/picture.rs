use crate::gpu::texture;
use crate::{Gpu, ViewportError};

const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8UnormSrgb;

/// Texture in GPU memory; clones share it.
#[derive(Debug, Clone)]
pub struct PictureOnGpu {
    texture: wgpu::Texture,
    pub(crate) view: wgpu::TextureView,
}

/// Allocates a texture with all mip levels.
pub(crate) fn reserve(gpu: &Gpu, width: u32, height: u32) -> Result<PictureOnGpu, ViewportError> {
    let levels = wgpu::Extent3d { width, height, depth_or_array_layers: 1 }.max_mips(wgpu::TextureDimension::D2);
    reserve_levels(gpu, width, height, levels)
}

/// Allocates a texture with `levels` mip levels. Sizes are in px.
pub(crate) fn reserve_levels(gpu: &Gpu, width: u32, height: u32, levels: u32) -> Result<PictureOnGpu, ViewportError> {
    if width == 0 || height == 0 || width.max(height) > gpu.largest_side_px() {
        return Err(ViewportError::BadPicture { width, height, found: 0 });
    }
    let usage =
        wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST | wgpu::TextureUsages::RENDER_ATTACHMENT;
    let descriptor = texture("picture", [width, height], FORMAT, usage);
    let texture = gpu.device.create_texture(&wgpu::TextureDescriptor { mip_level_count: levels, ..descriptor });
    let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
    Ok(PictureOnGpu { texture, view })
}

/// Writes complete rows of a picture, starting at `first_row`.
pub(crate) fn write_rows(gpu: &Gpu, picture: &PictureOnGpu, first_row: u32, rgba: &[u8]) -> Result<(), ViewportError> {
    let (width, height) = (picture.texture.width(), picture.texture.height());
    let row_bytes = 4 * width as usize;
    let rows = (rgba.len() / row_bytes) as u32;
    if !rgba.len().is_multiple_of(row_bytes) || first_row.saturating_add(rows) > height {
        return Err(ViewportError::BadPicture { width, height, found: rgba.len() });
    }
    let mut position = picture.texture.as_image_copy();
    position.origin.y = first_row;
    let layout =
        wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(row_bytes as u32), rows_per_image: Some(rows) };
    gpu.queue.write_texture(position, rgba, layout, wgpu::Extent3d { width, height: rows, depth_or_array_layers: 1 });
    Ok(())
}

/// Replaces all pixels by those of a bitmap of the same size, if possible without a copy through the CPU.
#[cfg(target_arch = "wasm32")]
pub(crate) fn write_bitmap(
    gpu: &Gpu,
    picture: &PictureOnGpu,
    bitmap: &wgpu::web_sys::ImageBitmap,
) -> Result<(), ViewportError> {
    let (width, height) = (picture.texture.width(), picture.texture.height());
    if [bitmap.width(), bitmap.height()] != [width, height] {
        return Err(ViewportError::BadPicture { width, height, found: 0 });
    }
    let source = wgpu::CopyExternalImageSourceInfo {
        source: wgpu::ExternalImageSource::ImageBitmap(bitmap.clone()),
        origin: wgpu::Origin2d::ZERO,
        flip_y: false,
    };
    let position = wgpu::CopyExternalImageDestInfo {
        texture: &picture.texture,
        mip_level: 0,
        origin: wgpu::Origin3d::ZERO,
        aspect: wgpu::TextureAspect::All,
        color_space: wgpu::PredefinedColorSpace::Srgb,
        premultiplied_alpha: false,
    };
    let size = wgpu::Extent3d { width, height, depth_or_array_layers: 1 };
    gpu.queue.copy_external_image_to_texture(&source, position, size);
    Ok(())
}

/// One white pixel, for meshes without a picture.
pub(crate) fn blank(gpu: &Gpu) -> Result<PictureOnGpu, ViewportError> {
    let pixel = reserve(gpu, 1, 1)?;
    write_rows(gpu, &pixel, 0, &[255; 4])?;
    Ok(pixel)
}

pub(crate) fn sampler(gpu: &Gpu) -> wgpu::Sampler {
    gpu.device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("picture"),
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        mipmap_filter: wgpu::MipmapFilterMode::Linear,
        anisotropy_clamp: 8,
        ..Default::default()
    })
}

/// Pipeline that computes a mip level from the previous one.
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

/// Computes the mip levels; each pixel is the mean of four, in linear light.
pub(crate) fn finish(gpu: &Gpu, shrink: &wgpu::RenderPipeline, PictureOnGpu { texture, .. }: &PictureOnGpu) {
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
        let (source, target) = (level(smaller - 1), level(smaller));
        let resources = [wgpu::BindingResource::TextureView(&source), wgpu::BindingResource::Sampler(&sampler)];
        let bindings = gpu.bind_group(&shrink.get_bind_group_layout(0), resources);
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
        pass.set_bind_group(0, &bindings, &[]);
        pass.draw(0..3, 0..1);
    }
    gpu.queue.submit([encoder.finish()]);
}
