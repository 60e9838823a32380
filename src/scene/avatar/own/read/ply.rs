//! Polygon file format (PLY), ASCII and binary: the vertices and the faces.

use super::builder::SurfaceBuilder;
use super::unreadable::unreadable;
use crate::config::Limits;
use crate::fault::Fault;
use crate::scene::avatar::TriangleMesh;
use nalgebra::Vector3;

/// Lines of a header, and bytes of one of them, beyond which a file is no PLY.
const HEADER_LINES: usize = 1_000;
const LINE_BYTES: usize = 4_096;
/// Corners of a face, beyond which a file is damaged.
const CORNERS: usize = 1_000;

#[derive(Clone, Copy, PartialEq, Eq)]
enum Encoding {
    Ascii,
    Little,
    Big,
}

#[derive(Clone, Copy)]
enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

struct Property {
    name: String,
    /// Type of the count of a list.
    list: Option<Scalar>,
    kind: Scalar,
}

struct Element {
    name: String,
    count: usize,
    properties: Vec<Property>,
}

/// Values of the body of a file, in order.
struct Values<'a> {
    bytes: &'a [u8],
    at: usize,
    encoding: Encoding,
}

/// Reads the faces of a file as fans of triangles.
pub(super) fn read(bytes: &[u8], limits: &Limits) -> Result<TriangleMesh, Fault> {
    let (encoding, elements, at) = header(bytes)?;
    let mut values = Values {
        bytes,
        at,
        encoding,
    };
    let mut builder = SurfaceBuilder::new(limits);
    for element in &elements {
        // what takes no bytes would be read for ever
        if element.properties.is_empty() && element.count > 0 {
            let detail = format!("element {} has no property", element.name);
            return Err(unreadable("header", detail));
        }
        for _ in 0..element.count {
            read_item(element, &mut values, &mut builder)?;
        }
    }
    Ok(builder.finish())
}

fn read_item(
    element: &Element,
    values: &mut Values<'_>,
    builder: &mut SurfaceBuilder<'_>,
) -> Result<(), Fault> {
    let begin = values.at;
    let place = || format!("byte {begin}");
    let mut point = Vector3::repeat(f64::NAN);
    let mut corners = Vec::new();
    for property in &element.properties {
        let count = match property.list {
            Some(kind) => values.count(kind)?,
            None => 1,
        };
        let is_face = matches!(&*property.name, "vertex_indices" | "vertex_index");
        for _ in 0..count {
            let value = values.next(property.kind)?;
            match &*property.name {
                "x" => point.x = value,
                "y" => point.y = value,
                "z" => point.z = value,
                _ if is_face => corners.push(index(value).ok_or_else(|| {
                    unreadable(place(), "a face names a vertex that is not there")
                })?),
                _ => {}
            }
        }
    }
    match &*element.name {
        "vertex" => builder.vertex(point, place),
        "face" => builder.polygon(&corners, place),
        _ => Ok(()),
    }
}

/// Returns a whole number from 0 on.
fn index(value: f64) -> Option<usize> {
    let is_index = value.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(&value);
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "whole, and within the range of u32"
    )]
    is_index.then_some(value as usize)
}

/// Reads the header; with it the offset of what follows.
fn header(bytes: &[u8]) -> Result<(Encoding, Vec<Element>, usize), Fault> {
    let (mut encoding, mut elements) = (None, Vec::<Element>::new());
    let mut at = 0;
    for number in 1..=HEADER_LINES {
        let place = || format!("line {number}");
        let rest = &bytes[at..];
        let end = rest.iter().take(LINE_BYTES).position(|byte| *byte == b'\n');
        let end = end.ok_or_else(|| unreadable(place(), "the header has no end"))?;
        at += end + 1;
        let line = std::str::from_utf8(&rest[..end])
            .map_err(|_| unreadable(place(), "the header is not text"))?;
        let words: Vec<_> = line.split_ascii_whitespace().collect();
        let wrong = || unreadable(place(), "the line of the header is not one of PLY");
        match words[..] {
            ["format", name, _] => encoding = Some(encoding_of(name).ok_or_else(wrong)?),
            ["element", name, count] => elements.push(Element {
                name: name.to_owned(),
                count: count.parse().map_err(|_| wrong())?,
                properties: Vec::new(),
            }),
            ["property", ref property @ ..] => {
                let property = property_of(property).ok_or_else(wrong)?;
                let element = elements.last_mut().ok_or_else(wrong)?;
                element.properties.push(property);
            }
            ["end_header"] => {
                let encoding =
                    encoding.ok_or_else(|| unreadable(place(), "the header has no format"))?;
                return Ok((encoding, elements, at));
            }
            ["ply"] | ["comment" | "obj_info", ..] | [] => {}
            _ => return Err(wrong()),
        }
    }
    Err(unreadable("header", "the header has no end"))
}

fn encoding_of(name: &str) -> Option<Encoding> {
    Some(match name {
        "ascii" => Encoding::Ascii,
        "binary_little_endian" => Encoding::Little,
        "binary_big_endian" => Encoding::Big,
        _ => return None,
    })
}

fn property_of(words: &[&str]) -> Option<Property> {
    let (list, kind, name) = match *words {
        ["list", count, kind, name] => (Some(scalar(count)?), kind, name),
        [kind, name] => (None, kind, name),
        _ => return None,
    };
    Some(Property {
        name: name.to_owned(),
        list,
        kind: scalar(kind)?,
    })
}

fn scalar(name: &str) -> Option<Scalar> {
    Some(match name {
        "char" | "int8" => Scalar::I8,
        "uchar" | "uint8" => Scalar::U8,
        "short" | "int16" => Scalar::I16,
        "ushort" | "uint16" => Scalar::U16,
        "int" | "int32" => Scalar::I32,
        "uint" | "uint32" => Scalar::U32,
        "float" | "float32" => Scalar::F32,
        "double" | "float64" => Scalar::F64,
        _ => return None,
    })
}

impl Values<'_> {
    fn count(&mut self, kind: Scalar) -> Result<usize, Fault> {
        let at = self.at;
        let count = index(self.next(kind)?).filter(|count| *count <= CORNERS);
        count.ok_or_else(|| {
            unreadable(
                format!("byte {at}"),
                "the count of a list is not that of a face",
            )
        })
    }

    fn next(&mut self, kind: Scalar) -> Result<f64, Fault> {
        let at = self.at;
        let value = match self.encoding {
            Encoding::Ascii => self.word(),
            Encoding::Little | Encoding::Big => self.binary(kind),
        };
        value.ok_or_else(|| {
            let detail = "the file ends, or has no number, where one must be";
            unreadable(format!("byte {at}"), detail)
        })
    }

    fn word(&mut self) -> Option<f64> {
        let rest = self.bytes.get(self.at..)?;
        let first = rest.iter().position(|byte| !byte.is_ascii_whitespace())?;
        let word = &rest[first..];
        let end = word.iter().position(u8::is_ascii_whitespace);
        let word = &word[..end.unwrap_or(word.len())];
        self.at += first + word.len();
        std::str::from_utf8(word).ok()?.parse().ok()
    }

    fn binary(&mut self, kind: Scalar) -> Option<f64> {
        match kind {
            Scalar::I8 => Some(f64::from(i8::from_le_bytes(self.take()?))),
            Scalar::U8 => Some(f64::from(u8::from_le_bytes(self.take()?))),
            Scalar::I16 => Some(f64::from(i16::from_le_bytes(self.take()?))),
            Scalar::U16 => Some(f64::from(u16::from_le_bytes(self.take()?))),
            Scalar::I32 => Some(f64::from(i32::from_le_bytes(self.take()?))),
            Scalar::U32 => Some(f64::from(u32::from_le_bytes(self.take()?))),
            Scalar::F32 => Some(f64::from(f32::from_le_bytes(self.take()?))),
            Scalar::F64 => Some(f64::from_le_bytes(self.take()?)),
        }
    }

    /// Takes the bytes of a number, the lowest first.
    fn take<const N: usize>(&mut self) -> Option<[u8; N]> {
        let mut bytes = *self.bytes.get(self.at..)?.first_chunk::<N>()?;
        self.at += N;
        if self.encoding == Encoding::Big {
            bytes.reverse();
        }
        Some(bytes)
    }
}
