use glam::DVec3;
use std::collections::HashMap;

use super::push;
use crate::PrintedBody;
use crate::model::MM_PER_M;
use crate::zip::{NamedFile, stored};

/// Colour of the back and the sides.
const NEUTRAL: [u8; 3] = [200, 200, 200];

const CONTENT_TYPES: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>
"#;

const RELATIONSHIPS: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>
"#;

/// Exports a 3MF package: a closed body in millimetres, lying on its back with the face towards +Z, as printers expect.
///
/// The front has the face's colours (materials extension); sides and back are neutral.
pub fn three_mf(printed: &PrintedBody) -> Vec<u8> {
    let files = [
        NamedFile::new("[Content_Types].xml", CONTENT_TYPES),
        NamedFile::new("_rels/.rels", RELATIONSHIPS),
        NamedFile::new("3D/3dmodel.model", model_xml(printed)),
    ];
    stored(&files, 1)
}

fn model_xml(printed: &PrintedBody) -> String {
    let (body, painted) = (&printed.body, Painted::of(printed));
    let low = body.positions_m().iter().copied().reduce(DVec3::min).unwrap_or_default() * MM_PER_M;
    let mut text = String::with_capacity(120 * body.topology().triangles().len());
    text.push_str(concat!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" xml:lang=\"en-US\" ",
        "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" ",
        "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\">\n",
        "<metadata name=\"Title\">face</metadata>\n<metadata name=\"Application\">Rosto ",
        env!("CARGO_PKG_VERSION"),
        "</metadata>\n<resources>\n<m:colorgroup id=\"1\">\n"
    ));
    for [r, g, b] in &painted.colours {
        push(&mut text, format_args!("<m:color color=\"#{r:02X}{g:02X}{b:02X}\"/>\n"));
    }
    text.push_str("</m:colorgroup>\n<object id=\"2\" type=\"model\" pid=\"1\" pindex=\"0\">\n<mesh>\n<vertices>\n");
    for position in body.positions_m() {
        let DVec3 { x, y, z } = *position * MM_PER_M - low;
        push(&mut text, format_args!("<vertex x=\"{x:.5}\" y=\"{y:.5}\" z=\"{z:.5}\"/>\n"));
    }
    text.push_str("</vertices>\n<triangles>\n");
    for ([a, b, c], [p1, p2, p3]) in body.topology().triangles().iter().zip(painted.corners) {
        push(&mut text, format_args!("<triangle v1=\"{a}\" v2=\"{b}\" v3=\"{c}\" pid=\"1\" p1=\"{p1}\""));
        if [p2, p3] != [p1; 2] {
            push(&mut text, format_args!(" p2=\"{p2}\" p3=\"{p3}\""));
        }
        text.push_str("/>\n");
    }
    text.push_str(
        "</triangles>\n</mesh>\n</object>\n</resources>\n<build>\n<item objectid=\"2\"/>\n</build>\n</model>\n",
    );
    text
}

/// A colour palette, neutral first, and the palette indices of each triangle's corners.
struct Painted {
    colours: Vec<[u8; 3]>,
    corners: Vec<[usize; 3]>,
}

impl Painted {
    /// Palette of the distinct vertex colours; front triangles use their vertices' colours, others the neutral one.
    fn of(PrintedBody { body, colours_srgb, .. }: &PrintedBody) -> Self {
        let mut colours = vec![NEUTRAL];
        let mut indices = HashMap::from([(NEUTRAL, 0)]);
        let index_of = |colour: &[u8; 3]| {
            *indices.entry(*colour).or_insert_with(|| {
                colours.push(*colour);
                colours.len() - 1
            })
        };
        let of_vertex: Vec<usize> = colours_srgb.iter().map(index_of).collect();
        let (front, others) = body.topology().triangles().split_at(body.front_triangles());
        let coloured = front.iter().map(|corners| corners.map(|corner| of_vertex[corner as usize]));
        Self { corners: coloured.chain(others.iter().map(|_| [0; 3])).collect(), colours }
    }
}
