// node check_prints.js MORPHGRID WORK DOCUMENT CHECKOUT: called by tools/slicers.
const fs = require('fs');
const path = require('path');
const { spawnSync } = require('child_process');
const { readMoves, straightByToolpath, sum } = require('./read_gcode');
const { objectsIn, slice, axesOf, shareAlong, filamentOf } = require('./slice');
const { drawToolpaths } = require('./draw');

const [, , morphgrid, work, documentFile, checkout] = process.argv;

// What is printed; the two that docs/printing.md proposes come first.
const PRINTS = [
  { name: 'node of three tiers', scene: 'node', set: ['grid.layers=3'], print: ['--scale', '20'] },
  { name: 'strip of 12 x 2 nodes', scene: 'strip', set: ['grid.nodes_u=12', 'grid.nodes_v=2', 'grid.layers=3'], print: [], pictured: true },
  { name: 'strip', scene: 'strip', set: [], print: [] },
  { name: 'egg chair, 10 nodes long', scene: 'egg_chair_true', set: ['grid.nodes_long=10', 'grid.max_shrinkage=0.34'], print: [] },
];

const failures = [];
const check = (what, isRight) => {
  if (!isRight) failures.push(what);
};
const apart = (a, b) => Math.abs(a / b - 1);

function print({ name, scene, set, print: options }) {
  const folder = path.join(work, name.replace(/[^a-z0-9]+/g, '_'));
  const run = spawnSync(morphgrid, ['print', path.join(checkout, 'scenes', `${scene}.toml`),
    '--printer', path.join(checkout, 'printers/prusa_mk4.toml'), '--material', path.join(checkout, 'materials/pla_0.08.toml'),
    '--out', folder, '--quiet', '--stl', '--3mf', ...set.flatMap((one) => ['--set', one]), ...options], { encoding: 'utf8' });
  // 3: written, though struts are out of range.
  if (run.status !== 0 && run.status !== 3) throw new Error(`${name}: morphgrid print ended with ${run.status}\n${run.stderr}`);
  return { folder, report: JSON.parse(fs.readFileSync(path.join(folder, 'print.json'), 'utf8')) };
}

// A tier's file beside its report; how far they are apart at most.
function compareTier(name, folder, report, tier) {
  const { sizes } = report;
  const told = report.tiers[tier];
  const file = path.join(folder, `tier_${tier + 1}.gcode`);
  const read = readMoves(file);
  const inPasses = read.moves.filter((move) => move.pass >= 0);
  const where = `${name}, tier ${tier + 1}`;
  const differences = [
    apart(sum(inPasses, (move) => move.length), 1000 * told.path_m),
    apart(straightByToolpath(file), read.straight),
    apart(filamentOf(read.moves), told.filament_mm),
    apart(read.rapid, 1000 * told.travel_m),
  ];
  check(`${where}: lengths or volumes differ by ${Math.max(...differences)}`, Math.max(...differences) < 1e-3);
  const isTop = tier + 1 === report.tiers.length;
  const top = sizes.strut_height_mm + (isTop ? 0 : sizes.tube_height_mm);
  const heights = [...read.heights].sort((a, b) => a - b);
  const passes = inPasses.at(-1).pass + 1; // Low tubes go up row by row, so heights come again.
  check(`${where}: ${passes} passes, not ${told.passes}`, passes === told.passes);
  check(`${where}: ends at ${heights.at(-1)} mm, not ${top}`, Math.abs(heights.at(-1) - top) < 6e-4);
  const reach = sizes.line_width_mm / 2;
  const isOnBed = [0, 1].every((axis) => read.low[axis] >= reach && read.high[axis] <= sizes.bed_mm[axis] - reach);
  check(`${where}: beside the bed`, isOnBed);
  return { read, worst: Math.max(...differences) };
}

function compareSolids(name, folder, tiers) {
  for (let tier = 1; tier <= tiers; ++tier) {
    const objects = objectsIn(path.join(folder, `tier_${tier}.stl`));
    check(`${name}: tier_${tier}.stl is not manifold, 1 part`, objects.length === 1 && objects[0].manifold && objects[0].parts === 1);
  }
  const objects = objectsIn(path.join(folder, 'tiers.3mf'));
  check(`${name}: tiers.3mf has not ${tiers} manifold objects of 1 part`,
    objects.length === tiers && objects.every(({ manifold, parts }) => manifold && parts === 1));
}

// Of what we lay between hubs. Zigzags have links that run along the strut: names tell them apart, not directions.
function ownShareAlong(moves) {
  const struts = moves.filter((move) => move.name.startsWith('strut'));
  return filamentOf(struts.filter((move) => move.name.endsWith('along'))) / filamentOf(struts);
}

// The top tier, which has no tubes: by how much more filament each of PrusaSlicer's generators lays in it, the
// share that it lays along struts, and ours.
function compareSlicer(name, folder, report, ours) {
  const { sizes } = report;
  const solid = path.join(folder, `tier_${report.tiers.length}.stl`);
  const own = ours.moves.filter((move) => /^(strut|hub)/.test(move.name) && move.pass >= 0);
  const axes = axesOf(ours.moves);
  const where = { hub: sizes.hub_diameter_mm, width: sizes.strut_width_mm };
  const [classic, arachne] = ['classic', 'arachne'].map((generator) => {
    const moves = slice(solid, path.join(folder, `${generator}.gcode`), {
      bed: sizes.bed_mm, nozzle: sizes.nozzle_mm, filament: sizes.filament_diameter_mm,
      lineWidth: sizes.line_width_mm, passHeight: sizes.pass_height_mm, generator });
    return { filament: filamentOf(moves) / filamentOf(own) - 1, along: shareAlong(moves, axes, where) };
  });
  check(`${name}: PrusaSlicer's filament differs by ${percent(classic.filament, 1)}`, Math.abs(classic.filament) < 0.02);
  return { classic, arachne, along: ownShareAlong(own) };
}

const percent = (share, digits) => `${(100 * share).toFixed(digits)} %`;
const signed = (share) => (share >= 0 ? '+' : '') + percent(share, 1);

function row({ name, folder, report, tiers, solid }) {
  const total = (key) => sum(report.tiers, (tier) => tier[key]);
  const worst = Math.max(...tiers.map((tier) => tier.worst));
  return `| ${name} | ${report.tiers.length} | ${total('path_m').toFixed(1)} | ${total('filament_g').toFixed(1)} | ` +
    `${(total('seconds') / 3600).toFixed(1)} | ${report.struts.out_of_range.length} of ${report.struts.count} | ${worst.toExponential(0)} | ` +
    `${signed(solid.classic.filament)}; ${signed(solid.arachne.filament)} | ${percent(solid.classic.along, 0)}; ` +
    `${percent(solid.arachne.along, 0)} | ${percent(solid.along, 0)} |\n`;
}

// As withBlock() of the program.
function withBlock(document, name, content) {
  const begin = `<!-- begin ${name} -->\n`, end = `<!-- end ${name} -->\n`;
  const from = document.indexOf(begin), to = document.indexOf(end);
  if (from < 0 || to < from) throw new Error(`${documentFile} has no block ${name}`);
  return document.slice(0, from + begin.length) + content + document.slice(to);
}

function drawPictures({ report, tiers, folder }) {
  const images = path.join(path.dirname(documentFile), 'images');
  const read = tiers[0].read;
  const hub = axesOf(read.moves)[0].from;
  const reach = 2.2 * report.struts.median_mm;
  const left = hub[0] - 0.4 * reach, bottom = hub[1] - 4; // The sheet lies askew.
  const window = { low: [left, bottom], high: [left + reach, bottom + 0.75 * reach] };
  const width = report.sizes.line_width_mm;
  // The second pass is the first with rings.
  fs.writeFileSync(path.join(images, 'toolpath_corner.svg'), drawToolpaths(read, { passes: [1], window, width, pixels: 720 }));
  fs.writeFileSync(path.join(images, 'toolpath_tier.svg'), drawToolpaths(read, { passes: [1], width, pixels: 720 }));
  fs.copyFileSync(path.join(folder, 'tier_1.svg'), path.join(images, 'tier_map.svg'));
}

function main() {
  const HEADER = '| | tiers | path, m | filament, g | time, h | out of range | parsers differ by | its filament over ours | it lays along | we lay along |\n' +
    '| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n';
  let table = HEADER;
  process.stdout.write(HEADER);
  for (const one of PRINTS) {
    const { folder, report } = print(one);
    const tiers = report.tiers.map((_, tier) => compareTier(one.name, folder, report, tier));
    compareSolids(one.name, folder, report.tiers.length);
    const solid = compareSlicer(one.name, folder, report, tiers.at(-1).read);
    const line = row({ name: one.name, folder, report, tiers, solid });
    process.stdout.write(line);
    table += line;
    if (one.pictured) drawPictures({ report, tiers, folder });
  }
  for (const failure of failures) process.stderr.write(`slicers: ${failure}\n`);
  if (failures.length) process.exit(3);
  fs.writeFileSync(documentFile, withBlock(fs.readFileSync(documentFile, 'utf8'), 'slicers', table));
}

main();
