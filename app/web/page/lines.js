// What stands before a student's lines where they run, in a worker or in Node: the given words, what the rewritten lines call,
// and the run itself. Vectors are plain lists of numbers.
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => $list([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]);
const length = a => Math.hypot(...a);
const normalize = a => $div(a, length(a));
const { sqrt, pow, abs, min, max, floor, round, sin, cos, tan } = Math, radians = degrees => degrees * Math.PI / 180;

const kMostTime = 800, kMostNumbers = 1e7, kMostVisits = 2000, kMostIndex = 1e6;  // ms and numbers of new lists, for a call
let $turns = 0, $made = 0, $end = Infinity;
/** @type {?any[]} */
let $visits = null;

const $thing = a => (a === undefined ? 'nothing' : Array.isArray(a) ? 'a vector' : typeof a === 'number' ? 'a number' : typeof a);
// + − * / of numbers and of vectors, component by component.
const $operator = (of, sign) => (a, b) => {
  if (typeof a === 'number' && typeof b === 'number') return of(a, b);
  if (Array.isArray(a) && Array.isArray(b)) {
    if (a.length !== b.length) throw new TypeError(`${a.length} ${sign} ${b.length} numbers`);
    return $list(a.map((x, i) => of(x, b[i])));
  }
  if (Array.isArray(a) && typeof b === 'number') return $list(a.map(x => of(x, b)));
  if (Array.isArray(b) && typeof a === 'number') return $list(b.map(x => of(a, x)));
  throw new TypeError(`${$thing(a)} ${sign} ${$thing(b)}`);
};
const $add = $operator((a, b) => a + b, '+'), $sub = $operator((a, b) => a - b, '−'), $mul = $operator((a, b) => a * b, '*'), $div = $operator((a, b) => a / b, '/');
const $neg = a => (Array.isArray(a) ? $list(a.map(x => -x)) : -a);

/** Each turn of a loop and each call of a function. @param {number} line */
function $turn(line) {
  if ((++$turns & 8191) === 0 && performance.now() > $end) throw Object.assign(new Error(`Line ${line} was still running after ${kMostTime / 1000} s: does its loop end?`), { line, isEndless: true });
}
function $list(list) {
  if (Array.isArray(list) && ($made += list.length) > kMostNumbers) throw new RangeError('the lists have more than 10 million numbers');
  return list;
}
function $push(list, ...values) {
  if (!Array.isArray(list)) throw new TypeError(`push of ${$thing(list)}`);
  $list(values);
  return list.push(...values);
}
function $index(i) {
  if (typeof i !== 'number' || i > kMostIndex) throw new TypeError('an index is a number, at most 1000000');
  return i;
}
const $shown = (value, depth = 0) => (Array.isArray(value) ? depth > 1 || value.length > 16 ? `a list of ${value.length}` : Array.from(value, one => $shown(one, depth + 1))
  : typeof value === 'object' || typeof value === 'function' ? `a ${typeof value}` : value);
const $visit = visit => { if ($visits && $visits.length < kMostVisits) $visits.push(visit); };
const $line = (line, values) => $visit({ line, values: Object.entries(values).slice(0, 12).map(([name, value]) => [name, $shown(value)]) });
const $back = (line, value) => ($visit({ line, returned: $shown(value) }), value);
const $test = (line, value) => ($visit({ line, taken: !!value }), value);
const $compare = (line, a, sign, b) => {
  const value = sign === '<' ? a < b : sign === '<=' ? a <= b : sign === '>' ? a > b : sign === '>=' ? a >= b : sign[0] === '!' ? a !== b : a === b;
  $visit({ line, taken: value, compared: [$shown(a), sign, $shown(b)] });
  return value;
};

// Each browser has words of its own for it.
const $isDeep = error => /stack size|recursion/i.test(error && error.message);
/** Why lines have thrown. */
function $wordsOf(error) {
  if ($isDeep(error)) return 'a function calls itself without end';
  return String(error && error.message || error).slice(0, 200);
}

/** Runs calls one after the other. shape: "3 3* 1 > 3", the counts of numbers of each argument, * where it is a list, and of the
 * result, t where it is true or false. beat: told every 100 ms that calls go on. No number counts as NaN.
 * @param {Function} lines @param {string} shape @param {number} calls @param {Float64Array} numbers @param {() => void} beat */
function $run(lines, shape, calls, numbers, beat) {
  const [taken, given] = shape.split(' > '), shapes = taken.split(' '), isTruth = given === 't', size = isTruth ? 1 : Number(given);
  const out = new Float64Array(calls * size).fill(NaN);
  let at = 0, beaten = performance.now();
  const one = count => (count === 1 ? numbers[at++] : Array.from({ length: count }, () => numbers[at++]));
  const argument = text => (text.endsWith('*') ? Array.from({ length: numbers[at++] }, () => one(parseInt(text, 10))) : one(Number(text)));
  for (let call = 0; call < calls; ++call) {
    const values = shapes.map(argument), now = performance.now();
    $turns = 0, $made = 0, $end = now + kMostTime;
    if (now - beaten > 100) beaten = now, beat();
    try {
      const result = lines(...values), parts = isTruth ? [result === true || result === false ? Number(result) : result] : size === 1 ? [result] : result;
      if (!Array.isArray(parts) || parts.length !== size) continue;
      for (let i = 0; i < size; ++i) if (typeof parts[i] === 'number') out[call * size + i] = parts[i];
    } catch (error) {
      if ($isDeep(error) || (error && error.isEndless)) throw error;
    }
  }
  return out;
}

/** One call with the traced lines: what each line did. @returns {{visits: any[], threw: string, at: number}} */
function $trace(lines, shape, numbers) {
  $visits = [];
  let threw = '', at = 0;
  try {
    $run((...values) => {
      try {
        return lines(...values);
      } catch (error) {
        threw = $wordsOf(error), at = Number(error && error.line) || 0;
        throw error;
      }
    }, shape, 1, numbers, () => {});
  } catch { /* it is in threw */ }
  const visits = $visits;
  $visits = null;
  return { visits, threw, at };
}
