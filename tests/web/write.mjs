// Questions of kind write in Chromium: every one with its answer, hand-ins that mean harm, keys, sizes, a server. Arguments: the
// program.
import { execFileSync, spawnSync } from 'node:child_process';
import fs from 'node:fs';
import http from 'node:http';
import os from 'node:os';
import path from 'node:path';
import { launch } from './browser.mjs';
import { hostile, right } from './hostile.mjs';

const [program] = process.argv.slice(2), shots = process.env.SHADESCOPE_SHOTS;
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'shadescope-write-'));
let failed = 0, held = 0;
/** @param {string} claim @param {any} true_ @param {any} [found] */
function expect(claim, true_, found = '') {
  if (true_) return void ++held;
  ++failed;
  console.log(`FAILED: ${claim}${found === '' ? '' : ': ' + JSON.stringify(found)}`);
}
const lessons = JSON.parse(execFileSync(program, ['lesson', 'list', '--json'], { encoding: 'utf8' })).map(lesson => lesson.name);
const textOf = name => JSON.parse(execFileSync(program, ['lesson', 'show', name, '--json'], { encoding: 'utf8', maxBuffer: 1 << 26 }));
const write = name => {
  const file = path.join(folder, name + '.html');
  execFileSync(program, ['lesson', 'export', name, '--live', '-o', file], { stdio: 'ignore' });
  return file;
};
const kSaid = 'document.querySelector("#said").innerText';
const kIdle = '!writing.busy && verdict';
const browser = await launch();
async function run(p, text) {
  await p.run(`verdict = null, document.querySelector('#code').value = ${JSON.stringify(text)}, document.querySelector('#answer').requestSubmit()`);
  await p.until(kIdle);
  return p.run(kSaid);
}

try {
  // Every question of kind write: which lessons have one, and that its answer is right in Node and in the page.
  const pages = [];
  for (const name of lessons) {
    const questions = textOf(name).pages.map((page, i) => ({ name, i, kind: page.question?.kind, answer: page.question?.answer })).filter(one => one.kind === 'write');
    if (!questions.length) continue;
    const checked = spawnSync(program, ['lesson', 'check', name, '--strict'], { encoding: 'utf8' });
    expect(`lesson check ${name} --strict`, checked.status === 0, checked.stdout + checked.stderr);
    pages.push(...questions);
  }
  expect('12 questions and more', pages.length >= 12, pages.length);
  const stages = new Set();
  let current = '', p = null;
  for (const { name, answer } of pages) {
    if (name !== current) {
      await p?.close();
      const file = write(name), size = fs.statSync(file).size;
      expect(`${name} is under 2.0 MB`, size < 2e6, size);
      expect(`${name} has acorn's licence`, fs.readFileSync(file, 'utf8').includes('by various contributors (see AUTHORS)'));
      p = await browser.open('file://' + file), current = name;
    }
    const number = await p.run(`(() => { for (let i = 0; i < data.pages; ++i) { openPage(i); if (page.question?.write && !page.question.settled) return i; } return -1; })()`);
    expect(`${name} has the page`, number >= 0);
    stages.add(await p.run('page.question.write.stage'));
    const lines = answer.replace(/^```\n?|\n?```$/g, '');
    const start = await run(p, await p.run('page.question.write.start'));
    expect(`${name}, page ${number + 1}: the start is not right`, !/^● Right/.test(start), start);
    const said = await run(p, lines);
    expect(`${name}, page ${number + 1}: the answer is right`, /^● Right/.test(said), said);
    expect(`${name}, page ${number + 1}: full points`, await p.run('page.question.points === page.question.full'));
  }
  await p.close();
  expect('every stage', stages.size === 6, [...stages]);
  expect('no errors', p.log.length === 0, p.log);
  expect('a lesson without such a question has no acorn', !fs.readFileSync(write('opengl'), 'utf8').includes('id="writer"'));

  const file = path.join(folder, 'diffuse.html');
  const lambert = `file://${file}?page=${textOf('diffuse').pages.filter(page => !page.returns).findIndex(page => page.question?.kind === 'write') + 1}`;
  const kDefects = { 'negative diffuse light': 'return kd * I * dot(N, L);', 'lit from behind': 'return kd * I * abs(dot(N, L));', 'coefficient left out': 'return I * max(0, dot(N, L));' };
  const body = line => `function lambert(kd, I, N, L) {\n  ${line}\n}`;
  p = await browser.open(lambert, { width: 1366, height: 768 });
  for (const [name, line] of Object.entries(kDefects)) {
    const said = await run(p, body(line));
    expect(`named: ${name}`, said.toLowerCase().startsWith('△ ' + name), said);
    expect(`${name}: place and both numbers`, /first\s+\S.*expected\s+\(.*got\s+\(/s.test(said), said);
    expect(`${name}: a sentence`, said.split('\n').length > 4, said);
  }
  expect('both pictures', await p.run('document.querySelectorAll("#withlines canvas").length === 2'));
  expect('they differ', await p.run('/of \\d+ pixels differ/.test(document.querySelector("#withlines .note").textContent)'));
  await p.until('document.querySelector("#trace .now")');
  await p.run('goToVisit(0)');
  expect('own lines have their values', await p.run('/kd = \\(/.test(document.querySelector("#trace .values").textContent)'), await p.run('document.querySelector("#trace").innerText'));
  await p.run('document.activeElement.blur(), document.querySelector("#heading").focus()');
  await p.key('.');
  expect('. steps to the next line', await p.run('document.querySelector("#trace .now .text").textContent.includes("return") && /returns/.test(document.querySelector("#trace .now .values").textContent)'), await p.run('document.querySelector("#trace").innerText'));
  await p.key(',');
  expect(', steps back', await p.run('writing.at === 0'));
  for (const [i, mode] of ['wipe', 'difference'].entries()) {
    await p.run(`document.querySelectorAll('#withlines .segments button')[${i + 1}].click()`);
    expect(`${mode} shows one picture`, await p.run('document.querySelectorAll("#withlines canvas").length === 1'));
  }
  await p.run(`document.querySelector('#withlines .segments button').click()`);
  // The keyboard alone.
  await p.run('document.querySelector("#code").focus(), document.querySelector("#code").select()');
  await p.ask('Input.insertText', { text: 'const lambert = (kd, I, N, L) => kd;' });
  await p.key('Enter'), await p.key('Tab');
  expect('Tab indents', await p.run('document.querySelector("#code").value.endsWith("\\n  ")'), await p.run('document.querySelector("#code").value'));
  await p.key('Enter', 2);
  await p.until(kIdle);
  expect('Ctrl+Enter runs', /differ/.test(await p.run(kSaid)), await p.run(kSaid));
  await p.run('document.querySelector("#code").focus()');
  await p.key('Escape'), await p.key('Tab');
  expect('Esc, then Tab leaves', await p.run('document.activeElement.id === "run"'), await p.run('document.activeElement.id'));
  // A hint costs, a run does not.
  expect('runs cost nothing', await p.run('page.question.worth === page.question.full'));
  await p.run('document.querySelector("#hint").click()');
  expect('a hint costs', await p.run('page.question.worth < page.question.full'));

  for (const [name, { text, said }] of Object.entries(hostile)) {
    const found = await run(p, text);
    expect(`${name}: ${said}`, said.test(found) && !/^● Right/.test(found), found);
    expect(`${name}: the page lives`, (await p.run('document.querySelector("#heading").textContent')) === 'Your own lambert');
  }
  expect('nothing of it reached the page', await p.run('typeof evil === "undefined" && !document.querySelector("#app img") && [1, 2].map(x => x).length === 2'));
  expect('no request', p.requests.filter(url => !/^(file|blob|data):/.test(url)).length === 0, p.requests);
  expect('no error of the page', p.log.length === 0, p.log);
  for (const [name, text] of Object.entries(right)) {
    const said = await run(p, text);
    expect(`right as well: ${name}`, /^● Right/.test(said), said);
  }
  // What was run last is there after a reload, and in a hand-in, which grade runs again.
  const saved = await p.run('core.ask("answers", data.name)');
  for (const [name, text, points] of [['anna', saved, 1.5], ['bert', saved.replaceAll('if (c < 0) c = 0;', ''), 0]]) fs.mkdirSync(path.join(folder, 'in'), { recursive: true }), fs.writeFileSync(path.join(folder, 'in', name + '.json'), text);
  spawnSync(program, ['grade', path.join(folder, 'in'), '-o', path.join(folder, 'class')]);
  const rows = fs.readFileSync(path.join(folder, 'class', 'students.csv'), 'utf8');
  expect('grade runs lines again', /anna,1\.5/.test(rows) && /bert,0/.test(rows), rows);
  expect('and says so', /run again/.test(fs.readFileSync(path.join(folder, 'class', 'class.csv'), 'utf8')));
  await p.close();

  for (const [size, options, query] of [['390', { width: 390, height: 844, mobile: true, scale: 2 }, ''], ['1366', { width: 1366, height: 768 }, ''], ['projector', { width: 1280, height: 720 }, '&projector=1'], ['dark', { width: 1366, height: 768, dark: true }, '']]) {
    p = await browser.open(lambert + query, options);
    expect(`no scrolling sideways at ${size}, before`, await p.run('document.documentElement.scrollWidth <= innerWidth'));
    if (shots) await p.shot(path.join(shots, `write-${size}-start.png`));
    await run(p, body('return kd * I * dot(N, L);'));
    await p.until('document.querySelector("#trace .now")');
    expect(`no scrolling sideways at ${size}`, await p.run('document.documentElement.scrollWidth <= innerWidth'), await p.run('document.documentElement.scrollWidth'));
    const [top, bottom, height] = await p.run('(b => [b.top, b.bottom, innerHeight])(document.querySelector("#said .mark").getBoundingClientRect())');
    expect(`the verdict is in sight at ${size}`, top >= 0 && bottom <= height, [top, bottom, height]);
    if (shots) await p.shot(path.join(shots, `write-${size}.png`));
    if (shots && size === '390') await p.run('document.querySelector("#withlines").scrollIntoView()'), await p.shot(path.join(shots, 'write-390-below.png'));
    await p.close();
  }

  // From a server.
  const asked = [], server = http.createServer((request, response) => { asked.push(request.url); response.setHeader('Content-Type', 'text/html'); response.end(fs.readFileSync(file)); }).listen(0, '127.0.0.1');
  await new Promise(done => server.once('listening', done));
  p = await browser.open(`http://127.0.0.1:${/** @type {any} */ (server.address()).port}/${lambert.slice(lambert.indexOf('?'))}`, { online: true });
  const said = await run(p, body('return kd * I * max(0, dot(N, L));'));
  expect('it works from a server', /^● Right/.test(said), said);
  expect('which is asked for the page alone', asked.filter(url => !url.startsWith('/?')).every(url => url === '/favicon.ico'), asked);
  await p.close();
  server.close();
} finally {
  await browser.close();
  fs.rmSync(folder, { recursive: true, force: true, maxRetries: 5 });
}
console.log(`${held} claims hold, ${failed} do not`);
process.exitCode = failed === 0 ? 0 : 1;
