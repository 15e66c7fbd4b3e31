use rosto_stage::{Background, Dots, RenderSettings, Stage, Surface, Visibility};

use crate::frame::FrameOnGpu;
use crate::mesh::MeshOnGpu;
use crate::photo_layer::PhotoLayerOnGpu;
use crate::pipelines::{OverlayPair, Pipelines};
use crate::target::Attachments;

/// Resources of a frame.
#[derive(Debug)]
pub(crate) struct FrameResources {
    pub(crate) pipelines: Pipelines,
    pub(crate) frame: FrameOnGpu,
    /// Uniforms of the original shape, for the comparison slider.
    pub(crate) frame_before: FrameOnGpu,
    pub(crate) mesh: Option<MeshOnGpu>,
    pub(crate) photo_layer: Option<PhotoLayerOnGpu>,
    pub(crate) marks: wgpu::Buffer,
    pub(crate) mark_count: u32,
}

/// Records one frame: background, mesh, lines, marks.
pub(crate) fn record(
    drawn: &FrameResources,
    stage: &Stage,
    encoder: &mut wgpu::CommandEncoder,
    attachments: &Attachments,
    resolved: &wgpu::TextureView,
) {
    let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some("frame"),
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view: &attachments.colour,
            depth_slice: None,
            resolve_target: Some(resolved),
            ops: wgpu::Operations {
                load: wgpu::LoadOp::Clear(empty_colour(stage.render_settings().background)),
                store: wgpu::StoreOp::Discard,
            },
        })],
        depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
            view: &attachments.depth,
            depth_ops: Some(wgpu::Operations { load: wgpu::LoadOp::Clear(1.0), store: wgpu::StoreOp::Discard }),
            stencil_ops: None,
        }),
        ..Default::default()
    });
    pass.set_bind_group(0, &drawn.frame.bindings, &[]);
    record_backdrop(drawn, stage.render_settings(), &mut pass);
    match stage.render_settings().wipe {
        Some(share) => record_both(drawn, stage, share, attachments.size, &mut pass),
        None => record_shape(drawn, stage, &mut pass),
    }
}

/// Records the original shape up to a share of the width, and the current shape beyond.
fn record_both(
    drawn: &FrameResources,
    stage: &Stage,
    share: f64,
    [width, height]: [u32; 2],
    pass: &mut wgpu::RenderPass<'_>,
) {
    let edge = ((share * f64::from(width)).round() as u32).min(width);
    pass.set_bind_group(0, &drawn.frame_before.bindings, &[]);
    pass.set_scissor_rect(0, 0, edge, height);
    record_shape(drawn, stage, pass);
    pass.set_bind_group(0, &drawn.frame.bindings, &[]);
    pass.set_scissor_rect(edge, 0, width - edge, height);
    record_shape(drawn, stage, pass);
    // WebGL2 applies the scissor rectangle to the final blit, too.
    pass.set_scissor_rect(0, 0, width, height);
}

fn empty_colour(background: Background) -> wgpu::Color {
    match background {
        Background::Plain(colour) => {
            let [r, g, b, a] = colour.with_alpha(1.0).map(f64::from);
            wgpu::Color { r, g, b, a }
        }
        Background::Ground | Background::Transparent => wgpu::Color::TRANSPARENT,
    }
}

fn record_backdrop(drawn: &FrameResources, settings: &RenderSettings, pass: &mut wgpu::RenderPass<'_>) {
    if settings.background == Background::Ground {
        pass.set_pipeline(&drawn.pipelines.background);
        pass.draw(0..3, 0..1);
    }
}

fn record_shape(drawn: &FrameResources, stage: &Stage, pass: &mut wgpu::RenderPass<'_>) {
    record_photo_layer(drawn, stage, pass);
    record_mesh(drawn, stage, pass);
}

fn record_photo_layer(drawn: &FrameResources, stage: &Stage, pass: &mut wgpu::RenderPass<'_>) {
    let Some(photo_layer) = drawn.photo_layer.as_ref().filter(|_| stage.picture_opacity() > 0.0) else { return };
    pass.set_pipeline(&drawn.pipelines.photo_layer);
    pass.set_bind_group(1, &photo_layer.bindings, &[]);
    pass.set_vertex_buffer(0, photo_layer.points_on_gpu.slice(..));
    pass.set_index_buffer(photo_layer.indices.slice(..), wgpu::IndexFormat::Uint32);
    pass.draw_indexed(0..photo_layer.index_count, 0, 0..1);
}

fn record_mesh(drawn: &FrameResources, stage: &Stage, pass: &mut wgpu::RenderPass<'_>) {
    let Some(mesh) = &drawn.mesh else { return };
    let pipelines = &drawn.pipelines;
    let settings = stage.render_settings();
    pass.set_bind_group(1, &mesh.bindings, &[]);
    pass.set_index_buffer(mesh.indices.slice(..), wgpu::IndexFormat::Uint32);
    // A fully visible picture replaces the mesh, which then only writes depth.
    let is_covered = drawn.photo_layer.is_some() && stage.picture_share() == 1.0;
    let is_depth_only = is_covered || settings.surface == Surface::HiddenLine;
    pass.set_pipeline(if is_depth_only { &pipelines.depth_only } else { &pipelines.surface });
    pass.draw_indexed(0..3 * mesh.topology.triangles().len() as u32, 0, 0..1);
    if settings.background == Background::Ground && !is_depth_only {
        pass.set_pipeline(&pipelines.ground);
        pass.draw(0..6, 0..1);
    }
    if settings.wireframe == Visibility::Shown {
        pass.set_pipeline(&pipelines.wire);
        pass.set_vertex_buffer(0, mesh.edges.slice(..));
        pass.draw(0..6, 0..mesh.topology.edges().len() as u32);
    }
    if settings.dots != Dots::None && settings.surface != Surface::Coloured {
        pass.set_pipeline(&pipelines.dots);
        let vertices = mesh.topology.vertex_count() as u32;
        pass.draw(0..6, 0..settings.dotted.map_or(vertices, |dotted| dotted.min(vertices)));
    }
    record_marks(drawn, stage, pass);
}

fn record_marks(drawn: &FrameResources, stage: &Stage, pass: &mut wgpu::RenderPass<'_>) {
    if stage.gizmo().is_some() {
        record_overlay_pair(&drawn.pipelines.gizmo, 3, pass);
    }
    if drawn.mark_count > 0 {
        pass.set_vertex_buffer(0, drawn.marks.slice(..));
        record_overlay_pair(&drawn.pipelines.marks, drawn.mark_count, pass);
    }
}

fn record_overlay_pair(OverlayPair { seen, hidden }: &OverlayPair, count: u32, pass: &mut wgpu::RenderPass<'_>) {
    for pipeline in [hidden, seen] {
        pass.set_pipeline(pipeline);
        pass.draw(0..6, 0..count);
    }
}
