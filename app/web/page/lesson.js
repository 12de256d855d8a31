// The lesson's text, and its question. The core judges.

/** What was said about the last answer. @type {any} */
let verdict = null;

function drawLesson() {
  one('#count').textContent = page.count > 1 ? `page ${page.name} of ${page.count}` : '';
  one('#heading').textContent = page.heading;
  fillHtml(one('#text'), page.text);
  document.title = page.heading + ' – ' + data.title;
  drawDots();
  drawQuestion();
}

/** A mark for each page: where one is, and which are answered. */
function drawDots() {
  one('#dots').hidden = data.pages === 1;
  fillKept(one('#dots'), Array.from({ length: data.pages }, (_, i) => [`page ${i}`, () => {
    const name = `Page ${i + 1}`;
    const button = element('button', { type: 'button', ariaLabel: name, title: name }, element('i'));
    button.addEventListener('click', () => guarded(() => openPage(i)));
    return button;
  }]));
  all('#dots button').forEach((button, i) => {
    button.classList.toggle('done', i in data.made.points);
    if (i === view.page && one('#end').hidden) button.setAttribute('aria-current', 'page');
    else button.removeAttribute('aria-current');
  });
  const got = Object.values(data.made.points).reduce((all, points) => all + points, 0);
  one('#points').textContent = data.points > 0 ? `${shortNumber(got, 4)} of ${shortNumber(data.points)} ${data.points === 1 ? 'point' : 'points'}` : '';
}

function drawQuestion() {
  const box = one('#question'), question = page.question;
  one('#saveanswers').hidden = !page.answered;
  one('#kept').hidden = !page.answered, one('#forget').hidden = !data.isKept;
  one('#kept span').textContent = data.isKept ? 'This browser keeps your answers.' : 'This browser keeps no answers. Save them before you leave.';
  one('#look').hidden = data.isScene || !mayLookInside() || !one('#end').hidden;
  one('#look').setAttribute('aria-pressed', String(view.inside));
  box.hidden = !question;
  const isOpen = question && !question.settled, atEnd = view.page + 1 >= data.pages;
  one('#goon').hidden = !question?.settled || !page.has_then || page.then;
  one('#goback').hidden = !page.then;
  one('#next').hidden = isOpen || !one('#goon').hidden || data.isScene;
  one('#next').textContent = atEnd ? 'Finish' : 'Next page';
  if (!question) return;
  if (question.settled) data.made.points[view.page] = question.points, drawDots();
  box.classList.toggle('settled', question.settled), box.classList.toggle('right', question.state === 'right');
  box.classList.toggle('wrong', isOpen && verdict !== null);
  fillHtml(one('#asked'), question.text);
  drawAnswer(question);
  const said = one('#said');
  said.replaceChildren();
  if (verdict) {
    const [mark, word] = { right: ['●', verdict.given || 'Right'], known: ['△', verdict.name], 'not yet': ['△', 'Not yet'], again: ['○', 'Once more'], stopped: ['○', verdict.name] }[verdict.mark];
    said.append(element('p', { className: 'mark ' + verdict.mark.replace(' ', '-'), textContent: `${mark} ${word}` }));
    const words = element('div');
    fillHtml(words, verdict.said);
    dropBeginning(words, word);
    if (words.textContent.trim()) said.append(words);
    if (verdict.more) said.append(verdict.more);
  }
  one('#hints').replaceChildren(...question.hints.map((hint, i) => {
    const box = element('div', { className: 'hint' }, element('b', { textContent: `Hint ${i + 1}` }), element('div'));
    fillHtml(box.lastElementChild, hint);
    return box;
  }));
  const left = question.hint_count - question.hints.length, points = n => `${shortNumber(n)} ${n === 1 ? 'point' : 'points'}`;
  one('#hint').hidden = question.settled || left === 0, one('#hint').textContent = `Hint (${left} left)`;
  one('#giveup').hidden = question.settled;
  one('#worth').textContent = question.settled ? `${points(question.points)} of ${shortNumber(question.full)}`
    : question.free ? `worth ${shortNumber(question.worth)}, a wrong prediction is free`
    : `worth ${shortNumber(question.worth)}` + (question.tries_left === null ? '' : `, ${question.tries_left} ${question.tries_left === 1 ? 'try' : 'tries'} left`);
  const solution = one('#solution');
  solution.hidden = !question.solution, solution.open = question.state === 'shown';
  if (question.solution) {
    fillHtml(one('#solved'), question.solution.answer);
    one('#works').replaceChildren(...question.solution.steps.map(line => {
      const item = element('li');
      fillHtml(item, line);
      return item;
    }));
  }
}

/** "Not yet: too small." below a mark that says "Not yet" is "Too small." @param {Element} box @param {string} word */
function dropBeginning(box, word) {
  const text = document.createTreeWalker(box, NodeFilter.SHOW_TEXT).nextNode(), begins = text?.nodeValue.match(/^\s*(.*?)[.:]\s*/);
  if (!begins || begins[1] !== word) return;
  const rest = text.nodeValue.slice(begins[0].length);
  text.nodeValue = rest.charAt(0).toUpperCase() + rest.slice(1);
}

/** The place to answer, by the kind of question; what stands there already stays. */
function drawAnswer(question) {
  const form = one('#answer'), key = [page.number, question.kind, question.options.length].join();
  if (form.known !== key) {
    form.known = key;
    form.replaceChildren(...answerFields(question));
  }
  form.hidden = question.settled && question.kind !== 'write';
  if (question.kind === 'order') all('.ordered', form).forEach(row => {
    const words = one('.words', row), { text } = question.options[row.item];
    if (words.known !== text) words.known = text, fillHtml(words, text);
  });
  else question.options.forEach((option, i) => {
    const [input, words] = form.children[i].children;
    input.disabled = option.off, form.children[i].classList.toggle('off', option.off);
    if (words.known !== option.text) words.known = option.text, fillHtml(one('.words', words), option.text);
  });
  if (question.kind === 'click') one('#pickedthing', form).textContent = pickWords(question.click);
  if (question.kind === 'until') one('#gauge', form).textContent = question.gauge ? `Now: ${question.gauge}` : '';
}

function answerFields(question) {
  const check = element('button', { type: 'submit', className: 'primary', textContent: 'Check' });
  if (question.kind === 'order') return [orderList(question), check];
  if (question.kind === 'write') return writeFields(question);
  if (question.options.length)
    return [...question.options.map((option, i) => {
      const type = question.kind === 'choice' ? 'radio' : 'checkbox';
      return element('label', { className: 'option' }, element('input', { type, name: 'option', value: i }),
        element('span', {}, element('b', { textContent: String.fromCharCode(65 + i) + ' ' }), element('span', { className: 'words' })));
    }), check];
  if (question.kind === 'number') {
    const field = element('input', { type: 'text', id: 'typed', inputMode: 'decimal', autocomplete: 'off', ariaLabel: 'Your answer' });
    field.setAttribute('aria-describedby', 'asked');
    return [element('span', { className: 'typedrow' }, field, ' ', question.unit || ''), check];
  }
  if (question.kind === 'click') return [element('p', { className: 'note', id: 'pickedthing' }), check];
  return [element('p', { className: 'number', id: 'gauge' }), check];
}

/** Rows that are moved by their buttons, with Alt and the arrows, or dragged. */
function orderList(question) {
  const list = element('ol', { className: 'orderlist', ariaLabel: `From ${question.ends[0] || 'first'} to ${question.ends[1] || 'last'}` });
  const move = (row, by) => {
    const rows = [...list.children], to = rows.indexOf(row) + by;
    if (to < 0 || to >= rows.length) return;
    /** @type {any} */ const held = document.activeElement;
    by < 0 ? rows[to].before(row) : rows[to].after(row);
    held?.focus();  // moving a node takes the focus from it
    say(`${one('.words', row).textContent}, ${to + 1} of ${rows.length}`);
  };
  let dragged = null;
  question.options.forEach((_, i) => {
    const button = (sign, by, word) => {
      const made = element('button', { type: 'button', className: 'icon', textContent: sign, ariaLabel: word });
      made.addEventListener('click', () => move(row, by));
      return made;
    };
    const words = element('span', { className: 'words' });
    const row = element('li', { className: 'ordered', tabIndex: 0, draggable: true }, words, button('↑', -1, 'Up'), button('↓', 1, 'Down'));
    row.item = i;
    row.addEventListener('keydown', event => {
      const by = { ArrowUp: -1, ArrowDown: 1 }[event.key];
      if (!event.altKey || !by) return;
      event.preventDefault();
      move(row, by);
    });
    row.addEventListener('dragstart', () => { dragged = row; });
    row.addEventListener('dragend', () => { dragged = null; });
    row.addEventListener('dragover', event => {
      if (!dragged || dragged === row) return;
      event.preventDefault();
      const { top, height } = row.getBoundingClientRect();
      event.clientY < top + height / 2 ? row.before(dragged) : row.after(dragged);
    });
    list.append(row);
  });
  return element('div', { className: 'order' }, element('p', { className: 'note', textContent: question.ends[0] || 'first' }),
    list, element('p', { className: 'note', textContent: question.ends[1] || 'last' }));
}

/** What is under the picked pixel, as the core's Pick has it. */
function pickOf() {
  if (!view.pixel) return {};
  const [x, y] = view.pixel, [width] = pictureSize(), at = y * width + x;
  const number = name => {
    if (!core.call('buffer', name, 0)) return undefined;  // not yet, inside the frame
    const id = core.numbers(JSON.parse(core.text()))[at];
    return id >= 0 ? id : undefined;
  };
  const polygon = number('polygon_id');
  return { x, y, polygon, object: number('object_id'), vertex: nearestVertex(polygon) };
}

/** The vertex of the polygon that lies nearest to the picked pixel on the screen. */
function nearestVertex(polygon) {
  if (polygon === undefined) return undefined;
  mesh ??= core.ask('mesh');
  const screen = core.numbers(core.ask('buffer', 'vertices.screen', 0)), off = vertex => Math.hypot(screen[3 * vertex] - view.pixel[0] - 0.5, screen[3 * vertex + 1] - view.pixel[1] - 0.5);
  return mesh.polygons[polygon].reduce((best, vertex) => (off(vertex) < off(best) ? vertex : best));
}

function pickWords(kind) {
  if (!view.pixel) return `Click the ${kind} in the picture.`;
  if (kind === 'pixel') return `Picked: pixel ${view.pixel.join(', ')}`;
  const found = pickOf()[kind];
  return found === undefined ? `There is no ${kind} at this pixel.` : `Picked: ${kind} ${found}`;
}

/** The reader has clicked into a picture. */
function picked() {
  if (page.question?.kind === 'click' && !page.question.settled) drawQuestion();
}

function given() {
  const { kind } = page.question;
  if (kind === 'number') return { typed: one('#typed').value };
  if (kind === 'choice' || kind === 'several') return { chosen: all('#answer input:checked').map(input => Number(input.value)) };
  if (kind === 'order') return { order: all('#answer .ordered').map(row => row.item) };
  return kind === 'click' ? { pick: pickOf() } : {};
}

function check() {
  const answer = given(), found = core.ask('check', JSON.stringify(answer));
  verdict = { ...found, given: found.mark === 'right' ? answer.typed : '' };
  if (found.mark === 'known') data.made.mistakes.push([found.name, page.name]);
  readAgain();
  if (page.question.settled && page.has_then && found.mark === 'right') showThen();
  else one(page.question.settled ? '#foot' : '#help').scrollIntoView({ block: 'nearest' });
  say(all('#said > *').map(part => part.textContent.replace(/^[●△○] /, '')).join('. '));
}

const keptAs = () => `shadescope ${data.name}`;

/** For the next time that the page is loaded; a browser may refuse. */
function keepAnswers() {
  try {
    localStorage.setItem(keptAs(), core.ask('answers', data.name));
    data.isKept = true;
  } catch { data.isKept = false; }
}

function rememberAnswers() {
  let kept = null;
  try {
    kept = localStorage.getItem(keptAs());
  } catch { /* it keeps nothing */ }
  if (!kept) return;
  const { points, mistakes } = core.ask('remember', data.name, kept);
  Object.assign(data, { isKept: true, made: { ...data.made, points: Object.fromEntries(points), mistakes } });
}

/** Reads the page again after its question has changed: what was hidden may be there now. */
function readAgain() {
  keepAnswers();
  page = core.ask('read');
  if (page.question?.settled && view.pixel === null && page.pixel) view.pixel = page.pixel;
  draw();
}

function startLesson() {
  one('#answer').addEventListener('submit', event => {
    event.preventDefault();
    guarded(page.question.kind === 'write' ? runLines : check);
  });
  const does = (id, work) => one(id).addEventListener('click', () => guarded(work));
  does('#hint', () => {
    core.ask('hint');
    verdict = null;
    readAgain();
    say(one('#hints').lastElementChild.textContent);
  });
  does('#giveup', () => {
    core.ask('show');
    verdict = null;
    readAgain();
    say('The answer: ' + one('#solved').textContent);
    for (const assignment of page.question.answer || []) setSetting(...splitAssignment(assignment));
    if (!page.question.answer && page.has_then) showThen();
  });
  does('#forget', () => {
    localStorage.removeItem(keptAs());
    location.reload();
  });
  does('#goon', showThen);
  does('#goback', () => openPage(view.page, false));
  does('#next', () => (view.page + 1 < data.pages ? openPage(view.page + 1) : showEnd()));
}

/** @param {string} assignment @returns {[string, string]} */
function splitAssignment(assignment) {
  const at = assignment.indexOf('=');
  return [assignment.slice(0, at), assignment.slice(at + 1)];
}
