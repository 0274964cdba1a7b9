#!/usr/bin/env node
// SPDX-License-Identifier: GPL-3.0-or-later
// The command line. The program runs in a worker, which can have a large stack, and this thread receives the signals.
import { fileURLToPath } from "node:url";
import { Worker } from "node:worker_threads";

const save = 1, stop = 2;
const stackMegabytes = 400;
// What the signals have asked for, and whether the program listens.
const shared = new Int32Array(new SharedArrayBuffer(8));

const worker = new Worker(new URL("../lib/command.mjs", import.meta.url), {
    workerData: { words: process.argv.slice(2), shared, stackBytes: stackMegabytes << 20,
                  library: fileURLToPath(new URL("../stdlib", import.meta.url)) },
    resourceLimits: { stackSizeMb: stackMegabytes, maxOldGenerationSizeMb: 4096 },
});
worker.on("message", status => { process.exitCode = status; });
worker.on("error", problem => {
    process.stderr.write(`error: ${problem?.message ?? problem}\n`);
    process.exitCode = 3;
});

// The first signal asks the program to stop, while it listens; the next one ends it, as usual.
for (const signal of ["SIGINT", "SIGTERM", "SIGHUP"]) {
    const taken = () => {
        if (Atomics.load(shared, 1) && Atomics.exchange(shared, 0, stop) !== stop) return;
        process.removeListener(signal, taken);
        process.kill(process.pid, signal);
    };
    process.on(signal, taken);
}
if (process.platform !== "win32")
    process.on("SIGUSR1", () => { if (Atomics.load(shared, 1)) Atomics.compareExchange(shared, 0, 0, save); });
