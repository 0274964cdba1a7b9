// SPDX-License-Identifier: GPL-3.0-or-later
// The server of the page says when it has another one, which is loaded at the same frame.
async function watch() {
  for (;;) {
    try {
      const answer = await fetch("changed?since=" + facts.watched);
      if (answer.ok && Number(await answer.text()) !== facts.watched) break;
    } catch {
      await new Promise(resolve => setTimeout(resolve, 1000));  // nobody answers
    }
  }
  sessionStorage.frame = frame;
  location.reload();
}
watch();
