// The mesh, and where its vertices are at this moment.
struct Shape {
    position_m: vec3f,
    normal: vec3f,
}

struct Follow {
    turn_a: vec3f,
    field_a: f32,
    turn_b: vec3f,
    field_b: f32,
    cross: f32,
}

struct Skin {
    uv: vec2f,
    colour: u32,
    scalar: f32,
}

@group(1) @binding(0) var<storage, read> shapes: array<Shape>;
@group(1) @binding(1) var<storage, read> shapes_before: array<Shape>;
@group(1) @binding(2) var<storage, read> follows: array<Follow>;
@group(1) @binding(3) var<storage, read> skins: array<Skin>;
@group(1) @binding(4) var photo: texture_2d<f32>;
@group(1) @binding(5) var photo_sampler: sampler;

fn position_m(index: u32) -> vec3f {
    let follow = follows[index];
    let edited = shapes[index].position_m + follow.field_a * frame.offset_a_m + follow.field_b * frame.offset_b_m;
    return mix(edited, shapes_before[index].position_m, frame.before);
}

fn normal(index: u32) -> vec3f {
    let follow = follows[index];
    let a = frame.offset_a_m;
    let b = frame.offset_b_m;
    let edited = shapes[index].normal + cross(follow.turn_a, a) + cross(follow.turn_b, b) + cross(a, b) * follow.cross;
    let blended = mix(edited, shapes_before[index].normal, frame.before);
    let size = length(blended);
    return select(vec3f(0.0, 0.0, 1.0), blended / size, size > 0.0);
}

// How far a vertex follows the handles, whichever way, 0..1.
fn response(index: u32) -> f32 {
    return clamp(max(abs(follows[index].field_a), abs(follows[index].field_b)), 0.0, 1.0);
}
