use rosto_export::{BaseColour, ExportOption, Format, Solid, Units};

use crate::{EditsAs, Error, ExpressionsAs, FileOptions, MeshRequest, Triangulation};

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
        use ExportOption::{Edits, Eyes, Height, Solid as SolidBody, TextureSize};
        let is_surface = options.print.solid == Solid::Surface;
        let refused = [
            (by_colours && format == Format::Png, ExportOption::BaseColour, "a .png has no vertex colours"),
            (by_colours && is_given(TextureSize), TextureSize, "base colour `colours` writes no texture"),
            (is_surface && format == Format::ThreeMf, SolidBody, "a .3mf needs a closed body"),
            (is_surface && is_given(Height), Height, "only a closed body is scaled"),
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
