//! DXF files written fluently, right ones and hostile ones.
#![allow(
    dead_code,
    reason = "each program takes this file in as its own and uses some of it"
)]

use std::fmt::Write;

/// Writes the text of a DXF, tag by tag.
#[derive(Default)]
pub(crate) struct DxfBuilder {
    blocks: String,
    entities: String,
    in_block: bool,
}

impl DxfBuilder {
    /// A file with one text of the model space: its units.
    pub(crate) fn metric() -> Self {
        Self::default().text("1", "Units: METRIC")
    }

    /// A tag where the builder stands: in the open block, else in the model space.
    pub(crate) fn tag(mut self, code: i32, value: &str) -> Self {
        let out = if self.in_block {
            &mut self.blocks
        } else {
            &mut self.entities
        };
        writeln!(out, "{code}\n{value}").expect("writing to a String cannot fail");
        self
    }

    /// Opens a block and puts it into the model space.
    pub(crate) fn block(mut self, name: &str) -> Self {
        self = self.end_block();
        self = self
            .tag(0, "INSERT")
            .tag(8, "1")
            .tag(2, name)
            .point_tags(0, [0.0, 0.0]);
        self.in_block = true;
        self.tag(0, "BLOCK")
            .tag(8, "0")
            .tag(2, name)
            .point_tags(0, [0.0, 0.0])
    }

    /// Closes the open block, if there is one.
    pub(crate) fn end_block(mut self) -> Self {
        if self.in_block {
            self = self.tag(0, "ENDBLK");
            self.in_block = false;
        }
        self
    }

    /// A text.
    pub(crate) fn text(self, layer: &str, value: &str) -> Self {
        self.tag(0, "TEXT")
            .tag(8, layer)
            .point_tags(0, [0.0, 0.0])
            .tag(1, value)
    }

    /// A point.
    pub(crate) fn point(self, layer: &str, at: [f64; 2]) -> Self {
        self.tag(0, "POINT").tag(8, layer).point_tags(0, at)
    }

    /// A straight line.
    pub(crate) fn line(self, layer: &str, a: [f64; 2], b: [f64; 2]) -> Self {
        self.tag(0, "LINE")
            .tag(8, layer)
            .point_tags(0, a)
            .point_tags(1, b)
    }

    /// An R12 polyline.
    pub(crate) fn run(mut self, layer: &str, closed: bool, points: &[[f64; 2]]) -> Self {
        let flag = if closed { "1" } else { "0" };
        self = self
            .tag(0, "POLYLINE")
            .tag(8, layer)
            .tag(66, "1")
            .tag(70, flag);
        for point in points {
            self = self.tag(0, "VERTEX").tag(8, layer).point_tags(0, *point);
        }
        self.tag(0, "SEQEND").tag(8, layer)
    }

    fn point_tags(self, offset: i32, [x, y]: [f64; 2]) -> Self {
        self.tag(10 + offset, &x.to_string())
            .tag(20 + offset, &y.to_string())
    }

    /// The bytes of the file.
    pub(crate) fn bytes(self) -> Vec<u8> {
        let Self {
            blocks, entities, ..
        } = self.end_block();
        format!(
            "0\nSECTION\n2\nBLOCKS\n{blocks}0\nENDSEC\n0\nSECTION\n2\nENTITIES\n{entities}0\nENDSEC\n0\nEOF\n"
        )
        .into_bytes()
    }
}
