// SPDX-License-Identifier: GPL-3.0-or-later
// The program's preview for a page of the editor: it is started on any free port of this machine,
// and asked for its picture whenever there is a new one. Knows nothing of VS Code.
"use strict";
const { spawn } = require("child_process");
const http = require("http");
const path = require("path");

const pause = 300;  // milliseconds between two questions

class Preview {
  /// `shown({ png, line, progress, errors })` is told of each change; png is a Buffer, and null
  /// where the picture is the same as before. `ended(reason)` is told once when the program is gone.
  constructor(program, scene, shown, ended = () => {}) {
    this.shown = shown;
    this.port = 0;
    this.pictures = 0;
    this.last = "";
    this.said = "";
    this.stopped = false;
    this.process = spawn(program, ["+I./" + path.basename(scene), "--preview", "0"],
                         { cwd: path.dirname(scene), stdio: ["ignore", "ignore", "pipe"] });
    this.process.stderr.on("data", data => this.hear(data));
    const end = () => {
      if (!this.stopped) ended(this.said);
      this.stop();
    };
    this.process.on("error", end);
    this.process.on("exit", end);
  }

  get address() {
    return `http://localhost:${this.port}/`;
  }

  /// The program says once where it can be asked.
  hear(data) {
    this.said = (this.said + data).slice(-4000);
    const place = /^preview: http:\/\/localhost:(\d+)\/$/m.exec(this.said);
    if (this.port || !place) return;
    this.port = Number(place[1]);
    this.look();
  }

  get(page) {
    return new Promise((resolve, reject) => {
      http.get(this.address + page, answer => {
        const parts = [];
        answer.on("data", part => parts.push(part));
        answer.on("end", () => resolve(Buffer.concat(parts)));
        answer.on("error", reject);
      }).on("error", reject);
    });
  }

  async look() {
    try {
      const { picture, line, progress, errors } = JSON.parse((await this.get("status")).toString());
      const state = JSON.stringify([picture, line, progress, errors]);
      const png = picture !== this.pictures ? await this.get("picture.png") : null;
      if (state !== this.last && !this.stopped) this.shown({ png, line, progress, errors });
      this.pictures = picture;
      this.last = state;
    } catch {
      // The program may be busy, or at its end, which is told in another way.
    }
    if (!this.stopped) this.timer = setTimeout(() => this.look(), pause);
  }

  stop() {
    this.stopped = true;
    clearTimeout(this.timer);
    this.process.kill();
  }
}

module.exports = { Preview };
