//! Writes the `.pvd` file, which gives every `.vtu` its time.

use std::fmt::Write;

use super::VtkError;

/// The text of a `.pvd` file over `frames`: time, s, and the file name of the `.vtu`, relative
/// to the `.pvd`, with `/` between folders.
///
/// # Errors
/// Times must be finite and increase: frames of equal time would be shown on top of each other.
/// File names must not be empty or hold control characters, which XML cannot carry.
pub fn pvd(frames: &[(f64, String)]) -> Result<String, VtkError> {
    let mut text = String::with_capacity(128 + 96 * frames.len());
    text.push_str("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    text.push_str("<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n");
    text.push_str("  <Collection>\n");
    let mut before = f64::NEG_INFINITY;
    for (frame, (time, file)) in frames.iter().enumerate() {
        if !time.is_finite() || *time <= before {
            return Err(VtkError::Time { frame, file: file.clone(), time: *time });
        }
        before = *time;
        if file.is_empty() || file.chars().any(char::is_control) {
            return Err(VtkError::FileName { frame, file: file.clone() });
        }
        text.push_str("    <DataSet timestep=\"");
        // Shortest text that reads back as the same number; writing to a String cannot fail.
        let _ = write!(text, "{time:?}");
        text.push_str("\" part=\"0\" file=\"");
        escape(file, &mut text);
        text.push_str("\"/>\n");
    }
    text.push_str("  </Collection>\n</VTKFile>\n");
    Ok(text)
}

/// Appends `value` as the content of an XML attribute.
fn escape(value: &str, text: &mut String) {
    for c in value.chars() {
        match c {
            '&' => text.push_str("&amp;"),
            '<' => text.push_str("&lt;"),
            '>' => text.push_str("&gt;"),
            '"' => text.push_str("&quot;"),
            '\'' => text.push_str("&apos;"),
            c => text.push(c),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn file_names_are_escaped_and_times_exact() -> Result<(), VtkError> {
        let frames = [(-0.1, "a/b & \"c\" <'d'>.vtu".to_owned()), (0.1 + 0.2, "шаг 2.vtu".to_owned())];
        let text = pvd(&frames)?;
        let sets: Vec<&str> = text.lines().filter(|l| l.contains("<DataSet")).map(str::trim).collect();
        assert_eq!(
            sets,
            [
                r#"<DataSet timestep="-0.1" part="0" file="a/b &amp; &quot;c&quot; &lt;&apos;d&apos;&gt;.vtu"/>"#,
                r#"<DataSet timestep="0.30000000000000004" part="0" file="шаг 2.vtu"/>"#,
            ]
        );
        Ok(())
    }

    #[test]
    fn times_must_be_finite_and_increase() {
        for (times, faulty) in [([0.0, f64::NAN], 1), ([f64::INFINITY, 1.0], 0), ([1.0, 1.0], 1), ([1.0, 0.5], 1)] {
            let frames = times.map(|time| (time, "x.vtu".to_owned()));
            let result = pvd(&frames);
            assert!(matches!(result, Err(VtkError::Time { frame, .. }) if frame == faulty), "{times:?}: {result:?}");
        }
    }

    #[test]
    fn names_xml_cannot_carry_are_refused() {
        let result = pvd(&[(0.0, "a\0.vtu".to_owned())]);
        assert!(matches!(result, Err(VtkError::FileName { frame: 0, .. })), "{result:?}");
    }
}
