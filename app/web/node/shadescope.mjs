#!/usr/bin/env node
// The command without a window, on any system that has Node: the core of the page, with files by name and bytes. As a module
// for autograders: start(), openScene(), handIn(), compare(), run().
import { existsSync, mkdirSync, readFileSync, readdirSync, realpathSync, renameSync, statSync, watch, writeFileSync } from 'node:fs';
import { basename, dirname, join, relative, resolve, isAbsolute } from 'node:path';
import { fileURLToPath } from 'node:url';
import { cpus } from 'node:os';
import { deflateSync, gunzipSync, inflateSync } from 'node:zlib';

const here = dirname(fileURLToPath(import.meta.url));
const beside = name => readFileSync(join(here, name));
/** The page's own loader. */
export const Core = new Function(beside('core.js').toString() + '\nreturn Core;')();
const statuses = { done: 0, answerIsNo: 1, wrongUsage: 2, badInput: 3, couldNotWrite: 4 };
const mostBytes = 256 << 20;

/** A core of its own. @param {(what: string, done: number, all: number) => void} progress told of long work, of all cores */
export async function start(progress = () => {}) {
  Core.progress = progress;
  return Core.start(gunzipSync(beside('shadescope_core_all.wasm.gz')));
}

/** Opens a scene file, or one that comes with the program by its name. Files that it names are read from its folder. */
export function openScene(core, scene, settings = []) {
  const own = ['.toml', '.scene'].map(ending => join(here, 'scenes', scene + ending)).find(file => !/[\\/]/.test(scene) && existsSync(file));
  const isFile = existsSync(scene) && statSync(scene).isFile();
  if (!isFile && !own) throw new Error(`${scene}: there is no such file, and no scene that comes with the program is called so`);
  const file = isFile ? scene : own, name = isFile ? scene : basename(own), folder = dirname(file);
  const bytes = readFileSync(file);
  core.ask('file', name, bytes);
  let opened;
  for (const given = new Set(); ;) {
    try { opened = core.ask('open', name, bytes); break; } catch (error) {
      // What it names and is in its folder; nothing outside of it.
      const more = core.ask('missing').filter(each => !given.has(each) && isInside(folder, each));
      if (more.length === 0) throw error;
      for (const each of more) {
        given.add(each);
        const found = readFileSync(join(folder, each));
        core.ask('file', each, found), core.ask('file', name.slice(0, name.lastIndexOf('/') + 1) + each, found);
      }
    }
  }
  for (const setting of settings)
    try { core.ask('set', setting); } catch (error) { throw Object.assign(error, { isOfUsage: true }); }
  return opened;
}
function isInside(folder, name) {
  const file = resolve(folder, name), from = relative(resolve(folder), file);
  return from !== '' && !from.startsWith('..') && !isAbsolute(from) && existsSync(file) && statSync(file).isFile() && statSync(file).size <= mostBytes;
}

/** Hands in a renderer's folders and files; those before are forgotten. */
export function handIn(core, paths) {
  core.ask('take_back');
  for (const given of paths) {
    if (!existsSync(given)) { core.ask('hand_nothing', given); continue; }
    if (!statSync(given).isDirectory()) { core.ask('hand', given, readFileSync(given), 1); continue; }
    const names = readdirSync(given).filter(name => statSync(join(given, name)).isFile());
    for (const name of names.sort((a, b) => Buffer.compare(Buffer.from(a), Buffer.from(b)))) {
      const path = given.endsWith('/') ? given + name : `${given}/${name}`;
      core.ask('hand', path, statSync(path).size <= mostBytes && /\.(npy|png|tga|bmp|ppm|pgm|pbm|pnm|pfm|exr|csv|toml)$/i.test(name) ? readFileSync(path) : '', 0);
    }
  }
}

/** What `shadescope compare --json` prints, as text. options: known, hints, strict, tolerance (["color=2"]), stage. */
export function compare(core, paths, options = {}) {
  core.ask('verdict_options', JSON.stringify(options));
  core.ask('verdict', paths.join(' '));
  return core.text();
}

/** What a command of the program prints of the open scene: inspect, plan, export and check, by the program's own functions.
 * Options by their names on the command line: { pixel: '10,20', json: true }; buffers, format of export, case and group are lists.
 * @returns {{out: string, messages: string, status: number, files: string[]}} */
export const run = (core, command, options = {}) => core.ask('run_command', command, JSON.stringify(options));

/** The bytes of a file that run(core, 'export', …) has named. @param {string} name @returns {Uint8Array} */
export function written(core, name) {
  const bytes = core.numbers(core.ask('written', name)).slice();
  return name.endsWith('.png') ? packedPng(bytes) : bytes;
}

/** The pixels of a PNG packed, which the core stores as they are. @param {Uint8Array} png @returns {Uint8Array} */
function packedPng(png) {
  const bytes = Buffer.from(png), parts = [bytes.subarray(0, 8)];
  for (let at = 8, size; at < bytes.length; at += 12 + size) {
    size = bytes.readUInt32BE(at);
    if (bytes.toString('latin1', at + 4, at + 8) !== 'IDAT') { parts.push(bytes.subarray(at, at + 12 + size)); continue; }
    const packed = deflateSync(inflateSync(bytes.subarray(at + 8, at + 8 + size)), { level: 9 }), chunk = Buffer.concat([Buffer.alloc(4), Buffer.from('IDAT'), packed, Buffer.alloc(4)]);
    chunk.writeUInt32BE(packed.length), chunk.writeUInt32BE(crc32(chunk.subarray(4, -4)), chunk.length - 4);
    parts.push(chunk);
  }
  return Buffer.concat(parts);
}
/** ISO 3309. @param {Uint8Array} bytes */
function crc32(bytes) {
  let sum = ~0;
  for (const byte of bytes) {
    sum ^= byte;
    for (let bit = 0; bit < 8; ++bit) sum = sum >>> 1 ^ (sum & 1 ? 0xEDB88320 : 0);
  }
  return ~sum >>> 0;
}

/** Error against run time of the open scene, in this process: what `shadescope study` writes as study.json, and what it prints.
 * @param {string[]} sweeps as --sweep takes them @param {{warmUp?: number, repeat?: number, tell?: (text: string) => void}} [options] @returns {{json: string, text: string}} */
export function study(core, sweeps, { warmUp = 2, repeat = 20, tell = () => {} } = {}) {
  const points = core.ask('study', sweeps.join('\n'), `${cpus()[0]?.model}, Node ${process.version}`, warmUp, repeat);
  for (const [i, point] of points.entries()) tell(`Errors: ${i} of ${points.length}, ${point}`), core.ask('study_point', i);
  tell('Times'), core.ask('study_times');
  return core.ask('study_report', 960, 600, 16);
}

// --- The command line

const usage = `shadescope compare SCENE FOLDER|FILE... [--json] [--hints 0..3] [--stage STAGE] [--tolerance BUFFER=NUMBER]
                   [--strict] [--no-known] [--watch]
    finds the first wrong stage of another renderer by its files
shadescope export SCENE -o DIR [--format npy,png,csv,scene] [--buffers all|NAME,...] [--until STAGE] [--at PLACE]
                   [--where CONDITION] [--mix TERM=GAIN,...] [--shadow-verdicts] [--force]
    writes buffers and manifest.json; adds to a folder, and removes nothing from it
shadescope inspect SCENE --pixel X,Y|--table TABLE|--where CONDITION|--row Y|--step PLACE|--contracts [--format FORMAT] [--json]
    prints a pixel with its equation, a table, a row, a step's algorithm, or what must hold
shadescope plan SCENE [--buffers all|NAME,...] [--until STAGE] [--counts] [--json]
    prints what runs, what is left out, and why
shadescope check [--case ID] [--group GROUP] [--list] [--json]
    runs the stiff and extreme cases
shadescope study SCENE --sweep SWEEP... [--warm-up N] [--repeat N] [--json]
    prints error against run time; SWEEP is KEY=VALUE,VALUE,..., KEY=FIRST..LAST*FACTOR or the name of a ready-made one
SCENE is a file, or the name of a scene that comes with this package. Each takes --set KEY=VALUE and --size WxH for it.
Exit status: 0 done, 1 the answer is no, 2 wrong usage, 3 bad input, 4 could not write.
`;
const ofScene = ['set', 'size'];
/** Options without and with a value. @type {Record<string, {flags: string[], valued: string[], work: (found: any) => Promise<number>}>} */
const commands = {
  compare: { flags: ['json', 'strict', 'no-known', 'watch'], valued: ['hints', 'stage', 'tolerance', ...ofScene], work: runCompare },
  export: { flags: ['force', 'shadow-verdicts'], valued: ['output', 'format', 'buffers', 'until', 'at', 'where', 'mix', ...ofScene], work: runExport },
  inspect: { flags: ['contracts', 'json'], valued: ['pixel', 'table', 'where', 'row', 'step', 'format', ...ofScene], work: runInspect },
  plan: { flags: ['counts', 'json'], valued: ['buffers', 'until', ...ofScene], work: runPlan },
  check: { flags: ['list', 'json'], valued: ['case', 'group'], work: runCheck },
  study: { flags: ['json'], valued: ['sweep', 'warm-up', 'repeat', ...ofScene], work: runStudy },
};
const listed = new Set(['tolerance', 'buffers']);  // with commas between

class WrongUsage extends Error {}

/** {"words": […], "json": true, "set": ["a=b"]} */
function parse(args, { flags, valued }) {
  const found = { words: [] };
  for (let i = 0; i < args.length; ++i) {
    const [, name, value] = /^--([a-z-]+)(?:=(.*))?$/s.exec(args[i] === '-o' ? '--output' : args[i]) || [];
    if (!name) { found.words.push(args[i]); continue; }
    if ((flags.includes(name) || name === 'help') && value === undefined) { found[name] = true; continue; }
    if (!valued.includes(name)) throw new WrongUsage(`there is no option ${args[i].split('=')[0]}`);
    const given = value ?? args[++i];
    if (given === undefined) throw new WrongUsage(`--${name} needs a value`);
    (found[name] ??= []).push(...(listed.has(name) ? given.split(',') : [given]));
  }
  return found;
}
function settingsOf(found) {
  const size = found.size ? /^(\d+)x(\d+)$/.exec(found.size.at(-1)) : null;
  if (found.size && !size) throw new WrongUsage(`--size is "${found.size.at(-1)}", expected WxH, as in 640x480`);
  return [...(size ? [`width=${size[1]}`, `height=${size[2]}`] : []), ...(found.set || [])];
}

async function compareOnce(core, paths, options, json) {
  handIn(core, paths);
  let text;
  try { text = compare(core, paths, options); } catch (error) { return void process.stderr.write(error.message + '\n') || statuses.badInput; }
  const status = JSON.parse(text).exit;
  process.stdout.write(json ? text + '\n' : core.ask('verdict_text', 100).map(line => line.text + '\n').join(''));
  return status;
}

async function runCompare(found) {
  const [scene, ...paths] = found.words, hints = found.hints ? Number(found.hints.at(-1)) : 3;
  if (!scene) throw new WrongUsage('SCENE is missing');
  if (paths.length === 0) throw new WrongUsage('FOLDER is missing: where your renderer has written its buffers');
  if (![0, 1, 2, 3].includes(hints)) throw new WrongUsage(`--hints is "${found.hints.at(-1)}", expected 0 to 3`);
  const settings = settingsOf(found), core = await start();
  const options = { known: !found['no-known'], hints, strict: found.strict === true, tolerance: found.tolerance || [], stage: found.stage?.at(-1) || '' };
  try { core.ask('verdict_options', JSON.stringify(options)); } catch (error) { throw new WrongUsage(error.message.trim()); }
  openScene(core, scene, settings);
  const status = await compareOnce(core, paths, options, found.json);
  if (!found.watch) return status;
  // Again when the files have changed and rest for a moment.
  let soon;
  for (const path of paths) watch(path, () => { clearTimeout(soon), soon = setTimeout(() => compareOnce(core, paths, options, found.json), 500); });
  return new Promise(() => {});
}

/** The scene that the words name, alone, in a core of its own. */
async function coreOf(found) {
  const [scene, ...more] = found.words;
  if (!scene) throw new WrongUsage('SCENE is missing');
  if (more.length) throw new WrongUsage(`${more[0]} is one word too many`);
  const settings = settingsOf(found), core = await start();
  openScene(core, scene, settings);
  return core;
}
function last(list) { return list?.at(-1); }

/** Prints what the command says. */
function answer({ out, messages, status }) {
  process.stdout.write(out), process.stderr.write(messages);
  return status;
}

async function runInspect(found) {
  const kinds = ['pixel', 'table', 'where', 'row', 'step', 'contracts'].filter(kind => found[kind] !== undefined);
  if (kinds.length !== 1) throw new WrongUsage('one of --pixel, --table, --where, --row, --step and --contracts is needed');
  if (found.json && found.format) throw new WrongUsage('--json and --format exclude each other');
  if (found.format && ['where', 'contracts'].includes(kinds[0])) throw new WrongUsage(`--format and --${kinds[0]} exclude each other`);
  if (found.row && !/^-?\d+$/.test(last(found.row))) throw new WrongUsage(`--row is "${last(found.row)}", expected a row's number`);
  const options = { json: found.json, contracts: found.contracts, format: last(found.format), pixel: last(found.pixel), table: last(found.table), where: last(found.where), step: last(found.step), row: found.row && Number(last(found.row)) };
  return answer(run(await coreOf(found), 'inspect', options));
}

async function runPlan(found) {
  return answer(run(await coreOf(found), 'plan', { json: found.json, counts: found.counts, buffers: found.buffers, until: last(found.until) }));
}
async function runCheck(found) {
  if (found.words.length) throw new WrongUsage(`${found.words[0]} is one word too many`);
  return answer(run(await start(), 'check', { case: found.case, group: found.group, list: found.list, json: found.json }));
}

async function runStudy(found) {
  if (!found.sweep) throw new WrongUsage('--sweep is missing: KEY=VALUE,VALUE,... or the name of a ready-made one');
  const [warmUp, repeat] = [['warm-up', 2, 0], ['repeat', 20, 1]].map(([name, otherwise, least]) => {
    const text = last(found[name]) ?? String(otherwise);
    if (!/^\d{1,5}$/.test(text) || Number(text) < least) throw new WrongUsage(`--${name} is "${text}", expected a number from ${least}`);
    return Number(text);
  });
  const core = await coreOf(found), tell = text => process.stderr.isTTY && process.stderr.write(`\r\x1b[K${text}`);
  let said;
  try { said = study(core, found.sweep, { warmUp, repeat, tell }); } catch (error) { throw Object.assign(error, { isOfUsage: error.errors !== undefined }); }
  if (process.stderr.isTTY) process.stderr.write('\r\x1b[K');
  process.stdout.write(found.json ? said.json : said.text);
  return statuses.done;
}

async function runExport(found) {
  const folder = last(found.output);
  if (!folder) throw new WrongUsage('-o needs the name of a folder');
  if (found.at && found.until) throw new WrongUsage('--at names the stage; --until cannot go with it');
  const core = await coreOf(found), options = { folder, format: found.format && last(found.format).split(','), buffers: found.buffers, until: last(found.until), at: last(found.at), where: last(found.where), mix: last(found.mix), shadowVerdicts: found['shadow-verdicts'] };
  const said = run(core, 'export', options);
  if (said.status !== statuses.done) return answer(said);
  let ours = [];
  try { ours = JSON.parse(readFileSync(join(folder, 'manifest.json'), 'utf8')).contents.map(entry => entry.file).concat('manifest.json'); } catch { /* no export is there */ }
  const foreign = said.files.filter(name => !found.force && !ours.includes(name) && existsSync(join(folder, name)));
  if (foreign.length) {
    process.stderr.write(foreign.map(name => `${join(folder, name)}: is there, and Shadescope did not write it; expected another folder, or --force\n`).join(''));
    return statuses.couldNotWrite;
  }
  try {
    mkdirSync(folder, { recursive: true });
    // Whole files, and the one that names the others last.
    for (const name of [...said.files.filter(name => name !== 'manifest.json'), 'manifest.json']) {
      writeFileSync(join(folder, name + '.part'), written(core, name));
      renameSync(join(folder, name + '.part'), join(folder, name));
    }
  } catch (error) {
    process.stderr.write(error.message + '\n');
    return statuses.couldNotWrite;
  }
  return answer(said);
}

async function main(args) {
  const [command, ...rest] = args;
  try {
    if (!command || command === '--help' || rest.includes('--help')) return void process.stdout.write(usage) || (command ? statuses.done : statuses.wrongUsage);
    if (command === '--version') return void process.stdout.write(JSON.parse(beside('package.json').toString()).version + '\n') || statuses.done;
    if (!Object.hasOwn(commands, command)) throw new WrongUsage('there is no such command here');
    return await commands[command].work(parse(rest, commands[command]));
  } catch (error) {
    process.stderr.write(error instanceof WrongUsage ? `shadescope ${command}: ${error.message}\n` : error.message + '\n');
    return error instanceof WrongUsage || error.isOfUsage ? statuses.wrongUsage : statuses.badInput;
  }
}
if (process.argv[1] && realpathSync(process.argv[1]) === fileURLToPath(import.meta.url)) process.exitCode = await main(process.argv.slice(2));
