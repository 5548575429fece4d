//! Symbols of units.

use std::fmt;
use std::ops::Deref;

use serde::{Serialize, Serializer};

/// Symbol of a unit, as `N/um`; empty for a pure number. It holds its text itself, so that a kind of quantity is copied
/// as a number is, whether its unit stands in the program or in a user's file.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct UnitSymbol {
    /// Zero beyond the text.
    bytes: [u8; Self::LONGEST],
    length: u8,
}

impl UnitSymbol {
    /// Most bytes of a symbol; people write some ten.
    pub const LONGEST: usize = 47;

    /// The symbol of this text.
    ///
    /// # Panics
    /// The text is longer than any symbol; a constant of such a text does not compile.
    pub const fn new(text: &str) -> Self {
        match Self::written(text) {
            Some(symbol) => symbol,
            None => panic!("the symbol of a unit is too long"),
        }
    }

    /// The symbol of a text that a user has written; `None` where it is longer than any symbol.
    pub const fn written(text: &str) -> Option<Self> {
        let text = text.as_bytes();
        if text.len() > Self::LONGEST {
            return None;
        }
        let (mut bytes, mut i) = ([0; Self::LONGEST], 0);
        while i < text.len() {
            bytes[i] = text[i];
            i += 1;
        }
        Some(Self { bytes, length: text.len() as u8 })
    }
}

impl Default for UnitSymbol {
    /// That of a pure number.
    fn default() -> Self {
        Self::new("")
    }
}

impl From<UnitSymbol> for String {
    fn from(symbol: UnitSymbol) -> Self {
        (*symbol).into()
    }
}

impl Deref for UnitSymbol {
    type Target = str;

    fn deref(&self) -> &str {
        // It was made of a text.
        std::str::from_utf8(&self.bytes[..usize::from(self.length)]).unwrap_or_default()
    }
}

impl fmt::Display for UnitSymbol {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&**self, f)
    }
}

impl fmt::Debug for UnitSymbol {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Debug::fmt(&**self, f)
    }
}

impl Serialize for UnitSymbol {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self)
    }
}

impl PartialEq<str> for UnitSymbol {
    fn eq(&self, other: &str) -> bool {
        **self == *other
    }
}

impl PartialEq<&str> for UnitSymbol {
    fn eq(&self, other: &&str) -> bool {
        **self == **other
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_symbol_is_the_text_that_it_was_made_of() {
        for text in ["", "N/um", "°C", "µm/m"] {
            assert_eq!(&*UnitSymbol::new(text), text);
        }
        assert_eq!(
            UnitSymbol::written(&"m".repeat(UnitSymbol::LONGEST)).map(|symbol| symbol.len()),
            Some(UnitSymbol::LONGEST)
        );
        assert_eq!(UnitSymbol::written(&"m".repeat(UnitSymbol::LONGEST + 1)), None);
    }
}
