// SPDX-License-Identifier: GPL-3.0-or-later
// The worker of render(): files in memory, and of the disk nothing but the library.
import os from "node:os";
import { parentPort, workerData } from "node:worker_threads";

import { runProgram } from "./program.mjs";

const { scene, words, files, stackBytes, library } = workerData;
const decoder = new TextDecoder();
let messages = "", made = null;
const output = "/scene/picture";
const status = await runProgram(["/scene/scene.pov", ...words, "-o", output + ".png"], {
    environment: { CANDELABRA_STDLIB: "/library" },
    stackBytes,
    freeMemory: os.freemem(),
    err: text => { messages += text; },
    prepare: (FS, module) => {
        const folder = name => {
            const end = name.lastIndexOf("/");
            if (end > 0) FS.mkdirTree(name.slice(0, end));
        };
        FS.mkdir("/library");
        FS.mount(FS.filesystems.NODEFS, { root: library }, "/library");
        FS.mkdir("/scene");
        for (const [name, content] of [["scene.pov", scene], ...Object.entries(files)]) {
            folder("/scene/" + name);
            FS.writeFile("/scene/" + name, content);
        }
        FS.chdir("/scene");
        FS.registerDevice(FS.makedev(64, 2), {
            write: (stream, buffer, offset, length) => {
                messages += decoder.decode(buffer.slice(offset, offset + length), { stream: true });
                return length;
            },
        });
        for (const [descriptor, name] of [[1, "stdout"], [2, "stderr"]]) {
            FS.unlink("/dev/" + name);
            FS.mkdev("/dev/" + name, FS.makedev(64, 2));
            FS.close(FS.getStream(descriptor));
            FS.open("/dev/" + name, 1);
        }
        made = () => FS.analyzePath(output + ".png").exists ? FS.readFile(output + ".png") : null;
    },
});
const picture = status === 0 ? made() : null;
parentPort.postMessage({ status, messages, picture });
