// The program in one page: scenes, lessons and files of the reader's own open, links open them again, and hostile ones do
// nothing. Argument: the program.
import { execFileSync, spawnSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import zlib from 'node:zlib';
import { launch } from './browser.mjs';
import { expect, folder as work } from './claims.mjs';

const [program] = process.argv.slice(2);
const file = path.join(work, 'shadescope.html'), address = 'file://' + file;
execFileSync(program, ['site', 'export', '--one', '-o', file], { stdio: ['ignore', 'ignore', 'inherit'] });
expect('the page has at most 2.85 MB, with what writing needs', fs.statSync(file).size <= 2.85e6, fs.statSync(file).size);
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
    for (const [hash, done] of [['#bug&seed=2026.1', 'game.state !== null && !game.isBusy'], ['#check&case=S10', 'cases.results.S10'], ['#study=pyramid', 'study.scene !== ""'], ['#scene=pyramid', 'document.documentElement.dataset.place === "scene" && !running']]) {
      await page.run(`location.hash = ${JSON.stringify(hash)}`);
      await page.until(done);
      expect(`${hash} does not scroll sideways at ${width}`, await page.run('document.documentElement.scrollWidth <= innerWidth'), await page.run('document.documentElement.scrollWidth'));
      const nameless = await page.run('all(":is(button, select, input, canvas, a)").filter(part => part.checkVisibility() && !part.ariaHidden && !(part.ariaLabel || part.textContent.trim() || part.labels?.length || part.title)).map(part => part.outerHTML.slice(0, 80))');
      expect(`every control of ${hash} has a name at ${width}`, nameless.length === 0, nameless);
      if (shots) await page.shot(path.join(shots, `${hash.slice(1, 4)}-${width}.png`));
    }
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
  const stills = () => page.run('JSON.stringify([data.link, view.page, view.then, report, one("#text").textContent, core.ask("inspect", ...(view.pixel || [9, 9]), view.channel)])');
  /** The link of what is open opens the same. @param {string} name */
  const linkedAgain = async name => {
    await page.run('one("#copylink").click()');
    const before = await stills(), hash = await page.run('linkNow().hash');
    await opens('#start');
    await opens(hash);
    expect(`the link of ${name} opens it again`, await said() === '' && await stills() === before, [hash, await said()]);
  };
  const scenes = await page.run('whole.known.map(one => one.name)');
  const some = list => (isLong ? list : list.filter((_, i) => i % 6 === 0));
  for (const name of some(scenes)) {
    await opens('#scene=' + name);
    expect(`${name} opens`, await said() === '' && await page.run('document.documentElement.dataset.place === "scene" && view.inside'), await said());
    await linkedAgain(name);
  }
  for (const name of some(lessons)) {
    await opens('#lesson=' + name);
    expect(`lesson ${name} opens`, await said() === '' && await page.run('!view.inside && data.pages > 0'), await said());
    for (let number = 1; number < await page.run('data.pages'); number += isLong ? 1 : 4) await page.run(`openPage(${number})`), await linkedAgain(`${name}, page ${number + 1}`);
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
  // The wrong picture, beside the command's.
  const played = spawnSync(program, ['bug', '--seed', '2026'], { input: 'hint\nlook depth\nlook 200,200\nmark 1\nmark 2\nquit\n', encoding: 'utf8' }).stdout;
  await opens('#bug&seed=2026.1');
  await page.until('game.state !== null && !game.isBusy');
  expect('the game has the picture of the command', played.includes(await page.run('game.state.said')) && played.includes(`this is ${await page.run('game.state.scene')}.`), await page.run('game.state'));
  if (shots) await page.shot(path.join(shots, 'bug-1366.png'));
  for (const does of ['one("#bughint").click()', 'lookAt("depth")', 'lookAt("", 200, 200)', 'one("#bugboxes button").closest("ol").children[1].firstElementChild.click()', 'one("#bugboxes").children[2].firstElementChild.click()']) {
    await page.run(does);
    const words = await page.run('game.state.said.trim()');
    expect(`${does} says what the command says`, words !== '' && played.includes(words), words);
  }
  expect('the points are the same', played.includes(`${await page.run('game.state.points')} points`), [await page.run('game.state.points'), played.slice(-300)]);
  const truth = await page.run('(() => { for (let i = 0; game.state.phase === "stage" && i < 7; ++i) if (!game.state.boxes[i].cleared) one("#bugboxes").children[i].firstElementChild.click(); for (let i = 0; game.state.phase === "cause" && i < 5; ++i) one("#bugcauses").children[i].click(); return [game.state.phase, one("#bugreveal").textContent]; })()');
  expect('it can be played to its end', truth[0] === 'over' && truth[1].length > 100, truth);
  expect('its link is its seed', (await page.run('linkNow().hash')) === '#bug&seed=2026.1', await page.run('linkNow().hash'));
  // Cases.
  await opens('#check&case=G1');
  await page.until('cases.results.G1');
  const [g1] = JSON.parse(execFileSync(program, ['check', '--case', 'G1', '--json'], { encoding: 'utf8' })).results;
  expect('a case gives the numbers of the command', await page.run('JSON.stringify([cases.results.G1.naive_text, cases.results.G1.ours_text, cases.results.G1.holds])') === JSON.stringify([g1.naive_text, g1.ours_text, true]), await page.run('cases.results.G1'));
  expect('all cases are listed', (await page.run('all("#cases tbody tr").length')) === JSON.parse(execFileSync(program, ['check', '--list', '--json'], { encoding: 'utf8' })).length);
  expect('both forms are shown', await page.run('one("#casebox").checkVisibility() && one("#casebox").textContent.includes(cases.list.find(row => row.case === "G1").stable_form)'));
  if (isLong) {
    await page.run('one("#caserun").click()');
    await page.until('Object.keys(cases.results).length === cases.list.length');
    expect('every case holds', (await page.run('Object.values(cases.results).filter(row => !row.holds).map(row => row.case)')).length === 0, await page.run('Object.values(cases.results).filter(row => !row.holds)'));
  }
  if (shots) await page.shot(path.join(shots, 'check-1366.png'));
  // A study of the open scene, with its settings: the errors of the command.
  await opens('#study=flat_gouraud_phong&set=width=80&set=height=60&sweep=shading=flat,phong');
  expect('a link fills in the sweep, and runs nothing', await said() === '' && await page.run('one("#sweep").value === "" && one("#sweepmore").value === "shading=flat,phong" && !study.isBusy'), [await said(), await page.run('one("#sweepmore").value')]);
  await page.run('one("#studyrun").click()');
  await page.until('study.report !== null');
  const found = JSON.parse(await page.run('study.report.json'));
  const asked = JSON.parse(spawnSync(program, ['study', 'flat_gouraud_phong', '--set', 'width=80', '--set', 'height=60', '--sweep', 'shading=flat,phong', '--warm-up', '0', '--repeat', '1', '--processes', '1', '--json', '-o', path.join(work, 'study')], { encoding: 'utf8', maxBuffer: 1 << 26 }).stdout);
  const models = report => report.points.map(point => point.errors.map(row => row.model && Number(row.model.toPrecision(9))));
  expect('a study finds the errors of the command', JSON.stringify(models(found)) === JSON.stringify(models(asked)) && found.points[0].frame[0].length === 9, [models(found)[0].slice(0, 3), models(asked)[0].slice(0, 3)]);
  expect('the plot has a mark for each point, the table a row', await page.run('all("#studyplot circle, #studyplot path:not(.line)").length >= 2 && all("#studyrows tr").length === 2 && one("#studyplot svg").getBoundingClientRect().height > 100'));
  expect('its link is its sweep', /^#study=flat_gouraud_phong&set=.*&sweep=shading=flat,phong$/.test(await page.run('linkNow().hash')), await page.run('linkNow().hash'));
  if (shots) await page.shot(path.join(shots, 'study-1366.png'));
  const drawnPlot = await page.run('svgText(one("#studyplot svg"))');
  fs.writeFileSync(path.join(work, 'plot.svg'), drawnPlot);
  expect('a saved plot has its colours', /stroke="rgb/.test(drawnPlot) && spawnSync('python3', ['-c', 'import sys, xml.dom.minidom as m; m.parse(sys.argv[1])', path.join(work, 'plot.svg')]).status === 0, drawnPlot.slice(0, 300));
  await page.run('one("#studyrun").click()');
  await page.run('one("#studystop").click()');
  expect('a study can be cancelled', await page.run('!study.isBusy && study.report === null && one("#studystop").hidden'));
  // What must hold, and downloads.
  await opens('#scene=pyramid');
  await page.key('k');
  const held = JSON.parse(execFileSync(program, ['inspect', 'pyramid', '--contracts', '--json'], { encoding: 'utf8' }));
  expect('K shows what must hold', await page.run(`one("#holdbox").open && all("#holdbox tbody tr").length === ${held.length}`), await page.run('one("#holdsum").textContent'));
  if (shots) await page.shot(path.join(shots, 'contracts-1366.png'));
  await page.run('one("#holdclose").click(), globalThis.savedFiles = [], saveFile = (...all) => savedFiles.push(all), one("#savekey").click()');
  execFileSync(program, ['export', 'pyramid', '--format', 'npy', '--buffers', 'depth', '-o', 'depth'], { cwd: work, stdio: 'ignore' });
  await page.run('one("#savebuffer").value = "depth", one("#savenpy").click()');
  const bytes = Buffer.from(await page.run('(() => { let text = ""; for (const byte of savedFiles[0][0]) text += String.fromCharCode(byte); return btoa(text); })()'), 'base64');
  expect('numbers are saved as the program exports them', bytes.equals(fs.readFileSync(path.join(work, 'depth', 'depth.npy'))), bytes.length);
  await page.run('one("#savepng").click()');
  await page.until('savedFiles.length === 2');
  expect('so is a picture', await page.run('savedFiles[1][2] === "depth.png" && savedFiles[1][0].size > 500'));
  await page.run('pick([48, 36]), one("#savebuffer").value = "z_view", one("#savesvg").click()');
  const figure = await page.run('savedFiles[2][0]');
  fs.writeFileSync(path.join(work, 'figure.svg'), figure);
  expect('a figure has its picture, bar and caption', /^<svg[^>]* width="84mm"/.test(figure) && figure.includes('href="data:image/png') && figure.includes('<linearGradient') && figure.includes('at 48, 36:') && spawnSync('python3', ['-c', 'import sys, xml.dom.minidom as m; m.parse(sys.argv[1])', path.join(work, 'figure.svg')]).status === 0, figure.replace(/base64,[^"]*/, '').slice(0, 400));
  if (shots) fs.writeFileSync(path.join(shots, 'figure.svg'), figure), fs.writeFileSync(path.join(shots, 'plot.svg'), drawnPlot);
  await page.run('one("#saveclose").click()');
  // Hostile ones: said, and nothing else.
  await page.run('globalThis.hit = 0');
  const long = 'x'.repeat(5000), bomb = zlib.deflateRawSync(Buffer.alloc(800000)).toString('base64url');
  for (const hash of ['#scene=<img src=x onerror=hit=1>', '#__proto__=1', '#constructor', '#scene=__proto__', '#lesson=constructor', '#scene=pyramid&__proto__=1', '#scene=pyramid&set=width=99999', '#scene=pyramid&set=<b>', '#' + long, '#scene=../../etc/passwd', '#mine&scene=../../etc/passwd', '#scene=pyramid&at=%E0%A4', '#lesson=pyramid&page=99999999999999999999', '#scene=pyramid&step=nowhere', '#scene=pyramid&show=<script>,x', '#scene=pyramid&with=nothing=1', '#mine&hints=-5', '#mine&convention=rows', '#bug&seed=99999999999999999999', '#bug&seed=<i>', '#check&case=<b>', '#study=<b>', '#study&set=<b>', '#study=__proto__', '#check&case=__proto__', '#scene&toml=AAAA', '#scene&toml=' + bomb]) {
    const elements = await page.run('document.querySelectorAll("script, img, iframe").length');
    await opens(hash);
    expect(`${hash.slice(0, 40)} does nothing`, await page.run('globalThis.hit === 0') && await page.run('document.querySelectorAll("script, img, iframe").length') === elements);
    if (/toml=/.test(hash)) await page.until('!one("#wrong").hidden').catch(() => {});
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
  // Its link has the scene.
  await page.run('setSetting("material.0.n", "5"), pick([200, 180])');
  const mine = await page.run('JSON.stringify([view.pixel, core.ask("inspect", ...view.pixel, view.channel)])');
  await page.run('navigator.clipboard ? (navigator.clipboard.writeText = async () => {}) : 0, copyLink()');
  const packed = await page.run('location.hash');
  expect('a small scene stands in its link', /^#scene&toml=[\w-]+/.test(packed) && packed.length <= 2000, packed);
  await opens('#start');
  await opens(packed);
  await page.until('document.documentElement.dataset.place === "scene" && view.pixel !== null');
  expect('which opens it again', await said() === '' && (await page.run('JSON.stringify([view.pixel, core.ask("inspect", ...view.pixel, view.channel)])')) === mine, [await said(), mine.slice(0, 200)]);
  const scenesFolder = new URL('../../resources/scenes/', import.meta.url).pathname;
  await opens('#start');
  await give([scenesFolder + 'box_over_plane.scene', scenesFolder + 'box.des', scenesFolder + 'floor.des']);
  await page.until('one("#title").textContent === "box_over_plane.scene" || !one("#wrong").hidden');
  expect('a scene opens with the files that it names', await said() === '', await said());
  expect('the page asks nothing of the network', page.requests.every(one => /^(file|data|blob):/.test(one)), page.requests);
  const thrown = page.log.filter(line => !line.startsWith('Error: The scene in the link is'));  // which is said
  expect('nothing is thrown', thrown.length === 0, thrown.slice(0, 3));
  await page.close();
} finally {
  await browser.close();
}
