// Pictures of toolpaths, SVG, from G-code alone.

// By ;TYPE:, as viewers colour them: what it is, its colour.
const KINDS = {
  Perimeter: ['along the strut', '#c0392b'],
  'Solid infill': ['across it', '#2e86c1'],
  'External perimeter': ['hubs', '#8d6e1f'],
  'Gap fill': ['tag', '#229954'],
  'Skirt/Brim': ['skirt', '#888888'],
};

const round = (x) => String(Math.round(x * 100) / 100);

// Polylines of moves that begin where the last one ended, clipped by leaving out what lies outside.
function polylines(moves, inside) {
  const lines = [];
  let last = null;
  for (const { from, to } of moves) {
    if (!inside(from) && !inside(to)) continue;
    if (!last || last[0] !== from[0] || last[1] !== from[1]) lines.push([from]);
    lines.at(-1).push(to);
    last = to;
  }
  return lines;
}

// read: as readMoves() gives it; passes: whose moves are drawn; window: {low, high}, else all; width: of a line,
// mm; pixels: of the picture's width.
function drawToolpaths(read, { passes, window, width, pixels }) {
  const moves = read.moves.filter((move) => passes.includes(move.pass));
  const { low, high } = window ?? {
    low: [0, 1].map((axis) => Math.min(...moves.map((move) => move.to[axis])) - 2),
    high: [0, 1].map((axis) => Math.max(...moves.map((move) => move.to[axis])) + 2),
  };
  const size = [high[0] - low[0], high[1] - low[1]];
  const inside = (point) => [0, 1].every((axis) => point[axis] >= low[axis] - 3 && point[axis] <= high[axis] + 3);
  const short = (x) => x.toFixed(window ? 2 : 1); // A tenth of a mm is less than a pixel of a whole tier.
  const at = (point) => `${short(point[0] - low[0])},${short(high[1] - point[1])}`;
  const group = (chosen, colour, stroke) => {
    const d = polylines(chosen, inside).map((line) => `M${line.map(at).join(' ')}`).join('');
    return d && `<path d="${d}" stroke="${colour}" stroke-width="${round(stroke)}"/>\n`;
  };
  const unit = size[0] / 100;
  const step = 100 / 6;
  const shown = Object.entries(KINDS).filter(([type]) => moves.some((move) => move.type === type));
  const paths = shown.map(([type, [, colour]]) => group(moves.filter((move) => move.type === type), colour, 0.75 * width)); // So that lines can be told apart.
  const travel = read.travel.filter((move) => passes.includes(move.pass));
  paths.push(group(travel, '#00000066', width / 5));
  const legend = [...shown.map(([, kind]) => kind), ['travel', '#999999']].map(([text, colour], n) =>
    `<rect x="${round(unit + n * step * unit)}" y="${round(size[1] + unit)}" width="${round(2 * unit)}" height="${round(2 * unit)}" fill="${colour}"/>` +
    `<text x="${round(3.7 * unit + n * step * unit)}" y="${round(size[1] + 2.8 * unit)}">${text}</text>`).join('\n');
  const height = size[1] + 4 * unit;
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${pixels}" height="${Math.round((pixels * height) / size[0])}" ` +
    `viewBox="0 0 ${round(size[0])} ${round(height)}">\n<rect width="100%" height="100%" fill="#fff"/>\n` +
    `<svg width="${round(size[0])}" height="${round(size[1])}" viewBox="0 0 ${round(size[0])} ${round(size[1])}">\n` +
    `<g fill="none" stroke-linecap="round" stroke-linejoin="round">\n${paths.join('')}</g>\n</svg>\n` +
    `<g font-family="sans-serif" font-size="${round(1.9 * unit)}">\n${legend}\n</g>\n</svg>\n`;
}

module.exports = { drawToolpaths };
