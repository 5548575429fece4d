//! Rows below the readings that sum them up: mean, standard deviation, largest and smallest.

use super::layout::is_value;
use super::lexicon::folded;
use super::records::Records;

/// What such a row begins with, in small letters without accents.
const SUMS: &[&str] = &[
    "mean",
    "average",
    "avg",
    "std",
    "stdev",
    "std dev",
    "std.dev.",
    "std. dev.",
    "standard deviation",
    "sigma",
    "max",
    "min",
    "maximum",
    "minimum",
    "range",
    "median",
    "count",
    "sum",
    "total",
    "cp",
    "cpk",
    "usl",
    "lsl",
    "x-bar",
    "xbar",
    "mittelwert",
    "mittel",
    "durchschnitt",
    "stabw",
    "standardabweichung",
    "streuung",
    "spannweite",
    "anzahl",
    "summe",
    "moyenne",
    "ecart type",
    "ecart-type",
    "etendue",
    "media",
    "deviazione standard",
    "desviacion estandar",
    "rango",
    "srednia",
    "odchylenie standardowe",
    "rozstep",
    "prumer",
    "smerodatna odchylka",
    "среднее",
    "ско",
    "размах",
    "平均",
    "平均值",
    "标准差",
    "標準偏差",
    "最大",
    "最小",
    "最大值",
    "最小值",
    "范围",
];

/// Most rows of sums.
const MOST: usize = 12;
/// Rows from which a column that is filled in all of them is one that every reading fills.
const MANY: usize = 5;

/// Leaves out the last rows where they begin with a word for a sum of those above, or where the first column is blank that every
/// reading fills; what is told of it.
pub fn left_out(records: &mut Records) -> Option<String> {
    let count = records.len();
    let mut reader = records.reader();
    let mut rows: Vec<Vec<String>> = Vec::new();
    for record in count.saturating_sub(MOST + 1)..count {
        rows.push(reader.read(record).iter().map(str::to_string).collect());
    }
    let is_sum = |cells: &Vec<String>| {
        let first = cells.iter().find(|cell| !cell.is_empty()).map(|cell| folded(cell));
        first.is_some_and(|own| !is_value(&own) && SUMS.contains(&own.trim_end_matches([':', '=', ' '])))
    };
    let summed = rows.iter().rev().take_while(|cells| is_sum(cells)).count();
    let above = count - summed;
    let blank = if above > MANY { blank_below(records, above) } else { 0 };
    let left_out = summed + blank;
    if left_out == 0 || left_out >= count || left_out > MOST {
        return None;
    }
    let line = records.line(count - left_out);
    let what = rows[rows.len() - left_out].iter().find(|cell| !cell.is_empty()).cloned().unwrap_or_default();
    records.keep_first(count - left_out);
    let rows = if left_out == 1 { "row".to_string() } else { format!("{left_out} rows") };
    if blank > 0 && summed == 0 {
        return Some(format!(
            "the last {rows} left out, from line {line} on: their first cell is empty, which all others fill, as where the \
             readings are summed up; fill it where they are readings"
        ));
    }
    Some(format!("the last {rows} left out, from line {line} on (`{what}`): they sum up the readings"))
}

/// Number of the last of some records that leave the first column blank, which all before them fill.
fn blank_below(records: &Records, count: usize) -> usize {
    let mut reader = records.reader();
    // What tells readings apart stands in front.
    if !reader.read(count - 1)[0].is_empty() {
        return 0;
    }
    let first = reader.read(0).clone();
    if first[0].is_empty() {
        return 0;
    }
    let ends = (1..count).find(|record| reader.read(*record)[0].is_empty()).unwrap_or(count);
    // A blank among others that are filled again is a name that was written once for several.
    let is_all = (ends..count).all(|record| reader.read(record)[0].is_empty());
    if is_all && ends >= MANY && count - ends <= MOST.min(ends / 2) { count - ends } else { 0 }
}
