// Sizes, times and memory of live pages in Chromium, printed. Arguments: the program, and the core.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { launch } from './browser.mjs';

const [program, core] = process.argv.slice(2);
const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'shadescope-live-'));
const browser = await launch();
const middle = list => list.sort((a, b) => a - b)[list.length >> 1];
const megabytes = bytes => (bytes / 2 ** 20).toFixed(1) + ' MB';
try {
  console.log(`core, packed: ${(fs.statSync(core).size / 1000).toFixed(0)} kB`);
  const make = (name, ...args) => {
    const file = path.join(folder, name + '.html');
    execFileSync(program, [...args, '--live', '-o', file], { stdio: ['ignore', 'ignore', 'inherit'] });
    console.log(`${name}: ${(fs.statSync(file).size / 1000).toFixed(0)} kB (budget 1600)`);
    return 'file://' + file;
  };
  const lesson = make('pyramid lesson', 'lesson', 'export', 'pyramid');
  for (const scene of ['pyramid', 'z_buffer_phong', 'teapot', 'soft_shadow']) {
    const url = make(scene, 'export', scene), painted = [];
    for (let i = 0; i < 5; ++i) {
      const page = await browser.open(url);
      painted.push(Number(await page.run('document.documentElement.dataset.painted')));
      if (i === 4) {
        // Of a step the page's own work with the layout that it makes; where the frame runs in the worker, what the page
        // stands still for, and when the picture is there.
        const [steps, stills] = await page.run(`(async () => { const key = settings.find(s => s.key.endsWith('.n') && !s.idle)?.key || 'light.0.intensity', times = [], stills = [];
          for (let i = 0; i < 30; ++i) {
            const began = performance.now(), done = setSetting(key, String(3 + i % 20));
            document.body.offsetHeight;
            stills.push(performance.now() - began);
            await done;
            document.body.offsetHeight;
            times.push(performance.now() - began);
          }
          return [times, stills]; })()`);
        const memory = await page.run('core.memory.byteLength'), frames = await page.run('Array.from({ length: 9 }, () => core.calls.frame(1))');
        const range = list => `${middle(list).toFixed(1)} ms, at best ${Math.min(...list).toFixed(1)}`;
        console.log(`  first picture ${middle(painted)} ms (budget 1000); a slider's step, all drawn anew ${range(steps)} (budget 16, for pyramid)${await page.run('isLong') ? `, of which the page stands still for ${range(stills)}` : ''}; a whole frame ${range(frames)}; memory ${megabytes(memory)} (budget 128)`);
      }
      await page.close();
    }
  }
  // What a hand waits for: a step of the first hold of each first page with all that follows it, and its frame alone, up to
  // where the page stands in it; there and back interleaved. In CPU time of the page's thread: the machine may be shared.
  for (const { name } of JSON.parse(execFileSync(program, ['lesson', 'list', '--json'], { encoding: 'utf8' }))) {
    const held = await browser.open(make(name + ' lesson', 'lesson', 'export', name) + '?page=1'), hold = await held.run('held.holds[0]?.name');
    const kSteps = 10, best = { step: Infinity, set: Infinity, both: Infinity };
    const works = { step: 'isLong = false, putHand(to), document.body.offsetHeight', set: 'core.ask("set", to)', both: 'core.ask("set", to), core.call("frame", 0), goToPlace()' };
    for (let round = 0; hold && round < 8; ++round)
      for (const [part, work] of Object.entries(works)) {
        const before = await held.metrics();
        await held.ask('Runtime.evaluate', { expression: `(places => { for (let i = 0; i < ${kSteps}; ++i) { const to = places[i % 2]; ${work}; } })([core.ask('nudge', 0, 1, 1, 1), held.holds[0].own])` });
        best[part] = Math.min(best[part], 1000 * ((await held.metrics()).TaskDuration - before.TaskDuration) / kSteps);
      }
    const frame = best.both - best.set;
    console.log(hold ? `  a step of ${hold}: ${best.step.toFixed(1)} ms, its frame alone ${frame.toFixed(1)} ms, ratio ${(best.step / frame).toFixed(2)} (budget 2.5)` : '  nothing is held on its first page');
    await held.close();
  }
  const page = await browser.open(lesson);
  for (let i = 0; i < (await page.run('data.pages')); ++i) await page.run(`openPage(${i})`);
  console.log(`all pages of the lesson: memory ${megabytes(await page.run('core.memory.byteLength'))}`);
} finally {
  await browser.close();
  fs.rmSync(folder, { recursive: true, force: true });
}
