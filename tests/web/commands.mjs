// The command for Node prints what the program prints, byte for byte: inspect, plan, check, and the files of export. Arguments:
// the program, the tarball. All scenes with SHADESCOPE_LONG=1.
import { execFileSync, spawnSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import zlib from 'node:zlib';
import { fileURLToPath } from 'node:url';
import { unpack } from './both.mjs';
import { expect, folder } from './claims.mjs';

const [program, tarball] = process.argv.slice(2), { command, bothSay } = unpack(program, tarball);
const scenes = fileURLToPath(new URL('../../resources/scenes/', import.meta.url)), isLong = process.env.SHADESCOPE_LONG === '1';
const some = isLong ? fs.readdirSync(scenes).filter(name => /\.(toml|scene)$/.test(name)) : ['pyramid.scene', 'flat_gouraud_phong.toml', 'box_over_plane.scene'];

for (const scene of some) {
  const small = [scene, '--size', '160x120'];
  for (const args of [['plan', ...small], ['plan', ...small, '--json'], ['plan', ...small, '--counts', '--json'], ['plan', ...small, '--buffers', 'color,normal', '--counts'],
    ['inspect', ...small, '--pixel', '80,70'], ['inspect', ...small, '--pixel', '80,70', '--json'], ['inspect', ...small, '--pixel', '80,70', '--format', 'latex'], ['inspect', ...small, '--table', 'vertices'], ['inspect', ...small, '--table', 'polygons', '--format', 'csv'],
    ['inspect', ...small, '--where', 'n_dot_l.0 < 0.5'], ['inspect', ...small, '--where', 'n_dot_l.0 < 0.5', '--json'], ['inspect', ...small, '--row', '70'], ['inspect', ...small, '--row', '70', '--json'], ['inspect', ...small, '--contracts'], ['inspect', ...small, '--contracts', '--json'],
    ['inspect', ...small, '--step', 'z-buffer/polygon=1'], ['inspect', ...small, '--step', 'z-buffer/polygon=1', '--json']])
    bothSay(args.join(' '), args, scenes);
}
// What is wrong with the options.
for (const args of [['plan', 'pyramid.scene', '--buffers', 'colr'], ['plan', 'pyramid.scene', '--until', 'z_buffer'], ['inspect', 'pyramid.scene', '--pixel', '9999,1'], ['inspect', 'pyramid.scene', '--pixel', 'x'], ['inspect', 'pyramid.scene', '--row', '9999'], ['inspect', 'pyramid.scene', '--where', 'n_dot_l.0 <'],
  ['inspect', 'pyramid.scene', '--step', 'nowhere'], ['inspect', 'pyramid.scene', '--row', '7', '--format', 'latex'].slice(0, 4), ['check', '--case', 'S999'], ['check', '--group', 'shadows'], ['plan', 'pyramid.scene', '--set', 'colour=1'], ['plan', 'pyramid.scene', '--set', 'width=-4']])
  bothSay(args.join(' '), args, scenes);
// Cases, but for their times. Long double has 64 bits in the program and 113 in Node: of what is measured by it the texts are
// compared, which have two digits.
const timeless = text => text.replace(/"(milliseconds|seconds)": [0-9.e+-]+/g, '').replace(/, in [0-9.]+ s$/m, '').replace(/"(naive|ours)": [0-9.e+-]+/g, '');
for (const args of [['check', '--list'], ['check', '--list', '--json'], ['check', '--case', 'S10', '--json'], ['check', ...(isLong ? [] : ['--group', 'depth']), '--json'], ['check', '--case', 'G1', '--case', 'T14']])
  bothSay(args.join(' '), args, scenes, timeless);

/** Pixels of an RGB picture, and its texts. @param {Buffer} png */
function pixelsOf(png) {
  const parts = [], words = [];
  for (let at = 8, size; at < png.length; at += 12 + size) {
    size = png.readUInt32BE(at);
    const kind = png.toString('latin1', at + 4, at + 8), data = png.subarray(at + 8, at + 8 + size);
    if (kind === 'IDAT') parts.push(data);
    else if (kind === 'tEXt' || kind === 'IHDR') words.push(data.toString('latin1'));
  }
  const rows = zlib.inflateSync(Buffer.concat(parts)), width = png.readUInt32BE(16), stride = 3 * width, pixels = Buffer.alloc(rows.length);
  for (let from = 0, to = 0; from < rows.length; from += stride + 1, to += stride)
    for (let i = 0; i < stride; ++i)  // filters none, left and up
      pixels[to + i] = rows[from + 1 + i] + (rows[from] === 1 && i >= 3 ? pixels[to + i - 3] : rows[from] === 2 && to ? pixels[to + i - stride] : 0);
  return { pixels, words: words.join('; ') };
}

// Files of an export, and a manifest that says the same of them, but for times.
const withoutTimes = (key, value) => (/milliseconds|^run$/.test(key) ? 0 : value);
const manifestOf = name => JSON.stringify(JSON.parse(fs.readFileSync(path.join(folder, name, 'manifest.json'), 'utf8'), withoutTimes));
for (const [i, args] of [['pyramid.scene', '--format', 'npy,csv,scene', '--size', '96x72'], ['box_over_plane.scene', '--size', '64x48', '--format', 'npy', '--buffers', 'color,depth', '--set', 'precision=double'], ['pyramid.scene', '--size', '96x72', '--format', 'npy', '--at', 'z-buffer/polygon=1'], ['pyramid.scene', '--size', '96x72', '--format', 'csv', '--buffers', 'condition', '--where', 'n_dot_l.0 < 0.5']].entries()) {
  const [native, node] = ['program', 'node'].map(who => path.join(folder, who + i));
  const told = [[program], ['node', command]].map(([first, ...rest], k) => spawnSync(first, [...rest, 'export', ...args, '-o', [native, node][k]], { cwd: scenes, encoding: 'utf8' }));
  expect(`export ${args.join(' ')} says the same`, told[0].stderr.replaceAll(native, '') .replace(/, [0-9.]+ .?B,/, '') === told[1].stderr.replaceAll(node, '').replace(/, [0-9.]+ .?B,/, '') && told[0].status === 0 && told[1].status === 0, told.map(one => one.stderr));
  const [names, others] = [native, node].map(name => fs.readdirSync(name).sort().join());
  expect('and writes the same files', names === others && names.length > 10, [names, others]);
  for (const name of fs.readdirSync(native).filter(name => name !== 'manifest.json'))
    expect(`${name} has the same bytes`, fs.readFileSync(path.join(native, name)).equals(fs.readFileSync(path.join(node, name))));
  expect('the manifests say the same', manifestOf('program' + i) === manifestOf('node' + i), [manifestOf('program' + i).slice(0, 2000), manifestOf('node' + i).slice(0, 2000)]);
}
// Pictures have the program's pixels.
execFileSync(program, ['export', 'box_over_plane.scene', '--size', '64x48', '--format', 'png', '--shadow-verdicts', '-o', path.join(folder, 'native-png')], { cwd: scenes, stdio: 'ignore' });
const pictures = spawnSync('node', [command, 'export', 'box_over_plane.scene', '--size', '64x48', '--format', 'png', '--shadow-verdicts', '-o', path.join(folder, 'node-png')], { cwd: scenes, encoding: 'utf8' });
const names = fs.readdirSync(path.join(folder, 'native-png')).sort();
expect('as many pictures', pictures.status === 0 && names.length > 10 && names.join() === fs.readdirSync(path.join(folder, 'node-png')).sort().join(), pictures.stderr);
expect('shadow verdicts among them', names.includes('shadow_verdict.0.png'), names);
for (const name of names.filter(name => name.endsWith('.png'))) {
  const [native, node] = ['native-png', 'node-png'].map(where => pixelsOf(fs.readFileSync(path.join(folder, where, name))));
  expect(`${name} has the same pixels and words`, native.pixels.equals(node.pixels) && native.words === node.words, [native.words, node.words]);
}

// A study finds what the program finds, but for times. Long double, which rays are cast in, has 64 bits there and 113 here: errors
// agree in ten digits; of what is stored, held against nearly the same number, in six: the near plane of the last points is 10^4 times
// nearer than the scene.
for (const args of [['flat_gouraud_phong', '--size', '80x60', '--sweep', 'shading=all'], ['box_over_plane', '--size', '64x48', '--sweep', 'shadow'], ['pyramid', '--size', '64x48', '--sweep', 'depth']]) {
  const said = [[program, 'study', ...args, '--warm-up', '0', '--repeat', '1', '--processes', '1', '--json', '-o', path.join(folder, 'study')], ['node', command, 'study', ...args, '--warm-up', '0', '--repeat', '1', '--json']].map(([first, ...rest]) => spawnSync(first, rest, { encoding: 'utf8', maxBuffer: 1 << 26 }));
  const [native, node] = said.map(one => JSON.parse(one.stdout || '{}'));
  const without = text => JSON.stringify({ ...text, machine: 0, compiler: 0, load: 0, contents: 0, file: 0, points: 0, error_bars: 0 });
  expect(`study ${args.join(' ')} is of the same`, said.every(one => one.status === 0) && without(native) === without(node), said.map(one => one.stderr).concat(without(native), without(node)));
  const facts = point => JSON.stringify([point.number, point.values, point.failure, point.megabytes, point.counters, point.errors.map(row => [row.buffer, row.stage, row.measure, row.unit])]);
  expect('with the same points and counters', native.points.length > 1 && native.points.every((point, i) => facts(point) === facts(node.points[i])), [native.points, node.points].map(points => points?.map(facts)));
  const apart = native.points.flatMap((point, i) => point.errors.flatMap((row, k) => ['model', 'arithmetic', 'storage'].map(kind => [row[kind], node.points[i].errors[k][kind], kind === 'storage' ? 1e-6 : 1e-10, `${point.values} ${row.buffer} ${row.measure} ${kind}`]))).filter(([a, b, most]) => (a === null) !== (b === null) || Math.abs(a - b) > most * Math.max(Math.abs(a), Math.abs(b)));
  expect('and the same errors', apart.length === 0, apart.slice(0, 5));
}
for (const args of [['study', 'pyramid'], ['study', 'pyramid', '--sweep', 'nothing=1'], ['study', 'pyramid', '--sweep', 'shading=all', '--repeat', '0']]) {
  const said = spawnSync('node', [command, ...args], { encoding: 'utf8' });
  expect(`${args.join(' ')} is wrong usage`, said.status === 2 && said.stderr.length > 20, said);
}

// Models in every format, and what is wrong with some.
const points = [[0, 0, 0], [90, 0, 0], [0, 90, 0], [0, 0, 90]], faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];
const numbers = Buffer.concat([Buffer.from(new Float32Array(points.flat()).buffer), Buffer.from(new Uint16Array(faces.flat()).buffer)]);
const gltf = bytes => JSON.stringify({ asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0 }], meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
  buffers: [{ byteLength: 72, uri: 'data:application/octet-stream;base64,' + bytes.toString('base64') }], bufferViews: [{ buffer: 0, byteOffset: 0, byteLength: 48 }, { buffer: 0, byteOffset: 48, byteLength: 24 }],
  accessors: [{ bufferView: 0, componentType: 5126, count: 4, type: 'VEC3', min: [0, 0, 0], max: [90, 90, 90] }, { bufferView: 1, componentType: 5123, count: 12, type: 'SCALAR' }] });
const models = {
  'one.obj': points.map(p => `v ${p.join(' ')}\n`).join('') + faces.map(f => `f ${f.map(i => i + 1).join(' ')}\n`).join(''),
  'one.off': `OFF\n4 4 0\n${points.map(p => p.join(' ')).join('\n')}\n${faces.map(f => '3 ' + f.join(' ')).join('\n')}\n`,
  'one.ply': `ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n${points.map(p => p.join(' ')).join('\n')}\n${faces.map(f => '3 ' + f.join(' ')).join('\n')}\n`,
  'one.stl': `solid one\n${faces.map(f => `facet normal 0 0 0\nouter loop\n${f.map(i => `vertex ${points[i].join(' ')}\n`).join('')}endloop\nendfacet\n`).join('')}endsolid one\n`,
  'one.gltf': gltf(numbers),
  'bad.obj': 'v 0 0 0\nv 1 0 0\nv 0 1\nf 1 2 9\n', 'bad.off': 'OFF\n4 1 0\n0 0 0\n', 'bad.ply': 'ply\nformat ascii 1.0\nelement vertex 3000000000\nend_header\n', 'bad.stl': 'solid one\nfacet normal 0 0\n', 'bad.gltf': '{"asset": {"version": "1.0"}}', 'short.gltf': gltf(numbers.subarray(0, 50)), 'empty.toml': '', 'bad.toml': '[camera]\nrho = "far"\n',
};
for (const [name, text] of Object.entries(models)) {
  fs.writeFileSync(path.join(folder, name), text);
  bothSay(`inspect ${name}`, ['inspect', name, '--table', 'vertices', '--json'], folder);
  if (name.startsWith('one')) bothSay(`plan ${name}`, ['plan', name, '--counts'], folder);
}

// The wrong picture, every one of three seeds: played through the core as a module to its end, then the same words typed.
const { start, openScene } = await import(command), core = await start();
for (const name of fs.readdirSync(scenes)) core.ask('file', name, fs.readFileSync(path.join(scenes, name)));
for (const seed of isLong ? [7, 2026, 31337] : [7]) {
  const typed = [], said = [], pictures = isLong ? 5 : 2;
  for (let number = 0; number < pictures; ++number) {
    let state = core.ask('game', seed, number);
    const does = (words, ...call) => { state = core.ask(...call), typed.push(words), said.push(state.said.trim()); };
    said.push(state.said.trim());
    does('hint', 'game_hint'), does('look depth', 'game_look', 'depth', 0, 0), does('look 40,30', 'game_look', '', 40, 30);
    for (let box = 0; state.phase === 'stage' && box < 7; ++box) does(`mark ${box}`, 'game_mark', box);
    for (let cause = 0; state.phase === 'cause' && cause < 5; ++cause) does(String(cause + 1), 'game_name', cause);
    said.push(state.reveal.trim(), `${state.points} points: ${state.looks} look`);
    expect(`seed ${seed}, picture ${number + 1} is played to its end`, state.phase === 'over', state.phase);
  }
  const printed = spawnSync(program, ['bug', '--seed', String(seed), '--count', String(pictures)], { input: typed.join('\n') + '\n', encoding: 'utf8' }).stdout;
  let at = 0;
  const missing = said.filter(text => { const found = printed.indexOf(text, at); if (found >= 0) at = found; return found < 0; });
  expect(`seed ${seed}: words and points of the command, in their order`, missing.length === 0 && said.length > 10, missing[0]);
}

// What the program did not write stays.
fs.mkdirSync(path.join(folder, 'kept'));
fs.writeFileSync(path.join(folder, 'kept', 'color.npy'), 'mine');
const kept = spawnSync('node', [command, 'export', 'pyramid', '--size', '32x24', '-o', 'kept'], { cwd: folder, encoding: 'utf8' });
expect('a file of somebody else is not replaced', kept.status === 4 && kept.stderr.includes('--force') && fs.readFileSync(path.join(folder, 'kept', 'color.npy'), 'utf8') === 'mine', kept);
const forced = spawnSync('node', [command, 'export', 'pyramid', '--size', '32x24', '-o', 'kept', '--force'], { cwd: folder, encoding: 'utf8' });
expect('but with --force', forced.status === 0 && fs.statSync(path.join(folder, 'kept', 'color.npy')).size > 100, forced.stderr);
// As a module, as its README says.
const module = `import { start, openScene, run, written } from ${JSON.stringify(command)}; const core = await start(); openScene(core, 'pyramid', ['width=64', 'height=48']); const { files } = run(core, 'export', { folder: '.', buffers: ['color'], format: ['npy'] }); console.log(files.join(), written(core, 'color.npy').length);`;
expect('a module gives the same', execFileSync('node', ['--input-type=module', '-e', module], { encoding: 'utf8' }).trim() === `color.npy,manifest.json ${128 + 64 * 48 * 3}`);
