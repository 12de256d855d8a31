#!/usr/bin/env node
// The command without a window, on any system that has Node: the core of the page, with files by name and bytes. As a module
// for autograders: start(), openScene(), handIn(), compare().
import { existsSync, readFileSync, readdirSync, realpathSync, statSync, watch } from 'node:fs';
import { basename, dirname, join, relative, resolve, isAbsolute } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gunzipSync } from 'node:zlib';

const here = dirname(fileURLToPath(import.meta.url));
const beside = name => readFileSync(join(here, name));
/** The page's own loader. */
export const Core = new Function(beside('core.js').toString() + '\nreturn Core;')();
const statuses = { done: 0, answerIsNo: 1, wrongUsage: 2, badInput: 3 };
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
  for (const setting of settings) core.ask('set', setting);
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

// --- The command line

const usage = `shadescope compare SCENE FOLDER|FILE... [--json] [--hints 0..3] [--stage STAGE] [--tolerance BUFFER=NUMBER]
                   [--strict] [--no-known] [--set KEY=VALUE] [--size WxH] [--watch]
Finds the first wrong stage of another renderer by its files. SCENE is a file, or the name of a scene that comes with it.
`;
const flags = new Set(['json', 'strict', 'no-known', 'watch', 'help', 'version']);
const valued = new Set(['hints', 'stage', 'tolerance', 'set', 'size']);

class WrongUsage extends Error {}

/** {"words": […], "json": true, "set": ["a=b"]} */
function parse(args) {
  const found = { words: [] };
  for (let i = 0; i < args.length; ++i) {
    const [, name, value] = /^--([a-z-]+)(?:=(.*))?$/s.exec(args[i]) || [];
    if (!name) { found.words.push(args[i]); continue; }
    if (flags.has(name) && value === undefined) { found[name] = true; continue; }
    if (!valued.has(name)) throw new WrongUsage(`there is no option ${args[i].split('=')[0]}`);
    const given = value ?? args[++i];
    if (given === undefined) throw new WrongUsage(`--${name} needs a value`);
    (found[name] ??= []).push(...(name === 'tolerance' ? given.split(',') : [given]));
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

async function main(args) {
  const [command, ...rest] = args;
  try {
    const found = parse(rest);
    if (!command || command === '--help' || found.help) return void process.stdout.write(usage) || (command ? statuses.done : statuses.wrongUsage);
    if (command === '--version') return void process.stdout.write(JSON.parse(beside('package.json').toString()).version + '\n') || statuses.done;
    if (command !== 'compare') throw new WrongUsage(`no command is called ${command}`);
    return await runCompare(found);
  } catch (error) {
    process.stderr.write(error instanceof WrongUsage ? `shadescope ${command}: ${error.message}\n` : error.message + '\n');
    return error instanceof WrongUsage ? statuses.wrongUsage : statuses.badInput;
  }
}
if (process.argv[1] && realpathSync(process.argv[1]) === fileURLToPath(import.meta.url)) process.exitCode = await main(process.argv.slice(2));
