// Error against run time of the open scene, as `shadescope study` finds both; a buffer as a figure. Drawings are SVG.

const study = {
  scene: '',                         // as TOML
  /** @type {?Side} */
  side: null,
  run: 0,
  isBusy: false,
  /** @type {any} */
  report: null,
};

/** @param {string} tag @param {Record<string, any>} attributes @param {...(Node|string)} children @returns {any} */
function svgElement(tag, attributes, ...children) {
  const made = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
  made.append(...children);
  return made;
}
/** As a file, in the colours that it has in the page. @param {any} drawing */
function svgText(drawing) {
  const copy = drawing.cloneNode(true), parts = [...copy.querySelectorAll('[class]')];
  for (const [i, part] of drawing.isConnected ? [...drawing.querySelectorAll('[class]')].entries() : [])
    for (const name of ['fill', 'stroke']) parts[i].setAttribute(name, getComputedStyle(part)[name]);
  copy.setAttribute('xmlns', 'http://www.w3.org/2000/svg');
  return new XMLSerializer().serializeToString(copy) + '\n';
}

/** @param {any} plot as the core lays it out @returns {any} */
function plotDrawing({ width, height, lines, markers, texts }) {
  const pathOf = points => points.map(([x, y], i) => `${i ? 'L' : 'M'}${x.toFixed(2)} ${y.toFixed(2)}`).join('');
  return svgElement('svg', { viewBox: `0 0 ${width} ${height}`, role: 'img', 'font-family': 'Inter, "DejaVu Sans", sans-serif' },
    ...lines.map(line => svgElement('path', { class: `line ${line.ink}`, d: pathOf(line.points), 'stroke-width': line.width, 'stroke-dasharray': line.dashes.map(each => each * line.width).join(' ') })),
    ...markers.map(({ outline, at, size, filled, ink }) => svgElement(outline.length ? 'path' : 'circle', { class: `${filled ? 'mark' : 'ring'} ${ink}`, 'stroke-width': size / 7, ...(outline.length ? { d: pathOf(outline) + 'Z' } : { cx: at[0], cy: at[1], r: size / 2 }) })),
    ...texts.map(({ at, anchor, text, size, bold, upwards, ink }) => svgElement('text', { class: ink, x: at[0], y: at[1], 'text-anchor': anchor, 'font-size': size, 'font-weight': bold ? 700 : 400, ...(upwards ? { transform: `rotate(-90 ${at.join(' ')})` } : {}) }, text)));
}

/** @param {string} name of a scene; empty: the open one, with its settings @param {Record<string, string[]>} of @returns {string[]} what does not fit */
function openStudy(name, of) {
  const known = whole.known.find(scene => scene.name === name), first = known || (data ? null : whole.known[0]);
  const refused = name && !known ? [`study=${name}: not in this page`] : [];
  if (first) refused.push(...openLesson(first.page, first.name, of));
  go('study'), document.title = 'Study – Shadescope';
  core.call('scene');
  if (study.scene !== core.text()) stopStudy(), Object.assign(study, { scene: core.text(), report: null });
  one('#studyhead').textContent = `Error against run time: ${one('#title').textContent}`;
  const asked = of.sweep || [], sweeps = core.ask('sweeps'), isNamed = sweeps.some(sweep => sweep.name === asked[0]);
  one('#sweep').replaceChildren(...sweeps.map(({ name: value, meaning, needs }) => element('option', { value, textContent: value, title: needs || meaning, disabled: needs !== '' })), element('option', { value: '', textContent: 'of your own' }));
  one('#sweep').value = isNamed ? asked[0] : asked.length ? '' : sweeps.find(sweep => !sweep.needs)?.name || '';
  one('#sweepmore').value = asked.slice(isNamed ? 1 : 0).join('; ');
  drawStudy();
  return refused;
}

/** As --sweep takes them. */
const sweepsAsked = () => [one('#sweep').value, ...one('#sweepmore').value.split(';')].map(text => text.trim()).filter(text => text);

async function runStudy() {
  stopStudy();
  study.side ??= new Side(core.module, (what, done, all) => tell(`Times, round ${done} of ${all}`, .7 + .3 * done / all));
  const run = ++study.run, tell = (text, share) => { one('#studysaid').textContent = text, one('#studyprogress').value = share; };
  const [, browser = '', version = ''] = /(Firefox|Edg|Chrome|Version)\/(\d+)/.exec(navigator.userAgent) || [];
  Object.assign(study, { isBusy: true, report: null });
  drawStudy();
  try {
    const begun = await study.side.ask(['open', 'scene.toml', encoder.encode(study.scene)], ['study', sweepsAsked().join('\n'), `${browser} ${version}, ${navigator.hardwareConcurrency} cores`, 2, 9]);
    const points = JSON.parse(begun.at(-1));
    for (const [i, point] of points.entries()) {
      tell(`Errors, ${i} of ${points.length}: ${point}`, .7 * i / points.length);
      await study.side.ask(['study_point', i]);
    }
    const found = await study.side.ask(['study_times'], ['study_report', 640, 420, 14]);
    if (run === study.run) study.report = JSON.parse(found.at(-1));
  } catch (error) {
    if (!error.isStopped) throw error;
  } finally {
    if (run === study.run) study.isBusy = false, drawStudy();
  }
}
function stopStudy() {
  if (!study.isBusy) return;
  ++study.run, study.isBusy = false;
  study.side?.stop();
}

function drawStudy() {
  const { report, isBusy } = study;
  one('#studystop').hidden = one('#studyprogress').hidden = !isBusy;
  one('#studyrun').disabled = isBusy;
  if (!isBusy) one('#studysaid').textContent = '';
  const option = one('#sweep').selectedOptions[0];
  one('#studymeaning').textContent = option?.value ? option.title : 'KEY=VALUE,VALUE,… or KEY=FIRST..LAST*FACTOR, as --sweep takes it; several with ; between them.';
  one('#studybody').hidden = !report;
  if (!report) return;
  const drawing = plotDrawing(report.plot);
  drawing.setAttribute('aria-label', report.answers.join(' '));
  one('#studyplot').replaceChildren(drawing);
  one('#studyanswers').replaceChildren(...[...report.answers, report.reference, report.protocol].map((textContent, i) => element('p', { textContent, className: i > 1 ? 'note' : '' })));
  one('#studymeasure').textContent = report.measure;
  one('#studyrows').replaceChildren(...report.rows.map(row => element('tr', { className: row.front ? 'shown' : '' }, element('th', { scope: 'row', textContent: row.label }),
    ...[row.error, row.time && `${row.time} ms`].map(text => element('td', { className: 'number', textContent: withMinus(text) })), element('td', { textContent: row.standing }))));
  one('#studytext').textContent = report.text;
}

/** A buffer on paper, 84 mm wide: its picture, the palette's bar, the picked pixel and a caption, as `shadescope figure` has them. @param {string} buffer */
function figureDrawing(buffer) {
  const picture = core.ask('picture', buffer, 0, -1, 0, 0, 0, 0, 0, 0, 0), [, , columns, rows] = picture.part, canvas = element('canvas', { width: columns, height: rows });
  canvas.getContext('2d').putImageData(new ImageData(new Uint8ClampedArray(core.memory, picture.pixels, 4 * columns * rows), columns, rows), 0, 0);
  // In pt; 1 pt is 1/72 inch.
  const width = 84 / 25.4 * 72, wide = picture.scale ? width - 52 : width - 1, high = wide * rows / columns, barHeight = Math.min(high, 140);
  const at = view.pixel && columns === pictureSize()[0] && rows === pictureSize()[1] ? view.pixel : null;
  const numbers = at && core.numbers(core.ask('buffer', buffer, 0)), channels = picture.channels, from = at && (at[1] * columns + at[0]) * channels;
  const value = at ? [...numbers.slice(from, from + channels)].map(number => shortNumber(number)).join(', ') : '';
  const words = `${picture.meaning.replace(/\.?$/, '.')} ${buffer} of ${data.link || one('#title').textContent}, ${columns} × ${rows} pixels${at ? `; at ${at.join(', ')}: ${value}${picture.unit ? ' ' + picture.unit : ''}` : ''}.`.split(' '), lines = [''];
  for (const word of words) if (lines.at(-1).length + word.length < 58) lines.push((lines.pop() + ' ' + word).trim()); else lines.push(word);
  const text = (x, y, said) => svgElement('text', { x, y, fill: '#171A1F' }, said), parts = [svgElement('image', { href: canvas.toDataURL('image/png'), x: .5, y: .5, width: wide, height: high, preserveAspectRatio: 'none', 'image-rendering': 'pixelated' }),
    svgElement('rect', { x: .5, y: .5, width: wide, height: high, fill: 'none', stroke: '#171A1F', 'stroke-width': .5 })];
  if (picture.scale) {
    const stops = picture.stops.map((color, i) => svgElement('stop', { offset: 1 - i / (picture.stops.length - 1), 'stop-color': `rgb(${color})` })).reverse();
    parts.push(svgElement('defs', {}, svgElement('linearGradient', { id: 'bar', x1: 0, y1: 0, x2: 0, y2: 1 }, ...stops)), svgElement('rect', { x: wide + 6, y: .5, width: 8, height: barHeight, fill: 'url(#bar)', stroke: '#171A1F', 'stroke-width': .5 }));
    for (let i = 0; i < 5; ++i) parts.push(text(wide + 18, 7 + (barHeight - 7) * i / 4, shortNumber(picture.last + (picture.first - picture.last) * i / 4, 4)));
    if (picture.unit && high > barHeight + 10) parts.push(text(wide + 6, barHeight + 10, picture.unit));
  }
  const side = Math.max(4, wide / columns);
  if (at) for (const [stroke, line] of [['#fff', 2.5], ['#171A1F', 1]]) parts.push(svgElement('rect', { x: .5 + (at[0] + .5) * wide / columns - side / 2, y: .5 + (at[1] + .5) * high / rows - side / 2, width: side, height: side, fill: 'none', stroke, 'stroke-width': line }));
  const height = high + 6 + 10 * lines.length;
  return svgElement('svg', { width: '84mm', height: `${(height / 72 * 25.4).toFixed(3)}mm`, viewBox: `0 0 ${width.toFixed(3)} ${height.toFixed(3)}`, 'font-size': 8, 'font-family': 'Inter, "DejaVu Sans", sans-serif' }, ...parts, ...lines.map((line, i) => text(.5, high + 10 + 10 * i, line)));
}

function startStudy() {
  one('#studyrun').addEventListener('click', () => guardedWait(runStudy));
  one('#studystop').addEventListener('click', () => { stopStudy(), drawStudy(); });
  one('#sweep').addEventListener('change', drawStudy);
  one('#studysvg').addEventListener('click', () => saveFile(svgText(one('#studyplot svg')), 'image/svg+xml', 'study.svg'));
  one('#studyjson').addEventListener('click', () => saveFile(study.report.json, 'application/json', 'study.json'));
  one('#savesvg').addEventListener('click', () => guarded(() => saveAs(svgText(figureDrawing(one('#savebuffer').value)), 'image/svg+xml', one('#savebuffer').value + '.svg')));
}
