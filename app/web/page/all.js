// The whole program in one page: where the reader is, what is dropped, links that open a state again.

/** Scenes, lessons and the starter, as the writer has put them in. @type {any} */
let whole;

/** Shows a place of the page; the others are hidden. @param {string} place */
function go(place) {
  const root = document.documentElement;
  root.dataset.place = place;
  for (const part of all('.place')) part.hidden = part.dataset.in !== place;
  if (place !== 'scene') root.classList.add('inside'), view.inside = false;
  one('#copied').textContent = '';
  for (const link of all('#places a')) {
    if (link.hash.slice(1) === (place === 'scene' ? 'start' : place)) link.setAttribute('aria-current', 'page'), link.scrollIntoView({ block: 'nearest', inline: 'center' });
    else link.removeAttribute('aria-current');
  }
}

/** Opens a lesson, or a scene as a lesson of one page. @param {any} lesson @param {string} link its name in a link @param {Record<string, string[]>} of @returns {string[]} what of the link does not fit */
function openLesson(lesson, link, of) {
  data = { ...lesson, link };
  takeLesson(data);
  go('scene');
  const page = Math.max(1, parseInt(of.page?.[0] || '1', 10) || 1);
  openPage(Math.min(data.pages, page) - 1, of.then?.[0] === '1');
  if (of.inside?.[0] === '1' && !data.isScene) lookInside(true);
  document.documentElement.classList.toggle('inside', view.inside);
  return ['set', 'at', 'step', 'show', 'with'].some(key => of[key]) ? restore(of) : [];
}

/** A scene or model that the reader has brought. @param {Brought} file @param {Brought[]} list what it may name @param {Record<string, string[]>} [of] the rest of a link */
function openOwn(file, list, of = {}) {
  const name = lastName(file.path);
  for (const each of list) core.ask('file', lastName(each.path), each.bytes);
  core.ask('open', name, file.bytes);
  core.call('scene');
  const scene = core.text();
  openLesson({ title: name, name: '', can: [], next: null, texts: ['<p>Click a pixel to see why it has its colour.</p>'], files: { 'scene.toml': scene },
    lesson: 'title: Your scene\nlecture: Scene\nsummary: Your scene\nscene: scene\n\n# Your scene\nbuffers: color\n\nClick a pixel to see why it has its colour\\.\n' }, '', {});
  one('#title').textContent = name;
  const refused = of.toml ? restore(of) : [];
  if (refused.length) sayWrong(`Some of the link does not fit: ${refused.join('; ')}`);
}

/** Where the address leads. */
function route() {
  one('#wrong').hidden = true;
  const { place, name, of, refused } = readLink(location.hash);
  const lesson = place === 'scene' ? whole.known.find(scene => scene.name === name)?.page : place === 'lesson' && Object.hasOwn(whole.lessons, name) ? whole.lessons[name] : null;
  if (place === 'mine') refused.push(...openMine(of));
  else if (place === 'bug') refused.push(...openBug(of.seed?.[0]));
  else if (place === 'check') refused.push(...openCases(of.case?.[0]));
  else if (place === 'study') refused.push(...openStudy(name, of));
  else if (place === 'scene' && !name && of.toml) return void guardedWait(() => openFromLink(of));
  else if (lesson) refused.push(...openLesson(lesson, name, of));
  else {
    go('start');
    document.title = 'Shadescope';
    if (place !== 'start' || name) refused.push(`${place}=${name}: not in this page`);
  }
  if (refused.length) sayWrong(`Some of the link does not fit: ${refused.join('; ')}`);
}

/** @param {string} text */
function sayWrong(text) { one('#wrong').textContent = text, one('#wrong').hidden = false; }

/** My renderer with what a link says of it. @param {Record<string, string[]>} of @returns {string[]} what does not fit */
function openMine(of) {
  const refused = [], wanted = of.scene?.[0];
  if (wanted && !Object.hasOwn(whole.scenes, wanted)) refused.push(`scene=${wanted}: not in this page`);
  else if (wanted && mine.scene?.name !== wanted) Object.assign(mine, { scene: sceneOfPage(wanted), isChosen: true, report: null });
  if (of.set) mine.settings = of.set;
  for (const text of of.convention || []) {
    const [, key, value] = /^([a-z-]+)=([\w.-]+)$/.exec(text) || [];
    if (key) mine.stated[key] = value;
    else refused.push(`convention=${text}: no convention`);
  }
  if (of.hints) mine.most = mine.hints = Math.max(0, Math.min(3, parseInt(of.hints[0], 10) || 0));
  if (of.show) mine.shown = of.show[0];
  const at = (of.at?.[0] || '').split(',').map(Number);
  if (at.length === 2 && at.every(each => Number.isInteger(each) && each >= 0)) mine.pixel = at;
  go('mine'), document.title = 'My renderer – Shadescope';
  if (!mine.isBusy && mine.files.length && !mine.report) compareMine();
  else drawMine();
  return refused;
}

/** What a drop or a choice means: a renderer's buffers, a scene, a model. @param {Drop} drop */
function takeDrop(drop) {
  one('#wrong').hidden = true;
  const { list } = drop, [scene] = scenesAmong(list), model = list.find(file => kModels.test(file.path)), numbers = list.filter(file => kNumbers.test(file.path));
  const own = scene ? list.find(file => lastName(file.path) === scene.name) : model, isMine = document.documentElement.dataset.place === 'mine';
  const areTextures = model && !scene && numbers.every(file => /\.png$/i.test(file.path));
  if (numbers.length && !areTextures) {
    if (!isMine) history.pushState(null, '', '#mine');
    go('mine');
    return takeMine(drop);
  }
  if (!own) throw new Error('Nothing here is a scene, a model or a buffer: toml, scene; obj, ply, stl, off, gltf, glb; npy, png, tga, bmp, ppm, pgm, pfm, csv.');
  if (isMine) {
    Object.assign(mine, { scene: { name: lastName(own.path), list: list.map(file => ({ name: lastName(file.path), bytes: file.bytes })) }, isChosen: true, report: null });
    return void compareMine();
  }
  openOwn(own, list);
  history.pushState(null, '', '#');
}

function startDrops() {
  const root = document.documentElement;
  addEventListener('dragover', event => { event.preventDefault(), root.classList.add('dropping'); });
  addEventListener('dragleave', event => { if (!event.relatedTarget) root.classList.remove('dropping'); });
  addEventListener('drop', event => {
    event.preventDefault(), root.classList.remove('dropping');
    const transfer = event.dataTransfer;
    if (transfer) guardedWait(async () => takeDrop(await filesOfDrop(transfer)));
  });
  for (const button of all('.choosefolder')) button.addEventListener('click', () => guardedWait(async () => {
    const pick = /** @type {any} */ (globalThis).showDirectoryPicker;
    if (!pick) return void one('#folderfield').click();
    const folder = await pick({ id: 'mine', mode: 'read' }).catch(error => { if (error.name !== 'AbortError') throw error; });
    if (folder) takeDrop({ name: folder.name, folder, list: await filesOfFolder(folder) });
  }));
  for (const button of all('.choosefiles')) button.addEventListener('click', () => one('#filesfield').click());
  for (const input of [one('#folderfield'), one('#filesfield')])
    input.addEventListener('change', () => guardedWait(async () => takeDrop(await filesOfInput(input))));
}

function fillStart() {
  one('#scenes').replaceChildren(...whole.known.map(({ name, title, look, picture }) => element('li', {}, element('a', { href: `#scene=${name}` },
    element('img', { alt: '', width: 160, height: 120, loading: 'lazy', src: picture }), element('b', { textContent: title }), element('span', { className: 'note', textContent: look })))));
  one('#lessons').replaceChildren(...Object.entries(whole.lessons).map(([name, { title, summary }]) => element('li', {},
    element('a', { href: `#lesson=${name}`, textContent: title }), element('span', { className: 'note', textContent: summary }))));
  // Of a site: what is beside this page.
  for (const { heading, entries } of whole.beside)
    one('#beside').append(element('h2', { textContent: heading }), element('ul', { className: 'listed' }, ...entries.map(({ file, title, note }) => element('li', {}, element('a', { href: file, textContent: title }), element('span', { className: 'note', textContent: note })))));
}

/** The link, whose scene of the reader's own is packed first, as far as it is short. */
async function copyLink() {
  const own = data && data.link === '' && document.documentElement.dataset.place === 'scene', toml = own ? await packedText(data.files['scene.toml']) : '';
  const { hash, leftOut } = linkNow(toml);
  history.replaceState(null, '', hash);
  const said = leftOut ? `The link is copied, without ${leftOut} of its values: it would be too long.` : own && !toml ? 'The link has no scene of your own, which is too long: save the scene and send it along.' : 'The link is copied.';
  const tell = () => { one('#copied').textContent = said, say(said); };
  if (navigator.clipboard) navigator.clipboard.writeText(location.href).then(tell, () => { one('#copied').textContent = 'The link is in the address.'; });
  else one('#copied').textContent = 'The link is in the address.';
}

/** A scene whose text stands in the link. @param {Record<string, string[]>} of */
async function openFromLink(of) {
  const text = await unpackedText(of.toml[0]);
  openOwn({ path: 'scene.toml', bytes: encoder.encode(text), stamp: '' }, [], of);
}

async function start() {
  const root = document.documentElement;
  root.classList.add('live');
  if (new URLSearchParams(location.search).has('projector')) root.classList.add('projector');
  checkBrowser();
  whole = JSON.parse(decoder.decode(await unpacked(one('#packed').textContent)));
  // The core reads the table of mistakes once, for the first lesson: each has the rows of all.
  const tables = Object.values(whole.lessons).map(lesson => lesson.files['misconceptions.md'].split('\n')), rows = new Set(tables.flatMap(table => table.slice(2)));
  for (const lesson of Object.values(whole.lessons)) lesson.files['misconceptions.md'] = [...tables[0].slice(0, 2), ...[...rows].filter(row => row), ''].join('\n');
  fillStart();
  if (/^#?(start)?$/.test(location.hash)) go('start');
  core = await Core.start(await unpackedCore());
  startParts(), startMine(), startDrops(), startGame(), startStudy();
  one('#copylink').addEventListener('click', () => guardedWait(copyLink));
  addEventListener('hashchange', () => guarded(route));
  route();
  root.dataset.ready = '1';
}
start().catch(sayCannotStart);
