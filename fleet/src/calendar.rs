//! Dates and days since 1970.

/// Date of a number of days since 1970 (Hinnant, days_from_civil and back).
pub fn date(days: i32) -> String {
    let z = i64::from(days) + 719_468;
    let era = z.div_euclid(146_097);
    let of_era = z.rem_euclid(146_097);
    let year_of_era = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let shifted = (5 * of_year + 2) / 153;
    let day = of_year - (153 * shifted + 2) / 5 + 1;
    let month = if shifted < 10 { shifted + 3 } else { shifted - 9 };
    let year = year_of_era + era * 400 + i64::from(month <= 2);
    format!("{year:04}-{month:02}-{day:02}")
}

/// Days since 1970 of a date such as `2026-11-23`; `None` where it is none.
pub fn day(text: &str) -> Option<i32> {
    let mut words = text.splitn(3, '-');
    let mut number = || words.next().filter(|word| word.bytes().all(|b| b.is_ascii_digit()))?.parse::<i64>().ok();
    let (year, month, of_month) = (number()?, number()?, number()?);
    // March is the first month: leap days stand at the end of the year.
    let shifted_year = if month > 2 { year } else { year - 1 };
    let era = shifted_year.div_euclid(400);
    let year_of_era = shifted_year.rem_euclid(400);
    let of_year = (153 * ((month + 9) % 12) + 2) / 5 + of_month - 1;
    let days = era * 146_097 + 365 * year_of_era + year_of_era / 4 - year_of_era / 100 + of_year - 719_468;
    i32::try_from(days).ok().filter(|days| date(*days) == text)
}

#[cfg(test)]
mod tests {
    use super::{date, day};

    #[test]
    fn dates_are_those_of_the_calendar() {
        assert_eq!(date(0), "1970-01-01");
        assert_eq!(date(20_780), "2026-11-23");
        assert_eq!(date(11_016), "2000-02-29");
        assert_eq!(date(-1), "1969-12-31");
    }

    #[test]
    fn days_are_those_of_their_dates() {
        for days in (-1000..40_000).step_by(7) {
            assert_eq!(day(&date(days)), Some(days));
        }
        for wrong in ["2026-02-30", "2026-13-01", "2026-1-1", "monday", "", "2026-11", "+026-11-23"] {
            assert_eq!(day(wrong), None, "{wrong}");
        }
    }
}
