// The strip of six stages, and steps inside the frame.

const kStates = { runs: ['ran', '●', 'ran'], reused: ['reused', '○', 'reused'], 'left out': ['left', '–', 'left out'] };

function drawStages() {
  const at = plan.stages.findIndex(stage => stage.stage === (view.step ? view.step.stage : page.stage));
  all('#stages button').forEach((button, i) => {
    const stage = plan.stages[i], isOut = stage.action === 'left out', isLater = view.step !== null && i > at && !isOut;
    const [state, mark, word] = isLater ? ['later', '·', 'not yet'] : kStates[stage.action] || kStates.runs;
    button.className = isOut ? 'out' : '';
    if (i === at) button.setAttribute('aria-current', 'step');
    else button.removeAttribute('aria-current');
    const inside = i === at && view.step ? `${view.step.progress.done} of ${view.step.progress.of} ${view.step.progress.unit}` : stage.counts;
    const told = isOut ? (hides('plan') ? '' : stage.why) : isLater || hides('counts') ? '' : inside;
    /** @returns {[string, () => Element]} */
    const span = (className, text) => [className + text, () => element('span', { className, textContent: text })];
    fillKept(button, [['name', () => element('span', { className: 'name' })], span('told', told), span('time', isOut || isLater ? '' : timeText(stage.milliseconds))]);
    fillKept(button.firstElementChild, [span('number', i + 1), span('label', stage.label), span('state ' + state, `${mark} ${word}`)]);
    button.title = hides('plan') ? '' : [stage.why, ...stage.parts.filter(part => part.action === 'left out').map(part => `${part.part} left out: ${part.why}`)].join('\n');
  });
  one('#frame').textContent = `frame ${plan.number}, ${timeText(plan.milliseconds)}`;
  const remarks = plan.remarks.map(remark => (remark.about ? remark.about + ': ' : '') + remark.text);
  one('#remarks').hidden = remarks.length === 0 || hides('plan');
  one('#remarks').textContent = remarks.join(' ');
}

function drawSteps() {
  const step = view.step, bar = one('#steps'), last = step === null;
  bar.hidden = hides('timeline');
  one('#forth').disabled = one('#last').disabled = last;
  one('#first').disabled = one('#back').disabled = step !== null && step.first;
  const progress = one('#progress');
  progress.max = step ? Math.max(1, step.of) : 1, progress.value = step ? step.done : 1;
  one('#stepped').textContent = stepWords();
  one('#level').value = view.level;
  drawAlgorithm();
}

/** The algorithm of the stage as the lectures print it; the text is the core's. */
function drawAlgorithm() {
  const box = one('#algorithmbox');
  box.hidden = hides('algorithm') || !core.calls.algorithm;
  if (box.hidden || !box.open) return;
  const stage = plan.stages.findIndex(stage => stage.stage === (view.step ? view.step.stage : page.stage));
  const found = core.ask('algorithm', stage);
  /** @type {[string, () => Element][]} */
  const parts = [];
  if (!found) parts.push(kept('There is no algorithm for this stage.'));
  else {
    parts.push(kept(found.title), ['lines', () => element('ol', { className: 'code' })]);
    for (const words of [...(found.left_out || []), found.note]) if (words) parts.push(kept(words));
  }
  fillKept(one('#algorithm'), parts);
  if (!found) return;
  fillKept(one('.code', box), found.lines.map(line => [JSON.stringify(line), () => codeLine(line)]));
  one('.code .now', box)?.scrollIntoView({ block: 'nearest' });
}

function codeLine(line) {
  const values = [line.with_values !== line.text ? line.with_values : '', line.remark].filter(words => words).join('  ');
  const row = element('li', { className: line.status.replace(' ', '-') },
    element('span', { className: 'text', textContent: '  '.repeat(line.indent) + line.text }), element('span', { className: 'values', textContent: values }));
  if (line.status === 'now') row.setAttribute('aria-current', 'step');
  return row;
}

function stepWords() {
  const step = view.step;
  if (!step) return 'the whole frame';
  const { done, of, unit } = step.progress;
  // The words may begin with the stage: "Z-buffer, done".
  const words = step.words?.startsWith(step.label) ? step.words : `${step.label}: ${step.words || 'start'}`;
  return `${words}${of ? ` (${done} of ${of} ${unit})` : ''}`;
}

/** way: 1 forth, -1 back, 0 to a place. @param {number} way @param {string} [place] */
function step(way, place = '') {
  if (hides('timeline')) return;
  const made = core.ask('step', view.level, way, place);
  view.step = made.last ? null : made;
  if (made.pixel && way !== 0 && view.level >= 3 && !made.last) view.pixel = made.pixel;
  draw();
  say(stepWords());
}

function startStages() {
  one('#algorithmbox').addEventListener('toggle', () => guarded(drawAlgorithm));
  for (let i = 0; i < 6; ++i) {
    const button = element('button', { type: 'button' });
    button.addEventListener('click', () => guarded(() => step(0, plan.stages[i].stage)));
    one('#stages').append(element('li', {}, button));
  }
  const does = (id, work) => one(id).addEventListener('click', () => guarded(work));
  does('#first', () => step(0, 'transform/start'));
  does('#back', () => step(-1));
  does('#forth', () => step(1));
  does('#last', () => step(0, 'shading'));
  one('#level').addEventListener('change', event => { view.level = Number(event.target.value); });
}
