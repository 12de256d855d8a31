// The page as a whole: opening it and its pages, drawing, keys.

function draw() {
  page = core.ask('read');
  drawLesson();
  if (!view.inside) return void (drawPixel(), drawHeld());
  buffers = core.ask('buffers');
  drawStages();
  drawPixel();
  drawSettings();
  fillCompare();
  drawPictures();
  drawSteps();
  drawSpace();
}

/** Among the instruments a second picture stands beside the one that a half shows. @returns {View[]} */
function picturesInside() {
  const shown = page.buffers.slice(0, 2).map(({ buffer, channel, range }) => ({ buffer, channel: channel > 2 ? -1 : channel, range }));
  const second = ['n_dot_l.0', 'polygon_id', 'color'].find(name => name !== shown[0].buffer && buffers.some(buffer => buffer.name === name));
  return shown.length > 1 ? shown : [...shown, { buffer: second, channel: -1, range: null }];
}

/** @param {number} number @param {boolean} [then] */
function openPage(number, then = false) {
  if (number < 0 || number >= data.pages) return;
  const had = document.activeElement;
  keepPicture();
  one('#end').hidden = true, one('main').hidden = false;
  if (number !== view.page || then !== view.then) verdict = null;
  page = core.ask('page', number, then ? 1 : 0);
  if (page.question && !page.question.settled && !data.isScene) view.inside = false;
  document.documentElement.classList.toggle('inside', view.inside);
  Object.assign(view, { page: number, then: page.then, pixel: page.pixel, channel: page.channel, level: page.level, step: null, condition: page.condition, mix: page.mix, compare: '', was: '', own: {} });
  settings = core.ask('settings'), buffers = core.ask('buffers');
  view.pictures = picturesInside();
  forgetFrame();
  isLong = false;  // the page's own frame is there
  runFrame();
  held = core.ask('holds');
  view.part = view.fit = partDrawn();
  if (view.inside) goToPlace();
  view.space = page.space === 'world' || hides('inspector') ? 'world' : 'point';
  one('#settingsbox').open = !page.question && page.in_play.length === 0;
  one('#question').known = one('#answer').known = null;
  one('#question').classList.remove('lit');
  drawPixel();
  aimSpace();
  buildStage();
  draw();
  one('#lessonbox').scrollTop = 0;
  if (had && had !== document.body && !takesKeys(had)) one('#heading').focus({ preventScroll: true });  // the page is read from its beginning
  say(`${page.heading}. ${one('#count').textContent}`);
}

/** The instruments in place of the stage, or the stage again. @param {boolean} inside */
function lookInside(inside) {
  if (inside === view.inside || !mayLookInside() || data.isScene) return;
  view.inside = inside;
  document.documentElement.classList.toggle('inside', inside);
  if (!inside) view.step = null;
  buildStage();
  isLong = false;
  runFrame(draw);
  say(inside ? 'The instruments are shown.' : 'The picture is shown.');
}

/** Once nothing is hidden any more. */
const mayLookInside = () => !page.question || page.question.settled;

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
  '?': () => one('#help').showModal(),
  i: () => lookInside(!view.inside),
  PageDown: () => (view.page + 1 < data.pages ? openPage(view.page + 1) : undefined),
  PageUp: () => openPage(view.page - 1),
};
const kInsideKeys = {
  '.': () => step(1),
  ',': () => step(-1),
  a: () => { one('#algorithmbox').open = !one('#algorithmbox').open; },
};

/** What a digit does: the end of a stage inside, else an option, or the beginning of a number. @param {string} key */
function digitKey(key) {
  if (!/^[0-9]$/.test(key)) return undefined;
  if (view.inside) return /^[1-6]$/.test(key) ? () => one(`#stages li:nth-child(${key}) button`).click() : undefined;
  if (!page.question || page.question.settled) return undefined;
  const option = all('#answer .option input')[Number(key) - 1];
  return option ? () => option.click() : undefined;
}

/** A lesson or scene is shown, not another place of the page that is the whole program. */
const isLessonShown = () => (document.documentElement.dataset.place || 'scene') === 'scene';

function startKeys() {
  addEventListener('keydown', event => {
    if (!isLessonShown() || event.ctrlKey || event.metaKey || event.altKey || one('#help').open) return;
    if (/** @type {Element} */ (event.target).matches('input[type=text], select, textarea')) return;
    const typed = one('#typed');
    if (typed && takesKeys(typed) && /^[-0-9]$/.test(event.key)) return void typed.focus();  // which takes the key
    const work = digitKey(event.key) || kKeys[event.key] || (view.inside ? kInsideKeys[event.key] : undefined);
    if (!work) return;
    event.preventDefault();
    guarded(work);
  });
  one('#keys').addEventListener('click', () => one('#help').showModal());
  one('#close').addEventListener('click', () => one('#help').close());
  one('#look').addEventListener('click', () => guarded(() => lookInside(!view.inside)));
  one('#save').addEventListener('click', () => guarded(saveScene));
  one('#saveanswers').addEventListener('click', () => guarded(saveAnswers));
  addEventListener('resize', () => soon('draw', () => { if (view.inside) drawPictures(), drawSpace(); }));
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => { if (isLessonShown()) guarded(drawSpace); });
  addEventListener('beforeprint', () => { if (isLessonShown()) guarded(drawPaper); });
}

/** What is wrong with the browser, before anything is asked of it. */
function checkBrowser() {
  if (typeof WebAssembly !== 'object' || !('DecompressionStream' in globalThis))
    throw new Error('This browser is too old: the page needs Chromium 91, Firefox 113, Safari 16.4 or newer.');
}

/** The parts of a lesson's page. */
function startParts() { startStage(), startStages(), startPictures(), startPixel(), startSettings(), startLesson(), startSpace(), startKeys(); }

/** The lesson whose pages are opened from now on. @param {any} lesson title, name, text, files */
function takeLesson(lesson) {
  data.made = { points: {}, mistakes: [], pictures: {} };
  for (const [name, text] of Object.entries(lesson.files)) core.ask('file', name, text);
  const opened = core.ask('lesson', lesson.lesson, JSON.stringify(lesson.texts));
  data.pages = opened.pages, data.points = opened.points, data.isScene = lesson.name === '';
  if (!data.isScene) rememberAnswers();
  view.inside = data.isScene;
  document.documentElement.classList.toggle('scene', data.isScene);
  one('#title').textContent = opened.title;
}

/** @param {Error} error */
function sayCannotStart(error) {
  one('#wrong').textContent = 'This page could not start: ' + error.message, one('#wrong').hidden = false;
  one('#app').classList.add('failed');
  console.error(error);
}
