use std::borrow::Cow;

use crate::target::{DEPTH_FORMAT, SAMPLES};
use crate::{Gpu, shaders};

/// Render pipelines and their bind group layouts.
#[derive(Debug)]
pub(crate) struct Pipelines {
    pub frame_layout: wgpu::BindGroupLayout,
    pub mesh_layout: wgpu::BindGroupLayout,
    pub photo_layer_layout: wgpu::BindGroupLayout,
    pub background: wgpu::RenderPipeline,
    pub photo_layer: wgpu::RenderPipeline,
    pub ground: wgpu::RenderPipeline,
    pub surface: wgpu::RenderPipeline,
    pub depth_only: wgpu::RenderPipeline,
    pub wire: wgpu::RenderPipeline,
    pub dots: wgpu::RenderPipeline,
    pub marks: OverlayPair,
    pub gizmo: OverlayPair,
}

/// Pipelines for the visible and the occluded part of an overlay.
#[derive(Debug)]
pub(crate) struct OverlayPair {
    pub seen: wgpu::RenderPipeline,
    pub hidden: wgpu::RenderPipeline,
}

/// Opacity of occluded marks.
const HIDDEN_MARK_ALPHA: f64 = 0.3;
/// Opacity of occluded gizmo arms, which must remain easy to pick.
const HIDDEN_ARM_ALPHA: f64 = 0.75;

/// Depth and colour state of a pipeline.
#[derive(Clone, Copy)]
enum Role {
    Backdrop,
    PhotoLayer,
    Solid,
    DepthOnly,
    Overlay,
    SeenThrough { alpha: f64 },
}

struct PipelineSpec<'a> {
    name: &'static str,
    text: &'static str,
    entries: [&'static str; 2],
    role: Role,
    words: &'a [Option<wgpu::VertexBufferLayout<'a>>],
}

const PAIR: [Option<wgpu::VertexBufferLayout<'_>>; 1] = [Some(wgpu::VertexBufferLayout {
    array_stride: 8,
    step_mode: wgpu::VertexStepMode::Instance,
    attributes: &[wgpu::VertexAttribute { format: wgpu::VertexFormat::Uint32x2, offset: 0, shader_location: 0 }],
})];
const POINT: [Option<wgpu::VertexBufferLayout<'_>>; 1] = [Some(wgpu::VertexBufferLayout {
    array_stride: 16,
    step_mode: wgpu::VertexStepMode::Vertex,
    attributes: &[
        wgpu::VertexAttribute { format: wgpu::VertexFormat::Float32x2, offset: 0, shader_location: 0 },
        wgpu::VertexAttribute { format: wgpu::VertexFormat::Float32x2, offset: 8, shader_location: 1 },
    ],
})];
const MAIN: [&str; 2] = ["vertex", "fragment"];

impl Pipelines {
    pub fn new(gpu: &Gpu, format: wgpu::TextureFormat) -> Self {
        let frame_layout = layout(gpu, "frame", &[uniform(0)]);
        let mesh_layout = layout(gpu, "mesh", &[data(0), data(1), data(2), data(3), picture(4), picture_sampler(5)]);
        let photo_layer_layout = layout(gpu, "photo_layer", &[picture(0), picture_sampler(1)]);
        let backdrop = pipeline_layout(gpu, &[Some(&frame_layout)]);
        let over_mesh = pipeline_layout(gpu, &[Some(&frame_layout), Some(&mesh_layout)]);
        let over_picture = pipeline_layout(gpu, &[Some(&frame_layout), Some(&photo_layer_layout)]);
        let build = |layout: &wgpu::PipelineLayout, name, text, role| {
            pipeline(gpu, format, layout, &PipelineSpec { name, text, entries: MAIN, role, words: &[] })
        };
        let overlay_pair = |name, text, entries, words, alpha| {
            let one = |role| pipeline(gpu, format, &over_mesh, &PipelineSpec { name, text, entries, role, words });
            OverlayPair { seen: one(Role::Overlay), hidden: one(Role::SeenThrough { alpha }) }
        };
        let wire = PipelineSpec { name: "wire", text: shaders::WIRE, entries: MAIN, role: Role::Overlay, words: &PAIR };
        let photo_layer = PipelineSpec {
            name: "photo_layer",
            text: shaders::PHOTO_LAYER,
            entries: MAIN,
            role: Role::PhotoLayer,
            words: &POINT,
        };
        Self {
            photo_layer: pipeline(gpu, format, &over_picture, &photo_layer),
            background: build(&backdrop, "background", shaders::BACKGROUND, Role::Backdrop),
            ground: build(&backdrop, "ground", shaders::GROUND, Role::Overlay),
            surface: build(&over_mesh, "surface", shaders::SURFACE, Role::Solid),
            depth_only: build(&over_mesh, "depth_only", shaders::SURFACE, Role::DepthOnly),
            dots: build(&over_mesh, "dots", shaders::DOTS, Role::Overlay),
            wire: pipeline(gpu, format, &over_mesh, &wire),
            marks: overlay_pair("marks", shaders::MARKS, MAIN, &PAIR[..], HIDDEN_MARK_ALPHA),
            gizmo: overlay_pair("gizmo", shaders::GIZMO, ["arm_vertex", "arm_fragment"], &[], HIDDEN_ARM_ALPHA),
            frame_layout,
            mesh_layout,
            photo_layer_layout,
        }
    }
}

fn entry(binding: u32, visibility: wgpu::ShaderStages, ty: wgpu::BindingType) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry { binding, visibility, ty, count: None }
}

fn uniform(binding: u32) -> wgpu::BindGroupLayoutEntry {
    let ty = wgpu::BindingType::Buffer {
        ty: wgpu::BufferBindingType::Uniform,
        has_dynamic_offset: false,
        min_binding_size: None,
    };
    entry(binding, wgpu::ShaderStages::VERTEX_FRAGMENT, ty)
}

fn data(binding: u32) -> wgpu::BindGroupLayoutEntry {
    entry(binding, wgpu::ShaderStages::VERTEX, texture(false))
}

fn picture(binding: u32) -> wgpu::BindGroupLayoutEntry {
    entry(binding, wgpu::ShaderStages::FRAGMENT, texture(true))
}

fn texture(filterable: bool) -> wgpu::BindingType {
    wgpu::BindingType::Texture {
        sample_type: wgpu::TextureSampleType::Float { filterable },
        view_dimension: wgpu::TextureViewDimension::D2,
        multisampled: false,
    }
}

fn picture_sampler(binding: u32) -> wgpu::BindGroupLayoutEntry {
    entry(binding, wgpu::ShaderStages::FRAGMENT, wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering))
}

fn layout(gpu: &Gpu, label: &str, entries: &[wgpu::BindGroupLayoutEntry]) -> wgpu::BindGroupLayout {
    gpu.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some(label), entries })
}

fn pipeline_layout(gpu: &Gpu, groups: &[Option<&wgpu::BindGroupLayout>]) -> wgpu::PipelineLayout {
    gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: None,
        bind_group_layouts: groups,
        immediate_size: 0,
    })
}

fn pipeline(
    gpu: &Gpu,
    format: wgpu::TextureFormat,
    layout: &wgpu::PipelineLayout,
    spec: &PipelineSpec<'_>,
) -> wgpu::RenderPipeline {
    let module = gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some(spec.name),
        source: wgpu::ShaderSource::Wgsl(Cow::Borrowed(spec.text)),
    });
    let constants: &[(&str, f64)] = match spec.role {
        Role::SeenThrough { alpha } => &[("alpha", alpha)],
        _ => &[],
    };
    let options = wgpu::PipelineCompilationOptions { constants, ..Default::default() };
    gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some(spec.name),
        layout: Some(layout),
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some(spec.entries[0]),
            compilation_options: options.clone(),
            buffers: spec.words,
        },
        primitive: Default::default(),
        depth_stencil: Some(depth(spec.role)),
        multisample: wgpu::MultisampleState { count: SAMPLES, ..Default::default() },
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: Some(spec.entries[1]),
            compilation_options: options,
            targets: &[Some(colour(spec.role, format))],
        }),
        multiview_mask: None,
        cache: None,
    })
}

fn depth(role: Role) -> wgpu::DepthStencilState {
    let (write, compare) = match role {
        Role::Backdrop => (false, wgpu::CompareFunction::Always),
        Role::PhotoLayer | Role::Solid | Role::DepthOnly => (true, wgpu::CompareFunction::Less),
        Role::Overlay => (false, wgpu::CompareFunction::LessEqual),
        Role::SeenThrough { .. } => (false, wgpu::CompareFunction::Greater),
    };
    wgpu::DepthStencilState {
        format: DEPTH_FORMAT,
        depth_write_enabled: Some(write),
        depth_compare: Some(compare),
        stencil: Default::default(),
        bias: Default::default(),
    }
}

fn colour(role: Role, format: wgpu::TextureFormat) -> wgpu::ColorTargetState {
    let (blend, write_mask) = match role {
        Role::Backdrop | Role::Solid => (None, wgpu::ColorWrites::ALL),
        Role::DepthOnly => (None, wgpu::ColorWrites::empty()),
        Role::PhotoLayer | Role::Overlay | Role::SeenThrough { .. } => {
            (Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING), wgpu::ColorWrites::ALL)
        }
    };
    wgpu::ColorTargetState { format, blend, write_mask }
}
