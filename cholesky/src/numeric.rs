//! Numeric factorization: front by front, children first.

use crate::NotPositiveDefinite;
use crate::kernel::FrontFactorization;
use crate::symbolic::{ContributionVertex, Entry, Front, Symbolic};
use crate::tiles::{
    TILE_ROWS, TILE_VERTICES, TileColumn, TileOperation, run, tile_count, triangle_len,
};
use nalgebra::Matrix3;
use pulp::{Arch, Simd};
use std::ops::Range;

/// Factors the part of the matrix of `blocks` that is in some of the fronts: all, or those that one
/// of them needs. The factor and the stacks of contributions are overwritten.
///
/// # Errors
/// The first front with a pivot that is not positive.
pub(crate) fn factorize(
    arch: Arch,
    (symbolic, fronts): (&Symbolic, Range<usize>),
    blocks: &[Matrix3<f64>],
    factor: &mut [TileColumn],
    [even, odd]: &mut [Vec<TileColumn>; 2],
) -> Result<(), usize> {
    for number in fronts {
        let front = &symbolic.fronts[number];
        let (contributions, stack) = if front.is_odd {
            (&even[..], &mut odd[..])
        } else {
            (&odd[..], &mut even[..])
        };
        let children = front.children.iter().map(|&child| &symbolic.fronts[child]);
        let contribution = |child: &Front| &contributions[child.stack..][..child.update_len()];
        let panel = &mut factor[front.panel..front.panel + front.panel_len()];
        panel.fill([0.0; TILE_ROWS]);
        for entry in &symbolic.entries[front.entries.clone()] {
            add_entry(panel, entry, &blocks[entry.block]);
        }
        for child in children.clone() {
            let extend_add = ExtendAdd {
                front,
                child,
                contribution: contribution(child),
                target: Target::Panel(&mut *panel),
            };
            run(arch, extend_add);
        }
        let update = &mut stack[front.stack..front.stack + front.update_len()];
        let factorization = FrontFactorization {
            panel,
            update: &mut *update,
            columns: front.columns(),
            own_tile_rows: front.tile_rows()[0],
        };
        run(arch, factorization).map_err(|NotPositiveDefinite| number)?;
        for child in children {
            let extend_add = ExtendAdd {
                front,
                child,
                contribution: contribution(child),
                target: Target::Update(&mut *update),
            };
            run(arch, extend_add);
        }
    }
    Ok(())
}

fn add_entry(panel: &mut [TileColumn], entry: &Entry, block: &Matrix3<f64>) {
    let block = if entry.is_transposed {
        block.transpose()
    } else {
        *block
    };
    let columns: &[[f64; 3]; 3] = block.as_ref();
    for (target, source) in panel[entry.column..][..3].iter_mut().zip(columns) {
        add(&mut target.as_chunks_mut::<3>().0[entry.in_tile], source);
    }
}

/// The part of a front that a contribution is added to.
enum Target<'f> {
    /// Its own columns.
    Panel(&'f mut [TileColumn]),
    /// Its own contribution.
    Update(&'f mut [TileColumn]),
}

/// The contribution of a child, to be added to a front.
struct ExtendAdd<'f> {
    front: &'f Front,
    child: &'f Front,
    contribution: &'f [TileColumn],
    target: Target<'f>,
}

impl TileOperation for ExtendAdd<'_> {
    type Output = ();

    #[inline(always)]
    fn run<S: Simd, const VECTORS: usize>(self, _simd: S) {
        let own = self.front.own.len();
        let vertices = &self.child.contribution;
        // Those that become columns of the panel come first.
        let owned = vertices.partition_point(|vertex| vertex.place < own);
        let (target, columns, first, start): (_, _, _, fn(&ContributionVertex) -> usize) =
            match self.target {
                Target::Panel(panel) => (panel, 0..owned, 0, |row| row.in_panel),
                Target::Update(update) => (update, owned..vertices.len(), own, |row| row.in_update),
            };
        // In the order in which the contribution lies, tile row by tile row.
        let first_tile = columns.start / TILE_VERTICES;
        for tile in first_tile..tile_count(vertices.len()) {
            let source = &self.contribution[triangle_len(tile)..triangle_len(tile + 1)];
            let rows = TILE_VERTICES * tile..vertices.len().min(TILE_VERTICES * (tile + 1));
            for row in rows.start.max(columns.start)..rows.end {
                let columns = columns.start..columns.end.min(row + 1);
                let places = vertices[columns.clone()]
                    .iter()
                    .map(|vertex| 3 * (vertex.place - first));
                add_row(
                    (&mut target[start(&vertices[row])..], vertices[row].in_tile),
                    places,
                    &source[3 * columns.start..3 * columns.end],
                    row - rows.start,
                );
            }
        }
    }
}

/// Adds the blocks of one row, which are in place `from` of the tile columns of `source`, to the
/// columns of `target` that begin at `places`, in place `to` of their tiles.
#[inline(always)]
fn add_row(
    (target, to): (&mut [TileColumn], usize),
    places: impl Iterator<Item = usize>,
    source: &[TileColumn],
    from: usize,
) {
    for (place, source) in places.zip(source.as_chunks::<3>().0) {
        for (target, source) in target[place..place + 3].iter_mut().zip(source) {
            let source = &source.as_chunks::<3>().0[from];
            add(&mut target.as_chunks_mut::<3>().0[to], source);
        }
    }
}

#[inline(always)]
fn add(target: &mut [f64; 3], source: &[f64; 3]) {
    for (target, source) in target.iter_mut().zip(source) {
        *target += source;
    }
}
