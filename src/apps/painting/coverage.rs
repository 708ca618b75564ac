//! Coverage of a painting motion: the roller's line of contact, swept over the wall and counted in
//! cells.

use super::strokes::Strokes;
use super::surface::Surface;

/// Number of passes over each cell of the wall.
#[derive(Debug, Clone, PartialEq)]
pub struct Coverage {
    /// Number of cells across and along the strokes.
    pub cells: [usize; 2],
    /// Number of passes over each cell: `[k * across + i]`, from the lower left.
    pub passes: Vec<u16>,
    /// Share of the wall that is painted.
    pub painted: f64,
    /// Share of the wall that is painted on more than one lane.
    pub overlapped: f64,
}

/// Size of a cell, m; walls with more than [`MOST`] cells to a side have larger ones.
const CELL: f64 = 0.005;
/// Maximum number of cells to a side.
const MOST: f64 = 400.0;

impl Coverage {
    /// Computes the coverage of the lanes with a roller of this width, m.
    pub fn new(surface: &Surface, strokes: &Strokes, width: f64) -> Self {
        let count = |extent: f64| (extent / CELL).ceil().clamp(1.0, MOST) as usize;
        let cells = [count(surface.width), count(surface.height)];
        let ([left, _], [low, _]) = (surface.sides(), surface.ends());
        let mut passes = vec![0u16; cells[0] * cells[1]];
        let mut lanes = vec![0u16; cells[0] * cells[1]];
        // A cell counts if its middle is passed; on the seam of two lanes it belongs to both.
        let slack = 1e-9;
        let inside = |x: f64, a: f64, b: f64| x >= a.min(b) - slack && x <= a.max(b) + slack;
        let legs: Vec<_> = strokes.legs(0.0).into_iter().filter(|l| l.phase.contact()).collect();
        for k in 0..cells[1] {
            let z = low + (k as f64 + 0.5) * surface.height / cells[1] as f64;
            for i in 0..cells[0] {
                let y = left + (i as f64 + 0.5) * surface.width / cells[0] as f64;
                let under = |from: f64, to: f64| inside(y, from.min(to) - 0.5 * width, from.max(to) + 0.5 * width);
                let strokes = legs.iter().filter(|l| l.from[1] != l.to[1]);
                let passed = strokes.filter(|l| under(l.from[0], l.to[0]) && inside(z, l.from[1], l.to[1])).count();
                passes[k * cells[0] + i] = passed.min(usize::from(u16::MAX)) as u16;
            }
        }
        for (cell, lanes) in lanes.iter_mut().enumerate() {
            let y = left + ((cell % cells[0]) as f64 + 0.5) * surface.width / cells[0] as f64;
            if passes[cell] > 0 {
                *lanes =
                    (0..strokes.lanes).filter(|&k| (strokes.lane(k) - y).abs() <= 0.5 * width + slack).count() as u16;
            }
        }
        let share = |f: &dyn Fn(&u16) -> bool, of: &[u16]| of.iter().filter(|p| f(p)).count() as f64 / of.len() as f64;
        let (painted, overlapped) = (share(&|p| *p > 0, &passes), share(&|p| *p > 1, &lanes));
        Self { cells, passes, painted, overlapped }
    }
}
