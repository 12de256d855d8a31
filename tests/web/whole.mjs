// The program in one page: scenes, lessons and files of the reader's own open, links open them again, and hostile ones do
// nothing. Argument: the program.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { launch } from './browser.mjs';

const [program] = process.argv.slice(2);
const work = fs.mkdtempSync(path.join(os.tmpdir(), 'shadescope-whole-')), file = path.join(work, 'shadescope.html'), address = 'file://' + file;
let held = 0, failed = 0;
/** @param {string} claim @param {any} true_ @param {any} [found] */
function expect(claim, true_, found = '') {
  if (true_) return void ++held;
  ++failed;
  console.log(`FAILED: ${claim}${found === '' ? '' : ': ' + JSON.stringify(found)}`);
}
execFileSync(program, ['site', 'export', '--one', '-o', file], { stdio: ['ignore', 'ignore', 'inherit'] });
expect('the page has at most 2.6 MB', fs.statSync(file).size <= 2.6e6, fs.statSync(file).size);
const lessons = JSON.parse(execFileSync(program, ['lesson', 'list', '--json'], { encoding: 'utf8' })).map(each => each.name);
const shots = process.env.SHADESCOPE_SHOTS, isLong = process.env.SHADESCOPE_LONG === '1';

const browser = await launch();
try {
  for (const width of [390, 1366]) {
    const page = await browser.open(address, { width, height: width < 500 ? 844 : 768, mobile: width < 500 });
    expect(`the start does not scroll sideways at ${width}`, await page.run('document.documentElement.scrollWidth <= innerWidth'), await page.run('document.documentElement.scrollWidth'));
    expect('every lesson is listed', JSON.stringify(await page.run('Object.keys(whole.lessons).sort()')) === JSON.stringify([...lessons].sort()));
    expect('every scene has its picture', await page.run('all("#scenes img").every(one => one.src.startsWith("data:image/png"))'));
    if (shots) await page.shot(path.join(shots, `start-${width}.png`));
    await page.close();
  }
  const page = await browser.open(address, { width: 1366, height: 768 });
  const opens = async hash => {
    await page.run(`(location.hash = ${JSON.stringify(hash)}, new Promise(done => setTimeout(done, 30)))`);
    await page.until('!running');
  };
  const said = () => page.run('one("#wrong").hidden ? "" : one("#wrong").textContent');
  /** What a reader sees, as far as the core knows it. */
  const state = () => page.run('JSON.stringify([document.documentElement.dataset.place, one("#title").textContent, view.page, view.then, view.pixel, view.step?.place, view.pictures.map(one => one.buffer), view.compare, Object.keys(view.own).map(key => key + settingOf(key).text), view.pixel ? core.ask("inspect", ...view.pixel, view.channel) : null])');
  const scenes = await page.run('whole.known.map(one => one.name)');
  const some = list => (isLong ? list : list.filter((_, i) => i % 6 === 0));
  for (const name of some(scenes)) {
    await opens('#scene=' + name);
    expect(`${name} opens`, await said() === '' && await page.run('document.documentElement.dataset.place === "scene" && view.inside'), await said());
  }
  for (const name of some(lessons)) {
    await opens('#lesson=' + name);
    expect(`lesson ${name} opens`, await said() === '' && await page.run('!view.inside && data.pages > 0'), await said());
  }
  // A state, its link, and the state that the link opens.
  await opens('#scene=z_buffer_phong');
  await page.run('setSetting("material.0.n", "4")');
  await page.until('!running && settingOf("material.0.n").text === "4"');
  await page.run('guarded(() => { pick([200, 180]), show(1, "normal"), step(0, "z-buffer/polygon=2"); })');
  const before = await state();
  await page.run('one("#copylink").click()');
  const link = await page.run('location.hash');
  await opens('#start');
  await opens(link);
  expect('a link opens the state again', await state() === before, [link, before.slice(0, 300), (await state()).slice(0, 300)]);
  if (shots) await page.shot(path.join(shots, 'scene-1366.png'));
  await opens('#lesson=' + lessons[0] + '&page=2');
  expect('a link opens a page of a lesson', await page.run('view.page === 1'));
  if (shots) await page.shot(path.join(shots, 'lesson-1366.png'));
  await page.run('history.back(), new Promise(done => setTimeout(done, 100))');
  expect('Back works', await page.run('document.documentElement.dataset.place === "scene" && data.isScene'));
  await opens('#mine&scene=pyramid.scene&hints=1');
  expect('My renderer takes scene and hints from a link', await page.run('mine.scene.name === "pyramid.scene" && mine.hints === 1 && one("#minescene").value === "pyramid.scene"'));
  // Hostile ones: said, and nothing else.
  await page.run('globalThis.hit = 0');
  const long = 'x'.repeat(5000);
  for (const hash of ['#scene=<img src=x onerror=hit=1>', '#__proto__=1', '#constructor', '#scene=__proto__', '#lesson=constructor', '#scene=pyramid&__proto__=1', '#scene=pyramid&set=width=99999', '#scene=pyramid&set=<b>', '#' + long, '#scene=../../etc/passwd', '#mine&scene=../../etc/passwd', '#scene=pyramid&at=%E0%A4', '#lesson=pyramid&page=99999999999999999999', '#scene=pyramid&step=nowhere', '#scene=pyramid&show=<script>,x', '#scene=pyramid&with=nothing=1', '#mine&hints=-5']) {
    const elements = await page.run('document.querySelectorAll("script, img, iframe").length');
    await opens(hash);
    expect(`${hash.slice(0, 40)} does nothing`, await page.run('globalThis.hit === 0') && await page.run('document.querySelectorAll("script, img, iframe").length') === elements);
    if (!/page=9|hints=-5/.test(hash)) expect(`${hash.slice(0, 40)} is said`, await said() !== '', await page.run('location.hash.slice(0, 60)'));
  }
  // Own files: a model, a scene that names another.
  const give = async files => {
    const { root } = await page.ask('DOM.getDocument'), { nodeId } = await page.ask('DOM.querySelector', { nodeId: root.nodeId, selector: '#filesfield' });
    await page.ask('DOM.setFileInputFiles', { nodeId, files });
    await page.until('one("#filesfield").value === ""');
  };
  await page.ask('DOM.enable');
  await opens('#start');
  const model = path.join(work, 'house.obj');
  fs.writeFileSync(model, 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n');
  await give([model]);
  await page.until('one("#title").textContent === "house.obj" || !one("#wrong").hidden');
  expect('a model opens', await said() === '' && await page.run('core.ask("mesh") !== null && document.documentElement.dataset.place === "scene"'), await said());
  const scenesFolder = new URL('../../resources/scenes/', import.meta.url).pathname;
  await opens('#start');
  await give([scenesFolder + 'box_over_plane.scene', scenesFolder + 'box.des', scenesFolder + 'floor.des']);
  await page.until('one("#title").textContent === "box_over_plane.scene" || !one("#wrong").hidden');
  expect('a scene opens with the files that it names', await said() === '', await said());
  expect('the page asks nothing of the network', page.requests.every(one => /^(file|data|blob):/.test(one)), page.requests);
  expect('nothing is thrown', page.log.length === 0, page.log.slice(0, 3));
  await page.close();
} finally {
  await browser.close();
  fs.rmSync(work, { recursive: true, force: true });
}
console.log(`${held} claims hold, ${failed} do not`);
process.exitCode = failed === 0 ? 0 : 1;
