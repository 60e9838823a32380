//! Seeded numbers for the tests.

/// Numbers that look random, the same every time (`SplitMix64`: G. L. Steele, D. Lea,
/// C. H. Flood, OOPSLA 2014).
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Returns a whole number from 0 to `count` - 1.
    pub(crate) fn below(&mut self, count: u64) -> u64 {
        self.next() % count
    }

    /// Returns a whole number from -`extent` to `extent`.
    pub(crate) fn integer(&mut self, extent: i64) -> i64 {
        let shifted = self.below(2 * extent.unsigned_abs() + 1);
        i64::try_from(shifted).expect("extents are small") - extent
    }

    /// Returns a point of whole coordinates from -`extent` to `extent`, which single precision
    /// holds up to 2²⁴.
    pub(crate) fn point(&mut self, extent: i64) -> [f32; 3] {
        [(); 3].map(|()| self.integer(extent) as f32)
    }
}
