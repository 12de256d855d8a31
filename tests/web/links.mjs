// Links made by a grammar with hostile parts: 100,000 of them are read, and written again, by the page's own script. None throws;
// nothing comes out of them that is no place, key or value of the table, and nothing longer than a link may be.
import fs from 'node:fs';
import { expect } from './claims.mjs';

const script = fs.readFileSync(new URL('../../app/web/page/link.js', import.meta.url), 'utf8');
const { readLink, writeLink, kPlaces, kMostLink, kMostValues } = new Function(`'use strict'; ${script}; return { readLink, writeLink, kPlaces, kMostLink, kMostValues };`)();

let state = 20260;
/** Numerical Recipes' generator. @param {number} most */
const random = most => (state = Math.imul(state, 1664525) + 1013904223 >>> 0) / 2 ** 32 * most | 0;
const oneOf = list => list[random(list.length)];
const places = Object.keys(kPlaces), keys = [...new Set(Object.values(kPlaces).flat())];
const hostile = ['<img src=x onerror=alert(1)>', '__proto__', 'constructor', 'hasOwnProperty', '../../etc/passwd', '%', '%E0%A4', '%00', '\u0000', '"', "'", '&amp;', 'javascript:alert(1)', '\u202e', '𝕏', '[object Object]', 'toString', '=', '&', '#', '%26set%3Dx', 'x'.repeat(130), 'NaN', '-1', '99999999999999999999', ''];
const plain = ['pyramid', 'width=320', '150,90', 'z-buffer/polygon=2', 'color,normal', 'shading=flat', '3', '2026.1', 'S10', 'object.#.tessellation=4..64*2', 'depth.rows=bottom-up', 'abc_-9'];
const word = () => (random(3) ? oneOf(plain) : oneOf(hostile));
const key = place => (random(2) && kPlaces[place]?.length ? oneOf(kPlaces[place]) : random(2) ? oneOf(keys) : oneOf(hostile));
const part = place => `${key(place)}${random(8) ? '=' : ''}${random(2) ? encodeURIComponent(word()) : word()}`;
function link() {
  const place = random(5) ? oneOf(places) : oneOf(hostile), parts = Array.from({ length: random(random(20) ? 6 : 90) }, () => part(place));
  return '#' + [`${place}${random(3) ? '=' + oneOf([...plain, word()]) : ''}`, ...parts].join(oneOf(['&', '&', '&', '&&', ';']));
}

const wrong = [];
let read = 0, kept = 0;
for (let i = 0; i < 100000 && wrong.length < 5; ++i) {
  const hash = link();
  try {
    const found = readLink(hash), values = Object.entries(found.of);
    const isKnown = places.includes(found.place) && /^[\w.-]{0,60}$/.test(found.name) && Array.isArray(found.refused) && Object.getPrototypeOf(found.of) === null &&
      values.every(([name, list]) => kPlaces[found.place].includes(name) && list.length <= kMostValues && list.every(value => typeof value === 'string' && /^[\w.,:=+*\- /#]{0,1200}$/.test(value)));
    const { hash: again, leftOut } = writeLink(found.place, found.name, found.of), back = readLink(again);
    const isSame = leftOut > 0 || (back.place === found.place && back.name === found.name && back.refused.length === 0 && JSON.stringify(back.of, Object.keys(back.of).sort()) === JSON.stringify(found.of, Object.keys(found.of).sort()));
    if (!isKnown || again.length > kMostLink || !isSame) wrong.push([hash, found, again]);
    ++read, kept += values.length > 0 ? 1 : 0;
  } catch (error) {
    wrong.push([hash, error.message]);
  }
}
expect('every link is read without an exception, holds what the table has, and is written as it was read', wrong.length === 0 && read === 100000, wrong);
expect('most are not refused whole', kept > 20000, kept);
expect('no prototype was changed', Object.keys(Object.prototype).length === 0 && {}.set === undefined);
