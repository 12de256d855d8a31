// What a lesson on paper promises, asked of some in Chromium with the network off: they need nothing else, say nothing to the
// console, show every picture, and print without a cut figure. Arguments: the program, then lessons.
import { execFileSync } from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';
import { launch } from './browser.mjs';
import { expect, folder } from './claims.mjs';

const [program, ...lessons] = process.argv.slice(2);
// A4 with the browser's own margins of 1 cm, at 96 dots per inch.
const paper = { width: Math.round(19 / 2.54 * 96), height: Math.round(27.7 / 2.54 * 96) };
const wide = 'document.documentElement.scrollWidth - document.documentElement.clientWidth';

const browser = await launch();
try {
  for (const lesson of lessons) {
    execFileSync(program, ['lesson', 'export', lesson, '-o', folder], { stdio: 'ignore' });
    for (const name of [`${lesson}.html`, `${lesson}-answers.html`]) {
      const url = 'file://' + path.join(folder, name);
      const page = await browser.open(url, { ...paper, ready: 'document.readyState === "complete"' });
      await page.ask('Emulation.setEmulatedMedia', { media: 'print' });
      expect(`${name} asks for nothing but itself`, page.requests.every(one => one === url || one.startsWith('data:')), page.requests);
      expect(`${name} shows all its pictures`, await page.run('[...document.images].every(one => one.naturalWidth > 0)'));
      expect(`${name} describes all its pictures`, await page.run('[...document.images].every(one => one.alt.length > 20)'));
      expect(`${name} is as wide as the paper`, await page.run(wide) <= 0, await page.run(wide));
      // What must stay whole says so, and fits on a sheet: then no sheet ends within it.
      const cut = await page.run(`[...document.querySelectorAll('figure, table, .equation, .question')]
        .filter(one => getComputedStyle(one).breakInside !== 'avoid' || one.getBoundingClientRect().height > ${paper.height})
        .map(one => one.outerHTML.slice(0, 80))`);
      expect(`no sheet ends within a figure of ${name}`, cut.length === 0, cut);
      expect(`${name} is silent`, page.log.length === 0, page.log);
      await page.close();
      const phone = await browser.open(url, { width: 390, height: 844, mobile: true, ready: 'document.readyState === "complete"' });
      expect(`${name} fits a phone`, await phone.run(wide) <= 0, await phone.run(wide));
      await phone.close();
    }
  }
} finally {
  await browser.close();
}
