// The program and the command for Node, as it is packed, side by side.
import { execFileSync, spawnSync } from 'node:child_process';
import path from 'node:path';
import { expect, folder } from './claims.mjs';

/** The first line in which two texts differ. @param {string} a @param {string} b */
function difference(a, b) {
  const [left, right] = [a.split('\n'), b.split('\n')], i = left.findIndex((line, at) => line !== right[at]);
  return `\n  program: ${left[i]}\n  Node:    ${right[i]}`;
}

/** @param {string} program @param {string} tarball */
export function unpack(program, tarball) {
  execFileSync('tar', ['xzf', tarball, '-C', folder]);
  const command = path.join(folder, 'package', 'shadescope.mjs');
  /** Runs both in the same folder; gives what the program says.
   * @param {string} claim @param {string[]} args @param {string} cwd @param {(text: string) => string} [without] times, say */
  const bothSay = (claim, args, cwd, without = text => text) => {
    const [native, node] = [[program, ...args], ['node', command, ...args]].map(([first, ...rest]) =>
      spawnSync(first, rest, { cwd, encoding: 'utf8', maxBuffer: 1 << 28 }));
    const errors = native.stderr.replace(/^compare: .* known errors.*\n/gm, '');  // how far it is
    expect(`${claim}: the same on standard output`, without(native.stdout) === without(node.stdout), difference(without(native.stdout), without(node.stdout)));
    expect(`${claim}: the same errors`, errors === node.stderr, difference(errors, node.stderr));
    expect(`${claim}: the same status`, native.status === node.status, [native.status, node.status]);
    return native;
  };
  return { command, bothSay };
}
