// Files that the reader brings: by a drop, a choice, or a folder that is watched. Names and bytes; nothing leaves the page.

/** @typedef {{path: string, bytes: Uint8Array, stamp: string}} Brought */
/** @typedef {{name: string, folder: any, list: Brought[]}} Drop */
const kMostFiles = 400, kMostBytes = 256 * 1024 * 1024;

/** Reads files within the limits; one that has its stamp is not read again.
 * @param {{path: string, file: File}[]} offered @param {Map<string, Brought>} [before] @returns {Promise<Brought[]>} */
async function readFiles(offered, before = new Map()) {
  if (offered.length > kMostFiles) throw new Error(`More than ${kMostFiles} files: choose the folder that your renderer writes into.`);
  if (offered.reduce((sum, { file }) => sum + file.size, 0) > kMostBytes)
    throw new Error('More than 256 MB: choose the folder that your renderer writes into.');
  const list = await Promise.all(offered.map(async ({ path, file }) => {
    const stamp = `${path} ${file.size} ${file.lastModified}`, had = before.get(path);
    return had && had.stamp === stamp ? had : { path, stamp, bytes: new Uint8Array(await file.arrayBuffer()) };
  }));
  return list.sort((a, b) => (a.path < b.path ? -1 : 1));
}

/** A folder's own files, not those of folders in it. @param {any} folder @param {Map<string, Brought>} [before] */
async function filesOfFolder(folder, before) {
  const offered = [];
  for await (const entry of folder.values())
    if (entry.kind === 'file' && offered.length <= kMostFiles) offered.push({ path: `${folder.name}/${entry.name}`, file: await entry.getFile() });
  return readFiles(offered, before);
}

/** What was dropped: files by themselves, or a folder, with its handle where the browser gives one.
 * @param {DataTransfer} transfer @returns {Promise<Drop>} */
async function filesOfDrop(transfer) {
  // All are asked for at once: after the first wait the browser has forgotten them.
  const items = [...transfer.items].filter(item => item.kind === 'file');
  const entries = items.map(item => item.webkitGetAsEntry?.()), files = items.map(item => item.getAsFile());
  const handles = await Promise.all(items.map(item => /** @type {any} */ (item).getAsFileSystemHandle?.().catch(() => null)));
  const folder = handles.find(handle => handle?.kind === 'directory');
  if (folder) return { name: folder.name, folder, list: await filesOfFolder(folder) };
  /** @type {{path: string, file: File}[]} */
  const offered = [];
  let name = '';
  for (let i = 0; i < items.length; ++i) {
    const entry = /** @type {any} */ (entries[i]), file = files[i];
    if (!entry?.isDirectory) {
      if (file) offered.push({ path: file.name, file });
      continue;
    }
    name = entry.name;
    const reader = entry.createReader(), some = () => new Promise((done, failed) => reader.readEntries(done, failed));
    for (let found = await some(); found.length && offered.length <= kMostFiles; found = await some())
      for (const each of found.filter(each => each.isFile))
        offered.push({ path: `${name}/${each.name}`, file: await new Promise((done, failed) => each.file(done, failed)) });
  }
  return { name, folder: null, list: await readFiles(offered) };
}

/** What a field for files or for a folder holds. @param {HTMLInputElement} input @returns {Promise<Drop>} */
async function filesOfInput(input) {
  const offered = [...(input.files || [])].map(file => ({ path: file.webkitRelativePath || file.name, file })).filter(({ path }) => path.split('/').length <= 2);
  const list = await readFiles(offered);
  input.value = '';  // the same folder may be chosen again
  return { name: list[0]?.path.includes('/') ? list[0].path.split('/')[0] : '', folder: null, list };
}

/** Tells when a folder's files have changed and rest for one look; one that is being written is read at the next.
 * @param {any} folder @param {Brought[]} list as it was read @param {(list: Brought[]) => void} tell @returns {() => void} ends it */
function watchFolder(folder, list, tell) {
  const stampOf = files => files.map(file => file.stamp).join('\n');
  let known = new Map(list.map(file => [file.path, file])), told = stampOf(list), last = told, isLooking = false;
  const timer = setInterval(async () => {
    if (document.hidden || isLooking) return;
    isLooking = true;
    try {
      const now = await filesOfFolder(folder, known), stamp = stampOf(now);
      known = new Map(now.map(file => [file.path, file]));
      if (stamp === last && stamp !== told) told = stamp, tell(now);
      last = stamp;
    } catch { /* the next look reads it */ }
    isLooking = false;
  }, 500);
  return () => clearInterval(timer);
}

/** A zip of texts, stored as they are (PKWARE's APPNOTE 6.3.9). @param {Record<string, string>} texts @returns {Blob} */
function zipOf(texts) {
  /** @type {Uint8Array[]} */
  const parts = [], directory = [];
  let at = 0;
  const number = (value, size) => Uint8Array.from({ length: size }, (_, i) => value >>> 8 * i & 255);
  const joined = list => Uint8Array.from(list.flatMap(part => [...part]));
  for (const [name, text] of Object.entries(texts)) {
    const bytes = encoder.encode(text), path = encoder.encode(name);
    // Version 2.0, names in UTF-8, stored, 1 January 1980; check sum and sizes.
    const facts = joined([number(20, 2), number(0x800, 2), number(0, 4), number(0x21, 2), number(crc32(bytes), 4), number(bytes.length, 4), number(bytes.length, 4), number(path.length, 2), number(0, 2)]);
    directory.push(joined([number(0x02014b50, 4), number(20, 2), facts, number(0, 10), number(at, 4), path]));
    parts.push(joined([number(0x04034b50, 4), facts, path]), bytes);
    at += 30 + path.length + bytes.length;
  }
  const size = directory.reduce((sum, entry) => sum + entry.length, 0);
  const end = joined([number(0x06054b50, 4), number(0, 4), number(directory.length, 2), number(directory.length, 2), number(size, 4), number(at, 4), number(0, 2)]);
  return new Blob([...parts, ...directory, end], { type: 'application/zip' });
}
/** @param {Uint8Array} bytes */
function crc32(bytes) {
  let sum = ~0;
  for (const byte of bytes) {
    sum ^= byte;
    for (let bit = 0; bit < 8; ++bit) sum = sum >>> 1 ^ (sum & 1 ? 0xEDB88320 : 0);
  }
  return ~sum >>> 0;
}
