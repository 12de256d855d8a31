// Why the picked pixel has its colour: the equation in symbols and numbers, its terms, the fragments.


/** One line of the equation; each part is a formula of its own, so that the line may break between them. */
function fillLine(box, line) {
  box.setAttribute('aria-label', line.text);
  const remark = line.role === 'row' ? line.remark : '';
  /** @type {[string, () => Element][]} */
  const parts = line.mathml.map(part => [part, () => mathPart(part)]);
  if (remark) parts.push([remark, () => element('span', { className: 'remark', textContent: remark })]);
  fillKept(box, parts);
}

/** @param {string} part */
function mathPart(part) {
  const holder = element('span');
  fillHtml(holder, '<math>' + part + '</math> ');
  const first = holder.firstElementChild.firstElementChild;
  if (first && first.localName === 'mo' && /^[=+]$/.test(first.textContent)) first.setAttribute('form', 'infix');
  return holder;
}

function fillEquation(box, lines) {
  const rows = lines.flatMap(line => [line, ...(line.role === 'result' && view.was ? [null] : [])]);  // null: the line before
  const kinds = rows.map(line => (line === null ? 'was' : line.role === 'note' ? 'note' : 'line' + (line.role === 'row' ? ' row' : line.text.startsWith('=') ? ' more' : '')));
  fillKept(box, kinds.map(kind => [kind, () => {
    const made = element('div', { className: kind });
    if (kind.startsWith('line')) made.setAttribute('role', 'math');
    return made;
  }]));
  rows.forEach((line, i) => {
    const words = line === null ? view.was : line.text, row = box.children[i];
    if (line && line.role !== 'note') fillLine(row, line);
    else if (row.textContent !== words) row.textContent = words;
  });
}

function pixelWords() {
  if (!view.pixel) return 'No pixel is picked.';
  const at = `Pixel ${view.pixel.join(', ')}`;
  if (!report || hides('inspector')) return at + '.';
  const seen = report.covered ? `polygon ${report.polygon}` : 'nothing drawn';
  return `${at}: ${seen}, colour ${report.color.join(' ')}.`;
}

/** @param {string} text */
const note = text => element('p', { className: 'note', textContent: text });

function drawPixel() {
  const box = one('#why'), head = one('#pixelhead');
  const hidden = hides('inspector');
  report = view.pixel && !hidden ? core.ask('inspect', ...view.pixel, view.channel) : null;
  head.hidden = !report;
  if (hidden) return fillKept(box, []);
  if (!report) return fillKept(box, [kept('Click a pixel to see why it has its colour.')]);
  one('#pixel').textContent = report.pixel.join(', ');
  drawSwatch(report.color);
  one('#color').textContent = report.color.join(' ');
  one('#seen').textContent = !report.covered ? 'Nothing is drawn here.'
    : `Polygon ${report.polygon}, object ${report.object}` + (report.interpolation ? `, interpolated ${report.interpolation.split(':')[0]}` : '');
  all('#channel button').forEach((button, i) => button.setAttribute('aria-pressed', String(i === view.channel)));
  const told = termNotes(), terms = termRows(), rows = fragmentRows();
  const lines = report.equation && !hides('equation') ? report.equation.filter(line => line.role !== 'note' || !told.includes(line.text)) : [];
  /** @type {[string, () => Element][]} */
  const parts = [];
  if (lines.length) parts.push(['equation', () => element('div', { className: 'equation' })]);
  else if (hides('equation') && report.covered) parts.push(kept('The equation is hidden until you answer the question.'));
  if (terms.length) parts.push(['terms', () => table('terms', 'Terms')]);
  parts.push(...told.map(kept), ...lines.filter(line => line.remark && line.role !== 'row').map(line => kept(line.remark)));
  if (rows.length) parts.push(['fragments', () => table('fragments', 'Fragments')]);
  fillKept(box, parts);
  if (lines.length) fillEquation(one('.equation', box), lines);
  if (terms.length) fillKept(one('.terms tbody', box), terms);
  if (rows.length) fillKept(one('.fragments tbody', box), rows);
}

/** @param {string} text @returns {[string, () => Element]} */
const kept = text => [text, () => note(text)];

function table(className, caption) {
  return element('table', { className }, element('caption', { textContent: caption }), element('tbody'));
}

function drawSwatch(color) {
  const canvas = one('#swatch'), context = canvas.getContext('2d');
  context.fillStyle = `rgb(${color})`;
  context.fillRect(0, 0, canvas.width, canvas.height);
}

const hasTerms = () => report.covered && report.i_max && !report.outline && !hides('equation');

/** @returns {[string, () => Element][]} */
function termRows() {
  if (!hasTerms()) return [];
  const c = view.channel, rows = [['ambient', report.ambient[c]]];
  report.diffuse.forEach((value, k) => rows.push([`diffuse ${k}`, value[c]]));
  report.specular.forEach((value, k) => rows.push([`specular ${k}`, value[c]]));
  if (report.emission[c]) rows.push(['emission', report.emission[c]]);
  return rows.map(([name, value]) => [[name, value, report.i_max].join(), () => {
    const bar = element('i');
    bar.style.width = 100 * Math.max(0, Math.min(1, value / report.i_max)) + '%';  // of I_max
    return element('tr', {}, element('th', { scope: 'row', textContent: name }),
      element('td', { ariaHidden: 'true' }, element('span', { className: 'share' }, bar)),
      element('td', { className: 'number', textContent: withMinus(value.toFixed(3)) }));
  }]);
}

function termNotes() {
  if (!hasTerms()) return [];
  return [...new Set(report.evaluations.flatMap(evaluation => evaluation.lights.map(light => light.note)).filter(text => text))];
}

/** @returns {[string, () => Element][]} */
function fragmentRows() {
  const rows = report.fragments.map(fragment => [fragment.polygon, fragment.text, fragment.verdict, fragment.shadows])
    .concat(report.culled.map(polygon => [polygon.polygon, '', polygon.reason, []]));
  if (!rows.length) return [];
  const head = () => element('tr', {}, ...['polygon', 'depth, and what was stored', 'verdict'].map(text => element('th', { scope: 'col', textContent: text })));
  return [['head', head], ...rows.map(([polygon, text, verdict, shadows]) => [JSON.stringify([polygon, text, verdict, shadows]), () =>
    element('tr', {}, element('td', { className: 'number', textContent: polygon }),
      element('td', { className: 'number', textContent: text }),
      element('td', {}, verdict, ...shadows.map(words => element('div', { className: 'note', textContent: words }))))])];
}

/** The result of the equation now, for "was …". */
function resultText() {
  const lines = report?.equation;
  return lines?.find(line => line.role === 'result')?.text.replace(/^= /, '') || '';
}

function startPixel() {
  all('#channel button').forEach((button, i) => button.addEventListener('click', () => guarded(() => {
    view.channel = i, view.was = '';
    drawPixel();
  })));
  const referred = event => event.target.closest('[data-refers]')?.dataset.refers;
  one('#why').addEventListener('pointerover', event => {
    const key = referred(event);
    for (const control of all('[data-key]')) control.classList.toggle('hot', control.dataset.key === key);
  });
  one('#why').addEventListener('click', event => guarded(() => {
    const name = referred(event);
    if (!name) return;
    const control = all('#inplay [data-key], #settings [data-key]').find(row => row.dataset.key === name);
    if (control) return reveal(control);
    if (page.hidden.buffers.includes(name) || !buffers.some(buffer => buffer.name === name)) return;
    view.compare = '';
    show(1, name);
    say(`The second picture shows ${name}.`);
  }));
}

function reveal(control) {
  const group = control.closest('details');
  for (let at = group; at; at = at.parentElement.closest('details')) at.open = true;
  one('input, select', control).focus();
}
