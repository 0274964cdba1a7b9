// SPDX-License-Identifier: GPL-3.0-or-later
// Tries the npm package as it is packed, with nothing but node.
//   node test.mjs FOLDER    the folder `package` of the unpacked tarball
import assert from "node:assert";
import { spawn, spawnSync } from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import { pathToFileURL } from "node:url";

const folder = path.resolve(process.argv[2]);
const command = path.join(folder, "bin/candelabra.js");
const place = fs.mkdtempSync(path.join(os.tmpdir(), "candelabra-"));
process.on("exit", () => fs.rmSync(place, { recursive: true, force: true }));

const scene = "camera { location -3*z look_at 0 } sphere { 0, 1 pigment { rgb <1, 0.5, 0.2> } } light_source { -9*z, 1 }\n";
const run = (words, options = {}) => spawnSync(process.execPath, [command, ...words], { cwd: place, maxBuffer: 1 << 28, ...options });
const put = (name, text) => { fs.writeFileSync(path.join(place, name), text); return name; };
const isPng = bytes => bytes.subarray(1, 4).toString() === "PNG";
const said = result => result.stderr.toString();

const cases = {
    "says its version"() {
        assert.match(run(["--version"]).stdout.toString(), /^Candelabra \d+\.\d+/i);
    },
    "writes a picture beside the scene, with the library"() {
        const result = run([put("one.pov", '#include "colors.inc"\n' + scene), "+W32", "+H24"]);
        assert.equal(result.status, 0, said(result));
        assert.ok(isPng(fs.readFileSync(path.join(place, "one.png"))));
    },
    "writes a picture to standard output, byte for byte"() {
        const file = run([put("two.pov", scene), "+W32", "+H24", "-o", "two.png"]);
        const stream = run(["two.pov", "+W32", "+H24", "-o-"]);
        assert.equal(file.status, 0, said(file));
        assert.equal(stream.status, 0, said(stream));
        assert.ok(isPng(stream.stdout));
    },
    "writes the formats that need no library, and names them where one is missing"() {
        put("formats.pov", scene);
        for (const name of ["exr", "hdr", "ppm", "tga", "tif"]) {
            const result = run(["formats.pov", "+W16", "+H12", "-o", "made." + name]);
            assert.equal(result.status, 0, said(result));
        }
        const result = run(["formats.pov", "+W16", "+H12", "-o", "made.webp"]);
        assert.equal(result.status, 3, said(result));
        assert.match(said(result), /WebAssembly[^]*TGA and TIFF are written without/);
    },
    "reads a scene from standard input"() {
        const result = run(["-", "+W16", "+H12", "-o", "in.png"], { input: scene });
        assert.equal(result.status, 0, said(result));
    },
    "names the place of a mistake, without colours through a pipe"() {
        const result = run([put("wrong.pov", "sphere { 0, }\n")]);
        assert.equal(result.status, 1);
        assert.match(said(result), /wrong\.pov:1/);
        assert.doesNotMatch(said(result), /\x1b/);
    },
    "macros that call themselves without end are a message"() {
        const result = run([put("deep.pov", "#macro M(I) M(I + 1) #end M(0)\n")]);
        assert.equal(result.status, 1, said(result));
        assert.doesNotMatch(said(result), /RangeError|\bat wasm/);
        assert.match(said(result), /deep/);
    },
    "macros may call themselves a thousand times"() {
        const result = run([put("thousand.pov", scene + "#macro M(I) #if (I) M(I - 1) #end #end M(1000)\n"), "+W16", "+H12"]);
        assert.equal(result.status, 0, said(result));
    },
    "the limit on memory holds"() {
        const result = run([put("large.pov", "#declare A = array; #for (I, 0, 1e8) #declare A[I] = <I, I, I>; #end\n"),
                            "--limit-memory", "400"]);
        assert.notEqual(result.status, 0);
        assert.match(said(result), /memory/);
    },
    "a preview is refused with the reason"() {
        const result = run(["two.pov", "--preview", "8000"]);
        assert.equal(result.status, 2);
        assert.match(said(result), /WebAssembly/);
    },
    async "a signal stops the work, and the state is saved"() {
        put("long.pov", scene);
        const child = spawn(process.execPath, [command, "long.pov", "+W800", "+H600", "--samples", "100000", "--progress", "json"],
                            { cwd: place });
        let text = "";
        child.stderr.on("data", part => {
            if (!text.includes("progress") && String(part).includes("progress")) child.kill("SIGINT");
            text += part;
        });
        const status = await new Promise(resolve => child.on("exit", resolve));
        assert.equal(status, 4, text);
        assert.ok(fs.readdirSync(place).some(name => name.includes("long") && name.endsWith(".exr")), fs.readdirSync(place).join());
    },
    async "what has not been allowed is closed"() {
        const { default: candelabra } = await import(pathToFileURL(path.join(folder, "lib/candelabra.mjs")));
        const disk = await import(pathToFileURL(path.join(folder, "lib/disk.mjs")));
        const { FS } = await candelabra({});
        const allow = disk.lockable(FS);
        disk.mountDisk(FS);
        const inside = disk.inside(place);
        fs.mkdirSync(path.join(place, "open"));
        fs.mkdirSync(path.join(place, "shut"));
        for (const name of ["open", "shut"]) put(name + "/file", "text");
        FS.readFile(inside + "/shut/file");
        allow(inside + "/open", 0);
        assert.equal(FS.readFile(inside + "/open/file", { encoding: "utf8" }), "text");
        const closed = [() => FS.readFile(inside + "/shut/file"), () => FS.readdir(inside + "/shut"),
                        () => FS.writeFile(inside + "/open/new", ""), () => FS.writeFile(inside + "/shut/new", ""),
                        () => FS.unlink(inside + "/open/file"), () => FS.rename(inside + "/open/file", inside + "/shut/b"),
                        () => FS.symlink("/etc/passwd", inside + "/open/link"),
                        () => FS.readFile(disk.inside(process.execPath)),
                        () => FS.readFile(inside + "/open/../shut/file")];
        for (const each of closed) assert.throws(each, problem => problem.errno === 2, String(each));
    },
    async "paths of Windows are those of the program"() {
        const { wordsInside } = await import(pathToFileURL(path.join(folder, "lib/disk.mjs")));
        const words = ["C:\\scenes\\one.pov", "+OD:\\out\\", "--preset=e:/set.json", "+W32", "a\\b.pov", "-o-", "Size=1:2"];
        assert.deepEqual(wordsInside(words, true),
                         ["/c/scenes/one.pov", "+O/d/out/", "--preset=/e/set.json", "+W32", "a/b.pov", "-o-", "Size=1:2"]);
        assert.deepEqual(wordsInside(words, false), words);
    },
    async "render() gives a picture, and rejects with the messages"() {
        const { render, SceneError } = await import(pathToFileURL(path.join(folder, "index.mjs")));
        const { picture } = await render('#include "colors.inc"\n' + scene, { width: 32, height: 24 });
        assert.ok(isPng(Buffer.from(picture)));
        await assert.rejects(render("sphere { 0, }"), problem => problem instanceof SceneError && /scene\.pov:1/.test(problem.message));
        const files = { "data/lamps.inc": "#declare Lamp = sphere { 0, 1 }\n" };
        await render('#include "data/lamps.inc"\nobject { Lamp }\n' + scene, { width: 8, height: 8, files });
        const abort = new AbortController();
        setTimeout(() => abort.abort(), 500);
        await assert.rejects(render(scene, { width: 2000, height: 2000, options: ["--samples", "10000"], signal: abort.signal }),
                             problem => problem.name === "AbortError");
    },
};

// A process of Windows cannot be asked to stop.
if (process.platform === "win32") delete cases["a signal stops the work, and the state is saved"];

let failed = 0;
for (const [name, work] of Object.entries(cases)) {
    try {
        await work();
        console.log("ok:", name);
    } catch (problem) {
        failed += 1;
        console.log("FAILED:", name, "\n", problem.message);
    }
}
process.exitCode = failed === 0 ? 0 : 1;
