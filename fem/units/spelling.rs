//! Units as shops spell them, in words and in other scripts, and what each is here.

/// Names of units, and how they are written here.
const SPELLED: &[(&[&str], &str)] = &[
    (&["Grad", "degree", "degrees", "DEG", "Deg", "º", "˚", "градус", "град", "度"], "deg"),
    (&["′", "arc-min", "Bogenminute", "Bogenminuten", "угл.мин"], "arcmin"),
    (&["″", "Bogensekunde", "Bogensekunden", "arcseconds", "arc-sec", "arcsecs", "угл.с", "角秒"], "arcsec"),
    (&["U", "Umdr", "tr", "об", "r", "转", "回転"], "rev"),
    (&["мкм", "micron", "microns", "Mikron", "Mikrometer", "micrometer", "micrometre", "微米", "μ", "ミクロン"], "um"),
    (&["мм", "MM", "Millimeter", "millimeter", "millimetre", "毫米", "ミリ"], "mm"),
    (&["см"], "cm"),
    (&["м", "米"], "m"),
    (&["inch", "inches", "Inch", "Inches", "INCH", "IN", "in.", "Zoll", "pouce", "дюйм"], "in"),
    (&["mil", "mils", "thou"], "in/1000"),
    (&["RPM", "Rpm", "Upm"], "rpm"),
    (&["Rad"], "rad"),
    (&["kp"], "kgf"),
    (&["Newton", "Н", "牛"], "N"),
    (&["кН", "KN"], "kN"),
    (&["Nm", "Н·м"], "N*m"),
    (&["Nmm"], "N*mm"),
    (&["Ncm"], "N*cm"),
    (&["mNm"], "mN*m"),
    (&["kNm"], "kN*m"),
    (&["sec", "Sek", "Sekunde", "Sekunden", "seconds", "с", "сек", "秒"], "s"),
    (&["Min", "Minute", "Minuten", "minutes", "мин", "分"], "min"),
    (&["Std", "ч", "小时", "時間"], "h"),
];

/// Names that shops read in two ways, and what to write.
const DOUBTFUL: &[(&str, &str)] = &[
    ("grad", "some mean a degree by it, others a gon: write deg or gon"),
    ("lb", "a force is in lbf, a mass in kg, of which a pound has 0.45359237"),
    ("lbs", "a force is in lbf, a mass in kg, of which a pound has 0.45359237"),
    ("C", "temperatures are in degC or K"),
    ("F", "temperatures are in degC or K"),
    ("degF", "temperatures are in degC or K"),
    ("°F", "temperatures are in degC or K"),
    ("Celsius", "temperatures are in degC or K"),
    ("celsius", "temperatures are in degC or K"),
];

/// Marks between the names of a unit.
pub const MARKS: [char; 8] = ['*', '·', '/', '^', '(', ')', '²', '³'];

/// The name here of a unit that a shop spells otherwise.
pub fn meant(name: &str) -> Option<&'static str> {
    SPELLED.iter().find(|(words, _)| words.contains(&name)).map(|(_, own)| *own)
}

/// What to write in the place of a name that could mean two units.
pub fn doubt(name: &str) -> Option<&'static str> {
    DOUBTFUL.iter().find(|(word, _)| *word == name).map(|(_, help)| *help)
}

/// A unit with its names as they are written here.
pub fn plain(unit: &str) -> String {
    let mut written = String::new();
    for piece in unit.split_inclusive(MARKS) {
        let name = piece.trim_end_matches(MARKS);
        written.push_str(meant(name.trim()).unwrap_or(name));
        written.push_str(&piece[name.len()..]);
    }
    written
}

#[cfg(test)]
mod tests {
    use super::super::Unit;
    use super::*;

    #[test]
    fn a_spelling_is_a_unit_and_no_other() {
        for (words, own) in SPELLED {
            let unit = Unit::parse(own).unwrap();
            for word in *words {
                assert_eq!(Unit::parse(word), Ok(unit), "{word}");
                assert_eq!(SPELLED.iter().filter(|(all, _)| all.contains(word)).count(), 1, "{word} stands twice");
            }
        }
    }

    #[test]
    fn names_are_exchanged_and_marks_stay() {
        for (spelled, own) in
            [("мкм/м", "um/m"), ("U/min", "rev/min"), ("Nm/Grad", "N*m/deg"), ("W/(m²·K)", "W/(m²·K)")]
        {
            assert_eq!(plain(spelled), own);
        }
    }

    #[test]
    fn what_could_mean_two_units_is_asked() {
        for (word, help) in DOUBTFUL {
            assert_eq!(Unit::parse(word).unwrap_err().hint.as_deref(), Some(*help), "{word}");
        }
    }
}
