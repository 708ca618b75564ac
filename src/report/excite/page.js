// One plot per joint, everything in percent of its limit.
const W = 560, H = 220, LEFT = 44, RIGHT = 8, TOP = 20, BOTTOM = 198;
const end = data.time[data.time.length - 1] || 1;
const lines = [];
data.joints.forEach((joint, index) => {
  const svg = make(document.getElementById('joints'), 'svg', { viewBox: `0 0 ${W} ${H}`, role: 'img', 'aria-label': joint.name });
  const x = t => LEFT + t / end * (W - LEFT - RIGHT), y = p => (TOP + BOTTOM) / 2 - p / 110 * (BOTTOM - TOP) / 2;
  for (const p of [-50, 0, 50]) make(svg, 'line', { class: p ? 'grid' : 'zero', x1: LEFT, x2: W - RIGHT, y1: y(p), y2: y(p) });
  for (const p of [-100, 100]) make(svg, 'line', { class: 'limit', x1: LEFT, x2: W - RIGHT, y1: y(p), y2: y(p) });
  for (const p of [-100, 0, 100]) make(svg, 'text', { x: LEFT - 5, y: y(p) + 4, 'text-anchor': 'end' }, `${p}`);
  const grid = ticks(0, end, 7);
  for (const t of grid.all) make(svg, 'text', { x: x(t), y: BOTTOM + 16, 'text-anchor': 'middle' }, t.toFixed(grid.places));
  const middle = (joint.position[0] + joint.position[1]) / 2, half = (joint.position[1] - joint.position[0]) / 2;
  const share = {
    ddq: v => v / joint.acceleration, dq: v => v / joint.velocity, tau: v => v / joint.torque, q: v => (v - middle) / half,
  };
  for (const name of ['ddq', 'dq', 'tau', 'q']) {
    if (name === 'tau' && !joint.torque) continue;
    const d = joint[name].map((v, i) => `${i ? 'L' : 'M'}${x(data.time[i]).toFixed(1)} ${y(100 * share[name](v)).toFixed(1)}`).join('');
    make(svg, 'path', { class: name, d });
  }
  make(svg, 'text', { class: 'title', x: LEFT, y: 13 }, joint.name || `joint ${index + 1}`);
  const label = make(svg, 'text', { x: W - RIGHT, y: 13, 'text-anchor': 'end' }, '');
  const cursor = make(svg, 'line', { class: 'hover', x1: 0, x2: 0, y1: TOP, y2: BOTTOM, visibility: 'hidden' });
  lines.push({ cursor, x });
  svg.addEventListener('pointermove', event => {
    const box = svg.getBoundingClientRect();
    const t = Math.min(end, Math.max(0, ((event.clientX - box.left) / box.width * W - LEFT) / (W - LEFT - RIGHT) * end));
    const i = Math.min(data.time.length - 1, Math.round(t / end * (data.time.length - 1)));
    const torque = joint.torque ? `  tau ${joint.tau[i].toFixed(1)}` : '';
    label.textContent = `${data.time[i].toFixed(2)} s  q ${joint.q[i].toFixed(2)}  dq ${joint.dq[i].toFixed(2)}  ddq ${joint.ddq[i].toFixed(2)}${torque}`;
    setMoment(t);
  });
});

offer(document.getElementById('joints'), 'motion', ['t', ...data.joints.flatMap((_, j) => ['q', 'dq', 'ddq', ...(data.joints[j].torque ? ['tau'] : [])].map(n => n + (j + 1)))],
  () => data.time.map((t, i) => [t, ...data.joints.flatMap(joint => [joint.q[i], joint.dq[i], joint.ddq[i], ...(joint.torque ? [joint.tau[i]] : [])])]));

// History: one line per start.
(() => {
  const all = data.history.filter(r => isFinite(r[1]));
  if (!all.length) return;
  const svg = make(document.getElementById('history'), 'svg', { viewBox: '0 0 800 260', role: 'img', 'aria-label': 'history' });
  const sorted = all.map(r => r[1]).sort((a, b) => a - b);
  const log = data.criterion === 'cond' || data.criterion === 'trace' || data.criterion === 'smallest';
  const scale = v => log ? Math.log10(v) : v;
  const low = scale(sorted[0]), high = scale(sorted[Math.floor(0.97 * (sorted.length - 1))]) + 1e-9;
  const longest = {};
  all.forEach(r => { longest[r[0]] = (longest[r[0]] || 0) + 1; });
  const most = Math.max(2, ...Object.values(longest));
  const x = k => 70 + k / (most - 1) * 720, y = v => 225 - (Math.min(scale(v), high) - low) / (high - low || 1) * 210;
  const grid = log ? [sorted[0], sorted[Math.floor(sorted.length / 2)], 10 ** high] : ticks(low, high, 5).all;
  for (const v of grid) {
    make(svg, 'line', { class: 'grid', x1: 70, x2: 790, y1: y(v), y2: y(v) });
    make(svg, 'text', { x: 64, y: y(v) + 4, 'text-anchor': 'end' }, Number(v.toPrecision(4)));
  }
  for (const k of ticks(0, most - 1, 8).all) make(svg, 'text', { x: x(k), y: 246, 'text-anchor': 'middle' }, k);
  const step = {}, last = {};
  all.forEach(([start, value, feasible]) => {
    const k = step[start] = (step[start] ?? -1) + 1, here = [x(k), y(value)];
    if (last[start]) make(svg, 'path', { class: 'q', opacity: feasible ? 0.9 : 0.2, d: `M${last[start]}L${here}` });
    last[start] = here;
  });
})();

// The arm, seen from an angle that can be turned.
let setMoment = () => {};
(() => {
  const box = document.getElementById('arm');
  const canvas = document.createElement('canvas'), bar = document.createElement('div');
  bar.className = 'bar';
  const button = document.createElement('button'), slider = document.createElement('input'), clock = document.createElement('span');
  button.textContent = 'Play';
  Object.assign(slider, { type: 'range', min: 0, max: data.moments.length - 1, value: 0 });
  bar.append(button, slider, clock);
  box.append(canvas, bar);
  canvas.width = 880; canvas.height = 660;
  const c = canvas.getContext('2d');
  let turn = 0.7, lift = 0.35, at = 0, playing = false;
  let low = [-0.2, -0.2, 0], high = [0.2, 0.2, 0.3];
  for (const [points, balls] of data.figures) for (const list of [points, balls]) list.forEach((v, i) => {
    low[i % 3] = Math.min(low[i % 3], v); high[i % 3] = Math.max(high[i % 3], v);
  });
  const center = low.map((v, i) => (v + high[i]) / 2), size = Math.hypot(...low.map((v, i) => high[i] - v)) || 1;
  const zoom = 760 / size;
  const project = ([x, y, z]) => {
    const [a, b, h] = [x - center[0], y - center[1], z - center[2]];
    const u = Math.cos(turn) * a + Math.sin(turn) * b, w = -Math.sin(turn) * a + Math.cos(turn) * b;
    return [440 + zoom * u, 330 - zoom * (Math.cos(lift) * h + Math.sin(lift) * w), -Math.cos(lift) * w + Math.sin(lift) * h];
  };
  const stroke = (points, colour, width) => {
    c.beginPath();
    points.forEach((p, i) => { const [x, y] = project(p); if (i) c.lineTo(x, y); else c.moveTo(x, y); });
    c.strokeStyle = colour; c.lineWidth = width; c.stroke();
  };
  const triples = list => { const all = []; for (let i = 0; i < list.length; i += 3) all.push(list.slice(i, i + 3)); return all; };
  const path = triples(data.figures.flatMap(f => f[0].slice(-3)));
  const tone = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const draw = () => {
    c.clearRect(0, 0, 880, 660);
    const z = data.ground ?? 0, reach = Math.ceil(size / 2 / 0.2) * 0.2;
    for (let k = -reach; k <= reach + 1e-9; k += 0.2) {
      stroke([[k, -reach, z], [k, reach, z]], tone('--line'), 1);
      stroke([[-reach, k, z], [reach, k, z]], tone('--line'), 1);
    }
    for (const [a, b] of data.boxes) {
      const corner = k => [k & 1 ? b[0] : a[0], k & 2 ? b[1] : a[1], k & 4 ? b[2] : a[2]];
      for (let k = 0; k < 8; k++) for (const bit of [1, 2, 4]) if (!(k & bit)) stroke([corner(k), corner(k | bit)], '#b34700', 1.5);
    }
    for (const line of data.outlines ?? []) stroke(line, '#b34700', 1.5);
    stroke(path, '#0072b255', 1);
    const [points, balls] = data.figures[at];
    const spheres = triples(balls).map((p, i) => ({ p: project(p), r: data.radii[i] })).sort((a, b) => a.p[2] - b.p[2]);
    for (const { p, r } of spheres) {
      const glow = c.createRadialGradient(p[0] - 0.3 * r * zoom, p[1] - 0.3 * r * zoom, 0, p[0], p[1], r * zoom);
      glow.addColorStop(0, '#ffffffcc'); glow.addColorStop(1, '#0072b255');
      c.beginPath(); c.arc(p[0], p[1], r * zoom, 0, 7); c.fillStyle = glow; c.fill();
      c.strokeStyle = '#0072b266'; c.lineWidth = 1; c.stroke();
    }
    const bones = [[0, 0, 0], ...triples(points)];
    stroke(bones, tone('--ink'), 5);
    for (const p of bones) { const [x, y] = project(p); c.beginPath(); c.arc(x, y, 5, 0, 7); c.fillStyle = '#d55e00'; c.fill(); }
    clock.textContent = `${data.moments[at].toFixed(2)} s`;
    slider.value = at;
    for (const { cursor, x } of lines) {
      cursor.setAttribute('x1', x(data.moments[at])); cursor.setAttribute('x2', x(data.moments[at])); cursor.setAttribute('visibility', 'visible');
    }
  };
  setMoment = t => { if (!playing) { at = Math.min(data.moments.length - 1, Math.round(t / end * (data.moments.length - 1))); draw(); } };
  slider.addEventListener('input', () => { at = +slider.value; draw(); });
  let begun = 0;
  const frame = now => {
    if (!playing) return;
    const t = ((now - begun) / 1000) % (data.moments[data.moments.length - 1] + 0.5);
    at = Math.min(data.moments.length - 1, Math.floor(t / end * data.moments.length));
    draw();
    requestAnimationFrame(frame);
  };
  button.addEventListener('click', () => {
    playing = !playing; button.textContent = playing ? 'Stop' : 'Play';
    if (playing) { begun = performance.now() - data.moments[at] * 1000; requestAnimationFrame(frame); }
  });
  let grip = null;
  canvas.addEventListener('pointerdown', e => { grip = [e.clientX, e.clientY, turn, lift]; canvas.setPointerCapture(e.pointerId); });
  canvas.addEventListener('pointermove', e => {
    if (!grip) return;
    turn = grip[2] - (e.clientX - grip[0]) / 150;
    lift = Math.max(-0.2, Math.min(1.5, grip[3] + (e.clientY - grip[1]) / 200));
    draw();
  });
  canvas.addEventListener('pointerup', () => { grip = null; });
  draw();
})();
