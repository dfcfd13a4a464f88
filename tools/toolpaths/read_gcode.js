// What two parsers of others make of G-code: npm's gcode-parser and gcode-toolpath. Knows nothing of who wrote
// it but the comments "; strut u i j along", "; hub i j" and their like. Lengths in mm.
const fs = require('fs');
const { parseLine } = require('gcode-parser');
const Toolpath = require('gcode-toolpath');

// {moves, travel, heights, low, high, straight, rapid}: moves that lay something, each {from, to, z, length, filament, pass, type,
// name}; pass counts from 0, -1 before the first. filament is a
// length. straight: the length of all G1; rapid: of G0.
function readMoves(file) {
  const position = { X: 0, Y: 0, Z: 0 };
  const read = { moves: [], travel: [], heights: new Set(), low: [Infinity, Infinity], high: [-Infinity, -Infinity], straight: 0, rapid: 0 };
  let isRelative = false, e = 0, pass = -1, name = '', type = '';
  for (const line of fs.readFileSync(file, 'utf8').split('\n')) {
    if (line.startsWith(';LAYER_CHANGE')) pass += 1;
    else if (line.startsWith(';TYPE:')) type = line.slice(6).trim();
    else if (line.startsWith('; ') && !line.includes('=')) name = line.slice(2);
    if (line.startsWith(';')) continue;
    const { words } = parseLine(line);
    if (!words.length) continue;
    const command = words[0][0] + words[0][1];
    const values = Object.fromEntries(words.slice(1));
    if (command === 'M83') isRelative = true;
    if (command === 'M82') isRelative = false;
    if (command === 'G92') e = values.E ?? e;
    if (command !== 'G0' && command !== 'G1') continue;
    const from = [position.X, position.Y];
    for (const axis of 'XYZ') position[axis] = values[axis] ?? position[axis];
    const filament = values.E === undefined ? 0 : isRelative ? values.E : values.E - e;
    if (!isRelative) e = values.E ?? e;
    const to = [position.X, position.Y];
    const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
    if (length === 0) continue;
    read[command === 'G1' ? 'straight' : 'rapid'] += length;
    const move = { from, to, z: position.Z, length, filament, pass, type, name };
    if (!(filament > 0)) {
      read.travel.push(move);
      continue;
    }
    read.moves.push(move);
    if (pass >= 0) read.heights.add(position.Z);
    for (const point of [from, to]) {
      for (const axis of [0, 1]) {
        read.low[axis] = Math.min(read.low[axis], point[axis]);
        read.high[axis] = Math.max(read.high[axis], point[axis]);
      }
    }
  }
  return read;
}

// The same length by the other parser.
function straightByToolpath(file) {
  let straight = 0;
  const toolpath = new Toolpath({
    addLine: (modal, from, to) => {
      if (modal.motion === 'G1') straight += Math.hypot(to.x - from.x, to.y - from.y);
    },
  });
  toolpath.loadFromStringSync(fs.readFileSync(file, 'utf8'), () => {});
  return straight;
}

const sum = (moves, value) => moves.reduce((total, move) => total + value(move), 0);

module.exports = { readMoves, straightByToolpath, sum };
