//! Numbers by chance, the same every time.

/// xorshift64* [Vigna 2016].
pub struct Random(pub u64);

impl Random {
    /// Between two numbers.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        let bits = self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 11;
        low + (high - low) * bits as f64 / (1_u64 << 53) as f64
    }

    /// A text with up to three bytes changed, left out or put in, those from among `signs`.
    pub fn spoilt(&mut self, text: &str, signs: &[u8]) -> Vec<u8> {
        let mut text = text.as_bytes().to_vec();
        for _ in 0..1 + self.between(0.0, 3.0) as usize {
            let at = self.between(0.0, text.len() as f64) as usize;
            match self.between(0.0, 3.0) as usize {
                0 => text[at] = self.between(0.0, 256.0) as u8,
                1 => drop(text.remove(at)),
                _ => text.insert(at, signs[self.between(0.0, signs.len() as f64) as usize]),
            }
        }
        text
    }
}
