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
        // A face from several photos is fitted here, in the page's own module: 14 kB more.
        limit: 640_000,
    },
    Budget {
        name: "page module for WebGL2",
        files: &["wasm/rosto-studio-webgl_bg.wasm", "wasm/rosto-studio-webgl.js"],
        limit: 1_600_000,
    },
    Budget {
        name: "worker module",
        files: &["wasm/rosto-vision-web_bg.wasm", "wasm/rosto-vision-web.js"],
        limit: 1_600_000,
    },
    Budget {
        name: "networks",
        files: &["assets/face_detector.onnx", "assets/face_landmarks_attention.onnx"],
        limit: 2_600_000,
    },
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

/// Weighs the built page: each part with a budget, all at once, then everything else together.
pub fn weigh(dist: &Path) -> Result<Vec<Row>> {
    let weights = at_once(&BUDGETS, |budget| weight_of_all(budget.files.iter().map(|file| dist.join(file))))?;
    let budgeted = BUDGETS.iter().zip(weights);
    let mut rows: Vec<Row> = budgeted
        .map(|(budget, weight)| Row { name: budget.name.to_owned(), weight, limit: Some(budget.limit) })
        .collect();
    let mut rest = files_below(dist)?;
    rest.retain(|file| !file.to_string_lossy().ends_with(".d.ts"));
    rest.retain(|file| !BUDGETS.iter().flat_map(|budget| budget.files).any(|budgeted| *file == dist.join(budgeted)));
    let name = format!("the other {} files", rest.len());
    rows.push(Row { name, weight: weight_of_all(rest)?, limit: None });
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

/// Does it for each of them, in a thread of its own.
fn at_once<T: Sync, R: Send>(all: &[T], act: impl Fn(&T) -> Result<R> + Sync) -> Result<Vec<R>> {
    std::thread::scope(|scope| {
        let running: Vec<_> = all.iter().map(|one| scope.spawn(|| act(one))).collect();
        running
            .into_iter()
            .map(|thread| thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
            .collect()
    })
}

fn weight_of_all(files: impl IntoIterator<Item = PathBuf>) -> Result<Weight> {
    let weights = files.into_iter().map(|file| weight_of(&file)).collect::<Result<Vec<_>>>()?;
    Ok(weights.into_iter().fold(Weight::default(), Weight::plus))
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

/// All files below a folder, in no order.
pub fn files_below(folder: &Path) -> Result<Vec<PathBuf>> {
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
