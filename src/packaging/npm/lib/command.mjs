// SPDX-License-Identifier: GPL-3.0-or-later
// The worker of the command line.
import fs from "node:fs";
import os from "node:os";
import { parentPort, workerData } from "node:worker_threads";

import { connectStreams, inside, lockable, mountDisk, wordsInside } from "./disk.mjs";
import { runProgram } from "./program.mjs";

const { words, shared, stackBytes, library } = workerData;
const environment = { ...process.env };
environment.CANDELABRA_STDLIB ||= inside(library);
let allow;
const status = await runProgram(wordsInside(words), {
    environment,
    stackBytes,
    freeMemory: os.freemem(),
    interrupt: () => Atomics.load(shared, 0) && Atomics.exchange(shared, 0, 0),
    listens: on => { Atomics.store(shared, 1, on ? 1 : 0); },
    allow: (path, rights) => allow(path, rights),
    err: text => { fs.writeSync(2, text); },
    prepare: FS => {
        allow = lockable(FS);
        mountDisk(FS);
        connectStreams(FS);
    },
});
parentPort.postMessage(status);
