// What the page shows, and small helpers that all its parts use.

/** @param {string} selector @param {ParentNode} [root] @returns {any} */
const one = (selector, root = document) => root.querySelector(selector);
/** @param {string} selector @param {ParentNode} [root] @returns {any[]} */
const all = (selector, root = document) => [...root.querySelectorAll(selector)];

/** An element; text is text, never markup.
 * @param {string} tag @param {Record<string, any>} [properties] @param {...(Node|string)} children @returns {any} */
function element(tag, properties = {}, ...children) {
  const { dataset, ...plain } = properties, made = Object.assign(document.createElement(tag), plain);
  Object.assign(made.dataset, dataset);
  made.append(...children);
  return made;
}

/** HTML from the page's writer and the core, which escape what people have typed. @param {Element} box @param {string} html */
function fillHtml(box, html) { box.innerHTML = html; }

/** Children by key: one that has its key stays, so that the browser lays out only what has changed.
 * @param {Element} box @param {[string, () => Element][]} wanted */
function fillKept(box, wanted) {
  while (box.children.length > wanted.length) box.lastElementChild.remove();
  wanted.forEach(([key, make], i) => {
    const there = /** @type {any} */ (box.children[i]);
    if (there && there.keptAs === key) return;
    const made = Object.assign(make(), { keptAs: key });
    if (there) there.replaceWith(made);
    else box.append(made);
  });
}

/** Text, written only where it is another: what is written is laid out anew. @param {Element} part @param {string} text */
const setText = (part, text) => { if (part.textContent !== text) part.textContent = text; };

/** A word with a script, as "k_s specular". @param {string} text @returns {(Node|string)[]} */
const withScripts = text => text.split(/([A-Za-z]_[A-Za-z0-9]+)/).map((part, i) => {
  if (i % 2 === 0) return part;
  const [letter, script] = part.split('_');
  return element('span', {}, element('i', { textContent: letter }), element('sub', { textContent: script }));
});

const withMinus = text => String(text).replace(/-/g, '−');
/** @param {number} value @param {number} [digits] */
const shortNumber = (value, digits = 5) => withMinus(Number(value.toPrecision(digits)));
/** @param {number} ms */
const timeText = ms => (ms < 1 ? 'under 1 ms' : ms < 10 ? ms.toFixed(1) + ' ms' : ms.toFixed(0) + ' ms');
/** @param {string} text */
const say = text => { one('#status').textContent = text; };

// Does work once for all that came since the last picture of the screen.
const waiting = new Map();
/** @param {string} what @param {() => void} work */
function soon(what, work) {
  if (waiting.size === 0)
    requestAnimationFrame(() => {
      const works = [...waiting.values()];
      waiting.clear();
      for (const each of works) guarded(each);
    });
  waiting.set(what, work);
}

/** Shows what is wrong in place of nothing. @param {() => void} work */
function guarded(work) {
  const had = document.activeElement;
  try {
    work();
  } catch (error) {
    one('#wrong').textContent = error.message, one('#wrong').hidden = false;
    console.error(error);
  }
  keepFocus(had);
}

/** @param {?Element} part */
const takesKeys = part => !!part && part.isConnected && part.getClientRects().length > 0 && !(/** @type {any} */ (part).disabled);

/** A button that its own work has hidden or switched off gives the keyboard to the nearest one: else Tab would begin at the
 * top of the page. @param {?Element} had */
function keepFocus(had) {
  if (!had || had === document.body || takesKeys(had) || ![document.body, had].includes(/** @type {any} */ (document.activeElement))) return;
  const group = had.closest('#steps, header, section'), buttons = group ? all('button', group) : [], at = buttons.indexOf(had);
  const near = [...buttons.slice(at + 1), ...buttons.slice(0, Math.max(0, at)).reverse()].find(takesKeys);
  (near || group || one('#heading')).focus({ preventScroll: true });
}

/** @typedef {{buffer: string, channel: number, range: ?number[]}} View */
const view = {
  inside: false,                     // the instruments are shown, not the stage
  page: 0,
  then: false,
  /** @type {View[]} */
  pictures: [{ buffer: 'color', channel: -1, range: null }, { buffer: 'color', channel: -1, range: null }],
  /** @type {?number[]} */
  pixel: null,
  channel: 2,                        // of the equation
  level: 2,                          // of a step
  /** @type {any} */
  step: null,                        // where the steps are; null at the end of the frame
  compare: '',                       // the setting of B
  condition: '',                     // of the buffers condition and expression
  mix: '',                           // of the buffer mix
  space: 'point',                    // or "world"
  turned: { point: [0, 18], world: [30, 20] },  // degrees
  /** @type {number[]} */
  part: [0, 0, 1, 1],                // of the picture that is shown: x, y, width, height, pixels
  /** @type {number[]} */
  fit: [0, 0, 1, 1],                 // the part where something is drawn
  was: '',                           // the result before the last change
  /** @type {Record<string, string>} */
  own: {},                           // settings that the reader has changed, with their values before
};

/** @type {Core} */
let core;
/** The lesson as the writer has put it in. @type {any} */
let data;
// Answers of the core about what is shown now.
/** @type {any} */
let page;
/** @type {any} */
let plan;
/** @type {any[]} */
let settings = [];
/** @type {any} */
let report = null;
/** Every buffer that the scene can have. @type {any[]} */
let buffers = [];
/** @type {any} */
let mesh;

const hides = part => page.hidden.parts.includes(part);
const settingOf = key => settings.find(setting => setting.key === key);
const pictureSize = () => [settingOf('width').value, settingOf('height').value];
