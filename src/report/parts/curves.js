// One plot per joint: torque above, residual below. W x H in the SVG's own units.
const W = 560, H = 250, LEFT = 48, RIGHT = 8, TOP = 20, SPLIT = 168, LOWER = 180, BOTTOM = 226;
const sum = steps => { let total = 0; return steps.map(step => total += step); };
const drawLog = (box, packed) => {
  const unpack = joint => ({
    step: joint.step, measured: joint.measured.map(sum), estimated: joint.estimated.map(sum), residual: joint.residual.map(sum),
  });
  const trace = { segment: sum(packed.segment), joints: packed.joints.map(unpack) };
  const time = sum(packed.time).map(t => t / 1e4);
  const end = time[time.length - 1] || 1;
  let view = [time[0] || 0, end];
  const plots = [];
  trace.joints.forEach((joint, index) => {
    const svg = make(box, 'svg', { viewBox: `0 0 ${W} ${H}`, role: 'img', 'aria-label': `joint ${index + 1}` });
    plots.push({ svg, joint, index });
  });
  const first = at => { let a = 0, b = time.length; while (a < b) { const m = (a + b) >> 1; time[m] < at ? a = m + 1 : b = m; } return a; };
  const x = t => LEFT + (t - view[0]) / (view[1] - view[0]) * (W - LEFT - RIGHT);
  const redraw = () => plots.forEach(plot => {
    const { svg, joint, index } = plot;
    svg.replaceChildren();
    const from = Math.max(0, first(view[0]) - 1), to = Math.min(time.length, first(view[1]) + 1);
    // As few points as the width shows: least and largest per half unit.
    const bucket = Math.max(1, Math.floor((to - from) / (2 * (W - LEFT - RIGHT))));
    const reach = curves => {
      let low = Infinity, high = -Infinity;
      for (const curve of curves) for (const side of curve) for (let i = from; i < to; i++) { low = Math.min(low, side[i]); high = Math.max(high, side[i]); }
      if (!(high > low)) { low -= 1; high += 1; }
      const room = 0.05 * (high - low);
      return [(low - room) * joint.step, (high + room) * joint.step];
    };
    const panel = (top, bottom, curves, count) => {
      const [low, high] = reach(curves.map(c => joint[c]));
      const y = v => bottom - (v - low) / (high - low) * (bottom - top);
      const grid = ticks(low, high, count), isZero = v => Math.abs(v) < 1e-12;
      // Where the text is large beside the panel a number gives way to zero's, and to the time's.
      const room = v => isZero(v) || (y(v) < bottom - 3 && !grid.all.some(w => isZero(w) && Math.abs(y(v) - y(w)) < 18));
      for (const v of grid.all) {
        make(svg, 'line', { class: isZero(v) ? 'zero' : 'grid', x1: LEFT, x2: W - RIGHT, y1: y(v), y2: y(v) });
        if (bottom - top > 100 || room(v)) make(svg, 'text', { x: LEFT - 5, y: y(v) + 4, 'text-anchor': 'end' }, v.toFixed(grid.places));
      }
      for (const name of curves) {
        const sides = joint[name];
        let d = '', segment = null;
        for (let i = from; i < to; i += bucket) {
          let low = Infinity, high = -Infinity;
          const last = Math.min(i + bucket, to);
          for (let k = i; k < last; k++) { low = Math.min(low, sides[0][k]); high = Math.max(high, sides[sides.length - 1][k]); }
          const px = x(time[i]).toFixed(1);
          d += (trace.segment[i] === segment ? 'L' : 'M') + px + ' ' + y(low * joint.step).toFixed(1);
          if (high > low) d += 'L' + px + ' ' + y(high * joint.step).toFixed(1);
          segment = trace.segment[i];
        }
        make(svg, 'path', { class: name, d, 'clip-path': `inset(0)` });
      }
    };
    const grid = ticks(view[0], view[1], 7);
    for (const t of grid.all) {
      make(svg, 'line', { class: 'grid', x1: x(t), x2: x(t), y1: TOP, y2: BOTTOM });
      make(svg, 'text', { x: x(t), y: BOTTOM + 14, 'text-anchor': 'middle' }, t.toFixed(grid.places));
    }
    panel(TOP, SPLIT, ['measured', 'estimated'], 5);
    panel(LOWER, BOTTOM, ['residual'], 3);
    make(svg, 'text', { class: 'title', x: LEFT, y: 13 }, `joint ${index + 1}`);
    plot.label = make(svg, 'text', { x: W - RIGHT, y: 13, 'text-anchor': 'end' }, '');
    plot.line = make(svg, 'line', { class: 'hover', x1: 0, x2: 0, y1: TOP, y2: BOTTOM, visibility: 'hidden' });
    plot.select = make(svg, 'rect', { class: 'select', x: 0, y: TOP, width: 0, height: BOTTOM - TOP, visibility: 'hidden' });
  });
  const middle = (sides, i, step) => (sides[0][i] + sides[sides.length - 1][i]) / 2 * step;
  let start = null;
  const at = event => {
    const r = event.currentTarget.getBoundingClientRect();
    const px = Math.min(W - RIGHT, Math.max(LEFT, (event.clientX - r.left) / r.width * W));
    return view[0] + (px - LEFT) / (W - LEFT - RIGHT) * (view[1] - view[0]);
  };
  const hover = t => plots.forEach(plot => {
    const i = Math.min(time.length - 1, first(t)), j = plot.joint;
    plot.line.setAttribute('x1', x(time[i]));
    plot.line.setAttribute('x2', x(time[i]));
    plot.line.setAttribute('visibility', 'visible');
    const value = name => middle(j[name], i, j.step).toPrecision(4);
    plot.label.textContent = `${time[i].toFixed(3)} s: ${value('measured')} measured, ${value('estimated')} estimated, ${value('residual')} left`;
  });
  plots.forEach(plot => {
    plot.svg.addEventListener('pointerdown', e => { start = at(e); plot.svg.setPointerCapture(e.pointerId); });
    plot.svg.addEventListener('pointermove', e => {
      const t = at(e);
      hover(t);
      if (start !== null) plots.forEach(p => {
        p.select.setAttribute('x', x(Math.min(start, t)));
        p.select.setAttribute('width', Math.abs(x(t) - x(start)));
        p.select.setAttribute('visibility', 'visible');
      });
    });
    plot.svg.addEventListener('pointerup', e => {
      const t = at(e);
      if (start !== null && Math.abs(x(t) - x(start)) > 5) view = [Math.min(start, t), Math.max(start, t)];
      start = null;
      redraw();
    });
    plot.svg.addEventListener('dblclick', () => { view = [time[0], end]; redraw(); });
    plot.svg.addEventListener('pointerleave', () => plots.forEach(p => { p.line.setAttribute('visibility', 'hidden'); p.label.textContent = ''; }));
  });
  redraw();
  const names = ['measured', 'estimated', 'residual'];
  offer(box, 'torques', ['t', 'segment', ...plots.flatMap(plot => names.map(name => name + (plot.index + 1)))],
    () => time.map((t, i) => [t, trace.segment[i], ...plots.flatMap(({ joint }) => names.map(name => middle(joint[name], i, joint.step)))]));
};
document.querySelectorAll('.plots').forEach(box => drawLog(box, data.traces[+box.dataset.trace]));

// Heat map: blue is positive, red negative, white zero; without the parameters that have no estimate.
(() => {
  const box = document.getElementById('correlation'), all = data.names.length;
  const shown = data.names.map((_, i) => i).filter(i => data.correlation[i * all + i] !== null);
  const names = shown.map(i => data.names[i]), n = names.length;
  if (!n) return box.remove();
  const at = (i, k) => data.correlation[shown[i] * all + shown[k]] / 100;
  offer(box, 'correlation', ['', ...names], () => names.map((name, i) => [name, ...names.map((_, k) => at(i, k))]));
  const cell = Math.max(10, Math.min(24, 640 / n)), left = 56, top = 52, size = n * cell;
  const svg = make(box, 'svg', { viewBox: `0 0 ${left + size + 10} ${top + size + 24}`, role: 'img', 'aria-label': 'correlation' });
  box.style.maxWidth = `${left + size + 10}px`;
  const colour = c => {
    const w = Math.min(1, Math.abs(c) / 100), mix = (a, b) => Math.round(a + (b - a) * w);
    return c >= 0 ? `rgb(${mix(255, 0)},${mix(255, 90)},${mix(255, 160)})` : `rgb(${mix(255, 190)},${mix(255, 60)},${mix(255, 30)})`;
  };
  const label = make(svg, 'text', { class: 'big', x: left, y: top + size + 17 }, '');
  names.forEach((row, i) => {
    make(svg, 'text', { x: left - 4, y: top + (i + 0.7) * cell, 'text-anchor': 'end' }, row);
    make(svg, 'text', { transform: `translate(${left + (i + 0.7) * cell},${top - 4}) rotate(-90)` }, row);
    names.forEach((column, k) => {
      const c = data.correlation[shown[i] * all + shown[k]];
      const rect = make(svg, 'rect', { x: left + k * cell, y: top + i * cell, width: cell - 0.5, height: cell - 0.5, fill: colour(c) });
      const text = `${row}, ${column}: ${(c / 100).toFixed(2)}`;
      rect.addEventListener('pointerenter', () => { label.textContent = text; });
    });
  });
})();
