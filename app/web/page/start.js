// The page of one lesson, or of one scene.

/** ?page=3 or #3, from 1. */
function firstPage() {
  const asked = parseInt(new URLSearchParams(location.search).get('page') || location.hash.slice(1), 10);
  return asked ? Math.min(data.pages, Math.max(1, asked)) - 1 : 0;
}

async function start() {
  document.documentElement.classList.add('live');  // without scripts the paper stays
  if (new URLSearchParams(location.search).has('projector')) document.documentElement.classList.add('projector');
  checkBrowser();
  const began = performance.now();
  data = JSON.parse(one('#data').textContent);
  core = await Core.start(await unpackedCore());
  takeLesson(data);
  startParts();
  // The address names a page, nothing else.
  addEventListener('hashchange', () => guarded(() => openPage(firstPage())));
  openPage(firstPage());
  requestAnimationFrame(() => {
    const root = document.documentElement;
    root.dataset.ready = '1', root.dataset.began = String(Math.round(began)), root.dataset.painted = String(Math.round(performance.now()));
  });
}
start().catch(sayCannotStart);
