// The two pictures: a buffer in its palette, what of it is seen, the picked pixel, numbers in large pixels.

const kValuesFrom = 44;  // CSS pixels that a pixel needs for its numbers to stand in it

/** The part where something is drawn, with the picked pixel, in the picture's proportions; all where that is most of it. */
function partDrawn() {
  const [width, height] = pictureSize(), [left, top, w, h] = boxDrawn(4), wide = Math.ceil(Math.max(w, h * width / height));
  if (wide > 0.8 * width) return [0, 0, width, height];
  return partAround(left + w / 2 - 0.5, top + h / 2 - 0.5, wide);
}

/** @param {number} x @param {number} y @param {number} wide */
function partAround(x, y, wide) {
  const [width, height] = pictureSize(), w = Math.max(4, Math.min(width, Math.round(wide)));
  const h = Math.max(1, Math.min(height, Math.round(w * height / width)));
  const within = (start, size, end) => Math.max(0, Math.min(end - size, Math.round(start)));
  return [within(x - w / 2, w, width), within(y - h / 2, h, height), w, h];
}

/** Closer (below 1) or farther, around a place. @param {number} factor @param {number[]} [around] */
function zoom(factor, around) {
  const [x, y, w, h] = view.part, [cx, cy] = around || view.pixel || [x + w / 2, y + h / 2];
  const wide = Math.max(4, Math.min(pictureSize()[0], w * factor)), share = wide / w;
  view.part = partAround(cx + (x + w / 2 - cx) * share, cy + (y + h / 2 - cy) * share, wide);
  drawPictures();
}

function drawPictures() {
  all('.picture').forEach((figure, i) => {
    const compared = view.compare !== '' && i === 1;
    drawPicture(figure, compared ? view.pictures[0] : i === 1 ? thereNow(view.pictures[1]) : view.pictures[0], compared ? 1 : 0);
  });
  drawRecipe();
  const [x, y, w, h] = view.part, [width, height] = pictureSize();
  one('#whole').hidden = w === width && h === height && view.fit[2] === width;
  one('#whole').textContent = w === width && h === height ? 'Fit' : 'Whole';
  one('#part').textContent = w === width && h === height ? `${width} × ${height} pixels` : `${w} × ${h} of ${width} × ${height} pixels`;
}

/** The texts that derived buffers on show are made after. */
function drawRecipe() {
  const shows = (...names) => view.pictures.some(shown => names.includes(shown.buffer));
  const asks = { condition: shows('condition', 'expression'), mix: shows('mix') };
  one('#recipe').hidden = !asks.condition && !asks.mix;
  for (const [name, isAsked] of Object.entries(asks)) {
    const field = one('#' + name);
    field.hidden = one(`#${name}label`).hidden = !isAsked;
    if (document.activeElement !== field) field.value = view[name];
  }
}

function setRecipe() {
  const given = { condition: one('#condition').value, mix: one('#mix').value };
  try {
    core.ask('recipe', given.condition, given.mix);
  } catch (error) {
    return void (say(error.message), one('#refused').textContent = error.message);
  }
  one('#refused').textContent = '';
  Object.assign(view, given);
  if (view.step) draw();
  else runFrame(draw);
}

/** Inside the frame, where a buffer is not there yet: what the stage draws. @param {View} shown @returns {View} */
function thereNow(shown) {
  if (!view.step) return shown;
  const held = core.ask('held'), drawn = ['polygon_id', ...held.filter(name => name.startsWith('shadow_buffer'))];
  const other = held.includes(shown.buffer) ? undefined : drawn.find(name => held.includes(name) && !page.hidden.buffers.includes(name));
  return other ? { buffer: other, channel: -1, range: null } : shown;
}

/** @param {any} figure @param {View} shown @param {number} which */
function drawPicture(figure, shown, which) {
  const canvas = one('canvas', figure), why = one('.absent', figure), scale = one('.scale', figure);
  const title = view.compare === '' ? '' : which === 1 ? 'B: ' + view.compare.replace('=', ' = ') : 'A';
  one('.side', figure).textContent = title;
  fillChooser(one('select', figure), shown.buffer, which === 1);
  let picture = null;
  try {
    picture = core.ask('picture', shown.buffer, which, shown.channel, shown.range ? 1 : 0, ...(shown.range || [0, 0]), ...view.part);
  } catch (error) {
    why.textContent = error.errors ? error.errors[0].found : error.message;
  }
  why.hidden = picture !== null, scale.hidden = !picture?.scale;
  one('.meaning', figure).textContent = picture ? picture.unit || picture.meaning.replace(/\.$/, '') : '';
  one('.meaning', figure).title = picture ? picture.meaning : '';
  canvas.setAttribute('aria-label', picture ? `${shown.buffer}, ${picture.width} by ${picture.height}. ${picture.meaning}` : why.textContent);
  figure.picture = picture, figure.which = which;
  const domain = buffers.find(buffer => buffer.name === shown.buffer)?.domain, frame = one('.frame', figure);
  const isListed = picture !== null && (domain === 'vertex' || domain === 'polygon');
  frame.classList.toggle('listed', isListed), frame.classList.toggle('free', picture !== null && domain === 'texel');
  fillKept(one('.rows', figure), isListed ? [[`${shown.buffer} ${picture.shape}`, () => element('table', {}, element('tbody'))]] : []);
  if (isListed) fillRows(figure, shown.buffer, which), scale.hidden = true, figure.ofPixels = false;
  else if (picture) {
    const ofPixels = picture.width === pictureSize()[0] && picture.height === pictureSize()[1];
    const [, , w, h] = figure.seen = picture.part;
    figure.ofPixels = ofPixels;
    if (canvas.width !== w || canvas.height !== h) canvas.width = w, canvas.height = h;
    canvas.getContext('2d').putImageData(new ImageData(new Uint8ClampedArray(core.memory, picture.pixels, 4 * w * h), w, h), 0, 0);
    if (picture.scale) drawScale(scale, picture);
  }
  drawMarks(figure);
}

const kMostRows = 200;

/** What has no pixels is listed: a row for each vertex or polygon. @param {any} figure @param {string} name @param {number} which */
function fillRows(figure, name, which) {
  const buffer = core.ask('buffer', name, which), numbers = core.numbers(buffer), channels = buffer.shape[1] || 1, count = buffer.shape[0];
  /** @type {[string, () => Element][]} */
  const rows = [];
  for (let i = 0; i < Math.min(count, kMostRows); ++i) {
    const texts = [...numbers.slice(i * channels, (i + 1) * channels)].map(value => shortNumber(value));
    rows.push([texts.join(), () => element('tr', {}, element('th', { scope: 'row', textContent: i }), ...texts.map(text => element('td', { className: 'number', textContent: text })))]);
  }
  if (count > kMostRows) rows.push(['more', () => element('tr', {}, element('td', { colSpan: channels + 1, textContent: `and ${count - kMostRows} more` }))]);
  fillKept(one('tbody', figure), rows);
}

/** @param {any} scale @param {any} picture */
function drawScale(scale, picture) {
  const [low, high] = all('input', scale), bar = one('canvas', scale), context = bar.getContext('2d');
  if (document.activeElement !== low) low.value = shortNumber(picture.first, 4);
  if (document.activeElement !== high) high.value = shortNumber(picture.last, 4);
  const gradient = context.createLinearGradient(0, 0, bar.width, 0);
  picture.stops.forEach((stop, i) => gradient.addColorStop(i / (picture.stops.length - 1), `rgb(${stop})`));
  context.fillStyle = gradient;
  context.fillRect(0, 0, bar.width, 1);
}

/** Buffers by their stage; those that the scene has no use for come last. */
function fillChooser(chooser, chosen, disabled) {
  const groups = new Map();
  for (const buffer of buffers) {
    if (page.hidden.buffers.includes(buffer.name) && buffer.name !== chosen) continue;
    const group = buffer.useless ? 'Not used by this scene' : buffer.stage;
    if (!groups.has(group)) groups.set(group, []);
    groups.get(group).push(buffer);
  }
  const last = 'Not used by this scene', order = [...groups.keys()].filter(name => name !== last);
  if (groups.has(last)) order.push(last);
  const known = order.map(name => name + groups.get(name).map(buffer => buffer.name)).join();
  if (chooser.known !== known) {
    chooser.known = known;
    chooser.replaceChildren(...order.map(label => element('optgroup', { label }, ...groups.get(label).map(buffer =>
      element('option', { value: buffer.name, textContent: buffer.name, title: buffer.useless || buffer.meaning })))));
  }
  chooser.value = chosen;
  chooser.disabled = disabled;
}

/** The picked pixel, and the numbers of pixels that are large enough. */
function drawMarks(figure) {
  const over = one('.over', figure), box = over.getBoundingClientRect(), ratio = devicePixelRatio;
  over.width = Math.round(box.width * ratio), over.height = Math.round(box.height * ratio);
  over.setAttribute('aria-label', `Picture of ${one('select', figure).value}. ` +
    (view.pixel ? `Picked pixel ${view.pixel.join(', ')}. ` : '') + 'Arrow keys move the picked pixel.');
  if (!figure.picture || !figure.ofPixels) return;
  const context = over.getContext('2d'), [left, top, wide] = figure.seen, size = over.width / wide;
  if (size / ratio >= kValuesFrom) drawValues(figure, context, size, ratio);
  if (!view.pixel) return;
  const x = (view.pixel[0] - left + 0.5) * size, y = (view.pixel[1] - top + 0.5) * size;
  const half = Math.max(4 * ratio, size / 2), gap = half + 4 * ratio;
  for (const [width, color] of [[3.5 * ratio, '#000'], [1.5 * ratio, '#fff']]) {
    context.lineWidth = /** @type {number} */ (width), context.strokeStyle = /** @type {string} */ (color);
    context.beginPath();
    for (const [x0, y0, x1, y1] of [[0, y, x - gap, y], [x + gap, y, over.width, y], [x, 0, x, y - gap], [x, y + gap, x, over.height]])
      if (x1 > x0 || y1 > y0) context.moveTo(x0, y0), context.lineTo(x1, y1);
    context.stroke();
    context.strokeRect(x - half, y - half, 2 * half, 2 * half);
  }
}

function drawValues(figure, context, size, ratio) {
  const buffer = core.ask('buffer', one('select', figure).value, figure.which), numbers = core.numbers(buffer);
  const [left, top, wide, high] = figure.seen, columns = buffer.shape[1], channels = buffer.shape[2] || 1;
  context.textAlign = 'center', context.textBaseline = 'middle';
  context.font = `${Math.min(13, size / ratio / 5) * ratio}px "JetBrains Mono", ui-monospace, monospace`;
  const line = size / 5;
  for (let y = 0; y < high; ++y)
    for (let x = 0; x < wide; ++x) {
      const at = ((top + y) * columns + left + x) * channels;
      for (let c = 0; c < channels; ++c) {
        const text = shortNumber(numbers[at + c], 3), px = (x + 0.5) * size, py = (y + 0.5) * size + (c - (channels - 1) / 2) * line;
        context.lineWidth = 3 * ratio, context.strokeStyle = '#fff', context.strokeText(text, px, py);
        context.fillStyle = '#111', context.fillText(text, px, py);
      }
    }
}

/** The pixel under the pointer, or null where the picture has no pixels. */
function pixelAt(figure, event) {
  if (!figure.picture || !figure.ofPixels) return null;
  const box = one('.over', figure).getBoundingClientRect(), [left, top, wide, high] = figure.seen;
  const x = left + Math.floor((event.clientX - box.left) / box.width * wide), y = top + Math.floor((event.clientY - box.top) / box.height * high);
  const [width, height] = pictureSize();
  return x >= 0 && y >= 0 && x < width && y < height ? [x, y] : null;
}

/** @param {number[]} at */
function pick(at) {
  const [width, height] = pictureSize();
  view.pixel = [Math.max(0, Math.min(width - 1, at[0])), Math.max(0, Math.min(height - 1, at[1]))];
  view.was = '';
  const [x, y, w, h] = view.part, [px, py] = view.pixel;
  if (px < x || py < y || px >= x + w || py >= y + h) view.part = partAround(px, py, w);
  draw();
}

function tellCursor(figure, event) {
  const at = pixelAt(figure, event), cursor = one('.cursor', figure);
  if (!at) return void (cursor.textContent = '');
  const buffer = core.ask('buffer', one('select', figure).value, figure.which), numbers = core.numbers(buffer), channels = buffer.shape[2] || 1;
  const from = (at[1] * buffer.shape[1] + at[0]) * channels;
  cursor.textContent = `${at.join(', ')}: ${[...numbers.slice(from, from + channels)].map(value => shortNumber(value)).join('  ')}`;
}

function startPictures() {
  all('.picture').forEach((figure, i) => {
    const over = one('.over', figure), chooser = one('select', figure), [low, high] = all('.scale input', figure);
    over.addEventListener('click', event => guarded(() => {
      const at = pixelAt(figure, event);
      if (at) pick(at), picked();
      over.focus();
    }));
    over.addEventListener('pointermove', event => soon('cursor', () => tellCursor(figure, event)));
    over.addEventListener('wheel', event => {
      if (!event.ctrlKey && !over.matches(':focus')) return;  // the page scrolls
      event.preventDefault();
      soon('zoom', () => zoom(event.deltaY < 0 ? 0.8 : 1.25, pixelAt(figure, event) || undefined));
    }, { passive: false });
    over.addEventListener('keydown', event => {
      const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
      if (event.key === 'Enter') return guarded(picked);
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      if (event.key === '+' || event.key === '-') return guarded(() => zoom(event.key === '+' ? 0.8 : 1.25));
      if (!way) return;
      event.preventDefault();
      const step = event.shiftKey ? 10 : 1, [x, y] = view.pixel || pictureSize().map(size => size >> 1);
      guarded(() => pick([x + step * way[0], y + step * way[1]]));
      say(pixelWords());
    });
    chooser.addEventListener('change', () => guarded(() => show(i, chooser.value)));
    for (const input of [low, high])
      input.addEventListener('change', () => guarded(() => {
        const ends = [low, high].map(end => Number(end.value.replace('−', '-').replace(',', '.')));
        view.pictures[view.compare ? 0 : i].range = ends.every(Number.isFinite) && low.value && high.value ? ends : null;
        drawPictures();
      }));
    one('.fit', figure).addEventListener('click', () => guarded(() => {
      view.pictures[view.compare ? 0 : i].range = null;
      drawPictures();
    }));
  });
  for (const name of ['#condition', '#mix']) one(name).addEventListener('change', () => guarded(setRecipe));
  one('#closer').addEventListener('click', () => guarded(() => zoom(0.6)));
  one('#farther').addEventListener('click', () => guarded(() => zoom(1 / 0.6)));
  one('#whole').addEventListener('click', () => guarded(() => {
    const [width, height] = pictureSize();
    view.part = view.part[2] === width ? view.fit : [0, 0, width, height];
    drawPictures();
  }));
}

/** Shows a buffer in one of the pictures; computes it where it is not there. @param {number} i @param {string} name */
function show(i, name) {
  view.pictures[i] = { buffer: name, channel: -1, range: null };
  if (view.step) draw();
  else runFrame(draw);
}
