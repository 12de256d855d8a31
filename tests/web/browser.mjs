// Chromium without a window, driven over its own pipe: no library, no port, no network.
import { spawn } from 'node:child_process';
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';

// When a live page is ready: it has started, or says why it has not.
const kReady = 'document.documentElement.dataset.ready === "1" || !document.querySelector("#wrong").hidden';
// Frames that take long come from a worker, and some work waits for the next picture of the screen: after whatever a script
// does the page is waited for, so that no claim depends on how fast the machine is.
const kSettled = `new Promise(done => {
  const look = () => ((typeof running !== 'undefined' && running) || (typeof waiting !== 'undefined' && waiting.size > 0) ? setTimeout(look, 5) : done());
  look();
})`;

export async function launch(program = process.env.CHROMIUM || 'chromium') {
  const profile = fs.mkdtempSync(path.join(os.tmpdir(), 'shadescope-chromium-'));
  const child = spawn(program, ['--headless=new', '--no-sandbox', '--disable-gpu', '--hide-scrollbars', '--no-first-run',
    '--remote-debugging-pipe', '--user-data-dir=' + profile], { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'] });
  const [to, from] = [/** @type {any} */ (child.stdio[3]), /** @type {any} */ (child.stdio[4])];
  const waiting = new Map(), listeners = [];
  let count = 0, rest = '';
  from.setEncoding('utf8');
  from.on('data', chunk => {
    const messages = (rest + chunk).split('\0');
    rest = messages.pop();
    for (const text of messages) {
      const message = JSON.parse(text), answered = waiting.get(message.id);
      if (!answered) { for (const listener of listeners) listener(message); continue; }
      waiting.delete(message.id);
      if (message.error) answered[1](new Error(message.error.message));
      else answered[0](message.result);
    }
  });
  const send = (method, params = {}, sessionId = undefined) => new Promise((done, failed) => {
    waiting.set(++count, [done, failed]);
    to.write(JSON.stringify({ id: count, method, params, sessionId }) + '\0');
  });

  /** A page at an address, when it is ready. kept: with the answers that the browser has kept of it. online: for a server on this machine. */
  async function open(url, { width = 1280, height = 800, dark = false, mobile = false, scale = 1, scripts = true, ready = kReady, kept = false, online = false } = {}) {
    const { targetId } = await send('Target.createTarget', { url: 'about:blank' });
    const { sessionId } = await send('Target.attachToTarget', { targetId, flatten: true });
    const ask = (method, params = {}) => send(method, params, sessionId);
    const log = [], requests = [];
    listeners.push(message => {
      if (message.sessionId !== sessionId) return;
      if (message.method === 'Network.requestWillBeSent') requests.push(message.params.request.url);
      if (message.method === 'Runtime.exceptionThrown') log.push(message.params.exceptionDetails.exception?.description || message.params.exceptionDetails.text);
      if (message.method === 'Runtime.consoleAPICalled' && message.params.type === 'error') log.push(message.params.args.map(arg => arg.value ?? arg.description).join(' '));
    });
    for (const domain of ['Page', 'Runtime', 'Network']) await ask(domain + '.enable');
    await ask('Performance.enable', { timeDomain: 'threadTicks' });
    await ask('Network.emulateNetworkConditions', { offline: !online, latency: 0, downloadThroughput: -1, uploadThroughput: -1 });
    await ask('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: scale, mobile });
    await ask('Emulation.setEmulatedMedia', { features: [{ name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' }] });
    if (!scripts) await ask('Emulation.setScriptExecutionDisabled', { value: true });
    if (!kept) await ask('Page.addScriptToEvaluateOnNewDocument', { source: 'try { localStorage.clear(); } catch {}' });
    await ask('Page.navigate', { url });
    const evaluate = async expression => {
      const result = await ask('Runtime.evaluate', { expression, awaitPromise: true, returnByValue: true, allowUnsafeEvalBlockedByCSP: false });
      if (result.exceptionDetails) throw new Error(result.exceptionDetails.exception?.description || result.exceptionDetails.text);
      return result.result.value;
    };
    const settle = () => evaluate(kSettled).catch(() => {});  // it may be leaving
    const run = async expression => {
      const value = await evaluate(expression);
      await settle();
      return value;
    };
    /** Asks again until the page says yes. */
    const until = async expression => {
      for (let tries = 0; tries < 18000; ++tries) {
        if (await evaluate(expression).catch(() => false)) return;
        await new Promise(done => setTimeout(done, 10));
      }
      throw new Error(`${expression} does not come true\n${log.join('\n')}`);
    };
    const key = async (name, modifiers = 0) => {
      const codes = { ArrowLeft: 37, ArrowUp: 38, ArrowRight: 39, ArrowDown: 40, Tab: 9, Enter: 13, PageDown: 34, PageUp: 33 };
      const event = { key: name, modifiers, windowsVirtualKeyCode: codes[name] || name.toUpperCase().charCodeAt(0) };
      await ask('Input.dispatchKeyEvent', { type: 'keyDown', ...event, text: name.length === 1 ? name : name === 'Enter' ? '\r' : undefined });
      await ask('Input.dispatchKeyEvent', { type: 'keyUp', ...event });
      await settle();
    };
    const click = async (x, y) => {
      for (const type of ['mousePressed', 'mouseReleased']) await ask('Input.dispatchMouseEvent', { type, x, y, button: 'left', clickCount: 1 });
      await settle();
    };
    /** What the page's thread has done: TaskDuration, its CPU seconds, LayoutCount and others. */
    const metrics = async () => Object.fromEntries((await ask('Performance.getMetrics')).metrics.map(({ name, value }) => [name, value]));
    const shot = async file => {
      const { data } = await ask('Page.captureScreenshot', { format: 'png' });
      fs.writeFileSync(file, Buffer.from(data, 'base64'));
    };
    if (scripts) await until(ready);
    return { ask, run, until, key, click, metrics, shot, log, requests, close: () => send('Target.closeTarget', { targetId }) };
  }

  const close = async () => {
    const ended = new Promise(done => child.once('exit', done));
    await send('Browser.close').catch(() => {});
    child.kill();
    await ended;
    fs.rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
  };
  return { open, close };
}
