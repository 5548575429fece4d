//! Numbers as accounts and protractors write them: the minus behind them (`5,1-`), and angles in degrees, minutes and seconds
//! (`12°30'15"`).

use super::heading::Heading;
use super::records::Records;

/// Writes numbers of the `numeric` columns whose minus stands behind them with the minus in front.
pub fn minus_in_front(records: &mut Records, numeric: &[bool], text: &str, told: &mut Vec<String>) {
    // Hardly any file has them, and all would be read once more.
    if !["-;", "-,", "-\t", "-\"", "-\n", "-\r"].iter().any(|end| text.contains(end)) && !text.ends_with('-') {
        return;
    }
    let columns: Vec<usize> = (0..numeric.len()).filter(|column| numeric[*column]).collect();
    let mut first = None;
    records.rewrite(&columns, |_, cells, column| {
        let own = cells[column].strip_suffix('-').map(str::trim_end).filter(|own| is_bare(own))?;
        first.get_or_insert_with(|| cells[column].to_string());
        Some(format!("-{own}"))
    });
    told.extend(first.map(|cell| format!("the minus of `{cell}` and its like stands behind")));
}

/// Whether a text is digits with marks alone.
fn is_bare(text: &str) -> bool {
    text.starts_with(|c: char| c.is_ascii_digit()) && text.chars().all(|c| c.is_ascii_digit() || matches!(c, '.' | ','))
}

/// Writes columns of angles in degrees, minutes and seconds as degrees.
pub fn degrees(headings: &mut [Heading], records: &mut Records, numeric: &[bool], told: &mut Vec<String>) {
    let is_open = |heading: &Heading| matches!(&*heading.unit, "" | "deg" | "°");
    let open: Vec<usize> =
        (0..numeric.len()).filter(|column| numeric[*column] && is_open(&headings[*column])).collect();
    let first = |records: &Records, column: usize| records.get(0).get(column).map(str::to_string).unwrap_or_default();
    if records.is_empty() || !open.iter().any(|column| is_parted(&first(records, *column))) {
        return;
    }
    let mut columns = open;
    columns.retain(|column| is_parted(&first(records, *column)));
    // What does not follow stays as it is, and is refused as no number.
    records.rewrite(&columns, |_, cells, column| angle(&cells[column]).map(|own| own.to_string()));
    for column in columns {
        let heading = &mut headings[column];
        heading.unit = "deg".into();
        told.push(format!("`{}` in degrees, minutes and seconds", heading.name));
    }
}

/// Whether a cell has degrees and parts of them.
fn is_parted(cell: &str) -> bool {
    cell.contains('°') && angle(cell).is_some()
}

/// Degrees of `-12°30'15.5"`; minutes and seconds may be left out. `None` of anything else.
fn angle(cell: &str) -> Option<f64> {
    let (sign, rest) = match cell.trim().strip_prefix(['-', '−']) {
        Some(rest) => (-1.0, rest),
        None => (1.0, cell.trim().trim_start_matches('+')),
    };
    let number = |text: &str| {
        let text = text.trim();
        is_bare(text).then(|| text.replace(',', ".").parse::<f64>().ok()).flatten()
    };
    let (degrees, rest) = rest.split_once('°')?;
    let (minutes, rest) = rest.split_once(['\'', '′', '’']).map_or((None, rest), |(own, rest)| (Some(own), rest));
    // Two strokes may stand for the seconds.
    let seconds = rest.trim().trim_end_matches(['"', '″', '”', '\'', '′']).trim();
    let below = |text: Option<&str>| match text.filter(|own| !own.is_empty()) {
        None => Some(0.0),
        Some(own) => number(own).filter(|own| *own < 60.0),
    };
    Some(sign * (number(degrees)? + below(minutes)? / 60.0 + below(Some(seconds))? / 3600.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn degrees_have_minutes_and_seconds() {
        assert_eq!(
            ["0°0'0\"", "30°15'36\"", "-12° 30′", "90°", "1°0'1,8\""].map(angle),
            [Some(0.0), Some(30.26), Some(-12.5), Some(90.0), Some(1.0005)]
        );
        for wrong in ["30", "30°60'", "a°1'", "30°1'x", "°", "1°-2'"] {
            assert_eq!(angle(wrong), None, "{wrong}");
        }
    }
}
