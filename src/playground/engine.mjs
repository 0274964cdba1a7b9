// SPDX-License-Identifier: GPL-3.0-or-later
// The program in workers of the page. Each worker has a whole instance of it, so nothing is shared
// and no special headers are needed.

export class Engine {
  // `assets`: {compiled, library, makeWorker}.
  constructor(assets) {
    Object.assign(this, { assets, idle: [], busy: new Map(), next: 0 });
    this.idle.push(this.#worker());  // it starts while the page is made
  }

  // Runs the program in a worker of its own; see run() in worker.js. stop(group) ends the runs of a
  // group: their promises are never settled.
  run(job, group) {
    const id = this.next++, worker = this.idle.pop() ?? this.#worker();
    return new Promise(resolve => {
      this.busy.set(id, { worker, group });
      worker.onmessage = ({ data }) => {
        this.busy.delete(id);
        this.idle.push(worker);
        resolve(data);
      };
      worker.onerror = event => {
        this.busy.delete(id);
        worker.terminate();
        resolve({ status: 3, out: "", err: `error: ${event.message}\n`, made: {} });
      };
      worker.postMessage({ id, ...job });
    });
  }

  stop(group) {
    for (const [id, each] of this.busy) {
      if (each.group !== group) continue;
      each.worker.terminate();
      this.busy.delete(id);
    }
  }

  #worker() {
    const { compiled, library, makeWorker } = this.assets, worker = makeWorker();
    worker.postMessage({ compiled, library });
    return worker;
  }
}

// The texts that the program keeps in a PNG file, by keyword.
export function textsOf(png) {
  const texts = {}, view = new DataView(png.buffer, png.byteOffset, png.byteLength), decoder = new TextDecoder();
  for (let at = 8; at + 12 <= png.length;) {
    const length = view.getUint32(at), kind = decoder.decode(png.subarray(at + 4, at + 8));
    const content = png.subarray(at + 8, at + 8 + length), end = content.indexOf(0);
    if (kind === "tEXt" || kind === "iTXt")
      texts[decoder.decode(content.subarray(0, end))] = decoder.decode(content.subarray(end + 1));
    at += 12 + length;
  }
  return texts;
}

// Whether a film needs the whole picture at once, so that it cannot be rendered in bands.
export function needsWhole(png) {
  return /\bglare=on\b|\bauto_exposure|exposure=auto/.test(Object.values(textsOf(png)).join(" "));
}

// `count` bands of rows, each [first, last] from 1. They end at multiples of `step`.
export function bandsOf(height, count, step = 1) {
  const end = i => i === count ? height : Math.floor(height * i / count / step) * step;
  return Array.from({ length: count }, (_, i) => [end(i) + 1, end(i + 1)]).filter(([first, last]) => first <= last);
}
