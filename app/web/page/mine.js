// My renderer: what the reader's renderer has written, beside what the program makes of the same scene. Words, marks and numbers
// are those of the JSON that `shadescope compare --json` prints.

const mine = {
  /** The scene that both draw, with the files that it names. @type {?{name: string, list: {name: string, bytes: Uint8Array}[]}} */
  scene: null,
  /** Scenes of the folder. @type {{name: string, list: {name: string, bytes: Uint8Array}[]}[]} */
  offered: [],
  isChosen: false,                   // by the reader, so that a folder's own does not take its place
  /** @type {string[]} */
  settings: [],                      // of the scene, KEY=VALUE
  /** Conventions by hand, before those of mine.toml. @type {Record<string, string>} */
  stated: Object.create(null),
  /** @type {Brought[]} */
  files: [],
  name: '',                          // of the folder
  /** @type {any} */
  folder: null,                      // its handle, where the browser gives one
  watching: () => {},                // ends the watch
  /** The verdict, and its text as it came. @type {any} */
  report: null,
  json: '',
  /** @type {{text: string, bold: boolean}[]} */
  lines: [],
  /** @type {number[][]} */
  worst: [],                         // pixels to look at
  worstAt: 0,
  shown: '',                         // the buffer
  /** @type {?number[]} */
  pixel: null,
  kinds: [0, 3],                     // of the two pictures, as verdict_picture() has them
  hints: 3,                          // how much is given away
  most: 3,                           // and may be, by the link
  isBusy: false,
  isAsking: false,                   // for pictures
  isLate: false,                     // other ones than those that were asked for are wanted
  wasStopped: false,
  run: 0,
  /** @type {?Side} */
  side: null,
  /** Others, while names are tried. @type {Side[]} */
  helpers: [],
};
/** Cores that try the known errors together; each reads the files anew. */
function workersOfNames() { return /** @type {any} */ (navigator).deviceMemory < 4 ? 1 : Math.max(1, Math.min(4, navigator.hardwareConcurrency - 1)); }
const kNumbers = /\.(npy|png|tga|bmp|ppm|pgm|pbm|pnm|pfm|exr|csv)$/i, kScenes = /\.(toml|scene)$/i, kModels = /\.(obj|ply|stl|off|gltf|glb)$/i;
const kOfScene = /\.(toml|scene|des|obj|mtl|ply|stl|off|gltf|glb|bin)$/i;
const kSigns = { 'agrees': 'ok', 'wrong here': 'bad', 'given what it got': 'given', 'no file': 'none', 'cannot tell': 'unclear' };
const lastName = path => path.slice(path.lastIndexOf('/') + 1);
const pathSaid = () => (mine.name ? `${mine.name}/: ` : '') + (mine.files.length === 1 ? '1 file' : `${mine.files.length} files`);
const buffersOf = report => report.stages.flatMap(stage => stage.buffers);

/** Files that hold a scene, each with what it may name. @param {Brought[]} files */
function scenesAmong(files) {
  const list = files.filter(file => kOfScene.test(file.path)).map(file => ({ name: lastName(file.path), bytes: file.bytes }));
  return list.filter(({ name }) => kScenes.test(name) && name !== 'mine.toml').map(({ name }) => ({ name, list }));
}
/** A scene that comes with the page. @param {string} name of its file */
const sceneOfPage = name => ({ name, list: Object.entries(whole.scenes).map(([file, text]) => ({ name: file, bytes: encoder.encode(text) })) });
/** The calls that open a scene. */
const callsOfScene = ({ name, list }) => [...list.map(file => ['file', file.name, file.bytes]), ['open', name, list.find(file => file.name === name).bytes], ...mine.settings.map(text => ['set', text])];

/** @param {Drop} drop */
function takeMine({ name, folder, list }) {
  mine.watching();
  Object.assign(mine, { files: list, name, folder, report: null, pixel: null, shown: '', stated: mine.files.length ? Object.create(null) : mine.stated });
  mine.offered = scenesAmong(list);
  if (mine.offered.length && !mine.isChosen) mine.scene = mine.offered.length === 1 ? mine.offered[0] : null;
  mine.watching = folder ? watchFolder(folder, list, now => { mine.files = now, compareMine(); }) : () => {};
  compareMine();
}

/** Compares anew; a comparison that runs is stopped. Stages come first, names follow. @param {boolean} [names] */
async function compareMine(names = true) {
  if (mine.isBusy) stopMine();
  mine.side ??= new Side(core.module, tellNames);
  const run = ++mine.run;
  Object.assign(mine, { isBusy: mine.scene !== null && mine.files.length > 0, wasStopped: false });
  drawMine();
  if (!mine.isBusy) return;
  // Chosen one by one, the file of the scene is none of the renderer's; of a folder the core tells them apart.
  const handed = mine.files.filter(file => mine.name || lastName(file.path) !== mine.scene.name);
  const isNumbers = file => kNumbers.test(file.path) || kOfScene.test(file.path);
  const begin = () => [...callsOfScene(mine.scene), ['take_back'], ...handed.map(file => ['hand', file.path, isNumbers(file) ? file.bytes : '', mine.name ? 0 : 1]),
    ['verdict_options', JSON.stringify({ known: false, hints: mine.hints, stated: mine.stated })], ['verdict', mine.name || 'files']];
  try {
    for (const known of names ? [false, true] : [false]) {
      if (known) await measureNames(begin(), workersOfNames());
      const answers = await mine.side.ask(...(known ? [['verdict_names']] : begin()), ['verdict_text', 100], ['verdict_worst']);
      if (run !== mine.run) return;
      takeReport(answers.at(-3), JSON.parse(answers.at(-2)), JSON.parse(answers.at(-1)), !known);
      mine.isBusy = names && !known && mine.hints >= 3 && mine.report.exit === 1;
      drawMine(), await drawMinePictures();
      if (!mine.isBusy) break;
    }
  } catch (error) {
    if (run !== mine.run) return;
    mine.isBusy = false;
    if (!error.isStopped) drawMine(error.isTrap ? `Not enough memory for ${mine.files.length} files of this size: hand in fewer, or compare at a smaller size.` : error.message);
  }
  if (run === mine.run) document.documentElement.dataset.compared = String(run);
}

/** The known errors, shared out among cores: what each has measured is given to the one that judges.
 * @param {any[][]} begin the calls that compare the stages @param {number} count */
async function measureNames(begin, count) {
  if (count < 2) return;
  while (mine.helpers.length < count - 1) mine.helpers.push(new Side(core.module, () => {}));
  const helped = mine.helpers.slice(0, count - 1).map((side, i) => side.ask(...begin, ['names_part', i + 1, count]).then(answers => answers.at(-1), error => {
    if (error.isStopped) throw error;
    return '[]';  // out of memory: the first measures what is missing
  }));
  const own = mine.side.ask(['names_part', 0, count]).then(answers => answers.at(-1));
  await mine.side.ask(...(await Promise.all([own, ...helped])).map(part => ['names_given', part]));
  mine.helpers.forEach(side => side.stop());  // which frees their memory
}
function tellNames(what, done, all) {
  one('#mineprogress').value = done / all;
  one('#minedone').textContent = `Known errors ${done} of ${all}`;
  if (done * 10 % all < 10) sayMine(`${Math.floor(10 * done / all) * 10} % of the known errors are tried.`);
}
function stopMine() { for (const side of [mine.side, ...mine.helpers]) side?.stop(); }

/** @param {string} json @param {any[]} lines @param {any} worst @param {boolean} isFirst the names are still to come */
function takeReport(json, lines, worst, isFirst) {
  const stays = mine.report && !isFirst;  // the reader may have gone on to another pixel
  Object.assign(mine, { json, lines, report: JSON.parse(json), worst: worst.pixels });
  const pictures = buffersOf(mine.report).filter(row => row.picture).map(row => row.name);
  if (stays && pictures.includes(mine.shown)) return;
  if (!pictures.includes(mine.shown)) mine.shown = worst.buffer || pictures.find(name => name === 'color') || pictures[0] || '';
  mine.worstAt = 0;
  if (mine.hints >= 2 && worst.pixels.length) mine.pixel = worst.pixels[mine.worstAt++];
}

const sayMine = text => { one('#minesaid').textContent = text; };

/** @param {string} [trouble] */
function drawMine(trouble = '') {
  const report = mine.report, choice = one('#minescene');
  const needsScene = mine.files.length > 0 && !mine.scene;
  const problems = report && report.refused > 0 ? report.problems.slice(-report.refused) : [], more = problems.length - 2;
  const refused = (more > 1 ? [...problems.slice(0, 2), `and ${more} more files: see Files`] : problems).join('\n');
  const said = trouble || refused || (needsScene ? mine.offered.length > 1 ? `There are ${mine.offered.length} scenes in your folder. Choose above the one that your renderer draws.` : 'Which scene does your renderer draw? Choose it above, or drop its file.' : mine.wasStopped ? 'The comparison was cancelled.' : '');
  one('#minetrouble').textContent = said, one('#minetrouble').hidden = said === '';
  one('#minefolder').textContent = mine.files.length ? pathSaid() + (mine.folder ? ', watched' : '') : '';
  one('#minewatch').hidden = mine.files.length === 0 || mine.folder !== null;
  one('#minewatch').textContent = 'This browser cannot watch a folder. Drop it again after your renderer has written.';
  one('#mineagain').hidden = mine.files.length === 0, one('#mineempty').hidden = mine.files.length > 0;
  for (const { name } of [...mine.offered, ...(mine.scene ? [mine.scene] : [])])
    if (![...choice.options].some(option => option.value === name)) choice.append(element('option', { value: name, textContent: `${name}, yours` }));
  choice.value = mine.scene ? mine.scene.name : '';
  if (document.activeElement !== one('#mineset')) one('#mineset').value = mine.settings.join('; ');
  one('#minework').hidden = !mine.isBusy;
  if (mine.isBusy && !report) one('#minedone').textContent = 'Your files are being compared', one('#mineprogress').removeAttribute('value');
  one('#minestrip').hidden = !report || mine.hints < 1 && report.exit === 1;
  if (!report) one('#minepixel').hidden = true;
  one('#minebody').hidden = !report && !mine.isBusy;
  all('#minebox > :not(#minework), .minepictures').forEach(part => part.classList.toggle('absentnow', !report));
  if (!report) return;
  document.title = `${report.headline} – Shadescope`;
  if (!mine.isBusy) sayMine(report.headline);
  one('#minesign').textContent = report.exit === 1 ? '✗' : report.exit === 0 ? '✓' : '?';
  one('#minesign').className = 'sign ' + (report.exit === 1 ? 'bad' : report.exit === 0 ? 'ok' : 'unclear');
  one('#minehead').textContent = report.headline;
  one('#mineevidence').textContent = report.evidence;
  drawMineStrip(), drawMineLikely(), drawMineLists();
  one('#mineworst').hidden = mine.hints < 2 || mine.worst.length === 0;
}

function drawMineStrip() {
  one('#minestrip').replaceChildren(...mine.report.stages.map((stage, i) => {
    const kind = kSigns[stage.verdict] || 'none', telling = stage.buffers.find(row => !row.agrees) || stage.buffers[0];
    const told = stage.verdict === 'wrong here' && telling ? `${telling.name} ${telling.text}` : '';
    const button = element('button', { type: 'button', className: kind, title: [stage.own, ...stage.buffers.map(row => `${row.name}: ${row.text}`)].filter(text => text).join('\n'), disabled: !stage.buffers.some(row => row.picture) },
      element('span', { className: 'name' }, element('span', { className: 'number', textContent: i + 1 }), element('span', { className: 'label', textContent: stage.label }), element('span', { className: `sign ${kind}`, textContent: stage.mark || '', ariaHidden: 'true' })),
      element('span', { className: `state ${kind}`, textContent: stage.verdict || '' }));
    button.setAttribute('aria-label', [`${i + 1} ${stage.label}`, stage.verdict, told].filter(text => text).join(', '));
    button.addEventListener('click', () => goToStage(stage));
    return element('li', {}, button);
  }));
}

/** The first of its pictures that differs, else the first. */
function goToStage(stage) {
  const pictures = stage.buffers.filter(row => row.picture), wrong = pictures.find(row => !row.agrees);
  if (pictures.length) showMine((wrong || pictures[0]).name, wrong?.worst || mine.pixel);
}
/** @param {string} buffer @param {?number[]} pixel */
function showMine(buffer, pixel) {
  mine.shown = buffer, mine.pixel = pixel;
  drawMinePictures();
}
function goToWorst() {
  if (mine.hints < 2 || !mine.worst.length) return;
  showMine(mine.shown, mine.worst[mine.worstAt % mine.worst.length]);
  ++mine.worstAt;
}

/** 100 % only where nothing is left over. @param {number} share */
function percentText(share) {
  const percent = Math.max(0, Math.min(share < .9995 ? 99.9 : 100, 100 * share));
  return percent.toFixed(percent > 99 && percent < 100 ? 1 : 0) + ' %';
}

function drawMineLikely() {
  const { report } = mine, box = one('#minelikely'), known = report.known, isOne = known.length === 1;
  box.hidden = mine.hints < 3 || report.exit !== 1;
  if (box.hidden) return;
  /** @param {any} row @param {number} number */
  const card = (row, number) => element('div', { className: 'likely' }, element('b', { textContent: (isOne ? '' : `${number + 1}  `) + row.name }),
    element('span', {}, element('span', { className: 'note', textContent: 'yours ' }), element('code', { className: 'bad', textContent: row.wrong })),
    element('span', {}, element('span', { className: 'note', textContent: 'right ' }), element('code', { textContent: row.right })),
    element('div', { className: 'row' }, element('span', { className: 'note', textContent: 'explains' }), element('meter', { value: Math.max(0, row.explained), max: 1, ariaLabel: 'explains' }), element('span', { className: 'number', textContent: percentText(row.explained) })),
    ...(row.lesson ? [element('span', { className: 'note', textContent: `Lesson ${row.lesson}, page “${row.lesson_page}”` })] : []));
  const parts = [element('h3', { textContent: 'Likely error' })];
  if (report.likely) parts.push(element('p', { className: 'note', textContent: report.likely }));
  else parts.push(element('p', { className: 'note', textContent: mine.isBusy ? 'The known errors are being tried.' : 'The known errors were not tried.' }));
  parts.push(...known.map(card));
  const { experiment } = report;
  if (experiment) {
    parts.push(element('h3', { textContent: `What tells them apart: print ${experiment.place} of ${experiment.buffer}.` }));
    parts.push(element('ul', {}, ...experiment.between.map((id, i) => element('li', {}, element('span', { className: 'number', textContent: experiment.values[id] }), ` means ${i + 1}`))));
  }
  box.replaceChildren(...parts);
}

/** How the files are read, by a key of mine.toml. @param {any} row of the JSON's choices */
function choiceRow(row) {
  const id = 'convention-' + row.key, list = element('select', { id, title: row.buffers }, ...row.values.map(value => element('option', { value, textContent: value })));
  list.value = row.value;
  list.addEventListener('change', () => stateConvention(row.key, list.value));
  const back = element('button', { type: 'button', className: 'link', textContent: 'by hand: put back', title: 'Read the files as they were found to be written' });
  back.addEventListener('click', () => stateConvention(row.key, ''));
  return element('div', { className: 'row' }, element('label', { htmlFor: id, textContent: row.key }), list, row.key in mine.stated ? back : element('span', { className: 'note', textContent: row.certainty }));
}
/** @param {string} key @param {string} value empty: as it is found */
function stateConvention(key, value) {
  if (value) mine.stated[key] = value;
  else delete mine.stated[key];
  compareMine();
}

function drawMineLists() {
  const { report } = mine;
  /** @param {string} id @param {string} sentence @param {string[]} texts */
  const list = (id, sentence, texts) => {
    one(`${id} summary span`).textContent = sentence;
    one(`${id} :is(ul, ol)`).replaceChildren(...texts.map(text => element('li', { textContent: text })));
    one(id).hidden = texts.length === 0;
  };
  list('#minecontracts', `${report.contracts.length} do not hold`, report.contracts.map(row => `${row.claim} ${row.formula}: broken in ${row.broken} of ${row.checked} (${row.buffer})`));
  const found = report.choices.filter(row => row.certainty).length, byHand = Object.keys(mine.stated).length;
  list('#mineconventions', byHand ? `${byHand} by hand` : found ? `${found} found, read as such` : 'as this program’s', report.conventions.filter(row => !row.key).map(row => `${row.buffer}: ${row.value} (${row.certainty})`));
  one('#mineconventions').hidden = report.choices.length + report.conventions.length === 0;
  fillKept(one('#minechoices'), report.choices.map(row => [JSON.stringify(row) + mine.stated[row.key], () => choiceRow(row)]));
  const rows = buffersOf(report), missing = report.not_handed_in;
  list('#minefiles', `${rows.length} read`, [...report.problems, ...(missing.length ? [`Not handed in: ${missing.join(', ')}`] : []), ...rows.map(row => `${row.file}: ${row.text}` + (row.tolerance_text ? ` (${row.tolerance_text})` : ''))]);
  list('#minehints', `${report.hints.length} of 3 given`, report.hints);
  one('#minetext').textContent = mine.lines.map(line => line.text).join('\n');
}

async function drawMinePictures() {
  const { shown, run } = mine, row = mine.report && buffersOf(mine.report).find(each => each.name === shown), panes = all('#mine .pane');
  one('#minenone').hidden = Boolean(row);
  for (const pane of panes) pane.hidden = !row;
  if (!row) return void (one('#minepixel').hidden = true);
  if (mine.isAsking) return void (mine.isLate = true);
  mine.isAsking = true;
  const kinds = [...mine.kinds], [x, y] = mine.pixel || [0, 0];
  const answers = await mine.side.ask(...kinds.map(kind => ['verdict_picture', shown, kind]), ...(mine.pixel ? [['verdict_pixel', x, y], ['want', 'color'], ['frame', 0], ['inspect', x, y, 0]] : [])).catch(() => null);
  mine.isAsking = false;
  if (answers && run === mine.run) {
    panes.forEach((pane, i) => drawPane(pane, kinds[i], answers[i], row));
    drawMinePixel(answers[2] ? JSON.parse(answers[2]) : null, answers[5] ? JSON.parse(answers[5]).equation || [] : []);
  }
  if (mine.isLate) mine.isLate = false, drawMinePictures();
}

/** @param {any} pane @param {number} kind @param {{rgba: any, width: number, height: number}} picture @param {any} row */
function drawPane(pane, kind, { rgba, width, height }, row) {
  const canvas = one('canvas', pane), cross = one('.cross', pane);
  canvas.width = width, canvas.height = height;
  canvas.getContext('2d').putImageData(new ImageData(rgba, width, height), 0, 0);
  canvas.setAttribute('aria-label', [`${row.name} of your renderer`, `${row.name} of the reference`, `Where ${row.name} differs, by how much`, `${row.name}: ${row.text}; ${row.wrong} wrong, ${row.missing} missing, ${row.extra} extra`][kind]);
  one('b', pane).textContent = row.name;
  all('.segments button', pane).forEach(button => button.setAttribute('aria-pressed', String(Number(button.value) === kind)));
  if (one('.legend', pane)) one('.legend', pane).hidden = kind !== 3;
  cross.hidden = !mine.pixel;
  if (mine.pixel) cross.style.left = `${(mine.pixel[0] + .5) / width * 100}%`, cross.style.top = `${(mine.pixel[1] + .5) / height * 100}%`;
}

/** @param {?any[]} rows @param {any[]} equation of the reference */
function drawMinePixel(rows, equation) {
  const box = one('#minepixel');
  box.hidden = !rows || !mine.pixel;
  if (box.hidden) return;
  const [x, y] = mine.pixel;
  one('h3', box).textContent = `Pixel ${x}, ${y}`;
  one('tbody', box).replaceChildren(...rows.map(row => element('tr', { className: row.bad ? 'bad' : '' }, element('th', { scope: 'row', textContent: row.buffer }),
    ...[row.mine, row.reference].map(text => element('td', { className: 'number', textContent: withMinus(text) })), element('td', { textContent: row.class }))));
  const lines = equation.filter(line => line.role !== 'note' && line.role !== 'row');
  one('.equation', box).hidden = lines.length === 0;
  fillEquation(one('.equation', box), lines);
}

const kMineKeys = {
  w: goToWorst,
  d: () => (mine.kinds[1] = mine.kinds[1] === 3 ? 2 : 3, drawMinePictures()),
  Escape: () => { if (mine.isBusy) cancelMine(); },
};
/** What was found stays: the worker that knew it is gone, so that another finds it again, without the names. */
function cancelMine() {
  ++mine.run;
  stopMine();
  mine.isBusy = false;
  if (mine.report) return void compareMine(false);
  mine.wasStopped = true;
  drawMine();
}

/** @param {KeyboardEvent} event */
function keyOfMine(event) {
  if (!mine.report) return event.key === 'Escape' ? kMineKeys.Escape : undefined;
  if (/^[1-6]$/.test(event.key)) return () => goToStage(mine.report.stages[Number(event.key) - 1]);
  const move = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
  if (move && mine.pixel && /** @type {Element} */ (event.target).matches('.pane canvas')) {
    const { width, height } = /** @type {HTMLCanvasElement} */ (event.target), far = event.shiftKey ? 10 : 1;
    return () => showMine(mine.shown, [Math.max(0, Math.min(width - 1, mine.pixel[0] + far * move[0])), Math.max(0, Math.min(height - 1, mine.pixel[1] + far * move[1]))]);
  }
  return kMineKeys[event.key] || kMineKeys[event.key.toLowerCase()];
}

function startMine() {
  const isHere = () => document.documentElement.dataset.place === 'mine';
  const choice = one('#minescene');
  choice.append(...whole.known.map(({ file, title }) => element('option', { value: file, textContent: title })));
  choice.addEventListener('change', () => {
    const own = mine.offered.find(scene => scene.name === choice.value);
    if (!own && !Object.hasOwn(whole.scenes, choice.value)) return;
    Object.assign(mine, { isChosen: true, scene: own || sceneOfPage(choice.value), report: null, pixel: null, shown: '' });
    compareMine();
  });
  one('#mineset').addEventListener('change', event => {
    mine.settings = event.target.value.split(';').map(text => text.trim()).filter(text => text);
    Object.assign(mine, { report: null, pixel: null });
    compareMine();
  });
  one('#hints').addEventListener('change', event => { mine.hints = Math.min(mine.most, Number(event.target.value)), event.target.value = String(mine.hints), compareMine(); });
  one('#minecancel').addEventListener('click', cancelMine);
  one('#mineworst button').addEventListener('click', goToWorst);
  one('#mineagain').addEventListener('click', () => guardedWait(async () => {
    if (!mine.folder) return void one('#mine .choosefolder').click();
    mine.files = await filesOfFolder(mine.folder);
    compareMine();
  }));
  one('#minejson').addEventListener('click', () => saveFile(mine.json + '\n', 'application/json', 'compare.json'));
  one('#minereport').addEventListener('click', () => guardedWait(async () => {
    const [page] = await mine.side.ask(['verdict_html', `shadescope compare ${mine.scene?.name} ${mine.name || 'files'}`]);
    saveFile(page, 'text/html', 'compare.html');
  }));
  one('#minecopy').addEventListener('click', () => navigator.clipboard?.writeText(one('#minetext').textContent + '\n').then(() => sayMine('Copied the finding as text.')));
  one('#starter').addEventListener('click', () => {
    const names = ['check_me.toml', one('#language').value], link = element('a', { download: 'mine.zip' });
    link.href = URL.createObjectURL(zipOf(Object.fromEntries(names.map(name => [`mine/${name}`, whole.starter[name]]))));
    link.click();
    URL.revokeObjectURL(link.href);
  });
  all('#mine .pane').forEach((pane, i) => {
    one('canvas', pane).addEventListener('click', event => {
      const box = event.target.getBoundingClientRect(), { width, height } = event.target;
      showMine(mine.shown, [Math.min(width - 1, Math.floor((event.clientX - box.left) / box.width * width)), Math.min(height - 1, Math.floor((event.clientY - box.top) / box.height * height))]);
    });
    for (const button of all('.segments button', pane)) button.addEventListener('click', () => { mine.kinds[i] = Number(button.value), drawMinePictures(); });
  });
  addEventListener('keydown', event => {
    if (!isHere() || event.ctrlKey || event.metaKey || event.altKey || /** @type {Element} */ (event.target).matches('select, input')) return;
    if (event.key === 'Shift' && mine.report && mine.kinds[0] === 0) return void (mine.kinds[0] = 1, drawMinePictures());
    const work = keyOfMine(event);
    if (work) event.preventDefault(), guarded(work);
  });
  addEventListener('keyup', event => { if (event.key === 'Shift' && isHere() && mine.kinds[0] === 1 && mine.report) mine.kinds[0] = 0, drawMinePictures(); });
  // On paper all is open.
  addEventListener('beforeprint', () => { if (isHere()) for (const part of all('#minebox details')) part.open = true; });
}

/** @param {() => Promise<any>} work */
const guardedWait = work => work().catch(error => {
  one('#wrong').textContent = error.message, one('#wrong').hidden = false;
  console.error(error);
});
