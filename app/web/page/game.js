// The wrong picture, as `shadescope bug` plays it; the catalogue of stiff cases; what must hold of the open scene; downloads. Words
// and numbers are those of the program's commands.

const game = {
  /** Its own, so that the open scene stays. @type {?Core} */
  core: null,
  seed: 0, number: 1,
  /** @type {any} */
  state: null,
  isBusy: false,
};

/** What a command of the program prints. @param {Core} of @param {string} command @param {any} options */
function commandOf(of, command, options) {
  const said = of.ask('run_command', command, JSON.stringify(options));
  if (said.status > 1) throw new Error(said.messages.trim());
  return said;
}

/** "2026.3": a seed and a picture's number, from 1. @param {string} text @returns {?number[]} */
function seedIn(text) {
  const [, seed, number = '1'] = /^(\d{1,9})(?:\.(\d{1,3}))?$/.exec(text.trim()) || [];
  return seed && Number(number) > 0 ? [Number(seed), Number(number)] : null;
}

/** @param {string} [seed] @returns {string[]} what does not fit */
function openBug(seed) {
  go('bug'), document.title = 'The wrong picture – Shadescope';
  const asked = seed === undefined ? null : seedIn(seed);
  if (asked ? asked[0] !== game.seed || asked[1] !== game.number || !game.state : !game.state) {
    const [from, number] = asked || [1000 + Math.floor(Math.random() * 9000), 1];
    guardedWait(() => beginGame(from, number));
  }
  return seed !== undefined && !asked ? [`seed=${seed}: no such picture`] : [];
}

/** @param {number} seed @param {number} number */
async function beginGame(seed, number) {
  if (game.isBusy) return;
  game.isBusy = true;
  Object.assign(game, { seed, number, state: null });
  one('#bugasked').textContent = 'The picture is being made …';
  one('#bugsaid').replaceChildren(), one('#bugreveal').hidden = one('#bugcausebox').hidden = true;
  try {
    if (!game.core) {
      game.core = await Core.of(core.module);
      for (const [name, text] of Object.entries(whole.scenes)) game.core.ask('file', name, text);
    }
    await new Promise(done => requestAnimationFrame(() => setTimeout(done)));  // the sentence is there first
    const state = game.core.ask('game', seed, number - 1), names = game.core.ask('held');
    one('#buglook').replaceChildren(...names.map(name => element('option', { value: name, textContent: name })));
    const picture = game.core.ask('picture', 'color', 0, -1, 0, 0, 0, 0, 0, 0, 0), canvas = one('#bugpicture');
    canvas.width = picture.width, canvas.height = picture.height;
    canvas.getContext('2d').putImageData(new ImageData(new Uint8ClampedArray(game.core.memory, picture.pixels, 4 * picture.width * picture.height), picture.width, picture.height), 0, 0);
    takeGame(state, 'The picture');
    history.replaceState(null, '', linkNow().hash);
  } finally {
    game.isBusy = false;
  }
}

/** @param {any} state what the core says of the game @param {string} head of what is said now */
function takeGame(state, head) {
  game.state = state;
  if (state.said) one('#bugsaid').prepend(element('li', {}, element('b', { textContent: head }), element('pre', { textContent: state.said.trimEnd(), tabIndex: 0 })));
  one('#bugasked').textContent = state.phase === 'stage' ? `${state.scene}: something is wrong. Which stage is the first that leaves something wrong?`
    : state.phase === 'cause' ? `${state.scene}: that is the stage. What is the cause?` : `${state.scene}: found, ${state.points} points.`;
  one('#bugseed').value = `${game.seed}.${game.number}`;
  one('#bugpoints').textContent = `${state.points} points · ${state.looks} ${state.looks === 1 ? 'look' : 'looks'}, ${state.par} free · ${state.hints} of 3 hints`;
  one('#bugboxes').replaceChildren(...state.boxes.map((box, i) => {
    const button = element('button', { type: 'button', disabled: box.cleared || state.phase !== 'stage' },
      element('span', { className: 'name' }, element('span', { className: 'number', textContent: i }), element('span', { className: 'label', textContent: box.label })),
      element('span', { className: box.cleared ? 'state ok' : 'state', textContent: box.cleared ? '✓ did what it should' : state.phase === 'stage' ? 'mark as wrong' : '' }));
    button.addEventListener('click', () => guarded(() => takeGame(game.core.ask('game_mark', i), `Marked: ${box.label}`)));
    return element('li', {}, button);
  }));
  one('#bugcausebox').hidden = state.phase !== 'cause';
  one('#bugcauses').replaceChildren(...state.causes.map((cause, i) => {
    const button = element('button', { type: 'button', textContent: cause.name, disabled: cause.excluded });
    button.addEventListener('click', () => guarded(() => takeGame(game.core.ask('game_name', i), `Named: ${cause.name}`)));
    return button;
  }));
  one('#bugreveal').hidden = state.phase !== 'over', one('#bugreveal').textContent = state.reveal.trimEnd();
  one('#bughint').disabled = state.phase === 'over';
  say(one('#bugasked').textContent);
}

/** @param {string} buffer empty: the pixel @param {number} [x] @param {number} [y] */
function lookAt(buffer, x = 0, y = 0) {
  takeGame(game.core.ask('game_look', buffer, x, y), buffer || `Pixel ${x}, ${y}`);
}

// --- Stiff cases

const cases = {
  /** @type {any[]} */
  list: [],
  /** Of those that have run, by id. @type {Record<string, any>} */
  results: Object.create(null),
  /** @type {?Side} */
  side: null,
  shown: '',
  run: 0,
  isBusy: false,
};

/** @param {string} [id] @returns {string[]} what does not fit */
function openCases(id) {
  go('check'), document.title = 'Stiff cases – Shadescope';
  if (!cases.list.length) {
    cases.list = JSON.parse(commandOf(core, 'check', { list: true, json: true }).out);
    one('#casehead').textContent = `${cases.list.length} stiff and extreme cases`;
    one('#cases tbody').replaceChildren(...cases.list.map(row => element('tr', { dataset: { id: row.case } },
      element('td', { className: 'number' }, element('a', { href: '#check&case=' + row.case, textContent: row.case })),
      ...[row.title, row.input].map(text => element('td', { textContent: text })), ...['number', 'number', ''].map(className => element('td', { className })))));
  }
  const known = id === undefined || cases.list.some(row => row.case === id);
  if (id !== undefined && known) {
    cases.shown = id;
    guardedWait(() => runCases([id]));
  }
  drawCase();
  return known ? [] : [`case=${id}: no such case`];
}

/** @param {string[]} ids */
async function runCases(ids) {
  if (cases.isBusy) cases.side?.stop();
  cases.side ??= new Side(core.module, () => {});
  const run = ++cases.run, began = performance.now();
  cases.isBusy = true;
  one('#casestop').hidden = ids.length < 2;
  let done = 0, holding = 0;
  try {
    for (const id of ids) {
      const [text] = await cases.side.ask(['run_command', 'check', JSON.stringify({ case: [id], json: true })]);
      if (run !== cases.run) return;
      const [result] = JSON.parse(JSON.parse(text).out).results, row = one(`#cases tr[data-id="${CSS.escape(id)}"]`);
      cases.results[id] = result;
      ++done, holding += result.holds ? 1 : 0;
      [result.naive_text, result.ours_text, result.holds ? '✓ holds' : '✗ breaks'].forEach((said, i) => { row.children[3 + i].textContent = said; });
      row.children[5].className = result.holds ? 'ok' : 'bad';
      one('#casesum').textContent = `${done} of ${ids.length} run, ${holding} hold, ${timeText(performance.now() - began)}`;
      drawCase();
    }
  } catch (error) {
    if (!error.isStopped) throw error;
  } finally {
    if (run === cases.run) cases.isBusy = false, one('#casestop').hidden = true;
  }
}

/** The case that the address names, with both forms and the bound. */
function drawCase() {
  const what = cases.list.find(row => row.case === cases.shown), box = one('#casebox'), result = cases.results[cases.shown];
  box.hidden = !what;
  for (const row of all('#cases tbody tr')) row.classList.toggle('shown', row.dataset.id === cases.shown);
  if (!what) return;
  one('h3', box).textContent = `${what.case}  ${what.title}`;
  const facts = [['input', what.input], ['the naive form', what.naive_form], ['gives', result?.naive_text || 'is being run'], ['the stable form', what.stable_form], ['gives', result?.ours_text || 'is being run'],
    ['measured', what.unit ? `${what.measure}, ${what.unit}` : what.measure], ['against', what.reference], ['holds up to', String(what.bound)], ['ends in', what.ends_in], ...(result && !result.holds ? [['breaks', result.reason]] : [])];
  one('dl', box).replaceChildren(...facts.filter(([, text]) => text).flatMap(([name, text]) => [element('dt', { textContent: name }), element('dd', { textContent: withMinus(text) })]));
}

// --- The open scene: what must hold, and downloads

function showContracts() {
  const short = value => (typeof value === 'number' ? shortNumber(value) : value);
  const rows = JSON.parse(commandOf(core, 'inspect', { contracts: true, json: true }).out), checked = rows.filter(row => row.checked > 0), broken = checked.filter(row => row.hold + (row.undecided || 0) < row.checked);
  one('#holdsum').textContent = `${rows.length} contracts of the stages, ${checked.length} checked here, ${checked.length - broken.length} hold.`;
  one('#holdbox tbody').replaceChildren(...[...broken, ...rows.filter(row => !broken.includes(row))].map(row => element('tr', { className: broken.includes(row) ? 'bad' : '' },
    element('th', { scope: 'row', textContent: row.stage + (row.light === undefined ? '' : `, light ${row.light}`) }), element('td', { textContent: row.formula }),
    element('td', { className: 'number', textContent: row.why ? '–' : `${row.hold} of ${row.checked}` }),
    element('td', { textContent: row.why || `${row.worst.place}: ${short(row.worst.value)}${row.worst.unit ? ' ' + row.worst.unit : ''}, off by ${short(row.worst.error)}` }))));
  one('#holdbox').showModal();
}

/** @param {Uint8Array|string} bytes @param {string} type @param {string} name */
function saveAs(bytes, type, name) {
  saveFile(/** @type {any} */ (bytes), type, name);
  one('#saved').textContent = `${name} is saved.`;
}

/** The bytes that `shadescope export` writes. */
function saveNumbers() {
  const buffer = one('#savebuffer').value, made = buffer === 'mix' ? { mix: view.mix } : ['condition', 'expression'].includes(buffer) ? { where: view.condition } : {};
  commandOf(core, 'export', { folder: '.', buffers: [buffer], format: ['npy'], at: view.step?.place || '', ...made });
  saveAs(core.numbers(core.ask('written', buffer + '.npy')).slice(), 'application/octet-stream', buffer + '.npy');
}

/** The picture in the palette's colours, its whole range. */
function savePicture() {
  const buffer = one('#savebuffer').value, picture = core.ask('picture', buffer, 0, -1, 0, 0, 0, 0, 0, 0, 0), [, , width, height] = picture.part;
  const canvas = element('canvas', { width, height });
  canvas.getContext('2d').putImageData(new ImageData(new Uint8ClampedArray(core.memory, picture.pixels, 4 * width * height), width, height), 0, 0);
  canvas.toBlob(blob => saveAs(/** @type {any} */ (blob), 'image/png', buffer + '.png'));
}

function showSaving() {
  const list = one('#savebuffer'), now = view.pictures[0].buffer;
  list.replaceChildren(...core.ask('held').map(name => element('option', { value: name, textContent: name })));
  if (![...list.options].some(option => option.value === now) && core.call('buffer', now, 0)) list.append(element('option', { value: now, textContent: now }));
  list.value = now, one('#saved').textContent = '';
  one('#savebox').showModal();
}

function startGame() {
  const does = (id, work) => one(id).addEventListener('click', () => guarded(work));
  does('#buglookgo', () => lookAt(one('#buglook').value));
  does('#bugpixel', () => lookAt('', Math.trunc(Number(one('#bugx').value)), Math.trunc(Number(one('#bugy').value))));
  does('#bughint', () => takeGame(game.core.ask('game_hint'), 'Hint'));
  does('#bugnext', () => { guardedWait(() => beginGame(game.seed, game.number + 1)); });
  one('#bugseed').addEventListener('change', event => {
    const asked = seedIn(event.target.value);
    if (asked) guardedWait(() => beginGame(asked[0], asked[1]));
    else event.target.value = `${game.seed}.${game.number}`;
  });
  one('#bugpicture').addEventListener('click', event => guarded(() => {
    const { width, height } = event.target, box = event.target.getBoundingClientRect();
    lookAt('', Math.min(width - 1, Math.floor((event.clientX - box.left) / box.width * width)), Math.min(height - 1, Math.floor((event.clientY - box.top) / box.height * height)));
  }));
  one('#caserun').addEventListener('click', () => guardedWait(() => runCases(cases.list.map(row => row.case))));
  does('#casestop', () => cases.side?.stop());
  does('#contractskey', showContracts);
  does('#holdclose', () => one('#holdbox').close());
  does('#savekey', showSaving);
  does('#saveclose', () => one('#savebox').close());
  does('#savenpy', saveNumbers);
  does('#savepng', savePicture);
  does('#savetoml', () => { core.call('scene'), saveAs(core.text(), 'text/plain', `${data.name || data.link || 'scene'}.toml`); });
  kInsideKeys.k = showContracts;
}
