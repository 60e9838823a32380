//! A DXF as its tags say, read by a few lines of its own: what the importer is compared with, so none of its code.
#![allow(
    dead_code,
    reason = "each program takes this file in as its own and uses some of it"
)]

/// A point in drawing units.
pub(crate) type P = [f64; 2];

/// One entity.
#[derive(Clone, Debug, Default)]
pub(crate) struct Entity {
    /// `LINE`, `POLYLINE` (its vertices are in `points`).
    pub(crate) kind: String,
    /// Its layer.
    pub(crate) layer: String,
    /// Its points: both ends of a line, the vertices of a polyline, else where it is.
    pub(crate) points: Vec<P>,
    /// Whether it is a closed polyline.
    pub(crate) closed: bool,
    /// The text of a TEXT, the name of the block of an INSERT.
    pub(crate) text: String,
    /// Whether it is an INSERT that turns, scales, mirrors or repeats, or something seen from behind.
    pub(crate) transformed: bool,
}

/// One block.
#[derive(Default)]
pub(crate) struct Block {
    /// Its name.
    pub(crate) name: String,
    /// What it holds.
    pub(crate) entities: Vec<Entity>,
}

/// A drawing.
#[derive(Default)]
pub(crate) struct Drawing {
    /// All blocks but those of the model and paper space.
    pub(crate) blocks: Vec<Block>,
    /// The model space.
    pub(crate) model: Vec<Entity>,
    /// How many entities are in neither.
    pub(crate) stray: usize,
}

type Tags<'a> = [(i32, &'a str)];

/// Reads a text DXF; what is not understood is left out.
pub(crate) fn read(bytes: &[u8]) -> Drawing {
    let text = String::from_utf8_lossy(bytes)
        .replace("\r\n", "\n")
        .replace('\r', "\n");
    let lines: Vec<&str> = text.split('\n').map(str::trim).collect();
    let tags: Vec<(i32, &str)> = lines
        .chunks_exact(2)
        .filter_map(|pair| Some((pair[0].parse().ok()?, pair[1])))
        .filter(|tag| tag.0 != 999)
        .collect();
    let mut drawing = Drawing::default();
    let mut section = String::new();
    let mut block: Option<Block> = None;
    let starts: Vec<usize> = (0..tags.len()).filter(|i| tags[*i].0 == 0).collect();
    for (k, start) in starts.iter().enumerate() {
        let end = starts.get(k + 1).copied().unwrap_or(tags.len());
        let (kind, own) = (tags[*start].1.to_uppercase(), &tags[start + 1..end]);
        match (kind.as_str(), section.as_str()) {
            ("SECTION", _) => section = first(own, 2).to_uppercase(),
            ("ENDSEC", _) => section.clear(),
            ("EOF", _) => break,
            ("BLOCK", "BLOCKS") => {
                drawing.blocks.extend(block.take());
                let name = first(own, 2).to_owned();
                let entities = Vec::new();
                block = Some(Block { name, entities });
            }
            ("ENDBLK", _) => drawing.blocks.extend(block.take()),
            (kind, "BLOCKS") if block.is_some() => {
                let open = block.as_mut().expect("asked just before");
                add(&mut open.entities, kind, own);
            }
            (kind, "ENTITIES") => add(&mut drawing.model, kind, own),
            (_, "BLOCKS" | "") => drawing.stray += 1,
            _ => {}
        }
    }
    drawing.blocks.extend(block);
    let is_space =
        |name: &str| name.starts_with(['*', '$']) && name.to_lowercase().contains("_space");
    drawing.blocks.retain(|block| !is_space(&block.name));
    drawing
}

fn first<'a>(own: &Tags<'a>, code: i32) -> &'a str {
    own.iter().find(|tag| tag.0 == code).map_or("", |tag| tag.1)
}

fn add(entities: &mut Vec<Entity>, kind: &str, own: &Tags<'_>) {
    let numbers = |code: i32| -> Vec<f64> {
        let found = own.iter().filter(|tag| tag.0 == code);
        found.filter_map(|tag| tag.1.parse().ok()).collect()
    };
    let pairs = |x: i32, y: i32| {
        let pairs = numbers(x).into_iter().zip(numbers(y));
        pairs.map(|(x, y)| [x, y]).collect::<Vec<P>>()
    };
    let flags = numbers(70).first().copied().unwrap_or(0.0);
    let points = match kind {
        "POLYLINE" => Vec::new(),
        "LINE" => [pairs(10, 20), pairs(11, 21)].concat(),
        "LWPOLYLINE" => pairs(10, 20),
        // Of a value that is given twice, the last counts.
        _ => pairs(10, 20).last().copied().into_iter().collect(),
    };
    if kind == "SEQEND" {
        return;
    }
    if kind == "VERTEX" {
        // Control points of a spline are none of its points.
        if let Some(polyline) = entities.last_mut().filter(|_| flags != 16.0) {
            polyline.points.extend(points);
        }
        return;
    }
    let is_changed = |tag: &(i32, &str)| match tag.0 {
        41 | 42 | 70 | 71 => kind == "INSERT" && tag.1.parse() != Ok(1.0),
        50 => kind == "INSERT" && tag.1.parse() != Ok(0.0),
        230 => tag.1.parse() != Ok(1.0),
        _ => false,
    };
    entities.push(Entity {
        kind: kind.to_owned(),
        layer: first(own, 8).to_owned(),
        points,
        closed: flags % 2.0 == 1.0,
        text: first(own, if kind == "INSERT" { 2 } else { 1 }).to_owned(),
        transformed: own.iter().any(is_changed),
    });
}
