// The stage: one large picture, what stands over it, and the grips that a hand moves. Places and values are the core's.

const isStill = () => matchMedia('(prefers-reduced-motion: reduce)').matches;
const clamp = (value, low, high) => Math.max(low, Math.min(high, value));

/** What can be held, with places and words. @type {{holds: any[], shows: string, played: boolean, files: any[]}} */
let held = { holds: [], shows: '', played: false, files: [] };
/** The views of the half, each with its canvases. @type {any[]} */
let cells = [];
/** Buttons that are dragged: a hold of the core, the line between two pictures, the picked pixel. @type {any[]} */
let grips = [];
/** The drag that is going on. @type {any} */
let drag = null;
/** Values before each drag, and each run of keys. @type {string[]} */
let undo = [];
let playDone = false;

const isClick = () => page.question?.kind === 'click' && !page.question.settled;
/** Whether a click moves the picked pixel: the text before a question speaks of the one that is there. */
const mayPick = () => isClick() || !page.question || page.question.settled;
const comparison = () => page.buffers.find(shown => shown.against)?.against || '';

/** The part where something is drawn, with a margin; all where that is most of it, or where something may move. */
function stagePart(shown) {
  const [width, height] = pictureSize();
  if (shown.zoom) {
    const [factor, x, y] = shown.zoom, w = Math.min(width, 640 / factor), h = Math.min(height, 480 / factor);
    return [clamp(x - w / 2, 0, width - w), clamp(y - h / 2, 0, height - h), w, h].map(Math.round);
  }
  if (held.holds.some(hold => hold.kind !== 'number')) return [0, 0, width, height];
  const [x, y, w, h] = boxDrawn(16);
  return w * h > 0.7 * width * height ? [0, 0, width, height] : [x, y, w, h];
}

/** The polygon of each pixel, -1 for none; empty before the z-buffer, which a page about transform or cull does not reach. */
function idsDrawn() {
  try {
    return core.numbers(core.ask('buffer', 'polygon_id', 0));
  } catch {
    return [];
  }
}

/** What is drawn, with the picked pixel and a margin: x, y, width, height. @param {number} margin */
function boxDrawn(margin) {
  const [width, height] = pictureSize(), ids = idsDrawn();
  let left = width, right = -1, top = height, bottom = -1;
  for (let y = 0, i = 0; y < height; ++y)
    for (let x = 0; x < width; ++x, ++i)
      if (ids[i] >= 0) left = Math.min(left, x), right = Math.max(right, x), top = Math.min(top, y), bottom = Math.max(bottom, y);
  if (right < left) return [0, 0, width, height];
  if (view.pixel) left = Math.min(left, view.pixel[0]), right = Math.max(right, view.pixel[0]), top = Math.min(top, view.pixel[1]), bottom = Math.max(bottom, view.pixel[1]);
  left = Math.max(0, left - margin), top = Math.max(0, top - margin);
  return [left, top, Math.min(width, right + margin + 1) - left, Math.min(height, bottom + margin + 1) - top];
}

/** The cells of the half that is open, and its grips. The 3D view stands among the cells, or among the instruments. */
function buildStage() {
  const svg = () => document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  drag = null, undo = [], playDone = page.then;
  one('#withlines')?.remove();
  cells = page.buffers.slice(0, 4).map(shown => {
    const canvases = [element('canvas'), element('canvas')], over = svg(), field = element('div', { className: 'field' }, ...canvases, over);
    canvases.forEach((canvas, i) => { canvas.setAttribute('role', 'img'); if (i) canvas.hidden = true; });
    over.setAttribute('aria-hidden', 'true');
    const caption = element('figcaption'), box = element('figure', { className: 'cell' }, field, caption);
    return { shown, canvases, over, field, caption, box, part: stagePart(shown), wipe: shown.wipe ?? 0.5, fit: { k: 1, x: 0, y: 0 }, corner: [0, 0], size: [0, 0] };
  });
  const space = one('.space'), inStage = page.space !== '' && !view.inside && !hides('inspector');
  one('#cells').replaceChildren(...cells.map(cell => cell.box), ...(inStage ? [space] : []));
  if (!inStage) one('.middle').append(space);
  one('#cells').dataset.count = String(one('#cells').children.length);
  one('#stage').classList.toggle('axis', page.held.figure === 'codes');
  one('#play').textContent = '';
  drawFigure.kind = '';
  buildGrips();
}

function buildGrips() {
  for (const grip of grips) grip.button.remove(), grip.bubble.remove();
  grips = held.holds.map((hold, number) => makeGrip(hold.kind, hold.name, number));
  for (const cell of cells) if (cell.shown.against && cell.shown.mode === 'wipe') grips.push(makeGrip('line', 'Line between the two pictures', -1, cell));
  if ((isClick() || page.held.spot) && cells.length) grips.push(makeGrip(page.held.spot ? 'pixel spot' : 'pixel', page.held.spot?.name || 'Place', -1, cells[0]));
  one('#room').classList.toggle('holding', grips.length > 0);
}

/** @param {string} kind @param {string} name @param {number} number @param {any} [cell] */
function makeGrip(kind, name, number, cell = cells[0]) {
  const button = element('button', { type: 'button', className: `grip ${kind} fresh`, ariaLabel: name }), bubble = element('span', { className: 'bubble', ariaHidden: 'true' });
  button.setAttribute('role', 'slider');
  const grip = { kind: kind.split(' ')[0], name, number, cell, button, bubble, onAxis: false, words: '' };
  button.addEventListener('pointerdown', event => guarded(() => grab(grip, event)));
  button.addEventListener('keydown', event => guarded(() => gripKey(grip, event)));
  return grip;
}

// ---- Places: of the picture, of a track, of the page.

/** CSS pixels. Read once a step, before anything is drawn: what is read between two changes is laid out anew. */
let roomSize = { width: 0, height: 0, figure: 0 };
function measureRoom() {
  const room = one('#room').getBoundingClientRect();
  roomSize = { width: room.width, height: room.height, figure: one('#figure').clientWidth };
  for (const cell of cells) {
    const field = cell.field.getBoundingClientRect();
    cell.corner = [field.left - room.left, field.top - room.top], cell.size = [cell.field.clientWidth, cell.field.clientHeight];
  }
}
const onField = (cell, [x, y]) => [cell.fit.x + x * cell.fit.k, cell.fit.y + y * cell.fit.k];
const onRoom = (cell, place) => onField(cell, place).map((value, i) => value + cell.corner[i]);
/** A pointer in pixels of the cell's picture. */
function inPicture(cell, event) {
  const box = cell.field.getBoundingClientRect();
  return [(event.clientX - box.left - cell.fit.x) / cell.fit.k, (event.clientY - box.top - cell.fit.y) / cell.fit.k];
}
/** The track of a number: its ends, from low to high. */
function trackOf(grip) {
  if (grip.onAxis) return figure.track;
  const tracks = grips.filter(other => other.kind === 'number' && !other.onAxis), x = 40 + 84 * tracks.indexOf(grip), low = roomSize.height - 44;
  return [[x, low], [x, Math.max(low - 260, 96)]];
}
function placeOfGrip(grip) {
  const { width, height } = roomSize;
  if (grip.kind === 'line') return [onRoom(grip.cell, [grip.cell.wipe * pictureSize()[0], 0])[0], Math.max(34, onRoom(grip.cell, [0, grip.cell.part[1]])[1] + 34)];
  if (grip.kind === 'pixel') {
    const { spot } = page.held, at = view.pixel || (spot && [pictureSize()[0] >> 3, spot.row]);
    return at ? onRoom(grip.cell, at.map(v => v + 0.5)) : [width / 2, height / 2];
  }
  const hold = held.holds[grip.number];
  if (grip.kind === 'eye') return [width - 46, height - 44];
  if (grip.kind === 'number') {
    const [[x0, y0], [x1, y1]] = trackOf(grip), share = hold.place[0];
    return [x0 + share * (x1 - x0), y0 + share * (y1 - y0)];
  }
  if (!hold.place) return null;
  const [x, y] = onRoom(grip.cell, hold.place);
  return [clamp(x, 22, width - 22), clamp(y, 22, height - 22)];
}
/** Where a pointer is for the core: pixels of the picture, or the share of a track. */
function forCore(grip, event) {
  if (grip.kind !== 'number') return inPicture(grip.cell, event);
  const box = one(grip.onAxis ? '#figure' : '#room').getBoundingClientRect(), [[x0, y0], [x1, y1]] = trackOf(grip), [dx, dy] = [x1 - x0, y1 - y0];
  const share = ((event.clientX - box.left - x0) * dx + (event.clientY - box.top - y0) * dy) / (dx * dx + dy * dy);
  return [share, share];
}

// ---- Dragging.

function grab(grip, event) {
  event.preventDefault(), event.stopPropagation();
  const at = forCore(grip, event), values = grip.number >= 0 ? held.holds[grip.number].values : String(grip.kind === 'line' ? grip.cell.wipe : view.pixel || '');
  drag = { grip, id: event.pointerId, from: at, last: at, to: at, values, moved: false };
  grip.button.focus({ preventScroll: true });
  grip.button.classList.remove('fresh'), grip.button.classList.add('on');
  document.documentElement.classList.add('dragging');
}

/** Shift moves by a tenth of what the pointer does, Ctrl in coarse steps. */
function dragged(event) {
  if (!drag || event.pointerId !== drag.id) return;
  const at = forCore(drag.grip, event), fine = event.shiftKey ? 0.1 : 1;
  drag.to = drag.to.map((value, i) => value + fine * (at[i] - drag.last[i])), drag.last = at;
  const { grip } = drag, coarse = event.ctrlKey || event.metaKey ? 1 : 0;
  if (!drag.moved && grip.number >= 0) undo.push(drag.values);
  drag.moved = true;
  const mine = drag;
  mine.due = () => {
    mine.due = null;
    if (grip.kind === 'line') return setLine(grip, mine.to[0] / pictureSize()[0]);
    if (grip.kind === 'pixel') return pickOnStage(mine.to.map(Math.floor));
    putHand(core.ask('hold', grip.number, ...mine.from, ...mine.to, coarse, mine.values));
  };
  soon('drag', () => mine.due?.());
}

function letGo() {
  if (!drag) return;
  guarded(() => drag.due?.());  // the last move may still wait for the next picture of the screen
  const { grip, moved } = drag;
  drag = null;
  grip.button.classList.remove('on'), document.documentElement.classList.remove('dragging');
  if (moved) say(`${grip.name}: ${grip.words}`);
  if (moved && grip.kind === 'pixel') picked();
}

function gripKey(grip, event) {
  const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
  if (event.altKey || event.ctrlKey || event.metaKey || (!way && event.key !== 'Home')) return;
  event.preventDefault(), event.stopPropagation();
  grip.button.classList.remove('fresh');
  if (grip.kind === 'line') return setLine(grip, way ? grip.cell.wipe + (event.shiftKey ? 0.1 : 0.01) * (way[0] - way[1]) : grip.cell.shown.wipe);
  if (grip.kind === 'pixel') {
    const step = event.shiftKey ? 10 : 1, [x, y] = view.pixel || pictureSize().map(size => size >> 1);
    if (way) pickOnStage([x + step * way[0], y + step * way[1]]), picked();
    return;
  }
  const hold = held.holds[grip.number], isRun = gripKey.last === grip && performance.now() - gripKey.at < 1000;
  gripKey.last = grip, gripKey.at = performance.now();
  if (!isRun || !way) undo.push(hold.values);
  const values = way ? core.ask('nudge', grip.number, ...way, event.shiftKey ? 1 : 0) : hold.own;
  soon('key', () => { putHand(values), say(grip.words); });
}
/** @type {any} */ gripKey.last = null;
gripKey.at = 0;

function setLine(grip, share) {
  grip.cell.wipe = clamp(share, 0.02, 0.98);
  drawStage();
}

/** Puts values into the settings; the grips follow at once, the picture when its frame is there. @param {string} values */
function putHand(values) {
  try {
    core.ask('set', values);
  } catch (error) {
    return void say(error.message);
  }
  running?.since.push(values);
  for (const assignment of values.split('; ')) {
    const [key] = splitAssignment(assignment);
    if (!(key in view.own)) view.own[key] = settingOf(key)?.text ?? '';
  }
  readValues();
  if (isLong) held = core.ask('holds'), placeGrips();
  return runFrame(view.inside ? draw : drawHeld);
}

/** What a step moves: the pictures, what stands over them, words, figure, play, a gauge. */
function drawHeld() {
  held = core.ask('holds');
  if (page.space !== '') drawPixel();
  drawStage();
  if (page.question?.gauge && !page.question.settled) page = core.ask('read'), drawQuestion();
  drawSettings();
  if (page.space !== '' && !hides('inspector')) drawSpace();
}

function pickOnStage(at) {
  if (page.held.spot) at[1] = page.held.spot.row;
  view.pixel = at.map((value, i) => clamp(value, 0, pictureSize()[i] - 1));
  drawPixel(), drawStage();
}

function startStage() {
  addEventListener('pointermove', dragged);
  addEventListener('pointerup', letGo), addEventListener('pointercancel', letGo);
  addEventListener('keydown', event => guarded(() => {
    if (event.key === 'Escape' && drag) {
      const { grip, values, moved } = drag;
      drag.due = null, letGo();
      if (moved && grip.number >= 0) undo.pop(), putHand(values);
      else if (grip.kind === 'line') setLine(grip, Number(values));
    } else if ((event.ctrlKey || event.metaKey) && event.key === 'z' && undo.length && !(/** @type {Element} */ (event.target).matches('input[type=text]'))) {
      event.preventDefault();
      putHand(undo.pop());
    }
  }));
  one('#room').addEventListener('pointerdown', event => guarded(() => {
    const cell = cells.find(each => each.field.contains(event.target)), [width, height] = pictureSize();
    if (!cell || !cell.ofPixels || event.button) return;
    const [x, y] = inPicture(cell, event).map(Math.floor), isIn = x >= 0 && y >= 0 && x < width && y < height;
    if (isClick() && isIn) {
      pickOnStage([x, y]);
      const grip = grips.find(each => each.kind === 'pixel');
      return grip ? grab(grip, event) : picked();
    }
    const id = isIn ? core.numbers(core.ask('buffer', 'object_id', 0))[y * width + x] : -1;
    const grip = grips.find(each => each.number >= 0 && held.holds[each.number].object === id && id >= 0) || grips.find(each => each.kind === 'eye');
    if (grip) return grab(grip, event);
    if (isIn && mayPick()) pickOnStage([x, y]), say(pixelWords());
  }));
  one('#room').addEventListener('pointerup', () => { if (isClick()) guarded(picked); });
  new ResizeObserver(() => page && soon('fit', () => { drawStage(); if (page.space !== '') drawSpace(); })).observe(one('#room'));
}

// ---- Drawing.

function drawStage() {
  if (view.inside) return;
  measureRoom();
  cells.forEach(drawCell);
  drawFigure();
  placeGrips();
  drawFiles();
  judgePlay();
}

/** The files that the scene would be. The line of the vertex in the hand is lit; after the answer its number is marked. */
function drawFiles() {
  const box = one('#files'), { files } = held, vertex = held.holds.find(hold => hold.kind === 'vertex')?.vertex, known = JSON.stringify([files.map(({ title, lines }) => [title, lines.length]), page.then]);
  box.hidden = files.length === 0, one('#stage').classList.toggle('filed', !box.hidden);
  const mark = text => !page.then || !/^\d+,\(/.test(text) ? [text] : text.split(/(\d+)/).map((part, i) => (i > 1 && i % 2 && part === String(vertex) ? element('u', { textContent: part }) : part));
  if (drawFiles.known === known) {
    const rows = all('tr', box);
    return void files.flatMap(file => file.lines).forEach((line, i) => { if (rows[i].children[1].textContent !== line.text) rows[i].children[1].replaceChildren(...mark(line.text)); });
  }
  drawFiles.known = known;
  box.replaceChildren(...files.map(({ title, lines }, i) => {
    const isLast = i === files.length - 1, rows = lines.map(line => element('tr', { className: line.vertex === vertex ? 'lit' : '' }, element('td', { textContent: line.number || '' }), element('td', {}, ...mark(line.text)), element('td', { textContent: line.meaning })));
    return element('details', { open: isLast || (innerWidth > 760 && innerHeight > 740) }, element('summary', { textContent: title }), element('table', {}, element('tbody', {}, ...rows)));
  }));
  const lit = box.querySelector('.lit');
  if (lit) box.scrollTop += lit.getBoundingClientRect().top - box.getBoundingClientRect().top - box.clientHeight / 2;
}
drawFiles.known = '';

function fitCell(cell) {
  const [x, y, w, h] = cell.part, [width, height] = cell.size;
  // Where the room is small the play keeps a place of its own.
  const top = cell === cells[0] && page.held.play && width < 800 ? (width < 500 ? 44 : 60) : 0;
  const k = Math.max(0.01, Math.min(width / w, (height - top) / h));
  cell.fit = { k, x: width / 2 - (x + w / 2) * k, y: top + (height - top) / 2 - (y + h / 2) * k };
}

/** Which of the two pictures, or their difference, a cell shows. */
const shownOf = ({ against, mode }) => (against === '' ? [0] : mode === 'wipe' ? [0, 1] : mode === 'b' ? [1] : mode === 'difference' ? [2] : [0]);

function drawCell(cell) {
  const { shown, canvases } = cell, domain = buffers.find(buffer => buffer.name === shown.buffer)?.domain;
  const isListed = domain === 'vertex' || domain === 'polygon', sides = shownOf(shown);
  cell.field.classList.toggle('listed', isListed);
  canvases[0].hidden = isListed, canvases[1].hidden = isListed || sides.length < 2;
  cell.ofPixels = false;
  if (isListed) {
    putOver(cell, '');
    fillKept(cell.field, [['canvas', () => canvases[0]], ['canvas', () => canvases[1]], ['over', () => cell.over], ['rows', () => element('div', { className: 'rows', tabIndex: 0 }, element('table', {}, element('tbody')))]]);
    fillRows(cell.field, shown.buffer, sides[0]);
    cell.caption.textContent = shown.buffer, cell.caption.hidden = false;
    return;
  }
  let picture = null;
  try {
    sides.forEach((which, i) => {
      const name = which === 2 ? `${shown.buffer} ${shown.metric === 'E' ? 'AE' : shown.metric}` : shown.buffer;
      picture = core.ask('picture', name, which, shown.channel > 2 ? -1 : shown.channel, shown.range && which !== 2 ? 1 : 0, ...(shown.range || [0, 0]), ...cell.part);
      const [x, y, w, h] = picture.part, canvas = canvases[i];
      if (i === 0) {
        cell.ofPixels = picture.width === pictureSize()[0] && picture.height === pictureSize()[1];
        if (!cell.ofPixels) cell.part = picture.part;
        fitCell(cell);
      }
      if (canvas.width !== w || canvas.height !== h) canvas.width = w, canvas.height = h;
      canvas.getContext('2d').putImageData(new ImageData(new Uint8ClampedArray(core.memory, picture.pixels, 4 * w * h), w, h), 0, 0);
      const { k } = cell.fit;
      canvas.style.transform = `translate(${cell.fit.x + x * k}px, ${cell.fit.y + y * k}px) scale(${k})`;
      canvas.style.imageRendering = page.held.hard || shown.buffer !== 'color' || k >= 4 ? 'pixelated' : 'auto';
      canvas.setAttribute('aria-label', `${shown.buffer}${which === 1 ? ` with ${shown.against}` : ''}, ${picture.width} by ${picture.height}. ${picture.meaning}`);
    });
  } catch (error) {
    // A page that stops before there is a picture shows where the polygons are.
    cell.caption.known = '', canvases[0].hidden = true;
    if (shown.overlays.includes('edges')) try {
      fitCell(cell);
      cell.caption.hidden = true;
      return putOver(cell, shapesOver(cell, []));
    } catch {}
    putOver(cell, '');
    cell.caption.textContent = error.errors ? error.errors[0].found : error.message, cell.caption.hidden = false;
    return;
  }
  if (sides.length > 1) {
    const [x, , w] = cell.part, from = (cell.wipe * pictureSize()[0] - x) / w;
    canvases[1].style.clipPath = `inset(0 0 0 ${clamp(100 * from, 0, 100)}%)`;
  }
  drawCaption(cell, picture, sides);
  putOver(cell, cell.ofPixels ? shapesOver(cell, sides) : '');
}

/** Below each of several pictures, and where colours stand for numbers: what it is. */
function drawCaption(cell, picture, sides) {
  const { shown, caption } = cell, words = [];
  if (cells.length > 1 || shown.buffer !== 'color') words.push(shown.buffer);
  if (sides[0] === 1) words.push(shown.against.replace('=', ' = '));
  if (sides[0] === 2) words.push(`difference from ${shown.against.replace('=', ' = ')}: ${picture.differing} pixels differ, the largest by ${shortNumber(picture.largest, 4)}`);
  const key = JSON.stringify([words, picture.scale && [picture.first, picture.last]]);
  if (caption.known === key) return;
  caption.known = key;
  caption.hidden = words.length === 0;
  caption.replaceChildren(element('b', { textContent: words.join(' · ') }));
  if (!picture.scale) return;
  const bar = element('i', { className: 'palette' });
  bar.style.background = `linear-gradient(90deg, ${picture.stops.map(stop => `rgb(${stop})`).join()})`;
  caption.append(' ', element('span', { className: 'number', textContent: shortNumber(picture.first, 4) }), bar, element('span', { className: 'number', textContent: shortNumber(picture.last, 4) }), ` ${picture.unit}`);
}

const svgLine = (a, b, color, width = 3, dash = '') => `<line x1="${a[0]}" y1="${a[1]}" x2="${b[0]}" y2="${b[1]}" stroke="#000A" stroke-width="${width + 3}" stroke-linecap="round"/><line x1="${a[0]}" y1="${a[1]}" x2="${b[0]}" y2="${b[1]}" stroke="${color}" stroke-width="${width}" stroke-dasharray="${dash}" stroke-linecap="round"/>`;
const svgWords = (at, text, attributes = '') => `<text x="${at[0]}" y="${at[1]}" ${attributes}>${text.replace(/[<&]/g, '')}</text>`;
const pointsOf = list => list.map(point => point.map(value => value.toFixed(1)).join()).join(' ');

/** What stands over a cell's picture, where it is not there already. */
const putOver = (cell, shapes) => { if (cell.shapes !== shapes) cell.over.innerHTML = cell.shapes = shapes; };

function shapesOver(cell, sides) {
  const at = place => onField(cell, place), first = cell === cells[0], lamp = first && held.holds.find(hold => hold.around);
  let out = '';
  if (cell.shown.overlays.includes('edges')) out += edgesOver(at);
  const [kind, number] = page.selected.split(' ');
  if (kind === 'polygon') out += `<polygon class="selected" points="${pointsOf(cornersOf(Number(number)).map(at))}"/>`;
  if (kind === 'vertex') out += (([x, y]) => `<circle class="selected" r="8" cx="${x}" cy="${y}"/>`)(at(vertexAt(Number(number))));
  if (lamp?.kind === 'vertex') out += (([x, y]) => `<circle class="before" r="6" cx="${x}" cy="${y}"/>`)(at(lamp.around));
  if (lamp?.place) out += `<line class="lead" x1="${at(lamp.place)[0]}" y1="${at(lamp.place)[1]}" x2="${at(lamp.around)[0]}" y2="${at(lamp.around)[1]}"/>`;
  if (view.pixel) {
    const o = at(view.pixel.map(v => v + 0.5)), hides = name => page.hidden.buffers.some(hidden => hidden.startsWith(name)), isShown = !hides('normal') && !hides('light_vector'), vectors = lamp?.kind === 'lamp' && isShown ? core.ask('vectors', ...view.pixel) : null;
    if (vectors) {
      const from = at(vectors.at), n = at(vectors.N), l = at(vectors.L), away = v => { const d = Math.hypot(v[0] - from[0], v[1] - from[1]) || 1; return [v[0] + 16 * (v[0] - from[0]) / d, v[1] + 6 + 16 * (v[1] - from[1]) / d]; };
      out += `<polygon class="horizon" points="${pointsOf(vectors.horizon.map(at))}"/>` + svgLine(from, n, 'var(--on-N)') + svgLine(from, l, 'var(--sun)', 3, vectors.n_dot_l > 0 ? '' : '2 7');
      out += `<polyline class="arc" points="${pointsOf(vectors.arc.map(at))}"/>` + svgWords(away(n), 'N', 'class="symbol N"') + svgWords(away(l), 'L', 'class="symbol L"');
      if (vectors.H && !hides('halfway_vector')) {
        // Its letter stands aside: H may lie on N.
        const h = at(vectors.H), d = Math.hypot(h[0] - from[0], h[1] - from[1]) || 1;
        out += svgLine(from, h, 'var(--on-H)') + svgWords([h[0] + 18 * (h[1] - from[1]) / d, h[1] + 6 - 18 * (h[0] - from[0]) / d], 'H', 'class="symbol H"');
      }
    }
    let fill = 'none';
    if (cell.shown.buffer === 'color' && sides[0] === 0) {
      const numbers = core.numbers(core.ask('buffer', 'color', 0)), i = 3 * (view.pixel[1] * pictureSize()[0] + view.pixel[0]);
      fill = `rgb(${[...numbers.slice(i, i + 3)].map(Number)})`;
    }
    const r = clamp(cell.fit.k * 0.75, 10, 40);
    out += `<circle cx="${o[0]}" cy="${o[1]}" r="${r}" fill="${r > 10 ? 'none' : fill}" stroke="#000" stroke-width="5"/><circle class="ring" cx="${o[0]}" cy="${o[1]}" r="${r}" fill="none" stroke="#fff" stroke-width="2.5"/>`;
  }
  for (const [number, pixel] of Object.entries(page.pins)) {
    const p = at(pixel.map(v => v + 0.5));
    out += `<circle cx="${p[0]}" cy="${p[1]}" r="5" fill="none" stroke="#fff" stroke-width="2"/>` + svgWords([p[0] + 9, p[1] - 7], number);
  }
  if (sides.length > 1) {
    const x = at([cell.wipe * pictureSize()[0], 0])[0], [a, b] = sideNames(cell.shown.against), top = Math.max(40, at([0, cell.part[1]])[1] + 40);
    out += svgLine([x, 0], [x, cell.size[1]], '#fff', 2) + svgWords([x - 32, top], a, 'text-anchor="end"') + (cell.wipe < 0.95 ? svgWords([x + 32, top], b) : '');
  }
  return out;
}

/** What stands at both sides of the line: "phong" and "gouraud", "n = 0.05" and "n = 0.02". */
function sideNames(against) {
  const [key, value] = splitAssignment(against.split('; ')[0]), setting = settingOf(key);
  if (!setting) return ['', value];
  return setting.kind === 'choice' ? [setting.text, value] : [`${setting.label} ${withMinus(setting.text)}`, withMinus(value)];
}

const vertexAt = i => [...core.numbers(core.ask('buffer', 'vertices.screen', 0)).slice(3 * i, 3 * i + 2)];
const cornersOf = polygon => (mesh ??= core.ask('mesh')).polygons[polygon].map(vertexAt);
function edgesOver(at) {
  mesh ??= core.ask('mesh');
  const screen = core.numbers(core.ask('buffer', 'vertices.screen', 0)), isThere = v => screen[3 * v] > -1e29;
  const path = mesh.polygons.filter(corners => corners.every(isThere)).map(corners => `M${corners.map(v => at([screen[3 * v], screen[3 * v + 1]]).map(value => value.toFixed(1)).join()).join('L')}Z`).join('');
  return `<path class="edges" d="${path}"/>`;
}

function placeGrips() {
  const codes = page.held.figure === 'codes';
  for (const grip of grips) {
    const hold = held.holds[grip.number];
    grip.onAxis = codes && hold?.keys[0] === 'camera.near';
    const into = one(grip.onAxis ? '#figure' : '#grips');
    if (grip.button.parentNode !== into) into.append(grip.button, grip.bubble);
    const p = grip.place = placeOfGrip(grip);
    grip.button.hidden = grip.bubble.hidden = !p;
    if (!p) continue;
    grip.button.style.left = p[0] + 'px', grip.button.style.top = p[1] + 'px';
    grip.button.classList.toggle('behind', !!hold?.behind), grip.button.classList.toggle('axis', grip.onAxis);
    const ownWords = grip.kind === 'line' ? sideNames(grip.cell.shown.against).join(', ') : grip.kind === 'pixel' ? (view.pixel || []).join(', ') : hold.words;
    grip.words = grip.number === 0 && !grip.onAxis && held.shows ? held.shows : ownWords;
    grip.button.setAttribute('aria-valuetext', grip.words);
    grip.button.setAttribute('aria-valuenow', String(hold ? hold.number : Math.round(100 * grip.cell.wipe)));
    if (grip.kind === 'number') grip.button.setAttribute('aria-valuemin', hold.low), grip.button.setAttribute('aria-valuemax', hold.high);
    setText(grip.bubble, grip.kind === 'line' || (grip.kind === 'pixel' && !drag) ? '' : grip.words);
    grip.bubble.hidden = grip.bubble.textContent === '';
    placeBubble(grip);
  }
  const shows = held.shows !== '' && grips[0]?.onAxis ? held.shows : '';
  one('#shows').hidden = shows === '', setText(one('#shows'), shows);
}

/** Words never lie under the finger, nor on the play. 100% is their own width: so it need not be read. */
function placeBubble(grip) {
  const [x, y] = grip.place, beside = ((grip.kind === 'number' || grip.kind === 'turn') && !grip.onAxis) || (!grip.onAxis && y < 76), room = `${roomSize.width - x}px - 100%`;
  Object.assign(grip.bubble.style, { left: x + 'px', top: y - (beside ? 14 : grip.onAxis ? 62 : 54) + 'px' });
  // To the right of the grip, or to its left where there is no room; else over its middle, as far as the room goes.
  grip.bubble.style.transform = beside ? `translateX(clamp(-36px - 100%, (${room} - 42px) * 9999, 36px))` : `translateX(max(${6 - x}px, min(-50%, ${room} - 6px)))`;
}

// ---- The figure: the core says what is in it.

/** What the figure has: shapes, or the terms of an equation; where a grip on its axis moves. @type {any} */
let figure = null;

/** Its place is kept from the beginning, so that nothing moves at the answer. */
function drawFigure() {
  const box = one('#figure'), kind = page.held.figure || '';
  box.hidden = !page.keeps_figure, box.dataset.kind = kind;
  let made = one('.made', box);
  if (!made) box.prepend(made = element('div', { className: 'made' }));
  if (kind !== drawFigure.kind) made.replaceChildren(), box.classList.toggle('rise', page.then && kind !== '');
  drawFigure.kind = kind;
  if (kind) box.classList.remove('empty');  // on a small screen an empty one is away, and has no width
  const [left, next] = [0, 1].map(column => onRoom(cells[0], [column, 0])[0]);
  figure = kind ? core.ask('figure', roomSize.figure || box.clientWidth, left, next - left, ...(view.pixel || [-1, -1]), view.channel) : null;
  box.classList.toggle('empty', !figure?.spoken);
  if (!figure?.spoken) made.replaceChildren();
  else if (figure.terms.length) drawTerms(made);
  else made.innerHTML = `<svg role="img" aria-label="${figure.spoken.replace(/[<&"]/g, '')}">${figure.shapes.map(svgShape).join('')}</svg>`;
}
drawFigure.kind = '';

const kAnchors = ['start', 'middle', 'end'];
function svgShape({ kind, role, points, text, anchor }) {
  const [[x, y], [x2, y2] = [0, 0]] = points;
  if (kind === 'words') return svgWords([x, y], text, `text-anchor="${kAnchors[2 * anchor]}" class="${role}"`);
  if (kind === 'box') return `<rect x="${x}" y="${y}" width="${x2 - x}" height="${y2 - y}" rx="3" class="${role}"/>`;
  if (kind === 'dot') return `<circle cx="${x}" cy="${y}" r="4" class="${role}"/>`;
  if (kind === 'curve') return `<polyline points="${pointsOf(points)}" class="${role}"/>`;
  return `<line x1="${x}" y1="${y}" x2="${x2}" y2="${y2}" class="${role}"/>`;
}

function drawTerms(made) {
  const column = ({ symbol, text }) => element('div', {}, element('span', {}, ...withScripts(symbol)), element('b', { textContent: text })), sign = text => element('div', { className: 'sign' }, text);
  const columns = [...figure.terms.flatMap((term, i) => [...(i ? [sign('+')] : []), column(term)]), sign('='), column(figure.sum)];
  const bar = element('div', { className: 'terms-bar', ariaHidden: 'true' }, ...figure.terms.map(({ share }, i) => {
    const part = element('i');
    part.style.width = clamp(100 * share, 0, 100) + '%', part.style.background = ['#9AA3AF', 'var(--sun)', '#F2F4F7', '#F2F4F7'][i];
    return part;
  }));
  made.replaceChildren(element('div', { className: 'sum', role: 'math', ariaLabel: figure.spoken }, ...columns), bar);
}

/** The sentence on the picture becomes what was found once its condition has been true. */
function judgePlay() {
  const play = page.held.play, box = one('#play');
  if (!play || page.then) return void (box.textContent = '');
  if (held.played && !playDone) playDone = true, one('#question').classList.add('lit'), say(play.done);
  const text = playDone ? play.done : play.text;
  box.classList.toggle('done', playDone);
  if (box.textContent === text) return;
  const changes = box.textContent !== '';
  box.textContent = text;
  if (changes && !isStill()) box.animate([{ transform: 'scale(1.15)', opacity: 0.2 }, { transform: 'none', opacity: 1 }], { duration: 420, easing: 'cubic-bezier(.2,.7,.2,1)' });
}

/** The answer is a small event: the old picture is wiped off the new one; what is in the hand stays there. */
function showThen() {
  const shot = cells[0]?.canvases[0], ghost = shot && !isStill() && !view.inside ? element('canvas', { width: shot.width, height: shot.height, className: 'ghost' }) : null, said = verdict;
  if (ghost) ghost.getContext('2d').drawImage(shot, 0, 0), ghost.style.transform = shot.style.transform;
  openPage(view.page, true);
  verdict = said;
  drawQuestion();
  one('#text').classList.add('came');
  setTimeout(() => one('#text').classList.remove('came'), 700);
  if (ghost && cells[0]) {
    cells[0].field.insertBefore(ghost, cells[0].over);
    ghost.animate([{ clipPath: 'inset(0)' }, { clipPath: 'inset(0 0 0 100%)' }], { duration: 700, easing: 'cubic-bezier(.6,0,.2,1)', fill: 'forwards' }).onfinish = () => ghost.remove();
    one('.ring', cells[0].over)?.animate([{ r: '10px', opacity: 1 }, { r: '46px', opacity: 0 }], { duration: 700, iterations: 2 });
  }
  one('#next').focus({ preventScroll: true });
}
