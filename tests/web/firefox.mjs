// A live page, a page with a worker, lines of the reader's own, and a talk in Firefox: what a reader sees and does, by its own remote protocol
// (Marionette: "LENGTH:JSON" over a local socket). Arguments: the program, and a cue list.
import { execFileSync, spawn, spawnSync } from 'node:child_process';
import fs from 'node:fs';
import net from 'node:net';
import path from 'node:path';
import { expect, folder } from './claims.mjs';
import { hostile, right } from './hostile.mjs';

const [program, cues] = process.argv.slice(2);
const pause = ms => new Promise(done => setTimeout(done, ms));

async function freePort() {
  const server = net.createServer().listen(0, '127.0.0.1');
  await new Promise(done => server.once('listening', done));
  const { port } = /** @type {any} */ (server.address());
  await new Promise(done => server.close(done));
  return port;
}

async function launch() {
  const profile = path.join(folder, 'profile'), port = await freePort();
  fs.mkdirSync(profile);
  fs.writeFileSync(path.join(profile, 'user.js'), `user_pref("marionette.port", ${port});\nuser_pref("browser.shell.checkDefaultBrowser", false);\nuser_pref("datareporting.policy.dataSubmissionEnabled", false);\nuser_pref("network.dns.disabled", true);\n`);
  const child = spawn(process.env.FIREFOX || 'firefox-esr', ['--headless', '--marionette', '--profile', profile, 'about:blank'],
    { stdio: 'ignore', env: { ...process.env, HOME: folder, MOZ_REMOTE_SETTINGS_DEVTOOLS: '1' } });
  /** @type {any} */
  let socket = null;
  for (let tries = 0; tries < 600 && !socket; ++tries) {
    const one = net.connect(port, '127.0.0.1');
    socket = await new Promise(done => one.once('connect', () => done(one)).once('error', () => done(null)));
    if (!socket) await pause(200);
  }
  const waiting = new Map();
  let bytes = Buffer.alloc(0), count = 0;
  socket.on('data', chunk => {
    bytes = Buffer.concat([bytes, chunk]);
    for (;;) {
      const colon = bytes.indexOf(58), length = colon < 0 ? NaN : Number(bytes.subarray(0, colon));
      if (!(bytes.length >= colon + 1 + length)) return;
      const message = JSON.parse(bytes.subarray(colon + 1, colon + 1 + length).toString());
      bytes = bytes.subarray(colon + 1 + length);
      if (!Array.isArray(message)) continue;  // its greeting
      const [, id, error, result] = message, [done, fail] = waiting.get(id) || [];
      if (error) fail?.(new Error(error.message));
      else done?.(result);
    }
  });
  const send = (name, parameters = {}) => new Promise((done, fail) => {
    waiting.set(++count, [done, fail]);
    const text = JSON.stringify([0, count, name, parameters]);
    socket.write(`${Buffer.byteLength(text)}:${text}`);
  });
  await send('WebDriver:NewSession', { capabilities: { alwaysMatch: { pageLoadStrategy: 'normal' } } });
  const run = async script => (await send('WebDriver:ExecuteScript', { script: 'return ' + script, args: [] })).value;
  const until = async script => {
    for (let tries = 0; tries < 3000; ++tries) {
      if (await run(script)) return true;
      await pause(20);
    }
    return false;
  };
  const close = async () => {
    const ended = new Promise(done => child.once('exit', done));
    await send('Marionette:Quit', { flags: ['eForceQuit'] }).catch(() => {});
    setTimeout(() => child.kill(), 5000).unref();
    await ended;
  };
  const shot = async file => fs.writeFileSync(file, Buffer.from((await send('WebDriver:TakeScreenshot', { full: false })).value, 'base64'));
  const key = async value => send('WebDriver:PerformActions', { actions: [{ type: 'key', id: 'keys', actions: [{ type: 'keyDown', value }, { type: 'keyUp', value }] }] });
  /** Chooses files in a field. @param {string} selector @param {string[]} files */
  const give = async (selector, files) => {
    const { value } = await send('WebDriver:FindElement', { using: 'css selector', value: selector });
    await send('WebDriver:ElementSendKeys', { id: Object.values(value)[0], text: files.join('\n') });
  };
  /** By mouse, from the middle of a part. @param {string} selector @param {number} dx @param {number} dy CSS pixels */
  const drag = async (selector, dx, dy) => {
    const [x, y] = await run(`(box => [box.x + box.width / 2, box.y + box.height / 2].map(Math.round))(document.querySelector(${JSON.stringify(selector)}).getBoundingClientRect())`);
    const move = (toX, toY) => ({ type: 'pointerMove', x: toX, y: toY, duration: 0 });
    await send('WebDriver:PerformActions', { actions: [{ type: 'pointer', id: 'mouse', parameters: { pointerType: 'mouse' }, actions: [move(x, y), { type: 'pointerDown', button: 0 }, move(x + dx / 2, y + dy / 2), move(x + dx, y + dy), { type: 'pointerUp', button: 0 }] }] });
  };
  const size = (width, height) => send('WebDriver:SetWindowRect', { width, height });
  return { give, drag, size, open: url => send('WebDriver:Navigate', { url }), run, until, key, shot, close };
}

const write = (name, ...args) => {
  const file = path.join(folder, name);
  execFileSync(program, [...args, '-o', file], { stdio: ['ignore', 'ignore', 'ignore'] });
  return 'file://' + file;
};
const kReady = 'document.documentElement.dataset.ready === "1" || !document.querySelector("#wrong").hidden';
const firefox = await launch();
try {
  await firefox.open(write('pyramid.html', 'export', 'pyramid', '--live'));
  expect('a page starts', await firefox.until(kReady) && await firefox.run('document.querySelector("#wrong").hidden'), await firefox.run('document.querySelector("#wrong").textContent'));
  expect('it has its style', await firefox.run('getComputedStyle(document.querySelector(".app")).display === "grid"'));
  expect('an equation is laid out', await firefox.run('document.querySelector(".equation math").getBoundingClientRect().width > 5'));
  const picture = `(c => c.getContext('2d').getImageData(0, 0, c.width, c.height).data.reduce((hash, byte) => (hash * 31 + byte) | 0, 0))(document.querySelector('.frame canvas[role=img]'))`;
  const before = await firefox.run(picture), numbers = await firefox.run('document.querySelector(".equation").textContent');
  await firefox.run(`(s => { s.value = '3'; s.dispatchEvent(new Event('input', { bubbles: true })); })(document.getElementById('set-material.0.n'))`);
  expect('a slider moves the equation', await firefox.until(`document.querySelector('.equation').textContent !== ${JSON.stringify(numbers)}`));
  expect('and the picture', (await firefox.run(picture)) !== before);
  await firefox.key('5');
  expect('5 goes to the end of the z-buffer', await firefox.until('document.querySelector("#stages li:nth-child(5) button").hasAttribute("aria-current")'));
  expect('fetch is refused', await firefox.run('fetch("https://example.org/").then(() => false, () => true)'));
  if (process.env.SHADESCOPE_SHOTS) await firefox.shot(path.join(process.env.SHADESCOPE_SHOTS, 'firefox.png'));

  // 50 ms and more a frame, on any machine of today.
  await firefox.open(write('soft.html', 'export', 'soft_shadow', '--size', '960x720', '--live'));
  expect('a page with soft shadows starts', await firefox.until(kReady) && await firefox.run('document.querySelector("#wrong").hidden'));
  const first = await firefox.run(picture);
  await firefox.run(`(s => { s.value = '0.3'; s.dispatchEvent(new Event('input', { bubbles: true })); })(document.getElementById('set-light.0.intensity'))`);
  expect('its worker draws', await firefox.until(`${picture} !== ${first}`), await firefox.run('document.querySelector("#wrong").textContent'));

  // Pages that are held: a lamp, a number on its axis, a vertex, by keys and by mouse. The words at the grip say where it is.
  await firefox.size(1366, 768);
  for (const [name, answer] of [['diffuse', '48'], ['depth-precision', 'In its upper half'], ['pyramid', 'They name it by number']]) {
    await firefox.open(write(`${name}-held.html`, 'lesson', 'export', name, '--live') + '?page=1');
    expect(`${name} starts`, await firefox.until(kReady) && await firefox.run('document.querySelector("#wrong").hidden'), await firefox.run('document.querySelector("#wrong").textContent'));
    const words = 'document.querySelector(".grip:not([hidden])").getAttribute("aria-valuetext")', heading = 'document.querySelector("#heading").textContent';
    const own = await firefox.run(words), first = await firefox.run(heading);
    await firefox.run('void document.querySelector(".grip:not([hidden])").focus()');
    await firefox.key('\uE014');  // Right
    expect(`an arrow key moves what ${name} holds`, await firefox.until(`${words} !== ${JSON.stringify(own)}`), own);
    await firefox.key('\uE011');  // Home
    expect(`${name}: Home puts it back`, await firefox.until(`${words} === ${JSON.stringify(own)}`), await firefox.run(words));
    await firefox.drag('.grip:not([hidden])', 60, -20);
    expect(`a drag moves what ${name} holds`, await firefox.until(`${words} !== ${JSON.stringify(own)}`), own);
    const moved = await firefox.run(words);
    await firefox.run(`void (field => { if (field) field.value = ${JSON.stringify(answer)}; else [...document.querySelectorAll('#answer .option')].find(option => option.textContent.includes(${JSON.stringify(answer)})).querySelector('input').click(); document.querySelector('#answer').requestSubmit(); })(document.querySelector('#typed'))`);
    expect(`${name} is answered`, await firefox.until('document.querySelector("#question").classList.contains("right")'), await firefox.run('document.querySelector("#said").textContent'));
    if (name === 'diffuse') expect('what is held stays in the hand', (await firefox.run(words)) === moved, [moved, await firefox.run(words)]);
    if (process.env.SHADESCOPE_SHOTS) await firefox.shot(path.join(process.env.SHADESCOPE_SHOTS, `firefox-${name}.png`));
    await firefox.run('void document.querySelector("#next").click()');
    expect(`${name} goes on`, await firefox.until(`${heading} !== ${JSON.stringify(first)}`), first);
  }

  // The program in one page: files, links, widths, and nothing asked of the network.
  const one = write('shadescope.html', 'site', 'export', '--one'), mineFolder = path.join(folder, 'mine');
  await firefox.open(one + '#mine');
  expect('the program in one page starts', await firefox.until(kReady) && await firefox.run('document.querySelector("#wrong").hidden'), await firefox.run('document.querySelector("#wrong").textContent'));
  // What the page declares with let and const is not seen from here: the document is, and its functions.
  execFileSync(program, ['export', 'pyramid', '--format', 'npy,scene', '--size', '64x48', '--buffers', 'color,z_view,normal', '-o', mineFolder], { stdio: 'ignore' });
  execFileSync(program, ['export', 'pyramid', '--format', 'npy', '--size', '64x48', '--buffers', 'normal', '--set', 'defect=normal-matrix', '-o', path.join(folder, 'wrong')], { stdio: 'ignore' });
  fs.copyFileSync(path.join(folder, 'wrong', 'normal.npy'), path.join(mineFolder, 'normal.npy'));
  const given = fs.readdirSync(mineFolder).filter(name => name !== 'manifest.json'), buffers = given.filter(name => name.endsWith('.npy'));
  const native = spawnSync(program, ['compare', 'pyramid.toml', ...buffers], { cwd: mineFolder, encoding: 'utf8' }).stdout;
  const compared = 'Number(document.documentElement.dataset.compared || 0)', text = 'document.querySelector("#minetext").textContent';
  await firefox.give('#filesfield', given.map(name => path.join(mineFolder, name)));
  expect('files are judged', await firefox.until(`${compared} > 0`), await firefox.run('document.querySelector("#wrong").textContent + document.querySelector("#minetrouble").textContent'));
  expect('as the program judges them', (await firefox.run(text)) + '\n' === native, [await firefox.run(text), native]);
  // The same files by a drop: its items have no folders and no handles.
  const files = JSON.stringify(given.map(name => [name, fs.readFileSync(path.join(mineFolder, name)).toString('base64')])), dropped = await firefox.run(compared);
  await firefox.run(`(() => { const transfer = new DataTransfer(); for (const [name, base64] of ${files}) transfer.items.add(new File([Uint8Array.from(atob(base64), letter => letter.charCodeAt(0))], name)); document.body.dispatchEvent(new DragEvent('drop', { bubbles: true, cancelable: true, dataTransfer: transfer })); })()`);
  expect('dropped files are judged alike', await firefox.until(`${compared} > ${dropped}`) && (await firefox.run(text)) + '\n' === native, await firefox.run(text));
  const inScene = 'document.documentElement.dataset.place === "scene" && !document.documentElement.classList.contains("working") && document.querySelector("#pixelhead").checkVisibility()';
  await firefox.run('location.hash = "#scene=z_buffer_phong"'), await firefox.until(inScene);
  await firefox.run('(pick([200, 180]), show(1, "normal"))'), await firefox.until(inScene);
  const state = '[linkNow().hash, document.querySelector("#why").textContent].join()', link = await firefox.run('linkNow().hash'), asked = await firefox.run(state);
  await firefox.run('location.hash = "#start"'), await firefox.until('document.documentElement.dataset.place === "start"');
  await firefox.run(`location.hash = ${JSON.stringify(link)}`), await firefox.until(inScene);
  expect('a link opens a state again', link.includes('at=200,180') && (await firefox.run(state)) === asked, [link, await firefox.run('linkNow().hash')]);
  for (const width of [500, 768, 1280, 1366])  // Firefox has no narrower window
    for (const hash of ['#start', '#mine', '#bug&seed=2026.1', '#check']) {
      await firefox.size(width, 768);
      await firefox.run(`location.hash = ${JSON.stringify(hash)}`);
      await firefox.until(`document.documentElement.dataset.place === ${JSON.stringify(/[a-z]+/.exec(hash)[0])}`);
      expect(`${hash} does not scroll sideways at ${width}`, await firefox.run('document.documentElement.scrollWidth <= innerWidth'), await firefox.run('[document.documentElement.scrollWidth, innerWidth]'));
    }
  // Scripts of this test run beside the page's, where the page's policy forbids no eval: Chromium's test asks for that.
  expect('nothing is fetched', await firefox.run('fetch("https://example.org/").then(() => false, () => true)'));
  expect('the page has asked for its file alone', await firefox.run('performance.getEntriesByType("resource").every(entry => /^(file|data|blob):/.test(entry.name))'), await firefox.run('performance.getEntriesByType("resource").map(entry => entry.name)'));
  if (process.env.SHADESCOPE_SHOTS) await firefox.shot(path.join(process.env.SHADESCOPE_SHOTS, 'firefox-check.png'));

  // Lines of the reader's own, right, wrong, and meaning harm.
  const page = JSON.parse(execFileSync(program, ['lesson', 'show', 'diffuse', '--json'], { encoding: 'utf8', maxBuffer: 1 << 26 })).pages.filter(one => !one.returns).findIndex(one => one.question?.kind === 'write') + 1;
  await firefox.open(`${write('diffuse.html', 'lesson', 'export', 'diffuse', '--live')}?page=${page}`);
  expect('a page with an editor starts', await firefox.until(kReady) && await firefox.run('document.querySelector("#code") !== null'));
  const lines = async text => {
    await firefox.run(`void (document.querySelector('#said').replaceChildren(), document.querySelector('#code').value = ${JSON.stringify(text)}, document.querySelector('#run').click())`);
    return await firefox.until('document.querySelector("#said .mark") !== null && document.querySelector("#run").firstChild.nodeValue === "Run"') ? firefox.run('document.querySelector("#said").innerText') : 'no verdict';
  };
  for (const [name, { text, said }] of Object.entries(hostile)) {
    const found = await lines(text);
    expect(`${name}: ${said}`, said.test(found) && !/^● Right/.test(found), found);
  }
  expect('the page lives, and nothing reached it', await firefox.run('document.querySelector("#heading").textContent === "Your own lambert" && typeof evil === "undefined" && !document.querySelector("#app img")'));
  for (const [name, text] of Object.entries(right)) {
    const said = await lines(text);
    expect(`right: ${name}`, /^● Right/.test(said), said);
  }
  if (process.env.SHADESCOPE_SHOTS) await firefox.shot(path.join(process.env.SHADESCOPE_SHOTS, 'firefox-write.png'));

  let talk = '';
  try {
    talk = write('talk.html', 'present', 'export', cues);
  } catch (error) {
    if (error.status !== 2) throw error;  // this build draws no views
  }
  if (talk) {
    await firefox.open(talk);
    expect('a talk starts', await firefox.until(kReady.split(' ||')[0]));
    await firefox.key('\uE00F');  // Page Down
    expect('Page Down shows the second cue', await firefox.until('document.querySelectorAll(".cue.shown").length === 1 && document.querySelectorAll(".cue")[1].matches(".shown")'));
    expect('with its pictures', await firefox.run('[...document.querySelectorAll(".cue.shown img")].every(image => image.naturalWidth > 0 && image.clientHeight > 100)'));
    await firefox.key('b');
    expect('B makes the screen black', await firefox.until('!document.querySelector("#cover").hidden'));
  }
} finally {
  await firefox.close();
}
