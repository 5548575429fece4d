//! Dates and times of day (ISO 8601).

/// Nanoseconds in a second.
const SECOND: i128 = 1_000_000_000;
/// Seconds in a day.
const DAY: i128 = 86_400;

/// A moment: a date and a time of day, or a time of day alone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Moment {
    /// Nanoseconds since the first of January 1970, or since midnight.
    since: i128,
    /// Whether it has a date.
    pub(super) has_date: bool,
    /// Whether it says how far its clock is from UTC, and is counted in UTC.
    has_zone: bool,
}

impl Moment {
    /// Reads `2026-03-01T10:00:00` or `01.03.2026 10:00:00`, with a blank for the T, fractions of a second and a zone (`Z`, `+01:00`)
    /// where there are some, and a time of day alone, `10:00:00`; `None` where the text is something else.
    pub fn parse(text: &str) -> Option<Self> {
        let text = text.trim();
        let (date, time) = match text.split_once(['T', 't', ' ']) {
            Some((date, time)) => (Some(date), time.trim_start()),
            None => (None, text),
        };
        let days = date.map(days).unwrap_or(Some(0))?;
        let (time, zone) = zone(time)?;
        // 10:30 alone could be minutes and seconds.
        let of_day = of_day(time, date.is_some())?;
        let has_zone = zone.is_some();
        let since = days * DAY * SECOND + of_day - zone.unwrap_or(0) * 60 * SECOND;
        Some(Self { since, has_date: date.is_some(), has_zone })
    }

    /// Whether a text is a date alone.
    pub(super) fn is_date(text: &str) -> bool {
        days(text.trim()).is_some()
    }

    /// Seconds since another moment of the same form; `None` where the forms differ.
    pub(super) fn after(self, other: Self) -> Option<f64> {
        let is_same = self.has_date == other.has_date && self.has_zone == other.has_zone;
        is_same.then(|| (self.since - other.since) as f64 / SECOND as f64)
    }
}

/// Digits alone, as many as said.
fn digits(text: &str, count: usize) -> Option<i128> {
    let is_number = text.len() == count && text.bytes().all(|b| b.is_ascii_digit());
    is_number.then(|| text.parse().ok()).flatten()
}

/// Days since the first of January 1970 in the Gregorian calendar (Richards, in: Explanatory Supplement to the
/// Astronomical Almanac, 3rd ed., ch. 15).
fn days(date: &str) -> Option<i128> {
    // 01.03.2026 has the day in front; with strokes it could be the month.
    let parts: Vec<&str> = if date.contains('.') { date.rsplit('.').collect() } else { date.split('-').collect() };
    let mut parts = parts.into_iter();
    let (year, month) = (digits(parts.next()?, 4)?, digits(parts.next()?, 2)?);
    let day = digits(parts.next()?, 2)?;
    let is_leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
    let longest = match month {
        2 if is_leap => 29,
        2 => 28,
        4 | 6 | 9 | 11 => 30,
        1..=12 => 31,
        _ => return None,
    };
    if parts.next().is_some() || !(1..=longest).contains(&day) {
        return None;
    }
    // Years begin with March, so that the day of a leap year is the last.
    let (years, months) = if month > 2 { (year, month - 3) } else { (year - 1, month + 9) };
    let leaps = years.div_euclid(4) - years.div_euclid(100) + years.div_euclid(400);
    Some(365 * years + leaps + (153 * months + 2) / 5 + day - 1 - 719_468)
}

/// A time, and the minutes by which its zone is ahead of UTC.
fn zone(time: &str) -> Option<(&str, Option<i128>)> {
    if let Some(time) = time.strip_suffix(['Z', 'z']) {
        return Some((time, Some(0)));
    }
    let Some(sign) = time.find(['+', '-']) else { return Some((time, None)) };
    let (time, offset) = time.split_at(sign);
    let (hours, minutes) = match offset[1..].split_once(':') {
        Some((hours, minutes)) => (digits(hours, 2)?, digits(minutes, 2)?),
        None if offset.len() == 5 => (digits(offset.get(1..3)?, 2)?, digits(offset.get(3..)?, 2)?),
        None => (digits(&offset[1..], 2)?, 0),
    };
    let ahead = 60 * hours + minutes;
    Some((time, Some(if offset.starts_with('-') { -ahead } else { ahead })))
}

/// Most hours of a time that has passed.
const MOST_HOURS: i128 = 9999;

/// Nanoseconds since midnight.
fn of_day(time: &str, may_end_with_minutes: bool) -> Option<i128> {
    let mut parts = time.trim().split(':');
    let hours = parts.next()?;
    // Beside a date a day has 24 hours; what has none may be a time that has passed, 30:00:00.
    let (most, hours) = match may_end_with_minutes {
        true => (23, digits(hours, 2)?),
        false => (MOST_HOURS, digits(hours, hours.len().clamp(2, 4))?),
    };
    let minutes = digits(parts.next()?, 2)?;
    let seconds = match parts.next() {
        Some(seconds) => seconds,
        None if may_end_with_minutes => "00",
        None => return None,
    };
    let (whole, fraction) = seconds.split_once(['.', ',']).unwrap_or((seconds, "0"));
    let whole = digits(whole, 2)?;
    if parts.next().is_some() || hours > most || minutes > 59 || whole > 60 || fraction.is_empty() {
        return None;
    }
    let fraction = &fraction[..fraction.len().min(9)];
    let nanoseconds = digits(fraction, fraction.len())? * 10i128.pow(9 - fraction.len() as u32);
    Some(((hours * 60 + minutes) * 60 + whole) * SECOND + nanoseconds)
}
