//! Finishing passes of many short blocks, as CAM systems write them, in many styles.

/// How a program is written.
#[derive(Clone, Copy)]
pub struct Style {
    pub name: &'static str,
    /// Before the blocks.
    pub head: &'static str,
    /// Units of X for a millimetre of radius, of Z for a millimetre, and decimals of both.
    pub scale: (f64, f64, usize),
    /// Letters of X and Z.
    pub letters: (&'static str, &'static str),
    /// Whether they count on.
    pub is_on: bool,
    /// Between words, and at the end of a line.
    pub gap: &'static str,
    pub end: &'static str,
    /// After the blocks.
    pub tail: &'static str,
}

const PLAIN: Style = Style {
    name: "plain",
    head: "G18 G21 G90\nT1 M6\nG0 X60. Z5.\nG0 X30. Z1.\nG1 F0.15\n",
    scale: (2.0, 1.0, 3),
    letters: ("X", "Z"),
    is_on: false,
    gap: " ",
    end: "\n",
    tail: "G0 X60. Z5.\nM30\n",
};

pub const STYLES: &[Style] = &[
    PLAIN,
    Style {
        name: "numbered, with lines ended by both, marks and comments with words in them",
        head: "%\r\nO0042 (SHAFT X30 Z1)\r\nG18 G21 ; X40\r\nN1 T0101\r\nN2 G97 S900 M3\r\nN3 G0 X60. Z5.\r\nN4 X30. Z1.(X30)\r\n/N5 M8\r\nN6 G1F.15\r\n",
        end: " (X1 Z1)\r\n",
        tail: "N9998 G0 X60.\r\nN9999 M30\r\n%\r\n\r\n\r\n",
        ..PLAIN
    },
    Style {
        name: "small letters, without blanks, few decimals in the head",
        head: "g18g21\ng0x60z5\nx30z1\ng1f.15\n",
        letters: ("x", "z"),
        gap: "",
        tail: "g0x60\nm2\n",
        ..PLAIN
    },
    Style {
        name: "counting on by G91",
        head: "G18 G21 G90\nG0 X60. Z5.\nG0 X30. Z1.\nG1 F0.15\nG91\n",
        is_on: true,
        tail: "G0 X20.\nG90 G0 Z5.\nM30\n",
        ..PLAIN
    },
    Style {
        name: "counting on by U and W",
        head: "G21 G40 G99\nG28 U0. W0.\nG50 S2000\nT0101\nG0 X60. Z5.\nX30. Z1.\nG4 X1.5\nG1 F0.15\n",
        letters: ("U", "W"),
        is_on: true,
        tail: "G0 U20.\nZ5.\nG28 U0. W0.\nM30\n",
        ..PLAIN
    },
    Style {
        name: "radii by G8",
        head: "G18 G21 G90 G8\nG0 X30. Z5.\nG0 X15. Z1.\nG1 F0.15\n",
        scale: (1.0, 1.0, 4),
        tail: "G0 X30. Z5.\nM2\n",
        ..PLAIN
    },
    Style {
        name: "inches",
        head: "G18 G20 G90 G54\nG0 X2.5 Z.2\nG0 X1.1811 Z.04\nG1 F.006\n",
        scale: (2.0 / 25.4, 1.0 / 25.4, 4),
        tail: "G0 X2.5 Z.2\nM30\n",
        ..PLAIN
    },
];

impl Style {
    /// A program that finishes both sections in blocks of 2 mm.
    pub fn program(&self) -> Vec<u8> {
        let (across, along, decimals) = self.scale;
        let mut spots: Vec<(f64, f64)> = (0..=30).map(|i| (15.0, -2.0 * f64::from(i))).collect();
        spots.extend((0..=20).map(|i| (20.0, -60.0 - 2.0 * f64::from(i))));
        let step = 10f64.powi(decimals as i32);
        let round = |value: f64| (value * step).round() / step;
        let mut at = (round(15.0 * across), round(1.0 * along));
        let mut text = self.head.to_string();
        for (r, z) in spots {
            let to = (round(r * across), round(z * along));
            let (x, z) = if self.is_on { (to.0 - at.0, to.1 - at.1) } else { to };
            let (letters, gap) = (self.letters, self.gap);
            text += &format!("{}{x:.decimals$}{gap}{}{z:.decimals$}{}", letters.0, letters.1, self.end);
            at = to;
        }
        (text + self.tail).into_bytes()
    }
}
