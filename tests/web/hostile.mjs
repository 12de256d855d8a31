// Hand-ins that mean harm, or are broken, for lambert(kd, I, N, L): the lines of the body, or a whole text. said: what the page has to
// say, where more than one thing would be right by chance.

const body = lines => `function lambert(kd, I, N, L) {\n${lines}\n}`;
const kRight = 'return kd * I * max(0, dot(N, L));';

/** @type {Record<string, {text: string, said: RegExp}>} */
export const hostile = {
  'endless loop': { text: body('  let i = 0;\n  while (true) {\n    i = i + 1;\n  }'), said: /Line 3 was still running/ },
  'endless for, empty': { text: body('  for (;;);'), said: /Line 2 was still running/ },
  'endless loop outside of the function': { text: 'for (;;);\n' + body(kRight), said: /Line 1 was still running/ },
  'endless recursion': { text: body('  return lambert(kd, I, N, L);'), said: /calls itself without end/ },
  'recursion that branches': { text: body('  const f = n => (n < 2 ? n : f(n - 1) + f(n - 2));\n  return kd * f(60);'), said: /Line 2 was still running/ },
  'slow regular expression': { text: body("  return /^(a+)+$/.test('a'.repeat(60) + '!');"), said: /Not run/ },
  'endless sort': { text: body('  return [3, 1, 2].sort(() => { for (;;) {} });'), said: /Line 2 was still running/ },
  'memory, lists': { text: body('  const a = [];\n  for (;;) a.push([1, 2, 3]);'), said: /differ|still running/ },
  'memory, doubling': { text: body('  let a = [1];\n  for (;;) a = [...a, ...a];'), said: /differ|still running/ },
  'memory, copies': { text: body('  const a = [];\n  for (;;) a.push(a.slice());'), said: /differ|still running/ },
  'memory, a far index': { text: body('  const a = [];\n  a[4000000000] = 1;\n  return a;'), said: /differ/ },
  'memory, new': { text: body('  const a = [];\n  for (;;) a.push(new Array(1000000).fill(1.5));'), said: /new is not there|fill is not there/ },
  'fetch': { text: body("  return fetch('https://example.org/' + kd[0]);"), said: /there is no fetch here/ },
  'self': { text: body('  return self;'), said: /there is no self here/ },
  'globalThis': { text: body('  return globalThis;'), said: /there is no globalThis here/ },
  'XMLHttpRequest': { text: body('  return new XMLHttpRequest();'), said: /Not run/ },
  'import()': { text: body("  return import('https://example.org/x.js');"), said: /import is not there/ },
  'importScripts': { text: body("  return importScripts('https://example.org/x.js');"), said: /there is no importScripts here/ },
  'a worker of its own': { text: body("  return new Worker('data:text/javascript,for(;;);');"), said: /Not run/ },
  'eval': { text: body("  return eval('1 + 1');"), said: /there is no eval here/ },
  'constructor by its name': { text: body('  return lambert.constructor(1)();'), said: /\.constructor is not there/ },
  'constructor by an index': { text: body("  return kd['con' + 'structor'];"), said: /a text is not there/ },
  'an index that is a list': { text: body('  const k = [kd];\n  return kd[k];'), said: /differ/ },
  'constructor taken apart': { text: body('  const { constructor } = lambert;\n  return constructor;'), said: /this field is not there/ },
  'a field of a prototype': { text: body('  return { __proto__: kd };'), said: /this field is not there/ },
  'document': { text: body("  return document.body.innerHTML = 'x';"), said: /\.innerHTML is not there/ },
  'postMessage': { text: body('  for (;;) postMessage(1);'), said: /there is no postMessage here/ },
  'a name of the run': { text: body('  return $run(1);'), said: /there is no \$run here/ },
  'a name of the run, declared': { text: body('  const $turns = 1;\n  return kd;'), said: /\$turns cannot be a name/ },
  'changed prototypes': { text: body('  Math.sqrt = () => 0;\n  return kd;'), said: /differ/ },
  'a changed word': { text: body('  dot = () => 1;\n  return kd;'), said: /differ|Stopped|Not run/ },
  'breaking out': { text: "}); self.evil = 1; (function () {", said: /Not run/ },
  'try around an endless loop': { text: body('  for (;;) { try { for (;;); } catch (e) {} }'), said: /try is not there/ },
  'a label': { text: body('  a: for (;;) break a;'), said: /a label is not there/ },
  'markup returned': { text: body("  return '<img src=x onerror=alert(1)>';"), said: /a text is not there/ },
  'markup as a name': { text: body('  return \\u003cimg;'), said: /Not run/ },
  'a function returned': { text: body('  return () => 1;'), said: /differ/ },
  'a circle returned': { text: body('  const a = [];\n  a.push(a);\n  return a;'), said: /differ/ },
  'circles inside': { text: body('  const a = [];\n  a.push(a);\n  return [a, a, a];'), said: /differ/ },
  'an object returned': { text: body('  return { length: 3 };'), said: /differ/ },
  'nothing returned': { text: body('  const c = dot(N, L);'), said: /differ/ },
  'numbers that are none': { text: body('  return [NaN, Infinity, -Infinity];'), said: /differ/ },
  'an unknown name': { text: body('  return kd * I * dott(N, L);'), said: /Line 2, column 19: there is no dott here: do you mean dot\?/ },
  'an unclosed bracket': { text: body('  return kd * (I;'), said: /Line 2, column 17/ },
  'brackets within brackets': { text: body('  return ' + '('.repeat(3000) + '1' + ')'.repeat(3000) + ';'), said: /Not run|differ/ },
  'too long a text': { text: body('  return kd;' + ' '.repeat(10001)), said: /more than 10000 characters/ },
  'another function': { text: 'function lamberd() { return 1; }', said: /there is no function lambert/ },
  'number + truth': { text: body('  return kd + true;'), said: /differ/ },
};

/** Right answers in other styles. */
export const right = {
  'component by component': body('  let c = 0;\n  for (let i = 0; i < 3; i++) { c += N[i] * L[i]; }\n  if (c < 0) c = 0;\n  const out = [];\n  for (let k = 0; k < 3; k++) out[k] = kd[k] * I[k] * c;\n  return out;'),
  'lists': body('  const c = N.map((n, i) => n * L[i]).reduce((sum, x) => sum + x, 0);\n  return kd.map((k, i) => (k * I[i] * Math.max(0, c)));'),
  'an arrow': 'const lambert = (kd, I, N, L) => (kd * I * max(0, dot(N, L)));',
};
