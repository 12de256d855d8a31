// Lesson pages that are held: what a hand moves, what it may not tell, by mouse, finger and keys. Arguments: the program,
// and the core.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { launch } from './browser.mjs';
import { expect, folder } from './claims.mjs';

const [program] = process.argv.slice(2), shots = process.env.SHADESCOPE_SHOTS;
const kSizes = [['390', { width: 390, height: 844, mobile: true }, ''], ['1366', { width: 1366, height: 768 }, ''], ['projector', { width: 1280, height: 720 }, '&projector=1'], ['dark', { width: 1366, height: 768, dark: true }, '']];
const write = name => {
  const file = path.join(folder, name + '.html');
  execFileSync(program, ['lesson', 'export', name, '--live', '-o', file], { stdio: ['ignore', 'ignore', 'inherit'] });
  return 'file://' + file;
};
const middle = selector => `(b => [b.x + b.width / 2, b.y + b.height / 2, b.width, b.height])(document.querySelector(${JSON.stringify(selector)}).getBoundingClientRect())`;

const browser = await launch();
/** A drag by mouse, in a few moves. */
async function drag(p, from, to, { release = true, modifiers = 0 } = {}) {
  const mouse = (type, [x, y]) => p.ask('Input.dispatchMouseEvent', { type, x, y, button: 'left', buttons: 1, clickCount: 1, modifiers });
  await mouse('mousePressed', from);
  for (let i = 1; i <= 5; ++i) await mouse('mouseMoved', from.map((v, k) => v + (to[k] - v) * i / 5)), await settle(p);
  if (release) await mouse('mouseReleased', to);
  await settle(p);
}
// Two pictures of the screen, and a frame that takes so long that another thread computes it.
const shown = p => p.run('new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(1))))');
const settle = async p => { await shown(p), await p.until('typeof running === "undefined" || !running'), await shown(p); };
const picture = '(c => { const d = c.getContext("2d").getImageData(0, 0, c.width, c.height).data; let h = 0; for (let i = 0; i < d.length; ++i) h = (h * 31 + d[i]) | 0; return h; })(cells[0].canvases[0])';

/** What a number or a choice is judged with the page's own values, and with every hand three coarse steps away: the answer
 * that the page gives, or every option. */
const verdictsMoved = `(() => {
  const mark = given => (core.call('check', JSON.stringify(given)) ? JSON.parse(core.text()).mark : 'settled');
  const pages = judge => {
    localStorage.clear(), takeLesson(data);
    return Array.from({ length: data.pages }, (_, i) => {
      openPage(i);
      return page.question && held.holds.length && ['number', 'choice'].includes(page.question.kind) ? judge(page.question, i) : '';
    });
  };
  const said = pages(() => (core.ask('show'), core.ask('read').question.solution.answer.replace(/<[^>]*>/g, '').replaceAll('−', '-').match(/-?[0-9.]+/)?.[0] ?? ''));
  const marks = steps => pages((question, i) => {
    for (let step = 0; step < steps; ++step) held.holds.forEach((_, number) => core.ask('set', core.ask('nudge', number, 1, -1, 1)));
    core.call('frame', 0);
    return question.kind === 'number' ? mark({ typed: said[i] }) : question.options.map((_, option) => mark({ chosen: [option] })).join();
  });
  const own = marks(0), moved = marks(3);
  return own.map((mark, i) => [i + 1, mark, moved[i]]).filter(([, before, after]) => before !== after);
})()`;
/** Of steps of the hand on the first page: how often one is laid out, and what it asks the core twice. */
async function workOfSteps(p) {
  const kSteps = 20, steps = `for (let i = 0; i < ${kSteps}; ++i) { asked.length = 0, isLong = false; putHand(core.ask('nudge', 0, i % 2 ? 1 : -1, 0, 1)); document.body.offsetHeight; }`;
  if (!await p.run('openPage(0), held.holds.length > 0')) return { layouts: 0, twice: [] };
  await p.run(`asked = [], Core.prototype.call = (call => function (name, ...values) { asked.push([name, ...values].join()); return call.call(this, name, ...values); })(Core.prototype.call)`);
  await settle(p);
  const before = await p.metrics(), twice = await p.run(`(() => { ${steps} return asked.filter((one, i) => asked.indexOf(one) < i); })()`);
  return { layouts: Math.floor(((await p.metrics()).LayoutCount - before.LayoutCount) / kSteps), twice };
}
/** Of each first half with something to hold: a question out of view, grips too small or over one another, words cut off. */
const layoutOfHeld = `(async () => {
  const wrong = [], boxOf = part => part.getBoundingClientRect();
  localStorage.clear(), takeLesson(data);
  for (let i = 0; i < data.pages; ++i) {
    openPage(i);
    if (!page.question || !grips.some(grip => grip.number >= 0)) continue;
    scrollTo(0, 0);
    for (let frame = 0; frame < 3; ++frame) await new Promise(done => requestAnimationFrame(done));
    const shown = grips.filter(grip => !grip.button.hidden), stage = boxOf(one('.stage'));
    if (boxOf(one('#asked')).bottom > innerHeight) wrong.push([i + 1, 'the question ends at', Math.round(boxOf(one('#asked')).bottom)]);
    if (document.documentElement.scrollWidth > innerWidth) wrong.push([i + 1, 'scrolls sideways']);
    for (const { name, button, bubble } of shown) {
      if (button.offsetWidth < 44 || button.offsetHeight < 44) wrong.push([i + 1, name, 'is small']);
      const b = boxOf(bubble);
      if (!bubble.hidden && (b.left < stage.left - 1 || b.right > stage.right + 1 || b.top < stage.top - 1)) wrong.push([i + 1, name, 'has its words cut off']);
    }
    shown.forEach(({ name, button }, k) => shown.slice(0, k).forEach(other => {
      const a = boxOf(button), b = boxOf(other.button), over = Math.min(Math.min(a.right, b.right) - Math.max(a.left, b.left), Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top));
      if (over > 8) wrong.push([i + 1, name, 'is over', other.name, Math.round(over)]);
    }));
  }
  return wrong;
})()`;

try {
  const names = JSON.parse(execFileSync(program, ['lesson', 'list', '--json'], { encoding: 'utf8' })).map(lesson => lesson.name);
  const files = Object.fromEntries(['pyramid', 'diffuse', 'depth-precision', 'smooth', 'z-buffer', 'highlight'].map(name => [name, write(name)]));

  // Whatever half holds something: its grips are large, in the room, and a way there and back is the same.
  for (const [name, file] of Object.entries(files).slice(0, 4))
    for (const [size, options, query] of kSizes) {
      const p = await browser.open(`${file}?page=1${query}`, options);
      expect(`${name} starts at ${size}`, await p.run('document.querySelector("#wrong").hidden'), await p.run('document.querySelector("#wrong").textContent'));
      const small = await p.run('grips.filter(grip => !grip.button.hidden && (grip.button.offsetWidth < 44 || grip.button.offsetHeight < 44)).length');
      expect(`${name}: grips have 44 px at ${size}`, (await p.run('grips.length')) > 0 && small === 0, small);
      const cut = await p.run('grips.filter(grip => { const b = grip.bubble.getBoundingClientRect(), s = document.querySelector(".stage").getBoundingClientRect(); return !grip.bubble.hidden && (b.left < s.left - 1 || b.right > s.right + 1 || b.top < s.top - 1); }).map(grip => grip.words)');
      expect(`${name}: words stay on the stage at ${size}`, cut.length === 0, cut);
      const [bottom, height] = await p.run('[document.querySelector("#asked").getBoundingClientRect().bottom, innerHeight]');
      expect(`${name}: the question is in view at ${size}`, bottom <= height, [bottom, height]);
      expect(`${name}: nothing says hidden at ${size}`, !/hidden/i.test(await p.run('document.body.innerText')));
      expect(`${name}: no instrument before the answer at ${size}`, await p.run('[...document.querySelectorAll(".instrument")].every(part => part.offsetParent === null) && document.querySelector("#look").hidden'));
      expect(`${name}: no scrolling sideways at ${size}`, await p.run('document.documentElement.scrollWidth <= innerWidth'));
      if (shots) await settle(p), await p.shot(path.join(shots, `${size}-${name}-1.png`));
      const words = await p.run('document.querySelector("#text").textContent.split(/\\s+/).filter(word => word).length');
      expect(`${name}: at most 60 words before the question`, words <= 60, words);
      await p.run('core.ask("show"), readAgain(), showThen()');
      await settle(p);
      expect(`${name}: the second half opens at ${size}`, await p.run('page.then'), await p.run('document.querySelector("#wrong").textContent'));
      expect(`${name}: the figure of the second half is drawn at ${size}`, await p.run('!page.held.figure || one("#figure .made").firstElementChild?.getBoundingClientRect().width > 100'));
      if (shots) await new Promise(done => setTimeout(done, 1600)), await p.shot(path.join(shots, `${size}-${name}-1-then.png`));
      expect(`${name}: no error at ${size}`, p.log.length === 0, p.log);
      await p.close();
    }

  // The stage is black in every theme; what stands on it has a contrast of 4.5 (WCAG 2.2, 1.4.3), by relative luminance.
  const reflection = write('reflection');
  for (const [size, options, query] of [kSizes[1], kSizes[2]]) {
    const p = await browser.open(reflection + `?page=1${query}`, options);
    await p.run('core.ask("show"), readAgain(), showThen()');
    await settle(p);
    const contrasts = await p.run(`(() => {
      const luminance = text => { const [r, g, b] = text.match(/[0-9.]+/g).map(x => x / 255).map(x => x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4); return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
      const contrast = (a, b) => (Math.max(luminance(a), luminance(b)) + 0.05) / (Math.min(luminance(a), luminance(b)) + 0.05);
      const probe = document.querySelector('#space').parentElement.appendChild(document.createElement('i'));
      const letters = ['N', 'L', 'V', 'R', 'H', 'text', 'text2', 'text3'].map(name => { probe.style.color = 'var(--' + name + ')'; return [name, contrast(getComputedStyle(probe).color, 'rgb(0, 0, 0)')]; });
      probe.remove();
      const buttons = [...document.querySelectorAll('#spaces button')].filter(button => button.offsetParent).map(button => [button.textContent, contrast(getComputedStyle(button).color, getComputedStyle(button).backgroundColor)]);
      return [...letters, ...buttons];
    })()`);
    expect(`letters and buttons of the stage at ${size}`, contrasts.length === 10 && contrasts.every(([, value]) => value >= 4.5), contrasts);
    await p.close();
  }

  // The lamp: by mouse.
  const p = await browser.open(files.diffuse + '?page=1', { width: 1366, height: 768 });
  const text = await p.run('document.querySelector("#text").textContent'), before = await p.run(picture);
  let [x, y] = await p.run(middle('.grip.lamp'));
  await drag(p, [x, y], [x + 150, y + 60]);
  const [tx, ty] = await p.run(middle('.grip.lamp'));
  expect('the grip stays under the pointer', Math.hypot(tx - x - 150, ty - y - 60) < 3, [tx - x, ty - y]);
  expect('the picture follows', (await p.run(picture)) !== before);
  expect('the text before the question stays', (await p.run('document.querySelector("#text").textContent')) === text);
  expect('the value is said at release', /Lamp: N·L/.test(await p.run('document.querySelector("#status").textContent')), await p.run('document.querySelector("#status").textContent'));
  const kept = await p.run('held.holds[0].values');
  await drag(p, [tx, ty], [tx - 90, ty], { release: false });
  expect('a drag goes on', (await p.run('held.holds[0].values')) !== kept);
  await p.ask('Input.dispatchKeyEvent', { type: 'keyDown', key: 'Escape', windowsVirtualKeyCode: 27 });
  await settle(p);
  expect('Esc takes it back', (await p.run('held.holds[0].values')) === kept, await p.run('held.holds[0].values'));
  await p.ask('Input.dispatchMouseEvent', { type: 'mouseReleased', x: tx, y: ty, button: 'left' });
  expect('and leaves no step', (await p.run('undo.length')) === 1);
  await p.run('putHand(undo.pop())');
  expect('undo goes back to the beginning', (await p.run('held.holds[0].values')) === (await p.run('held.holds[0].own')));
  // Behind the ball the play has its end.
  [x, y] = await p.run(middle('.grip.lamp'));
  const [rx, ry] = await p.run(middle('#room'));
  await drag(p, [x, y], [rx + 400, ry]);
  expect('the play has its end', (await p.run('document.querySelector("#play").textContent')) === 'Darker it does not get.', await p.run('[document.querySelector("#play").textContent, held.shows]'));
  expect('and the lamp is behind', await p.run('document.querySelector(".grip.lamp").classList.contains("behind")'));
  // The question is judged by the page's own frame, wherever the lamp is.
  await p.run('document.querySelector("#typed").value = "7848", document.querySelector("#answer").requestSubmit()');
  expect('a mistake has its name', (await p.run('verdict.mark')) === 'known' || (await p.run('verdict.mark')) === 'not yet');
  if (shots) await p.shot(path.join(shots, '1366-diffuse-1-wrong.png'));
  const hand = await p.run('held.holds[0].values');
  await p.run('document.querySelector("#typed").value = "48", document.querySelector("#answer").requestSubmit()');
  await settle(p);
  expect('48 is right with the lamp behind', await p.run('verdict.mark === "right" && page.then'), await p.run('JSON.stringify(verdict)'));
  expect('what is held stays in the hand', (await p.run('held.holds[0].values')) === hand);
  expect('the keyboard is at Next', (await p.run('document.activeElement.id')) === 'next');
  expect('the equation follows', /48\.0\+0\.0=48\.0/.test((await p.run('document.querySelector(".sum").textContent')).replace(/[^0-9.+=]/g, '').replace(/^[^4]*/, '')) || (await p.run('document.querySelector(".sum").textContent')).includes('48.0'), await p.run('document.querySelector(".sum").textContent'));
  const sums = await p.run('document.querySelector(".sum").textContent');
  await p.run('document.querySelector(".grip.lamp").focus()');
  // 10 times 15°, from behind the ball at the right to where the ringed point at the left is lit.
  for (let i = 0; i < 10; ++i) await p.key('ArrowLeft', 8), await settle(p);
  expect('arrow keys move the lamp, and the equation', (await p.run('document.querySelector(".sum").textContent')) !== sums);
  await p.key('Home'), await settle(p);
  expect('Home puts it back', (await p.run('held.holds[0].values')) === (await p.run('held.holds[0].own')));
  await p.run('document.activeElement.blur()');
  await p.key('i'), await settle(p);
  expect('I looks inside', await p.run('view.inside && document.querySelector("#stages").offsetParent !== null'));
  await p.key('i'), await settle(p);
  expect('and back', await p.run('!view.inside && cells[0].canvases[0].offsetParent !== null'));
  await p.close();

  // By finger: a drag moves the lamp and scrolls nothing.
  const t = await browser.open(files.diffuse + '?page=1', { width: 390, height: 844, mobile: true });
  await t.ask('Emulation.setTouchEmulationEnabled', { enabled: true });
  const [fx, fy] = await t.run(middle('.grip.lamp')), lampBefore = await t.run('held.holds[0].values');
  const touch = (type, points) => t.ask('Input.dispatchTouchEvent', { type, touchPoints: points });
  await touch('touchStart', [{ x: fx, y: fy }]);
  for (let i = 1; i <= 5; ++i) await touch('touchMove', [{ x: fx + 8 * i, y: fy - 12 * i }]), await settle(t);
  await touch('touchEnd', []);
  await settle(t);
  expect('a finger moves the lamp', (await t.run('held.holds[0].values')) !== lampBefore);
  expect('and scrolls nothing', (await t.run('scrollY')) === 0);
  await t.close();

  // By keys alone, from the first grip to the end of the page; without motion.
  const k = await browser.open(files.diffuse + '?page=1', { width: 1366, height: 768 });
  await k.ask('Emulation.setEmulatedMedia', { features: [{ name: 'prefers-reduced-motion', value: 'reduce' }] });
  await k.run('document.querySelector("#heading").focus()');
  let reached = '';
  await k.run('document.querySelector("#room").focus(), document.activeElement.blur()');
  for (let i = 0; i < 30 && !/grip/.test(reached); ++i) await k.key('Tab'), reached = await k.run('document.activeElement.className');
  expect('Tab reaches the lamp', /lamp/.test(reached), reached);
  await k.key('ArrowUp', 8), await settle(k);
  for (const digit of '48') await k.key(digit);
  expect('a digit goes to the field', (await k.run('document.querySelector("#typed").value')) === '48', await k.run('document.activeElement.id'));
  await k.key('Enter'), await settle(k);
  expect('Enter checks', await k.run('page.then'));
  await k.key('Enter'), await settle(k);
  expect('and goes on', await k.run('!page.then && view.page === 1'));
  await k.close();

  // The near plane: on the axis of the codes.
  const d = await browser.open(files['depth-precision'] + '?page=1', { width: 1366, height: 768 });
  const own = await d.run('settingOf("camera.near").text');
  [x, y] = await d.run(middle('.grip.number'));
  await drag(d, [x, y], [x + 420, y]);
  expect('the near plane moves along its axis', Number(await d.run('settingOf("camera.near").text')) > 5, await d.run('settingOf("camera.near").text'));
  const far = await d.run('settingOf("camera.near").text');
  [x, y] = await d.run(middle('.grip.number'));
  const mouse = (type, to) => d.ask('Input.dispatchMouseEvent', { type, x: to, y, button: 'left', buttons: 1, clickCount: 1 });
  await mouse('mousePressed', x);
  await Promise.all([mouse('mouseMoved', x + 1), mouse('mouseMoved', x - 300), mouse('mouseReleased', x - 300)]);
  await settle(d);
  expect('who lets go before the next picture loses no move', Number(await d.run('settingOf("camera.near").text')) < Number(far) / 2, await d.run('settingOf("camera.near").text'));
  [x, y] = await d.run(middle('.grip.number'));
  await drag(d, [x, y], [x + 300, y]);
  await d.until('document.querySelector("#play").textContent.includes("Half of all codes")').catch(() => {});
  expect('its play ends', (await d.run('document.querySelector("#play").textContent')).includes('Half of all codes'), await d.run('document.querySelector("#play").textContent'));
  if (shots) await d.shot(path.join(shots, '1366-depth-precision-1-moved.png'));
  await d.run('core.ask("show"), readAgain(), showThen()');
  expect('the second half sets its own near plane', (await d.run('settingOf("camera.near").text')) === own);
  const lost = await d.run('Number(held.shows.replace(/[^0-9]/g, ""))');
  expect('blue loses pixels', lost > 1000, await d.run('held.shows'));
  [x, y] = await d.run(middle('.grip.number'));
  await drag(d, [x, y], [x + 200, y]);
  expect('and fewer with a farther near plane', (await d.run('Number(held.shows.replace(/[^0-9]/g, ""))')) < lost, await d.run('held.shows'));
  await d.close();

  // The ball: by its own surface; the line between two pictures.
  const s = await browser.open(files.smooth + '?page=1', { width: 1366, height: 768 });
  const [bx, by] = await s.run(middle('#room'));
  await drag(s, [bx, by], [bx + 160, by]);
  expect('the ball turns with the pointer', Number(await s.run('settingOf("object.0.rz").text')) > 10, await s.run('settingOf("object.0.rz").text'));
  await s.run('core.ask("show"), readAgain(), showThen()');
  await settle(s);
  const line = await s.run('cells[0].wipe');
  [x, y] = await s.run(middle('.grip.line'));
  await drag(s, [x, y], [x - 120, y]);
  expect('the line moves', (await s.run('cells[0].wipe')) < line - 0.05, await s.run('cells[0].wipe'));
  expect('the two pictures differ', await s.run('!cells[0].canvases[1].hidden'));
  expect('and it is said what they are', /phong/.test(await s.run('cells[0].over.textContent')) && /gouraud/.test(await s.run('cells[0].over.textContent')), await s.run('cells[0].over.textContent'));
  // To the end: pictures, mistakes, next lesson.
  await s.run('(() => { for (let i = 0; i < data.pages; ++i) { openPage(i); if (page.question && !page.question.settled) core.ask("show"), readAgain(), page.has_then && openPage(i, true); } showEnd(); })()');
  expect('the end has a picture of each page', (await s.run('document.querySelectorAll("#end figure canvas").length')) >= 5, await s.run('document.querySelectorAll("#end figure canvas").length'));
  expect('and what one can do now', (await s.run('document.querySelector("#end").innerText')).includes('You can now'));
  if (shots) await settle(s), await s.shot(path.join(shots, '1366-end.png'));
  expect('nothing was written to the console', s.log.length === 0, s.log);
  await s.close();

  // A vertex, beside the files that follow it.
  const v = await browser.open(files.pyramid + '?page=1', { width: 1366, height: 768 });
  const lit = 'document.querySelector("#files .lit td:nth-child(2)").textContent';
  expect('the line of the apex is lit', (await v.run(lit)) === '(75,75,150)', await v.run(lit));
  const others = '[...document.querySelectorAll("#files tr:not(.lit)")].map(row => row.textContent).join()', file = await v.run(others);
  [x, y] = await v.run(middle('.grip.vertex'));
  await drag(v, [x, y], [x - 60, y + 30]);
  const [vx, vy] = await v.run(middle('.grip.vertex'));
  expect('the apex stays under the pointer', Math.hypot(vx - x + 60, vy - y - 30) < 4, [vx - x, vy - y]);
  const apex = await v.run('held.holds[0].values.replace(/vertex.0.4.[xyz]=/g, "").replaceAll("; ", ",")');
  expect('its line follows in whole units', (await v.run(lit)) === `(${apex})` && !apex.includes('.'), [await v.run(lit), apex]);
  expect('and no other', (await v.run(others)) === file);
  expect('where it was is drawn', (await v.run('document.querySelectorAll(".before").length')) === 1);
  expect('its play ends', (await v.run('document.querySelector("#play").textContent')) === 'One line follows: vertex 4.');
  if (shots) await v.shot(path.join(shots, '1366-pyramid-1-moved.png'));
  await v.run('document.querySelector(".grip.vertex").focus()');
  await v.key('ArrowUp'), await settle(v);
  expect('arrow keys move it', (await v.run(lit)) !== `(${apex})`);
  await v.run('core.ask("show"), readAgain(), showThen()'), await settle(v);
  expect('four lines name it', (await v.run('[...document.querySelectorAll("#files u")].map(mark => mark.textContent).join()')) === '4,4,4,4');
  expect('it stays in the hand', (await v.run(lit)) !== '(75,75,150)');
  expect('nothing was written to the console', v.log.length === 0, v.log);
  await v.close();

  // The rim of a highlight, by mouse; outwards n falls.
  const h = await browser.open(files.highlight + '?page=2', { width: 1366, height: 768 });
  [x, y] = await h.run(middle('.grip.rim'));
  await drag(h, [x, y], [x + 30, y]);
  expect('a wider highlight has a smaller n', Number(await h.run('settingOf("material.2.n").text')) < 8, await h.run('settingOf("material.2.n").text'));
  [x, y] = await h.run(middle('.grip.rim'));
  for (let i = 0; i < 40 && Number(await h.run('settingOf("material.2.n").text')) !== 31; ++i) await h.key('ArrowLeft'), await settle(h);
  await h.run('document.querySelector("#answer").requestSubmit()'), await settle(h);
  expect('n = 31 has its half at 12 degrees', await h.run('page.then'), await h.run('[settingOf("material.2.n").text, JSON.stringify(verdict)]'));
  await h.close();

  // A spot stays in its row, whatever the pointer does.
  const r = await browser.open(files['z-buffer'] + '?page=8', { width: 1366, height: 768 });
  [x, y] = await r.run(middle('.grip.pixel'));
  await drag(r, [x, y], [x + 200, y + 90]);
  expect('a spot stays in its row', (await r.run('view.pixel[1]')) === 240 && (await r.run('view.pixel[0]')) > 100, await r.run('view.pixel'));
  await r.run('core.ask("show"), readAgain(), showThen()'), await settle(r);
  expect('the row is drawn below', await r.run('document.querySelector("#figure .curve").getAttribute("points").length > 1000'));
  const words = await r.run('document.querySelector("#figure svg").ariaLabel');
  await r.run('document.querySelector(".grip.pixel").focus()');
  await r.key('ArrowRight', 8), await settle(r);
  expect('and follows the spot', (await r.run('document.querySelector("#figure svg").ariaLabel')) !== words, words);
  if (shots) await r.shot(path.join(shots, '1366-z-buffer-8-then.png'));
  await r.close();

  // Every page of every lesson, on the stage: no error, no word of what is hidden, the comparison of its second half, and
  // something to look at: a picture of one colour says so, or has edges over it, or a 3D view beside it.
  for (const name of names) {
    const l = await browser.open(write(name), { width: 1366, height: 768 });
    const found = await l.run(`(() => {
      const wrong = [], box = document.querySelector('#wrong'), saysSo = /black|empty|0 pixels differ|exact rays/i;
      const isPlain = canvas => { const d = new Uint32Array(canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.buffer); return canvas.hidden || d.every(pixel => pixel === d[0]); };
      const look = i => cells.forEach(cell => { if (!cell.field.classList.contains('listed') && isPlain(cell.canvases[0]) && !cell.over.querySelector('.edges') && !saysSo.test(cell.caption.textContent + one('#text').textContent)) wrong.push(i + ' has an empty picture of ' + cell.shown.buffer); });
      for (let i = 0; i < data.pages; ++i) {
        guarded(() => openPage(i));
        if (/hidden until/i.test(document.body.innerText)) wrong.push(i + ' says hidden');
        look(i);
        const hidden = page.hidden.buffers, menus = [...document.querySelectorAll('select, option, title, [title], [aria-label]')].filter(part => part.offsetParent !== null).map(part => (/^(SELECT|OPTION|title)$/.test(part.tagName) ? part.textContent : '') + part.title + part.ariaLabel).join(' ');
        for (const name of hidden) if (menus.includes(name)) wrong.push(i + ' names ' + name);
        if (page.question && !page.question.settled) guarded(() => { core.ask('show'); readAgain(); });
        if (page.has_then) guarded(() => openPage(i, true)), look(i + ' then');
        for (const shown of page.buffers) if (shown.against && !(shown.mode === 'a') && core.ask('picture', shown.buffer, 1, -1, 0, 0, 0, 0, 0, 0, 0).pixels === 0) wrong.push(i + ' has no second picture');
        if (!box.hidden) { wrong.push(i + ': ' + box.textContent); box.hidden = true; }
      }
      return wrong;
    })()`);
    expect(`every page of ${name} stands on the stage`, found.length === 0 && l.log.length === 0, [found, l.log]);
    const work = await workOfSteps(l);
    expect(`a step of the hand lays ${name} out once, and asks the core nothing twice`, work.layouts <= 1 && work.twice.length === 0, work);
    const moved = await l.run(verdictsMoved);
    expect(`no hand moves a verdict of ${name}`, moved.length === 0, moved);
    for (const [size, { width, height, mobile = false }] of kSizes.slice(0, 3)) {
      await l.ask('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: 1, mobile });
      await l.run(`document.documentElement.classList.toggle('projector', ${size === 'projector'})`);
      const laid = await l.run(layoutOfHeld);
      expect(`every first half of ${name} that holds something has its room at ${size}`, laid.length === 0, laid);
    }
    await l.close();
  }
} finally {
  await browser.close();
}
