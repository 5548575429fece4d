//! Words of label columns as people and instruments write them.

use super::lexicon::folded;
use crate::process::Words;

/// Words that mean the same, the program's own first, others in small letters without accents.
const SAME: &[&[&str]] = &[
    &[
        "+",
        "+1",
        "1",
        "forward",
        "forwards",
        "fwd",
        "up",
        "pos",
        "positive",
        "plus",
        "↑",
        "→",
        "pos.",
        "positiv",
        "positivo",
        "positif",
        "+x",
        "+y",
        "+z",
        "hin",
        "vorlauf",
        "vor",
        "vorwarts",
        "avant",
        "avanti",
        "adelante",
        "naprzod",
        "vpred",
        "вперед",
        "正",
        "正向",
        "前",
    ],
    &[
        "-",
        "-1",
        "−",
        "−1",
        "–",
        "backward",
        "backwards",
        "bwd",
        "reverse",
        "down",
        "neg",
        "negative",
        "minus",
        "↓",
        "←",
        "neg.",
        "negativ",
        "negativo",
        "negatif",
        "-x",
        "-y",
        "-z",
        "her",
        "rucklauf",
        "zuruck",
        "ruckwarts",
        "arriere",
        "indietro",
        "atras",
        "wstecz",
        "vzad",
        "zpet",
        "назад",
        "负",
        "反向",
        "後",
    ],
    &["forward", "forwards", "fwd", "vor", "vorwarts", "avant", "avanti", "adelante", "вперед", "正向"],
    &[
        "reverse",
        "reversed",
        "backward",
        "backwards",
        "bwd",
        "zuruck",
        "ruckwarts",
        "arriere",
        "indietro",
        "atras",
        "назад",
        "反向",
    ],
    &[
        "ccw",
        "counter-clockwise",
        "counterclockwise",
        "anticlockwise",
        "anti-clockwise",
        "gegen den uhrzeigersinn",
        "gegenuhrzeigersinn",
        "antihoraire",
        "antiorario",
        "antihorario",
        "против часовой стрелки",
        "逆时针",
        "反時計回り",
    ],
    &[
        "cw",
        "clockwise",
        "im uhrzeigersinn",
        "uhrzeigersinn",
        "horaire",
        "orario",
        "horario",
        "по часовой стрелке",
        "顺时针",
        "時計回り",
    ],
    &["load", "loading", "belastung", "charge", "carico", "carga", "нагрузка", "加载", "負荷"],
    &["unload", "unloading", "entlastung", "decharge", "scarico", "descarga", "разгрузка", "卸载", "除荷"],
    &["released", "gelost", "entspannt", "libere", "rilasciato", "liberado", "освобождено", "松开"],
    &["clamped", "gespannt", "serre", "serrato", "sujeto", "зажато", "夹紧"],
];

/// Whether a cell may be the word of a label.
pub fn is_label(cell: &str) -> bool {
    let cell = folded(cell);
    SAME.iter().any(|group| group.contains(&&*cell))
}

/// The word of a list that a cell means; capitals do not matter.
pub fn meant<'w>(cell: &str, words: &'w Words) -> Option<&'w str> {
    let (own, cell) = (cell.to_lowercase(), folded(cell));
    let means = |word: &&str| {
        let same = SAME.iter().find(|group| group[0] == *word);
        *word == own || same.is_some_and(|group| group.contains(&&*cell))
    };
    words.iter().find(means)
}
