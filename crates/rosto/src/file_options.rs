use rosto_export::{BaseColour, ExportOption, Eyes, Format, Material, Print, TextureSize, Units};

use crate::Error;

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
    pub print: Print,
}

impl FileOptions {
    /// Sets an option to the choice with this id, or to the text of a [`Solid`](rosto_export::Solid) or a
    /// [`PrintHeight`](rosto_export::PrintHeight).
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
                self.print.solid =
                    text.parse().map_err(|_| unknown(&["thickness:MM", "flat:MM", "flat", "surface"]))?;
            }
            ExportOption::Height => {
                self.print.height = text.parse().map_err(|_| unknown(&["life", "MM"]))?;
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
    pub fn has_pieces(&self, format: Format) -> bool {
        let are_eyes_pieces = format.supports(ExportOption::Eyes) && self.eyes == Eyes::Pieces;
        are_eyes_pieces || self.has_expression_targets(format)
    }

    /// Whether a format's files contain the whole-face texture.
    pub(crate) fn has_whole_texture(&self, format: Format) -> bool {
        format.supports(ExportOption::BaseColour) && self.base_colour == BaseColour::Whole
    }
}
