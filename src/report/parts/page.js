'use strict';
const data = JSON.parse(document.getElementById('data').textContent);
const NS = 'http://www.w3.org/2000/svg';
const make = (parent, name, attributes, text) => {
  const node = document.createElementNS(NS, name);
  for (const key in attributes) node.setAttribute(key, attributes[key]);
  if (text !== undefined) node.textContent = text;
  parent.appendChild(node);
  return node;
};
// Round values between the two, some `count` of them; how many decimals they need, and how they are written.
const ticks = (low, high, count) => {
  const raw = (high - low) / count, power = 10 ** Math.floor(Math.log10(raw));
  const step = power * [1, 2, 5, 10].find(m => m * power >= raw * (1 - 1e-9));
  const all = [];
  for (let k = Math.ceil(low / step); k * step <= high; k++) all.push(k * step);
  const places = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  return { all, places, text: v => places > 5 || Math.abs(high) >= 1e6 ? v.toExponential(1) : v.toFixed(places) };
};
// A link that saves the numbers of a plot as CSV.
const offer = (box, name, header, rows) => {
  const link = document.createElement('a');
  Object.assign(link, { className: 'save', textContent: `numbers: ${name}.csv`, href: '#', download: `${name}.csv` });
  const cell = v => v === null || v === undefined ? '' : typeof v === 'number' ? v : `"${String(v).replaceAll('"', '""')}"`;
  link.addEventListener('click', () => {
    const lines = [header, ...rows()].map(row => row.map(cell).join(','));
    link.href = URL.createObjectURL(new Blob([lines.join('\n') + '\n'], { type: 'text/csv' }));
  });
  box.after(link);
};
