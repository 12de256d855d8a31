// Every buffer of the scenes that come with the program, computed by the core of live pages, against the hashes that
// tests/reference/buffer_hashes_test.cpp asks of the program: the same bits. Arguments: the core, buffer_hashes.txt, the
// folder of the scenes. Some 50 spread samples of scene and precision, or all with SHADESCOPE_LONG=1.
import crypto from 'node:crypto';
import fs from 'node:fs';
import { startCore } from './core.mjs';

const [packed, hashFile, folder] = process.argv.slice(2);
const core = await startCore(packed);

/** [variant, precision, Map of buffer to hash] */
const samples = [];
for (const line of fs.readFileSync(hashFile, 'utf8').split('\n')) {
  if (line === '' || line.startsWith('#')) continue;
  if (line.startsWith('[')) {
    for (const precision of ['float', 'double']) samples.push([line.slice(1, -1), precision, new Map()]);
    continue;
  }
  const [buffer, float, double] = line.split(/\s+/);
  samples.at(-2)[2].set(buffer, float), samples.at(-1)[2].set(buffer, double);
}

for (const file of fs.readdirSync(folder))
  if (file.endsWith('.des')) core.ask('file', file, fs.readFileSync(`${folder}/${file}`, 'utf8'));

/** Whether the scene has the setting, and takes the value. */
const set = (key, value) => core.call('set', `${key}=${value}`) === 1;

// As read() in buffer_hashes_test.cpp: a small picture and small shadow buffers, everything left out that can be.
function open(variant, precision) {
  const [name, ...settings] = variant.split(' ');
  const file = [`${name}.toml`, `${name}.scene`].find(each => fs.existsSync(`${folder}/${each}`));
  core.ask('open', file, fs.readFileSync(`${folder}/${file}`, 'utf8'));
  for (const setting of settings) core.ask('set', setting);
  const value = key => core.ask('settings').find(setting => setting.key === key)?.value;
  const scale = value('camera.scale');
  if (scale !== undefined) set('camera.scale', scale * (120 / value('height')));
  core.ask('set', 'width=160'), core.ask('set', 'height=120');
  if (value('shadow.size') > 256) core.ask('set', 'shadow.size=256');
  core.ask('set', 'precision=' + precision);
  for (const setting of core.ask('settings'))
    if (setting.group === 'Leaving out') core.ask('set', `${setting.key}=${setting.choices.at(-1)}`);
}

function hashOf(name) {
  const buffer = core.ask('buffer', name, 0), numbers = core.numbers(buffer);
  const bytes = new Uint8Array(numbers.buffer, numbers.byteOffset, numbers.byteLength);
  return crypto.createHash('sha256').update([buffer.dtype, ...buffer.shape].join(' ')).update(bytes).digest('hex').slice(0, 16);
}

const taken = process.env.SHADESCOPE_LONG && process.env.SHADESCOPE_LONG !== '0' ? samples.length : Math.min(50, samples.length);
let compared = 0, wrong = 0;
for (let i = 0; i < taken; ++i) {
  const [variant, precision, hashes] = samples[taken === samples.length ? i : Math.floor(i * (samples.length - 1) / (taken - 1))];
  open(variant, precision);
  core.ask('want', 'every');
  core.calls.frame(1);
  const held = new Set(core.ask('held'));
  for (const [name, hash] of hashes) {
    ++compared;
    if (held.has(name) && hashOf(name) === hash) continue;
    ++wrong;
    console.log(`${variant} in ${precision}: ${name} ${held.has(name) ? 'has other bits' : 'is not there'}`);
  }
  for (const name of held)
    if (!hashes.has(name)) ++wrong, console.log(`${variant} in ${precision}: ${name} is there, and no hash for it`);
}
console.log(`${compared} buffers of ${taken} frames compared, ${wrong} differ; memory ${core.memory.byteLength >> 20} MB`);
process.exitCode = wrong === 0 && compared > 0 ? 0 : 1;
