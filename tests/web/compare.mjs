// Another renderer's files are judged alike everywhere: the command for Node, as it is packed, prints what the program prints,
// byte for byte. Arguments: the program, the tarball, the students' renderers in C++ and C. All of their errors with
// SHADESCOPE_LONG=1.
import { execFileSync, spawnSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { unpack } from './both.mjs';
import { expect, folder as work } from './claims.mjs';
import { fileURLToPath } from 'node:url';

const [program, tarball, cpp, c] = process.argv.slice(2);
const students = fileURLToPath(new URL('../student/', import.meta.url));
const { command, bothSay: say } = unpack(program, tarball), bothSay = (claim, args, cwd) => say(claim, ['compare', ...args], cwd);
const size = '64x48', isLong = process.env.SHADESCOPE_LONG === '1';
// Renderers that share no code with the program, each in conventions of its own.
const dark = ['--set', 'light.0.shadow=off', '--set', 'light.1.shadow=off'], near = ['--set', 'camera.near=4'];
const ways = [
  { of: ['python3', students + 'renderer.py'], scene: 'kiln', options: ['--shading', 'phong', '--no-shadow', '--near', '4', '--planes', '4,40', '--depth', 'window'], settings: [...dark, ...near, '--set', 'camera.far=40'] },
  { of: [cpp], scene: 'quay', options: ['--shading', 'phong', '--near', '4', '--planes', '4,40', '--rows', 'bottom-up', '--encoding', 'srgb'], settings: [...near, '--set', 'camera.far=40'] },
  { of: ['node', students + 'renderer.js'], scene: 'kiln', options: ['--near', '4'], settings: [...dark, ...near] },
  { of: [c], scene: 'quay', options: ['--planes', '4,40'], settings: [...near, '--set', 'camera.far=40'] },
];
let differing = 0;
for (const { of, scene, options, settings } of ways) {
  const errors = execFileSync(of[0], [...of.slice(1), '--list'], { encoding: 'utf8' }).trim().split('\n').map(line => line.split(' ')[0]);
  const taken = isLong ? ['', ...errors] : ['', errors[1], errors.at(-2)], named = isLong || of.includes('node') ? [] : ['--no-known'];  // names take longest
  for (const error of taken) {
    const folder = path.join(work, 'mine');
    fs.rmSync(folder, { recursive: true, force: true });
    fs.mkdirSync(folder);
    const file = `${students}scenes/${scene}.scene`;
    execFileSync(of[0], [...of.slice(1), file, 'mine', ...options, '--size', size, ...(error ? ['--error', error] : [])], { cwd: work });
    const said = bothSay(`${path.basename(of.at(-1))} ${error || 'right'}`, [file, 'mine', '--json', '--size', size, '--set', 'shading=phong', ...(error === errors[1] ? [] : named), ...settings], work);
    differing += said.status === 1;
  }
}
expect('errors were found', differing >= ways.length, String(differing));

// Files of every format, whole and damaged.
const folder = path.join(work, 'files');
execFileSync(program, ['export', 'pyramid', '--size', size, '--format', 'npy,png,csv', '-o', 'exported'], { cwd: work });
execFileSync(program, ['export', 'pyramid', '--size', size, '--format', 'scene', '-o', 'scene'], { cwd: work });
const scene = fs.readdirSync(path.join(work, 'scene')).find(name => /\.(toml|scene)$/.test(name));
const from = name => fs.readFileSync(path.join(work, 'exported', name));
const npyOf = (descr, fortran, shape, data) => {
  const head = `{'descr': '${descr}', 'fortran_order': ${fortran}, 'shape': (${shape.join(', ')}), }`.padEnd(117) + '\n';
  return Buffer.concat([Buffer.from('\x93NUMPY\x01\x00', 'latin1'), Buffer.from([head.length & 255, head.length >> 8]), Buffer.from(head, 'latin1'), data]);
};
const [width, height] = size.split('x').map(Number), count = width * height;
const depth = Array.from({ length: count }, (_, i) => 8 + Math.sin(i * .37)), byte = i => (i * 73 >> 2) & 255;
const numbers = write => { const data = Buffer.alloc(count * 8); depth.forEach((value, i) => write(data, value, i)); return data; };
const bytes = n => Buffer.from(Array.from({ length: n }, (_, i) => byte(i)));
const floats = channels => { const data = Buffer.alloc(4 * count * channels); for (let i = 0; i < count * channels; ++i) data.writeFloatLE(byte(i) / 255, 4 * i); return data; };
const files = {
  'z_view.npy': npyOf('>f8', 'False', [height, width], numbers((data, value, i) => data.writeDoubleBE(value, 8 * i))),
  'depth.npy': npyOf('<f8', 'True', [height, width], numbers((data, value, i) => data.writeDoubleLE(value, 8 * (i % width * height + Math.floor(i / width))))),
  'color.ppm': Buffer.concat([Buffer.from(`P6\n${width} ${height}\n255\n`), bytes(3 * count)]),
  'color.pfm': Buffer.concat([Buffer.from(`PF\n${width} ${height}\n-1.0\n`), floats(3)]),
  'shadow.pgm': Buffer.concat([Buffer.from(`P5\n${width} ${height}\n255\n`), bytes(count)]),
  'shadow.pbm': Buffer.from(`P1\n${width} ${height}\n` + Array.from({ length: count }, (_, i) => i % 3 === 0 ? '1' : '0').join(' ')),
  'color.png': from('color.png'), 'normal.png': from('normal.png'), 'color.npy': from('color.npy'),
  'color.csv': Buffer.from(Array.from({ length: height }, (_, y) => Array.from({ length: width }, (_, x) => byte(y * width + x)).join(',')).join('\n')),
  'z_view.exr': Buffer.from('\x76\x2f\x31\x01', 'latin1'), 'Color.PNG': from('color.png'), 'colr.png': from('color.png'), 'notes.txt': Buffer.from('x'),
  'mine.toml': Buffer.from('rows = "sideways"\n'),
};
const isExr = name => name.endsWith('.exr');
for (const [i, [name, whole]] of Object.entries(files).entries()) {
  const damaged = ['short', 'head', 'spoiled'][i % 3];  // of each file one, else all
  for (const [state, content] of Object.entries({ whole, short: whole.subarray(0, whole.length * .6), head: whole.subarray(0, 9), spoiled: whole.map((value, i) => i === whole.length >> 1 ? value ^ 64 : value), empty: Buffer.alloc(0) })) {
    if (isExr(name) || (!isLong && state !== 'whole' && state !== damaged)) continue;
    fs.rmSync(folder, { recursive: true, force: true });
    fs.mkdirSync(folder);
    fs.writeFileSync(path.join(folder, name), content);
    fs.writeFileSync(path.join(folder, 'polygon_id.npy'), from('polygon_id.npy'));
    bothSay(`${name}, ${state}`, [`scene/${scene}`, 'files', '--json', '--no-known'], work);
  }
}
for (const args of [['files', '--strict'], ['files/polygon_id.npy'], ['files/polygon_id.npy', 'nothing'], ['files', '--hints', '1', '--json'], ['exported', '--tolerance', 'color=3,depth=0.1'], ['exported', '--stage', 'z-buffer'], ['exported', '--stage', 'zbuffer'], ['exported', '--tolerance', 'colour=3']])
  bothSay(args.join(' '), [`scene/${scene}`, ...args], work);
const exr = spawnSync('node', [command, 'compare', `scene/${scene}`, 'z_view.exr', '--json'], { cwd: (fs.writeFileSync(path.join(work, 'z_view.exr'), files['z_view.exr']), work), encoding: 'utf8' });
expect('an OpenEXR file is named with its cure', exr.status === 3 && exr.stderr.includes('npy or pfm'), exr.stderr);
const none = spawnSync('node', [command, 'compare', `scene/${scene}`], { cwd: work, encoding: 'utf8' });
expect('a missing folder is wrong usage', none.status === 2 && none.stderr.includes('FOLDER is missing'), none.stderr);

