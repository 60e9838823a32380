//! Damage done to files, the same for the same seed: bytes, lines and groups deleted, doubled, exchanged, cut off.
#![allow(
    dead_code,
    reason = "each program takes this file in as its own and uses some of it"
)]

/// Numbers by splitmix64.
pub(crate) struct Dice(pub(crate) u64);

impl Dice {
    /// A number below `n`; 0 where `n` is 0.
    pub(crate) fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^= z >> 31;
        usize::try_from(z % (n.max(1) as u64)).expect("below a usize")
    }

    /// A number from 0 to 1.
    pub(crate) fn part(&mut self) -> f64 {
        self.below(1 << 30) as f64 / f64::from(1 << 30)
    }
}

/// A damaged copy. One to three kinds of damage, at places chosen by `seed`.
pub(crate) fn damaged(bytes: &[u8], seed: u64) -> Vec<u8> {
    let mut dice = Dice(seed);
    let mut out = bytes.to_vec();
    for _ in 0..=dice.below(3) {
        out = match dice.below(10) {
            0 => a_byte(out, &mut dice),
            1 => cut_off(out, &mut dice),
            kind => lines(&out, kind, &mut dice),
        };
    }
    out
}

fn a_byte(mut bytes: Vec<u8>, dice: &mut Dice) -> Vec<u8> {
    const BYTES: &[u8] = b"0123456789.-+eE :,xX\r\n\0\xff\x80ABZ";
    let at = dice.below(bytes.len());
    match dice.below(3) {
        _ if bytes.is_empty() => {}
        0 => {
            bytes.remove(at);
        }
        1 => bytes.insert(at, BYTES[dice.below(BYTES.len())]),
        _ => bytes[at] = BYTES[dice.below(BYTES.len())],
    }
    bytes
}

fn cut_off(mut bytes: Vec<u8>, dice: &mut Dice) -> Vec<u8> {
    let keep = dice.below(bytes.len());
    bytes.truncate(keep);
    bytes
}

/// Damage to lines, to groups of two lines, and to whole entities, at which the lines before and after stay in step.
fn lines(bytes: &[u8], kind: usize, dice: &mut Dice) -> Vec<u8> {
    let mut lines: Vec<&[u8]> = bytes.split(|b| *b == b'\n').collect();
    let line = dice.below(lines.len());
    let group = line / 2 * 2;
    let end = lines.len();
    let entity = |from: usize| {
        let opens = |i: &usize| i.is_multiple_of(2) && lines[*i].trim_ascii() == b"0";
        let start = (0..=from).rev().find(opens).unwrap_or(0);
        let stop = (start + 1..end).find(opens).unwrap_or(end);
        start..stop
    };
    let other = dice.below(end);
    match kind {
        2 => {
            lines.remove(line);
        }
        3 => lines.insert(line, lines[line]),
        4 => lines.swap(line, other),
        5 => {
            lines.drain(group..(group + 2).min(end));
        }
        6 => {
            let copy = lines[group..(group + 2).min(end)].to_vec();
            lines.splice(group..group, copy);
        }
        7 => {
            lines.drain(entity(line));
        }
        8 => {
            let copy = lines[entity(line)].to_vec();
            let at = entity(other).start;
            lines.splice(at..at, copy);
        }
        _ => lines[line] = lines[other],
    }
    lines.join(&b'\n')
}
