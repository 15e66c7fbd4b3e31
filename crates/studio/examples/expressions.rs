//! Writes the displacements of a face's landmarks by each expression as JSON: `{"expression": [[x, y, z], …], …}`.
//! Reads 468 positions in metres as JSON from standard input; empty input selects the canonical face.

use std::io::Read;

use glam::DVec3;
use rosto_studio::{Expression, Expressions};
use serde_json::{Map, Value, json};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut text = String::new();
    std::io::stdin().read_to_string(&mut text)?;
    let positions_m: Vec<DVec3> = match text.trim() {
        "" => rosto_face::canonical_positions_m(),
        list => serde_json::from_str::<Vec<[f64; 3]>>(list)?.into_iter().map(DVec3::from).collect(),
    };
    let started = std::time::Instant::now();
    let mut expressions = Expressions::new(&positions_m)?;
    let mut file = Map::new();
    for expression in Expression::ALL {
        let displacements = expressions.displacement(expression)?;
        file.insert(
            expression.id().into(),
            displacements.iter().map(|displacement| json!(displacement.to_array())).collect(),
        );
    }
    eprintln!("{} expressions in {:?}", file.len(), started.elapsed());
    println!("{}", Value::from(file));
    Ok(())
}
