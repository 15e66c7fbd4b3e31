//! What a visitor downloads, and the budget it must stay in.

use crate::failure::{Doing, Result};
use crate::process::Run;
use crate::{cache, workspace};
use std::path::{Path, PathBuf};

/// A part of the page with the most it may weigh when compressed with brotli.
pub struct Budget {
    /// What the part is.
    pub name: &'static str,
    /// Its files below the built page.
    pub files: &'static [&'static str],
    /// The most it may weigh, in bytes after brotli.
    pub limit: usize,
}

/// The parts that have a budget.
pub const BUDGETS: [Budget; 4] = [
    Budget {
        name: "page module",
        files: &["wasm/rosto-studio-web_bg.wasm", "wasm/rosto-studio-web.js"],
        limit: 400_000,
    },
    Budget {
        name: "page module for WebGL2",
        files: &["wasm/rosto-studio-webgl_bg.wasm", "wasm/rosto-studio-webgl.js"],
        limit: 1_600_000,
    },
    Budget {
        name: "worker module",
        files: &["wasm/rosto-vision-web_bg.wasm", "wasm/rosto-vision-web.js"],
        limit: 1_900_000,
    },
    Budget { name: "networks", files: &["assets/face_detector.onnx", "assets/face_landmarks.onnx"], limit: 1_500_000 },
];

const COMPRESS: &str = "const { readFileSync } = require('node:fs'), zlib = require('node:zlib'); \
    const bytes = readFileSync(process.argv[1]), c = zlib.constants; \
    const params = { [c.BROTLI_PARAM_QUALITY]: 11, [c.BROTLI_PARAM_LGWIN]: 24, [c.BROTLI_PARAM_SIZE_HINT]: bytes.length }; \
    console.log(zlib.brotliCompressSync(bytes, { params }).length)";

/// Bytes of something, as it is and after brotli.
#[derive(Clone, Copy, Default)]
pub struct Weight {
    /// Bytes on disk.
    pub raw: usize,
    /// Bytes after brotli at its best.
    pub brotli: usize,
}

/// One row of the table of sizes.
pub struct Row {
    /// What it is.
    pub name: String,
    /// What it weighs.
    pub weight: Weight,
    /// The most it may weigh after brotli, if it has a budget.
    pub limit: Option<usize>,
}

impl Row {
    /// Whether it stays in its budget.
    pub fn fits(&self) -> bool {
        self.limit.is_none_or(|limit| self.weight.brotli <= limit)
    }
}

/// Weighs the built page: each part with a budget, then everything else together.
pub fn weigh(dist: &Path) -> Result<Vec<Row>> {
    let mut rest = files_below(dist)?;
    let mut rows = Vec::new();
    for budget in &BUDGETS {
        let mut weight = Weight::default();
        for file in budget.files {
            let file = dist.join(file);
            weight = weight.plus(weight_of(&file)?);
            rest.retain(|other| *other != file);
        }
        rows.push(Row { name: budget.name.to_owned(), weight, limit: Some(budget.limit) });
    }
    rest.retain(|file| !file.to_string_lossy().ends_with(".d.ts"));
    let weights = rest.iter().map(|file| weight_of(file)).collect::<Result<Vec<_>>>()?;
    let weight = weights.into_iter().fold(Weight::default(), Weight::plus);
    rows.push(Row { name: format!("the other {} files", rest.len()), weight, limit: None });
    Ok(rows)
}

/// The rows as a Markdown table, in MB of 10⁶ bytes.
pub fn table(rows: &[Row]) -> String {
    let mut lines = vec!["| part | raw MB | brotli MB | budget MB |".to_owned(), "|---|---|---|---|".to_owned()];
    for row in rows {
        let limit = row.limit.map_or_else(String::new, megabytes);
        let Weight { raw, brotli } = row.weight;
        let verdict = if row.fits() { "" } else { " ✗" };
        lines.push(format!("| {} | {} | {} | {limit}{verdict} |", row.name, megabytes(raw), megabytes(brotli)));
    }
    lines.join("\n")
}

impl Weight {
    fn plus(self, other: Self) -> Self {
        Self { raw: self.raw + other.raw, brotli: self.brotli + other.brotli }
    }
}

fn weight_of(file: &Path) -> Result<Weight> {
    let bytes = std::fs::read(file).doing(format!("reading {}", file.display()))?;
    // Brotli at its best takes half a minute over a large module: the size is remembered by the file's sha256.
    let remembered = workspace::target().join("xtask/brotli-sizes").join(cache::sha256(&bytes));
    let known = std::fs::read_to_string(&remembered).ok().and_then(|size| size.parse().ok());
    if let Some(brotli) = known {
        return Ok(Weight { raw: bytes.len(), brotli });
    }
    let brotli = brotli_size(file)?;
    cache::write(&remembered, brotli.to_string())?;
    Ok(Weight { raw: bytes.len(), brotli })
}

/// Bytes after brotli at its best, by Node's zlib: a compressor of its own would double the time this program takes to
/// compile.
fn brotli_size(file: &Path) -> Result<usize> {
    let node = Run::new("node").args(["--eval", COMPRESS]).arg(file).quietly()?.checked()?;
    node.trim().parse().doing(format!("compressing {}", file.display()))
}

fn megabytes(bytes: usize) -> String {
    format!("{:.3}", bytes as f64 / 1e6)
}

fn files_below(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).doing(format!("listing {}", folder.display()))?.flatten() {
        let path = entry.path();
        if path.is_dir() {
            files.extend(files_below(&path)?);
        } else {
            files.push(path);
        }
    }
    Ok(files)
}
