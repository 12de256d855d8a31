// Why the picked pixel has its colour: the equation in symbols and numbers, its terms, the fragments.


/** One line of the equation; each part is a formula of its own, so that the line may break between them. */
function mathLine(line) {
  const goesOn = line.role !== 'row' && line.text.startsWith('=');
  const box = element('div', { className: 'line' + (line.role === 'row' ? ' row' : '') + (goesOn ? ' more' : '') });
  box.setAttribute('role', 'math');
  box.setAttribute('aria-label', line.text);
  for (const part of line.mathml) {
    const holder = document.createElement('div');
    fillHtml(holder, '<math>' + part + '</math>');
    const math = holder.firstElementChild;
    const first = math.firstElementChild;
    if (first && first.localName === 'mo' && /^[=+]$/.test(first.textContent)) first.setAttribute('form', 'infix');
    box.append(math, ' ');
  }
  if (line.remark && line.role === 'row') box.append(element('span', { className: 'remark', textContent: line.remark }));
  return box;
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
  if (hidden) return box.replaceChildren(note('Hidden until you answer the question.'));
  if (!report) return box.replaceChildren(note('Click a pixel to see why it has its colour.'));
  one('#pixel').textContent = report.pixel.join(', ');
  drawSwatch(report.color);
  one('#color').textContent = report.color.join(' ');
  one('#seen').textContent = !report.covered ? 'Nothing is drawn here.'
    : `Polygon ${report.polygon}, object ${report.object}` + (report.interpolation ? `, interpolated ${report.interpolation.split(':')[0]}` : '');
  all('#channel button').forEach((button, i) => button.setAttribute('aria-pressed', String(i === view.channel)));
  const lines = report.equation && !hides('equation') ? report.equation : [];
  const equation = element('div', { className: 'equation' });
  for (const line of lines) {
    equation.append(mathLine(line));
    if (line.role === 'result' && view.was) equation.append(element('div', { className: 'was', textContent: view.was }));
  }
  const parts = lines.length ? [equation] : hides('equation') && report.covered ? [note('The equation is hidden until you answer the question.')] : [];
  const remarks = lines.filter(line => line.remark && line.role !== 'row').map(line => note(line.remark));
  box.replaceChildren(...parts, ...terms(), ...remarks, ...fragments());
}

function drawSwatch(color) {
  const canvas = one('#swatch'), context = canvas.getContext('2d');
  context.fillStyle = `rgb(${color})`;
  context.fillRect(0, 0, canvas.width, canvas.height);
}

function terms() {
  if (!report.covered || !report.i_max || report.outline || hides('equation')) return [];
  const c = view.channel, rows = [['ambient', report.ambient[c]]];
  report.diffuse.forEach((value, k) => rows.push([`diffuse ${k}`, value[c]]));
  report.specular.forEach((value, k) => rows.push([`specular ${k}`, value[c]]));
  if (report.emission[c]) rows.push(['emission', report.emission[c]]);
  const table = element('table', { className: 'terms' }, element('caption', { textContent: 'Terms' }));
  for (const [name, value] of rows) {
    const bar = element('i');
    bar.style.width = 100 * Math.max(0, Math.min(1, value / report.i_max)) + '%';  // of I_max
    table.append(element('tr', {}, element('th', { scope: 'row', textContent: name }),
      element('td', { ariaHidden: 'true' }, element('span', { className: 'share' }, bar)),
      element('td', { className: 'number', textContent: withMinus(value.toFixed(3)) })));
  }
  const notes = report.evaluations.flatMap(evaluation => [...evaluation.lights.map(light => light.note)]).filter(text => text);
  return [table, ...[...new Set(notes)].map(note)];
}

function fragments() {
  const rows = report.fragments.map(fragment => [fragment.polygon, fragment.text, fragment.verdict, fragment.shadows])
    .concat(report.culled.map(polygon => [polygon.polygon, '', polygon.reason, []]));
  if (!rows.length) return [];
  const table = element('table', { className: 'fragments' }, element('caption', { textContent: 'Fragments' }),
    element('tr', {}, ...['polygon', 'depth, and what was stored', 'verdict'].map(text => element('th', { scope: 'col', textContent: text }))));
  for (const [polygon, text, verdict, shadows] of rows)
    table.append(element('tr', {}, element('td', { className: 'number', textContent: polygon }),
      element('td', { className: 'number', textContent: text }),
      element('td', {}, verdict, ...shadows.map(words => element('div', { className: 'note', textContent: words })))));
  return [table];
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
