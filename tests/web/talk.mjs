// What a talk as a page promises, asked of one in Chromium with the network off. Arguments: the program, and a cue list.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { launch } from './browser.mjs';
import { expect, folder, leaveOut } from './claims.mjs';

const [program, cues] = process.argv.slice(2);
const file = path.join(folder, 'talk.html'), url = 'file://' + file;
try {
  execFileSync(program, ['present', 'export', cues, '-o', file], { stdio: ['ignore', 'ignore', 'inherit'] });
} catch (error) {
  if (error.status !== 2) throw error;
  leaveOut('this build draws no views');
}

const list = fs.readFileSync(cues, 'utf8'), names = [...list.matchAll(/^name = "(.*)"$/gm)].map(match => match[1]);
const notes = [...list.matchAll(/^note = '''\n([^]*?)'''$/gm)].map(match => match[1]);
const browser = await launch();
try {
  const t = await browser.open(url);
  const text = selector => t.run(`document.querySelector(${JSON.stringify(selector)}).textContent`);
  const shown = () => t.run('[...document.querySelectorAll(".cue")].filter(cue => cue.offsetParent !== null).map(cue => cue.querySelector("h2").textContent)');
  expect('it begins with the first cue alone', (await shown()).join() === names[0], await shown());
  expect('every cue is there', (await t.run('cues.map(nameOf).join("\\n")')) === names.join('\n'));
  expect('every cue has a picture of each view', await t.run('cues.every(cue => cue.querySelectorAll(".view").length > 0 && [...cue.querySelectorAll(".view")].every(view => view.querySelector("img")?.naturalWidth > 0))'));
  expect('every picture has words', await t.run('[...document.images].every(image => image.alt.length > 3)'));
  expect('the notes are not for the audience', await t.run('[...document.querySelectorAll(".said")].every(note => note.offsetParent === null)'));
  const keys = [['PageDown', 1], ['ArrowRight', 2], ['PageUp', 1], ['ArrowLeft', 0]];
  for (const [key, at] of keys) {
    await t.key(key);
    expect(`${key} shows cue ${at + 1}`, (await shown()).join() === names[at], await shown());
  }
  await t.key('ArrowLeft');
  expect('before the first cue is none', (await t.run('at')) === 0);
  expect('the address names the cue', await t.run('location.hash === "#1"'));
  await t.key('b');
  expect('B makes the screen black', await t.run('!one("#cover").hidden && getComputedStyle(one("#cover")).backgroundColor === "rgb(0, 0, 0)" && one("#cover").getBoundingClientRect().width >= innerWidth'));
  await t.key('b');
  expect('and shows it again', await t.run('one("#cover").hidden'));
  await t.key('.'), await t.key('PageDown');
  expect('the next cue is seen', (await t.run('one("#cover").hidden')) && (await shown()).join() === names[1]);
  await t.key('1');
  expect('1 shows the first view alone', (await t.run('all(".view", cues[at]).filter(view => view.offsetParent !== null).length')) === 1);
  await t.key('0');
  expect('0 shows all views', (await t.run('all(".view", cues[at]).filter(view => view.offsetParent !== null).length')) === (await t.run('all(".view", cues[at]).length')));

  // The lecturer's window: a gesture opens it, as the key is one.
  const before = (await t.ask('Target.getTargets')).targetInfos.length;
  await t.run('go(0)');
  await t.key('n');
  await t.until('lecturer && lecturer.document.querySelector(".said")');
  expect('N opens a second window', (await t.ask('Target.getTargets')).targetInfos.length === before + 1);
  expect('with the note', (await t.run('lecturer.document.querySelector(".said").textContent')) === notes[0]);
  expect('the next cue', await t.run('lecturer.document.body.textContent.includes("Next: ' + names[1] + '")'));
  expect('and the time that is left', /45:00 left|\d+:\d\d left/.test(await t.run('lecturer.document.querySelector("#time").textContent')));
  expect('it has its style', await t.run('lecturer.getComputedStyle(lecturer.document.body).display === "grid"'));
  await t.run('lecturer.document.body.dispatchEvent(new lecturer.KeyboardEvent("keydown", { key: "PageDown", bubbles: true }))');
  expect('the keys work there', (await shown()).join() === names[1]);
  expect('and its note goes along', (await t.run('lecturer.document.querySelector(".said").textContent')) === notes[1]);
  await t.run('lecturer.close()');

  expect('the equation is MathML', await t.run('[...document.querySelectorAll(".equation")].length > 0 && [...document.querySelectorAll(".equation math")].every(math => math.namespaceURI.endsWith("MathML"))'));
  expect('eval is refused', await t.run('(() => { try { (0, eval)("1"); return false; } catch { return true; } })()'));
  expect('fetch is refused', await t.run('fetch("https://example.org/").then(() => false, () => true)'));
  const { nodes } = await t.ask('Accessibility.getFullAXTree');
  const nameless = nodes.filter(node => !node.ignored && ['button', 'image'].includes(node.role?.value) && !node.name?.value);
  expect('every control has a name', nameless.length === 0, nameless.map(node => node.role.value));
  expect('nothing was asked of the network', t.requests.every(one => /^(file|data|blob|about):/.test(one) || one === 'https://example.org/'), t.requests.filter(one => !one.startsWith('data:')));
  expect('no error was written', t.log.filter(line => !line.includes('Content Security Policy')).length === 0, t.log);
  await t.close();

  for (const [width, height] of [[320, 640], [390, 844], [640, 400], [1280, 800], [1920, 1080]]) {
    const n = await browser.open(url + '#3', { width, height, mobile: width < 500, dark: width === 390 });
    expect(`#3 opens the third cue at ${width}`, (await n.run('at')) === 2);
    expect(`no scrolling sideways at ${width}`, await n.run('document.documentElement.scrollWidth <= innerWidth'), await n.run('document.documentElement.scrollWidth'));
    expect(`pictures are seen at ${width}`, await n.run('cues.every((cue, i) => (show(i), all(".view img", cue).every(image => image.clientHeight > 60)))'));
    if (width >= 1280) {
      const cut = await n.run('cues.map((cue, i) => (show(i), cue.scrollHeight > cue.clientHeight + 1 || all(".view img", cue).some(image => image.clientHeight < innerHeight / 8) ? nameOf(cue) : "")).filter(name => name)');
      expect(`every cue is whole at ${width}`, cut.length === 0, cut);
    }
    await n.close();
  }
  const paper = await browser.open(url, { scripts: false });
  let seen = 0;
  for (let tries = 0; tries < 500 && seen < names.length; ++tries) {
    const { root } = await paper.ask('DOM.getDocument');
    seen = (await paper.ask('DOM.querySelectorAll', { nodeId: root.nodeId, selector: '.cue .said' }).catch(() => ({ nodeIds: [] }))).nodeIds.length;
    await new Promise(done => setTimeout(done, 10));
  }
  expect('without scripts every cue is there with its note', seen === names.length, seen);
  await paper.close();
} finally {
  await browser.close();
}
