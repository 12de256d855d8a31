// The page as a whole: opening it and its pages, drawing, keys.

function draw() {
  page = core.ask('read');
  buffers = core.ask('buffers');
  drawStages();
  drawPixel();
  drawLesson();
  drawSettings();
  fillCompare();
  drawPictures();
  drawSteps();
  drawSpace();
}

/** @param {number} number @param {boolean} [then] */
function openPage(number, then = false) {
  if (number < 0 || number >= data.pages) return;
  const had = document.activeElement;
  if (number !== view.page || then !== view.then) verdict = null;
  page = core.ask('page', number, then ? 1 : 0);
  Object.assign(view, { page: number, then: page.then, pixel: page.pixel, channel: page.channel, level: page.level, step: null, condition: page.condition, mix: page.mix, compare: '', was: '', own: {} });
  view.pictures = page.buffers.slice(0, 2).map(({ buffer, channel, range }) => ({ buffer, channel: channel > 2 ? -1 : channel, range }));
  settings = core.ask('settings');
  forgetFrame();
  isLong = false;  // the page's own frame is there
  runFrame();
  view.part = view.fit = partDrawn();
  if (page.place) {
    const made = core.ask('step', view.level, 0, page.place);
    view.step = made.last ? null : made;
  }
  view.space = hides('inspector') ? 'world' : 'point';
  one('#settingsbox').open = !page.question && page.in_play.length === 0;
  one('#question').known = one('#answer').known = null;
  drawPixel();
  aimSpace();
  draw();
  one('#lessonbox').scrollTop = 0;
  if (had && had !== document.body && !takesKeys(had)) one('#heading').focus();  // the page is read from its beginning
  say(`${page.heading}. ${one('#count').textContent}`);
}

/** @param {string} text @param {string} type @param {string} name */
function saveFile(text, type, name) {
  const link = element('a', { href: URL.createObjectURL(new Blob([text], { type })), download: name });
  link.click();
  URL.revokeObjectURL(link.href);
}

function saveScene() {
  core.call('scene');
  saveFile(core.text(), 'text/plain', `${data.name || 'scene'}-${page.name.replace('/', '-')}.toml`);
  say('The scene is saved with your settings. Open it in Shadescope.');
}

/** A hand-in for shadescope grade. */
function saveAnswers() {
  saveFile(core.ask('answers', data.name), 'application/json', `${data.name}-answers.json`);
  say('Your answers are saved. Give the file your name before you hand it in.');
}

const kKeys = {
  '.': () => step(1),
  ',': () => step(-1),
  a: () => { one('#algorithmbox').open = !one('#algorithmbox').open; },
  '?': () => one('#help').showModal(),
  PageDown: () => openPage(view.page + 1),
  PageUp: () => openPage(view.page - 1),
};

function startKeys() {
  addEventListener('keydown', event => {
    if (event.ctrlKey || event.metaKey || event.altKey || one('#help').open) return;
    if (/** @type {Element} */ (event.target).matches('input[type=text], select, textarea')) return;
    const work = /^[1-6]$/.test(event.key) ? () => one(`#stages li:nth-child(${event.key}) button`).click() : kKeys[event.key];
    if (!work) return;
    event.preventDefault();
    guarded(work);
  });
  one('#keys').addEventListener('click', () => one('#help').showModal());
  one('#close').addEventListener('click', () => one('#help').close());
  one('#save').addEventListener('click', () => guarded(saveScene));
  one('#saveanswers').addEventListener('click', () => guarded(saveAnswers));
  addEventListener('resize', () => soon('draw', () => { drawPictures(), drawSpace(); }));
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => guarded(drawSpace));
  // The address names a page, nothing else.
  addEventListener('hashchange', () => guarded(() => openPage(firstPage())));
}

/** ?page=3 or #3: of the lesson's own pages, from 1. Without either, the questions that return. */
function firstPage() {
  const asked = parseInt(new URLSearchParams(location.search).get('page') || location.hash.slice(1), 10);
  return asked ? Math.min(data.pages - 1, data.returning + Math.max(1, asked) - 1) : 0;
}

async function start() {
  document.documentElement.classList.add('live');  // without scripts the paper stays
  if (new URLSearchParams(location.search).has('projector')) document.documentElement.classList.add('projector');
  if (typeof WebAssembly !== 'object' || !('DecompressionStream' in globalThis))
    throw new Error('This browser is too old: the page needs Chromium 91, Firefox 113, Safari 16.4 or newer.');
  const began = performance.now();
  data = JSON.parse(one('#data').textContent);
  core = await Core.start(await unpackedCore());
  for (const [name, text] of Object.entries(data.files)) core.ask('file', name, text);
  const lesson = core.ask('lesson', data.lesson, JSON.stringify(data.texts));
  data.pages = lesson.pages, data.returning = lesson.returning;
  one('#title').textContent = lesson.title;
  startStages(), startPictures(), startPixel(), startSettings(), startLesson(), startSpace(), startKeys();
  openPage(firstPage());
  requestAnimationFrame(() => {
    const root = document.documentElement;
    root.dataset.ready = '1', root.dataset.began = String(Math.round(began)), root.dataset.painted = String(Math.round(performance.now()));
  });
}

start().catch(error => {
  one('#wrong').textContent = 'This page could not start: ' + error.message, one('#wrong').hidden = false;
  one('#app').classList.add('failed');
  console.error(error);
});
