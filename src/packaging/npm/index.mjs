// SPDX-License-Identifier: GPL-3.0-or-later
// render() as a function; index.d.ts describes it.
import { fileURLToPath } from "node:url";
import { Worker } from "node:worker_threads";

const stackMegabytes = 400;

export class SceneError extends Error {
    constructor(messages, status) {
        super(messages.trim());
        this.name = "SceneError";
        this.status = status;
    }
}

export function render(scene, { width, height, options = [], files = {}, signal } = {}) {
    const words = [];
    if (width !== undefined) words.push(`+W${width}`);
    if (height !== undefined) words.push(`+H${height}`);
    words.push("--progress", "none", ...options);
    return new Promise((resolve, reject) => {
        signal?.throwIfAborted();
        const worker = new Worker(new URL("lib/memory.mjs", import.meta.url), {
            workerData: { scene, words, files, stackBytes: stackMegabytes << 20,
                          library: fileURLToPath(new URL("stdlib", import.meta.url)) },
            resourceLimits: { stackSizeMb: stackMegabytes, maxOldGenerationSizeMb: 4096 },
        });
        const abort = () => { worker.terminate(); reject(signal.reason); };
        signal?.addEventListener("abort", abort, { once: true });
        worker.on("message", ({ status, messages, picture }) => {
            if (picture) resolve({ picture, messages });
            else reject(new SceneError(messages, status));
        });
        worker.on("error", reject);
        worker.on("exit", () => {
            signal?.removeEventListener("abort", abort);
            reject(new SceneError("the renderer ended without a picture", 3));
        });
    });
}
