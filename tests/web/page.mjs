// What a live page promises, asked of one in Chromium with the network off. Arguments: the program, and the core.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { launch } from './browser.mjs';
import { expect, folder } from './claims.mjs';

const [program] = process.argv.slice(2);
const write = (name, ...args) => {
  const file = path.join(folder, name);
  execFileSync(program, [...args, '--live', '-o', file], { stdio: ['ignore', 'ignore', 'inherit'] });
  return file;
};

const browser = await launch();
try {
  // The budget of a lesson is a count: 1.9 MB.
  const pyramid = write('pyramid.html', 'lesson', 'export', 'pyramid');
  expect('a lesson is at most 1.9 MB', fs.statSync(pyramid).size <= 1.9e6, fs.statSync(pyramid).size);

  // A scene: lecture 1's pyramid, whose numbers are derived in tests/reference/lecture1_pyramid_test.cpp.
  const scene = write('scene.html', 'export', 'pyramid');
  const p = await browser.open('file://' + scene);
  const text = selector => p.run(`document.querySelector(${JSON.stringify(selector)}).textContent`);
  expect('it starts', await p.run('document.querySelector("#wrong").hidden'), await text('#wrong'));
  await p.run('pick([268, 281])');
  expect('the equation has the numbers of the lecture', (await text('.equation')).includes('114.739'), await text('.equation'));
  expect('the equation is MathML', await p.run('document.querySelector(".equation math").namespaceURI.endsWith("MathML")'));
  expect('the shadow buffer is left out, with its reason', /left out.*convex/.test(await text('#stages li:nth-child(4)')), await text('#stages li:nth-child(4)'));
  expect('the fragments of the pixel are told', (await text('.fragments')).includes('passed, stays'), await text('.fragments'));

  const box = await p.run('(b => [b.x, b.y, b.width, b.height])(document.querySelector(".over").getBoundingClientRect())');
  await p.click(box[0] + box[2] * 0.3, box[1] + box[3] * 0.55);
  const picked = await p.run('view.pixel');
  expect('a click picks a pixel', picked.join() !== '268,281', picked);
  await p.key('ArrowRight');
  expect('an arrow key moves it by one', (await p.run('view.pixel[0]')) === picked[0] + 1);
  await p.key('ArrowDown', 8);
  expect('with Shift by ten', (await p.run('view.pixel[1]')) === picked[1] + 10);
  expect('and a screen reader is told', (await text('#status')).includes('Pixel'), await text('#status'));

  await p.run('document.activeElement.blur()');
  await p.key('5');
  expect('5 goes to the end of the z-buffer', (await p.run('view.step.stage')) === 'z-buffer');
  expect('the colour is not there yet, and why', await p.run('!document.querySelector(".absent").hidden'), await text('.absent'));
  const bits = 'core.numbers(core.ask("buffer", "polygon_id", 0)).join()';
  const before = await p.run(bits), place = await p.run('view.step.place');
  await p.key(',');
  expect(', steps back', (await p.run('view.step.done < view.step.of')) && (await p.run(bits)) !== before);
  await p.key('.');
  expect('. steps forth to the same place and bits', (await p.run('view.step.place')) === place && (await p.run(bits)) === before);
  for (const level of [0, 1, 2, 3, 4]) {
    await p.run(`view.level = ${level}`);
    const start = await p.run('view.step.place');
    await p.key(','), await p.key('.');
    expect(`back is exact at level ${level}`, (await p.run('view.step ? view.step.place : "shading"')) === start);
  }
  await p.key('6');

  await p.run('pick([268, 281])');
  await p.run('setSetting("material.0.n", "4")');
  expect('a setting moves the equation', (await text('.equation')).includes('115.712'), await text('.equation'));
  expect('and the line before stays', (await text('.was')).includes('114.739'));
  await p.run('document.querySelector("#putback").click()');
  expect('Put back takes it away', (await p.run('settingOf("material.0.n").text')) === '8');
  expect('a value out of range is refused with a reason', await p.run('setSetting("material.0.n", "-5"), document.querySelector("#refused").textContent !== ""'));
  const pixels = which => `(c => c.getContext('2d').getImageData(0, 0, c.width, c.height).data.join())(document.querySelectorAll('.frame canvas[role=img]')[${which}])`;
  await p.run('(c => { c.value = "shading=phong"; c.dispatchEvent(new Event("change")); })(document.querySelector("#compare"))');
  expect('B is another picture of the same buffer', (await p.run(pixels(0))) !== (await p.run(pixels(1))));
  expect('and A stays', (await text('.side')) === 'A');

  await p.run('(c => { c.value = ""; c.dispatchEvent(new Event("change")); })(document.querySelector("#compare"))');

  // The algorithm's lines are the program's, at the same step.
  const moment = 'z-buffer/polygon=2/row=270/x=258';
  await p.run(`one('#algorithmbox').open = true, view.level = 4, step(0, ${JSON.stringify(moment)})`);
  await p.until('document.querySelector(".code .now") !== null');
  const told = JSON.parse(execFileSync(program, ['inspect', 'pyramid', '--step', moment, '--json'], { encoding: 'utf8' }));
  const own = (told.algorithm?.lines ? told.algorithm : told).lines.map(line => line.text);
  expect('the algorithm has the lines of the program', (await p.run('[...document.querySelectorAll(".code .text")].map(line => line.textContent.trim()).join("\\n")')) === own.map(line => line.trim()).join('\n'), await text('.code'));
  expect('and its values', (await text('.code')).includes('polygon = 2'), await text('.code'));
  await p.run('step(0, "z-buffer/start")');
  expect('before its first step a stage is named once', (await text('#stepped')).split('Z-buffer').length === 2, await text('#stepped'));
  await p.run('one("#algorithmbox").open = false, step(0, "shading")');

  // Derived buffers are made of the frame.
  await p.run('show(1, "z_ndc")');
  expect('a derived buffer is shown', await p.run('document.querySelectorAll(".picture")[1].querySelector(".absent").hidden'), await text('.picture:last-child .absent'));
  await p.run('show(1, "condition"), one("#condition").value = "n_dot_l.0 < 0.75", one("#condition").dispatchEvent(new Event("change"))');
  const [met, all] = await p.run(`(() => { const holds = core.numbers(core.ask('buffer', 'condition', 0)), lit = core.numbers(core.ask('buffer', 'n_dot_l.0', 0)), ids = core.numbers(core.ask('buffer', 'polygon_id', 0)); let met = 0, all = 0; for (let i = 0; i < ids.length; ++i) if (ids[i] >= 0) ++all, met += (holds[i] === 1) === (lit[i] < 0.75) ? 1 : 0; return [met, all]; })()`);
  expect('a condition is true where it holds', all > 2000 && met === all, [met, all]);
  await p.run('one("#condition").value = "n_dot_l.0 <", one("#condition").dispatchEvent(new Event("change"))');
  expect('what is no condition is told', await p.run('!document.querySelectorAll(".picture")[1].querySelector(".absent").hidden'));
  await p.run('one("#condition").value = "", one("#condition").dispatchEvent(new Event("change")), show(1, "shadow_verdict.0")');
  expect('and what the program alone makes', /Shadescope|shadow/.test(await text('.picture:last-child .absent')), await text('.picture:last-child .absent'));
  await p.run('show(1, "polygon_id")');

  // A planted defect is a setting as any other.
  const correct = await p.run(pixels(0));
  await p.run('setSetting("defect", "y-down")');
  expect('a planted defect changes the picture', (await p.run(pixels(0))) !== correct);
  await p.run('document.querySelector("#putback").click()');
  expect('and goes again', (await p.run(pixels(0))) === correct);

  expect('eval is refused', await p.run('(() => { try { (0, eval)("1"); return false; } catch { return true; } })()'));
  expect('fetch is refused', await p.run('fetch("https://example.org/").then(() => false, () => true)'));
  expect('an inline handler is refused', await p.run(`new Promise(done => { const box = document.createElement('div'); box.innerHTML = '<img src=x onerror="window.bad = 1">'; document.body.append(box); setTimeout(() => { box.remove(); done(!window.bad); }, 50); })`));
  const { nodes } = await p.ask('Accessibility.getFullAXTree');
  const nameless = nodes.filter(node => !node.ignored && ['button', 'slider', 'combobox', 'textbox', 'checkbox', 'radio', 'image'].includes(node.role?.value) && !node.name?.value);
  expect('every control has a name', nameless.length === 0, nameless.map(node => node.role.value));
  expect('nothing was asked of the network', p.requests.every(url => url.startsWith('file:') || url.startsWith('data:') || url.startsWith('blob:') || url === 'https://example.org/'), p.requests);
  expect('no error was written', p.log.filter(line => !line.includes('Content Security Policy')).length === 0, p.log);
  await p.close();

  // Frames that take long run in a worker, whose core becomes the page's; the settings that move meanwhile are not lost.
  const soft = await browser.open('file://' + write('soft.html', 'export', 'soft_shadow', '--size', '160x120'));
  const [isShown, waited, answered, same, moved] = await soft.run(`(async () => {
    const bits = () => core.numbers(core.ask('buffer', 'color', 0)).join(), before = bits();
    const seen = () => (c => c.getContext('2d').getImageData(0, 0, c.width, c.height).data.join())(one('.frame canvas[role=img]'));
    isLong = true;
    const first = setSetting('light.0.intensity', '0.6'), waited = running !== null;
    setSetting('light.0.intensity', '0.3');
    const answered = bits() === before && report !== null;
    await first;
    while (running) await new Promise(done => setTimeout(done, 5));
    const after = bits(), shown = seen();
    draw();
    const isShown = seen() === shown;
    core.calls.frame(1);
    return [isShown, waited, answered, after === bits(), after !== before && settingOf('light.0.intensity').text === '0.3' && core.ask('values').some(([, text]) => text === '0.3')];
  })()`);
  expect('a long frame runs in a worker', waited);
  expect('the page answers meanwhile from the frame before', answered);
  expect('the frame of the worker has the bits of the page', same);
  expect('the newest setting wins', moved);
  expect('and its frame is the one that is shown', isShown);
  await soft.run(`isLong = true, setSetting('light.0.intensity', '0.5'), openPage(0)`);
  await soft.until('running === null');
  expect('a page that is opened meanwhile stays', await soft.run('core.ask("values").every(([, text], i) => text === settings[i].text) && view.own["light.0.intensity"] === undefined'));
  expect('no error came of the worker', soft.log.length === 0, soft.log);
  await soft.close();

  // Why a pixel of the night side is dark is a sentence, not a formula: with its spaces, and once.
  const night = await browser.open('file://' + write('night.html', 'export', 'ambient'));
  await night.run('pick([211, 268])');
  const why = await night.run('document.querySelector("#why").textContent');
  expect('a sentence below the equation keeps its spaces', why.includes('is not above 0, so light 0 adds nothing here.'), why);
  expect('and is there once', why.split('adds').length === 2, why);
  await night.close();

  // A lesson: its questions are judged as in the window.
  const q = await browser.open('file://' + pyramid + '?page=2');
  expect('?page=2 opens the second page', (await q.run('page.number')) === 1);
  expect('numbers stand in the text', await q.run('!/[{}]/.test(document.querySelector("#text").textContent)'));
  let asked = 0, right = 0;
  const count = await q.run('data.pages');
  for (let i = 0; i < count; ++i) {
    await q.run(`openPage(${i})`);
    if (!(await q.run('page.question'))) continue;
    ++asked;
    const hidden = await q.run('page.hidden.count');
    await q.run('core.ask("show"), readAgain()');
    expect(`page ${i + 1} shows its answer`, (await q.run('document.querySelector("#solved").textContent')) !== '');
    expect(`page ${i + 1} hides nothing afterwards`, (await q.run('page.hidden.count')) === 0, hidden);
    if (await q.run('page.has_then')) {
      await q.run('document.querySelector("#goon").click()');
      expect(`page ${i + 1} goes on to its second half`, await q.run('page.then'));
    }
    right += (await q.run('document.querySelector("#wrong").hidden')) ? 1 : 0;
  }
  expect('every page of the lesson opens', asked > 0 && right === asked, [asked, right]);
  expect('no error was written by the lesson', q.log.length === 0, q.log);
  await q.close();

  // What has no pixels is listed, and takes no more room than it has.
  const v = await browser.open('file://' + scene);
  // A frame that takes long is computed aside, so the table may come later.
  await v.run('show(0, "vertices.screen")');
  await v.until('document.querySelector(".rows tr") !== null').catch(() => {});
  expect('vertices are a table', (await v.run('document.querySelectorAll(".picture:first-child .rows tr").length')) === 5);
  expect('whose numbers are the buffer\'s', await v.run(`(numbers => document.querySelector('.rows tr:nth-child(2) td').textContent === shortNumber(numbers[3]))(core.numbers(core.ask('buffer', 'vertices.screen', 0)))`));
  expect('the page keeps its size', await v.run('document.documentElement.scrollHeight <= innerHeight'), await v.run('document.documentElement.scrollHeight'));
  await v.run('show(0, "color")');
  await v.until('document.querySelector(".rows tr") === null').catch(() => {});
  expect('and a picture comes back', await v.run('document.querySelector(".rows tr") === null && document.querySelector(".frame canvas").offsetHeight > 100'));
  await v.close();

  // Every lesson starts, within the budget, and each of its pages opens.
  for (const { name } of JSON.parse(execFileSync(program, ['lesson', 'list', '--json'], { encoding: 'utf8' }))) {
    const file = write('lesson.html', 'lesson', 'export', name);
    expect(`${name} is at most 1.9 MB`, fs.statSync(file).size <= 1.9e6, fs.statSync(file).size);
    const l = await browser.open('file://' + file);
    const wrong = await l.run(`(() => { const box = document.querySelector('#wrong'); for (let i = 0; box.hidden && i < data.pages; ++i) guarded(() => openPage(i)); return box.hidden ? '' : box.textContent; })()`);
    expect(`every page of ${name} opens`, wrong === '', wrong);
    await l.close();
  }

  // The pyramid's first number question: its answer, a hint, and something that is none.
  const r = await browser.open('file://' + pyramid);
  const number = await r.run('(() => { for (let i = 0; i < data.pages; ++i) { openPage(i); if (page.question?.kind === "number") return i; } return -1; })()');
  const answer = async typed => {
    await r.run(`document.querySelector('#typed').value = ${JSON.stringify(typed)}, document.querySelector('#answer').requestSubmit()`);
    return r.run('verdict.mark');
  };
  expect('a word is no answer and costs nothing', (await answer('<img src=x onerror=alert(1)>')) === 'again');
  expect('and is shown as it was typed', await r.run('document.querySelector("#said img") === null'));
  expect('a wrong number is wrong', ['not yet', 'known'].includes(await answer('123456')));
  const hints = await r.run('page.question.hint_count');
  await r.run('document.querySelector("#hint").click()');
  expect('a hint is shown', hints > 0 && (await r.run('document.querySelectorAll(".hint").length')) === 1);
  const solution = await r.run(`(() => { core.ask('show'); readAgain(); const text = document.querySelector('#solved').textContent; openPage(${number}); return text; })()`);
  expect('the answer has a number', /\d/.test(solution), solution);

  // The file that Save answers writes is graded: the class has the tries that were made here.
  expect('answers can be saved after the first', await r.run('!document.querySelector("#saveanswers").hidden'));
  const saved = await r.run(`(() => { const made = []; const own = saveFile; saveFile = (...all) => made.push(all); document.querySelector('#saveanswers').click(); saveFile = own; return made[0]; })()`);
  expect('the file is named after the lesson', saved[2] === 'pyramid-answers.json', saved[2]);
  fs.writeFileSync(path.join(folder, 'anna.json'), saved[0]);
  execFileSync(program, ['grade', path.join(folder, 'anna.json'), '-o', path.join(folder, 'class')], { stdio: 'ignore' });
  const { answers: [graded] } = JSON.parse(fs.readFileSync(path.join(folder, 'class', 'class.json'), 'utf8'));
  expect('grade reads it', graded.student === 'anna' && graded.lesson === 'pyramid' && graded.outcome === 'shown' && graded.tries[0].given === '123456' && graded.hints === 1, graded);

  // A reload finds the answers, and forgets them when it is told to. Whatever else is stored there costs nothing.
  const again = await browser.open('file://' + pyramid, { kept: true });
  // Another process of the browser has written them: they may be on their way.
  await again.until('localStorage.getItem(keptAs()) !== null').catch(() => {});
  await again.run('window.old = 1, location.reload()');
  await again.until('!window.old && document.documentElement.dataset.ready === "1"');
  expect('answers survive a reload', await again.run(`openPage(${number}), page.question.state === 'shown' && page.question.hints.length === 1 && ${number} in data.made.points`), await again.run('page.question'));
  expect('and it is told', /keeps your answers/.test(await again.run('document.querySelector("#kept").textContent')));
  const whole = 'core.ask("answers", data.name)';
  expect('the hand-in is the same', (await again.run(whole)) === saved[0]);
  await again.run('window.old = 1, document.querySelector("#forget").click()');
  await again.until('!window.old && document.documentElement.dataset.ready === "1"');
  expect('answers are forgotten', await again.run(`openPage(${number}), page.question.state === 'open' && !page.answered`));
  for (const text of ['', '{', '[]', '7', '{"lessons": 1}', '{"lessons": {"pyramid": {"Where one vertex goes": {"outcome": "right", "hints": -1, "tries": [3, {"right": 1, "hints": "x"}]}}}}']) {
    await again.run(`localStorage.setItem(keptAs(), ${JSON.stringify(text)})`);
    const odd = await browser.open('file://' + pyramid, { kept: true });
    await odd.until(`localStorage.getItem(keptAs()) === ${JSON.stringify(text)}`);
    await odd.run('window.old = 1, location.reload()');
    await odd.until('!window.old && document.documentElement.dataset.ready === "1"');
    expect(`it starts with ${text} in its storage`, await odd.run('document.querySelector("#wrong").hidden'), await odd.run('document.querySelector("#wrong").textContent'));
    await odd.close();
  }
  await again.close();

  // On a phone the arrows of an order are in their own rows.
  const painter = write('painter.html', 'lesson', 'export', 'painter');
  const order = await browser.open('file://' + painter, { width: 390, height: 844, mobile: true });
  await order.run('(() => { for (let i = 0; i < data.pages && page.question?.kind !== "order"; ++i) openPage(i); })()');
  const outside = await order.run(`[...document.querySelectorAll('.ordered')].flatMap(row => [...row.querySelectorAll('.icon')].filter(arrow => { const a = arrow.getBoundingClientRect(), r = row.getBoundingClientRect(); return a.top < r.top || a.bottom > r.bottom; }).map(arrow => row.textContent))`);
  expect('arrows of an order stay in their rows at 390', (await order.run('document.querySelectorAll(".ordered").length')) > 1 && outside.length === 0, outside);
  await order.close();

  // A wrong prediction costs nothing.
  const translucency = await browser.open('file://' + write('translucency.html', 'lesson', 'export', 'translucency'));
  const worth = () => translucency.run('document.querySelector("#worth").textContent');
  await translucency.run('(() => { for (let i = 0; i < data.pages && !page.question?.free; ++i) openPage(i); })()');
  expect('a prediction says that it is free', /a wrong prediction is free/.test(await worth()), await worth());
  await translucency.run('document.querySelector("#answer input").click(), document.querySelector("#answer").requestSubmit()');
  expect('a wrong prediction costs nothing', (await translucency.run('verdict.mark')) === 'known' && /^worth 1, 3 tries left$/.test(await worth()), await worth());
  await translucency.close();

  // No question of another lesson returns: the page does not know whether its reader has done that.
  const c = await browser.open('file://' + write('camera.html', 'lesson', 'export', 'camera'));
  expect('the first page is page 1', /^page 1 of 10$/.test(await c.run('document.querySelector("#count").textContent')));
  await c.close();
  const d = await browser.open('file://' + path.join(folder, 'camera.html') + '?page=3');
  expect('?page=3 opens page 3', (await d.run('page.name')) === '3', await d.run('page.name'));
  await d.close();
  await r.close();

  // With the keyboard alone: what hides or switches itself off hands the focus on, and a new page is read from its heading.
  const k = await browser.open('file://' + pyramid);
  const press = async id => {
    await k.run(`document.querySelector(${JSON.stringify(id)}).focus()`);
    await k.key('Enter');
    return k.run('document.activeElement.id || document.activeElement.className');
  };
  await k.run(`openPage(${number})`);
  await k.run('document.querySelector("#typed").value = "123456"');
  expect('a wrong answer leaves the focus in its field', (await press('#typed')) === 'typed');
  const voices = await k.run('[...document.querySelectorAll("[role=status], [role=alert], [aria-live]")].filter(part => part.textContent.includes("Not yet")).length');
  expect('a verdict is spoken once', voices === 1, voices);
  const verdictText = await k.run('document.querySelector("#said").textContent');
  expect('and says its word once', verdictText.split(/not yet/i).length === 2, verdictText);
  for (let i = 1; i < hints; ++i) await press('#hint');
  expect('the last hint hands the focus on', (await press('#hint')) === 'giveup');
  expect('so does the answer', ['goon', 'next', 'question'].includes(await press('#giveup')), await k.run('document.activeElement.outerHTML.slice(0, 80)'));
  await k.run('lookInside(true)');
  await press('#first');
  await k.until('!document.querySelector("#last").disabled').catch(() => {});
  await press('#last');
  await k.until('document.activeElement.id === "back"').catch(() => {});  // a long frame is computed aside
  expect('and the end of the frame', (await k.run('document.activeElement.id')) === 'back');
  await k.run('lookInside(false), openPage(data.pages - 2), core.ask("show"), readAgain(), page.has_then && openPage(view.page, true)');
  expect('the last page is read from its heading', (await press('#next')) === 'heading');
  await k.close();

  // Text twice as large: by the reader's setting, and alone.
  const set = await browser.open('file://' + pyramid + '?page=2');
  const size = async () => parseFloat(await set.run('getComputedStyle(document.documentElement).fontSize'));
  const usual = await size();
  await set.ask('Page.setFontSizes', { fontSizes: { standard: 32, fixed: 26 } });
  await set.until(`parseFloat(getComputedStyle(document.documentElement).fontSize) >= ${2 * usual}`);
  expect('a page follows the size of text that its reader has set', await set.run('document.documentElement.scrollWidth <= innerWidth'), [usual, await size()]);
  await set.close();
  const big = await browser.open('file://' + scene);
  await big.run('document.documentElement.style.fontSize = "26px", dispatchEvent(new Event("resize"))');
  expect('larger text leaves the pictures their room', (await big.run('document.querySelector(".pictures").clientWidth')) > 1280 / 4, await big.run('document.querySelector(".pictures").clientWidth'));
  expect('and covers no step', await big.run('[...document.querySelectorAll("#steps button")].every(button => { const { x, y, width, height } = button.getBoundingClientRect(); return button.contains(document.elementFromPoint(x + width / 2, y + height / 2)); })'));
  await big.close();
  for (const width of [768, 1024, 1280]) {
    const s = await browser.open('file://' + scene, { width, height: 1024 });
    const cut = await s.run('[...document.querySelectorAll("#stages .label")].filter(label => label.scrollWidth > label.clientWidth + 1 || label.scrollHeight > label.clientHeight + 4).map(label => label.textContent)');
    expect(`every stage has its whole name at ${width}`, cut.length === 0, cut);
    await s.close();
  }

  // Text of a scene is text.
  const evil = path.join(folder, 'evil.toml');
  execFileSync(program, ['export', 'lambert', '-o', path.join(folder, 'scene'), '--format', 'scene'], { stdio: 'ignore' });
  const toml = fs.readdirSync(path.join(folder, 'scene')).find(name => name.endsWith('.toml'));
  fs.writeFileSync(evil, fs.readFileSync(path.join(folder, 'scene', toml), 'utf8').replace(/^title = .*$/m, '').replace(/^/, 'title = "<img src=x onerror=\'window.bad=1\'></script>"\n'));
  const e = await browser.open('file://' + write('evil.html', 'export', evil));
  expect('a title is no markup', await e.run('!window.bad && document.querySelector("img") === null && document.querySelector("#title").textContent.includes("<img")'), await e.run('document.querySelector("#title").textContent + document.querySelector("#wrong").textContent'));
  await e.close();

  // Narrow and wide, light and dark, projector, no scripts.
  for (const [width, height, mobile] of [[320, 640, true], [390, 844, true], [640, 400, false], [1280, 800, false]])
    for (const query of ['', '?projector=1']) {
      const n = await browser.open('file://' + pyramid + query, { width, height, mobile, dark: width === 390 });
      expect(`no scrolling sideways at ${width} ${query}`, await n.run('document.documentElement.scrollWidth <= innerWidth'), await n.run('document.documentElement.scrollWidth'));
      if (mobile && query === '') {
        const small = await n.run(`[...document.querySelectorAll('button, select')].filter(b => b.offsetParent && b.getBoundingClientRect().height < 40).map(b => b.id || b.textContent)`);
        expect(`targets are large at ${width}`, small.length === 0, small);
      }
      await n.close();
    }
  // On a phone the picture stands beside a question that is answered by a click into it, however far the page is scrolled.
  const diffuse = write('diffuse.html', 'lesson', 'export', 'diffuse');
  for (const [width, height] of [[320, 640], [390, 844]]) {
    const n = await browser.open('file://' + diffuse, { width, height, mobile: true });
    for (let page = 0; page < 9 && !(await n.run('isClick()')); ++page)
      await n.run(`openPage(${page})`);
    await n.run('document.querySelector("#asked").scrollIntoView({ block: "end" })');
    const [top, bottom, asked] = await n.run('(() => { const of = s => document.querySelector(s).getBoundingClientRect(); return [of(".stage").top, of(".stage").bottom, of("#asked").bottom]; })()');
    expect(`the picture to click into is in sight at ${width}`, top >= -1 && bottom < height && asked <= height, [top, bottom, asked]);
    expect(`and leaves room for the question at ${width}`, height - bottom > height * 0.3, [bottom, height]);
    await n.close();
  }
  const without = await browser.open('file://' + pyramid, { scripts: false });
  let nodeId = 0;
  for (let tries = 0; tries < 500 && nodeId === 0; ++tries) {  // until the file is read
    const { root } = await without.ask('DOM.getDocument');
    ({ nodeId } = await without.ask('DOM.querySelector', { nodeId: root.nodeId, selector: '.paper h2' }).catch(() => ({ nodeId: 0 })));
    await new Promise(done => setTimeout(done, 10));
  }
  expect('without scripts the lesson is there on paper', nodeId > 0);
  await without.close();

  // Memory does not grow from scene to scene.
  const m = await browser.open('file://' + pyramid);
  const memory = async () => { for (let i = 0; i < count; ++i) await m.run(`openPage(${i})`); return m.run('core.memory.byteLength'); };
  for (let round = 0; round < 7; ++round) await memory();  // what an allocator keeps free is there then: it grew once, in the sixth, of fourteen
  const first = await memory();
  await memory();
  const later = await memory();
  expect('memory does not grow from page to page', later <= first && later <= 128 * 2 ** 20, [first, later]);
  await m.close();
} finally {
  await browser.close();
}
