// A talk: one cue at a time, with keys that clickers send, and the lecturer's window. Without scripts all cues stand below
// each other, with their notes.

/** @param {string} selector @param {ParentNode} [root] @returns {any} */
const one = (selector, root = document) => root.querySelector(selector);
/** @param {string} selector @param {ParentNode} [root] @returns {any[]} */
const all = (selector, root = document) => [...root.querySelectorAll(selector)];

const cues = all('.cue'), minutes = Number(document.body.dataset.minutes);
/** What the audience reads: a question or an answer, then the caption. */
const captionOf = cue => [...all('.title', cue), one('.caption', cue)].map(part => part.textContent.trim()).join(' ');
const noteOf = cue => one('.said', cue)?.textContent || '';
const nameOf = cue => one('h2', cue).textContent;
let at = 0, began = 0;
/** @type {?Window} */
let lecturer = null;

/** @param {number} number */
function show(number) {
  at = Math.max(0, Math.min(cues.length - 1, number));
  document.documentElement.classList.remove('alone');
  cues.forEach((cue, i) => cue.classList.toggle('shown', i === at));
  all('#dots button').forEach((dot, i) => (i === at ? dot.setAttribute('aria-current', 'step') : dot.removeAttribute('aria-current')));
  one('#place').textContent = `${at + 1} of ${cues.length}`;
  one('#back').disabled = at === 0, one('#forth').disabled = at === cues.length - 1;
  one('#status').textContent = `${nameOf(cues[at])}. ${captionOf(cues[at])}`;
  history.replaceState(null, '', '#' + (at + 1));
  uncover();
  fillLecturer();
}

/** The time of the talk begins with the first change. @param {number} to */
function go(to) {
  began ||= Date.now();
  show(to);
}

function uncover() { one('#cover').hidden = true; }
/** @param {string} color */
function cover(color) {
  const box = one('#cover'), isThere = !box.hidden && box.className === color;
  box.className = color, box.hidden = isThere;
  box.setAttribute('aria-label', `The screen is ${color}. Show it again.`);
  if (!isThere) box.focus();
}

/** One view of the cue alone; 0: all. @param {number} number */
function showAlone(number) {
  const views = all('.view', cues[at]), chosen = views[number - 1];
  document.documentElement.classList.toggle('alone', chosen !== undefined);
  for (const view of views) view.classList.toggle('chosen', view === chosen);
}

/** "12:05", of seconds. @param {number} seconds */
const clockText = seconds => `${seconds < 0 ? '−' : ''}${Math.floor(Math.abs(seconds) / 60)}:${String(Math.floor(Math.abs(seconds)) % 60).padStart(2, '0')}`;
const spent = () => (began ? (Date.now() - began) / 1000 : 0);

function tick() {
  const left = 60 * minutes - spent();
  if (!lecturer || lecturer.closed) return;
  const box = one('#time', lecturer.document);
  if (!box) return;
  const now = new Date();
  box.replaceChildren(...[`${clockText(spent())} since the beginning`, `${clockText(left)} left of ${minutes} min`,
    `${now.getHours()}:${String(now.getMinutes()).padStart(2, '0')}`].map((text, i) => {
    const part = box.ownerDocument.createElement('span');
    part.textContent = text, part.className = 'number' + (i === 1 && left < 0 ? ' over' : '');
    return part;
  }));
}

/** The lecturer's window: now and next, the note, the list, the time. */
function openLecturer() {
  if (lecturer && !lecturer.closed) return lecturer.focus();
  lecturer = open('', 'shadescope-notes', 'popup,width=1100,height=760');
  if (!lecturer) {
    one('#status').textContent = 'The browser has not opened a second window.';
    document.documentElement.classList.toggle('withnotes');
    return;
  }
  const page = lecturer.document, style = page.createElement('style');
  page.documentElement.lang = 'en', page.documentElement.className = 'lecturer';
  page.title = 'Notes: ' + document.title;
  style.textContent = one('style').textContent;
  page.head.replaceChildren(style);
  page.addEventListener('keydown', onKey);
  fillLecturer();
}

function fillLecturer() {
  if (!lecturer || lecturer.closed) return;
  const page = lecturer.document;
  /** @param {string} tag @param {string} text @param {string} [className] */
  const make = (tag, text, className = '') => Object.assign(page.createElement(tag), { textContent: text, className });
  const part = (heading, cue) => {
    const box = make('div', '');
    box.append(make('h2', heading + (cue ? ': ' + nameOf(cue) : '')));
    if (!cue) return box;
    box.append(page.importNode(one('.room', cue), true), make('p', captionOf(cue)));
    // The answer's choices, of which the right one is marked.
    const choices = one('.choices', one('.asks', cue) ? cues[cues.indexOf(cue) + 1] : cue);
    if (choices) box.append(page.importNode(choices, true));
    return box;
  };
  const list = make('ol', ''), time = make('div', '');
  time.id = 'time';
  cues.forEach((cue, i) => {
    const item = make('li', nameOf(cue));
    if (i === at) item.setAttribute('aria-current', 'step');
    item.addEventListener('click', () => go(i));
    list.append(item);
  });
  page.body.replaceChildren(part('Now', cues[at]), part(at + 1 < cues.length ? 'Next' : 'This is the last cue', cues[at + 1]),
    make('div', noteOf(cues[at]), 'said'), list, time);
  weigh(page);
  one('[aria-current]', list).scrollIntoView({ block: 'nearest' });
  tick();
}

/** Views share their room as in the window. @param {Document} page */
function weigh(page) {
  for (const part of all('[data-weight]', page)) part.style.flexGrow = part.dataset.weight;
}

const kKeys = {
  ArrowRight: () => go(at + 1), PageDown: () => go(at + 1), ' ': () => go(at + 1), ArrowDown: () => go(at + 1),
  ArrowLeft: () => go(at - 1), PageUp: () => go(at - 1), ArrowUp: () => go(at - 1),
  Home: () => go(0), End: () => go(cues.length - 1),
  b: () => cover('black'), '.': () => cover('black'), w: () => cover('white'),
  n: openLecturer, f: () => (document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen()),
  r: () => { began = Date.now(), tick(); },
  '?': () => one('#help').showModal(),
  Escape: uncover,
};

/** @param {KeyboardEvent} event */
function onKey(event) {
  if (event.ctrlKey || event.metaKey || event.altKey || one('#help').open) return;
  const onButton = /** @type {Element} */ (event.target).matches?.('button') && event.key === ' ';
  const work = onButton ? undefined : kKeys[event.key.length === 1 ? event.key.toLowerCase() : event.key];
  if (/^[0-9]$/.test(event.key)) return showAlone(Number(event.key));
  if (!work) return;
  event.preventDefault();
  work();
}

function start() {
  document.documentElement.classList.add('live');
  one('#foot').hidden = false;
  one('#dots').append(...cues.map((cue, i) => {
    const dot = Object.assign(document.createElement('button'), { type: 'button', title: nameOf(cue), ariaLabel: nameOf(cue) });
    dot.addEventListener('click', () => go(i));
    return dot;
  }));
  weigh(document);
  addEventListener('keydown', onKey);
  const does = (id, work) => one(id).addEventListener('click', work);
  does('#back', () => go(at - 1));
  does('#forth', () => go(at + 1));
  does('#notes', openLecturer);
  does('#keys', () => one('#help').showModal());
  does('#close', () => one('#help').close());
  does('#cover', uncover);
  const asked = () => (parseInt(location.hash.slice(1), 10) || 1) - 1;
  addEventListener('hashchange', () => show(asked()));
  addEventListener('pagehide', () => lecturer?.close());
  setInterval(tick, 500);
  show(asked());
  document.documentElement.dataset.ready = '1';
}

start();
