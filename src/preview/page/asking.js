// SPDX-License-Identifier: GPL-3.0-or-later
// How panels reach the program: ask(path) is the text of an answer, post(path, form) changes something.
// The preview has both by HTTP (http.js), the playground by its workers (src/playground/back_end.mjs).

// Sends one message at a time: what comes meanwhile is joined to the one that waits.
function sender(path, join = (older, newer) => newer) {
  let waiting = null, busy = false;
  return async form => {
    waiting = waiting ? join(waiting, form) : form;
    if (busy) return;
    busy = true;
    try {
      while (waiting) {
        const next = waiting;
        waiting = null;
        await post(path, next);
      }
    } catch { /* the status says that the program has ended */ }
    busy = false;
  };
}

async function copy(path, name) {
  const text = await ask(path);
  try {
    await navigator.clipboard.writeText(text);
    toast(name + " copied as script");
  } catch {
    element("picked").textContent = text;
    element("panel-pick").open = true;
    toast("The clipboard is closed: the text is in the panel Pixel");
  }
}
