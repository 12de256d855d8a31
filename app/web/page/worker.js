// Frames that take long, as those with soft shadows, run beside the page: the core's memory goes to a worker, runs there, and
// comes back as the page's. Meanwhile the page answers from the frame before.

const kLongFrame = 50;  // ms

/** @type {?Worker} */
let helper = null;
/** @typedef {{work: () => void, done: () => void}} Wait */
/** What the worker is at: the state it was given, the settings that have moved since, and what waits for its frame.
 * @type {?{changes: number, since: string[], waits: Wait[]}} */
let running = null;
/** What waits for the frame after it. @type {Wait[]} */
let afterFrame = [];

function startHelper() {
  const text = `const decoder = new TextDecoder(), encoder = new TextEncoder();\n${Core}\nlet module;
    onmessage = async ({ data }) => {
      module = data.module || module;
      const core = await Core.of(module);
      core.become(data.memory);
      for (const [name, ...values] of data.calls) core.call(name, ...values);
      const memory = core.memory.slice(0);
      postMessage(memory, [memory]);
    };
    onunhandledrejection = ({ reason }) => { throw reason; };`;
  const url = URL.createObjectURL(new Blob([text], { type: 'text/javascript' }));
  helper = new Worker(url);
  URL.revokeObjectURL(url);
  helper.onmessage = ({ data }) => guarded(() => takeFrame(data));
  helper.onerror = event => guarded(() => {
    helper?.terminate(), helper = null;
    forgetFrame(), setWorking(null);
    throw new Error('The frame could not be computed: ' + event.message);
  });
  return core.module;
}

/** @param {typeof running} work */
function setWorking(work) {
  running = work;
  document.documentElement.classList.toggle('working', work !== null);
  one('main').setAttribute('aria-busy', String(work !== null));
}

/** The frame that the settings now mean, in the worker. */
function sendFrame() {
  wantShown();
  const module = helper ? undefined : startHelper(), memory = core.memory.slice(0);
  setWorking({ changes: core.changes, since: [], waits: afterFrame });
  afterFrame = [];
  /** @type {Worker} */ (helper).postMessage({ module, memory, calls: frameCalls() }, [memory]);
}

/** @param {ArrayBuffer} memory */
function takeFrame(memory) {
  const { changes, since, waits } = running;
  setWorking(null);
  if (changes !== core.changes) {  // a step was made, say
    afterFrame = [...waits, ...afterFrame];
    return afterFrame.length ? sendFrame() : undefined;
  }
  core.become(memory);
  for (const assignment of since) core.call('set', assignment);
  frameIsThere(core.ask('plan').milliseconds);
  for (const { work } of waits) guarded(work);
  for (const { done } of waits) done();
  if ((since.length || afterFrame.length) && !running) sendFrame();
}

/** Nobody waits for a frame any more: a page is opened. */
function forgetFrame() {
  for (const { done } of [...(running?.waits || []), ...afterFrame]) done();
  afterFrame = [];
  if (running) running.waits = [];
}
