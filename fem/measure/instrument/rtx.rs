//! Dynamic captures of Renishaw laser interferometers, `.rtx` [the public converter rtx2csv, by which this is written; no
//! description of Renishaw's own was found].
//!
//! A header of lines `Key: value` that begins with `HEADER::` and ends with `Data:`, then 8-byte floating point numbers,
//! least byte first, then `EOF::`; lines end with CR and LF. "Actual sample rate" is in samples per second. The unit of
//! the numbers stands nowhere: the user says it.

use super::lines::{Instrument, lines, sheet};
use crate::input::{Problem, Source};
use crate::measure::records::Records;
use crate::measure::sheet::Sheet;

pub const RTX: Instrument = Instrument { is_one: |text| text.starts_with(HEADER), read };

const HEADER: &str = "HEADER::";
const DATA: &[u8] = b"Data:\r\n";
const END: &[u8] = b"EOF::\r\n";

/// Key of the sample rate.
const RATE: &str = "Actual sample rate";

/// Most samples that are read.
const MOST_SAMPLES: usize = 5_000_000;

/// Largest header, bytes.
const LARGEST_HEADER: usize = 100_000;

/// Makes a text of the bytes of a capture, its numbers as decimals in lines of their own; `None` where it is none.
///
/// # Errors
/// It is one, and is cut off or too long.
pub fn text(bytes: &[u8]) -> Option<Result<String, Problem>> {
    bytes.starts_with(HEADER.as_bytes()).then(|| decoded(bytes))
}

fn decoded(bytes: &[u8]) -> Result<String, Problem> {
    let cut = |message: &str| Problem::new(message).help("has the file been cut off? export it again");
    let head = &bytes[..bytes.len().min(LARGEST_HEADER)];
    let begin = head.windows(DATA.len()).position(|window| window == DATA).map(|at| at + DATA.len());
    let begin = begin.ok_or_else(|| cut("the header of the capture has no line `Data:` at its end"))?;
    let numbers = bytes[begin..].strip_suffix(END).ok_or_else(|| cut("the capture does not end with `EOF::`"))?;
    let (samples, rest) = numbers.as_chunks::<8>();
    if !rest.is_empty() {
        return Err(cut("the samples of the capture are no whole number of 8 bytes"));
    }
    if samples.len() > MOST_SAMPLES {
        let message = format!("the capture has {} samples; at most {MOST_SAMPLES} are read", samples.len());
        return Err(Problem::new(message).help("export a shorter capture, or at a lower rate"));
    }
    let mut text = String::from_utf8_lossy(&bytes[..begin]).into_owned();
    for sample in samples {
        text.push_str(&format!("{}\n", f64::from_le_bytes(*sample)));
    }
    Ok(text)
}

fn read(source: &Source) -> Result<Sheet, Problem> {
    let mut all = lines(&source.text);
    let mut rate = None;
    let mut keys = 0;
    let mut first = 0..0;
    for line in all.by_ref().take_while(|line| line.says != "Data:") {
        if first.is_empty() {
            first = line.place.clone();
        }
        let Some((key, value)) = line.says.rsplit("::").next().and_then(|says| says.split_once(": ")) else { continue };
        keys += usize::from(key.trim() != RATE);
        if key.trim() == RATE {
            let value: Option<f64> = value.trim().parse().ok();
            let value = value.filter(|rate| rate.is_finite() && *rate > 0.0);
            let problem = || line.problem(format!("`{RATE}` is no number above zero"), "export the capture again");
            rate = Some(value.ok_or_else(problem)?);
        }
    }
    let Some(rate) = rate else {
        let problem = Problem::new(format!("the header of the capture has no `{RATE}`"));
        return Err(problem.help("export the capture again").at(Some(first)));
    };
    let mut records = Records::written(source.text.clone(), 2);
    for (line, number) in all.filter(|line| !line.says.is_empty()).zip(0_u32..) {
        if !line.says.parse().is_ok_and(f64::is_finite) {
            let message = format!("sample {} is {}, and no number", number + 1, line.says);
            return Err(line.problem(message, "was the beam broken? leave such a capture out"));
        }
        let time = f64::from(number) / rate;
        records.push_written(line.place.start, [&*time.to_string(), line.says]);
    }
    let samples = records.len();
    let told = vec![
        format!("{samples} samples at {rate} a second from a capture as `time` and `value`"),
        "its unit stands nowhere, and is said by --columns 'value=NAME [UNIT]'".into(),
        format!("keys of its header beside the rate, which are left: {keys}"),
    ];
    Ok(sheet(vec!["time [s]".into(), "value".into()], first, records, told))
}
