//! Parquet: a table of plain columns as text, a line for each row, tabs between its cells.

use crate::input::Problem;

/// What begins and ends such a file.
const MARK: &[u8] = b"PAR1";

/// The text of a table; `None` where the bytes are no Parquet.
///
/// # Errors
/// The file cannot be read, is too large, or holds what is no table of plain columns; or the program was built without Parquet.
pub fn text(bytes: &[u8]) -> Option<Result<String, Problem>> {
    bytes.starts_with(MARK).then(|| written(bytes))
}

#[cfg(not(feature = "parquet"))]
fn written(_: &[u8]) -> Result<String, Problem> {
    let problem = Problem::new("this is Parquet, which the program was built without");
    Err(problem.help("build it without `--no-default-features`, or save the table as CSV"))
}

#[cfg(feature = "parquet")]
use table::written;

#[cfg(feature = "parquet")]
mod table {
    use bytes::Bytes;
    use parquet::errors::ParquetError;
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::Field;
    use parquet::schema::types::Type;

    use crate::input::{Problem, unless_damaged};

    /// Most columns, and the most bytes of the table when unpacked and as text: as of workbooks.
    const MOST_COLUMNS: usize = 1000;
    const LARGEST: i64 = 1_000_000_000;
    const LARGEST_TEXT: usize = 500_000_000;

    /// The text of a table.
    pub fn written(bytes: &[u8]) -> Result<String, Problem> {
        // The library gives up on some damaged pages by a panic.
        unless_damaged(|| read(bytes)).unwrap_or_else(|| {
            let problem = Problem::new("the Parquet file cannot be read: its pages are damaged");
            Err(problem.help("fetch it again, or save the table as CSV"))
        })
    }

    fn read(bytes: &[u8]) -> Result<String, Problem> {
        let wrong = |error: ParquetError| {
            let problem = Problem::new(format!("the Parquet file cannot be read: {error}"));
            problem
                .help("write it anew without encryption, compressed by snappy or gzip or not at all, or save it as CSV")
        };
        let reader = SerializedFileReader::new(Bytes::copy_from_slice(bytes)).map_err(wrong)?;
        let about = reader.metadata();
        let columns = about.file_metadata().schema().get_fields();
        let size = |group: &parquet::file::metadata::RowGroupMetaData| {
            group.columns().iter().map(|column| column.uncompressed_size().max(0)).fold(0, i64::saturating_add)
        };
        if about.row_groups().iter().map(size).fold(0, i64::saturating_add) > LARGEST {
            let problem = Problem::new(format!("the Parquet file unpacks to more than {} MB", LARGEST / 1_000_000));
            return Err(problem.help("write fewer rows, or the columns that are measured alone"));
        }
        let ends = |column: &parquet::file::metadata::ColumnChunkMetaData| {
            let first = column.dictionary_page_offset().unwrap_or(column.data_page_offset());
            let is_within = first >= 0 && column.data_page_offset() >= 0 && column.compressed_size() >= 0;
            is_within && first.checked_add(column.compressed_size()).is_some_and(|end| end <= bytes.len() as i64)
        };
        // The library takes for granted that they lie in the file.
        if !about.row_groups().iter().flat_map(|group| group.columns()).all(ends) {
            let problem = Problem::new("the Parquet file cannot be read: its columns do not lie in it");
            return Err(problem.help("it was changed or cut off: fetch it again, or save the table as CSV"));
        }
        if columns.len() > MOST_COLUMNS {
            let problem = Problem::new(format!("the Parquet file has {} columns", columns.len()));
            return Err(problem.help(format!("write at most {MOST_COLUMNS}: those that are measured")));
        }
        columns.iter().try_for_each(|column| plain(column))?;
        let heads: Vec<String> = columns.iter().map(|column| quoted(column.name())).collect();
        let mut text = heads.join("\t");
        text.push('\n');
        for row in reader.get_row_iter(None).map_err(wrong)? {
            for (i, (name, cell)) in row.map_err(wrong)?.get_column_iter().enumerate() {
                if i > 0 {
                    text.push('\t');
                }
                text.push_str(&shown(name, cell)?);
            }
            text.push('\n');
            if text.len() > LARGEST_TEXT {
                let problem = Problem::new(format!("the table has more than {} MB of text", LARGEST_TEXT / 1_000_000));
                return Err(problem.help("write fewer rows, or the columns that are measured alone"));
            }
        }
        Ok(text)
    }

    /// Refuses a column that holds lists or groups.
    fn plain(column: &Type) -> Result<(), Problem> {
        let about = column.get_basic_info();
        let is_list = about.has_repetition() && about.repetition() == parquet::basic::Repetition::REPEATED;
        if column.is_primitive() && !is_list {
            return Ok(());
        }
        let problem = Problem::new(format!("the column `{}` is nested: it holds lists or groups", column.name()));
        Err(problem.help("write a plain column for each of the values in it"))
    }

    /// A cell as a table of text would have it.
    fn shown(name: &str, cell: &Field) -> Result<String, Problem> {
        Ok(match cell {
            Field::Null => String::new(),
            Field::Double(number) if number.is_nan() => String::new(),
            Field::Float(number) if number.is_nan() => String::new(),
            Field::Double(number) => number.to_string(),
            Field::Float(number) => number.to_string(),
            Field::Str(text) => quoted(text),
            Field::Date(days) => date(i64::from(*days)),
            Field::TimeMillis(thousandths) => time(1000 * i64::from(*thousandths)),
            Field::TimeMicros(millionths) => time(*millionths),
            Field::TimestampMillis(thousandths) => moment(thousandths.saturating_mul(1000)),
            Field::TimestampMicros(millionths) => moment(*millionths),
            Field::Bytes(_) | Field::Group(_) | Field::ListInternal(_) | Field::MapInternal(_) => {
                let problem =
                    Problem::new(format!("the column `{name}` holds bytes, which are neither numbers nor words"));
                return Err(problem.help("leave the column out, or write it as text"));
            }
            number => number.to_string(),
        })
    }

    /// Millionths of a second in a day.
    const DAY: i64 = 86_400_000_000;

    /// A moment, millionths of a second after 1970, as ISO 8601 has it.
    fn moment(millionths: i64) -> String {
        format!("{}T{}", date(millionths.div_euclid(DAY)), time(millionths.rem_euclid(DAY)))
    }

    /// A time of day, millionths of a second after midnight.
    fn time(millionths: i64) -> String {
        let (seconds, rest) = (millionths.rem_euclid(DAY) / 1_000_000, millionths.rem_euclid(1_000_000));
        let fraction = if rest > 0 { format!(".{rest:06}") } else { String::new() };
        format!("{:02}:{:02}:{:02}{fraction}", seconds / 3600, seconds / 60 % 60, seconds % 60)
    }

    /// A day, by its number after 1970-01-01, in the calendar of today. Years of 400 repeat, and begin with March.
    fn date(day: i64) -> String {
        let from_march = day.saturating_add(719_468);
        let (era, of_era) = (from_march.div_euclid(146_097), from_march.rem_euclid(146_097));
        let year = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
        let of_year = of_era - (365 * year + year / 4 - year / 100);
        let month = (5 * of_year + 2) / 153;
        let day = of_year - (153 * month + 2) / 5 + 1;
        let month = if month < 10 { month + 3 } else { month - 9 };
        format!("{:04}-{month:02}-{day:02}", year + 400 * era + i64::from(month <= 2))
    }

    /// A text on one line, in quotes where it needs them.
    fn quoted(text: &str) -> String {
        let line = text.split_whitespace().collect::<Vec<_>>().join(" ");
        if line.starts_with('#') || line.contains('"') { format!("\"{}\"", line.replace('"', "\"\"")) } else { line }
    }
}

#[cfg(all(test, not(feature = "parquet")))]
mod tests {
    #[test]
    fn a_program_without_parquet_says_how_to_get_it() {
        let told = super::text(b"PAR1\0\0\0\0PAR1").map(|text| text.map_err(|problem| problem.help));
        assert!(matches!(told, Some(Err(Some(help))) if help.contains("--no-default-features")));
        assert!(super::text(b"x [mm],u").is_none());
    }
}

#[cfg(all(test, feature = "parquet"))]
mod tests {
    use std::sync::Arc;

    use parquet::data_type::{ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
    use parquet::errors::ParquetError;
    use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
    use parquet::schema::parser::parse_message_type;

    use super::text;

    /// Writes the next column of a group; `levels` say which rows have a value.
    fn column<T: DataType>(
        group: &mut SerializedRowGroupWriter<'_, Vec<u8>>,
        values: &[T::T],
        levels: Option<&[i16]>,
    ) -> Result<(), ParquetError> {
        let mut column = group.next_column()?.ok_or(ParquetError::EOF("columns".into()))?;
        column.typed::<T>().write_batch(values, levels, None)?;
        column.close()
    }

    /// A file of three rows with a column of each kind.
    fn file() -> Result<Vec<u8>, ParquetError> {
        let schema = parse_message_type(
            "message rows { OPTIONAL DOUBLE x; REQUIRED INT64 run; OPTIONAL BYTE_ARRAY direction (UTF8);
             REQUIRED INT64 time (TIMESTAMP(MILLIS, true)); }",
        )?;
        let mut writer = SerializedFileWriter::new(Vec::new(), Arc::new(schema), Arc::default())?;
        let mut group = writer.next_row_group()?;
        column::<DoubleType>(&mut group, &[0.1 + 0.2, -1e-9], Some(&[1, 0, 1]))?;
        column::<Int64Type>(&mut group, &[1, 2, 3], None)?;
        column::<ByteArrayType>(&mut group, &["for\"ward", "# back"].map(ByteArray::from), Some(&[1, 1, 0]))?;
        column::<Int64Type>(&mut group, &[0, 86_400_500, 1_000], None)?;
        group.close()?;
        writer.into_inner()
    }

    #[test]
    fn plain_columns_are_read_as_they_are() -> Result<(), ParquetError> {
        let told = text(&file()?).map(|text| text.map_err(|problem| problem.message));
        let expected = "x\trun\tdirection\ttime\n\
                        0.30000000000000004\t1\t\"for\"\"ward\"\t1970-01-01T00:00:00\n\
                        \t2\t\"# back\"\t1970-01-02T00:00:00.500000\n\
                        -0.000000001\t3\t\t1970-01-01T00:00:01\n";
        assert_eq!(told, Some(Ok(expected.into())));
        Ok(())
    }

    #[test]
    fn nested_columns_and_bytes_are_refused() -> Result<(), ParquetError> {
        for (schema, word) in [
            ("message rows { REQUIRED GROUP deep { REQUIRED DOUBLE x; } }", "`deep` is nested"),
            ("message rows { REPEATED DOUBLE many; }", "`many` is nested"),
        ] {
            let schema = Arc::new(parse_message_type(schema)?);
            let bytes = SerializedFileWriter::new(Vec::new(), schema, Arc::default())?.into_inner()?;
            let told = text(&bytes).map(|text| text.map_err(|problem| problem.message));
            assert!(matches!(&told, Some(Err(message)) if message.contains(word)), "{told:?}");
        }
        let schema = Arc::new(parse_message_type("message rows { REQUIRED BYTE_ARRAY raw; }")?);
        let mut writer = SerializedFileWriter::new(Vec::new(), schema, Arc::default())?;
        let mut group = writer.next_row_group()?;
        column::<ByteArrayType>(&mut group, &[ByteArray::from(vec![0xff, 0])], None)?;
        group.close()?;
        let told = text(&writer.into_inner()?).map(|text| text.map_err(|problem| problem.message));
        assert!(matches!(&told, Some(Err(message)) if message.contains("`raw` holds bytes")), "{told:?}");
        Ok(())
    }

    /// Files that were cut off, and files of which a byte is another one: what is read, or a problem.
    #[test]
    fn broken_files_are_told() -> Result<(), ParquetError> {
        let whole = file()?;
        for end in 4..whole.len() {
            assert!(matches!(text(&whole[..end]), Some(Err(_))), "{end} bytes of {}", whole.len());
        }
        for place in 4..whole.len() {
            for change in [0x01, 0x80, 0xff] {
                let mut broken = whole.clone();
                broken[place] ^= change;
                assert!(text(&broken).is_some());
            }
        }
        Ok(())
    }
}
