// What a comparison costs in Node beside the program, as ratios in one run: CPU seconds and memory of 20 files of 640 × 480, with one
// thread each: of the stages, the median of three, and once of the known errors. Printed. Arguments: the program, the tarball.
import { execFileSync, spawnSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { folder } from './claims.mjs';

const [program, tarball] = process.argv.slice(2);
execFileSync('tar', ['xzf', tarball, '-C', folder]);
const buffers = 'vertices.world,vertices.view,vertices.screen,vertices.normal,polygons.verdict,depth,z_view,polygon_id,object_id,overdraw,barycentric,position,normal,n_dot_l.0,n_dot_h.0,ambient,diffuse.0,specular.0,intensity,color';
execFileSync(program, ['export', 'z_buffer_phong', '--size', '640x480', '--buffers', buffers, '--set', 'defect=no-max', '--format', 'npy', '-o', 'mine'], { cwd: folder, stdio: 'ignore' });
execFileSync(program, ['export', 'z_buffer_phong', '--size', '640x480', '--format', 'scene', '-o', 'scene'], { cwd: folder, stdio: 'ignore' });
const scene = path.join('scene', fs.readdirSync(path.join(folder, 'scene')).find(name => name.endsWith('.toml')));
/** CPU seconds, user and system, and the largest resident size in MB. @param {string[]} command @param {string[]} options */
function cost(command, ...options) {
  const { stderr, stdout } = spawnSync('/usr/bin/time', ['-f', '%U %S %M', 'taskset', '-c', '0', ...command, 'compare', scene, 'mine', '--json', ...options], { cwd: folder, encoding: 'utf8', maxBuffer: 1 << 28 });
  if (JSON.parse(stdout).stages.length !== 6) throw new Error(stderr);
  const [user, system, kilobytes] = stderr.trim().split('\n').at(-1).split(' ').map(Number);
  return [user + system, kilobytes / 1024];
}
const node = ['node', path.join(folder, 'package', 'shadescope.mjs')];
const rounds = Array.from({ length: 3 }, () => [cost([program], '--no-known'), cost(node, '--no-known')]);
const middle = list => list.sort((a, b) => a - b)[list.length >> 1], column = (who, what) => middle(rounds.map(round => round[who][what]));
console.log(`stages of 20 files, 640 × 480: program ${column(0, 0).toFixed(2)} CPU s, ${column(0, 1).toFixed(0)} MB; Node ${column(1, 0).toFixed(2)} CPU s, ${column(1, 1).toFixed(0)} MB; ratio ${(column(1, 0) / column(0, 0)).toFixed(2)} (budget 2.0)`);
const names = [cost([program]), cost(node)];
console.log(`with names: program ${names[0][0].toFixed(1)} CPU s, ${names[0][1].toFixed(0)} MB; Node ${names[1][0].toFixed(1)} CPU s, ${names[1][1].toFixed(0)} MB (budget 600 MB)`);
process.exit(77);  // it claims nothing
