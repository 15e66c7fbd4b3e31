use rosto_export::{BaseColour, ExportOption, Eyes, Format, Material, Solid, TextureSize, Units};

use crate::{Error, MeshRequest, Triangulation};

rosto_mesh::named! {
    /// Representation of edits in a GLB.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum EditsAs {
        /// As part of the shape.
        #[default]
        Shape = "shape",
        /// As one morph target each, on the unedited face.
        MorphTargets = "morph-targets",
    }
}

rosto_mesh::named! {
    /// Representation of expressions in a GLB.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum ExpressionsAs {
        /// As part of the shape.
        #[default]
        Shape = "shape",
        /// As one morph target for each available expression, at its current weight; eyes and mouth are separate
        /// pieces.
        MorphTargets = "morph-targets",
    }
}

/// Options of an exported file; each format uses those that it supports.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FileOptions {
    /// Source of the face's colour.
    pub base_colour: BaseColour,
    /// Longest side of the texture.
    pub texture_size: TextureSize,
    /// Whether the face is lit.
    pub material: Material,
    /// Representation of edits.
    pub edits: EditsAs,
    /// Representation of expressions.
    pub expressions: ExpressionsAs,
    /// Filling of eyes and mouth; separate pieces if expressions are morph targets.
    pub eyes: Eyes,
    /// Unit of the positions in JSON.
    pub units: Units,
    /// Body for printing.
    pub solid: Solid,
}

impl FileOptions {
    /// Sets an option to the choice with this id, or to the text of a [`Solid`].
    ///
    /// # Errors
    /// [`Error::UnknownChoice`].
    pub fn set(&mut self, option: ExportOption, text: &str) -> Result<(), Error> {
        let unknown = |choices: &[&str]| Error::unknown(option.id(), text, choices);
        macro_rules! choose {
            ($field:ident, $kind:ty) => {
                self.$field = <$kind>::from_id(text).ok_or_else(|| unknown(&<$kind>::ALL.map(<$kind>::id)))?
            };
        }
        match option {
            ExportOption::BaseColour => choose!(base_colour, BaseColour),
            ExportOption::TextureSize => choose!(texture_size, TextureSize),
            ExportOption::Material => choose!(material, Material),
            ExportOption::Edits => choose!(edits, EditsAs),
            ExportOption::Expressions => choose!(expressions, ExpressionsAs),
            ExportOption::Eyes => choose!(eyes, Eyes),
            ExportOption::Units => choose!(units, Units),
            ExportOption::Solid => {
                self.solid = text.parse().map_err(|_| unknown(&["thickness:MM", "flat:MM", "surface"]))?;
            }
        }
        Ok(())
    }

    /// Whether a format's files contain edits as morph targets.
    pub(crate) fn has_edit_targets(&self, format: Format) -> bool {
        format.supports(ExportOption::Edits) && self.edits == EditsAs::MorphTargets
    }

    /// Whether a format's files contain expressions as morph targets.
    pub(crate) fn has_expression_targets(&self, format: Format) -> bool {
        format.supports(ExportOption::Expressions) && self.expressions == ExpressionsAs::MorphTargets
    }

    /// Whether a format's files contain eyes and mouth as separate pieces.
    pub(crate) fn has_pieces(&self, format: Format) -> bool {
        let are_eyes_pieces = format.supports(ExportOption::Eyes) && self.eyes == Eyes::Pieces;
        are_eyes_pieces || self.has_expression_targets(format)
    }

    /// Whether a format's files contain the whole-face texture.
    pub(crate) fn has_whole_texture(&self, format: Format) -> bool {
        format.supports(ExportOption::BaseColour) && self.base_colour == BaseColour::Whole
    }
}

impl MeshRequest {
    /// Refuses those of the `given` options that would have no effect on a file of this request.
    ///
    /// # Errors
    /// [`Error::NoEffect`], or [`Error::ImageUnits`] for image coordinates in another format than JSON.
    pub fn check_file(&self, format: Format, options: &FileOptions, given: &[ExportOption]) -> Result<(), Error> {
        let is_image = [self.units, options.units].contains(&Units::Image);
        if is_image && !format.supports(ExportOption::Units) {
            return Err(Error::ImageUnits);
        }
        if let Some(option) = given.iter().find(|option| **option != ExportOption::Units && !format.supports(**option))
        {
            return Err(Error::NoEffect {
                option: *option,
                reason: format!("only {} support it", supporting(*option)),
            });
        }
        let is_given = |option| given.contains(&option);
        let by_colours = options.base_colour == BaseColour::VertexColours;
        let is_open = self.triangulation == Triangulation::Tessellation;
        let has_targets = options.expressions == ExpressionsAs::MorphTargets;
        let has_edit_targets = options.edits == EditsAs::MorphTargets;
        use ExportOption::{Edits, Eyes, Solid as SolidBody, TextureSize};
        let refused = [
            (by_colours && format == Format::Png, ExportOption::BaseColour, "a .png has no vertex colours"),
            (by_colours && is_given(TextureSize), TextureSize, "base colour `colours` writes no texture"),
            (options.solid == Solid::Surface && format == Format::ThreeMf, SolidBody, "a .3mf needs a closed body"),
            (is_given(Eyes) && has_targets, Eyes, "an expression rig implies pieces"),
            (is_given(Eyes) && is_open, Eyes, "the tessellation has openings for eyes and mouth"),
            (has_edit_targets && self.edits.is_empty(), Edits, "no edit is given"),
        ];
        let first = refused.into_iter().find(|(is_refused, ..)| *is_refused);
        first.map_or(Ok(()), |(_, option, reason)| Err(Error::NoEffect { option, reason: reason.to_owned() }))
    }
}

/// The formats that support an option, such as ".stl and .3mf".
fn supporting(option: ExportOption) -> String {
    let formats = Format::ALL.into_iter().filter(|format| format.supports(option));
    let mut names: Vec<String> = formats.map(|format| format!(".{}", format.id())).collect();
    let last = names.pop().unwrap_or_default();
    if names.is_empty() { last } else { format!("{} and {last}", names.join(", ")) }
}
