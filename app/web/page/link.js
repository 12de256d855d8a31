// The state as an address, #PLACE=NAME&KEY=VALUE&…, of at most 2000 characters. What a link names is checked as what is typed: a
// link writes and sends nothing, and runs the core alone.

const kMostLink = 2000, kMostValues = 40;
/** The keys of each place; of a lesson a page, of My renderer the scene, of a scene without a name its text. @type {Record<string, string[]>} */
const kPlaces = {
  start: [],
  scene: ['toml', 'set', 'at', 'step', 'show', 'with'],
  lesson: ['page', 'then', 'inside', 'set', 'at', 'step', 'show', 'with'],
  mine: ['scene', 'hints', 'convention', 'set', 'show', 'at'],
  bug: ['seed'],
  check: ['case'],
  study: ['set', 'sweep'],
};
const kMostPacked = 1200;  // of a scene's text

/** @typedef {{place: string, name: string, of: Record<string, string[]>, refused: string[]}} Link */

/** @param {string} hash @returns {Link} an unknown place is the start; parts that do not fit are in `refused` */
function readLink(hash) {
  /** @type {Link} */
  const link = { place: 'start', name: '', of: Object.create(null), refused: [] };
  if (hash.length > kMostLink) return { ...link, refused: ['a link of more than 2000 characters'] };
  const parts = hash.replace(/^#/, '').split('&').filter(part => part !== '');
  parts.forEach((part, i) => {
    const [, key, text = ''] = /^([^=]*)=?(.*)$/s.exec(part) || [];
    let value = null;
    try { value = decodeURIComponent(text); } catch { /* a broken escape */ }
    if (value === null) return void link.refused.push(part);
    if (i === 0) {
      if (!Object.hasOwn(kPlaces, key) || !/^[\w.-]{0,60}$/.test(value)) return void link.refused.push(part);
      link.place = key, link.name = value;
    } else if (!kPlaces[link.place].includes(key) || !(key === 'toml' ? /^[\w-]{1,1200}$/ : /^[\w.,:=+*\- /#]{0,120}$/).test(value) || (link.of[key] ??= []).length >= kMostValues) link.refused.push(part);
    else link.of[key].push(value);
  });
  return link;
}

/** @param {string} place @param {string} name @param {Record<string, string[]>} of
 * @returns {{hash: string, leftOut: number}} leftOut: values for which there was no room */
function writeLink(place, name, of) {
  const plain = text => encodeURIComponent(text).replace(/%2C/g, ',').replace(/%3D/g, '=').replace(/%3A/g, ':').replace(/%2F/g, '/');
  let hash = '#' + place + (name ? '=' + plain(name) : ''), leftOut = 0;
  for (const key of kPlaces[place])
    for (const [i, value] of (of[key] || []).entries()) {
      const part = `&${key}=${plain(value)}`;
      if (i < kMostValues && hash.length + part.length <= kMostLink) hash += part;
      else ++leftOut;
    }
  return { hash, leftOut };
}

/** @param {Uint8Array} bytes @param {'CompressionStream'|'DecompressionStream'} way @param {number} [most] bytes @returns {Promise<Uint8Array>} */
async function throughStream(bytes, way, most = Infinity) {
  const reader = new Blob([bytes]).stream().pipeThrough(new (/** @type {any} */ (globalThis)[way])('deflate-raw')).getReader(), parts = [];
  let size = 0;
  for (let part = await reader.read(); !part.done; part = await reader.read()) {
    parts.push(part.value), size += part.value.length;
    if (size > most) throw new Error('The scene in the link is too long.');
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}
/** A text for a link (RFC 1951, then base64url); empty where it would be too long. @param {string} text */
async function packedText(text) {
  const packed = await throughStream(encoder.encode(text), 'CompressionStream');
  const letters = btoa(String.fromCharCode(...packed.subarray(0, kMostPacked))).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
  return packed.length <= kMostPacked && letters.length <= kMostPacked ? letters : '';
}
/** @param {string} letters @returns {Promise<string>} */
async function unpackedText(letters) {
  let bytes;
  try { bytes = Uint8Array.from(atob(letters.replace(/-/g, '+').replace(/_/g, '/')), letter => letter.charCodeAt(0)); } catch { throw new Error('The scene in the link is damaged.'); }
  return decoder.decode(await throughStream(bytes, 'DecompressionStream', 100000).catch(error => { throw /too long/.test(error.message) ? error : new Error('The scene in the link is damaged.'); }));
}

/** What is shown now. @param {string} [toml] the packed text of a scene that is the reader's own */
function linkNow(toml = '') {
  const { place } = document.documentElement.dataset;
  const at = pixel => (pixel ? [pixel.join(',')] : []);
  if (place === 'mine') {
    const own = mine.scene && Object.hasOwn(whole.scenes, mine.scene.name);
    return writeLink('mine', '', { scene: own ? [mine.scene.name] : [], hints: mine.most < 3 ? [String(mine.most)] : [], convention: Object.entries(mine.stated).map(([key, value]) => `${key}=${value}`), set: mine.settings, show: mine.shown ? [mine.shown] : [], at: at(mine.pixel) });
  }
  if (place === 'bug') return writeLink('bug', '', { seed: [`${game.seed}.${game.number}`] });
  if (place === 'check') return writeLink('check', '', { case: cases.shown ? [cases.shown] : [] });
  const changed = () => Object.keys(view.own).map(key => `${key}=${settingOf(key).text}`);
  if (place === 'study') return writeLink('study', data.isScene ? data.link : '', { set: changed(), sweep: sweepsAsked() });
  if (place !== 'scene') return { hash: '#start', leftOut: 0 };
  const kind = data.isScene ? 'scene' : 'lesson';
  return writeLink(kind, data.link, {
    toml: toml ? [toml] : [], page: [String(view.page + 1)], then: view.then ? ['1'] : [], inside: view.inside ? ['1'] : [],
    set: changed(), at: at(view.pixel), step: view.step ? [view.step.place] : [],
    show: view.inside ? [view.pictures.map(shown => shown.buffer).join(',')] : [], with: view.compare ? [view.compare] : [],
  });
}

/** The rest of a link to a scene or lesson that is open. @param {Record<string, string[]>} of @returns {string[]} what does not fit */
function restore(of) {
  /** @type {string[]} */
  const refused = [];
  /** @param {string} part @param {() => void} work */
  const attempt = (part, work) => { try { work(); } catch (error) { refused.push(`${part}: ${error.message}`); } };
  for (const text of of.set || []) attempt(text, () => {
    const key = text.split('=')[0], before = settingOf(key);
    if (!before) throw new Error('no such setting');
    core.ask('set', text);
    if (!(key in view.own)) view.own[key] = before.text;
  });
  const names = (of.show?.[0] || '').split(',').filter(name => name).slice(0, 2);
  names.forEach((name, i) => {
    if (buffers.some(buffer => buffer.name === name)) view.pictures[i] = { buffer: name, channel: -1, range: null };
    else refused.push(`show=${name}: no such buffer`);
  });
  if (of.with) attempt(`with=${of.with[0]}`, () => { core.ask('compare', of.with[0]), view.compare = of.with[0]; });
  readValues();
  runFrame();
  view.part = view.fit = partDrawn();
  const [x, y] = (of.at?.[0] || '').split(',').map(Number), [width, height] = pictureSize();
  if (of.at && Number.isInteger(x) && Number.isInteger(y) && x >= 0 && y >= 0 && x < width && y < height) view.pixel = [x, y];
  else if (of.at) refused.push(`at=${of.at[0]}: no such pixel`);
  if (of.step) attempt(`step=${of.step[0]}`, () => {
    const made = core.ask('step', view.level, 0, of.step[0]);
    view.step = made.last ? null : made;
  });
  draw();
  return refused;
}
