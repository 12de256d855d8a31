// Every buffer of every scene that comes with the program at 320 × 240, in float and double: what the program exports, bit
// for bit what the core of live pages computes. With SHADESCOPE_LONG alone. Arguments: the program, the core, the scenes.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { startCore } from './core.mjs';

const [program, packed, scenes] = process.argv.slice(2);
if (!process.env.SHADESCOPE_LONG || process.env.SHADESCOPE_LONG === '0') {
  console.log('Left out: a long sweep, for ./test --long');
  process.exit(77);
}
const core = await startCore(packed), folder = fs.mkdtempSync(path.join(os.tmpdir(), 'shadescope-large-'));
for (const file of fs.readdirSync(scenes))
  if (file.endsWith('.des')) core.ask('file', file, fs.readFileSync(path.join(scenes, file), 'utf8'));

/** The bytes behind a header: NPY format 1.0 has its length in bytes 8 and 9. @param {string} file */
function npyData(file) {
  const bytes = fs.readFileSync(file);
  return bytes.subarray(10 + bytes.readUInt16LE(8));
}

let compared = 0, wrong = 0, frames = 0;
try {
  for (const file of fs.readdirSync(scenes).filter(name => /\.(toml|scene)$/.test(name)))
    for (const precision of ['float', 'double']) {
      const name = path.parse(file).name, out = path.join(folder, `${name}-${precision}`);
      execFileSync(program, ['export', name, '--size', '320x240', '--set', 'precision=' + precision, '--format', 'npy', '-o', out], { stdio: 'ignore' });
      core.ask('open', file, fs.readFileSync(path.join(scenes, file), 'utf8'));
      for (const setting of ['width=320', 'height=240', 'precision=' + precision]) core.ask('set', setting);
      core.ask('want', 'every');
      core.calls.frame(1);
      ++frames;
      for (const written of fs.readdirSync(out).filter(one => one.endsWith('.npy'))) {
        ++compared;
        const buffer = path.parse(written).name;
        if (!core.call('buffer', buffer, 0)) {
          ++wrong;
          console.log(`${name} in ${precision}: ${buffer} is not there`);
          continue;
        }
        const numbers = core.numbers(JSON.parse(core.text()));
        const same = Buffer.from(numbers.buffer, numbers.byteOffset, numbers.byteLength).equals(npyData(path.join(out, written)));
        if (!same) ++wrong, console.log(`${name} in ${precision}: ${buffer} has other bits`);
      }
      fs.rmSync(out, { recursive: true });
    }
} finally {
  fs.rmSync(folder, { recursive: true, force: true });
}
console.log(`${compared} buffers of ${frames} frames compared, ${wrong} differ`);
process.exitCode = wrong === 0 && compared > 0 ? 0 : 1;
