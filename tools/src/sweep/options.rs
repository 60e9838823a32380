//! Options of the sweep.

use super::form::Form;
use super::garment::SweepGarment;
use super::line::SweepLine;
use clap::Args;
use std::path::PathBuf;

/// Sews real garments.
#[derive(Args)]
pub(crate) struct SweepOptions {
    /// Garments to sew; a name may end in `*`. All of them if none is named.
    pub(super) garments: Vec<String>,
    /// Length of mesh edges, in meters; each garment is sewn at every one.
    #[arg(long = "edge-length", default_values_t = [0.015])]
    pub(super) edge_lengths: Vec<f64>,
    /// Lets cloth pass through cloth.
    #[arg(long)]
    pub(super) no_self_contact: bool,
    /// Body that they are sewn on: `own`, the form of each garment's own size; `default`, the
    /// service's; or a file of a body, for all.
    #[arg(long, default_value_t = Form::Own)]
    pub(super) form: Form,
    /// Leaves the seams of all garments to the service, those that are known too.
    #[arg(long)]
    pub(super) suggest: bool,
    /// Instead of the folder's garments, so many drafted ones of each design of `unseen`.
    #[arg(long)]
    pub(super) drafted: Option<u64>,
    /// CPU time allowed to each, in seconds.
    #[arg(long, default_value_t = 60.0)]
    pub(super) time_limit: f64,
    /// Document to write the rows into, between its marks `garments`.
    #[arg(long)]
    pub(super) table: Option<PathBuf>,
    /// Sews the one garment named in this process, and prints its line as JSON.
    #[arg(long, hide = true)]
    pub(super) alone: bool,
}

impl SweepOptions {
    /// Returns true if a garment is to be sewn.
    pub(super) fn names(&self, garment: &SweepGarment) -> bool {
        let fits = |name: &String| match name.strip_suffix('*') {
            Some(start) => garment.name.starts_with(start),
            None => garment.name == *name,
        };
        self.garments.is_empty() || self.garments.iter().any(fits)
    }

    /// Returns the line of a garment of which nothing is known yet.
    pub(super) fn line(&self, garment: &SweepGarment, edge_length: f64) -> SweepLine {
        SweepLine {
            name: garment.name.clone(),
            true_seams: garment.has_true_seams(),
            form: self.form.to_string(),
            edge_length_m: edge_length,
            ..SweepLine::default()
        }
    }
}
