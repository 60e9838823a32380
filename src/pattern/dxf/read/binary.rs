//! Binary DXF as text DXF, so that one tag pass checks both.

use crate::fault::{Fault, PatternCode};

/// Converts a binary DXF, given without its sentinel, to text. Lines then count tags: tag `n`
/// stands in lines `2n - 1` and `2n`.
///
/// # Errors
/// A group code or value that is cut off or unknown.
pub(crate) fn to_text(bytes: &[u8]) -> Result<Vec<u8>, Fault> {
    // Since R13 group codes have two bytes, so the first tag begins 0, 0, "SECTION"; before, 0,
    // "SECTION".
    let wide = bytes.get(1) == Some(&0);
    let mut reader = BinaryReader {
        rest: bytes,
        tag: 0,
    };
    let mut text = Vec::with_capacity(2 * bytes.len());
    while !reader.rest.is_empty() {
        reader.tag += 1;
        let code = reader.code(wide)?;
        text.extend(format!("{code}\n").bytes());
        reader.value(code, wide, &mut text)?;
        text.push(b'\n');
        if text.ends_with(b"0\nEOF\n") {
            break;
        }
    }
    Ok(text)
}

/// A reader of the tags of a binary DXF.
struct BinaryReader<'a> {
    rest: &'a [u8],
    tag: usize,
}

impl BinaryReader<'_> {
    fn take<const N: usize>(&mut self) -> Result<[u8; N], Fault> {
        let (head, rest) = self
            .rest
            .split_first_chunk::<N>()
            .ok_or_else(|| self.fault("is cut off"))?;
        self.rest = rest;
        Ok(*head)
    }

    fn code(&mut self, wide: bool) -> Result<i16, Fault> {
        if wide {
            return Ok(i16::from_le_bytes(self.take()?));
        }
        match self.take::<1>()? {
            [255] => Ok(i16::from_le_bytes(self.take()?)),
            [code] => Ok(i16::from(code)),
        }
    }

    /// Reads the value that belongs to a group code, and adds it to `text`.
    fn value(&mut self, code: i16, wide: bool, text: &mut Vec<u8>) -> Result<(), Fault> {
        let value = match code {
            0..=9
            | 100..=102
            | 105
            | 300..=309
            | 320..=369
            | 390..=399
            | 410..=419
            | 430..=439
            | 470..=481
            | 999..=1003
            | 1005..=1009 => {
                return self.string(text);
            }
            10..=59 | 110..=149 | 210..=239 | 460..=469 | 1010..=1059 => {
                f64::from_le_bytes(self.take()?).to_string()
            }
            60..=79 | 170..=179 | 270..=289 | 370..=389 | 400..=409 | 1060..=1070 => {
                i16::from_le_bytes(self.take()?).to_string()
            }
            90..=99 | 420..=429 | 440..=459 | 1071 => i32::from_le_bytes(self.take()?).to_string(),
            160..=169 => i64::from_le_bytes(self.take()?).to_string(),
            290..=299 if wide => self.take::<1>()?[0].to_string(),
            290..=299 => i16::from_le_bytes(self.take()?).to_string(),
            310..=319 | 1004 => {
                let [count] = self.take::<1>()?;
                self.rest = self
                    .rest
                    .get(usize::from(count)..)
                    .ok_or_else(|| self.fault("is cut off"))?;
                String::new()
            }
            _ => {
                return Err(self.fault(&format!(
                    "has the group code {code}, which DXF does not know"
                )));
            }
        };
        text.extend(value.bytes());
        Ok(())
    }

    fn string(&mut self, text: &mut Vec<u8>) -> Result<(), Fault> {
        let end = self
            .rest
            .iter()
            .position(|b| *b == 0)
            .ok_or_else(|| self.fault("is cut off"))?;
        text.extend(
            self.rest[..end]
                .iter()
                .map(|b| if matches!(b, b'\n' | b'\r') { b' ' } else { *b }),
        );
        self.rest = &self.rest[end + 1..];
        Ok(())
    }

    fn fault(&self, what: &str) -> Fault {
        Fault::new(
            PatternCode::Binary,
            format!("line {}", 2 * self.tag),
            format!("tag {} of this binary DXF {what}", self.tag),
        )
        .fix("export the file again, as ASCII DXF")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_widths_of_group_codes_are_read() {
        let mut old = b"\0SECTION\0\x0a".to_vec();
        old.extend(1.5_f64.to_le_bytes());
        old.extend([66, 1, 0]);
        assert_eq!(to_text(&old).expect("old"), b"0\nSECTION\n10\n1.5\n66\n1\n");
        let mut new = b"\0\0SECTION\0\x0a\0".to_vec();
        new.extend(1.5_f64.to_le_bytes());
        new.extend([66, 0, 1, 0]);
        assert_eq!(to_text(&new).expect("new"), b"0\nSECTION\n10\n1.5\n66\n1\n");
    }

    #[test]
    fn cut_off_value_is_refused() {
        assert_eq!(
            to_text(b"\0SECTION\0\x0a\0\0")
                .expect_err("cut off")
                .pointer,
            "line 4"
        );
    }
}
