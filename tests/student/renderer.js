#!/usr/bin/env node
// A third student's renderer: scanlines with double interpolation (lecture 1), Phong shading with Blinn's halfway vector
// (lecture 2), reversed depth n / z. Written from the lectures; no code of Shadescope's is in it.
//
//   node renderer.js SCENE FOLDER [--size 320x240] [--near N] [--error NAME] [--rows bottom-up] [--list]
'use strict';
const fs = require('fs');
const path = require('path');

// name: [what it is in the program's table, - for none; the stage; the buffer where it shows first]
const ERRORS = {
  'minus-theta': ['theta-sign', 'transform', 'vertices.view'],
  'phi-from-ground': ['elevation', 'transform', 'vertices.view'],
  'skip-rotate': ['no-rotation', 'transform', 'vertices.world'],
  'turn-back': ['rotation-sign', 'transform', 'vertices.world'],
  'skip-scale': ['unscaled', 'transform', 'vertices.world'],
  'forgot-divide': ['no-division', 'transform', 'vertices.screen'],  // x_s = d x_v / rho
  'one-to-the-right': ['column', 'transform', 'color'],
  'cull-positive': ['cull-sign', 'cull', 'polygons.visible'],
  'cull-nothing': ['no-cull', 'cull', 'polygons.visible'],
  'mean-left': ['mean-not-unit', 'normals', 'vertices.normal'],   // the mean of the normals around, as it is
  'depth-of-polygon': ['one-depth', 'z-buffer', 'depth'],         // the mean z of its vertices
  'no-test': ['no-test', 'z-buffer', 'depth'],                    // painted in the order of the file
  'farther-wins': ['z-flip', 'z-buffer', 'depth'],
  'light-vector-raw': ['l-raw', 'shading', 'color'],
  'half-lambert': ['half-lambert', 'shading', 'color'],           // (N.L + 1) / 2
  'no-power': ['no-power', 'shading', 'color'],                   // N.H without its exponent
  'h-not-unit': ['h-raw', 'shading', 'color'],
  'times-shininess': ['times-n', 'shading', 'color'],             // n times N.H
  'view-axis': ['v-axis', 'shading', 'color'],                    // V is minus the viewing axis
  'blocky': ['blocks-of-four', 'shading', 'color'],               // one pixel in four by four is shaded
};

const o = { size: '320x240', near: 4, error: '', rows: 'top-down' };
const names = [];
for (let i = 2; i < process.argv.length; ++i) {
  const word = process.argv[i];
  if (word === '--list') {
    for (const [name, row] of Object.entries(ERRORS)) console.log(name, ...row);
    process.exit(0);
  }
  if (word.startsWith('--')) o[word.slice(2)] = process.argv[++i];
  else names.push(word);
}
if (names.length !== 2 || (o.error && !o.error.split('+').every((name) => ERRORS[name]))) {
  console.error('renderer.js SCENE FOLDER [--size WxH] [--near N] [--error NAME]');
  process.exit(2);
}
const made = o.error.split('+');  // several errors at once: one+another
const wrong = (name) => made.includes(name);
const [width, height] = o.size.split('x').map(Number);
const near = Number(o.near);

const add = (a, b) => a.map((v, i) => v + b[i]);
const sub = (a, b) => a.map((v, i) => v - b[i]);
const scaled = (s, a) => a.map((v) => s * v);
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => { const l = Math.hypot(...a); return l > 0 ? scaled(1 / l, a) : a; };
const radians = (degrees) => degrees * Math.PI / 180;

function reader(file) {
  const words = fs.readFileSync(file, 'utf8').replace(/\/\/.*/g, '').replace(/[(),]/g, ' ').split(/\s+/).filter((w) => w);
  let at = 0;
  const word = () => words[at++];
  const number = () => Number(word());
  return { word, number, vector: () => [number(), number(), number()] };
}

// ---- The scene.
const file = reader(names[0]);
const d = file.number();
const rho = file.number();
const theta = radians(file.number()) * (wrong('minus-theta') ? -1 : 1);
let phi = radians(file.number());
if (wrong('phi-from-ground')) phi = Math.PI / 2 - phi;
const vertices = [];
const polygons = [];
const materials = [];
for (let k = 0, count = file.number(); k < count; ++k) {
  const des = reader(path.join(path.dirname(names[0]), file.word()));
  let scale = file.vector();
  let turn = file.vector().map(radians);
  const move = file.vector();
  if (wrong('skip-scale')) scale = [1, 1, 1];
  if (wrong('skip-rotate')) turn = [0, 0, 0];
  if (wrong('turn-back')) turn = scaled(-1, turn);
  const points = des.number();
  const faces = des.number();
  const first = vertices.length;
  const rotate = (a, b, angle, p) => {
    const out = p.slice();
    out[a] = p[a] * Math.cos(angle) - p[b] * Math.sin(angle);
    out[b] = p[a] * Math.sin(angle) + p[b] * Math.cos(angle);
    return out;
  };
  for (let i = 0; i < points; ++i) {
    let p = des.vector().map((v, c) => v * scale[c]);
    p = rotate(1, 2, turn[0], p);
    p = rotate(2, 0, turn[1], p);
    p = rotate(0, 1, turn[2], p);
    vertices.push({ world: add(p, move), sum: [0, 0, 0], around: 0 });
  }
  for (let i = 0; i < faces; ++i) {
    const corners = [];
    for (let n = des.number(); n > 0; --n) corners.push(first + des.number());
    polygons.push({ corners, object: k });
  }
  materials.push({ kd: des.vector(), ks: des.number(), n: des.number() });
}
const lights = [];
for (let count = file.number(); count > 0; --count) {
  const place = file.vector();
  lights.push({ towards: wrong('light-vector-raw') ? place : unit(place), power: file.number() });
}
const ambient = file.number();

// ---- Transform: lecture 1's viewing system, z away from the viewer.
const right = [-Math.sin(theta), Math.cos(theta), 0];
const up = [-Math.cos(theta) * Math.cos(phi), -Math.sin(theta) * Math.cos(phi), Math.sin(phi)];
const forward = [-Math.sin(phi) * Math.cos(theta), -Math.sin(theta) * Math.sin(phi), -Math.cos(phi)];
const eye = scaled(-rho, forward);
const toView = (p) => [dot(right, p), dot(up, p), dot(forward, p) + rho];
function toScreen(v) {
  const z = wrong('forgot-divide') ? rho : v[2];
  return [width / 2 + d * v[0] / z + (wrong('one-to-the-right') ? 1 : 0), height / 2 - d * v[1] / z];
}
for (const v of vertices) v.view = toView(v.world);

// ---- Normals and culling.
for (const p of polygons) {
  const [a, b, c] = p.corners.map((i) => vertices[i].world);
  p.normal = unit(cross(sub(b, a), sub(c, a)));
  for (const i of p.corners) vertices[i].sum = add(vertices[i].sum, p.normal), ++vertices[i].around;
}
for (const v of vertices) v.normal = wrong('mean-left') ? scaled(1 / Math.max(1, v.around), v.sum) : unit(v.sum);

// All that is interpolated over a polygon, as one list: view, world, normal.
const bundle = (v) => [...v.view, ...v.world, ...v.normal];
function clip(list) {
  const out = [];
  list.forEach((a, i) => {
    const b = list[(i + 1) % list.length];
    if (a[2] >= near) out.push(a);
    if ((a[2] >= near) !== (b[2] >= near)) {
      const t = (near - a[2]) / (b[2] - a[2]);
      out.push(a.map((v, c) => v + t * (b[c] - v)));
    }
  });
  return out;
}
for (const p of polygons) {
  p.cut = clip(p.corners.map((i) => bundle(vertices[i])));
  let area = 0;
  p.cut.forEach((a, i) => {
    const [x0, y0] = toScreen(a), [x1, y1] = toScreen(p.cut[(i + 1) % p.cut.length]);
    area -= (x0 * y1 - x1 * y0) / 2;
  });
  p.visible = wrong('cull-nothing') ? p.cut.length > 2 : wrong('cull-positive') ? area < 0 : area > 0;
}

// ---- Z-buffer: scanlines; a pixel is drawn if its centre is between two edges.
const pixels = new Array(width * height).fill(null);
const zBuffer = new Float64Array(width * height).fill(wrong('farther-wins') ? 0 : Infinity);
polygons.forEach((p, number) => {
  if (!p.visible) return;
  const mean = p.cut.reduce((sum, c) => sum + c[2] / p.cut.length, 0);
  // Over z, so that a line in the picture is a line in space.
  const corners = p.cut.map((c) => ({ at: toScreen(c), over: [1 / c[2], ...c.map((v) => v / c[2])] }));
  const low = Math.max(0, Math.floor(Math.min(...corners.map((c) => c.at[1]))));
  const high = Math.min(height - 1, Math.ceil(Math.max(...corners.map((c) => c.at[1]))));
  for (let y = low; y <= high; ++y) {
    const sy = y + 0.5;
    const ends = [];
    corners.forEach((a, i) => {
      const b = corners[(i + 1) % corners.length];
      if ((a.at[1] <= sy) === (b.at[1] <= sy)) return;
      const t = (sy - a.at[1]) / (b.at[1] - a.at[1]);
      ends.push({ x: a.at[0] + t * (b.at[0] - a.at[0]), over: a.over.map((v, c) => v + t * (b.over[c] - v)) });
    });
    if (ends.length < 2) continue;
    ends.sort((a, b) => a.x - b.x);
    const [l, r] = [ends[0], ends[ends.length - 1]];
    for (let x = Math.max(0, Math.ceil(l.x - 0.5)); x < width && x + 0.5 < r.x; ++x) {
      const t = (x + 0.5 - l.x) / (r.x - l.x);
      const z = 1 / (l.over[0] + t * (r.over[0] - l.over[0]));
      const stored = wrong('depth-of-polygon') ? mean : z;
      const at = y * width + x;
      if (!wrong('no-test') && (wrong('farther-wins') ? stored <= zBuffer[at] : stored >= zBuffer[at])) continue;
      zBuffer[at] = stored;
      const values = l.over.slice(1).map((v, c) => z * (v + t * (r.over[c + 1] - v)));
      pixels[at] = { number, world: values.slice(3, 6), normal: values.slice(6, 9) };
    }
  }
});

// ---- Shading: Blinn's model at each pixel.
const largest = Math.max(...materials.flatMap((m) => m.kd));
const iMax = largest * ambient + lights.reduce((s, l) => s + l.power * (largest + Math.max(...materials.map((m) => m.ks))), 0);
const color = Buffer.alloc(3 * width * height);
const normals = new Float32Array(3 * width * height);
function shade(pixel) {
  const m = materials[polygons[pixel.number].object];
  const n = wrong('mean-left') ? pixel.normal : unit(pixel.normal);
  const v = wrong('view-axis') ? scaled(-1, forward) : unit(sub(eye, pixel.world));
  let sum = scaled(ambient, m.kd);
  for (const light of lights) {
    const nl = dot(n, light.towards);
    const diffuse = wrong('half-lambert') ? (nl + 1) / 2 : Math.max(0, nl);
    const between = add(light.towards, v);
    const nh = dot(n, wrong('h-not-unit') ? scaled(0.5, between) : unit(between));
    let shine = nl > 0 && nh > 0 ? Math.pow(nh, m.n) : 0;
    if (nl > 0 && nh > 0 && wrong('no-power')) shine = nh;
    if (nl > 0 && nh > 0 && wrong('times-shininess')) shine = nh * m.n;
    sum = sum.map((s, c) => s + light.power * (m.kd[c] * diffuse + m.ks * shine));
  }
  return { n, sum };
}
pixels.forEach((pixel, at) => {
  const x = at % width, y = Math.floor(at / width);
  const from = wrong('blocky') ? pixels[(y - y % 4) * width + x - x % 4] : pixel;
  if (pixel) normals.set(shade(pixel).n, 3 * at);
  if (!from) return;
  shade(from).sum.forEach((i, c) => { color[3 * at + c] = Math.round(255 * Math.min(1, Math.max(0, i / iMax))); });
});

// ---- Files.
const out = names[1];
fs.mkdirSync(out, { recursive: true });
const row = (y) => (o.rows === 'bottom-up' ? height - 1 - y : y);
function byRows(array, channels) {
  const turned = new array.constructor(array.length);
  for (let y = 0; y < height; ++y)
    turned.set(array.subarray(row(y) * width * channels, (row(y) + 1) * width * channels), y * width * channels);
  return turned;
}
function npy(name, array, shape) {
  const kind = array instanceof Float32Array ? '<f4' : '<i4';
  let head = `{'descr': '${kind}', 'fortran_order': False, 'shape': (${shape.join(', ')}${shape.length < 2 ? ',' : ''}), }`;
  head += ' '.repeat(63 - (head.length + 10) % 64) + '\n';
  const size = Buffer.from([head.length & 255, head.length >> 8]);
  const bytes = Buffer.from(array.buffer, array.byteOffset, array.byteLength);
  fs.writeFileSync(path.join(out, name + '.npy'), Buffer.concat([Buffer.from('\x93NUMPY\x01\x00', 'latin1'), size, Buffer.from(head), bytes]));
}
const picture = Buffer.alloc(color.length);
for (let y = 0; y < height; ++y) color.copy(picture, 3 * y * width, 3 * row(y) * width, 3 * (row(y) + 1) * width);
fs.writeFileSync(path.join(out, 'color.ppm'), Buffer.concat([Buffer.from(`P6\n${width} ${height}\n255\n`), picture]));
const depth = Float32Array.from(zBuffer, (z, at) => (pixels[at] ? near / z : 0));
npy('depth', byRows(depth, 1), [height, width]);
npy('normal', byRows(normals, 3), [height, width, 3]);
npy('vertices.world', Float32Array.from(vertices.flatMap((v) => v.world)), [vertices.length, 3]);
npy('vertices.view', Float32Array.from(vertices.flatMap((v) => v.view)), [vertices.length, 3]);
npy('vertices.screen', Float32Array.from(vertices.flatMap((v) => (v.view[2] > 1e-6 ? [...toScreen(v.view), 0] : [-1e30, -1e30, 0]))), [vertices.length, 3]);
npy('vertices.normal', Float32Array.from(vertices.flatMap((v) => v.normal)), [vertices.length, 3]);
npy('polygons.normal', Float32Array.from(polygons.flatMap((p) => p.normal)), [polygons.length, 3]);
npy('polygons.visible', Int32Array.from(polygons, (p) => Number(p.visible)), [polygons.length]);
npy('polygon_id', byRows(Int32Array.from(pixels, (p) => (p ? p.number : -1)), 1), [height, width]);
