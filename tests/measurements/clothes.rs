//! The same data in other clothes: files of every process as shops, instruments and laboratories might have exported them.
//!
//! What is put on is chosen by a seeded stream: language and spelling of headings, their row, units, separators, decimal
//! marks, words of labels, line ends, code page, text above and below, columns beside, order of columns, workbooks. A file
//! must be read as the very rows from which it was made, or asked about by one problem with a remedy; what may never be is
//! other rows. Words and factors here are this test's own.

use std::collections::BTreeMap;
use std::io::Write;

use fem::input::Source;
use fem::measure::{Decimal, Measurements, Reading};
use fem::process::Process;
use fem::processes;
use generator::BY_NAME;
use generator::random::Random;

/// Files of each process: a sample here, all of them by `FEM_CLOTHES=200`.
const SAMPLE: usize = 60;

/// Share of files that may be asked about though their headings are words of a language.
const ASKED: f64 = 0.01;

/// Words for columns: German, French, Italian, Spanish, Polish, Czech, Russian, Chinese, Japanese.
pub(super) const WORDS: &[(&str, [&str; 9])] = &[
    (
        "position",
        [
            "Sollposition",
            "Position cible",
            "Posizione",
            "Posición",
            "Pozycja",
            "Poloha",
            "Положение",
            "目标位置",
            "位置",
        ],
    ),
    ("direction", ["Richtung", "Sens", "Direzione", "Sentido", "Kierunek", "Směr", "Направление", "方向", "方向"]),
    ("run", ["Lauf", "Passage", "Corsa", "Pasada", "Przebieg", "Běh", "Прогон", "次数", "次数"]),
    ("part", ["Teil", "Pièce", "Pezzo", "Pieza", "Część", "Díl", "Деталь", "零件", "部品"]),
    ("angle", ["Winkel", "Angle", "Angolo", "Ángulo", "Kąt", "Úhel", "Угол", "角度", "角度"]),
    ("time", ["Zeit", "Temps", "Tempo", "Tiempo", "Czas", "Čas", "Время", "时间", "時間"]),
    (
        "temperature",
        [
            "Temperatur",
            "Température",
            "Temperatura",
            "Temperatura",
            "Temperatura",
            "Teplota",
            "Температура",
            "温度",
            "温度",
        ],
    ),
    ("force", ["Kraft", "Force", "Forza", "Fuerza", "Siła", "Síla", "Сила", "力", "力"]),
    ("feed", ["Vorschub", "Avance", "Avanzamento", "Avance", "Posuw", "Posuv", "Подача", "进给", "送り"]),
    (
        "deviation",
        ["Abweichung", "Écart", "Scostamento", "Desviación", "Odchyłka", "Odchylka", "Отклонение", "偏差", "偏差"],
    ),
    ("diameter", ["Durchmesser", "Diamètre", "Diametro", "Diámetro", "Średnica", "Průměr", "Диаметр", "直径", "直径"]),
];

/// Words for directions.
const WAYS: &[[&str; 2]] = &[
    ["vor", "zurück"],
    ["avant", "arrière"],
    ["avanti", "indietro"],
    ["adelante", "atrás"],
    ["+1", "-1"],
    ["Forward", "Reverse"],
    ["вперёд", "назад"],
    ["正向", "反向"],
];

/// Units in which a column may be written instead, with the factor by which its numbers then grow.
pub(super) const UNITS: &[(&str, &[(&str, f64)])] = &[
    ("um", &[("µm", 1.0), ("mm", 1e-3), ("nm", 1e3), ("мкм", 1.0), ("micron", 1.0)]),
    ("mm", &[("m", 1e-3), ("um", 1e3), ("in", 1.0 / 25.4), ("мм", 1.0), ("cm", 0.1)]),
    ("deg", &[("Grad", 1.0), ("°", 1.0), ("rad", std::f64::consts::PI / 180.0), ("arcmin", 60.0)]),
    ("s", &[("min", 1.0 / 60.0), ("ms", 1e3), ("sec", 1.0)]),
    ("min", &[("s", 60.0), ("h", 1.0 / 60.0)]),
    ("N", &[("kN", 1e-3), ("daN", 0.1), ("Н", 1.0)]),
    ("degC", &[("°C", 1.0), ("℃", 1.0)]),
];

/// A table as the program writes it.
#[derive(Clone)]
pub(super) struct Table {
    /// Name and unit of each column.
    pub(super) columns: Vec<(String, String)>,
    pub(super) rows: Vec<Vec<String>>,
}

impl Table {
    pub(super) fn of(text: &str) -> Self {
        let mut lines = text.lines().filter(|line| !line.starts_with('#') && !line.trim().is_empty());
        let column = |cell: &str| match cell.trim().split_once(" [") {
            Some((name, unit)) => (name.to_string(), unit.trim_end_matches(']').to_string()),
            None => (cell.trim().to_string(), String::new()),
        };
        let columns = lines.next().unwrap().split(',').map(column).collect();
        let row = |line: &str| line.split(',').map(|cell| cell.trim().to_string()).collect();
        Self { columns, rows: lines.map(row).collect() }
    }
}

/// What is put on.
struct Dressed {
    bytes: Vec<u8>,
    ending: &'static str,
    /// What was put on, for whoever looks at a failure.
    worn: String,
    /// Whether it has no headings, or names of its own for them, so that nobody can know what its columns are.
    must_ask: bool,
    /// The answer to what may be asked: headings and what they are.
    answer: Vec<(String, String)>,
}

/// A number with as many digits as it takes.
pub(super) fn scaled(cell: &str, factor: f64) -> String {
    match cell.parse::<f64>() {
        Ok(number) if factor != 1.0 => format!("{}", number * factor),
        _ => cell.to_string(),
    }
}

fn dressed(table: &Table, seed: u64) -> Dressed {
    let random = &mut Random::new("clothes", seed);
    let mut table = table.clone();
    let mut worn = Vec::new();
    let language = random.whole(0, 11);
    let foreign = (language < 9).then_some(language);
    let in_own_words = random.chance(0.06);
    let way = random.pick(WAYS);
    let translates = random.chance(0.7);
    let mut headings = Vec::new();
    let mut answer = Vec::new();
    for i in 0..table.columns.len() {
        let (name, unit) = table.columns[i].clone();
        let own = UNITS.iter().find(|(own, _)| *own == unit).map(|(_, all)| *all);
        let (new, factor) = match own {
            Some(all) if random.chance(0.4) && unit != "degC" => random.pick(all),
            Some(all) if unit == "degC" => random.pick(all),
            _ => ("", 1.0),
        };
        let new = if new.is_empty() { unit.clone() } else { new.to_string() };
        if name == "direction" && translates {
            for row in &mut table.rows {
                let words = match &*row[i] {
                    "+" | "-" => way,
                    // A cam has no sign of its direction.
                    "forward" | "reverse" if !way[0].starts_with('+') => way,
                    "ccw" | "cw" => ["CCW", "Clockwise"],
                    _ => continue,
                };
                row[i] = words[usize::from(matches!(&*row[i], "-" | "reverse" | "cw"))].to_string();
            }
        }
        for row in &mut table.rows {
            row[i] = scaled(&row[i], factor);
        }
        let word = foreign.and_then(|l| WORDS.iter().find(|(own, _)| *own == name).map(|(_, words)| words[l]));
        let spelled = match word {
            Some(word) => word.to_string(),
            None if random.chance(0.3) && !name.starts_with("u") => name.replace('_', " ").to_uppercase(),
            None => name.clone(),
        };
        let spelled = if in_own_words { format!("K{}", i + 1) } else { spelled };
        let said = if new.is_empty() { name.clone() } else { format!("{name} [{new}]") };
        answer.push((spelled.clone(), said));
        headings.push((spelled, new));
    }
    if random.chance(0.4) {
        worn.push("a column of remarks");
        headings.push((["Bemerkung", "Prüfer", "Comment"][random.whole(0, 2)].to_string(), String::new()));
        table.rows.iter_mut().for_each(|row| row.push("Müller".into()));
    }
    let is_unnamed = random.chance(0.05);
    let style = random.whole(0, 4);
    let units_below = style == 4 && headings.iter().any(|(_, unit)| !unit.is_empty());
    let cell = |(name, unit): &(String, String)| match (style, &**unit) {
        (_, "") => name.clone(),
        (4, _) => name.clone(),
        (1, unit) => format!("{name} ({unit})"),
        (2, unit) => format!("{name} / {unit}"),
        (3, unit) => format!("{name} in {unit}"),
        (_, unit) => format!("{name} [{unit}]"),
    };
    let mut rows: Vec<Vec<String>> = Vec::new();
    if !is_unnamed {
        rows.push(headings.iter().map(cell).collect());
        if units_below {
            rows.push(headings.iter().map(|(_, unit)| unit.clone()).collect());
        }
    }
    rows.extend(table.rows.iter().cloned());
    if is_unnamed {
        worn.push("no headings");
        answer.iter_mut().zip(1..).for_each(|(own, number)| own.0 = number.to_string());
    }
    let order_is_kept = random.chance(0.6);
    if !order_is_kept && !is_unnamed {
        worn.push("columns in another order");
        rows.iter_mut().for_each(|row| row.reverse());
    }
    let form = random.whole(0, 5);
    let above = random.chance(0.4);
    let below = random.chance(0.25);
    worn.push(["semicolons", "tabs", "commas", "semicolons and decimal commas", "blanks", "a workbook"][form]);
    let has_blank_cells = rows.iter().flatten().any(|cell| cell.is_empty() || cell.contains(' '));
    let form = if form == 4 && has_blank_cells { 0 } else { form };
    let is_number = |cell: &str| cell.parse::<f64>().is_ok();
    let mut lines: Vec<String> = Vec::new();
    if above {
        worn.push("text above");
        lines.extend(["Messprotokoll Nr. 4711", "Maschine: DMU 50", "Datum: 2026-03-01", ""].map(String::from));
    }
    if form == 5 {
        let above: Vec<Vec<String>> = lines.iter().map(|line| vec![line.clone()]).collect();
        let all: Vec<Vec<String>> = above.into_iter().chain(rows).collect();
        return Dressed {
            bytes: workbook(&all),
            ending: "xlsx",
            worn: format!("{worn:?} style {style}"),
            must_ask: in_own_words || is_unnamed,
            answer,
        };
    }
    let (separator, comma) = [(";", false), ("\t", false), (",", false), (";", true), ("  ", false)][form];
    for row in &rows {
        let cells = row.iter().map(|cell| {
            let cell = if comma && is_number(cell) { cell.replace('.', ",") } else { cell.clone() };
            if cell.contains(separator) || cell.contains('"') { format!("\"{cell}\"") } else { cell }
        });
        lines.push(cells.collect::<Vec<_>>().join(separator));
    }
    if below {
        worn.push("text below");
        lines.extend(["", "Mittelwert: siehe oben", "Ende der Messung"].map(String::from));
    }
    let end = ["\n", "\r\n", "\r"][random.whole(0, 2)];
    worn.push(["LF", "CRLF", "CR"][["\n", "\r\n", "\r"].iter().position(|own| *own == end).unwrap()]);
    let text = lines.iter().map(|line| format!("{line}{end}")).collect::<String>();
    let page = match foreign {
        Some(0..=3) => Some(encoding_rs::WINDOWS_1252),
        Some(4 | 5) => Some(encoding_rs::WINDOWS_1250),
        Some(6) => Some(encoding_rs::WINDOWS_1251),
        Some(7) => Some(encoding_rs::GBK),
        Some(8) => Some(encoding_rs::SHIFT_JIS),
        _ => None,
    };
    let bytes = match (random.whole(0, 3), page) {
        (0, _) => [&[0xEF, 0xBB, 0xBF], text.as_bytes()].concat(),
        (1, _) => [0xFEFF].into_iter().chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect(),
        (2, Some(page)) if !page.encode(&text).2 => {
            worn.push("a code page");
            page.encode(&text).0.into_owned()
        }
        _ => text.into_bytes(),
    };
    Dressed {
        bytes,
        ending: "csv",
        worn: format!("{worn:?} style {style}"),
        must_ask: in_own_words || is_unnamed,
        answer,
    }
}

/// Numbers of a workbook are numbers, whatever is said of its texts.
#[test]
fn a_decimal_comma_is_one_of_texts() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("data.xlsx");
    let process = *processes::ALL.iter().find(|own| own.name() == "stiffness").unwrap();
    let rows = [["force [N]", "displacement [um]"], ["100,0", "4.253"], ["200,125", "8.5"], ["400,0", "17"]];
    std::fs::write(&path, workbook(&rows.map(|row| row.map(String::from).to_vec()))).unwrap();
    let comma = Reading::new(&[], Some(Decimal::Comma)).unwrap();
    let found = Measurements::load_as(&path, process, &comma).unwrap();
    let shown: Vec<i64> = found.observed.iter().map(|si| (si * 1e9).round() as i64).collect();
    assert_eq!(shown, [4253, 8500, 17_000]);
    assert_eq!(found.rows.columns[0].to_vec(), [100.0, 200.125, 400.0]);
    // Of these texts one may be two hundred thousand.
    let error = Measurements::load_as(&path, process, &Reading::default()).unwrap_err().to_string();
    assert!(error.contains("--decimal"), "{error}");
}

/// The least workbook by ECMA-376 that holds these cells, behind a sheet that tells who made it.
fn workbook(rows: &[Vec<String>]) -> Vec<u8> {
    let mut archive = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
    let sheet = |rows: &[Vec<String>]| {
        let mut text = String::from(
            "<?xml version=\"1.0\"?><worksheet xmlns=\"http://schemas.openxmlformats.org/spreadsheetml/2006/main\"><sheetData>",
        );
        for (i, row) in rows.iter().enumerate() {
            text.push_str(&format!("<row r=\"{}\">", i + 1));
            for (j, cell) in row.iter().enumerate().filter(|(_, cell)| !cell.is_empty()) {
                let place = format!("{}{}", (b'A' + j as u8) as char, i + 1);
                let escaped = cell.replace('&', "&amp;").replace('<', "&lt;");
                text.push_str(&match cell.parse::<f64>() {
                    Ok(_) if !cell.starts_with('+') => format!("<c r=\"{place}\"><v>{cell}</v></c>"),
                    _ => format!("<c r=\"{place}\" t=\"inlineStr\"><is><t>{escaped}</t></is></c>"),
                });
            }
            text.push_str("</row>");
        }
        text + "</sheetData></worksheet>"
    };
    let info = [vec!["Prüfer".to_string(), "Müller".to_string()]];
    let office = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
    let package = "http://schemas.openxmlformats.org/package/2006";
    let relation = |id: usize, kind: &str, target: &str| {
        format!("<Relationship Id=\"rId{id}\" Type=\"{office}/{kind}\" Target=\"{target}\"/>")
    };
    let relations = |all: &str| {
        format!("<?xml version=\"1.0\"?><Relationships xmlns=\"{package}/relationships\">{all}</Relationships>")
    };
    let types = format!(
        "<?xml version=\"1.0\"?><Types xmlns=\"{package}/content-types\"><Default Extension=\"rels\" \
         ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/><Default Extension=\"xml\" \
         ContentType=\"application/vnd.openxmlformats-officedocument.spreadsheetml.worksheet+xml\"/><Override \
         PartName=\"/xl/workbook.xml\" \
         ContentType=\"application/vnd.openxmlformats-officedocument.spreadsheetml.sheet.main+xml\"/></Types>"
    );
    let book = format!(
        "<?xml version=\"1.0\"?><workbook xmlns=\"http://schemas.openxmlformats.org/spreadsheetml/2006/main\" \
         xmlns:r=\"{office}\"><sheets><sheet name=\"Info\" sheetId=\"1\" r:id=\"rId1\"/><sheet name=\"Messung\" \
         sheetId=\"2\" r:id=\"rId2\"/></sheets></workbook>"
    );
    let sheets = relation(1, "worksheet", "worksheets/sheet1.xml") + &relation(2, "worksheet", "worksheets/sheet2.xml");
    for (name, text) in [
        ("[Content_Types].xml", types),
        ("_rels/.rels", relations(&relation(1, "officeDocument", "xl/workbook.xml"))),
        ("xl/workbook.xml", book),
        ("xl/_rels/workbook.xml.rels", relations(&sheets)),
        ("xl/worksheets/sheet1.xml", sheet(&info)),
        ("xl/worksheets/sheet2.xml", sheet(rows)),
    ] {
        archive.start_file(name, zip::write::SimpleFileOptions::default()).unwrap();
        archive.write_all(text.as_bytes()).unwrap();
    }
    archive.finish().unwrap().into_inner()
}

/// Whether two readings hold the same rows, but for the round-off of a change of units.
fn are_same(found: &Measurements, own: &Measurements) -> bool {
    let close = |a: f64, b: f64| {
        a.to_bits() == b.to_bits() || (a - b).abs() <= 1e-9 * a.abs().max(b.abs()) || (a.is_nan() && b.is_nan())
    };
    let columns = |m: &Measurements| -> BTreeMap<usize, Vec<f64>> {
        // What a file records beside is not compared.
        (0..m.rows.columns.len() - m.recorded.len()).map(|i| (i, m.rows.columns[i].to_vec())).collect()
    };
    let all_close = |a: &[f64], b: &[f64]| a.len() == b.len() && a.iter().zip(b).all(|(a, b)| close(*a, *b));
    let (a, b) = (columns(found), columns(own));
    let own_u = own.uncertainty.as_ref().map(|u| u.to_vec());
    let found_u = found.uncertainty.as_ref().map(|u| u.to_vec());
    all_close(&found.observed, &own.observed)
        && a.len() == b.len()
        && a.iter().zip(&b).all(|((_, a), (_, b))| all_close(a, b))
        && match (found_u, own_u) {
            (Some(a), Some(b)) => all_close(&a, &b),
            (None, None) => true,
            _ => false,
        }
}

#[test]
fn the_same_data_in_other_clothes_is_the_same_or_asked_about_once() {
    let count = std::env::var("FEM_CLOTHES").ok().and_then(|own| own.parse().ok()).unwrap_or(SAMPLE);
    let folder = tempfile::tempdir().unwrap();
    let (mut wrong, mut asked, mut all, mut questions) = (Vec::new(), Vec::new(), 0, 0);
    for (name, maker) in BY_NAME {
        let process: &dyn Process = *processes::ALL.iter().find(|p| p.name() == name).unwrap();
        for seed in 0..count as u64 {
            let data = maker.nothing(seed % 10).data;
            let said = Reading::default().as_typed(true);
            let own = Measurements::parse_as(Source::new("own.csv", &*data), process, &said).unwrap();
            let Dressed { bytes, ending, worn, must_ask, answer } =
                dressed(&Table::of(&data), 1000 * seed + name.len() as u64);
            let path = folder.path().join(format!("{name}-{seed}.{ending}"));
            std::fs::write(&path, bytes).unwrap();
            all += 1;
            let found = match Measurements::load_as(&path, process, &said) {
                Ok(found) => found,
                Err(error) => {
                    let clear = error.problems.len() == 1 && error.problems[0].help.is_some();
                    let reading = Reading::of_columns(answer, None).unwrap().as_typed(true);
                    let answered = Measurements::load_as(&path, process, &reading);
                    if !must_ask {
                        asked.push(format!("{name} {seed} {worn}: {error}"));
                    }
                    questions += 1;
                    match answered {
                        Ok(found) if clear => found,
                        Ok(_) => {
                            wrong.push(format!("{name} {seed} {worn}: not one question: {error}"));
                            continue;
                        }
                        Err(other) => {
                            wrong.push(format!("{name} {seed} {worn}: {error}; answered: {other}"));
                            continue;
                        }
                    }
                }
            };
            if !are_same(&found, &own) {
                wrong.push(format!("{name} {seed} {worn}: other rows, {} for {}", found.len(), own.len()));
            }
        }
    }
    if std::env::var("FEM_CLOTHES").is_ok() {
        let (asked, wrong) = (asked.len(), wrong.len());
        println!(
            "{all} files, {questions} asked about, {asked} of them though their headings are words, {wrong} wrong"
        );
    }
    assert!(wrong.is_empty(), "{} of {all} wrong:\n{}", wrong.len(), wrong.join("\n"));
    let most = ASKED * all as f64;
    assert!(asked.len() as f64 <= most, "{} of {all} asked about:\n{}", asked.len(), asked.join("\n"));
}
