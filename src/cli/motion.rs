//! Reading a motion from CSV: `t, q1.., dq1.., ddq1..`.

use std::path::Path;

use super::Failure;
use super::files;
use crate::excite::check::Written;

/// Reads `t`, `q1..qn` and, if present, `dq..` and `ddq..`; other columns are ignored.
pub(super) fn read(path: &Path, dof: usize) -> Result<Written, Failure> {
    let shown = path.display();
    let text = files::text(path)?;
    let mut reader = csv::ReaderBuilder::new().trim(csv::Trim::All).from_reader(text.as_bytes());
    let joints = if dof == 1 { "1 joint".to_string() } else { format!("{dof} joints") };
    let bad = |what: String| Failure::input(format!("{shown}: {what}"));
    let header = reader.headers().map_err(|e| bad(format!("no CSV header: {e}")))?.clone();
    let find = |name: &str| header.iter().position(|h| h == name);
    let group = |prefix: &str| -> Option<Vec<usize>> { (1..=dof).map(|j| find(&format!("{prefix}{j}"))).collect() };
    let time = find("t").ok_or_else(|| bad("line 1: there is no column `t`".into()))?;
    let q = group("q").ok_or_else(|| {
        let missing = (1..=dof).map(|j| format!("q{j}")).find(|name| find(name).is_none()).unwrap_or_default();
        bad(format!("line 1: there is no column `{missing}`; the robot has {joints}"))
    })?;
    if find(&format!("q{}", dof + 1)).is_some() {
        return Err(bad(format!("line 1: there is a column `q{}`, but the robot has {joints}", dof + 1)));
    }
    let (dq, ddq) = (group("dq"), group("ddq"));
    let mut written = Written::default();
    for (row, record) in reader.records().enumerate() {
        let line = row + 2;
        let record = record.map_err(|e| bad(format!("line {line}: {e}")))?;
        let number = |column: usize| -> Result<f64, Failure> {
            let cell = record.get(column).unwrap_or("");
            cell.parse::<f64>().ok().filter(|x| x.is_finite()).ok_or_else(|| {
                bad(format!("line {line}, column `{}`: `{cell}` is not a finite number", &header[column]))
            })
        };
        let cells = |columns: &[usize]| columns.iter().map(|&c| number(c)).collect::<Result<Vec<f64>, _>>();
        written.t.push(number(time)?);
        written.q.push(cells(&q)?);
        if let Some(dq) = &dq {
            written.dq.push(cells(dq)?);
            if let Some(ddq) = &ddq {
                written.ddq.push(cells(ddq)?);
            }
        }
    }
    Ok(written)
}
