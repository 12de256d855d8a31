// The core in node, by the page's own loader.
import fs from 'node:fs';
import vm from 'node:vm';
import zlib from 'node:zlib';

const root = new URL('../../', import.meta.url);
export const Core = vm.runInThisContext(fs.readFileSync(new URL('app/web/page/core.js', root), 'utf8') + '\nCore');

/** @param {string} packed the file shadescope_core.wasm.gz */
export const startCore = packed => Core.start(zlib.gunzipSync(fs.readFileSync(packed)));
