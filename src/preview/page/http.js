// SPDX-License-Identifier: GPL-3.0-or-later
// The program behind the preview's page, by HTTP.
const token = document.querySelector("meta[name=token]").content;

async function ask(path) {
  return (await fetch(path)).text();
}

async function post(path, form) {
  const answer = await fetch(path, { method: "POST", headers: { "X-Token": token },
                                     body: new URLSearchParams(form) });
  if (answer.status === 403) location.reload();  // the program has been started again
  return answer;
}

// The name of files that are saved.
const sceneName = () => element("scene").textContent.replace(/\.\w+$/, "");
