//! Data of a whole file: VTK's `FieldData`, which vtkio does not write.

use std::fmt::Write;

/// An entry of the field data.
#[derive(Clone, Debug, PartialEq)]
pub enum Datum {
    /// A text.
    Text(&'static str, String),
    /// A number.
    Number(&'static str, f64),
}

/// Puts the data into a file of VTK's XML, before its first piece.
pub fn put(bytes: Vec<u8>, data: &[Datum]) -> Vec<u8> {
    let place = [&b"<UnstructuredGrid>"[..], b"<PolyData>"]
        .into_iter()
        .find_map(|tag| bytes.windows(tag.len()).take(1024).position(|w| w == tag).map(|at| at + tag.len()));
    let (Some(place), false) = (place, data.is_empty()) else { return bytes };
    [&bytes[..place], element(data).as_bytes(), &bytes[place..]].concat()
}

fn element(data: &[Datum]) -> String {
    let mut text = String::from("<FieldData>");
    // Writing to a String does not fail, here and below.
    for datum in data {
        match datum {
            Datum::Text(name, value) => {
                let _ =
                    write!(text, "<DataArray type=\"String\" Name=\"{name}\" NumberOfTuples=\"1\" format=\"ascii\">");
                // VTK writes a string as the numbers of its bytes, with a zero behind them.
                for byte in value.bytes().filter(|byte| *byte != 0) {
                    let _ = write!(text, "{byte} ");
                }
                text.push_str("0</DataArray>");
            }
            Datum::Number(name, value) => {
                let _ = write!(
                    text,
                    "<DataArray type=\"Float64\" Name=\"{name}\" NumberOfTuples=\"1\" format=\"ascii\">{value:?}</DataArray>"
                );
            }
        }
    }
    text.push_str("</FieldData>");
    text
}
