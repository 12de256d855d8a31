// The command for Node prints what the program prints, byte for byte: inspect, plan, check, and the files of export. Arguments:
// the program, the tarball. All scenes with SHADESCOPE_LONG=1.
import { execFileSync, spawnSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
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
