//! Headings in other languages: German, French, Italian, Spanish, Polish, Czech, Russian, Chinese, Japanese.

use std::collections::BTreeSet;

use super::vocabulary::Vocabulary;

/// What a heading may be called, by the columns that it then is: the first of them that a process knows.
/// Small letters, underscores for blanks, Latin letters without their accents.
const SAME: &[(&[&str], &[&str])] = &[
    (
        &["diameter_error"],
        &[
            "durchmesserfehler",
            "durchmesserabweichung",
            "erreur_de_diametre",
            "ecart_de_diametre",
            "errore_di_diametro",
            "scostamento_del_diametro",
            "error_de_diametro",
            "desviacion_del_diametro",
            "blad_srednicy",
            "odchylka_srednicy",
            "chyba_prumeru",
            "odchylka_prumeru",
            "погрешность_диаметра",
            "отклонение_диаметра",
            "直径误差",
            "直径偏差",
            "直径誤差",
        ],
    ),
    (
        &["RONt"],
        &[
            "ront",
            "roundness",
            "out_of_roundness",
            "roundness_deviation",
            "rundheit",
            "rundheitsabweichung",
            "unrundheit",
            "circularite",
            "ecart_de_circularite",
            "rotondita",
            "errore_di_rotondita",
            "circolarita",
            "redondez",
            "circularidad",
            "error_de_redondez",
            "okraglosc",
            "odchylka_okraglosci",
            "kruhovitost",
            "odchylka_kruhovitosti",
            "круглость",
            "отклонение_от_круглости",
            "некруглость",
            "圆度",
            "圆度误差",
            "真円度",
        ],
    ),
    (
        &["diameter"],
        &[
            "durchmesser",
            // Ist-Ø, without the stroke.
            "ist-o",
            "ist_o",
            "istdurchmesser",
            "ist-durchmesser",
            "ist_durchmesser",
            "diametre",
            "diametro",
            "srednica",
            "prumer",
            "диаметр",
            "直径",
        ],
    ),
    (
        &["position", "x"],
        &[
            "position",
            "ort",
            "stelle",
            "messstelle",
            "lage",
            "abscisse",
            "location",
            "abstand",
            "abstand_vom_spindelstock",
            "posizione",
            "posicion",
            "pozycja",
            "polozenie",
            "poloha",
            "pozice",
            "положение",
            "позиция",
            "位置",
            "测量位置",
            "測定位置",
            "soll",
            "sollposition",
            "zielposition",
            "position_commandee",
            "position_cible",
            "position_theorique",
            "consigne",
            "posizione_comandata",
            "posizione_nominale",
            "posicion_nominal",
            "posicion_programada",
            "pozycja_zadana",
            "zadana_poloha",
            "заданное_положение",
            "заданная_позиция",
            "目标位置",
            "指令位置",
            "目標位置",
        ],
    ),
    (
        &["actual_position"],
        &[
            "ist",
            "istposition",
            "position_reelle",
            "posizione_reale",
            "posicion_real",
            "skutecna_poloha",
            "pozycja_rzeczywista",
            "实际位置",
            "実位置",
        ],
    ),
    (
        &["part"],
        &[
            "teil",
            "teil_nr",
            "teil_nr.",
            "teilenummer",
            "teilnummer",
            "bauteil",
            "part_no",
            "part_no.",
            "part_nr",
            "part_number",
            "part_#",
            "workpiece",
            "numer_czesci",
            "nr_czesci",
            "cislo_dilu",
            "numero_de_piece",
            "numero_pezzo",
            "номер_детали",
            "零件号",
            "工件号",
            "部品番号",
            "werkstuck",
            "piece",
            "pezzo",
            "pieza",
            "czesc",
            "kus",
            "dil",
            "деталь",
            "零件",
            "工件",
            "部品",
            "ワーク",
        ],
    ),
    (
        &["radial_force"],
        &[
            "radialkraft",
            "force_radiale",
            "forza_radiale",
            "fuerza_radial",
            "sila_promieniowa",
            "radialni_sila",
            "радиальная_сила",
            "径向力",
        ],
    ),
    (&["force", "radial_force"], &["kraft", "forza", "fuerza", "sila", "сила", "力", "荷重"]),
    (
        &["torque"],
        &[
            "drehmoment",
            "moment",
            "lastmoment",
            "couple",
            "coppia",
            "momento_torcente",
            "par",
            "par_de_torsion",
            "moment_obrotowy",
            "kroutici_moment",
            "момент",
            "крутящий_момент",
            "扭矩",
            "转矩",
            "トルク",
        ],
    ),
    (
        &["clamp_force", "jaw_force"],
        &[
            "spannkraft",
            "force_de_serrage",
            "forza_di_serraggio",
            "fuerza_de_sujecion",
            "sila_mocowania",
            "upinaci_sila",
            "сила_зажима",
            "夹紧力",
            "クランプ力",
        ],
    ),
    (
        &["depth"],
        &[
            "schnitttiefe",
            "zustellung",
            "profondeur_de_passe",
            "profondita_di_passata",
            "profundidad_de_corte",
            "glebokosc_skrawania",
            "hloubka_rezu",
            "глубина_резания",
            "切深",
            "切削深度",
            "切込み",
        ],
    ),
    (&["feed"], &["vorschub", "avance", "avanzamento", "posuw", "posuv", "подача", "进给", "进给量", "送り"]),
    (
        &["spindle_speed", "cam_speed"],
        &[
            "drehzahl",
            "spindeldrehzahl",
            "vitesse_de_broche",
            "velocita_mandrino",
            "velocidad_del_husillo",
            "obroty",
            "otacky",
            "частота_вращения",
            "обороты",
            "转速",
            "主轴转速",
            "回転数",
            "主軸回転数",
        ],
    ),
    (&["time"], &["zeit", "temps", "tempo", "tiempo", "czas", "cas", "время", "时间", "時間"]),
    (&["angle"], &["winkel", "angolo", "angulo", "kat", "uhel", "угол", "角度"]),
    (
        &["displacement"],
        &[
            "verschiebung",
            "auslenkung",
            "weg",
            "deplacement",
            "spostamento",
            "desplazamiento",
            "przemieszczenie",
            "vychylka",
            "posunuti",
            "перемещение",
            "位移",
            "変位",
        ],
    ),
    (
        &["height_error"],
        &[
            "hohenfehler",
            "hohenabweichung",
            "erreur_de_hauteur",
            "ecart_de_hauteur",
            "errore_di_altezza",
            "error_de_altura",
            "blad_wysokosci",
            "chyba_vysky",
            "погрешность_высоты",
            "高度误差",
            "高さ誤差",
        ],
    ),
    (
        &["deviation", "diameter_error", "height_error"],
        &[
            "deviation",
            "abweichung",
            "fehler",
            "ecart",
            "erreur",
            "scostamento",
            "errore",
            "desviacion",
            "odchylka",
            "chyba",
            "blad",
            "отклонение",
            "погрешность",
            "偏差",
            "误差",
            "誤差",
        ],
    ),
    (
        &["elongation"],
        &[
            "elongation",
            "verlangerung",
            "langenanderung",
            "ausdehnung",
            "allongement",
            "dilatation",
            "allungamento",
            "alargamiento",
            "wydluzenie",
            "prodlouzeni",
            "удлинение",
            "伸长",
            "伸长量",
            "伸び",
        ],
    ),
    (&["temperature"], &["temperature", "temperatur", "temperatura", "teplota", "температура", "温度"]),
    (
        &["direction"],
        &["richtung", "sens", "direzione", "senso", "direccion", "sentido", "kierunek", "smer", "направление", "方向"],
    ),
    (&["branch"], &["ast", "belastungsrichtung"]),
    (&["run"], &["lauf", "durchlauf", "messlauf", "passage", "corsa", "pasada", "przebieg", "beh", "прогон", "次数"]),
    (&["state"], &["zustand", "etat", "stato", "estado", "stan", "stav", "состояние", "状态", "状態"]),
    (
        &["u"],
        &[
            "standardunsicherheit",
            "incertitude_type",
            "incertezza_tipo",
            "incertidumbre_tipica",
            "niepewnosc_standardowa",
            "standardni_nejistota",
            "стандартная_неопределенность",
            "标准不确定度",
            "標準不確かさ",
        ],
    ),
];

/// Letters with accents and those that they are without.
const ACCENTS: &[(&str, char)] = &[
    ("àáâãäåą", 'a'),
    ("çćč", 'c'),
    ("ďđ", 'd'),
    ("èéêëęě", 'e'),
    ("ìíîï", 'i'),
    ("łľĺ", 'l'),
    ("ñńň", 'n'),
    ("òóôõöø", 'o'),
    ("řŕ", 'r'),
    ("śš", 's'),
    ("ťţ", 't'),
    ("ùúûüůű", 'u'),
    ("ýÿ", 'y'),
    ("źżž", 'z'),
    ("ё", 'е'),
];

/// Small letters without their accents.
pub fn folded(word: &str) -> String {
    let letter = |c: char| ACCENTS.iter().find(|(all, _)| all.contains(c)).map_or(c, |(_, plain)| *plain);
    word.to_lowercase().replace('ß', "ss").chars().map(letter).collect()
}

/// Number of different words in a text that mean columns in some language, and of signs of units.
pub fn count(text: &str) -> usize {
    let signs = ['µ', '°'].into_iter().filter(|sign| text.contains(*sign)).count();
    let is_between = |c: char| !(c.is_alphabetic() || c == '_' || c == ' ');
    let text = folded(text);
    let name = |cell: &str| cell.split(" in ").next().unwrap_or_default().trim().replace(' ', "_");
    let cells: BTreeSet<String> = text.split(is_between).map(name).collect();
    signs + cells.iter().filter(|cell| SAME.iter().any(|(_, words)| words.contains(&&***cell))).count()
}

/// The column of a process that a word of another language means; `None` where the process knows none of those.
pub fn meant(word: &str, vocabulary: Vocabulary) -> Option<&'static str> {
    let word = folded(word);
    let mut all = SAME.iter().filter(|(_, words)| words.contains(&&*word)).flat_map(|(columns, _)| *columns);
    all.find(|column| vocabulary.knows(column)).copied()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::processes;

    #[test]
    fn a_word_means_one_column_of_a_process_or_none() {
        for process in processes::ALL {
            let vocabulary = Vocabulary::of(*process);
            for (columns, words) in SAME {
                let known: Vec<&&str> = columns.iter().filter(|own| vocabulary.knows(own)).collect();
                for word in *words {
                    assert_eq!(folded(word), *word, "written without accents");
                    assert_eq!(meant(word, vocabulary), known.first().map(|own| **own), "{word} of {}", process.name());
                    assert_eq!(SAME.iter().filter(|(_, all)| all.contains(word)).count(), 1, "{word} stands twice");
                }
            }
        }
    }
}
