//! WGSL sources, concatenated with their shared parts.

macro_rules! shader {
    ($($file:literal),+) => { concat!($(include_str!(concat!("../shaders/", $file, ".wgsl")), "\n"),+) };
}

pub(crate) const BACKGROUND: &str = shader!("frame", "background");
pub(crate) const GROUND: &str = shader!("frame", "ground");
pub(crate) const SURFACE: &str = shader!("frame", "mesh", "surface");
pub(crate) const WIRE: &str = shader!("frame", "mesh", "wire");
pub(crate) const DOTS: &str = shader!("frame", "mesh", "dots");
pub(crate) const MARKS: &str = shader!("frame", "mesh", "marks");
pub(crate) const GIZMO: &str = shader!("frame", "mesh", "marks", "gizmo");
pub(crate) const PHOTO_LAYER: &str = shader!("frame", "photo_layer");
pub(crate) const SHRINK: &str = shader!("shrink");

#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests {
    use rosto_stage::FrameUniforms;

    use super::*;
    use crate::vertex::{Geometry, InfluenceWeights, VertexAttributes};

    const ALL: [(&str, &str); 9] = [
        ("background", BACKGROUND),
        ("ground", GROUND),
        ("surface", SURFACE),
        ("wire", WIRE),
        ("dots", DOTS),
        ("marks", MARKS),
        ("gizmo", GIZMO),
        ("photo_layer", PHOTO_LAYER),
        ("shrink", SHRINK),
    ];

    fn module(text: &str) -> naga::Module {
        naga::front::wgsl::parse_str(text).unwrap_or_else(|error| panic!("{}", error.emit_to_string(text)))
    }

    fn size_of_struct(module: &naga::Module, name: &str) -> usize {
        let found = module.types.iter().find(|(_, found)| found.name.as_deref() == Some(name));
        match found.map(|(_, found)| &found.inner) {
            Some(naga::TypeInner::Struct { span, .. }) => *span as usize,
            other => panic!("{name}: {other:?}"),
        }
    }

    #[test]
    fn shaders_are_valid() {
        for (name, text) in ALL {
            let mut validator =
                naga::valid::Validator::new(naga::valid::ValidationFlags::all(), naga::valid::Capabilities::empty());
            let valid = validator.validate(&module(text));
            assert!(valid.is_ok(), "{name}: {:?}", valid.err());
        }
    }

    #[test]
    fn each_shader_file_is_validated() {
        let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/shaders");
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let text = std::fs::read_to_string(&path).unwrap();
            assert!(ALL.iter().any(|(_, joined)| joined.contains(&text)), "{} is not used", path.display());
        }
    }

    #[test]
    fn structs_have_the_same_size_in_rust_and_wgsl() {
        let surface = module(SURFACE);
        assert_eq!(size_of_struct(&surface, "FrameUniforms"), size_of::<FrameUniforms>());
        assert_eq!(size_of_struct(&surface, "Geometry"), size_of::<Geometry>());
        assert_eq!(size_of_struct(&surface, "InfluenceWeights"), size_of::<InfluenceWeights>());
        assert_eq!(size_of_struct(&surface, "VertexAttributes"), size_of::<VertexAttributes>());
    }
}
