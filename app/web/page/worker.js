// Frames that take long, as those with soft shadows, run beside the page: the core's memory goes to a worker, runs there, and
// comes back as the page's. Meanwhile the page answers from the frame before.

const kLongFrame = 50;  // ms

/** @type {?Worker} */
let helper = null;
/** What the worker is at: the state it was given, and the settings that have moved since. @type {?{changes: number, since: string[]}} */
let running = null;
/** What waits for the frame. @type {{work: () => void, done: () => void}[]} */
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
    setWorking(null);
    throw new Error('The frame could not be computed: ' + event.message);
  });
  return core.module;
}

/** @param {?{changes: number, since: string[]}} work */
function setWorking(work) {
  running = work;
  document.documentElement.classList.toggle('working', work !== null);
  one('main').setAttribute('aria-busy', String(work !== null));
}

/** The frame that the settings now mean, in the worker. */
function sendFrame() {
  wantShown();
  const module = helper ? undefined : startHelper(), memory = core.memory.slice(0);
  setWorking({ changes: core.changes, since: [] });
  /** @type {Worker} */ (helper).postMessage({ module, memory, calls: frameCalls() }, [memory]);
}

/** @param {ArrayBuffer} memory */
function takeFrame(memory) {
  const { changes, since } = running, isOld = changes !== core.changes;
  setWorking(null);
  if (isOld) return afterFrame.length ? sendFrame() : undefined;  // a step was made, say
  core.become(memory);
  for (const assignment of since) core.call('set', assignment);
  const waited = afterFrame;
  afterFrame = [];
  frameIsThere(core.ask('plan').milliseconds);
  for (const { work } of waited) guarded(work);
  for (const { done } of waited) done();
  if (since.length && !running) sendFrame();
}

/** Nobody waits for a frame any more: a page is opened. */
function forgetFrame() {
  for (const { done } of afterFrame) done();
  afterFrame = [];
}
