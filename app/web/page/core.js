// The pipeline: compiled, started, and asked. Each call gives JSON or throws what the core says is wrong.

/** @typedef {{found: string, expected: string, text: string}} Wrong */

const decoder = new TextDecoder(), encoder = new TextEncoder();

/** What stands in a page as base85 of a gzip file: see base85 in html_text.h. @param {string} base85 @returns {Promise<Uint8Array>} */
async function unpacked(base85) {
  const text = base85.trim(), packed = new Uint8Array(Math.floor(text.length / 5 * 4)), digits = new Uint8Array(128);
  for (let code = 33, digit = 0; code < 127; ++code) if (!'"$&\'<>@\\`'.includes(String.fromCharCode(code))) digits[code] = digit++;
  for (let from = 0, to = 0; from < text.length; from += 5) {
    let four = 0;
    for (let i = from; i < from + 5; ++i) four = 85 * four + (i < text.length ? digits[text.charCodeAt(i)] : 84);
    for (let shift = 24; shift >= 0; shift -= 8) packed[to++] = four >>> shift;
  }
  const stream = new Blob([packed]).stream().pipeThrough(new (/** @type {any} */ (globalThis).DecompressionStream)('gzip'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** The core, from the page or from the file that several pages share. @returns {Promise<Uint8Array>} */
async function unpackedCore() {
  const shared = /** @type {any} */ (globalThis).sharedCore, own = document.getElementById('core');
  if (!shared && !own) throw new Error('The file with the core is not beside this page: copy the whole folder.');
  return unpacked(shared || own.textContent);
}

class Core {
  /**
   * Told of long work.
   * @param {string} what @param {number} done @param {number} all
   */
  static progress(what, done, all) {}
  // Calls that change more than a setting, and what is wanted of a frame.
  static changing = new Set(['file', 'open', 'lesson', 'page', 'check', 'hint', 'show', 'remember', 'step', 'compare', 'write_scene', 'write_results', 'write_judge']);

  /** @param {WebAssembly.Module} module @param {Record<string, any>} calls */
  constructor(module, calls) {
    this.module = module, this.calls = calls;
    this.changes = 0;  // of its state, but for settings and what is wanted
  }

  /** @param {Uint8Array} bytes @returns {Promise<Core>} */
  static async start(bytes) { return Core.of(await WebAssembly.compile(bytes)); }

  /** @param {WebAssembly.Module} module @returns {Promise<Core>} */
  static async of(module) {
    /** @type {WebAssembly.Memory} */
    let memory;
    // What WebAssembly's system interface asks for: a clock, an end, no files, no environment.
    const known = {
      clock_time_get: (id, precision, to) => {
        new DataView(memory.buffer).setBigUint64(to, BigInt(Math.round(performance.now() * 1e6)), true);
        return 0;
      },
      environ_sizes_get: (count, size) => {
        const view = new DataView(memory.buffer);
        view.setUint32(count, 0, true), view.setUint32(size, 0, true);
        return 0;
      },
      progress: (what, size, done, all) => Core.progress(decoder.decode(new Uint8Array(memory.buffer, what >>> 0, size)), done, all),
      proc_exit: code => {
        throw new Error('The core has ended (' + code + '). Reload the page.');
      },
    };
    /** @type {Record<string, any>} */
    const imports = {};
    for (const { module: from, name } of WebAssembly.Module.imports(module))
      (imports[from] ??= {})[name] = known[name] || (() => 52);  // 52: not there
    const calls = (await WebAssembly.instantiate(module, imports)).exports;
    memory = /** @type {WebAssembly.Memory} */ (calls.memory);
    /** @type {any} */ (calls)._initialize();
    return new Core(module, calls);
  }

  /** Becomes the core whose memory this was: that is all the state there is between two calls. @param {ArrayBuffer} memory */
  become(memory) {
    const page = 65536, missing = memory.byteLength - this.memory.byteLength;
    if (missing > 0) this.calls.memory.grow(missing / page);
    new Uint8Array(this.memory).set(new Uint8Array(memory));
  }

  get memory() { return this.calls.memory.buffer; }

  /** Whether a call did what it was asked to; its answer is in text(). @param {string} name @param {...(string|number|Uint8Array)} values */
  call(name, ...values) {
    const held = [];
    const passed = values.flatMap(value => {
      if (typeof value === 'number') return [value];
      const bytes = typeof value === 'string' ? encoder.encode(value) : value, at = this.calls.alloc(bytes.length || 1) >>> 0;
      held.push(at);
      new Uint8Array(this.memory, at, bytes.length).set(bytes);
      return [at, bytes.length];
    });
    if (Core.changing.has(name)) ++this.changes;
    const done = this.calls[name](...passed);
    for (const at of held) this.calls.release(at);
    return done;
  }
  text() { return decoder.decode(new Uint8Array(this.memory, this.calls.text() >>> 0, this.calls.size())); }

  /** @param {string} name @param {...(string|number|Uint8Array)} values @returns {any} */
  ask(name, ...values) {
    const done = this.call(name, ...values), answer = JSON.parse(this.text());
    if (done) return answer;
    /** @type {Wrong[]} */
    const errors = answer.errors;
    throw Object.assign(new Error(errors.map(error => error.text).join('\n')), { errors });
  }

  /** The numbers of a buffer that ask('buffer', …) has found; they are the core's until it is asked again. */
  numbers({ pointer, count, dtype }) {
    const Kind = { float32: Float32Array, float64: Float64Array, int32: Int32Array, uint8: Uint8Array }[dtype];
    return new Kind(this.memory, pointer, count);
  }
}
