use glam::{DVec2, DVec3};
use rosto_mesh::Topology;
use wgpu::BindingResource::{Sampler, TextureView};
use wgpu::util::DeviceExt;

use crate::pipelines::Pipelines;
use crate::vertex::{Geometry, InfluenceWeights, VertexAttributes, geometry, influence_weights};
use crate::vertex_data::VertexData;
use crate::{Gpu, PictureOnGpu, ViewportError, picture};

/// Mesh to draw.
#[derive(Debug, Clone, Copy)]
pub struct MeshInput<'a> {
    /// Triangles and vertex count.
    pub topology: &'a Topology,
    /// Vertex positions in metres.
    pub positions_m: &'a [DVec3],
    /// sRGB colour per vertex; empty for white.
    pub colours_srgb: &'a [[u8; 3]],
    /// Texture coordinates in the picture, 0..1 from its top left; empty without a picture.
    pub uvs: &'a [DVec2],
    /// Texture; `None` for white.
    pub picture: Option<&'a PictureOnGpu>,
}

/// Mesh in GPU memory.
#[derive(Debug)]
pub(crate) struct MeshOnGpu {
    pub topology: Topology,
    positions_m: Vec<DVec3>,
    geometry: VertexData<Geometry>,
    geometry_before: VertexData<Geometry>,
    influence: VertexData<InfluenceWeights>,
    attributes: VertexData<VertexAttributes>,
    attribute_list: Vec<VertexAttributes>,
    pub indices: wgpu::Buffer,
    pub edges: wgpu::Buffer,
    pub bindings: wgpu::BindGroup,
}

impl MeshOnGpu {
    pub fn new(
        gpu: &Gpu,
        pipelines: &Pipelines,
        blank: &PictureOnGpu,
        input: &MeshInput<'_>,
    ) -> Result<Self, ViewportError> {
        let attribute_list = attributes(input)?;
        check_length("positions", input.positions_m.len(), input.topology.vertex_count())?;
        let picture = input.picture.unwrap_or(blank);
        let geometry_list = geometry(input.topology, input.positions_m);
        let geometry_now = VertexData::new(gpu, &geometry_list)?;
        let geometry_before = VertexData::new(gpu, &geometry_list)?;
        let influence = VertexData::new(gpu, &vec![InfluenceWeights::default(); attribute_list.len()])?;
        let attributes = VertexData::new(gpu, &attribute_list)?;
        let textures =
            [geometry_now.view(), geometry_before.view(), influence.view(), attributes.view(), picture.view.clone()];
        let sampler = picture::sampler(gpu);
        let resources = textures.iter().map(TextureView).chain([Sampler(&sampler)]);
        Ok(Self {
            bindings: gpu.bind_group(&pipelines.mesh_layout, resources),
            indices: filled(gpu, bytemuck::cast_slice(input.topology.triangles()), wgpu::BufferUsages::INDEX),
            edges: filled(gpu, bytemuck::cast_slice(input.topology.edges()), wgpu::BufferUsages::VERTEX),
            topology: input.topology.clone(),
            positions_m: input.positions_m.to_vec(),
            geometry: geometry_now,
            geometry_before,
            influence,
            attributes,
            attribute_list,
        })
    }

    pub fn write_positions(&mut self, gpu: &Gpu, positions_m: &[DVec3]) -> Result<(), ViewportError> {
        check_length("positions", positions_m.len(), self.topology.vertex_count())?;
        self.positions_m.copy_from_slice(positions_m);
        self.geometry.write(gpu, &geometry(&self.topology, positions_m));
        Ok(())
    }

    pub fn write_before(&self, gpu: &Gpu, positions_m: &[DVec3]) -> Result<(), ViewportError> {
        check_length("positions", positions_m.len(), self.topology.vertex_count())?;
        self.geometry_before.write(gpu, &geometry(&self.topology, positions_m));
        Ok(())
    }

    pub fn write_fields(
        &self,
        gpu: &Gpu,
        fields: [Option<&[f64]>; 2],
        influence_distances: Option<&[f64]>,
    ) -> Result<(), ViewportError> {
        for field in fields.into_iter().chain([influence_distances]).flatten() {
            check_length("responses", field.len(), self.topology.vertex_count())?;
        }
        self.influence.write(gpu, &influence_weights(&self.topology, &self.positions_m, fields, influence_distances));
        Ok(())
    }

    pub fn write_uvs(&mut self, gpu: &Gpu, uvs: &[DVec2]) -> Result<(), ViewportError> {
        check_length("texture coordinates", uvs.len(), self.topology.vertex_count())?;
        self.attribute_list.iter_mut().zip(uvs).for_each(|(attributes, uv)| attributes.uv = uv.as_vec2().to_array());
        self.attributes.write(gpu, &self.attribute_list);
        Ok(())
    }

    pub fn write_scalars(&mut self, gpu: &Gpu, scalars: &[f64]) -> Result<(), ViewportError> {
        check_length("scalars", scalars.len(), self.topology.vertex_count())?;
        self.attribute_list.iter_mut().zip(scalars).for_each(|(attributes, &scalar)| attributes.scalar = scalar as f32);
        self.attributes.write(gpu, &self.attribute_list);
        Ok(())
    }
}

pub(crate) fn check_length(what: &'static str, found: usize, expected: usize) -> Result<(), ViewportError> {
    if found == expected { Ok(()) } else { Err(ViewportError::LengthMismatch { what, expected, found }) }
}

fn attributes(input: &MeshInput<'_>) -> Result<Vec<VertexAttributes>, ViewportError> {
    if !input.colours_srgb.is_empty() {
        check_length("colours", input.colours_srgb.len(), input.topology.vertex_count())?;
    }
    if !input.uvs.is_empty() || input.picture.is_some() {
        check_length("texture coordinates", input.uvs.len(), input.topology.vertex_count())?;
    }
    let attributes = |vertex: usize| {
        let colour = input.colours_srgb.get(vertex).copied().unwrap_or([255; 3]);
        VertexAttributes {
            uv: input.uvs.get(vertex).map_or([0.0; 2], |uv| uv.as_vec2().to_array()),
            colour: colour.map(|channel| f32::from(channel) / 255.0),
            ..VertexAttributes::default()
        }
    };
    Ok((0..input.topology.vertex_count()).map(attributes).collect())
}

/// Creates a buffer with these bytes; at least 48, because empty buffers are invalid.
pub(crate) fn filled(gpu: &Gpu, bytes: &[u8], usage: wgpu::BufferUsages) -> wgpu::Buffer {
    let contents = if bytes.is_empty() { &[0; 48] } else { bytes };
    let usage = usage | wgpu::BufferUsages::COPY_DST;
    gpu.device.create_buffer_init(&wgpu::util::BufferInitDescriptor { label: None, contents, usage })
}
