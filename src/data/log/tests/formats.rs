//! Tests that CSV, gzipped CSV and Parquet read alike, and that garbage is an error, never a panic.

use std::io::Write;

use proptest::prelude::*;

use super::*;

fn packed(bytes: &[u8]) -> Vec<u8> {
    let mut out = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
    out.write_all(bytes).unwrap();
    out.finish().unwrap()
}

fn all_of(bytes: &[u8]) -> Result<Log, LogError> {
    Log::read(open("log", bytes)?.as_mut(), Quantity::Tau, Acceptance::default())
}

#[test]
fn three_formats_agree() {
    let plain = text(&good());
    let log = all_of(plain.as_bytes()).unwrap();
    assert_eq!(all_of(&packed(plain.as_bytes())).unwrap(), log);
    let mut parquet = Vec::new();
    super::super::parquet::write(&log, &mut parquet).unwrap();
    assert_eq!(Format::of(&parquet), Format::Parquet);
    assert_eq!(all_of(&parquet).unwrap().columns, log.columns);
    let mut again = Vec::new();
    super::super::csv::write(&log, &mut again).unwrap();
    assert_eq!(all_of(&again).unwrap(), log);
}

/// An empty list has no element, whether or not elements may be null.
#[test]
fn an_empty_list_of_parquet_is_a_bad_cell() {
    use ::parquet::{data_type::DoubleType, file::writer::SerializedFileWriter, schema::parser::parse_message_type};
    let lists = [
        ("repeated double x;", [1, 0, 1]),
        ("required group x (LIST) { repeated group list { required double element; } }", [1, 0, 1]),
        ("required group x (LIST) { repeated group list { optional double element; } }", [2, 0, 2]),
    ];
    for (schema, levels) in lists {
        let schema = parse_message_type(&format!("message log {{ {schema} }}")).unwrap();
        let mut bytes = Vec::new();
        let mut writer = SerializedFileWriter::new(&mut bytes, schema.into(), Default::default()).unwrap();
        let mut group = writer.next_row_group().unwrap();
        let mut column = group.next_column().unwrap().unwrap();
        column.typed::<DoubleType>().write_batch(&[1.0, 2.0], Some(&levels), Some(&[0; 3])).unwrap();
        column.close().unwrap();
        group.close().unwrap();
        writer.close().unwrap();
        let mut table = super::super::parquet::ParquetTable::new("log", bytes::Bytes::from(bytes)).unwrap();
        let mut block = Block { columns: vec![Vec::new()], ..Block::default() };
        table.select(&[0], 0).unwrap();
        table.next_rows(3, &mut block).unwrap();
        assert_eq!(table.names(), ["x[0]"]);
        assert_eq!((block.columns[0][0], block.columns[0][2]), (1.0, 2.0));
        assert!(block.columns[0][1].is_nan());
        let bad: Vec<(usize, &str)> = block.bad.iter().map(|b| (b.row, b.text.as_str())).collect();
        assert_eq!(bad, [(1, "0 elements in `x` where the first row has 1")]);
    }
}

/// UTF-16 of Windows programs; characters beyond 16 bits take two units.
#[test]
fn text_of_two_bytes_a_letter_is_read() {
    let plain = text(&good());
    let marked = format!("\u{feff}# Gelenk \u{1f916}\n{plain}");
    let little: Vec<u8> = marked.encode_utf16().flat_map(u16::to_le_bytes).collect();
    let big: Vec<u8> = marked.encode_utf16().flat_map(u16::to_be_bytes).collect();
    let log = all_of(plain.as_bytes()).unwrap();
    for bytes in [&little, &big] {
        assert_eq!(all_of(bytes).unwrap().columns, log.columns);
    }
    let cut = all_of(&little[..little.len() - 1]).unwrap_err().to_string();
    assert!(cut.contains("UTF-16"), "{cut}");
}

/// The first matrix of a file written by `save('x.mat', '-v4')`, in both byte orders.
#[test]
fn a_file_of_matlab_4_is_named() {
    let header = |order: fn(u32) -> [u8; 4], kind: u32| [kind, 3, 2, 0, 2].map(order).concat();
    for bytes in [header(u32::to_le_bytes, 0), header(u32::to_be_bytes, 1000)] {
        let said = all_of(&bytes).unwrap_err().to_string();
        assert!(said.contains("MATLAB 4") && said.contains("-v7"), "{said}");
    }
}

#[test]
fn blocks_of_any_size_give_the_same_rows() {
    let plain = text(&good());
    for rows in [1, 7, 1000] {
        let mut source = open("log", plain.as_bytes()).unwrap();
        let (mut block, mut lines, mut sum) = (Block::default(), 0, 0.0);
        loop {
            source.next_block(rows, &mut block).unwrap();
            if block.is_empty() {
                break;
            }
            assert!(block.len() <= rows);
            lines += block.len();
            sum += block.columns[1].iter().sum::<f64>();
        }
        assert_eq!(lines, 400);
        assert!((sum - all_of(plain.as_bytes()).unwrap().columns[1].iter().sum::<f64>()).abs() < 1e-9);
    }
}

#[test]
fn spaces_quotes_and_windows_lines() {
    let plain = text(&good()).replace(',', " , ").replace('\n', "\r\n").replacen("tau1", "\"tau1\"", 1);
    assert_eq!(all_of(plain.as_bytes()).unwrap().columns, all_of(text(&good()).as_bytes()).unwrap().columns);
    let marked = format!("\u{feff}{}", text(&good()));
    assert_eq!(all_of(marked.as_bytes()).unwrap().len(), 400);
}

#[test]
fn empty_and_truncated() {
    assert!(matches!(all_of(b""), Err(LogError::Empty { .. })));
    assert!(all_of(b"t,q1,tau1\n").is_err());
    let gz = packed(text(&good()).as_bytes());
    assert!(matches!(all_of(&gz[..gz.len() / 2]), Err(LogError::Read { .. })));
    assert!(matches!(all_of(b"PAR1rubbish"), Err(LogError::Parquet { .. })));
}

/// The error carries its cause as a typed value and as text.
#[test]
fn an_error_holds_its_cause() {
    let long: u64 = (48 << 20) + 1;
    let error = all_of(&[b"\x89MCAP0\r\n\x06", &long.to_le_bytes()[..]].concat()).unwrap_err();
    assert!(
        matches!(&error, LogError::Format { source, .. } if matches!(**source, Malformed::Mcap(McapError::LongRecord(n)) if n == long))
    );
    let said = format!("log: the MCAP file can't be read: a record of {long} bytes; {} are read at most", 48 << 20);
    assert_eq!(error.to_string(), said);
    assert!(std::error::Error::source(&error).is_some());

    let error = all_of(b"t,q1 [kg],tau1\n0,1,2\n").unwrap_err();
    assert!(matches!(&error, LogError::Unit { source, .. } if matches!(**source, UnitError::Unknown { .. })));
    assert!(error.to_string().starts_with("log, line 1, column `q1 [kg]`: `kg` is no unit for `q1`; choose among "));

    let reading = |column: &str| {
        let channel = Channel { name: "{joint}/x".into(), ..Channel::default() };
        let mapping = Mapping { columns: vec![(column.into(), channel)], ..Mapping::default() };
        Reading { mapping: Some(mapping), ..Reading::default() }
    };
    let error = |column: &str| match reading(column).layout("log", &["t", "a/x"]) {
        Err(LogError::Mapping { source, .. }) => *source,
        other => panic!("{other:?}"),
    };
    assert_eq!(error("q1"), MappingError::NoRobot);
    assert_eq!(error("q1").to_string(), "{joint} needs the robot file: give --robot ROBOT");
    assert_eq!(error("x1"), MappingError::NoColumn("x1".into()));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_bytes_make_it_panic(bytes in proptest::collection::vec(any::<u8>(), 0..300), kind in 0usize..4) {
        let head: &[u8] = [&b""[..], b"t,q1,tau1\n", b"\x1f\x8b\x08\0", b"PAR1"][kind];
        let _ = all_of(&[head, &bytes[..]].concat());
    }

    #[test]
    fn no_cells_make_it_panic(cells in proptest::collection::vec("(|-?[0-9]{1,3}(\\.[0-9])?|nan|inf|1e308|x|,|\n)", 0..120)) {
        let body = cells.chunks(3).map(|row| row.join(",") + "\n").collect::<String>();
        let bytes = format!("t,q1,tau1\n{body}");
        let _ = all_of(bytes.as_bytes());
        let mut source = open("log", bytes.as_bytes()).unwrap();
        let prepare = crate::data::signal::Prepare { keep: Acceptance::all(), filter: None, trim: 0.0, ..Default::default() };
        let _ = crate::data::signal::each_motion(source.as_mut(), 1, &prepare, |m| assert_eq!(m.tau.len(), m.states.len));
    }

    #[test]
    fn no_damage_to_a_parquet_makes_it_panic(at in 0usize..10_000, value in any::<u8>()) {
        let log = all_of(text(&good()).as_bytes()).unwrap();
        let mut bytes = Vec::new();
        super::super::parquet::write(&log, &mut bytes).unwrap();
        let at = at % bytes.len();
        bytes[at] = value;
        let _ = all_of(&bytes);
    }
}
