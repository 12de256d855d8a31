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
        const steps = await page.run(`(() => { const key = settings.find(s => s.key.endsWith('.n') && !s.idle)?.key || 'light.0.intensity', times = [];
          for (let i = 0; i < 30; ++i) { const began = performance.now(); setSetting(key, String(3 + i % 20)); times.push(performance.now() - began); } return times; })()`);
        const frames = await page.run('Array.from({ length: 9 }, () => core.calls.frame(1))');
        console.log(`  first picture ${middle(painted)} ms (budget 1000); a slider's step, all drawn anew ${middle(steps).toFixed(1)} ms (budget 16, for pyramid); a whole frame ${middle(frames).toFixed(1)} ms; memory ${megabytes(await page.run('core.memory.byteLength'))} (budget 128)`);
      }
      await page.close();
    }
  }
  const page = await browser.open(lesson);
  for (let i = 0; i < (await page.run('data.pages')); ++i) await page.run(`openPage(${i})`);
  console.log(`all pages of the lesson: memory ${megabytes(await page.run('core.memory.byteLength'))}`);
} finally {
  await browser.close();
  fs.rmSync(folder, { recursive: true, force: true });
}
