//! The rows of a finished study as Parquet: a column for each of theirs, what is empty null.

use std::path::Path;

use crate::input::Problem;
use crate::output::OutputError;
use crate::output::files::Guard;

use super::folder::StudyError;

/// Refuses to write Parquet where the program was built without it, or where the name says something else, before hours are
/// spent on the rows.
///
/// # Errors
/// It cannot be written.
pub fn check(path: &Path) -> Result<(), Problem> {
    if path.extension().is_none_or(|ending| !ending.eq_ignore_ascii_case("parquet")) {
        let problem = Problem::new(format!("--parquet: {} does not end in .parquet", path.display()));
        return Err(problem.help("name the file that is written, as rows.parquet"));
    }
    if cfg!(feature = "parquet") {
        return Ok(());
    }
    let problem = Problem::new("--parquet: the program was built without Parquet");
    Err(problem.help(
        "build it without `--no-default-features`, or let `polars.scan_csv(\"rows.csv\").sink_parquet(\"rows.parquet\")` do it",
    ))
}

/// Writes rows, which stand in a file of CSV, to a path.
///
/// # Errors
/// They cannot be read or written.
#[cfg(feature = "parquet")]
pub fn write(rows: &Path, path: &Path, guard: Guard) -> Result<(), StudyError> {
    let bytes = table::bytes(rows).map_err(|error| OutputError::at(path)(error))?;
    crate::output::files::write(path, &bytes, guard).map_err(StudyError::Output)
}

/// Refuses to: see [`check`].
///
/// # Errors
/// Always.
#[cfg(not(feature = "parquet"))]
pub fn write(_: &Path, path: &Path, _: Guard) -> Result<(), StudyError> {
    let unsupported = OutputError::at(path)(std::io::ErrorKind::Unsupported.into());
    Err(check(path).err().map_or(StudyError::Output(unsupported), StudyError::Refused))
}

#[cfg(feature = "parquet")]
mod table {
    use std::io;
    use std::path::Path;
    use std::sync::Arc;

    use parquet::basic::{Compression, LogicalType, Repetition, Type as Physical};
    use parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
    use parquet::errors::ParquetError;
    use parquet::file::properties::WriterProperties;
    use parquet::file::writer::SerializedFileWriter;
    use parquet::schema::types::Type;

    /// Rows of a group: what is held as cells at a time.
    const TOGETHER: usize = 100_000;

    /// What the cells of a column are.
    #[derive(Clone, Copy, PartialEq)]
    enum Holds {
        Whole,
        Numbers,
        Words,
    }

    /// The rows of a file of CSV.
    pub fn bytes(rows: &Path) -> io::Result<Vec<u8>> {
        let (names, holds) = columns(rows)?;
        let failed = |error: ParquetError| io::Error::other(error.to_string());
        let column = |(name, holds): (&String, &Holds)| {
            let physical = match holds {
                Holds::Whole => Physical::INT64,
                Holds::Numbers => Physical::DOUBLE,
                Holds::Words => Physical::BYTE_ARRAY,
            };
            let logical = (*holds == Holds::Words).then_some(LogicalType::String);
            let column = Type::primitive_type_builder(name, physical).with_repetition(Repetition::OPTIONAL);
            column.with_logical_type(logical).build().map(Arc::new)
        };
        let fields = names.iter().zip(&holds).map(column).collect::<Result<_, _>>().map_err(failed)?;
        let schema = Type::group_type_builder("rows").with_fields(fields).build().map_err(failed)?;
        let properties = WriterProperties::builder().set_compression(Compression::SNAPPY).build();
        let mut writer =
            SerializedFileWriter::new(Vec::new(), Arc::new(schema), Arc::new(properties)).map_err(failed)?;
        let mut reader = csv::Reader::from_path(rows).map_err(io::Error::other)?;
        let mut records = reader.records();
        loop {
            let some = records.by_ref().take(TOGETHER).collect::<Result<Vec<_>, _>>().map_err(io::Error::other)?;
            if some.is_empty() {
                break;
            }
            let mut group = writer.next_row_group().map_err(failed)?;
            for (i, holds) in holds.iter().enumerate() {
                let cells = || some.iter().map(|record| record.get(i).unwrap_or_default());
                let levels: Vec<i16> = cells().map(|cell| i16::from(!cell.is_empty())).collect();
                let said = || cells().filter(|cell| !cell.is_empty());
                let Some(mut column) = group.next_column().map_err(failed)? else { break };
                match holds {
                    Holds::Whole => {
                        let values: Vec<i64> = said().filter_map(|cell| cell.parse().ok()).collect();
                        column.typed::<Int64Type>().write_batch(&values, Some(&levels), None).map_err(failed)?;
                    }
                    Holds::Numbers => {
                        let values: Vec<f64> = said().filter_map(|cell| cell.parse().ok()).collect();
                        column.typed::<DoubleType>().write_batch(&values, Some(&levels), None).map_err(failed)?;
                    }
                    Holds::Words => {
                        let values: Vec<ByteArray> = said().map(ByteArray::from).collect();
                        column.typed::<ByteArrayType>().write_batch(&values, Some(&levels), None).map_err(failed)?;
                    }
                }
                column.close().map_err(failed)?;
            }
            group.close().map_err(failed)?;
        }
        writer.into_inner().map_err(failed)
    }

    /// Names of the columns and what they hold: the first numbers the jobs, the last is what went wrong, others hold numbers
    /// where every cell does that says something.
    fn columns(rows: &Path) -> io::Result<(Vec<String>, Vec<Holds>)> {
        let mut reader = csv::Reader::from_path(rows).map_err(io::Error::other)?;
        let names: Vec<String> = reader.headers().map_err(io::Error::other)?.iter().map(str::to_string).collect();
        let mut holds = vec![Holds::Numbers; names.len()];
        for record in reader.records() {
            for (cell, holds) in record.map_err(io::Error::other)?.iter().zip(&mut holds) {
                if !cell.is_empty() && cell.parse::<f64>().is_err() {
                    *holds = Holds::Words;
                }
            }
        }
        if let [first, .., last] = &mut holds[..] {
            (*first, *last) = (Holds::Whole, Holds::Words);
        }
        Ok((names, holds))
    }
}

#[cfg(all(test, feature = "parquet"))]
mod tests {
    use std::io::Write;

    use super::table;

    #[test]
    fn rows_are_numbers_and_words_and_nothing() -> std::io::Result<()> {
        let mut file = tempfile::NamedTempFile::new()?;
        file.write_all(b"job,depth [mm],verdict,chi2,error\n1,0.5,adequate,1.25,\n2,1e-3,,,\"no, none\"\n")?;
        let bytes = table::bytes(file.path())?;
        let text = crate::measure::text_of_parquet(&bytes).and_then(Result::ok);
        let expected = "job\tdepth [mm]\tverdict\tchi2\terror\n1\t0.5\tadequate\t1.25\t\n2\t0.001\t\t\tno, none\n";
        assert_eq!(text.as_deref(), Some(expected));
        Ok(())
    }
}
