// The wall: what is painted and how often, lanes, way points, the roller (the paper's Fig. 12, right).
(() => {
  const { sides, ends, cells, passes, cycle, spans, width } = data.wall;
  const wide = sides[1] - sides[0], high = ends[1] - ends[0];
  const room = 420, zoom = room / Math.max(wide, high, 1e-9), L = 60, T = 16;
  const W = L + wide * zoom + 90, H = T + high * zoom + 44;
  const svg = make(document.getElementById('wall'), 'svg', { viewBox: `0 0 ${W.toFixed(0)} ${H.toFixed(0)}`, role: 'img', 'aria-label': 'wall' });
  svg.style.maxWidth = `${(W / 12).toFixed(0)}rem`;
  const x = y => L + (y - sides[0]) * zoom, y = z => T + (ends[1] - z) * zoom;
  make(svg, 'rect', { class: 'bare', x: x(sides[0]), y: y(ends[1]), width: wide * zoom, height: high * zoom });
  // Runs of cells that are passed equally often, as rectangles.
  const cw = wide * zoom / cells[0], ch = high * zoom / cells[1];
  passes.forEach(([k, from, count, n, rows]) => {
    if (!n) return;
    const lanes = n / cycle;
    make(svg, 'rect', { x: (L + from * cw).toFixed(2), y: (T + (cells[1] - k - rows) * ch).toFixed(2), width: (count * cw + 0.2).toFixed(2), height: (rows * ch + 0.2).toFixed(2), fill: lanes > 1 ? '#0072b266' : '#56b4e966' });
  });
  make(svg, 'rect', { class: 'edge', fill: 'none', x: x(sides[0]), y: y(ends[1]), width: wide * zoom, height: high * zoom });
  for (const s of spans) {
    if (s.phase !== 'stroke' && s.phase !== 'shift') continue;
    make(svg, 'path', { class: s.phase, d: `M${x(s.from[0])} ${y(s.from[1])}L${x(s.to[0])} ${y(s.to[1])}` });
  }
  for (const s of spans) if (s.phase === 'stroke' || s.phase === 'shift')
    make(svg, 'circle', { cx: x(s.to[0]), cy: y(s.to[1]), r: 3.2, fill: 'var(--ink)' });
  const start = spans[0].to;
  make(svg, 'circle', { cx: x(start[0]), cy: y(start[1]), r: 5, fill: 'none', stroke: 'var(--ink)' });
  make(svg, 'path', { class: 'roller', d: `M${x(start[0] - width / 2)} ${y(start[1])}L${x(start[0] + width / 2)} ${y(start[1])}` });
  const across = ticks(sides[0], sides[1], 5), along = ticks(ends[0], ends[1], 6);
  for (const v of across.all) make(svg, 'text', { x: x(v), y: T + high * zoom + 16, 'text-anchor': 'middle' }, across.text(v));
  for (const v of along.all) make(svg, 'text', { x: L - 6, y: y(v) + 4, 'text-anchor': 'end' }, along.text(v));
  make(svg, 'text', { x: x((sides[0] + sides[1]) / 2), y: H - 8, 'text-anchor': 'middle' }, 'y, m');
  make(svg, 'text', { x: 12, y: y((ends[0] + ends[1]) / 2), 'text-anchor': 'middle', transform: `rotate(-90 12 ${y((ends[0] + ends[1]) / 2)})` }, 'z, m');
})();

// Where the roller is over time, and the swivel angle.
(() => {
  const box = document.getElementById('path');
  const draw = (curves, unit, label) => {
    const svg = make(box, 'svg', { viewBox: '0 0 900 220', role: 'img', 'aria-label': label });
    const all = curves.flatMap(c => c.values);
    let low = Math.min(...all), high = Math.max(...all);
    if (high - low < 1e-3) { low -= 0.05; high += 0.05; }
    const X = t => 60 + t / end * 830, Y = v => 190 - (v - low) / (high - low) * 170;
    const grid = ticks(low, high, 5), across = ticks(0, end, 10);
    for (const v of grid.all) {
      make(svg, 'line', { class: 'grid', x1: 60, x2: 890, y1: Y(v), y2: Y(v) });
      make(svg, 'text', { x: 54, y: Y(v) + 4, 'text-anchor': 'end' }, grid.text(v));
    }
    for (const t of across.all) make(svg, 'text', { x: X(t), y: 208, 'text-anchor': 'middle' }, across.text(t));
    make(svg, 'text', { class: 'title', x: 60, y: 12 }, `${label}, ${unit}, over s`);
    for (const { name, values } of curves)
      make(svg, 'path', { class: name, d: values.map((v, i) => `${i ? 'L' : 'M'}${X(data.time[i]).toFixed(1)} ${Y(v).toFixed(1)}`).join('') });
  };
  draw([{ name: 'y', values: data.place.y }, { name: 'z', values: data.place.z }], 'm', 'roller on the wall');
  if (data.place.swivel) draw([{ name: 'swivel', values: data.place.swivel }], 'rad', 'swivel');
  const { y, z, swivel } = data.place;
  offer(box, 'path', ['t', 'y', 'z', ...(swivel ? ['swivel'] : [])], () => data.time.map((t, i) => [t, y[i], z[i], ...(swivel ? [swivel[i]] : [])]));
})();
