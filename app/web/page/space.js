// The vectors at the picked point: on the hemisphere around N, and in world space. Drawn by hand, turned by hand and keys.

const minus = (a, b) => a.map((x, i) => x - b[i]), plus = (a, b) => a.map((x, i) => x + b[i]);
const times = (a, k) => a.map(x => x * k), dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const norm = a => Math.sqrt(dot(a, a)), unit = a => times(a, 1 / (norm(a) || 1));
const radians = degrees => degrees * Math.PI / 180;
const angleText = cosine => (Math.acos(Math.max(-1, Math.min(1, cosine))) * 180 / Math.PI).toFixed(1) + '°';
// On a stage, which is dark in every theme, colours are not those of the page.
const colorOf = name => getComputedStyle(one('#space')).getPropertyValue('--' + name).trim();

/** The vectors that the report of the picked pixel has; null where no surface is lit. */
function vectorsHere() {
  const evaluation = report?.covered && report.evaluations[0];
  if (!evaluation || norm(evaluation.N) === 0) return null;
  const light = evaluation.lights[0], found = { N: evaluation.N, V: evaluation.V };
  if (light)
    for (const name of ['L', 'R', 'H'])
      if (norm(light[name]) > 0) found[name] = light[name];
  // H only where the equation has it.
  if (!report.equation?.some(line => line.text.includes('H'))) delete found.H;
  return { vectors: found, at: evaluation.position, light };
}

/** Two axes across a direction. */
function axesAround(n) {
  const x = unit(cross(Math.abs(n[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0], n));
  return [x, cross(n, x), n];
}

/** Turns both views so that the vectors do not cover each other. */
function aimSpace() {
  const here = vectorsHere();
  if (!here) return;
  const { N, V, L } = here.vectors, axes = axesAround(N), inAxes = v => axes.map(axis => dot(axis, v));
  if (L) {
    const apart = minus(inAxes(V), inAxes(L));
    view.turned.point = [Math.atan2(-apart[0], apart[1]) * 180 / Math.PI, 18];
  }
  view.turned.world = [Math.atan2(V[1], V[0]) * 180 / Math.PI + 28, Math.asin(Math.max(-1, Math.min(1, V[2]))) * 180 / Math.PI - 8];
}

/** What the drawing needs of where it looks from: place() maps a point to the canvas. */
function lookFrom(azimuth, elevation, origin, scale, middle) {
  const a = radians(azimuth), e = radians(elevation);
  const eye = [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)], right = [-Math.sin(a), Math.cos(a), 0], up = cross(eye, right);
  const place = point => {
    const v = minus(point, origin);
    return [middle[0] + scale * dot(v, right), middle[1] - scale * dot(v, up)];
  };
  return { eye, right, up, place, scale };
}

function drawSpace() {
  const canvas = one('#space'), box = canvas.parentElement.getBoundingClientRect(), ratio = devicePixelRatio;
  canvas.width = Math.round(box.width * ratio), canvas.height = Math.round(box.height * ratio);
  all('#spaces button').forEach(button => button.setAttribute('aria-pressed', String(button.value === view.space)));
  const context = canvas.getContext('2d'), here = hides('inspector') ? null : vectorsHere();
  context.scale(ratio, ratio);
  const pen = penOf(context);
  if (view.space === 'world') drawWorld(context, pen, box, here);
  else if (here) drawPoint(context, pen, box, here);
  else pen.words(hides('inspector') ? '' : 'Pick a pixel of a surface to see its vectors.', [box.width / 2, box.height / 2], colorOf('text2'));
  canvas.setAttribute('aria-label', here ? 'Vectors at the picked point: ' + Object.entries(here.vectors).map(([name, v]) => `${name} (${v.map(x => withMinus(x.toFixed(3))).join(', ')})`).join('; ') : 'No vectors: no lit surface is picked.');
}

/** Lines and words on a canvas. @param {CanvasRenderingContext2D} context */
const penOf = context => ({
  line(points, width, color, dash = []) {
    context.beginPath();
    points.forEach((point, i) => (i ? context.lineTo(point[0], point[1]) : context.moveTo(point[0], point[1])));
    context.lineWidth = width, context.strokeStyle = color;
    context.setLineDash(dash), context.stroke(), context.setLineDash([]);
  },
  words(text, at, color, font = '13px Inter, system-ui, sans-serif') {
    context.font = font, context.textAlign = 'center', context.textBaseline = 'middle';
    context.lineWidth = 5, context.lineJoin = 'round', context.strokeStyle = colorOf('view');
    context.strokeText(text, at[0], at[1]);
    context.fillStyle = color, context.fillText(text, at[0], at[1]);
  },
});

function drawPoint(context, pen, box, here) {
  const { vectors, light } = here, axes = axesAround(vectors.N), turn = v => axes.map(axis => dot(axis, v));
  const scale = Math.min(box.width * 0.4, (box.height - 46) / 1.36), [azimuth, elevation] = view.turned.point;
  const look = lookFrom(azimuth, elevation, [0, 0, 0], scale, [box.width / 2, box.height - 22 - scale * 0.3]);
  const circle = z => Array.from({ length: 121 }, (_, i) => {
    const r = Math.sqrt(1 - z * z), t = radians(3 * i);
    return look.place([r * Math.cos(t), r * Math.sin(t), z]);
  });
  const arcOver = m => Array.from({ length: 61 }, (_, i) => {
    const t = radians(3 * i), h = Math.cos(t);
    return look.place([h * Math.cos(m), h * Math.sin(m), Math.sin(t)]);
  });
  context.globalAlpha = 0.28, context.fillStyle = `rgb(${report.color})`;
  context.beginPath(), circle(0).forEach(([x, y], i) => (i ? context.lineTo(x, y) : context.moveTo(x, y))), context.fill();
  context.globalAlpha = 1;
  pen.line(circle(0), 1, colorOf('outline'));
  for (const z of [0.5, Math.sqrt(3) / 2]) pen.line(circle(z), 1, colorOf('line'));
  for (let m = 0; m < 180; m += 30) pen.line(arcOver(radians(m)), 1, colorOf('line'));
  const rim = Array.from({ length: 61 }, (_, i) => plus(times(look.right, Math.cos(radians(3 * i))), times(look.up, Math.sin(radians(3 * i)))));
  pen.line(rim.filter(v => v[2] >= -1e-9).map(look.place), 1, colorOf('outline'));
  const arc = (from, to, text, radius) => {
    const along = Array.from({ length: 21 }, (_, i) => times(unit(plus(times(from, 1 - i / 20), times(to, i / 20))), radius));
    pen.line(along.map(look.place), 1.5, colorOf('text2'));
    pen.words(text, look.place(times(unit(plus(from, to)), radius + 0.1)), colorOf('text'), '600 12px "JetBrains Mono", ui-monospace, monospace');
  };
  if (vectors.L && vectors.R && light.n_dot_l > 0) {
    pen.line([look.place(turn(vectors.L)), look.place(turn(vectors.R))], 1.2, colorOf('text3'), [2, 3]);
    arc(turn(vectors.R), turn(vectors.V), angleText(light.r_dot_v), 0.66);
  }
  if (vectors.L) arc([0, 0, 1], turn(vectors.L), angleText(light.n_dot_l), 0.42);
  drawVectors(context, pen, box, look, [0, 0, 0], vectors, turn, 1);
}

function drawWorld(context, pen, box, here) {
  if (!core.call('buffer', 'vertices.world', 0)) return pen.words('The vertices are not in world space yet.', [box.width / 2, box.height / 2], colorOf('text2'));
  const numbers = core.numbers(JSON.parse(core.text())), points = [];
  for (let i = 0; i < numbers.length; i += 3) points.push([numbers[i], numbers[i + 1], numbers[i + 2]]);
  if (!points.length) return pen.words('The scene has no vertices.', [box.width / 2, box.height / 2], colorOf('text2'));
  if (points.every(point => norm(minus(point, points[0])) === 0)) return pen.words('The vertices are not in world space yet.', [box.width / 2, box.height / 2], colorOf('text2'));
  mesh ??= core.ask('mesh');
  const ends = pick => [0, 1, 2].map(i => points.reduce((end, point) => pick(end, point[i]), points[0][i]));
  const low = ends(Math.min), high = ends(Math.max), origin = times(plus(low, high), 0.5), size = norm(minus(high, low));
  const [azimuth, elevation] = view.turned.world, flat = lookFrom(azimuth, elevation, origin, 1, [0, 0]);
  const reach = axis => points.reduce((most, point) => Math.max(most, Math.abs(flat.place(point)[axis])), 1e-300);
  const look = lookFrom(azimuth, elevation, origin, Math.min((box.width / 2 - 60) / reach(0), (box.height / 2 - 34) / reach(1)), [box.width / 2, box.height / 2 + 10]);
  const placed = points.map(look.place), depth = points.map(point => dot(point, look.eye));
  const order = mesh.polygons.map((vertices, i) => ({ vertices, i, z: vertices.reduce((sum, v) => sum + depth[v], 0) / vertices.length })).sort((a, b) => a.z - b.z);
  const seen = here ? report.polygon : -1, isFine = order.length > 200;
  context.lineWidth = 1;
  for (const { vertices, i } of order) {
    context.beginPath();
    vertices.forEach((v, k) => (k ? context.lineTo(placed[v][0], placed[v][1]) : context.moveTo(placed[v][0], placed[v][1])));
    context.closePath();
    context.fillStyle = colorOfWorld(i === seen), context.fill();
    context.globalAlpha = isFine ? 0.35 : 1, context.strokeStyle = worldColors.outline, context.stroke(), context.globalAlpha = 1;
  }
  const foot = [box.width - 42, box.height - 38];
  [['x', [1, 0, 0]], ['y', [0, 1, 0]], ['z', [0, 0, 1]]].forEach(([name, axis]) => {
    const end = [foot[0] + 26 * dot(/** @type {number[]} */ (axis), look.right), foot[1] - 26 * dot(/** @type {number[]} */ (axis), look.up)];
    pen.line([foot, end], 1.5, colorOf('text3'));
    pen.words(/** @type {string} */ (name), [end[0] + 7, end[1]], colorOf('text2'), '12px Inter, system-ui, sans-serif');
  });
  if (here) drawVectors(context, pen, box, look, here.at, here.vectors, v => v, size * 0.36);
}

const worldColors = { outline: '' };
function colorOfWorld(isSeen) {
  worldColors.outline = colorOf('outline');
  return colorOf(isSeen ? 'tint' : 'surface');
}

const kDashes = { N: [], L: [8, 3.4], V: [8, 2.5, 2, 2.5], R: [3.4, 2.5], H: [1, 2.5] };

/** Each vector with its colour, its dash and its tip; the names do not cover each other. */
function drawVectors(context, pen, box, look, foot, vectors, turn, reach) {
  const from = look.place(foot), names = [];
  for (const name of ['R', 'V', 'H', 'L', 'N']) {
    if (!vectors[name]) continue;
    const tip = look.place(plus(foot, times(turn(vectors[name]), reach))), along = unit(minus(tip, from)), color = colorOf(name);
    const short = name === 'V' || name === 'H' ? 5 : name === 'N' ? 9 : 0;
    pen.line([from, minus(tip, times(along, short))], name === 'N' ? 3 : 2.4, color, kDashes[name]);
    drawTip(context, name, tip, along, color);
    names.push({ name, at: plus(tip, times(along, 18)), color });
  }
  for (let round = 0; round < 20; ++round)
    for (const a of names)
      for (const b of names) {
        const apart = minus(b.at, a.at), far = norm(apart);
        if (a === b || far >= 21) continue;
        const push = times(far ? times(apart, 1 / far) : [1, 0], (21 - far) / 2);
        a.at = minus(a.at, push), b.at = plus(b.at, push);
      }
  for (const { name, at, color } of names)
    pen.words(name, [Math.max(10, Math.min(box.width - 10, at[0])), Math.max(11, Math.min(box.height - 11, at[1]))], color, 'italic 700 18px "STIX Two Text", STIX, Georgia, serif');
  context.beginPath(), context.arc(from[0], from[1], 4, 0, 7);
  context.fillStyle = colorOf('view'), context.fill();
  context.lineWidth = 1.5, context.strokeStyle = colorOf('text'), context.stroke();
}

function drawTip(context, name, [x, y], [ux, uy], color) {
  context.fillStyle = context.strokeStyle = color, context.lineWidth = 2.2;
  context.beginPath();
  if (name === 'N') context.moveTo(x, y), context.lineTo(x - ux * 12 + uy * 5, y - uy * 12 - ux * 5), context.lineTo(x - ux * 12 - uy * 5, y - uy * 12 + ux * 5), context.fill();
  else if (name === 'R') context.moveTo(x - ux * 11 + uy * 7, y - uy * 11 - ux * 7), context.lineTo(x, y), context.lineTo(x - ux * 11 - uy * 7, y - uy * 11 + ux * 7), context.stroke();
  else if (name === 'H') context.moveTo(x, y - 6), context.lineTo(x + 6, y), context.lineTo(x, y + 6), context.lineTo(x - 6, y), context.fill();
  else context.arc(x, y, 5, 0, 7), name === 'L' ? context.fill() : context.stroke();
}

function startSpace() {
  const canvas = one('#space');
  const turn = (right, up) => {
    const turned = view.turned[view.space], lowest = view.space === 'world' ? -85 : 0;
    turned[0] += right, turned[1] = Math.max(lowest, Math.min(85, turned[1] + up));
    drawSpace();
  };
  canvas.addEventListener('pointerdown', event => canvas.setPointerCapture(event.pointerId));
  canvas.addEventListener('pointermove', event => {
    if (event.buttons) soon('turn', () => turn(-event.movementX * 0.5, event.movementY * 0.5));
  });
  canvas.addEventListener('keydown', event => {
    const way = { ArrowLeft: [5, 0], ArrowRight: [-5, 0], ArrowUp: [0, 5], ArrowDown: [0, -5] }[event.key];
    if (!way) return;
    event.preventDefault();
    guarded(() => turn(way[0], way[1]));
  });
  for (const button of all('#spaces button'))
    button.addEventListener('click', () => guarded(() => {
      view.space = button.value;
      drawSpace();
    }));
}
