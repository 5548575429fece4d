//! Materials as shops name them, with what handbooks say of them, and with the specific cutting force of Kienzle where one
//! is published.
//!
//! Properties are typical values at room temperature, the expansion the mean of 20 to 100 degC; names of other standards are
//! near equivalents. Handbooks and heats differ by `spread`, judged from several tables: half a width, some two standard
//! deviations. A part that matters deserves its own table.

use super::properties::{Material, material};

/// A material and the names by which it goes.
pub struct Entry {
    /// Its names, that of the European standard first.
    pub names: &'static [&'static str],
    /// Its properties.
    pub material: Material,
    /// By what handbooks differ in E, expansion, conductivity and specific heat, percent.
    pub spread: [f64; 4],
    /// Where such values stand.
    pub source: &'static str,
    /// What it resists cutting with.
    pub cutting: Option<Cutting>,
}

/// The specific cutting force kc = kc1.1·h^(−mc), h in mm [O. Kienzle, VDI-Z 94 (1952) 299].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cutting {
    /// kc1.1: force on a chip 1 mm thick and 1 mm wide, Pa.
    pub specific_force: f64,
    /// mc: the exponent of the thickness.
    pub exponent: f64,
    /// The farthest that another table lies from this one at h = 0.2 mm, percent.
    pub scatter: f64,
    /// The table.
    pub source: &'static str,
}

const fn cutting(
    newtons_per_square_millimetre: f64,
    exponent: f64,
    scatter: f64,
    source: &'static str,
) -> Option<Cutting> {
    Some(Cutting { specific_force: 1e6 * newtons_per_square_millimetre, exponent, scatter, source })
}

/// The list.
pub const ALL: &[Entry] = &[
    Entry {
        names: &["C45", "1.0503", "C45E", "1.1191", "Ck45", "AISI 1045", "SAE 1045", "1045", "S45C", "Сталь 45"],
        material: material(210.0e9, 0.3, 7850.0, 11.4e-6, 50.0, 470.0),
        spread: [3.0, 4.0, 6.0, 4.0],
        source: "usual values of steelmakers' datasheets after SEW 310 / F. Richter, Stahleisen-Sonderberichte 10 (1983); Lucefin card C45U 1.1730 (E 210, alpha 11.1, k 50, c 460); MatWeb AISI 1045 (alpha 11.5, k 49.8, c 486)",
        cutting: cutting(
            1600.0,
            0.25,
            20.0,
            "Sandvik Coromant, Training Handbook / material cross reference, MC: P1.2.Z.AN",
        ),
    },
    Entry {
        names: &["C15", "1.0401", "C15E", "1.1141", "Ck15", "AISI 1015", "SAE 1015", "1015", "S15C", "Сталь 15"],
        material: material(210.0e9, 0.3, 7850.0, 11.9e-6, 51.0, 470.0),
        spread: [3.0, 4.0, 6.0, 4.0],
        source: "usual values of steelmakers' datasheets after SEW 310 / F. Richter, Stahleisen-Sonderberichte 10 (1983); BISRA, Physical constants of some commercial steels (1953), 0.23 % C (k 51.9 at 0 degC)",
        cutting: cutting(
            1500.0,
            0.25,
            20.0,
            "Sandvik Coromant, Training Handbook / material cross reference, MC: P1.1.Z.AN",
        ),
    },
    Entry {
        names: &["S235JR", "1.0038", "S235", "St37-2", "RSt37-2", "St37", "SS400", "Ст3сп", "Ст3"],
        material: material(210.0e9, 0.3, 7850.0, 12.0e-6, 53.3, 440.0),
        spread: [2.0, 3.0, 5.0, 5.0],
        source: "EN 1993-1-1:2005 3.2.6 (E, nu, alpha); EN 1993-1-2:2005 3.4.1 at 20 degC (k, c); EN 1991-1-1 (density)",
        cutting: cutting(1500.0, 0.21, 15.0, "Walter, machining groups: P1"),
    },
    Entry {
        names: &[
            "S355J2",
            "1.0577",
            "S355JR",
            "1.0045",
            "S355",
            "St52-3",
            "1.0570",
            "ASTM A572 Grade 50",
            "SM490",
            "09Г2С",
        ],
        material: material(210.0e9, 0.3, 7850.0, 12.0e-6, 53.3, 440.0),
        spread: [2.0, 3.0, 5.0, 5.0],
        source: "EN 1993-1-1:2005 3.2.6 (E, nu, alpha); EN 1993-1-2:2005 3.4.1 at 20 degC (k, c); EN 1991-1-1 (density)",
        cutting: cutting(1500.0, 0.21, 15.0, "Walter, machining groups: P1"),
    },
    Entry {
        names: &["E295", "1.0050", "St50-2", "SS490", "Ст5сп"],
        material: material(210.0e9, 0.3, 7850.0, 11.9e-6, 50.0, 465.0),
        spread: [3.0, 4.0, 6.0, 4.0],
        source: "usual values of steelmakers' datasheets after SEW 310 / F. Richter, Stahleisen-Sonderberichte 10 (1983); as C45 and S355",
        cutting: cutting(1700.0, 0.25, 20.0, "Walter, machining groups: P2"),
    },
    Entry {
        names: &["11SMn30", "1.0715", "9SMn28", "AISI 1213", "1213", "SUM22"],
        material: material(207.0e9, 0.3, 7850.0, 11.9e-6, 50.0, 470.0),
        spread: [3.0, 4.0, 8.0, 4.0],
        source: "usual values of steelmakers' datasheets after SEW 310 / F. Richter, Stahleisen-Sonderberichte 10 (1983); free-cutting steel taken as low-carbon steel",
        cutting: cutting(
            1350.0,
            0.21,
            15.0,
            "ISCAR, material groups by VDI 3323 (turning catalogue 2017, p. 558; 2022 boring, p. 111): 1",
        ),
    },
    Entry {
        names: &["16MnCr5", "1.7131", "16MnCrS5", "1.7139", "AISI 5115", "5115", "18ХГ"],
        material: material(210.0e9, 0.3, 7850.0, 11.5e-6, 44.0, 465.0),
        spread: [3.0, 4.0, 8.0, 4.0],
        source: "usual values of steelmakers' datasheets after SEW 310 / F. Richter, Stahleisen-Sonderberichte 10 (1983)",
        cutting: cutting(
            1775.0,
            0.24,
            25.0,
            "ISCAR, material groups by VDI 3323 (turning catalogue 2017, p. 558; 2022 boring, p. 111): 6",
        ),
    },
    Entry {
        names: &[
            "42CrMo4",
            "1.7225",
            "42CrMoS4",
            "1.7227",
            "AISI 4140",
            "SAE 4140",
            "4140",
            "SCM440",
            "42CD4",
            "708M40",
            "38ХМ",
        ],
        material: material(210.0e9, 0.3, 7840.0, 11.9e-6, 42.6, 470.0),
        spread: [3.0, 5.0, 6.0, 4.0],
        source: "usual values of steelmakers' datasheets after SEW 310 / F. Richter, Stahleisen-Sonderberichte 10 (1983); Meusburger 1.7225 (k 42.6); MatWeb AISI 4140 (alpha 12.2)",
        cutting: cutting(2000.0, 0.25, 30.0, "Walter, machining groups: P8"),
    },
    Entry {
        names: &["34CrNiMo6", "1.6582", "AISI 4340", "SAE 4340", "4340", "SNCM439", "817M40", "38Х2Н2МА"],
        material: material(210.0e9, 0.3, 7840.0, 11.8e-6, 40.0, 475.0),
        spread: [3.0, 5.0, 10.0, 4.0],
        source: "usual values of steelmakers' datasheets after SEW 310 / F. Richter, Stahleisen-Sonderberichte 10 (1983); MatWeb AISI 4340 (alpha 12.3, k 44.5, c 475)",
        cutting: cutting(
            1900.0,
            0.25,
            15.0,
            "Sandvik Coromant, Training Handbook / material cross reference, MC: P2.5.Z.HT",
        ),
    },
    Entry {
        names: &["100Cr6", "1.3505", "AISI 52100", "SAE 52100", "52100", "SUJ2", "ШХ15", "535A99"],
        material: material(210.0e9, 0.3, 7820.0, 11.9e-6, 44.0, 475.0),
        spread: [3.0, 4.0, 15.0, 4.0],
        source: "MatWeb / AZoM AISI 52100 (density 7.81, alpha 11.9, k 46.6, c 475); gauge blocks of steel have 11.5 +- 1.0 (ISO 3650)",
        cutting: cutting(
            1775.0,
            0.24,
            15.0,
            "ISCAR, material groups by VDI 3323 (turning catalogue 2017, p. 558; 2022 boring, p. 111): 6",
        ),
    },
    Entry {
        names: &["X5CrNi18-10", "1.4301", "AISI 304", "304", "SUS304", "08Х18Н10", "V2A"],
        material: material(200.0e9, 0.3, 7900.0, 16.0e-6, 15.0, 500.0),
        spread: [3.0, 3.0, 5.0, 3.0],
        source: "EN 10088-1, annex of physical properties (density, E, alpha 20..100, k, c); nu: EN 1993-1-4",
        cutting: cutting(2000.0, 0.20, 20.0, "Tabellenbuch Zerspantechnik, 5th ed. 2022, p. 215: austenitic"),
    },
    Entry {
        names: &["X6CrNiMoTi17-12-2", "1.4571", "AISI 316Ti", "316Ti", "SUS316Ti", "10Х17Н13М2Т"],
        material: material(200.0e9, 0.3, 8000.0, 16.5e-6, 15.0, 500.0),
        spread: [3.0, 3.0, 5.0, 3.0],
        source: "EN 10088-1, annex of physical properties (density, E, alpha 20..100, k, c); nu: EN 1993-1-4",
        cutting: cutting(2000.0, 0.20, 15.0, "Tabellenbuch Zerspantechnik, 5th ed. 2022, p. 215: austenitic"),
    },
    Entry {
        names: &["X2CrNiMo17-12-2", "1.4404", "AISI 316L", "316L", "SUS316L"],
        material: material(200.0e9, 0.3, 8000.0, 16.0e-6, 15.0, 500.0),
        spread: [3.0, 3.0, 5.0, 3.0],
        source: "EN 10088-1, annex of physical properties (density, E, alpha 20..100, k, c); nu: EN 1993-1-4",
        cutting: cutting(2000.0, 0.20, 15.0, "Tabellenbuch Zerspantechnik, 5th ed. 2022, p. 215: austenitic"),
    },
    Entry {
        names: &["X20Cr13", "1.4021", "AISI 420", "420", "SUS420J1", "20Х13"],
        material: material(215.0e9, 0.3, 7700.0, 10.5e-6, 30.0, 460.0),
        spread: [3.0, 3.0, 15.0, 3.0],
        source: "EN 10088-1, annex of physical properties (density, E, alpha 20..100, k, c); nu: EN 1993-1-4",
        cutting: cutting(
            1875.0,
            0.21,
            30.0,
            "ISCAR, material groups by VDI 3323 (turning catalogue 2017, p. 558; 2022 boring, p. 111): 13",
        ),
    },
    Entry {
        names: &["X153CrMoV12", "X155CrVMo12-1", "1.2379", "AISI D2", "D2", "SKD11", "Х12МФ"],
        material: material(210.0e9, 0.29, 7700.0, 10.4e-6, 20.0, 460.0),
        spread: [3.0, 4.0, 15.0, 4.0],
        source: "Boehler K110 and Uddeholm Sverker 21 datasheets (E, density, k, c); AISI D2: alpha 10.4 (20..100)",
        cutting: cutting(2000.0, 0.25, 20.0, "Walter, machining groups: P11"),
    },
    Entry {
        names: &["EN-GJL-200", "5.1300", "EN-JL1030", "GG-20", "0.6020", "ASTM A48 Class 30", "FC200", "СЧ20"],
        material: material(100.0e9, 0.26, 7150.0, 11.0e-6, 50.0, 460.0),
        spread: [12.0, 6.0, 8.0, 5.0],
        source: "EN 1561:1997, informative annex of physical properties (E 0 of a range; k at 100 degC; c 20..200 degC); alpha between its 10.0 (-100..20) and 11.7 (20..200) (88..113)",
        cutting: cutting(1050.0, 0.23, 20.0, "Tabellenbuch Zerspantechnik, 5th ed. 2022, p. 215: GJL"),
    },
    Entry {
        names: &["EN-GJL-250", "5.1301", "EN-JL1040", "GG-25", "0.6025", "ASTM A48 Class 35", "FC250", "СЧ25"],
        material: material(110.0e9, 0.26, 7200.0, 11.0e-6, 48.5, 460.0),
        spread: [8.0, 6.0, 8.0, 5.0],
        source: "EN 1561:1997, informative annex of physical properties (E 0 of a range; k at 100 degC; c 20..200 degC); alpha between its 10.0 (-100..20) and 11.7 (20..200) (103..118)",
        cutting: cutting(
            1160.0,
            0.26,
            25.0,
            "Tabellenbuch Metall, older editions, specific cutting forces (steels and grey iron after Kienzle/Victor 1957): GJL-250",
        ),
    },
    Entry {
        names: &["EN-GJL-300", "5.1302", "EN-JL1050", "GG-30", "0.6030", "ASTM A48 Class 45", "FC300", "СЧ30"],
        material: material(122.0e9, 0.26, 7250.0, 11.0e-6, 47.5, 460.0),
        spread: [11.0, 6.0, 8.0, 5.0],
        source: "EN 1561:1997, informative annex of physical properties (E 0 of a range; k at 100 degC; c 20..200 degC); alpha between its 10.0 (-100..20) and 11.7 (20..200) (108..137)",
        cutting: cutting(1200.0, 0.28, 20.0, "Walter, machining groups: K4"),
    },
    Entry {
        names: &["EN-GJS-400-15", "5.3106", "EN-JS1030", "GGG-40", "0.7040", "60-40-18", "FCD400", "ВЧ40"],
        material: material(169.0e9, 0.275, 7100.0, 11.2e-6, 36.2, 515.0),
        spread: [3.0, 5.0, 8.0, 6.0],
        source: "EN 1563:1997, informative annex of physical properties (E, nu, density; k at 300 degC; c 20..500 degC); alpha 20..100: QIT, Ductile Iron Data for Design Engineers (12.5 for 20..400 in EN 1563)",
        cutting: cutting(950.0, 0.28, 25.0, "Walter, machining groups: K5"),
    },
    Entry {
        names: &["EN-GJS-600-3", "5.3201", "EN-JS1060", "GGG-60", "0.7060", "80-55-06", "FCD600", "ВЧ60"],
        material: material(174.0e9, 0.275, 7200.0, 10.6e-6, 32.5, 515.0),
        spread: [3.0, 5.0, 8.0, 6.0],
        source: "EN 1563:1997, informative annex of physical properties (E, nu, density; k at 300 degC; c 20..500 degC); alpha 20..100: QIT, Ductile Iron Data for Design Engineers (12.5 for 20..400 in EN 1563)",
        cutting: cutting(
            1350.0,
            0.28,
            15.0,
            "ISCAR, material groups by VDI 3323 (turning catalogue 2017, p. 558; 2022 boring, p. 111): 18",
        ),
    },
    Entry {
        names: &["EN AW-6082", "EN AW-6082 T6", "AlSi1MgMn", "AlMgSi1", "3.2315", "6082", "АД35"],
        material: material(70.0e9, 0.33, 2700.0, 23.4e-6, 175.0, 896.0),
        spread: [2.0, 2.0, 8.0, 2.0],
        source: "Aluminium-Taschenbuch 1, properties of wrought alloys (k 170..220)",
        cutting: cutting(600.0, 0.25, 35.0, "Walter, machining groups: N2"),
    },
    Entry {
        names: &["EN AW-6061", "EN AW-6061 T6", "AlMg1SiCu", "3.3211", "6061", "A6061", "АД33"],
        material: material(68.9e9, 0.33, 2700.0, 23.6e-6, 167.0, 896.0),
        spread: [2.0, 2.0, 4.0, 2.0],
        source: "ASM Handbook vol. 2 (1990), properties of wrought aluminium and aluminium alloys",
        cutting: cutting(600.0, 0.25, 35.0, "Walter, machining groups: N2"),
    },
    Entry {
        names: &["EN AW-7075", "EN AW-7075 T6", "AlZn5,5MgCu", "AlZn5.5MgCu", "3.4365", "7075", "A7075", "В95"],
        material: material(71.7e9, 0.33, 2810.0, 23.4e-6, 130.0, 960.0),
        spread: [2.0, 2.0, 5.0, 4.0],
        source: "ASM Handbook vol. 2 (1990), properties of wrought aluminium and aluminium alloys",
        cutting: cutting(600.0, 0.25, 35.0, "Walter, machining groups: N2"),
    },
    Entry {
        names: &["EN AW-2024", "EN AW-2024 T3", "AlCu4Mg1", "AlCuMg2", "3.1355", "2024", "A2024", "Д16"],
        material: material(73.1e9, 0.33, 2780.0, 23.2e-6, 121.0, 875.0),
        spread: [2.0, 2.0, 5.0, 3.0],
        source: "ASM Handbook vol. 2 (1990), properties of wrought aluminium and aluminium alloys",
        cutting: cutting(600.0, 0.25, 35.0, "Walter, machining groups: N2"),
    },
    Entry {
        names: &["EN AC-44200", "AC-AlSi12(a)", "AlSi12", "G-AlSi12", "3.2581", "A413.0", "АК12"],
        material: material(75.0e9, 0.33, 2650.0, 20.0e-6, 140.0, 900.0),
        spread: [5.0, 3.0, 10.0, 4.0],
        source: "EN 1706, informative annex (k 130..160, alpha 20); A413.0 in ASM Handbook vol. 2: E 71, alpha 20.4, k 121, c 963",
        cutting: cutting(
            700.0,
            0.25,
            15.0,
            "ISCAR, material groups by VDI 3323 (turning catalogue 2017, p. 558; 2022 boring, p. 111): 23",
        ),
    },
    Entry {
        names: &["CuZn39Pb3", "CW614N", "2.0401", "Ms58", "C38500", "C3603", "ЛС59-1"],
        material: material(97.0e9, 0.34, 8470.0, 20.9e-6, 123.0, 377.0),
        spread: [4.0, 3.0, 4.0, 2.0],
        source: "Copper Development Association (US), alloy data C38500 (alpha 20..300 degC)",
        cutting: cutting(550.0, 0.25, 35.0, "Walter, machining groups: N8"),
    },
    Entry {
        names: &["CuSn8", "CW453K", "2.1030", "C52100", "C5210"],
        material: material(110.0e9, 0.34, 8800.0, 18.2e-6, 62.0, 377.0),
        spread: [4.0, 3.0, 8.0, 2.0],
        source: "Copper Development Association (US), alloy data C52100 (alpha 20..300 degC); Deutsches Kupferinstitut CuSn8: E 115, k 67",
        cutting: cutting(
            700.0,
            0.27,
            90.0,
            "ISCAR, material groups by VDI 3323 (turning catalogue 2017, p. 558; 2022 boring, p. 111): 27",
        ),
    },
    Entry {
        names: &["Cu-ETP", "CW004A", "2.0060", "2.0065", "E-Cu58", "C11000", "C1100", "М1"],
        material: material(117.0e9, 0.34, 8930.0, 16.9e-6, 391.0, 385.0),
        spread: [4.0, 2.0, 2.0, 1.0],
        source: "Copper Development Association (US), alloy data C11000",
        cutting: cutting(
            700.0,
            0.27,
            90.0,
            "ISCAR, material groups by VDI 3323 (turning catalogue 2017, p. 558; 2022 boring, p. 111): 28",
        ),
    },
    Entry {
        names: &["TiAl6V4", "Ti-6Al-4V", "Grade 5", "3.7165", "3.7164", "R56400", "ВТ6"],
        material: material(114.0e9, 0.34, 4430.0, 8.6e-6, 6.7, 526.0),
        spread: [3.0, 3.0, 8.0, 5.0],
        source: "Boyer/Welsch/Collings, Materials Properties Handbook: Titanium Alloys (1994); ASM Handbook vol. 2",
        cutting: cutting(1500.0, 0.25, 20.0, "Walter, machining groups: S7"),
    },
    Entry {
        names: &["Inconel 718", "Alloy 718", "NiCr19NbMo", "NiCr19Fe19Nb5Mo3", "2.4668", "N07718"],
        material: material(200.0e9, 0.29, 8190.0, 13.1e-6, 11.4, 435.0),
        spread: [3.0, 3.0, 5.0, 3.0],
        source: "Special Metals SMC-045, INCONEL alloy 718 (E 199.9, nu 0.294 at 21 degC; alpha 21..93 degC; k, c at 21 degC)",
        cutting: cutting(2900.0, 0.25, 15.0, "Walter, machining groups: S4"),
    },
    Entry {
        names: &["granite", "natural granite", "Granit", "гранит"],
        material: material(70.0e9, 0.25, 2900.0, 6.5e-6, 3.0, 800.0),
        spread: [25.0, 15.0, 20.0, 10.0],
        source: "makers of machine beds and of surface plates: black rocks (gabbro, diabase) 70..100 GPa, grey granite 40..60; alpha 4..8; Weck/Brecher, Werkzeugmaschinen 2, materials of beds",
        cutting: None,
    },
    Entry {
        names: &[
            "polymer concrete",
            "mineral casting",
            "epoxy granite",
            "Mineralguss",
            "Polymerbeton",
            "Reaktionsharzbeton",
            "полимербетон",
        ],
        material: material(40.0e9, 0.28, 2400.0, 14.0e-6, 2.0, 1000.0),
        spread: [12.0, 20.0, 35.0, 10.0],
        source: "Weck/Brecher, Werkzeugmaschinen 2, materials of beds; makers of mineral casting give 30..45 GPa, 12..20 1e-6/K, 1.3..3 W/m/K",
        cutting: None,
    },
    Entry {
        names: &["Invar 36", "Invar", "FeNi36", "Ni36", "1.3912", "K93600", "36Н"],
        material: material(141.0e9, 0.29, 8050.0, 1.3e-6, 10.5, 515.0),
        spread: [4.0, 50.0, 8.0, 3.0],
        source: "Carpenter Technology, Invar 36 datasheet (alpha 25..93 degC, annealed)",
        cutting: None,
    },
    Entry {
        names: &["Zerodur"],
        material: material(90.3e9, 0.243, 2530.0, 0.0e-6, 1.46, 800.0),
        spread: [1.0, 0.0, 2.0, 3.0],
        source: "Schott, ZERODUR technical data (CTE 0..50 degC: class 0 0 +- 0.02, class 1 0 +- 0.05, class 2 0 +- 0.10 1e-6/K)",
        cutting: None,
    },
    Entry {
        names: &["hard metal", "WC-10Co", "WC-Co", "cemented carbide", "tungsten carbide", "Hartmetall", "K40", "ВК10"],
        material: material(580.0e9, 0.22, 14500.0, 5.6e-6, 80.0, 210.0),
        spread: [4.0, 8.0, 20.0, 8.0],
        source: "Brookes, World Directory and Handbook of Hardmetals; makers' tables, 10 % Co (6 % Co: E 630, density 14950, alpha 5.0; alpha 20..400 degC)",
        cutting: None,
    },
    Entry {
        names: &["PEEK", "VICTREX 450G", "polyether ether ketone"],
        material: material(4.0e9, 0.38, 1300.0, 50.0e-6, 0.3, 2200.0),
        spread: [10.0, 20.0, 10.0, 5.0],
        source: "Victrex, PEEK 450G datasheet (tensile modulus 23 degC ISO 527; alpha below 143 degC 45 along the flow, 55 mean; k 0.29..0.32)",
        cutting: cutting(150.0, 0.20, 25.0, "Walter, machining groups: O1"),
    },
    Entry {
        names: &["POM-C", "POM", "acetal", "Hostaform"],
        material: material(2.8e9, 0.38, 1410.0, 110.0e-6, 0.31, 1470.0),
        spread: [8.0, 12.0, 15.0, 5.0],
        source: "semi-finished POM-C of Ensinger and Celanese (tensile modulus 2.7..2.8 GPa; alpha 100..120); POM-H: E 3.1",
        cutting: cutting(150.0, 0.20, 25.0, "Walter, machining groups: O1"),
    },
    Entry {
        names: &["POM-H", "Delrin"],
        material: material(3.1e9, 0.38, 1420.0, 110.0e-6, 0.31, 1470.0),
        spread: [8.0, 12.0, 15.0, 5.0],
        source: "datasheets of Delrin 100 and 150 (tensile modulus 3.0..3.2 GPa; alpha 100..120)",
        cutting: None,
    },
];

/// The material of a name, in whatever spelling: capitals, blanks and hyphens do not matter.
pub fn named(name: &str) -> Option<&'static Entry> {
    let name = plain(name);
    ALL.iter().find(|entry| entry.names.iter().any(|own| plain(own) == name))
}

fn plain(name: &str) -> String {
    name.to_lowercase().replace([' ', '-', '_'], "")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_means_one_material_in_any_spelling() {
        let mut all: Vec<String> = ALL.iter().flat_map(|entry| entry.names).map(|name| plain(name)).collect();
        let count = all.len();
        all.sort_unstable();
        all.dedup();
        assert_eq!(all.len(), count, "a name stands twice");
        for (spelled, own) in
            [("42CrMo4", "42CrMo4"), ("1.7225", "42CrMo4"), ("aisi-4140", "42CrMo4"), ("GG 25", "EN-GJL-250")]
        {
            assert_eq!(named(spelled).unwrap().names[0], own, "{spelled}");
        }
    }

    #[test]
    fn properties_are_those_of_solids() {
        for Entry { names, material: own, spread, cutting, .. } in ALL {
            let is_solid = (1e9..1e12).contains(&own.youngs_modulus)
                && (0.2..0.45).contains(&own.poisson_ratio)
                && (1e3..2e4).contains(&own.density)
                && (0.0..2e-4).contains(&own.expansion)
                && (0.1..500.0).contains(&own.conductivity)
                && (100.0..3000.0).contains(&own.specific_heat);
            assert!(is_solid && spread.iter().all(|own| *own < 60.0), "{names:?}: {own:?}");
            if let Some(own) = cutting {
                assert!((1e8..4e9).contains(&own.specific_force) && (0.1..0.4).contains(&own.exponent), "{names:?}");
            }
        }
    }
}
