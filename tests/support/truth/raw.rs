//! A DXF as its tags say, read by a few lines of its own: what the importer is compared with, so none of its code.

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
}

/// One block.
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
}

/// Reads a text DXF; what is not understood is left out.
pub(crate) fn read(bytes: &[u8]) -> Drawing {
    let text = String::from_utf8_lossy(bytes)
        .replace("\r\n", "\n")
        .replace('\r', "\n");
    let lines: Vec<&str> = text.split('\n').map(str::trim).collect();
    let tags: Vec<(i32, &str)> = lines
        .chunks_exact(2)
        .filter_map(|pair| Some((pair[0].parse().ok()?, pair[1])))
        .collect();
    let mut drawing = Drawing::default();
    let mut section = "";
    let mut in_block = false;
    let starts: Vec<usize> = (0..tags.len()).filter(|i| tags[*i].0 == 0).collect();
    for (k, start) in starts.iter().enumerate() {
        let end = starts.get(k + 1).copied().unwrap_or(tags.len());
        let (kind, own) = (tags[*start].1, &tags[start + 1..end]);
        let value = |code: i32| own.iter().find(|tag| tag.0 == code).map_or("", |tag| tag.1);
        match kind {
            "SECTION" => section = value(2),
            "BLOCK" => {
                in_block = true;
                let name = value(2).to_owned();
                drawing.blocks.push(Block {
                    name,
                    entities: Vec::new(),
                });
            }
            "ENDBLK" => in_block = false,
            "SEQEND" | "ENDSEC" | "EOF" => {}
            _ if section == "BLOCKS" && in_block => {
                let block = drawing.blocks.last_mut().expect("a block is open");
                add(&mut block.entities, kind, own);
            }
            _ if section == "ENTITIES" => add(&mut drawing.model, kind, own),
            _ => {}
        }
    }
    let is_space =
        |name: &str| name.starts_with(['*', '$']) && name.to_lowercase().contains("_space");
    drawing.blocks.retain(|block| !is_space(&block.name));
    drawing
}

fn add(entities: &mut Vec<Entity>, kind: &str, own: &[(i32, &str)]) {
    let numbers = |code: i32| -> Vec<f64> {
        let found = own.iter().filter(|tag| tag.0 == code);
        found.filter_map(|tag| tag.1.parse().ok()).collect()
    };
    let mut points: Vec<P> = numbers(10)
        .into_iter()
        .zip(numbers(20))
        .map(|(x, y)| [x, y])
        .collect();
    if kind == "VERTEX" {
        if let Some(polyline) = entities.last_mut() {
            polyline.points.extend(points);
        }
        return;
    }
    match kind {
        "POLYLINE" => points.clear(),
        "LINE" => points.extend(
            numbers(11)
                .into_iter()
                .zip(numbers(21))
                .map(|(x, y)| [x, y]),
        ),
        _ => {}
    }
    let layer = own.iter().find(|tag| tag.0 == 8).map_or("", |tag| tag.1);
    let flags = numbers(70).first().copied().unwrap_or(0.0);
    entities.push(Entity {
        kind: kind.to_owned(),
        layer: layer.to_owned(),
        points,
        closed: flags % 2.0 == 1.0,
    });
}
