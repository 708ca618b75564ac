//! Plots of a run against the wall: force over time, deviation from the plan, path.

use std::fmt::Write;

use crate::apps::painting::run::Trace;
use crate::report::parts::page::escape;

const WIDTH: f64 = 820.0;
const HEIGHT: f64 = 190.0;

/// A plot frame with time on the abscissa and values on the ordinate.
struct Frame {
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
    end: f64,
    values: [f64; 2],
}

impl Frame {
    fn new(end: f64, values: [f64; 2]) -> Self {
        Self { left: 44.0, right: WIDTH - 10.0, top: 10.0, bottom: HEIGHT - 24.0, end: end.max(1e-9), values }
    }

    fn x(&self, t: f64) -> f64 {
        self.left + (self.right - self.left) * t / self.end
    }

    fn y(&self, v: f64) -> f64 {
        let [low, high] = self.values;
        self.bottom - (self.bottom - self.top) * ((v - low) / (high - low)).clamp(0.0, 1.0)
    }

    fn open(&self, svg: &mut String, caption: &str, title: &str, ticks: &[f64]) {
        let _ = write!(
            svg,
            "<p class=note>{caption}</p><svg class=bars viewBox='0 0 {WIDTH} {HEIGHT}' role=img aria-label='{}'>",
            escape(title)
        );
        for v in ticks {
            let at = self.y(*v);
            let _ = write!(
                svg,
                "<line class=grid x1={} x2={} y1={at:.1} y2={at:.1} /><text x={} y={:.1} text-anchor=end>{v:.1}</text>",
                self.left,
                self.right,
                self.left - 5.0,
                at + 4.0
            );
        }
        let step = [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0].into_iter().find(|s| self.end / s <= 10.0).unwrap_or(500.0);
        for k in 0..=(self.end / step).floor() as usize {
            let t = step * k as f64;
            let _ = write!(svg, "<text x={:.1} y={:.1} text-anchor=middle>{t} s</text>", self.x(t), HEIGHT - 6.0);
        }
    }

    fn curve(&self, svg: &mut String, class: &str, values: &[f64]) {
        let len = values.len().max(1) as f64;
        let points = values.iter().enumerate().filter(|(_, v)| v.is_finite());
        let points: Vec<String> = points
            .map(|(i, v)| format!("{:.1},{:.1}", self.x(self.end * (i as f64 + 0.5) / len), self.y(*v)))
            .collect();
        let _ = write!(svg, "<polyline class='{class}' points='{}' />", points.join(" "));
    }
}

/// Means of bins: a curve of at most 700 points.
fn thinned(values: &[f64]) -> Vec<f64> {
    let size = values.len().div_ceil(700).max(1);
    values.chunks(size).map(|c| c.iter().sum::<f64>() / c.len() as f64).collect()
}

/// Fig. 13: measured, estimated and desired force, with the legend in the caption.
pub(in crate::report) fn force(svg: &mut String, trace: &Trace, desired: f64, title: &str) {
    let curves = [thinned(&trace.measured), thinned(&trace.estimated)];
    let finite = curves.iter().flatten().copied().filter(|v| v.is_finite());
    let reach = finite.fold(1.5, |most: f64, v| most.max((v - desired).abs())).min(desired.max(1.5));
    let frame = Frame::new(trace.t.last().copied().unwrap_or(1.0), [desired - reach, desired + reach]);
    let caption = format!(
        "<b>{}</b>, N: <span class='swatch criterion0'></span>measured <span class='swatch criterion1'></span>estimated <span class='swatch dashed'></span>desired",
        escape(title)
    );
    frame.open(svg, &caption, title, &[desired - reach, desired, desired + reach]);
    curves.iter().enumerate().for_each(|(k, curve)| frame.curve(svg, &format!("curve{k}"), curve));
    let at = frame.y(desired);
    let _ = write!(svg, "<line class=chosen x1={} x2={} y1={at:.1} y2={at:.1} /></svg>", frame.left, frame.right);
}

/// Deviation of the contact from the plan, along two axes of the wall's plane, mm.
pub(in crate::report) fn aside(svg: &mut String, trace: &Trace, axes: [[f64; 3]; 2], names: [&str; 2]) {
    let off = |axis: [f64; 3]| -> Vec<f64> {
        let pairs = trace.actual.iter().zip(&trace.planned);
        thinned(&pairs.map(|(a, p)| (0..3).map(|k| 1e3 * axis[k] * (a[k] - p[k])).sum()).collect::<Vec<f64>>())
    };
    let curves = axes.map(off);
    let reach = curves.iter().flatten().fold(1.0, |most: f64, v| most.max(v.abs()));
    let frame = Frame::new(trace.t.last().copied().unwrap_or(1.0), [-reach, reach]);
    let caption = format!(
        "<b>Roller aside of the plan</b>, mm: <span class='swatch criterion0'></span>{} <span class='swatch criterion1'></span>{}",
        names[0], names[1]
    );
    frame.open(svg, &caption, "roller aside of the plan, mm", &[-reach, 0.0, reach]);
    curves.iter().enumerate().for_each(|(k, curve)| frame.curve(svg, &format!("curve{k}"), curve));
    svg.push_str("</svg>");
}

/// Fig. 12: planned and actual path of the roller, in the plane of the wall with these axes (to the
/// right and up).
pub(in crate::report) fn path(svg: &mut String, trace: &Trace, axes: [[f64; 3]; 2], title: &str) {
    let step = trace.t.len().div_ceil(1500).max(1);
    let of = |points: &[[f64; 3]]| -> Vec<[f64; 2]> {
        points.iter().step_by(step).map(|p| axes.map(|a| (0..3).map(|k| a[k] * p[k]).sum())).collect()
    };
    let curves = [of(&trace.planned), of(&trace.actual)];
    let (low, high) = curves.iter().flatten().fold(([f64::MAX; 2], [f64::MIN; 2]), |(l, h), p| {
        ([l[0].min(p[0]), l[1].min(p[1])], [h[0].max(p[0]), h[1].max(p[1])])
    });
    let [wide, tall] = [0, 1].map(|k| (high[k] - low[k]).max(1e-3));
    let scale = (300.0 / tall).min((WIDTH - 40.0) / wide);
    let height = tall * scale + 30.0;
    let _ = write!(
        svg,
        "<p class=note><b>{0}</b>, {wide:.2} m x {tall:.2} m: <span class='swatch criterion0'></span>planned <span class='swatch criterion1'></span>actual</p><svg class=bars viewBox='0 0 {WIDTH} {height:.0}' role=img aria-label='{0}'>",
        escape(title)
    );
    let left = 0.5 * (WIDTH - wide * scale);
    for (k, curve) in curves.iter().enumerate() {
        let points: Vec<String> = curve
            .iter()
            .map(|p| format!("{:.1},{:.1}", left + (p[0] - low[0]) * scale, height - 15.0 - (p[1] - low[1]) * scale))
            .collect();
        let _ = write!(svg, "<polyline class='curve{k}' points='{}' />", points.join(" "));
    }
    svg.push_str("</svg>");
}
