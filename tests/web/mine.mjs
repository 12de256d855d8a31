// The program in one page: a folder that a renderer wrote is judged in Chromium as the program judges it. Argument: the program.
import { execFileSync, spawnSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { launch } from './browser.mjs';
import { expect, folder as work } from './claims.mjs';

const [program] = process.argv.slice(2), starter = fileURLToPath(new URL('../../resources/starter/', import.meta.url));
const file = path.join(work, 'shadescope.html'), size = ['--size', '96x60'];
/** A folder as a renderer leaves it, the scene beside its buffers. @param {string} name @param {string[]} settings @param {string[]} buffers */
function write(name, settings, buffers) {
  execFileSync(program, ['export', 'check_me.toml', '--format', 'npy', '-o', 'all', ...settings.flatMap(one => ['--set', one])], { cwd: work });
  fs.mkdirSync(path.join(work, name));
  for (const buffer of buffers) fs.copyFileSync(path.join(work, 'all', buffer + '.npy'), path.join(work, name, buffer + '.npy'));
  fs.copyFileSync(path.join(work, 'check_me.toml'), path.join(work, name, 'check_me.toml'));
}
fs.writeFileSync(path.join(work, 'check_me.toml'), fs.readFileSync(starter + 'check_me.toml', 'utf8').replace('width = 320', 'width = 96').replace('height = 200', 'height = 60').replace('distance = 330', 'distance = 99'));
const buffers = ['vertices.world', 'vertices.screen', 'vertices.normal', 'polygons.verdict', 'z_view', 'polygon_id', 'normal', 'n_dot_l.0', 'color'];
write('mine', ['defect=normal-matrix'], buffers), write('right', [], buffers), write('dull', ['defect=no-max'], ['color']);
execFileSync(program, ['site', 'export', '--one', '-o', file], { stdio: ['ignore', 'ignore', 'inherit'] });
expect('the page has at most 2.85 MB, with what writing needs', fs.statSync(file).size <= 2.85e6, fs.statSync(file).size);
const native = (name, ...args) => spawnSync(program, ['compare', 'check_me.toml', name, ...args], { cwd: work, encoding: 'utf8', maxBuffer: 1 << 26 }).stdout;

const browser = await launch();
const shots = process.env.SHADESCOPE_SHOTS;
try {
  const sizes = { laptop: [1366, 768], phone: [390, 844] };
  for (const [device, [width, height]] of Object.entries(sizes)) {
    const page = await browser.open('file://' + file + '#mine', { width, height, mobile: width < 500 });
    const shot = async name => { if (shots) await page.shot(path.join(shots, `${name}-${width}.png`)); };
    const give = async (name, field = '#folderfield', files = [path.join(work, name)]) => {
      const { root } = await page.ask('DOM.getDocument'), { nodeId } = await page.ask('DOM.querySelector', { nodeId: root.nodeId, selector: field });
      const before = await page.run('mine.run');
      await page.ask('DOM.setFileInputFiles', { nodeId, files });
      await page.until(`Number(document.documentElement.dataset.compared) > ${before}`);
    };
    await page.ask('DOM.enable');
    const fits = () => page.run('document.documentElement.scrollWidth <= innerWidth');
    expect(`nothing scrolls sideways before a folder, ${device}`, await fits());
    expect('what to do is said', await page.run('one("#mineempty").textContent.includes("Drop the folder of your renderer here") || one("#mineempty h2").checkVisibility()'));
    await shot('mine-empty');
    if (device === 'phone') {
      await give('mine');
      expect('a phone shows the verdict', await page.run('one("#minehead").checkVisibility() && one("#minehead").textContent === mine.report.headline'));
      expect('nothing scrolls sideways on a phone', await fits(), await page.run('document.documentElement.scrollWidth'));
      expect('fingers hit what they mean', await page.run('all("#mine button, #mine select").filter(one => one.checkVisibility() && one.getBoundingClientRect().height < 43).map(one => one.textContent)').then(list => list.length === 0), await page.run('all("#mine button, #mine select").filter(one => one.checkVisibility() && one.getBoundingClientRect().height < 43).map(one => one.textContent)'));
      await shot('mine');
      await page.close();
      continue;
    }
    for (const name of ['mine', 'right', 'dull']) {
      await give(name);
      expect(`the verdict of ${name} is that of the program`, (await page.run('mine.json')) + '\n' === native(name, '--json'), await page.run('mine.report?.headline'));
      expect(`and so is its text`, (await page.run('one("#minetext").textContent')) + '\n' === native(name), await page.run('one("#minetext").textContent'));
      await page.until('!mine.isAsking');
      expect(`nothing scrolls sideways with ${name}`, await fits());
      await shot(name);
    }
    await give('mine');
    await page.until('!mine.isAsking && one("#minepixel").checkVisibility()');
    const at = JSON.stringify(await page.run('mine.pixel'));
    expect('the worst pixel is picked', at === JSON.stringify(await page.run('mine.worst[0]')), at);
    expect('its numbers are beside the right ones', await page.run('all("#minepixel tr.bad").length > 0 && one("#minepixel h3").textContent === "Pixel " + mine.pixel.join(", ")'));
    expect('the first picture is of the first wrong stage', await page.run('mine.shown === "normal"'), await page.run('mine.shown'));
    expect('the error is named in the words of the JSON', await page.run('one("#minelikely b").textContent === mine.report.known[0].name'), await page.run('one("#minelikely").textContent'));
    await page.key('w');
    await page.until('!mine.isAsking');
    expect('W goes to the next', await page.run('JSON.stringify(mine.pixel) === JSON.stringify(mine.worst[1 % mine.worst.length])'), await page.run('[mine.pixel, mine.worst]'));
    await page.key('d');
    await page.until('!mine.isAsking');
    expect('D shows the difference', await page.run('one(".pane:nth-of-type(2) [value=\\"2\\"]").getAttribute("aria-pressed") === "true"'));
    await page.key('5');
    await page.until('!mine.isAsking');
    expect('5 goes to the z-buffer', await page.run('mine.shown === "z_view"'), await page.run('mine.shown'));
    expect('cards say what they show', await page.run('all("#minestrip button")[2].getAttribute("aria-label").startsWith("3 Normals, wrong here")'), await page.run('all("#minestrip button")[2].getAttribute("aria-label")'));
    expect('every control has a name', (await page.run('all("#mine :is(button, select, canvas, progress, meter)").filter(one => !(one.ariaLabel || one.textContent.trim() || one.labels?.length || one.title)).length')) === 0);
    // Conventions by hand: as mine.toml has them.
    expect('conventions can be changed', await page.run('all("#minechoices select").length === mine.report.choices.length && mine.report.choices.length > 1'), await page.run('mine.report.choices'));
    const state = async (key, value) => {
      const before = await page.run('mine.run');
      await page.run(`stateConvention(${JSON.stringify(key)}, ${JSON.stringify(value)})`);
      await page.until(`Number(document.documentElement.dataset.compared) > ${before}`);
    };
    await state('rows', 'bottom-up');
    fs.writeFileSync(path.join(work, 'mine', 'mine.toml'), 'rows = "bottom-up"\n');
    expect('a convention by hand gives the verdict of mine.toml', (await page.run('mine.json')) + '\n' === native('mine', '--json'), await page.run('mine.report?.headline'));
    expect('and says so', await page.run('one("#mineconventions summary span").textContent === "1 by hand" && linkNow().hash.includes("convention=rows=bottom-up")'), await page.run('linkNow().hash'));
    fs.rmSync(path.join(work, 'mine', 'mine.toml'));
    await state('rows', '');
    expect('put back, it is found again', (await page.run('mine.json')) + '\n' === native('mine', '--json'));
    // The report is the program's, but for how its pictures are packed.
    await page.run('globalThis.savedFiles = [], saveFile = (...all) => savedFiles.push(all), one("#minereport").click()');
    await page.until('savedFiles.length === 1');
    const plain = html => html.replace(/data:image\/png;base64,[^"]*/g, ''), report = await page.run('savedFiles[0]');
    spawnSync(program, ['compare', 'check_me.toml', 'mine', '-o', 'native.html'], { cwd: work });
    const nativeReport = fs.readFileSync(path.join(work, 'native.html'), 'utf8'), pictures = html => html.match(/data:image\/png/g)?.length;
    expect('the report is that of the program', plain(report[0]).length > 5000 && plain(report[0]) === plain(nativeReport).replace(" -o native.html", ""), [plain(report[0]).length, plain(nativeReport).length]);
    expect('with its pictures', pictures(report[0]) === pictures(nativeReport), [pictures(report[0]), pictures(nativeReport)]);
    fs.writeFileSync(path.join(work, 'saved.html'), report[0]);
    const opened = await browser.open('file://' + path.join(work, 'saved.html'), { ready: 'document.readyState === "complete"' });
    expect('which a browser shows', await opened.run('[...document.images].every(image => image.naturalWidth > 0)'));
    await opened.close();
    // A drop, of a folder and of files.
    const drop = async (...files) => {
      const before = await page.run('mine.run'), data = { items: [], files, dragOperationsMask: 1 };
      for (const type of ['dragEnter', 'dragOver', 'drop']) await page.ask('Input.dispatchDragEvent', { type, x: 600, y: 400, data });
      await page.until(`Number(document.documentElement.dataset.compared) > ${before}`);
    };
    await drop(path.join(work, 'dull'));
    expect('a dropped folder is judged', (await page.run('mine.json')) + '\n' === native('dull', '--json') && (await page.run('mine.name')) === 'dull', await page.run('[mine.name, mine.files.map(file => file.path), mine.report?.headline]'));
    await drop(path.join(work, 'mine', 'color.npy'), path.join(work, 'mine', 'normal.npy'));
    expect('so are dropped files', await page.run('mine.files.length === 2 && mine.report.stages[5].buffers.length === 2'), await page.run('mine.files.map(file => file.path)'));
    // A folder that is chosen, and watched: a comparison begins once the files rest, not before.
    await give('mine');
    await page.run(`(() => {
      const files = mine.files.map(file => [lastName(file.path), file.bytes]);
      globalThis.folder = { name: 'mine', kind: 'directory', looks: 0, isWritten: false, async *values() {
        ++folder.looks;
        for (const [name, bytes] of files) yield { kind: 'file', name, getFile: async () => new File([bytes], name, { lastModified: name === 'color.npy' ? (folder.isWritten ? folder.looks : folder.stamp) : 1 }) };
      }, stamp: 1 };
      globalThis.showDirectoryPicker = async () => folder;
    })()`);
    const runs = await page.run('mine.run');
    await page.run('one("#mine .choosefolder").click()');
    await page.until(`Number(document.documentElement.dataset.compared) > ${runs}`);
    expect('a chosen folder is judged', (await page.run('mine.json')) + '\n' === native('mine', '--json') && (await page.run('one("#minefolder").textContent')).includes('watched'), await page.run('one("#minefolder").textContent'));
    for (let written = 0; written < 2; ++written) {
      const before = await page.run('(folder.isWritten = true, mine.run)'), looks = await page.run('folder.looks');
      await page.until(`folder.looks >= ${looks + 4}`);
      expect('while its files are written nothing is compared', (await page.run('mine.run')) === before);
      await page.run('folder.stamp = folder.looks + 1000, folder.isWritten = false');
      await page.until(`Number(document.documentElement.dataset.compared) > ${before}`);
      expect('and once when they rest', (await page.run('mine.run')) === before + 1, await page.run('mine.run'));
    }
    await page.run('mine.watching()');
    // Names that several cores have tried.
    await page.run('globalThis.askedOf = mine.helpers.length, workersOfNames = () => 3');
    await give('mine');
    expect('three cores give the verdict of one', await page.run('mine.helpers.length === 2') && (await page.run('mine.json')) + '\n' === native('mine', '--json'), await page.run('mine.report?.likely'));
    await page.run('workersOfNames = () => 1');
    // Another folder while names are tried; the page answers meanwhile.
    const before = await page.run('mine.run');
    const set = async name => page.ask('DOM.setFileInputFiles', { nodeId: (await page.ask('DOM.querySelector', { nodeId: (await page.ask('DOM.getDocument')).root.nodeId, selector: '#folderfield' })).nodeId, files: [path.join(work, name)] });
    await set('mine');
    await page.until(`mine.run === ${before + 1} && mine.report !== null && mine.isBusy`);
    expect('the page answers while names are tried', await page.run('new Promise(done => { one("#minehints summary").click(); requestAnimationFrame(() => done(one("#minehints").open)); })'));
    await set('dull');
    await page.until(`Number(document.documentElement.dataset.compared) === ${before + 2}`);
    expect('another folder meanwhile is judged alone', (await page.run('mine.json')) + '\n' === native('dull', '--json'), await page.run('mine.report?.headline'));
    // On paper: all is open, nothing is cut, controls are away.
    await page.ask('Emulation.setEmulatedMedia', { media: 'print' });
    for (const name of ['mine', 'right', 'dull']) {
      await page.ask('Emulation.setEmulatedMedia', { media: '' });
      await give(name);
      await page.until('!mine.isAsking');
      await page.ask('Emulation.setEmulatedMedia', { media: 'print' });
      await page.run('dispatchEvent(new Event("beforeprint"))');
      expect(`${name} on paper: all parts are open, controls are away`, await page.run('all("#minebox details").every(one => one.open) && all("#mine button:not(.strip button), .minebar, header").every(one => !one.checkVisibility())'), await page.run('all("#mine button:not(.strip button), .minebar, header").filter(one => one.checkVisibility()).map(one => one.outerHTML.slice(0, 60))'));
      expect(`${name} on paper: pictures stay whole`, await page.run('all(".pane").filter(one => one.checkVisibility()).every(one => getComputedStyle(one).breakInside === "avoid" && one.getBoundingClientRect().height < 900)'));
      if (shots) fs.writeFileSync(path.join(shots, `${name}-print.pdf`), Buffer.from((await page.ask('Page.printToPDF', { printBackground: true })).data, 'base64'));
    }
    await page.ask('Emulation.setEmulatedMedia', { media: '' });
    // Text twice as large.
    await page.run('document.documentElement.style.fontSize = "200%"');
    expect('text of 200 % does not scroll sideways', await fits(), await page.run('document.documentElement.scrollWidth'));
    await shot('mine-large');
    await page.run('document.documentElement.style.fontSize = ""');
    // Memory that is out ends the worker, not the page.
    await page.run('globalThis.askOfSide = Side.prototype.ask, Side.prototype.ask = () => Promise.reject(Object.assign(new Error("memory access out of bounds"), { isTrap: true })), compareMine()');
    await page.until('!one("#minetrouble").hidden');
    expect('memory that is out is said', (await page.run('one("#minetrouble").textContent')).startsWith('Not enough memory for 2 files of this size'), await page.run('one("#minetrouble").textContent'));
    await page.run('Side.prototype.ask = askOfSide');
    await give('mine');
    expect('and the page goes on', (await page.run('mine.json')) + '\n' === native('mine', '--json') && await page.run('one("#minetrouble").hidden'));
    // Less is given away.
    await page.run('one("#hints").value = "1", one("#hints").dispatchEvent(new Event("change"))');
    await page.until('mine.report?.hints.length === 1 && !mine.isBusy');
    expect('one hint gives no name and no place away', await page.run('one("#minelikely").hidden && one("#mineworst").hidden && mine.report.known.length === 0'));
    await page.run('one("#hints").value = "3", one("#hints").dispatchEvent(new Event("change"))');
    // Cancelled while names are tried: what the stages are stays.
    await page.until('mine.isBusy && mine.report !== null');
    await page.key('Escape');
    await page.until('!mine.isBusy && mine.report !== null');
    expect('after Cancel the stages stay', await page.run('mine.report.stages[2].verdict === "wrong here" && mine.report.known.length === 0'));
    // Of two scenes in a folder none is taken unasked.
    fs.cpSync(path.join(work, 'right'), path.join(work, 'two'), { recursive: true });
    fs.copyFileSync(path.join(work, 'right', 'check_me.toml'), path.join(work, 'two', 'another.toml'));
    await page.run('Object.assign(mine, { isChosen: false })');
    await set('two');
    await page.until('one("#minetrouble").textContent.startsWith("There are 2 scenes")');
    const asked = await page.run('mine.run');
    await page.run('one("#minescene").value = "check_me.toml", one("#minescene").dispatchEvent(new Event("change"))');
    await page.until(`Number(document.documentElement.dataset.compared) > ${asked}`);
    expect('the scene that is chosen is taken', await page.run('mine.report.exit === 0 && mine.scene.name === "check_me.toml"'), await page.run('mine.report?.headline'));
    // Files by themselves, a scene of the page, and what is no buffer.
    await give('', '#filesfield', [path.join(work, 'mine', 'color.npy'), path.join(work, 'mine', 'normal.npy')]);
    expect('files by themselves are compared', await page.run('mine.files.length === 2 && mine.report.stages[5].buffers.length === 2'), await page.run('mine.report?.stages'));
    fs.writeFileSync(path.join(work, 'notes.txt'), 'x');
    const { root } = await page.ask('DOM.getDocument'), { nodeId } = await page.ask('DOM.querySelector', { nodeId: root.nodeId, selector: '#filesfield' });
    await page.ask('DOM.setFileInputFiles', { nodeId, files: [path.join(work, 'notes.txt')] });
    await page.until('!one("#wrong").hidden');
    expect('other files are refused with all endings', await page.run('one("#wrong").textContent.includes("npy, png")'), await page.run('one("#wrong").textContent'));
    fs.mkdirSync(path.join(work, 'broken'));
    fs.writeFileSync(path.join(work, 'broken', 'color.png'), 'no picture');
    await page.run('one("#minescene").value = whole.known[0].file, one("#minescene").dispatchEvent(new Event("change"))');
    await page.until('!mine.isBusy');
    await page.ask('DOM.setFileInputFiles', { nodeId: (await page.ask('DOM.querySelector', { nodeId: (await page.ask('DOM.getDocument')).root.nodeId, selector: '#folderfield' })).nodeId, files: [path.join(work, 'broken')] });
    await page.until('one("#minetrouble").textContent.includes("color.png")');
    expect('a damaged file is said', await page.run('one("#minetrouble").textContent.includes("color.png")'), await page.run('one("#minetrouble").textContent'));
    expect('the starter is there', (await page.run('zipOf(Object.fromEntries(Object.entries(whole.starter))).size')) > 10000);
    const zip = Buffer.from(await page.run('zipOf({ "mine/check_me.toml": whole.starter["check_me.toml"], "mine/writer.py": whole.starter["writer.py"] }).arrayBuffer().then(all => btoa(String.fromCharCode(...new Uint8Array(all))))'), 'base64');
    fs.writeFileSync(path.join(work, 'mine.zip'), zip);
    const unpacked = spawnSync('python3', ['-c', 'import zipfile,sys; z=zipfile.ZipFile(sys.argv[1]); assert z.testzip() is None; print(z.read("mine/check_me.toml").decode(), end="")', path.join(work, 'mine.zip')], { encoding: 'utf8' });
    expect('and unpacks to its files', unpacked.stdout === fs.readFileSync(starter + 'check_me.toml', 'utf8'), unpacked.stderr);
    expect('the page asks nothing of the network', page.requests.every(one => /^(file|data|blob):/.test(one)), page.requests);
    expect('the page is silent', page.log.length === 0 || page.log.every(line => line.includes('Nothing here is')), page.log);
    await page.close();
  }
} finally {
  await browser.close();
}
