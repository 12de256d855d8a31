// A core beside the page, in a worker: long work that can be stopped. stop() ends the worker and starts another from the
// compiled module; nothing else can stop a core.

class Side {
  /** @param {WebAssembly.Module} module @param {(what: string, done: number, all: number) => void} progress */
  constructor(module, progress) {
    this.module = module, this.progress = progress;
    /** @type {Map<number, {done: (answers: any[]) => void, failed: (error: Error) => void}>} */
    this.waiting = new Map();
    this.number = 0;
    this.begin();
  }
  begin() {
    const text = `const decoder = new TextDecoder(), encoder = new TextEncoder();\n${Core}\nlet core;
      Core.progress = (what, done, all) => postMessage({ what, done, all });
      onmessage = async ({ data }) => {
        try {
          if (data.module) core = await Core.of(data.module);
          const answers = [];
          for (const [name, ...values] of data.calls) {
            const done = core.call(name, ...values), text = core.text();
            if (!done && name !== 'frame') throw new Error(JSON.parse(text).errors.map(error => error.text).join('\\n'));
            const picture = name === 'verdict_picture' ? JSON.parse(text) : null;
            answers.push(picture ? { width: picture.width, height: picture.height, rgba: new Uint8ClampedArray(core.memory.slice(picture.pixels, picture.pixels + 4 * picture.width * picture.height)) } : text);
          }
          postMessage({ number: data.number, answers });
        } catch (error) { postMessage({ number: data.number, error: error.message, isTrap: error instanceof WebAssembly.RuntimeError || error instanceof RangeError }); }
      };`;
    const url = URL.createObjectURL(new Blob([text], { type: 'text/javascript' }));
    this.worker = new Worker(url);
    URL.revokeObjectURL(url);
    this.isNew = true;
    this.worker.onmessage = ({ data }) => {
      if (data.what) return this.progress(data.what, data.done, data.all);
      const { done, failed } = this.waiting.get(data.number);
      this.waiting.delete(data.number);
      if (data.answers) return done(data.answers);
      if (data.isTrap) this.stop();  // its memory is of no use any more
      failed(Object.assign(new Error(data.error), { isTrap: data.isTrap }));
    };
    this.worker.onerror = event => this.end(new Error(event.message));
  }
  /** @param {...any[]} calls each a call's name and its values @returns {Promise<any[]>} answers as text; pictures with their pixels */
  ask(...calls) {
    const number = ++this.number, module = this.isNew ? this.module : undefined;
    this.isNew = false;
    this.worker.postMessage({ number, module, calls });
    return new Promise((done, failed) => this.waiting.set(number, { done, failed }));
  }
  stop() {
    this.worker.terminate();
    this.end(Object.assign(new Error('stopped'), { isStopped: true }));
    this.begin();
  }
  /** @param {Error} error */
  end(error) {
    for (const { failed } of this.waiting.values()) failed(error);
    this.waiting.clear();
  }
}
