use std::path::PathBuf;

use clap::Args;
use rosto::{MeshRequest, Units, anchor_rule, constraint};
use rosto_face::Region;
use rosto_studio::{
    AnchorKind, Anchors, Command, ConstraintKind, Details, Expression, FaceSlider, Mirror, Operator, RegionOfInfluence,
    Settings,
};

use crate::choices::{listed, one_of};
use crate::edits::{self, MM_PER_M, expression_edit, region_edit, slider_edit, vertex_edit};
use crate::error::CliError;
use crate::settings;

/// Edits of the face.
#[derive(Debug, Args)]
#[command(next_help_heading = "Edits, applied in this order")]
pub struct EditArguments {
    /// JSON file of edits: [{"vertex": 4, "offset": [0, 0, 1], "anchors": [10, 152]}], with "level" for a vertex of a
    /// denser mesh
    #[arg(long = "edits", value_name = "FILE")]
    pub file: Option<PathBuf>,
    /// Move a vertex by an offset, with the given anchors or those of --anchors; repeatable
    ///
    /// Vertices 0 to 467 are the landmarks. VERTEX@LEVEL is a vertex of the mesh at that subdivision level and moves
    /// only meshes of that level or denser, such as 20000@3 with --density 3.
    #[arg(long = "edit", value_name = "VERTEX[@LEVEL]:DX,DY,DZ[:A,B]", allow_hyphen_values = true, value_parser = vertex_edit)]
    pub vertices: Vec<Command>,
    /// Move a region by an offset, such as nose:0,0,5; repeatable
    #[arg(long = "region", value_name = "REGION:DX,DY,DZ", allow_hyphen_values = true, long_help = region_help(), value_parser = region_edit)]
    pub regions: Vec<Command>,
    /// Set a slider in mm, such as jaw-width:-4; repeatable
    #[arg(long = "slider", value_name = "SLIDER:MM", allow_hyphen_values = true, long_help = slider_help(), value_parser = slider_edit)]
    pub sliders: Vec<Command>,
    /// Set the weight of an expression from 0 to 1, such as jawOpen:0.6; repeatable
    #[arg(long = "expression", value_name = "EXPRESSION:WEIGHT", allow_hyphen_values = true, long_help = expression_help(),
        value_parser = expression_edit)]
    pub expressions: Vec<Command>,
    /// Make the face more symmetric, by a share from 0 to 1
    #[arg(long, value_name = "SHARE", allow_negative_numbers = true, value_parser = settings::share)]
    pub symmetrise: Option<f64>,
}

/// Settings of --edit, --edits and --region.
#[derive(Debug, Args)]
#[command(next_help_heading = "Settings of --edit, --edits and --region")]
pub struct SettingsArguments {
    /// Laplacian whose δ-coordinates the edit preserves
    #[arg(long, default_value = Operator::default().id(),
        value_parser = one_of("operator", Operator::ALL, Operator::id, Operator::from_id))]
    pub operator: Operator,
    /// Constraint on handles and anchors: "exact" for hard constraints, or the weight of soft ones
    #[arg(long, value_name = "exact|WEIGHT", allow_negative_numbers = true, default_value = "1", value_parser = constraint)]
    pub constraint: ConstraintKind,
    /// Anchors: two random vertices, the face's oval, the vertices beyond a radius, or only those of --pin
    #[arg(long, value_name = "random|oval|outside:RADIUS|pins", default_value = "random", value_parser = anchor_rule)]
    pub anchors: AnchorKind,
    /// Seed of the random anchors
    #[arg(long, value_name = "N", default_value_t = 0, allow_negative_numbers = true)]
    pub seed: u64,
    /// Additional anchor; repeatable
    #[arg(long = "pin", value_name = "VERTEX", allow_negative_numbers = true)]
    pub pins: Vec<u32>,
    /// Influence radius along the surface, in the units of the edits; vertices beyond it do not move
    #[arg(long, value_name = "RADIUS", allow_negative_numbers = true, value_parser = settings::radius)]
    pub radius: Option<f64>,
    /// Mirror the edit to the other side of the face; only with --units mm
    #[arg(long)]
    pub mirror: bool,
    /// Rotate the surface's details with it (as rigid as possible)
    #[arg(long)]
    pub turn_details: bool,
}

impl EditArguments {
    /// Adds the edits to a request, in the order that `--help` documents and in the request's units.
    pub fn add_to(&self, request: &mut MeshRequest, settings: &SettingsArguments) -> Result<(), CliError> {
        let unit = match request.units {
            Units::Image => 1.0,
            Units::Mm => 1.0 / MM_PER_M,
        };
        let mut moves = self.file.as_deref().map(edits::read).transpose()?.unwrap_or_default();
        moves.extend(self.vertices.iter().chain(&self.regions).cloned());
        request.add_moves(moves.into_iter().map(|edit| edits::scaled(edit, unit)), &settings.settings(unit));
        request.edits.extend(self.sliders.iter().chain(&self.expressions).cloned());
        request.edits.extend(self.symmetrise.map(|share| Command::Symmetrise { share }));
        Ok(())
    }
}

impl SettingsArguments {
    /// Settings of each edit. `unit` converts lengths of the command line to the document's.
    fn settings(&self, unit: f64) -> Settings {
        let kind = match self.anchors {
            AnchorKind::Random { .. } => AnchorKind::Random { seed: self.seed },
            AnchorKind::Outside { radius } => AnchorKind::Outside { radius: radius * unit },
            kind => kind,
        };
        Settings {
            operator: self.operator,
            constraint: self.constraint,
            anchors: Anchors { kind, pins: self.pins.clone() },
            influence: self
                .radius
                .map_or(RegionOfInfluence::Whole, |radius| RegionOfInfluence::Within { radius: radius * unit }),
            mirror: if self.mirror { Mirror::On } else { Mirror::Off },
            details: if self.turn_details { Details::AsRigidAsPossible } else { Details::Kept },
        }
    }
}

fn region_help() -> String {
    let names = listed(Region::ALL, Region::id);
    format!("Move a region by an offset, such as nose:0,0,5; repeatable.\n\nRegions: {names}")
}

fn expression_help() -> String {
    let names = listed(Expression::ALL, Expression::id);
    format!(
        "Set the weight of an expression from 0 to 1, such as jawOpen:0.6; repeatable. Only with --units mm. Left and right are the subject's.\n\nExpressions: {names}"
    )
}

fn slider_help() -> String {
    let names = listed(FaceSlider::ALL, FaceSlider::id);
    format!("Set a slider in mm, such as jaw-width:-4; repeatable. Only with --units mm.\n\nSliders: {names}")
}
