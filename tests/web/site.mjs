// What a site promises: every link leads to something in it, its pages share one core and work from a folder, with the
// network off. Argument: the program.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { launch } from './browser.mjs';
import { expect, folder as work } from './claims.mjs';

const [program] = process.argv.slice(2);
const folder = path.join(work, 'a site'), url = name => 'file://' + encodeURI(path.join(folder, name));
execFileSync(program, ['site', 'export', '-o', folder], { stdio: ['ignore', 'ignore', 'inherit'] });

const files = fs.readdirSync(folder), pages = files.filter(name => name.endsWith('.html'));
const texts = new Map(pages.map(name => [name, fs.readFileSync(path.join(folder, name), 'utf8')]));
// What a page says outside of its script, its style and its data.
const markup = name => texts.get(name).replace(/<(script|style)[^]*?<\/\1>/g, match => match.slice(0, match.indexOf('>') + 1));
const idsOf = name => new Set([...markup(name).matchAll(/ id="([^"]+)"/g)].map(match => match[1]));
let links = 0;
const reached = new Set(['index.html']);
for (const name of pages) {
  const lost = [];
  for (const [, to] of markup(name).matchAll(/ (?:href|src)="([^"]*)"/g)) {
    if (/^(https:|mailto:|data:)/.test(to)) continue;
    ++links;
    const [file, id] = decodeURI(to).split('#'), target = file || name;
    reached.add(target);
    const isPlace = target === 'index.html' && ['start', 'mine', 'bug', 'check', 'study'].includes(id?.split('=')[0] ?? '');
    if (!files.includes(target) || (id && !isPlace && !idsOf(target).has(id))) lost.push(to);
  }
  expect(`every link of ${name} leads to something`, lost.length === 0, lost);
}
expect('there are many links', links > 300, links);
expect('every file is reached by a link', files.every(name => reached.has(name)), files.filter(name => !reached.has(name)));
const live = pages.filter(name => /^(lesson|scene)-/.test(name) && !name.endsWith('-paper.html'));
expect('every live page leads back to the index', live.every(name => markup(name).includes('href="index.html"')), live.filter(name => !markup(name).includes('href="index.html"')));
const index = markup('index.html'), count = kind => new Set([...index.matchAll(new RegExp(`href="${kind}-[^"]*(?<!-paper)\\.html"`, 'g'))].map(match => match[0])).size;
const lessons = JSON.parse(execFileSync(program, ['lesson', 'list', '--json'], { encoding: 'utf8' }));
expect('the index has every lesson', count('lesson') === lessons.length, count('lesson'));
const scenes = fs.readdirSync(new URL('../../resources/scenes/', import.meta.url)).filter(name => /\.(toml|scene)$/.test(name));
expect('and every scene', count('scene') === scenes.length, [count('scene'), scenes.length]);
expect('no answers of handouts are in it', !files.some(name => name.includes('answers')));
expect('one file has the core', files.filter(name => texts.get(name)?.includes('id="core"')).length === 0 && files.includes('shadescope-core.js'));

const browser = await launch();
try {
  const whole = { ready: 'document.readyState === "complete"' };
  for (const name of ['index.html', 'manual.html', 'manual-window.html']) {
    for (const width of [390, 1280]) {
      const page = await browser.open(url(name), { ...(name === 'index.html' ? {} : whole), width, mobile: width < 500, dark: width < 500 });
      expect(`${name} does not scroll sideways at ${width}`, await page.run('document.documentElement.scrollWidth <= innerWidth'), await page.run('document.documentElement.scrollWidth'));
      expect(`${name} shows all its pictures`, await page.run('[...document.images].every(image => image.naturalWidth > 0)'));
      if (name === 'index.html') {
        const shown = await page.run('[...document.querySelectorAll("#beside a")].map(link => link.getAttribute("href"))');
        expect('the index is the whole program', await page.run('one("#startpage").checkVisibility() && one("#wrong").hidden && whole.known.length > 20'), await page.run('one("#wrong").textContent'));
        expect('and leads to lectures, paper and manual', shown.includes('manual.html') && shown.filter(file => file.endsWith('-paper.html')).length === lessons.length && shown.every(file => files.includes(file)), shown);
      } else expect(`${name} has its style`, await page.run('getComputedStyle(document.querySelector("main")).maxWidth !== "none"'));
      expect(`${name} is silent`, page.log.length === 0, page.log);
      await page.close();
    }
  }
  // Every page is opened in a long run, else every sixth.
  for (const name of pages.filter((_, i) => process.env.SHADESCOPE_LONG === '1' || i % 6 === 0)) {
    const isLive = /^(lesson|scene)-/.test(name) && !name.endsWith('-paper.html');
    const page = await browser.open(url(name), isLive ? {} : whole);
    if (isLive) expect(`every page of ${name} opens`, await page.run(`(() => { for (let i = 0; one('#wrong').hidden && i < data.pages; ++i) guarded(() => openPage(i)); return one('#wrong').hidden; })()`), await page.run('one("#wrong").textContent'));
    if (name.startsWith('talk-')) expect(`every cue of ${name} is shown`, await page.run('cues.every((cue, i) => (go(i), cue.offsetParent !== null && cues.filter(other => other.offsetParent).length === 1))'));
    expect(`${name} says nothing to the console`, page.log.length === 0, page.log);
    expect(`${name} asks nothing of the network`, page.requests.every(one => /^(file|data|blob):/.test(one)), page.requests.filter(one => !/^(file|data|blob):/.test(one)));
    await page.close();
  }
  for (const name of ['scene-pyramid.html', `lesson-${lessons[0].name}.html`]) {
    const page = await browser.open(url(name));
    expect(`${name} starts with the shared core`, await page.run('document.querySelector("#wrong").hidden'), await page.run('document.querySelector("#wrong").textContent'));
    expect(`${name} asks the folder alone`, page.requests.every(one => one.startsWith('file:') || one.startsWith('data:') || one.startsWith('blob:')), page.requests);
    await page.close();
  }
  // A page that was sent without the core's file says so.
  fs.rmSync(path.join(folder, 'shadescope-core.js'));
  const alone = await browser.open(url('scene-pyramid.html'));
  expect('without the core a page says what is missing', (await alone.run('document.querySelector("#wrong").textContent')).includes('whole folder'), await alone.run('document.querySelector("#wrong").textContent'));
  await alone.close();
} finally {
  await browser.close();
}
