// What every script here does: it counts the claims that hold, prints those that do not, and has a folder while it runs.
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';

export const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'shadescope-web-'));
let held = 0, failed = 0;

/** @param {string} claim @param {any} isTrue @param {any} [found] what there is instead */
export function expect(claim, isTrue, found = '') {
  if (isTrue) return void ++held;
  ++failed;
  console.log(`FAILED: ${claim}${found === '' ? '' : ': ' + (typeof found === 'string' ? found : JSON.stringify(found))}`);
}

/** Ends the script, whose claims nobody can ask here. @param {string} why */
export function leaveOut(why) {
  console.log('Left out: ' + why);
  process.exit(77);
}

process.on('exit', status => {
  fs.rmSync(folder, { recursive: true, force: true, maxRetries: 5 });
  if (status === 77) return;
  console.log(`${held} claims hold, ${failed} do not`);
  if (failed > 0 || held === 0) process.exitCode = 1;
});
