// Three lessons from their first page to their end, by the keyboard alone and by a finger alone: every question is answered
// or given up, every grip that a question needs is moved. Arguments: the program, and the core.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { launch } from './browser.mjs';

const [program] = process.argv.slice(2);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'shadescope-hands-'));
let failed = 0, held = 0;
/** @param {string} claim @param {any} true_ @param {any} [found] */
function expect(claim, true_, found = '') {
  if (true_) return void ++held;
  ++failed;
  console.log(`FAILED: ${claim}${found === '' ? '' : ': ' + JSON.stringify(found)}`);
}
const browser = await launch();
const kSteps = 120;
// Two pictures of the screen, and a frame that takes so long that another thread computes it.
const shown = p => p.run('new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(1))))');
const settle = async p => { await shown(p), await p.until('typeof running === "undefined" || !running'), await shown(p); };

/** What is right on each page: read by giving up on a page of its own. `place`: where the first grip is with that answer. */
async function answersOf(file) {
  const p = await browser.open(file, { width: 1366, height: 768 });
  const answers = await p.run(`(() => Array.from({ length: data.pages }, (_, i) => {
    openPage(i);
    if (!page.question) return { kind: 'none' };
    const { kind, options } = page.question, free = held.holds.map(hold => hold.keys).flat(), texts = options.map(option => plain(option.text));
    core.ask('show'), page = core.ask('read');
    const { solution, answer = [] } = page.question, said = plain(solution.answer);
    const isHeld = answer.length > 0 && answer.every(one => free.includes(one.split('=')[0]));
    if (isHeld) core.ask('set', answer.join('; ')), held = core.ask('holds');
    return { kind, said, right: texts.findIndex(text => said.includes(text)), values: isHeld ? answer : [], place: isHeld ? held.holds[0].place : null, isNumber: isHeld && held.holds[0].kind === 'number' };
    function plain(html) { const box = document.createElement('div'); fillHtml(box, html); return box.textContent.trim(); }
  }))()`);
  await p.close();
  return answers;
}
const isSettled = p => p.run('!page.question || page.question.settled');
const numberIn = text => text.replace(/−/g, '-').match(/-?[0-9.]+(?:e-?[0-9]+)?/)?.[0] ?? '0';

/** How far the values in the hand are from the answer's; directions by their angle. @param {string[]} values */
const distance = values => `((pairs) => {
  const now = pairs.map(([key]) => Number(settingOf(key).text)), to = pairs.map(([, value]) => Number(value));
  if (to.length === 1) return Math.abs(now[0] > 0 && to[0] > 0 ? Math.log(now[0] / to[0]) : now[0] - to[0]);
  const length = v => Math.hypot(...v), dot = now.reduce((sum, value, i) => sum + value * to[i], 0);
  return Math.acos(Math.max(-1, Math.min(1, dot / (length(now) * length(to)))));
})(${JSON.stringify(values)}.map(one => one.split('=')))`;

async function byKeys(name, file, answers) {
  const p = await browser.open(file, { width: 1366, height: 768 });
  const goTo = async selector => {
    for (let i = 0; i < 200; ++i) {
      if (await p.run(`document.activeElement.matches(${JSON.stringify(selector)})`)) return true;
      await p.key('Tab');
    }
    return false;
  };
  let right = 0;
  for (const [i, answer] of answers.entries()) {
    expect(`${name}, page ${i + 1} is reached by keys`, (await p.run('view.page')) === i, await p.run('view.page'));
    if (answer.kind === 'number' && await goTo('#typed'))
      for (const text of numberIn(answer.said)) await p.ask('Input.dispatchKeyEvent', { type: 'char', text });
    if (answer.kind === 'choice' && answer.right >= 0) await p.key(String(answer.right + 1));
    if (answer.values.length > 0 && await goTo('.grip')) {
      // Whichever arrow brings it nearer; large steps first.
      let best = await p.run(distance(answer.values));
      for (const shift of [8, 0])
        for (let round = 0, better = true; better && round < kSteps; ++round) {
          better = false;
          for (const [key, back] of [['ArrowRight', 'ArrowLeft'], ['ArrowLeft', 'ArrowRight'], ['ArrowUp', 'ArrowDown'], ['ArrowDown', 'ArrowUp']]) {
            await p.key(key, shift), await settle(p);
            const now = await p.run(distance(answer.values));
            if (now < best - 1e-9) { best = now, better = true; break; }
            await p.key(back, shift), await settle(p);
          }
        }
    }
    if (answer.kind === 'write' && await goTo('#code')) {
      await p.run('document.activeElement.select()'), await p.ask('Input.insertText', { text: answer.said }), await p.key('Enter', 2);
      await p.until('page.question.settled').catch(() => {});
      await p.key('Escape');  // the Tab key leaves the editor then
    } else if (answer.kind !== 'none' && answer.kind !== 'click' && await goTo('#answer button[type=submit]')) await p.key('Enter'), await settle(p);
    if (await isSettled(p)) ++right;
    else if (await goTo('#giveup')) await p.key('Enter'), await settle(p);
    expect(`${name}, page ${i + 1} is settled by keys`, await isSettled(p), answer);
    for (let tries = 0; tries < 3 && (await p.run('view.page')) === i && await p.run('document.querySelector("#end").hidden'); ++tries)
      if (await goTo('#goon:not([hidden]), #next:not([hidden])')) await p.key('Enter'), await settle(p);
  }
  expect(`${name} ends by keys`, await p.run('!document.querySelector("#end").hidden'));
  expect(`${name} by keys writes nothing to the console`, p.log.length === 0, p.log);
  await p.close();
  return right;
}

async function byFinger(name, file, answers) {
  const p = await browser.open(file, { width: 390, height: 844, mobile: true });
  await p.ask('Emulation.setTouchEmulationEnabled', { enabled: true });
  const touch = (type, points) => p.ask('Input.dispatchTouchEvent', { type, touchPoints: points });
  const middleOf = selector => p.run(`(part => { part.scrollIntoView({ block: 'center' }); const b = part.getBoundingClientRect(); return { x: b.x + b.width / 2, y: b.y + b.height / 2 }; })(document.querySelector(${JSON.stringify(selector)}))`);
  const tap = async selector => {
    const at = await middleOf(selector);
    await touch('touchStart', [at]), await touch('touchEnd', []), await settle(p);
  };
  let right = 0;
  for (const [i, answer] of answers.entries()) {
    expect(`${name}, page ${i + 1} is reached by a finger`, (await p.run('view.page')) === i, await p.run('view.page'));
    if (answer.kind === 'number') await tap('#typed'), await p.ask('Input.insertText', { text: numberIn(answer.said) });
    if (answer.kind === 'choice' && answer.right >= 0) await tap(`#answer .option:nth-child(${answer.right + 1}) input`);
    if (answer.place) {
      await p.run('scrollTo(0, 0)'), await settle(p);
      const from = await middleOf('.grip'), before = await p.run('scrollY');
      const to = await p.run(`(grip => { const room = document.querySelector(grip.onAxis ? '#figure' : '#room').getBoundingClientRect(); let at; if (grip.kind === 'number') { const [[x0, y0], [x1, y1]] = trackOf(grip), share = ${answer.place[0]}; at = [x0 + share * (x1 - x0), y0 + share * (y1 - y0)]; } else at = onRoom(grip.cell, ${JSON.stringify(answer.place)}); return { x: room.left + at[0], y: room.top + at[1] }; })(grips[0])`);
      await touch('touchStart', [from]);
      for (let step = 1; step <= 6; ++step) await touch('touchMove', [{ x: from.x + (to.x - from.x) * step / 6, y: from.y + (to.y - from.y) * step / 6 }]), await settle(p);
      await touch('touchEnd', []), await settle(p);
      expect(`${name}, page ${i + 1}: a drag scrolls nothing`, (await p.run('scrollY')) === before);
    }
    if (answer.kind === 'write') await tap('#code'), await p.run('document.activeElement.select()'), await p.ask('Input.insertText', { text: answer.said });
    if (answer.kind !== 'none' && answer.kind !== 'click') await tap('#answer button[type=submit]');
    // Written lines run in a worker, and what is said of them moves what stands below.
    if (answer.kind === 'write') await p.until('page.question.settled').catch(() => {});
    if (await isSettled(p)) ++right;
    else await tap('#giveup');
    expect(`${name}, page ${i + 1} is settled by a finger`, await isSettled(p), answer);
    for (let tries = 0; tries < 3 && (await p.run('view.page')) === i && await p.run('document.querySelector("#end").hidden'); ++tries)
      await tap(await p.run('document.querySelector("#goon").hidden') ? '#next' : '#goon');
  }
  expect(`${name} ends by a finger`, await p.run('!document.querySelector("#end").hidden'));
  expect(`${name} by a finger writes nothing to the console`, p.log.length === 0, p.log);
  await p.close();
  return right;
}

try {
  for (const name of ['diffuse', 'depth-precision', 'highlight']) {
    const page = path.join(folder, name + '.html'), file = 'file://' + page;
    execFileSync(program, ['lesson', 'export', name, '--live', '-o', page], { stdio: ['ignore', 'ignore', 'inherit'] });
    const answers = await answersOf(file + '?page=1');
    // Numbers, choices and what is held can be answered; the rest is given up. Some are rounded more than
    // is accepted, and a finger's pixel is more than two of the picture: the rim of a highlight is not always hit.
    const answerable = answers.filter(one => one.kind === 'number' || (one.kind === 'choice' && one.right >= 0) || one.values.length > 0).length;
    const keys = await byKeys(name, file + '?page=1', answers), finger = await byFinger(name, file + '?page=1', answers);
    console.log(`${name}: ${answers.length} pages, ${answerable} answered, right by keys ${keys}, by finger ${finger}`);
    expect(`what is answered of ${name} by keys is right`, keys >= answerable - 1, [keys, answerable]);
    expect(`what is answered of ${name} by a finger is right`, finger >= answerable - 2, [finger, answerable]);
  }
} finally {
  await browser.close();
  fs.rmSync(folder, { recursive: true, force: true });
}
console.log(`${held} claims hold, ${failed} do not`);
process.exitCode = failed === 0 ? 0 : 1;
