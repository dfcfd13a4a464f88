// What PrusaSlicer makes of a tier's solid.
const fs = require('fs');
const { spawnSync } = require('child_process');
const { readMoves, sum } = require('./read_gcode');

function slicer(args) {
  const run = spawnSync('prusa-slicer', ['--loglevel', '1', ...args], { encoding: 'utf8', maxBuffer: 1 << 28 });
  if (run.status !== 0) throw new Error(`prusa-slicer ${args.join(' ')}: ${run.stderr || run.error}`);
  return run.stdout + run.stderr;
}

// Of each object in a file: {manifold, parts, facets}.
function objectsIn(file) {
  const text = slicer(['--info', file]);
  const all = (key) => [...text.matchAll(new RegExp(`^${key} = +(\\S+)`, 'gm'))].map((match) => match[1]);
  const parts = all('number_of_parts');
  return all('manifold').map((manifold, n) => ({ manifold: manifold === 'yes', parts: Number(parts[n]) }));
}

// Moves that lay a tier, 100 % full. settings: {bed, nozzle, filament, lineWidth, passHeight}, mm, and the
// generator of perimeters, 'classic' or 'arachne'.
function slice(stl, gcode, settings) {
  const [x, y] = settings.bed;
  slicer([
    '--export-gcode', '--dont-arrange', '--output', gcode, '--bed-shape', `0x0,${x}x0,${x}x${y},0x${y}`,
    '--layer-height', settings.passHeight, '--first-layer-height', settings.passHeight, '--nozzle-diameter', settings.nozzle,
    '--filament-diameter', settings.filament, '--extrusion-width', settings.lineWidth,
    '--first-layer-extrusion-width', settings.lineWidth, '--fill-density', '100%', '--fill-pattern', 'rectilinear',
    '--perimeter-generator', settings.generator, '--skirts', '0', '--start-gcode', 'M83', '--end-gcode', 'M84', '--use-relative-e-distances', '--layer-gcode', 'G92 E0',
    stl].map(String));
  return readMoves(gcode).moves;
}

// Middle lines of struts, from what G-code of morphgrid says of hubs: [{from, to}].
function axesOf(moves) {
  const hubs = new Map();
  for (const { name, to } of moves) {
    const [, i, j] = /^hub (\d+) (\d+)$/.exec(name) ?? [];
    if (i === undefined) continue;
    const hub = hubs.get(`${i} ${j}`) ?? { x: 0, y: 0, count: 0 };
    hubs.set(`${i} ${j}`, { x: hub.x + to[0], y: hub.y + to[1], count: hub.count + 1 });
  }
  const at = (i, j) => {
    const hub = hubs.get(`${i} ${j}`);
    return hub && [hub.x / hub.count, hub.y / hub.count];
  };
  const axes = [];
  for (const place of hubs.keys()) {
    const [i, j] = place.split(' ').map(Number);
    for (const other of [at(i + 1, j), at(i, j + 1)]) if (other) axes.push({ from: at(i, j), to: other });
  }
  return axes;
}

// Which share of what lies in struts, between hubs, is laid within 30 degrees of their direction.
function shareAlong(moves, axes, { hub, width }) {
  let along = 0, all = 0;
  const lines = axes.map(({ from, to }) => {
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
    return { from, length, x: (to[0] - from[0]) / length, y: (to[1] - from[1]) / length };
  });
  for (const move of moves) {
    const x = (move.from[0] + move.to[0]) / 2, y = (move.from[1] + move.to[1]) / 2;
    for (const line of lines) {
      const distance = (x - line.from[0]) * line.x + (y - line.from[1]) * line.y;
      if (distance < hub / 2 || distance > line.length - hub / 2) continue;
      if (Math.abs((x - line.from[0]) * line.y - (y - line.from[1]) * line.x) > width / 2) continue;
      const cosine = ((move.to[0] - move.from[0]) * line.x + (move.to[1] - move.from[1]) * line.y) / move.length;
      all += move.length;
      if (Math.abs(cosine) > Math.cos(Math.PI / 6)) along += move.length;
      break;
    }
  }
  return along / all;
}

const filamentOf = (moves) => sum(moves, (move) => move.filament);

module.exports = { objectsIn, slice, axesOf, shareAlong, filamentOf };
