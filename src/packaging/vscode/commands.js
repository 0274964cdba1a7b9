// SPDX-License-Identifier: GPL-3.0-or-later
// The commands Render and Preview beside. Rendering is a task of the editor, whose messages become
// problems by the matcher in package.json; the preview is a page beside the text.
"use strict";
const crypto = require("crypto");
const path = require("path");
const vscode = require("vscode");
const { Preview } = require("./preview.js");

/// The path of the scene in front, which is saved first; or nothing, which is said.
async function scene() {
  const editor = vscode.window.activeTextEditor;
  if (!editor || editor.document.languageId !== "pov" || editor.document.uri.scheme !== "file") {
    vscode.window.showWarningMessage("Candelabra: open a scene first");
    return null;
  }
  await editor.document.save();
  return editor.document.uri.fsPath;
}

const picture_of = file => file.replace(/\.[^./\\]*$/, "") + ".png";

/// Renders to a picture of the scene's name beside it, and opens it when that went well.
async function render(program) {
  const file = await scene();
  if (!file) return;
  const words = ["+I./" + path.basename(file), "+O./" + path.basename(picture_of(file))];
  const run = new vscode.ProcessExecution(program, words, { cwd: path.dirname(file) });
  const task = new vscode.Task({ type: "candelabra" }, vscode.TaskScope.Workspace,
                               "Render " + path.basename(file), "candelabra", run, "$candelabra");
  const started = await vscode.tasks.executeTask(task);
  const listener = vscode.tasks.onDidEndTaskProcess(event => {
    if (event.execution !== started) return;
    listener.dispose();
    if (event.exitCode === 0)
      vscode.commands.executeCommand("vscode.open", vscode.Uri.file(picture_of(file)), vscode.ViewColumn.Beside);
  });
}

/// The page shows what it is sent, and fetches nothing itself.
function page(nonce) {
  return `<!DOCTYPE html>
<html><head><meta charset="utf-8">
<meta http-equiv="Content-Security-Policy"
      content="default-src 'none'; img-src data:; style-src 'nonce-${nonce}'; script-src 'nonce-${nonce}'">
<style nonce="${nonce}">
  body { padding: 0.5em; } img { max-width: 100%; } pre { white-space: pre-wrap; } progress { width: 100%; }
</style></head>
<body><img id="picture" alt=""><progress id="progress" max="1" value="0"></progress><p id="line"></p><pre id="errors"></pre>
<script nonce="${nonce}">
  const part = name => document.getElementById(name);
  addEventListener("message", ({ data }) => {
    if (data.png) part("picture").src = "data:image/png;base64," + data.png;
    part("progress").value = data.progress;
    part("line").textContent = data.line;
    part("errors").textContent = data.errors;
  });
</script></body></html>`;
}

async function preview(program) {
  const file = await scene();
  if (!file) return;
  const panel = vscode.window.createWebviewPanel(
    "candelabra.preview", "Preview of " + path.basename(file),
    { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true },
    { enableScripts: true, retainContextWhenHidden: true, localResourceRoots: [] });
  panel.webview.html = page(crypto.randomBytes(16).toString("hex"));
  const send = state => panel.webview.postMessage({ ...state, png: state.png && state.png.toString("base64") });
  const running = new Preview(program, file, send, said =>
    vscode.window.showErrorMessage(`${program} has ended: ${said.trim() || "it cannot be started"}`));
  panel.onDidDispose(() => running.stop());
}

module.exports = { preview, render };
