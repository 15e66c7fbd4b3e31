//! What `cargo xtask help` prints.

/// The tasks and what each is for.
pub const TEXT: &str = "\
cargo xtask TASK

  setup         obtain all that the tasks below need and that is missing
  serve         build the page and serve it on 127.0.0.1:8080, or the next free port
  dist          build the page for the web into dist/, and show its sizes
  reproduce     build the page once more, from nothing and elsewhere: it must be dist/ byte for byte
  npm           build the npm package out of the page into target/npm, and pack it
  test [STEP…]  check and test everything, or only the named steps
  deny          check licences, bans and sources of all that is compiled, as deny.toml wants them
  semver        whether the versions of the published crates say what has changed since the last release
  bench [WHAT…] measure against the paper and the peers; --write updates docs/benchmarks.md
  robustness    which faces are found, beside MediaPipe; --write updates docs/robustness.md
  readers       every file in programs that are not ours, Blender too; --write updates docs/opens-elsewhere.md
  torture [MIN] fuzz the readers, then run property, browser and monkey tests at length; 10 minutes a part by default
  screenshots   take the documentation's pictures of the page, its contact sheets, and axe-core's report
  wheel         build the Python package into target/wheels, and try it in an empty environment
  site          build the documentation as a static site into target/site
  help          this text

Every task first obtains what it needs. Tools go to $XDG_CACHE_HOME/rosto (by default ~/.cache/rosto) and are shared by
all checkouts; nothing is fetched or built twice. Debian packages are installed only where something is missing.

  ROSTO_BROWSER  the Chromium or Chrome that the tests drive
  CHROMEDRIVER   its driver
";
