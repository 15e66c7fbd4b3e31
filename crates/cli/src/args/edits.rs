use std::path::PathBuf;

use clap::Args;
use rosto_face::Region;
use rosto_studio::{
    AnchorKind, Anchors, ConstraintKind, Details, Expression, FaceSlider, Mirror, Operator, RegionOfInfluence, Settings,
};

use crate::choices::{listed, one_of};
use crate::edits::{Edit, ExpressionEdit, RegionEdit, SliderEdit};
use crate::settings::{self, Rule};

/// What is moved.
#[derive(Debug, Args)]
#[command(next_help_heading = "Edits, made in this order, each on the mesh that the last one left")]
pub struct EditArguments {
    /// A JSON file of edits: [{"vertex": 4, "offset": [0, 0, 1], "anchors": [10, 152]}], with "level" for a denser mesh's
    #[arg(long = "edits", value_name = "FILE")]
    pub file: Option<PathBuf>,
    /// A vertex, its offset, and the vertices that anchor it (else those of --anchors); repeatable
    ///
    /// Vertices 0 to 467 are the landmarks. VERTEX@LEVEL is one of the mesh cut up so many times, which moves that mesh and
    /// no coarser one: 20000@3 with --density 3.
    #[arg(long = "edit", value_name = "VERTEX[@LEVEL]:DX,DY,DZ[:A,B]", allow_hyphen_values = true)]
    pub vertices: Vec<Edit>,
    /// A named region and its offset, such as nose:0,0,5; repeatable
    #[arg(long = "region", value_name = "REGION:DX,DY,DZ", allow_hyphen_values = true, long_help = region_help())]
    pub regions: Vec<RegionEdit>,
    /// A ready-made slider and its amount in mm, such as jaw-width:-4; repeatable
    #[arg(long = "slider", value_name = "SLIDER:MM", allow_hyphen_values = true, long_help = slider_help())]
    pub sliders: Vec<SliderEdit>,
    /// An expression and how much of it the face shows, from 0 to 1, such as jawOpen:0.6; repeatable
    #[arg(long = "expression", value_name = "EXPRESSION:WEIGHT", allow_hyphen_values = true, long_help = expression_help())]
    pub expressions: Vec<ExpressionEdit>,
    /// Brings both sides closer to each other, by a share from 0 to 1
    #[arg(long, value_name = "SHARE", allow_negative_numbers = true, value_parser = settings::share)]
    pub symmetrise: Option<f64>,
}

/// How the mesh follows what is moved.
#[derive(Debug, Args)]
#[command(next_help_heading = "How the mesh follows")]
pub struct SettingsArguments {
    /// The Laplacian whose δ-coordinates an edit keeps
    #[arg(long, default_value = Operator::default().id(),
        value_parser = one_of("operator", Operator::ALL, Operator::id, Operator::from_id))]
    pub operator: Operator,
    /// How firmly handles and anchors are held: "exact", or the weight of a soft constraint
    #[arg(long, value_name = "exact|WEIGHT", allow_negative_numbers = true, default_value = "1", value_parser = settings::constraint)]
    pub constraint: ConstraintKind,
    /// What stays in place: two random vertices, the face's oval, everything further away than a radius, or only --pin
    #[arg(long, value_name = "random|oval|outside:RADIUS|pins", default_value = "random", value_parser = settings::anchors)]
    pub anchors: Rule,
    /// Chooses the random anchors
    #[arg(long, value_name = "N", default_value_t = 0, allow_negative_numbers = true)]
    pub seed: u64,
    /// A vertex that stays in place, beside the others; repeatable
    #[arg(long = "pin", value_name = "VERTEX", allow_negative_numbers = true)]
    pub pins: Vec<u32>,
    /// Lets nothing move further than this from what is moved, along the surface, in the units of the edits
    #[arg(long, value_name = "RADIUS", allow_negative_numbers = true, value_parser = settings::radius)]
    pub radius: Option<f64>,
    /// Moves the other side of the face by the mirrored offset; in millimetres only
    #[arg(long)]
    pub mirror: bool,
    /// Lets details turn with the surface (as rigid as possible)
    #[arg(long)]
    pub turn_details: bool,
}

impl SettingsArguments {
    /// The settings for the edit with this number, counted from 0. `unit` is the document's for one of the command line's.
    pub fn of_edit(&self, number: usize, unit: f64) -> Settings {
        let kind = match self.anchors {
            Rule::Random => AnchorKind::Random { seed: self.seed.wrapping_add(number as u64) },
            Rule::Oval => AnchorKind::Oval,
            Rule::Outside { radius } => AnchorKind::Outside { radius: radius * unit },
            Rule::PinsOnly => AnchorKind::PinsOnly,
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
    format!("A named region and its offset, such as nose:0,0,5; repeatable.\n\nRegions: {names}")
}

fn expression_help() -> String {
    let names = listed(Expression::ALL, Expression::id);
    format!(
        "An expression and how much of it the face shows, from 0 to 1, such as jawOpen:0.6; repeatable. In millimetres only. Left and right are the subject's.\n\nExpressions: {names}"
    )
}

fn slider_help() -> String {
    let names = listed(FaceSlider::ALL, FaceSlider::id);
    format!(
        "A ready-made slider and its amount in mm, such as jaw-width:-4; repeatable. In millimetres only.\n\nSliders: {names}"
    )
}
