// The settings: those that the page is about, and all that have an effect in this scene.

function drawSettings() {
  const hidden = hides('settings');
  one('#settingsbox').hidden = hidden;
  // What a hand holds needs no slider; before the answer only a question that is answered by settings has some.
  const isHeld = () => !view.inside && held.holds.length > 0, isOpen = page.question && !page.question.settled;
  const inPlay = page.in_play.filter(() => !isHeld()).map(settingOf).filter(setting => setting);
  one('#inplay').hidden = inPlay.length === 0 || (view.inside ? hidden && !isUntil() : isOpen && !isUntil());
  fillControls(one('#inplay'), inPlay);
  if (view.inside) drawAllSettings();
  one('#putback').hidden = Object.keys(view.own).length === 0;
}

/** Those that have an effect, by their group. */
function drawAllSettings() {
  const groups = new Map();
  for (const setting of settings) {
    if (setting.idle || page.in_play.includes(setting.key)) continue;
    const name = setting.group + (setting.index === null ? '' : ' ' + setting.index);
    if (!groups.has(name)) groups.set(name, []);
    groups.get(name).push(setting);
  }
  const box = one('#settings'), known = [...groups.keys()].join();
  if (box.known !== known) {
    box.known = known;
    box.replaceChildren(...[...groups.keys()].map(name => element('details', {}, element('summary', { textContent: name }), element('div', { className: 'controls' }))));
  }
  [...groups.values()].forEach((list, i) => fillControls(box.children[i].lastElementChild, list));
}

const isUntil = () => page.question?.kind === 'until';

/** One control a setting; controls that are there stay, so that a drag goes on. */
function fillControls(box, list) {
  const keys = list.map(setting => setting.key + setting.kind).join();
  if (box.known !== keys) {
    box.known = keys;
    box.replaceChildren(...list.map(control));
  }
  list.forEach((setting, i) => showValue(box.children[i], setting));
}

function control(setting) {
  const id = 'set-' + setting.key, isNumber = setting.kind === 'number' || setting.kind === 'integer';
  const label = element('label', { htmlFor: id, title: setting.meaning }, ...withScripts(setting.label));
  const row = element('div', { className: 'control', dataset: { key: setting.key } }, label);
  const change = text => soon('set ' + setting.key, () => setSetting(setting.key, text));
  if (setting.kind === 'switch') {
    const box = element('input', { type: 'checkbox', id });
    box.addEventListener('change', () => change(box.checked ? 'on' : 'off'));
    row.append(box);
  } else if (setting.kind === 'choice') {
    const list = element('select', { id }, ...setting.choices.map(choice => element('option', { value: choice, textContent: choice })));
    list.addEventListener('change', () => change(list.value));
    row.append(list);
  }
  if (!isNumber) return row;
  const field = element('input', { type: 'text', inputMode: 'decimal', className: 'typed', ariaLabel: `${setting.label}, typed`, autocomplete: 'off' });
  const step = setting.kind === 'integer' ? 1 : niceStep(setting.high - setting.low);
  const slider = element('input', { type: 'range', id, min: setting.low, max: setting.high, step });
  slider.addEventListener('input', () => change(slider.value));
  field.addEventListener('change', () => change(field.value.replace('−', '-').replace(',', '.')));
  row.append(field, element('span', { className: 'unit', textContent: setting.unit === 'degrees' ? '°' : setting.unit }), slider);
  return row;
}

/** A round step that gives a slider about 200 places. @param {number} range */
function niceStep(range) {
  const rough = range / 200, power = 10 ** Math.floor(Math.log10(rough));
  return [1, 2, 5, 10].map(k => k * power).find(step => step >= rough) || power;
}

function showValue(row, setting) {
  const slider = one('input[type=range]', row), field = one('.typed', row), box = one('input[type=checkbox]', row), list = one('select', row);
  if (slider) {
    slider.value = setting.value;
    slider.setAttribute('aria-valuetext', `${setting.text}${setting.unit ? ' ' + setting.unit : ''}`);
    if (document.activeElement !== field) field.value = withMinus(setting.text);
  }
  if (box) box.checked = setting.value !== 0;
  if (list) list.value = setting.text;
  row.classList.toggle('own', setting.key in view.own);
}

/** The promise is kept when the picture is drawn. @param {string} key @param {string} text @returns {Promise<void>} */
async function setSetting(key, text) {
  const before = { ...settingOf(key) }, result = resultText(), assignment = `${key}=${text}`;
  try {
    core.ask('set', assignment);
  } catch (error) {
    say(error.message), one('#refused').textContent = error.message;
    drawSettings();
    return;
  }
  running?.since.push(assignment);
  one('#refused').textContent = '';
  if (!(key in view.own)) view.own[key] = before.text;
  readValues();
  if (settingOf(key).text === view.own[key]) delete view.own[key];
  const sameSize = key !== 'width' && key !== 'height', was = result ? `was ${result}, with ${before.label.split(' ')[0]} = ${before.text}` : '';
  return runFrame(() => {
    view.was = was;
    if (!sameSize) view.pixel = null, view.part = view.fit = partDrawn();
    if (view.inside) draw();
    else drawPixel(), drawHeld();
  });
}

/** The calls that make the reader's frame. @returns {any[][]} */
const frameCalls = () => (other => [['frame', 0], ...(other ? [['compare', other]] : [])])(view.inside ? view.compare : comparison());

/** The reader's frame with what is shown, then `work`; at once, or in the worker where the frame before took long.
 * @param {() => void} [work] @returns {Promise<void>|undefined} */
function runFrame(work = () => {}) {
  if (!isLong) {
    wantShown();
    const [milliseconds] = frameCalls().map(([name, ...values]) => core.call(name, ...values));
    frameIsThere(milliseconds);
    work();
    return undefined;
  }
  return new Promise(done => {
    afterFrame.push({ work, done: () => done() });
    if (!running) sendFrame();
  });
}

/** Wants what the views show, of what there is, beside what the core wants for a page. */
function wantShown() {
  const names = (view.inside ? view.pictures : page.buffers).map(shown => shown.buffer);
  if (!core.call('want', names.join(','))) core.ask('want', names.filter(name => core.call('want', name)).join(','));
}

/** Whether the last frame took so long that the page would stand still. */
let isLong = false;

/** To the moment inside the frame that the half names. */
function goToPlace() {
  if (!page.place) return;
  const made = core.ask('step', view.level, 0, page.place);
  view.step = made.last ? null : made;
}

/** Steps begin anew. @param {number} milliseconds */
function frameIsThere(milliseconds) {
  view.step = null, mesh = null;
  if (view.inside) plan = core.ask('plan');
  else goToPlace();
  isLong = milliseconds > kLongFrame;
}

/** What a setting is stays; what it is set to moves. A choice may bring others with it. */
function readValues() {
  const values = core.ask('values');
  if (values.length !== settings.length) return void (settings = core.ask('settings'));
  values.forEach(([value, text, idle], i) => Object.assign(settings[i], { value, text, idle }));
}

function fillCompare() {
  const chooser = one('#compare');
  const choices = settings.filter(setting => (setting.kind === 'choice' || setting.kind === 'switch') && !setting.idle && setting.group !== 'Leaving out');
  const known = choices.map(setting => setting.key + setting.text).join();
  if (chooser.known !== known) {
    chooser.known = known;
    chooser.replaceChildren(element('option', { value: '', textContent: 'nothing' }), ...choices.map(setting =>
      element('optgroup', { label: setting.label }, ...setting.choices.filter(choice => choice !== setting.text)
        .map(choice => element('option', { value: `${setting.key}=${choice}`, textContent: `${setting.label}: ${choice}` })))));
  }
  chooser.value = view.compare;
  if (chooser.value !== view.compare) view.compare = chooser.value = '', core.ask('compare', '');
}

function startSettings() {
  one('#putback').addEventListener('click', () => guarded(() => openPage(view.page, view.then)));
  one('#compare').addEventListener('change', event => guarded(() => {
    view.compare = event.target.value;
    if (!isLong || view.compare === '') core.ask('compare', view.compare), draw();
    else runFrame(draw);
    say(view.compare ? `The second picture shows B, with ${view.compare}.` : 'The second picture shows a buffer.');
  }));
}
