//! Charts as SVG, and the report as one self-contained HTML page.
//!
//! # Overview
//! This crate is for programs that show results of runs and proofs. It takes plain data and contains no physics and no paper. [`Report`] is the
//! content of a page; [`page::render`] writes one HTML file without external references, for screens and for print. Each chart
//! ([`WorkPrecision`], [`Trajectory`], [`Sphere`], [`Areas`], [`Branches`], [`Timings`], and [`Sheet`] with the charts of one run)
//! has a method `svg` that returns a separate picture; equal data give equal bytes. A [`Sketch`] is a drawing of a mechanism, still or animated.
//!
//! Texts may contain LaTeX between dollar signs; labels inside pictures are plain text. LaTeX that cannot be typeset is
//! shown as source text and reported in [`Page::unset`].
//!
//! Tested properties: nothing is loaded from outside, every text is escaped and made harmless ([`visible`]), no number is silently left out.
//!
//! # Example
//! ```
//! assert_eq!(dalembert_charts::significant(0.30382, 3), "0.304");
//! let formula = dalembert_charts::mathml(r"\frac{1}{2} m v^2").expect("it can be typeset");
//! assert!(formula.starts_with("<math"));
//! ```

pub mod page;

mod report;
mod svg;
mod text;
mod visible;

pub use claims::Verdict;
pub use page::Page;
pub use report::{ClaimRow, PaperSection, Parameter, Report, SceneSection, Study, Table};
pub use svg::areas::{AreaCurve, Areas};
pub use svg::branches::{BranchPanel, BranchPiece, Branches, Standing};
pub use svg::number::{significant, tolerance};
pub use svg::sheet::Sheet;
pub use svg::sketch::{Instant, STYLE as SKETCH_STYLE, Sketch, SketchPart, SurfaceKind, View};
pub use svg::sphere::{Curve, CurvePoint, Mark, Sphere};
pub use svg::timings::{Contender, TimingRow, Timings};
pub use svg::trajectory::{Panel, Track, Trajectory};
pub use svg::work_precision::{Failure, Method, Point, Work, WorkPrecision};
pub use text::{Unset, mathml};
pub use visible::visible;
