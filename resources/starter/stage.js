// @FUNCTION@: @RESULT@.
@MEANINGS@
// Complete the function, then: shadescope stage @FUNCTION@ pyramid --with "node @FILE@"
const { sqrt, sin, cos, min, max, pow, abs, floor, round } = Math;
const radians = degrees => degrees * Math.PI / 180;
const add = (a, b) => a.map((x, i) => x + b[i]), sub = (a, b) => a.map((x, i) => x - b[i]);
const times = (k, a) => a.map(x => k * x), dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const length = a => sqrt(dot(a, a));
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

function @FUNCTION@(@PARAMETERS@) {
  // @HINT@
  return @ZERO@;
}

// Reads the calls and prints the results. Nothing to change from here on.
const words = require('fs').readFileSync(0, 'utf8').split(/\s+/);
let at = 0;
const next = () => Number(words[at++]);
const one = { Number: next, Point: () => [next(), next()], Vector: () => [next(), next(), next()] };
const value = kind => one[kind] ? one[kind]() : Array.from({ length: next() }, one[kind.slice(0, -1)]);
const name = words[at++], rows = next();
++at;
const lines = [`${name} ${rows} @COLUMNS@`];
for (let row = 0; row < rows; ++row)
  lines.push([@FUNCTION@(...[@KINDS@].map(value))].flat().map(Number).join(' '));
console.log(lines.join('\n'));
