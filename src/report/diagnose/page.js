const reach = (lists, zero) => {
  let low = zero ? 0 : Infinity, high = zero ? 0 : -Infinity;
  for (const list of lists) for (const v of list) if (v !== null) { low = Math.min(low, v); high = Math.max(high, v); }
  if (!(high > low)) { low = Number.isFinite(low) ? low - 1 : -1; high = low + 2; }
  return [low, high];
};
const room = ([low, high]) => [low - 0.06 * (high - low), high + 0.06 * (high - low)];
const canvas = (box, w, h, label) => make(box, 'svg', { viewBox: `0 0 ${w} ${h}`, role: 'img', 'aria-label': label });

// Marks with their words, which wrap as a text does.
const legend = (box, entries) => {
  const all = document.createElement('p');
  all.className = 'note legend';
  for (const [shape, attributes, word] of entries) {
    const entry = document.createElement('span');
    make(make(entry, 'svg', { viewBox: '0 0 24 12' }), shape, attributes);
    entry.append(word);
    all.append(entry);
  }
  box.append(all);
};

// A frame with grid and ticks; returns the maps from values to places.
const frame = (svg, { left, right, top, bottom, x, y, across = 6, up = 5, bare = false }) => {
  const px = v => left + (v - x[0]) / (x[1] - x[0]) * (right - left);
  const py = v => bottom - (v - y[0]) / (y[1] - y[0]) * (bottom - top);
  const vertical = ticks(y[0], y[1], up), horizontal = ticks(x[0], x[1], across);
  for (const v of vertical.all) {
    make(svg, 'line', { class: Math.abs(v) < 1e-12 ? 'zero' : 'grid', x1: left, x2: right, y1: py(v), y2: py(v) });
    make(svg, 'text', { x: left - 5, y: py(v) + 4, 'text-anchor': 'end' }, vertical.text(Math.abs(v) < 1e-12 ? 0 : v));
  }
  for (const v of horizontal.all) {
    make(svg, 'line', { class: 'grid', x1: px(v), x2: px(v), y1: top, y2: bottom });
    if (!bare) make(svg, 'text', { x: px(v), y: bottom + 14, 'text-anchor': 'middle' }, horizontal.text(Math.abs(v) < 1e-12 ? 0 : v));
  }
  return { px, py };
};
// `gap`: steps larger than this begin a new line.
const line = (svg, name, at, x, y, gap = Infinity) => {
  let d = '', last = null;
  x.forEach((v, i) => {
    if (y[i] === null || v === null) { last = null; return; }
    d += (last === null || v - last > gap || v < last ? 'M' : 'L') + at.px(v).toFixed(1) + ' ' + at.py(y[i]).toFixed(1);
    last = v;
  });
  make(svg, 'path', { class: name, d });
};

// The joint that gained most: torques, and the errors of all joints.
{
  const box = document.getElementById('story'), chosen = box && data.curves[+box.dataset.joint];
  if (chosen && chosen.t.length) {
    const { t, measured, before, after } = chosen, W = 560, H = 280, LEFT = 54, RIGHT = W - 8, TOP = 16, BOTTOM = H - 24;
    const less = errors => measured.map((v, i) => v === null || errors[i] === null ? null : v - errors[i]);
    const curves = { measured, before: less(before), after: less(after) }, svg = canvas(box, W, H, `joint ${+box.dataset.joint + 1}, measured and predicted torque`);
    const steps = t.slice(1).map((v, i) => v - t[i]).sort((a, b) => a - b), gap = 3 * (steps[steps.length >> 1] || 1);
    const at = frame(svg, { left: LEFT, right: RIGHT, top: TOP, bottom: BOTTOM, x: reach([t]), y: room(reach(Object.values(curves))) });
    for (const name in curves) line(svg, name, at, t, curves[name], gap);
    offer(box, 'story', ['t', 'measured', 'before', 'after'], () => t.map((v, i) => [v, ...Object.values(curves).map(curve => curve[i])]));
    offer(box, 'shares', ['joint', 'before_percent', 'after_percent'], () => data.shares.before.map((v, j) => [j + 1, v, data.shares.after[j]]));
    const bars = canvas(box, W, H, 'error of each joint, percent of its torque'), n = data.shares.before.length;
    const scale = frame(bars, { left: LEFT, right: RIGHT, top: TOP, bottom: BOTTOM, x: [0.4, n + 0.6], y: [0, 1.12 * reach([data.shares.before, data.shares.after], true)[1]], across: n, bare: true });
    const wide = 0.36 * (RIGHT - LEFT) / (n + 0.2);
    for (let j = 0; j < n; j++) {
      const middle = scale.px(j + 1);
      ['before', 'after'].forEach((name, k) => {
        const v = data.shares[name][j] ?? 0, x = middle + (k - 1) * wide;
        make(bars, 'rect', { class: name, x, y: scale.py(v), width: wide, height: BOTTOM - scale.py(v) });
        make(bars, 'text', { x: x + wide / 2, y: scale.py(v) - 4, 'text-anchor': 'middle' }, v >= 9.95 ? v.toFixed(0) : v.toFixed(1));
      });
      make(bars, 'text', { x: middle, y: BOTTOM + 15, 'text-anchor': 'middle' }, `joint ${j + 1}`);
    }
  }
}

// Each cause: what it explains over what shows it best, and what it gains on each joint.
document.querySelectorAll('[data-cause]').forEach(box => {
  const cause = data.causes[+box.dataset.cause], W = 560, H = 250, LEFT = 58, TOP = 10, RIGHT = W - 10, BOTTOM = H - 42;
  legend(box, [
    ...(cause.curve ? [['circle', { cx: 6, cy: 6, r: 2.6 }, 'error without the cause, means of bins'],
      ['path', { class: 'explained', d: 'M1 6h22' }, 'what the cause says']] : []),
    ['rect', { class: 'before', y: 1, width: 12, height: 10 }, 'without the cause'],
    ['rect', { class: 'after', y: 1, width: 12, height: 10 }, 'with it'],
    ['path', { class: 'noise', d: 'M1 6h22' }, 'noise'],
  ]);
  if (cause.curve) {
    const { over, x, measured, explained } = cause.curve, svg = canvas(box, W, H, 'measured and explained');
    const at = frame(svg, { left: LEFT, right: RIGHT, top: TOP, bottom: BOTTOM, x: room(reach([x])), y: room(reach([measured, explained], true)) });
    line(svg, 'explained', at, x, explained);
    x.forEach((v, i) => measured[i] !== null && make(svg, 'circle', { cx: at.px(v), cy: at.py(measured[i]), r: 2.2 }));
    make(svg, 'text', { class: 'axis', x: (LEFT + RIGHT) / 2, y: H - 8, 'text-anchor': 'middle' }, over);
    make(svg, 'text', { class: 'axis', transform: `translate(13,${(TOP + BOTTOM) / 2}) rotate(-90)`, 'text-anchor': 'middle' }, 'error, N m');
  }
  const { before, after } = cause, svg = canvas(box, W, H, 'gain per joint'), n = before.length;
  const at = frame(svg, { left: LEFT, right: RIGHT, top: TOP, bottom: BOTTOM, x: [0.4, n + 0.6], y: [0, 1.06 * reach([before, after, data.noise], true)[1]], across: n, bare: true });
  const wide = 0.36 * (RIGHT - LEFT) / (n + 0.2);
  for (let j = 0; j < n; j++) {
    const middle = at.px(j + 1), bar = (name, x, v) => make(svg, 'rect', { class: name, x, y: at.py(v), width: wide, height: BOTTOM - at.py(v) });
    bar('before', middle - wide, before[j] ?? 0);
    bar('after', middle, after[j] ?? 0);
    make(svg, 'line', { class: 'noise', x1: middle - 1.2 * wide, x2: middle + 1.2 * wide, y1: at.py(data.noise[j] ?? 0), y2: at.py(data.noise[j] ?? 0) });
    make(svg, 'text', { x: middle, y: BOTTOM + 15, 'text-anchor': 'middle' }, j + 1);
  }
  make(svg, 'text', { class: 'axis', x: (LEFT + RIGHT) / 2, y: H - 8, 'text-anchor': 'middle' }, 'joint');
  make(svg, 'text', { class: 'axis', transform: `translate(13,${(TOP + BOTTOM) / 2}) rotate(-90)`, 'text-anchor': 'middle' }, 'RMS error, N m');
  offer(box, `cause${+box.dataset.cause + 1}-gain`, ['joint', 'without', 'with', 'noise'], () => before.map((v, j) => [j + 1, v, after[j], data.noise[j]]));
  if (cause.curve) {
    const { over, x, measured, explained } = cause.curve;
    offer(box, `cause${+box.dataset.cause + 1}`, [over, 'error', 'explained'], () => x.map((v, i) => [v, measured[i], explained[i]]));
  }
});

// Measured torque above, error below, one plot per joint.
data.curves.forEach((curve, j) => {
  const box = document.getElementById('curves'), W = 560, H = 250, LEFT = 54, RIGHT = W - 8, svg = canvas(box, W, H, `joint ${j + 1}`);
  if (!curve.t.length) return;
  const steps = curve.t.slice(1).map((t, i) => t - curve.t[i]).sort((a, b) => a - b), gap = 3 * (steps[steps.length >> 1] || 1);
  const panel = (top, bottom, names, up, bare) => {
    const at = frame(svg, { left: LEFT, right: RIGHT, top, bottom, x: reach([curve.t]), y: room(reach(names.map(n => curve[n]))), up, bare });
    names.forEach(name => line(svg, name, at, curve.t, curve[name], gap));
  };
  panel(20, 112, ['measured'], 4, true);
  panel(124, 226, ['before', 'after'], 4, false);
  make(svg, 'text', { class: 'title', x: LEFT, y: 13 }, `joint ${j + 1}`);
  make(svg, 'text', { x: RIGHT, y: 13, 'text-anchor': 'end' }, 'torque above, error below; N m over s');
});

offer(document.getElementById('curves'), 'validation', ['joint', 't', 'torque', 'error_before', 'error_after'],
  () => data.curves.flatMap((c, j) => c.t.map((t, i) => [j + 1, t, c.measured[i], c.before[i], c.after[i]])));

// Small multiples: one row per joint, the same height of axis for all means of a joint.
data.maps.forEach((maps, j) => {
  const row = document.createElement('div');
  row.className = 'maps';
  document.getElementById('maps').appendChild(row);
  // Amplitudes and root mean squares have no sign, and an axis of their own.
  const sizes = /^(frequency|periods|with the motion|shift)/;
  const means = maps.filter(m => !sizes.test(m.over));
  const shared = room(reach(means.flatMap(m => [m.before, m.after]), true));
  maps.forEach((map, k) => {
    const W = 280, H = 200, LEFT = 52, RIGHT = W - 6, TOP = 22, BOTTOM = H - 38, svg = canvas(row, W, H, `joint ${j + 1}, ${map.over}`);
    const spectrum = sizes.test(map.over);
    const y = spectrum ? [0, 1.06 * reach([map.before, map.after], true)[1]] : shared;
    const at = frame(svg, { left: LEFT, right: RIGHT, top: TOP, bottom: BOTTOM, x: reach([map.x]), y, across: 3, up: 4 });
    line(svg, 'before', at, map.x, map.before);
    line(svg, 'after', at, map.x, map.after);
    if (!k) make(svg, 'text', { class: 'title', x: LEFT, y: 14 }, `joint ${j + 1}, N m`);
    if (spectrum) make(svg, 'text', { class: 'axis', x: LEFT, y: 14 }, /^(frequency|periods)/.test(map.over) ? 'amplitude, N m' : 'RMS, N m');
    make(svg, 'text', { class: 'axis', x: (LEFT + RIGHT) / 2, y: H - 6, 'text-anchor': 'middle' }, map.over);
  });
});
offer(document.getElementById('maps'), 'maps', ['joint', 'over', 'x', 'before', 'after'],
  () => data.maps.flatMap((maps, j) => maps.flatMap(m => m.x.map((x, i) => [j + 1, m.over, x, m.before[i], m.after[i]]))));
