// A question of kind write: an editor, the student's lines in a worker, and what the core says of their results. Two workers, both
// without the page and without a network: one reads the text, one runs it. What comes back is taken as numbers, and text as text.

const kMostSilence = 1000, kMostStart = 10000, kMostRun = 10000, kStopAfter = 1000;  // ms
const kMostRounds = 8;  // a wrong result may lead to calls that the right one does not make

/** @type {any} */
const writing = { parts: null, reader: null, runner: null, run: 0, mode: 'both', trace: null, at: 0, scene: '' };

/** @param {string} text @param {(event: any) => void} failed */
function blobWorker(text, failed) {
  const url = URL.createObjectURL(new Blob([text], { type: 'text/javascript' })), worker = new Worker(url);
  URL.revokeObjectURL(url);
  worker.onerror = event => { event.preventDefault(), failed(event); };
  return worker;
}

/** One question to a worker, which is ended when it says nothing for too long. @param {any} slot @param {any} message @param {number} silence */
const askWorker = (slot, message, silence) => new Promise((done, failed) => {
  const begun = performance.now(), { worker } = slot;
  let timer = 0;
  const end = text => { clearTimeout(timer), worker.terminate(), slot.worker = null, failed(new Error(text)); };
  const wait = ms => { clearTimeout(timer), timer = setTimeout(end, ms, 'Your lines were still running after 1 s.'); };
  slot.end = () => end('You have stopped your lines.');
  slot.failed = event => end(`Your lines have ended the run: ${String(event.message || 'no memory is left').slice(0, 200)}`);
  worker.onmessage = ({ data }) => {
    if (data?.beat !== true) return void (clearTimeout(timer), done(data));
    if (performance.now() - begun > kMostRun) end('Your lines were still running after 10 s.');
    else wait(silence);
  };
  wait(silence);
  worker.postMessage(message);
});

/** What stands packed in the page: acorn with the reader, and what runs lines. */
const writerParts = async () => (writing.parts ??= JSON.parse(decoder.decode(await unpacked(one('#writer').textContent))));

/** @param {string} text @param {string} name */
async function readText(text, name) {
  const { reader } = await writerParts();
  if (!writing.reader?.worker) {
    const slot = writing.reader = /** @type {any} */ ({ worker: null });
    slot.worker = blobWorker(`${reader}\nonmessage = ({ data }) => postMessage(readLines(data.text, data.name, acorn.parse));`, event => slot.failed?.(event));
  }
  return askWorker(writing.reader, { text, name }, kMostStart);
}

/** A worker with these lines in its text. It says once that it is there; only then do lines run, and their time. */
async function startRunner({ plain, traced }) {
  const { lines } = await writerParts();
  stopRunner();
  const slot = writing.runner = /** @type {any} */ ({ worker: null });
  slot.worker = blobWorker(`"use strict";\n${lines}
    const $plain = () => ${plain}, $traced = () => ${traced};
    (() => {
      const post = self.postMessage.bind(self);
      for (const name of ['postMessage', 'close', 'importScripts', 'fetch', 'XMLHttpRequest', 'WebSocket', 'EventSource', 'WebTransport', 'Worker', 'BroadcastChannel', 'MessageChannel', 'indexedDB', 'caches', 'navigator'])
        for (let at = self; at; at = Object.getPrototypeOf(at)) { try { Object.defineProperty(at, name, { value: undefined, configurable: false, writable: false }); } catch {} }
      const made = {};
      self.onmessage = ({ data: { kind, shape, calls, numbers } }) => {
        if (kind === 'start') return post({ started: true });
        try {
          $turns = 0, $made = 0, $end = performance.now() + kMostTime;
          const lines = made[kind] ??= kind === 'trace' ? $traced() : $plain();
          const out = kind === 'trace' ? $trace(lines, shape, numbers) : { out: $run(lines, shape, calls, numbers, () => post({ beat: true })) };
          post(out);
        } catch (error) { post({ failed: $wordsOf(error), at: Number(error && error.line) || 0 }); }
      };
    })();`, event => slot.failed?.(event));
  await askWorker(slot, { kind: 'start' }, kMostStart);
}
function stopRunner() {
  writing.runner?.worker?.terminate();
  writing.runner = null;
}

// ---- A run.

/** Runs the text in the page's scene, then in the trials, up to the first in which a result differs. */
async function runLines() {
  if (writing.busy) return void writing.runner?.end?.();
  const text = one('#code').value, { write } = page.question, run = ++writing.run, isHere = () => run === writing.run;
  verdict = null, writing.trace = null;
  markLine(0);
  drawQuestion();
  one('#withlines')?.remove();
  const late = setTimeout(() => { if (isHere()) setBusy('Stop'); }, kStopAfter);
  setBusy('Running …');
  try {
    const read = await readText(text, write.function);
    if (!isHere()) return;
    if (read.errors.length) {
      const [{ line, column, text: found }] = read.errors;
      markLine(line, 'bad');
      return void sayStopped('Not run', `Line ${line}, column ${column}: ${found}.`);
    }
    await startRunner(read);
    let found;
    for (let scene = 0; scene <= write.trials && isHere() && !found?.wrong; ++scene) found = await runIn(scene, write);
    if (isHere()) await showRun(found, text);
  } catch (error) {
    if (isHere()) markLine(error.at || 0, 'bad'), sayStopped('Stopped', error.message);
  } finally {
    clearTimeout(late);
    if (isHere()) setBusy('');
  }
}

/** @param {number} scene @param {any} write */
async function runIn(scene, write) {
  let asked = core.ask('write_scene', scene), found = null;
  writing.scene = asked.name;
  const size = write.shape.endsWith('t') ? 1 : Number(write.shape.split(' > ')[1]);
  for (let round = 0; asked.calls > 0 && round < kMostRounds; ++round) {
    const numbers = core.numbers(asked).slice(), answer = await askWorker(writing.runner, { kind: 'run', shape: write.shape, calls: asked.calls, numbers }, kMostSilence);
    if (answer?.failed !== undefined) throw Object.assign(new Error(String(answer.failed)), { at: Number(answer.at) || 0 });
    if (!(answer?.out instanceof Float64Array) || answer.out.length !== asked.calls * size) throw new Error('Your lines have returned something that is no number.');
    asked = core.ask('write_results', new Uint8Array(answer.out.buffer));
    found ??= asked;
  }
  return found;
}

/** The verdict, the pictures, and the first call that differs. */
async function showRun(found, text) {
  const judged = core.ask('write_judge', text);
  if (judged.mark === 'known') data.made.mistakes.push([judged.name, page.name]);
  const element_ = core.ask('write_element', found.first);
  verdict = { ...judged, given: '', more: found.wrong ? resultTable(element_) : null };
  readAgain();
  drawMine();
  await follow(element_);
  one(page.question.settled ? '#foot' : '#said').scrollIntoView({ block: 'nearest' });
  say(all('#said > *').map(part => part.textContent.replace(/^[●△○] /, '')).join('. '));
}

function sayStopped(name, text) {
  verdict = { mark: 'stopped', name, said: '', more: element('p', { textContent: text }) };
  drawQuestion();
  say(`${name}. ${text}`);
}

const resultTable = ({ place, expected, got }) => element('table', { className: 'results' }, ...[['first', place], ['expected', expected], ['got', got]].map(([name, value]) =>
  element('tr', {}, element('th', { scope: 'row', textContent: name }), element('td', { className: name === 'got' ? 'number bad' : 'number', textContent: withMinus(value) }))));

function setBusy(text) {
  writing.busy = text !== '';
  const button = one('#run');
  if (button) button.firstChild.nodeValue = text || 'Run';
}

// ---- Pictures, and the student's lines with their values.

const pictureOf = which => {
  const found = core.ask('write_picture', which);
  return { ...found, bytes: core.numbers(found).slice() };
};

/** With these lines, right, and where they differ. */
function drawMine() {
  one('#withlines')?.remove();
  const { write } = page.question, right = pictureOf(0), mine = write.picture ? pictureOf(1) : right, { width, height } = right;
  let apart = 0;
  const off = i => Math.max(...[0, 1, 2].map(k => Math.abs(mine.bytes[3 * i + k] - right.bytes[3 * i + k])));
  for (let i = 0; i < width * height; ++i) apart += Number(off(i) > 0);
  const canvas = (name, colorAt) => {
    const made = element('canvas', { width, height, tabIndex: -1 }), context = made.getContext('2d'), pixels = context.createImageData(width, height);
    for (let i = 0; i < width * height; ++i) pixels.data.set([...colorAt(i), 255], 4 * i);
    context.putImageData(pixels, 0, 0);
    made.setAttribute('role', 'img'), made.setAttribute('aria-label', name);
    made.addEventListener('click', event => guarded(() => {
      const box = made.getBoundingClientRect(), at = core.ask('write_at', Math.floor((event.clientX - box.left) / box.width * width), Math.floor((event.clientY - box.top) / box.height * height));
      if (at >= 0) follow(core.ask('write_element', at));
    }));
    return made;
  };
  const of = bytes => i => [bytes[3 * i], bytes[3 * i + 1], bytes[3 * i + 2]];
  const figure = (name, ...parts) => element('figure', {}, element('figcaption', { textContent: name }), ...parts);
  const kModes = { both: 'side by side', wipe: 'wipe', difference: 'difference' };
  const box = element('div', { className: 'pair' }), segments = element('div', { className: 'segments' });
  segments.setAttribute('role', 'group'), segments.setAttribute('aria-label', 'How the pictures are compared');
  const fill = () => {
    const line = element('input', { type: 'range', min: 0, max: width, value: width >> 1, ariaLabel: 'Line between the two pictures' });
    const wiped = () => canvas('With your lines at the left, right at the right', i => of(i % width < Number(line.value) ? mine.bytes : right.bytes)(i));
    const grey = i => { const d = off(i), g = 40 + right.bytes[3 * i + 1] / 3; return d > 0 ? [255, 60 + Math.max(0, 150 - 2 * d), 140] : [g, g, g]; };
    const yours = () => figure('A, with your lines', canvas('The picture with your lines', of(mine.bytes))), theirs = figure('B, right', canvas('The right picture', of(right.bytes)));
    box.replaceChildren(...(!write.picture ? [theirs] : writing.mode === 'both' ? [yours(), theirs]
      : writing.mode === 'wipe' ? [figure('A at the left, B at the right', wiped(), line)] : [figure('Where A and B differ', canvas('Pixels that differ', grey))]));
    line.addEventListener('input', () => box.querySelector('canvas').replaceWith(wiped()));
    for (const button of segments.children) button.setAttribute('aria-pressed', String(/** @type {any} */ (button).value === writing.mode));
  };
  segments.append(...Object.entries(kModes).map(([value, textContent]) => {
    const button = element('button', { type: 'button', value, textContent });
    button.addEventListener('click', () => { writing.mode = value, fill(); });
    return button;
  }));
  fill();
  const note = !write.picture ? 'Of this function the numbers alone are compared.' : apart ? `${apart} of ${width * height} pixels differ.` : 'The two pictures are equal; the numbers decide.';
  one('#stage').append(element('section', { id: 'withlines', ariaLabel: 'With your lines' },
    element('p', { className: 'bar' }, element('b', { textContent: ['Transform', 'Cull', 'Normals', 'Shadow buffer', 'Z-buffer', 'Shading'][write.stage] + ': your lines' }), write.picture ? segments : '',
      element('span', { className: 'note', textContent: (writing.scene ? `In ${writing.scene}. ` : '') + note })), box, element('section', { id: 'trace', ariaLabel: 'Your lines with their values', hidden: true })));
}

const wordsOf = value => (Array.isArray(value) ? `(${value.slice(0, 16).map(wordsOf).join(', ')})` : typeof value === 'number' ? Number.isNaN(value) ? 'not a number' : withMinus(Number.isFinite(value) ? Number(value.toPrecision(4)) : value > 0 ? '∞' : '-∞')
  : value === undefined ? 'nothing' : String(value).slice(0, 60));
/** What a line did, from a worker that runs foreign text: whatever it is becomes words. */
function visitWords(visit) {
  if (visit?.values) return Array.from(visit.values).slice(0, 12).map(pair => `${String(pair?.[0]).slice(0, 40)} = ${wordsOf(pair?.[1])}`).join('  ');
  if (visit && 'returned' in visit) return `returns ${wordsOf(visit.returned)}`;
  const compared = visit?.compared ? `${wordsOf(visit.compared[0])} ${String(visit.compared[1]).slice(0, 3)} ${wordsOf(visit.compared[2])}: ` : '';
  return compared + (visit?.taken === true ? 'true' : 'false');
}

/** One call once more, with the values of each line. @param {any} found of write_element */
async function follow(found) {
  const numbers = core.numbers(found).slice(), { write } = page.question, run = writing.run;
  if (!writing.runner?.worker) return;
  const answer = await askWorker(writing.runner, { kind: 'trace', shape: write.shape, calls: 1, numbers }, kMostSilence + 500).catch(() => null);
  if (run !== writing.run || !one('#trace') || !Array.isArray(answer?.visits)) return;
  const visits = answer.visits.slice(0, 2000).map(visit => ({ line: Number(visit?.line) || 0, words: visitWords(visit) }));
  writing.trace = { found, visits, threw: String(answer.threw || '').slice(0, 200), line: Number(answer.at) || 0 };
  writing.at = found.wrong ? 0 : visits.length;
  buildTrace();
}

function buildTrace() {
  const { found } = writing.trace, go = (id, text, name, to) => {
    const button = element('button', { type: 'button', id, className: name ? 'icon' : id === 'forthline' ? 'primary' : '' }, ...text);
    if (name) button.ariaLabel = name;
    button.addEventListener('click', () => guarded(() => goToVisit(to())));
    return button;
  };
  const next = element('button', { type: 'button', className: 'link', textContent: 'Next that differs' });
  next.hidden = core.ask('write_next', found.number) === found.number || core.ask('write_next', found.number) < 0;
  next.addEventListener('click', () => guarded(() => { follow(core.ask('write_element', core.ask('write_next', found.number))); }));
  one('#trace').hidden = false;
  one('#trace').replaceChildren(element('h3', { textContent: `Your lines at ${found.place}` }), element('p', { className: 'note number', hidden: /^\w+ = /.test(writing.trace.visits[0]?.words), textContent: withMinus(found.arguments.join('   ')) }), element('ol', { className: 'code' }),
    element('p', { className: 'row' }, go('firstline', ['|‹'], 'To the first line', () => 0), go('backline', ['Back ', element('kbd', { textContent: ',' })], '', () => writing.at - 1),
      go('forthline', ['Step ', element('kbd', { textContent: '.' })], '', () => writing.at + 1), go('lastline', ['›|'], 'To the end', () => writing.trace.visits.length), element('span', { className: 'note number', id: 'atline' }), element('span', { className: 'gap' }), next),
    element('p', { id: 'outcome' }));
  drawTrace();
}

/** @param {number} at */
function goToVisit(at) {
  if (!writing.trace) return;
  writing.at = clamp(at, 0, writing.trace.visits.length);
  drawTrace();
  one('#trace .now')?.scrollIntoView({ block: 'nearest' });
}

function drawTrace() {
  const { visits, found, threw, line } = writing.trace, { at } = writing, now = at < visits.length ? visits[at].line : 0, seen = new Map();
  // Of a loop the last turn; of a line that tells several things all that it told this time.
  let before = 0;
  for (const visit of visits.slice(0, at + 1)) seen.set(visit.line, visit.line === before ? [...seen.get(visit.line), visit.words].slice(-3) : [visit.words]), before = visit.line;
  one('#trace .code').replaceChildren(...one('#code').value.replace(/\s+$/, '').split('\n').map((text, i) => element('li', { className: i + 1 === now ? 'now' : seen.has(i + 1) ? '' : 'elsewhere' },
    element('span', { className: 'text', textContent: text || ' ' }), element('span', { className: 'values', textContent: (seen.get(i + 1) || []).join('  ') }))));
  const current = one('#trace .now');
  if (current) current.setAttribute('aria-current', 'step');
  one('#atline').textContent = `${Math.min(at + 1, visits.length)} of ${visits.length}`;
  one('#backline').disabled = one('#firstline').disabled = at === 0;
  one('#forthline').disabled = one('#lastline').disabled = at >= visits.length;
  const isAtEnd = at >= visits.length - 1, value = (text, isBad) => element('span', { className: isBad ? 'number bad' : 'number good', textContent: withMinus(text) });
  one('#outcome').replaceChildren(...(!isAtEnd ? [] : threw ? [value(`${line ? `Line ${line}: ` : ''}${threw}`, true)]
    : found.wrong ? ['Your lines give ', value(found.got, true), ', the program ', value(found.expected, false), '.'] : ['Your lines give ', value(found.got, false), ', as the program does.']));
  markLine(now, 'now');
}

// ---- The editor: a text field with line numbers that indents.

/** @param {number} line from 1; 0: none @param {string} [kind] */
function markLine(line, kind = 'now') {
  const lines = one('#code').value.split('\n');
  one('#marks').replaceChildren(...lines.map((_, i) => element('span', { className: i + 1 === line ? kind : '', textContent: String(i + 1) })));
  one('#code').rows = Math.max(lines.length, 4);
}

/** @param {any} question */
function writeFields(question) {
  const { write } = question, code = element('textarea', { id: 'code', spellcheck: false, wrap: 'off', autocomplete: 'off', value: write.last || write.start });
  code.setAttribute('autocapitalize', 'off'), code.setAttribute('aria-label', 'Your lines'), code.setAttribute('aria-describedby', 'asked contract');
  const contract = element('p', { className: 'note', id: 'contract' }, ...write.takes.flatMap(([name, meaning, isList], i) => [i ? '; ' : '', element('code', { textContent: name }), `${isList ? ', a list' : ''}: ${meaning}`]), `. Return: ${write.result}.`);
  const words = element('details', { className: 'words' }, element('summary', { textContent: 'Words' }), element('p', { className: 'note' }, 'JavaScript. ', element('code', { textContent: '+ − * /' }), ' also work on vectors such as ',
    element('code', { textContent: '[1, 0, 0]' }), '. There are ', element('code', { textContent: 'dot cross length normalize sqrt pow abs min max floor round sin cos tan radians' }), '. Tab indents; Esc, then Tab, leaves the field.'));
  const button = (id, text, work) => {
    const made = element('button', { type: 'button', id, className: 'link', textContent: text });
    made.addEventListener('click', () => guarded(work));
    return made;
  };
  const run = element('button', { type: 'submit', className: 'primary', id: 'run' }, 'Run', ' ', element('kbd', { textContent: 'Ctrl+Enter' }));
  code.addEventListener('input', () => markLine(0)), code.addEventListener('keydown', editKey);
  soon('editor', () => markLine(0));
  writing.run += 1, writing.busy = false, writing.trace = null;
  stopRunner();
  return [contract, element('div', { className: 'editor' }, element('div', { id: 'marks', ariaHidden: 'true' }), code), run, button('anew', 'Begin anew', () => { code.value = write.start, markLine(0); }), words];
}

let leavesEditor = false;
/** @param {any} event */
function editKey(event) {
  const field = event.target, { key } = event, insert = text => { event.preventDefault(), document.execCommand('insertText', false, text); };
  const lineStart = field.value.lastIndexOf('\n', field.selectionStart - 1) + 1, before = field.value.slice(lineStart, field.selectionStart);
  if (key === 'Escape') return void (leavesEditor = true);
  if (key === 'Tab' && !leavesEditor && !event.shiftKey) insert('  ');
  else if (key === 'Tab' && !leavesEditor) {
    event.preventDefault();
    if (field.value.startsWith('  ', lineStart)) field.setSelectionRange(lineStart, lineStart + 2), document.execCommand('delete');
  } else if (key === 'Enter' && (event.ctrlKey || event.metaKey)) event.preventDefault(), guarded(runLines);
  else if (key === 'Enter') insert('\n' + before.match(/^ */)[0] + (/[{([]\s*$/.test(before) ? '  ' : ''));
  else if (key === '}' && /^ +$/.test(before) && field.selectionStart === field.selectionEnd) {
    if (before.endsWith('  ')) field.setSelectionRange(field.selectionStart - 2, field.selectionStart);
    insert('}');
  }
  if (key !== 'Shift') leavesEditor = false;
}

addEventListener('keydown', event => {
  if (!one('#trace') || one('#trace').hidden || event.ctrlKey || event.metaKey || event.altKey || !/^[.,]$/.test(event.key)) return;
  if (/** @type {Element} */ (event.target).matches('input[type=text], select, textarea')) return;
  guarded(() => goToVisit(writing.at + (event.key === '.' ? 1 : -1)));
});
