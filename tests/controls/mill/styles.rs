//! Finishing passes of many short blocks, as CAM systems write them, in many styles.

use super::{LENGTH, WIDTH};

/// How a program is written.
#[derive(Clone, Copy)]
pub struct Style {
    pub name: &'static str,
    /// Before the blocks; the cutter stands at -14, 5, 0 then.
    pub head: &'static str,
    /// Units for a millimetre, and decimals.
    pub scale: (f64, usize),
    /// Letters of the axes.
    pub letters: [&'static str; 3],
    /// Whether they count on.
    pub is_on: bool,
    /// Whether tracks run across the part.
    pub is_across: bool,
    /// Whether Z stands before X.
    pub is_z_first: bool,
    /// Between words, and at the end of a line.
    pub gap: &'static str,
    pub end: &'static str,
    /// After the blocks.
    pub tail: &'static str,
}

const PLAIN: Style = Style {
    name: "plain",
    head: "G17 G21 G90 G40 G49 G80\nT1 M6\nG54 G0 X-14. Y5.\nG43 H1 Z50.\nG0 Z2.\nG1 Z0. F300\n",
    scale: (1.0, 3),
    letters: ["X", "Y", "Z"],
    is_on: false,
    is_across: false,
    is_z_first: false,
    gap: " ",
    end: "\n",
    tail: "G0 Z50.\nM30\n",
};

pub const STYLES: &[Style] = &[
    PLAIN,
    Style {
        name: "numbered, with lines ended by both, marks and comments with words in them",
        head: "%\r\nO0042 (TOP Z0 X1)\r\nG17 G21 ; Z40\r\nN1 T1\r\nN2 M06\r\nN3 T2 (NEXT Z1)\r\nN4 S900 M3\r\nN5 G0 X-14. Y5.(Z0)\r\n/N6 M8\r\nN7 G43 Z50. H1\r\nN8 G94 G1 Z0. F300.\r\n",
        end: " (Z1 X1)\r\n",
        tail: "N9998 G0 Z50.\r\nN9999 M30\r\n%\r\n\r\n\r\n",
        ..PLAIN
    },
    Style {
        name: "small letters, without blanks, few decimals in the head",
        head: "g17g21\ng0x-14y5z2\ng1z0f300\n",
        letters: ["x", "y", "z"],
        gap: "",
        tail: "g0z50\nm2\n",
        ..PLAIN
    },
    Style {
        name: "counting on by G91",
        head: "G17 G21 G90\nG0 X-14. Y5. Z2.\nG1 Z0. F300\nG91\n",
        is_on: true,
        tail: "G0 Z50.\nG28 Z0.\nG90\nM30\n",
        ..PLAIN
    },
    Style {
        name: "inches",
        head: "G17 G20 G90 G54\nG0 X-.5512 Y.1969 Z.1\nG1 Z0. F12.\n",
        scale: (1.0 / 25.4, 4),
        tail: "G0 Z2.\nM30\n",
        ..PLAIN
    },
    Style { name: "tracks across the part", is_across: true, ..PLAIN },
    Style { name: "Z before X", is_z_first: true, tail: "G91 G28 Z0.\nG28 X0. Y0.\nM30\n", ..PLAIN },
];

impl Style {
    /// Places that the cutter passes, mm: there and back in blocks of 2 mm.
    pub fn path(&self) -> Vec<[f64; 2]> {
        // Tracks across begin beyond the corner.
        let mut spots = if self.is_across { vec![[-14.0, 5.0], [-14.0, -14.0]] } else { vec![[-14.0, 5.0]] };
        let count = if self.is_across { 12 } else { 4 };
        for track in 0..count {
            // Each in the middle of the breadth that is its own.
            let breadth = if self.is_across { LENGTH } else { WIDTH } / f64::from(count);
            let beside = breadth * (f64::from(track) + 0.5);
            let length = if self.is_across { 34 } else { 64 };
            let along = |i: i32| -14.0 + 2.0 * f64::from(if track % 2 == 0 { i } else { length - i });
            let spot = |i: i32| if self.is_across { [beside, along(i)] } else { [along(i), beside] };
            spots.extend((0..=length).map(spot));
        }
        spots.into_iter().map(|spot| spot.map(|place| self.rounded(place))).collect()
    }

    fn rounded(&self, place: f64) -> f64 {
        let step = 10f64.powi(self.scale.1 as i32);
        (place * self.scale.0 * step).round() / step / self.scale.0
    }

    /// A program that mills the top along them.
    pub fn program(&self) -> Vec<u8> {
        let (scale, decimals) = self.scale;
        let path = self.path();
        let mut text = self.head.to_string();
        for pair in path.windows(2) {
            let from = if self.is_on { pair[0] } else { [0.0; 2] };
            let [x, y] = [0, 1].map(|axis| (pair[1][axis] - from[axis]) * scale + 0.0);
            let mut words = [format!("{x:.decimals$}"), format!("{y:.decimals$}"), format!("{:.decimals$}", 0.0)];
            words.iter_mut().zip(self.letters).for_each(|(word, letter)| word.insert_str(0, letter));
            if self.is_z_first {
                words.rotate_right(1);
            }
            text += &format!("{}{}", words.join(self.gap), self.end);
        }
        (text + self.tail).into_bytes()
    }
}
