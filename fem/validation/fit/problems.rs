//! The problems: formulas, where the search begins, certified values and their standard deviations.
//!
//! Source: NIST Statistical Reference Datasets, nonlinear regression, <https://www.itl.nist.gov/div898/strd/>,
//! a work of the United States government in the public domain. What NIST calls x is the position in m, and y
//! a deviation in m, but for Nelson, whose x1 is a time in s.

/// A parameter: its unit, NIST's starts 1 and 2, the certified value, and the certified standard deviation.
pub type Parameter = (&'static str, [f64; 2], f64, f64);

/// A problem of the collection.
pub struct Problem {
    /// NIST's name.
    pub name: &'static str,
    /// Formula over the coordinates and the parameters b1, b2, …
    pub formula: &'static str,
    /// In their order.
    pub parameters: &'static [Parameter],
    /// The data as a measurement file.
    pub data: &'static str,
    /// From which of NIST's starts the certified minimum is reached: not from start 1 of MGH10 and BoxBOD,
    /// which lead to other minima, and to four digits only from that of MGH09.
    pub reached_from: &'static [usize],
}

/// Lower level of difficulty.
const MISRA1A: Problem = Problem {
    name: "Misra1a",
    formula: "b1*(1 - exp(-b2*position))",
    parameters: &[
        ("m", [500.0, 250.0], 238.94212918, 2.7070075241),
        ("1/m", [0.0001, 0.0005], 0.00055015643181, 7.2668688436e-6),
    ],
    data: include_str!("nist/misra1a.csv"),
    reached_from: &[1, 2],
};
/// Lower level of difficulty.
const CHWIRUT2: Problem = Problem {
    name: "Chwirut2",
    formula: "exp(-b1*position)/(b2 + b3*position)",
    parameters: &[
        ("1/m", [0.1, 0.15], 0.16657666537, 0.03830328681),
        ("1/m", [0.01, 0.008], 0.0051653291286, 0.00066621605126),
        ("1/m^2", [0.02, 0.01], 0.012150007096, 0.0015304234767),
    ],
    data: include_str!("nist/chwirut2.csv"),
    reached_from: &[1, 2],
};
/// Lower level of difficulty.
const LANCZOS3: Problem = Problem {
    name: "Lanczos3",
    formula: "b1*exp(-b2*position) + b3*exp(-b4*position) + b5*exp(-b6*position)",
    parameters: &[
        ("m", [1.2, 0.5], 0.086816414977, 0.017197908859),
        ("1/m", [0.3, 0.7], 0.95498101505, 0.097041624475),
        ("m", [5.6, 3.6], 0.84400777463, 0.041488663282),
        ("1/m", [5.5, 4.2], 2.9515951832, 0.10766312506),
        ("m", [6.5, 4.0], 1.5825685901, 0.058371576281),
        ("1/m", [7.6, 6.3], 4.9863565084, 0.034436403035),
    ],
    data: include_str!("nist/lanczos3.csv"),
    reached_from: &[1, 2],
};
/// Lower level of difficulty.
const GAUSS1: Problem = Problem {
    name: "Gauss1",
    formula: "b1*exp(-b2*position) + b3*exp(-((position - b4)/b5)^2) + b6*exp(-((position - b7)/b8)^2)",
    parameters: &[
        ("m", [97.0, 94.0], 98.778210871, 0.5752731273),
        ("1/m", [0.009, 0.0105], 0.010497276517, 0.00011406289017),
        ("m", [100.0, 99.0], 100.48990633, 0.58831775752),
        ("m", [65.0, 63.0], 67.481111276, 0.10460593412),
        ("m", [20.0, 25.0], 23.12977336, 0.17439951146),
        ("m", [70.0, 71.0], 71.994503004, 0.62622793913),
        ("m", [178.0, 180.0], 178.99805021, 0.12436988217),
        ("m", [16.5, 20.0], 18.389389025, 0.20134312832),
    ],
    data: include_str!("nist/gauss1.csv"),
    reached_from: &[1, 2],
};
/// Average level of difficulty.
const NELSON: Problem = Problem {
    name: "Nelson",
    formula: "b1 - b2*time*exp(-b3*position)",
    parameters: &[
        ("m", [2.0, 2.5], 2.5906836021, 0.019149996413),
        ("m/s", [0.0001, 5e-9], 5.6177717026e-9, 6.112409654e-9),
        ("1/m", [-0.01, -0.05], -0.057701013174, 0.0039572366543),
    ],
    data: include_str!("nist/nelson.csv"),
    reached_from: &[1, 2],
};
/// Average level of difficulty.
const HAHN1: Problem = Problem {
    name: "Hahn1",
    formula: "(b1 + b2*position + b3*position^2 + b4*position^3)/(1 + b5*position + b6*position^2 + b7*position^3)",
    parameters: &[
        ("m", [10.0, 1.0], 1.0776351733, 0.17070154742),
        ("", [-1.0, -0.1], -0.12269296921, 0.012000289189),
        ("1/m", [0.05, 0.005], 0.004086375061, 0.00022508314937),
        ("1/m^2", [-1e-5, -1e-6], -1.4262662514e-6, 2.7578037666e-7),
        ("1/m", [-0.05, -0.005], -0.0057609940901, 0.00024712888219),
        ("1/m^2", [0.001, 0.0001], 0.00024053735503, 1.0449373768e-5),
        ("1/m^3", [-1e-6, -1e-7], -1.2314450199e-7, 1.3027335327e-8),
    ],
    data: include_str!("nist/hahn1.csv"),
    reached_from: &[1, 2],
};
/// Higher level of difficulty.
const THURBER: Problem = Problem {
    name: "Thurber",
    formula: "(b1 + b2*position + b3*position^2 + b4*position^3)/(1 + b5*position + b6*position^2 + b7*position^3)",
    parameters: &[
        ("m", [1000.0, 1300.0], 1288.13968, 4.6647963344),
        ("", [1000.0, 1500.0], 1491.0792535, 39.571156086),
        ("1/m", [400.0, 500.0], 583.23836877, 28.698696102),
        ("1/m^2", [40.0, 75.0], 75.416644291, 5.567537027),
        ("1/m", [0.7, 1.0], 0.96629502864, 0.031333340687),
        ("1/m^2", [0.3, 0.4], 0.39797285797, 0.014984928198),
        ("1/m^3", [0.03, 0.05], 0.049727297349, 0.0065842344623),
    ],
    data: include_str!("nist/thurber.csv"),
    reached_from: &[1, 2],
};
/// Higher level of difficulty.
const MGH09: Problem = Problem {
    name: "MGH09",
    formula: "b1*(position^2 + position*b2)/(position^2 + position*b3 + b4)",
    parameters: &[
        ("m", [25.0, 0.25], 0.19280693458, 0.011435312227),
        ("m", [39.0, 0.39], 0.19128232873, 0.19633220911),
        ("m", [41.5, 0.415], 0.12305650693, 0.080842031232),
        ("m^2", [39.0, 0.39], 0.13606233068, 0.090025542308),
    ],
    data: include_str!("nist/mgh09.csv"),
    reached_from: &[2],
};
/// Higher level of difficulty.
const MGH10: Problem = Problem {
    name: "MGH10",
    formula: "b1*exp(b2/(position + b3))",
    parameters: &[
        ("m", [2.0, 0.02], 0.005609636471, 0.00015687892471),
        ("m", [400000.0, 4000.0], 6181.3463463, 23.309021107),
        ("m", [25000.0, 250.0], 345.22363462, 0.78486103508),
    ],
    data: include_str!("nist/mgh10.csv"),
    reached_from: &[2],
};
/// Higher level of difficulty.
const RAT42: Problem = Problem {
    name: "Rat42",
    formula: "b1/(1 + exp(b2 - b3*position))",
    parameters: &[
        ("m", [100.0, 75.0], 72.462237576, 1.7340283401),
        ("", [1.0, 2.5], 2.6180768402, 0.088295217536),
        ("1/m", [0.1, 0.07], 0.067359200066, 0.0034465663377),
    ],
    data: include_str!("nist/rat42.csv"),
    reached_from: &[1, 2],
};
/// Higher level of difficulty.
const RAT43: Problem = Problem {
    name: "Rat43",
    formula: "b1/(1 + exp(b2 - b3*position))^(1/b4)",
    parameters: &[
        ("m", [100.0, 700.0], 699.6415127, 16.302297817),
        ("", [10.0, 5.0], 5.2771253025, 2.0828735829),
        ("1/m", [1.0, 0.75], 0.75962938329, 0.19566123451),
        ("", [1.0, 1.3], 1.2792483859, 0.68761936385),
    ],
    data: include_str!("nist/rat43.csv"),
    reached_from: &[1, 2],
};
/// Higher level of difficulty.
const BENNETT5: Problem = Problem {
    name: "Bennett5",
    formula: "b1*((b2 + position)/unit)^(-1/b3)",
    parameters: &[
        ("m", [-2000.0, -1500.0], -2523.5058043, 297.15175411),
        ("m", [50.0, 45.0], 46.736564644, 1.2448871856),
        ("", [0.8, 0.85], 0.93218483193, 0.020272299378),
    ],
    data: include_str!("nist/bennett5.csv"),
    reached_from: &[1, 2],
};
/// Higher level of difficulty.
const ECKERLE4: Problem = Problem {
    name: "Eckerle4",
    formula: "b1/b2*exp(-0.5*((position - b3)/b2)^2)",
    parameters: &[
        ("m^2", [1.0, 1.5], 1.5543827178, 0.015408051163),
        ("m", [10.0, 5.0], 4.0888321754, 0.046803020753),
        ("m", [500.0, 450.0], 451.54121844, 0.046800518816),
    ],
    data: include_str!("nist/eckerle4.csv"),
    reached_from: &[1, 2],
};
/// Higher level of difficulty.
const BOXBOD: Problem = Problem {
    name: "BoxBOD",
    formula: "b1*(1 - exp(-b2*position))",
    parameters: &[("m", [1.0, 100.0], 213.80940889, 12.354515176), ("1/m", [1.0, 0.75], 0.54723748542, 0.10455993237)],
    data: include_str!("nist/boxbod.csv"),
    reached_from: &[2],
};

/// From lower to higher difficulty.
pub const ALL: &[Problem] = &[
    MISRA1A, CHWIRUT2, LANCZOS3, GAUSS1, NELSON, HAHN1, THURBER, MGH09, MGH10, RAT42, RAT43, BENNETT5, ECKERLE4, BOXBOD,
];
