// The end of a lesson: the pictures as the reader left them, what was learned, the mistakes, the next lesson. And paper.

const kKept = [640, 480];

/** The first picture as it is seen now, with the line of a comparison. */
function pictureNow() {
  const [cell] = cells;
  if (!cell?.canvases[0].width || cell.field.classList.contains('listed')) return null;
  const canvas = element('canvas', { width: kKept[0], height: kKept[1] }), context = canvas.getContext('2d'), [x, y, w, h] = cell.part;
  const k = Math.min(canvas.width / w, canvas.height / h), left = (canvas.width - w * k) / 2, top = (canvas.height - h * k) / 2;
  context.imageSmoothingEnabled = cell.canvases[0].style.imageRendering !== 'pixelated';
  context.drawImage(cell.canvases[0], left, top, w * k, h * k);
  if (cell.canvases[1].hidden) return canvas;
  const split = clamp(cell.wipe * pictureSize()[0] - x, 0, w);
  context.drawImage(cell.canvases[1], split, 0, w - split, h, left + split * k, top, (w - split) * k, h * k);
  context.fillStyle = '#fff', context.fillRect(left + split * k - 1, top, 2, h * k);
  return canvas;
}

/** Keeps the picture of the page that is left, once it is answered. */
function keepPicture() {
  if (!page || view.inside || !one('#end').hidden || (page.question && !page.question.settled)) return;
  const canvas = pictureNow();
  if (canvas) data.made.pictures[view.page] = { canvas, heading: page.heading, words: grips.filter(grip => grip.number >= 0).map(grip => grip.words).join(', ') };
}

function showEnd() {
  keepPicture();
  const made = Object.values(data.made.pictures), mistakes = [...new Map(data.made.mistakes.map(([name, at]) => [name, at]))];
  const card = (title, ...parts) => element('div', { className: 'card' }, element('h3', { textContent: title }), ...parts);
  const list = rows => element('ul', {}, ...rows.map(row => element('li', {}, ...row)));
  const pictures = made.map(({ canvas, heading, words }) => {
    canvas.setAttribute('role', 'img'), canvas.setAttribute('aria-label', heading);
    return element('figure', {}, canvas, element('figcaption', {}, element('b', { textContent: heading }), element('span', { textContent: words ? 'as you left it: ' + words : '' })));
  });
  const keep = element('button', { type: 'button', textContent: 'Keep these pictures' }), next = data.next;
  keep.addEventListener('click', () => guarded(() => keepPictures(made)));
  const go = !next ? element('button', { type: 'button', className: 'primary', textContent: 'First page' }) : next.file ? element('a', { className: 'primary button', href: next.file, textContent: 'Begin' }) : null;
  if (go && !next) go.addEventListener('click', () => guarded(() => openPage(0)));
  const last = element('div', { className: 'card go' }, element('div', {}, ...(next ? [element('p', { className: 'note', textContent: 'Next lesson' + (next.minutes ? ` · ${next.minutes} min` : '') }), element('h3', { textContent: next.title })] : [element('h3', { textContent: 'That was the last lesson.' })])), element('span', { className: 'gap' }), ...(made.length ? [keep] : []), ...(go ? [go] : []));
  const heading = element('h2', { id: 'yours', tabIndex: -1, textContent: made.length ? 'These are yours.' : 'Done.' });
  one('#end').replaceChildren(element('p', { className: 'note', textContent: 'Done · ' + one('#points').textContent }), heading,
    element('div', { className: 'made' }, ...pictures),
    element('div', { className: 'two' }, card('You can now', list(data.can.map(text => [text]))),
      card('Mistakes that were yours', mistakes.length ? list(mistakes.map(([name, at]) => [element('b', { textContent: name + '. ' }), `page ${at}`])) : element('p', { textContent: 'None that the program knows.' })), last));
  one('main').hidden = true, one('#end').hidden = false, one('#look').hidden = true;
  one('#end').scrollTop = 0;
  drawDots();
  (go || heading).focus({ preventScroll: true });
  say('These are yours.');
}

/** All of them side by side, as one PNG. @param {any[]} made */
function keepPictures(made) {
  const columns = Math.min(4, made.length), rows = Math.ceil(made.length / columns), sheet = element('canvas', { width: kKept[0] * columns, height: kKept[1] * rows }), context = sheet.getContext('2d');
  context.fillStyle = '#000', context.fillRect(0, 0, sheet.width, sheet.height);
  made.forEach(({ canvas }, i) => context.drawImage(canvas, kKept[0] * (i % columns), kKept[1] * Math.floor(i / columns)));
  element('a', { href: sheet.toDataURL(), download: `${data.name || 'lesson'}.png` }).click();
}

/** Printed, the lesson is its handout, with the pictures that the core makes of each page's first half. */
function drawPaper() {
  const paper = one('#paper');
  fillHtml(paper, one('#handout').textContent);
  one('.banner', paper)?.remove();
  const before = core.memory.slice(0), drawn = canvas => Object.assign(element('canvas', { width: canvas.width, height: canvas.height }), { className: 'printed' });
  all('section', paper).forEach(section => {
    const i = parseInt(one('h2', section).textContent, 10) - 1;  // on paper some pages come before others
    if (!(i >= 0)) return;
    const shown = core.ask('page', i, 0), figures = element('div', { className: 'printed-row' });
    const values = shown.held.strip.length ? shown.held.strip : [''];
    for (const value of values) {
      if (value) core.ask('set', value);
      core.ask('want', shown.buffers.map(({ buffer }) => buffer).filter(name => core.call('want', name)).join(','));
      core.call('frame', 0);
      for (const { buffer, channel, range } of value ? shown.buffers.slice(0, 1) : shown.buffers) {
        if (!core.call('picture', buffer, 0, channel > 2 ? -1 : channel, range ? 1 : 0, ...(range || [0, 0]), 0, 0, 0, 0)) continue;
        const picture = JSON.parse(core.text()), [, , w, h] = picture.part, canvas = drawn({ width: w, height: h });
        canvas.getContext('2d').putImageData(new ImageData(new Uint8ClampedArray(core.memory, picture.pixels, 4 * w * h), w, h), 0, 0);
        figures.append(canvas);
      }
    }
    (one('.pictures', section) || one('h2', section))?.after(figures);
  });
  core.become(before);
}
