// What a cue says beside its pictures, asked of a talk with one cue for each, in Chromium. Argument: the program.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { launch } from './browser.mjs';
import { expect, folder, leaveOut } from './claims.mjs';

const [program] = process.argv.slice(2);
const list = path.join(folder, 'parts.cues'), file = path.join(folder, 'talk.html');
const view = (...lines) => ['[[cue.view]]', ...lines].join('\n');
const cue = (name, ...lines) => ['[[cue]]', `name = "${name}"`, ...lines].join('\n');
const color = view('buffer = "color"'), arrow = view('buffer = "polygon_id"', 'overlays = []');
const sphere = ['scene = "ambient"', 'pixel = [211, 268]', 'equation = "red"'];
fs.writeFileSync(list, ['title = "Parts"',
  cue('pins', 'scene = "concave_polygon"', 'pins = [[1, 88, 291], [2, 320, 292], [3, 321, 405]]', 'arrangement = "buffer"', arrow),
  cue('no pins', 'scene = "concave_polygon"', 'arrangement = "buffer"', arrow),
  cue('asks', 'ask = "Which k_r is it?"', 'choices = ["The first", "The <b>second</b>", "The third"]', 'right = "C"', ...sphere, 'arrangement = "buffer"', color),
  cue('answers', 'caption = "It is the third."', ...sphere, 'arrangement = "one"', color),
  cue('dark', 'caption = "Here the light is behind."', ...sphere, 'arrangement = "compare"', view('buffer = "n_dot_l.0"', 'range = [0.25, 0.75]'), view('buffer = "intensity"')),
  cue('lines', 'caption = "The cross product."', 'scene = "pyramid"', 'set = ["camera.scale=3"]', 'place = "normals/polygon=1/line=9"', 'step = "line"', 'algorithm = true', 'arrangement = "space"', color),
  cue('plan', 'scene = "pyramid"', 'set = ["camera.scale=3"]', 'place = "shading/polygon=1/line=3"', 'step = "line"', 'algorithm = true', 'arrangement = "buffer / buffer"', color, view('buffer = "shadow_buffer.0"')),
  cue('sides', 'scene = "flat_gouraud_phong"', 'arrangement = "compare"', view('buffer = "color"', 'against = "setting shading=phong"', 'compare = "a"'), view('buffer = "color"', 'against = "setting shading=phong"', 'compare = "b"')),
  cue('wipe', 'scene = "flat_gouraud_phong"', 'arrangement = "buffer"', view('buffer = "color"', 'against = "setting shading=phong"', 'compare = "wipe"')),
  cue('stage before', 'scene = "pyramid"', 'arrangement = "buffer"', view('buffer = "color"', 'against = "previous stage"', 'compare = "b"')),
  cue('before', 'scene = "pyramid"', 'arrangement = "buffer"', view('buffer = "color"', 'against = "before"', 'compare = "b"')),
  cue('begins', 'scene = "pyramid"', 'place = "z-buffer/start"', 'arrangement = "buffer"', view('buffer = "depth"')),
].join('\n\n') + '\n');
let printed = '';
try {
  printed = execFileSync(program, ['present', 'export', list, '-o', file], { encoding: 'utf8', stdio: ['ignore', 'pipe', fs.openSync(path.join(folder, 'told'), 'w')] });
} catch (error) {
  if (error.status !== 2) throw error;
  leaveOut('this build draws no views');
}
printed = fs.readFileSync(path.join(folder, 'told'), 'utf8');

const browser = await launch();
try {
  const t = await browser.open('file://' + file, { width: 1280, height: 720 });
  const to = name => t.run(`show(cues.findIndex(cue => nameOf(cue) === ${JSON.stringify(name)}))`);
  /** Of the cue on show, or null. @returns {Promise<any>} */
  const of = (selector, what = 'textContent') => t.run(`(part => part && part.${what})(one(${JSON.stringify(selector)}, cues[at]))`);
  const texts = selector => t.run(`all(${JSON.stringify(selector)}, cues[at]).map(part => part.textContent.trim())`);

  // Where two pictures differ, as groups of pixels less than 90 apart: the vertices are 113 and 232 pixels of the scene apart,
  // and the picture is larger.
  const groups = await t.run(`(async () => {
    const pixels = async name => {
      const image = one('img', cues.find(cue => nameOf(cue) === name)), canvas = document.createElement('canvas');
      await image.decode();
      canvas.width = image.naturalWidth, canvas.height = image.naturalHeight;
      const context = canvas.getContext('2d');
      context.drawImage(image, 0, 0);
      return context.getImageData(0, 0, canvas.width, canvas.height);
    };
    const a = await pixels('pins'), b = await pixels('no pins'), groups = [];
    for (let i = 0; i < a.data.length; i += 4) {
      if ([0, 1, 2].every(c => a.data[i + c] === b.data[i + c])) continue;
      const x = (i / 4) % a.width, y = Math.floor(i / 4 / a.width);
      const near = groups.find(group => Math.hypot(group.x - x, group.y - y) < 90);
      if (!near) groups.push({ x, y });
    }
    return groups.length;
  })()`);
  expect('every pin is in the picture', groups === 3, groups);

  await to('asks');
  expect('a question is above its picture', (await of('.title')) === 'Which kr is it?' && (await of('.title', 'getBoundingClientRect().bottom')) <= (await of('img', 'getBoundingClientRect().top')), await of('.title'));
  expect('its symbols are set', (await of('.title sub')) === 'r');
  expect('its choices are a list, and their text is no markup', (await texts('ol.choices > li')).join() === 'AThe first,BThe <b>second</b>,CThe third', await texts('ol.choices > li'));
  expect('none is marked', (await texts('.right')).length === 0);
  expect('it has no numbers beside it', (await of('.equation')) === null);
  await to('answers');
  expect('the answer is above its picture', (await of('.title')) === 'It is the third.', await of('.title'));
  expect('below its question', (await of('.asked')) === 'Which kr is it?', await of('.asked'));
  expect('and marks the right choice, in words too', (await texts('.choices .right')).join() === 'CThe third ● right', await texts('.choices .right'));
  expect('with its equation', (await of('.equation math', 'namespaceURI'))?.endsWith('MathML'));

  await to('asks');
  await t.key('n');
  await t.until('lecturer && lecturer.document.querySelector(".said")');
  expect('the notes beside a question have the right choice', await t.run('lecturer.document.querySelector(".choices .right")?.textContent.includes("The third")'));
  await t.run('lecturer.close()');

  await to('dark');
  expect('the equation ends with the frame buffer', (await texts('.equation > div')).at(-1)?.startsWith('FB'), await texts('.equation > div'));
  expect('no sentence has lost its spaces', !/\p{L}{25}/u.test(await of('.equation') ?? ''), await of('.equation'));
  // The range that the cue gives, and not that of the values.
  expect('a palette has the values of its ends', (await texts('.view:first-child .range .number')).map(Number).join() === '0.25,0.75', await texts('.view:first-child .range .number'));
  expect('and its colours from one to the other', await t.run('(stops => stops.length > 8 && stops[0].getAttribute("fill") !== stops.at(-1).getAttribute("fill"))(all(".view:first-child .range rect", cues[at]))'));

  await to('lines');
  const now = await texts('.code [aria-current=step] span');
  // The face Front of the pyramid is inclined by 48 degrees: n = (0.7433, 0, 0.6690), as the lecture computes by hand.
  expect('the algorithm is there, with the line and its values', now.some(text => /0\.7433.*0\.0000.*0\.6690/.test(text)), now);
  expect('with all of its lines', (await texts('.code li')).length === 9, await texts('.code li'));
  expect('and the loop around them', (await texts('.loop')).length === 1);
  expect('beside its picture', (await of('.algorithm', 'getBoundingClientRect().left')) >= (await of('img', 'getBoundingClientRect().right')));
  await to('plan');
  expect('it says why lines are left out', (await of('.why')) === 'Lines 4 to 7 are left out. The only object is convex: it cannot shadow itself.', await texts('.why'));
  expect('and marks them', (await texts('.code .left-out')).length === 4);
  expect('a buffer that was left out says why', (await of('.without')) === 'The only object is convex: it cannot shadow itself.', await of('.without'));
  expect('below its name', (await texts('figcaption')).join() === 'color,shadow_buffer.0', await texts('figcaption'));
  expect('in large text', parseFloat(await t.run('getComputedStyle(one(".without", cues[at])).fontSize')) >= 0.026 * 720);
  expect('the command says it too', printed.includes('left out: plan: shadow_buffer.0: The only object is convex: it cannot shadow itself.'), printed);

  await to('sides');
  expect('each side of a comparison has its value', (await texts('figcaption')).join(' and ') === 'color, Gouraud and color, Phong', await texts('figcaption'));
  await to('wipe');
  expect('both sides of one picture too', (await texts('figcaption span')).join(' and ') === 'color, Gouraud and color, Phong', await texts('figcaption span'));
  await to('stage before');
  expect('the stage before is shown', (await of('.without')) === null && (await of('figcaption')) !== 'color', [await of('.without'), await of('figcaption')]);
  await to('before');
  expect('a comparison with the scene before says what is missing', (await of('.without')) === 'A is shown alone: a page does not know the scene before the last change.', await of('.without'));
  expect('and so does the command', printed.includes('left out: before: color: A is shown alone'), printed);
  await to('begins');
  expect('the caption names its stage once', (await of('.caption b')) === 'Z-buffer, not begun', await of('.caption b'));
  await t.close();

  for (const [width, height] of [[1280, 720], [1920, 1080], [1024, 768]]) {
    const n = await browser.open('file://' + file, { width, height });
    // 22 of 1080 lines is what the clean view keeps to; scripts of an equation are smaller.
    const small = await n.run(`cues.flatMap((cue, i) => (show(i), all('*', cue).filter(part => part.offsetParent && !part.closest('math, h2') && [...part.childNodes].some(child => child.nodeType === 3 && child.data.trim()))
      .filter(part => parseFloat(getComputedStyle(part).fontSize) < 0.0203 * ${Math.min(height, width * 9 / 16)}).map(part => nameOf(cue) + ': ' + part.className + part.textContent)))`);
    expect(`all text can be read from the last row at ${width}`, small.length === 0, small.slice(0, 5));
    // Pictures are drawn for a screen of 900 lines, with text of 22 of 1080.
    const shrunk = await n.run(`cues.flatMap((cue, i) => (show(i), all('img', cue).map(image => [nameOf(cue), Math.min(image.clientWidth / image.naturalWidth, image.clientHeight / image.naturalHeight)])
      .filter(([, scale]) => scale < 0.8 * ${Math.min(height, width * 9 / 16)} / 900)))`);
    expect(`and the text of the pictures at ${width}`, shrunk.length === 0, shrunk);
    const cut = await n.run('cues.map((cue, i) => (show(i), cue.scrollHeight > cue.clientHeight + 1 || all(".equation, .choices, .algorithm, .title", cue).some(part => part.scrollHeight > part.clientHeight + 2 || part.scrollWidth > part.clientWidth + 1) ? nameOf(cue) : "")).filter(name => name)');
    expect(`every cue is whole at ${width}`, cut.length === 0, cut);
    await n.close();
  }
} finally {
  await browser.close();
}
