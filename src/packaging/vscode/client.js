// SPDX-License-Identifier: GPL-3.0-or-later
// The Language Server Protocol over the streams of a program: requests with answers, and
// notifications both ways. Knows nothing of VS Code, so that it can be tested without.
"use strict";
const { spawn } = require("child_process");

class Client {
  /// `heard(method, parameters)` is told what the server says unasked, `ended()` when it is gone.
  constructor(command, words, heard, ended = () => {}) {
    this.waiting = new Map();
    this.last = 0;
    this.input = Buffer.alloc(0);
    this.heard = heard;
    this.server = spawn(command, words, { stdio: ["pipe", "pipe", "inherit"] });
    this.server.stdin.on("error", () => {});
    this.server.stdout.on("data", data => this.receive(data));
    const end = () => {
      for (const { reject } of this.waiting.values()) reject(new Error(command + " has ended"));
      this.waiting.clear();
      ended();
    };
    this.server.on("error", end);
    this.server.on("exit", end);
  }

  send(message) {
    const body = Buffer.from(JSON.stringify({ jsonrpc: "2.0", ...message }));
    this.server.stdin.write(`Content-Length: ${body.length}\r\n\r\n`);
    this.server.stdin.write(body);
  }

  notify(method, params) {
    this.send({ method, params });
  }

  request(method, params) {
    const id = ++this.last;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      this.send({ id, method, params });
    });
  }

  /// Messages come in pieces of any size.
  receive(data) {
    this.input = Buffer.concat([this.input, data]);
    for (;;) {
      const head = this.input.indexOf("\r\n\r\n");
      if (head < 0) return;
      const length = Number(/Content-Length: *(\d+)/i.exec(this.input.toString("latin1", 0, head))[1]);
      if (this.input.length < head + 4 + length) return;
      const message = JSON.parse(this.input.toString("utf8", head + 4, head + 4 + length));
      this.input = this.input.subarray(head + 4 + length);
      const asked = this.waiting.get(message.id);
      if (message.method) this.heard(message.method, message.params);
      else if (asked) {
        this.waiting.delete(message.id);
        if (message.error) asked.reject(new Error(message.error.message));
        else asked.resolve(message.result);
      }
    }
  }

  async stop() {
    await this.request("shutdown");
    this.notify("exit");
  }
}

module.exports = { Client };
