// Current vertex positions and normals. Vertex data fill whole texels of a texture, row by row, because WebGL2 has no
// storage buffers.
struct Geometry {
    position_m: vec3f,
    normal: vec3f,
}

struct InfluenceWeights {
    normal_derivative_a: vec3f,
    field_a: f32,
    normal_derivative_b: vec3f,
    field_b: f32,
    cross: f32,
    influence_distance: f32,
}

struct VertexAttributes {
    uv: vec2f,
    scalar: f32,
    colour: vec3f,
}

@group(1) @binding(0) var shapes: texture_2d<f32>;
@group(1) @binding(1) var shapes_before: texture_2d<f32>;
@group(1) @binding(2) var follows: texture_2d<f32>;
@group(1) @binding(3) var attributes: texture_2d<f32>;
@group(1) @binding(4) var picture: texture_2d<f32>;
@group(1) @binding(5) var picture_sampler: sampler;

// Texels per row; same value as in `src/vertex_data.rs`.
const ROW = 1024u;

fn place(texel: u32) -> vec2u {
    return vec2u(texel % ROW, texel / ROW);
}

fn geometry(vertex: u32) -> Geometry {
    let position = textureLoad(shapes, place(2u * vertex), 0);
    let normal = textureLoad(shapes, place(2u * vertex + 1u), 0);
    return Geometry(position.xyz, normal.xyz);
}

fn shape_before(vertex: u32) -> Geometry {
    let position = textureLoad(shapes_before, place(2u * vertex), 0);
    let normal = textureLoad(shapes_before, place(2u * vertex + 1u), 0);
    return Geometry(position.xyz, normal.xyz);
}

fn follow(vertex: u32) -> InfluenceWeights {
    let a = textureLoad(follows, place(3u * vertex), 0);
    let b = textureLoad(follows, place(3u * vertex + 1u), 0);
    let both = textureLoad(follows, place(3u * vertex + 2u), 0);
    return InfluenceWeights(a.xyz, a.w, b.xyz, b.w, both.x, both.y);
}

fn vertex_attributes(vertex: u32) -> VertexAttributes {
    let first = textureLoad(attributes, place(2u * vertex), 0);
    let colour = textureLoad(attributes, place(2u * vertex + 1u), 0);
    return VertexAttributes(first.xy, first.z, colour.rgb);
}

fn position_m(vertex: u32) -> vec3f {
    let follow = follow(vertex);
    let edited = geometry(vertex).position_m + follow.field_a * frame.offset_a_m + follow.field_b * frame.offset_b_m;
    return mix(edited, shape_before(vertex).position_m, frame.before);
}

fn normal(vertex: u32) -> vec3f {
    let follow = follow(vertex);
    let a = frame.offset_a_m;
    let b = frame.offset_b_m;
    let edited = geometry(vertex).normal + cross(follow.normal_derivative_a, a) + cross(follow.normal_derivative_b, b) + cross(a, b) * follow.cross;
    let blended = mix(edited, shape_before(vertex).normal, frame.before);
    let size = length(blended);
    return select(vec3f(0.0, 0.0, 1.0), blended / size, size > 0.0);
}

// Magnitude of a vertex's response to the handles, 0..1.
fn response(vertex: u32) -> f32 {
    let follow = follow(vertex);
    return clamp(max(abs(follow.field_a), abs(follow.field_b)), 0.0, 1.0);
}
