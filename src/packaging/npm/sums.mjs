// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the package makes the same pictures on this system as elsewhere: the SHA-256 of small pictures of its examples.
//   node sums.mjs FOLDER > LIST     on one system; FOLDER: the folder `package` of the unpacked tarball
//   node sums.mjs FOLDER LIST       on another; ends with 1 and their names if pictures differ
import { spawnSync } from "node:child_process";
import { createHash } from "node:crypto";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";

const scenes = ["lights/ring", "lights/fibonacci_sphere", "lights/lens_in_haze", "gallery/ballroom", "gallery/courtyard",
                "gallery/campfire", "paper/fig6"];
const [folder, list] = process.argv.slice(2).map(each => path.resolve(each));
const place = fs.mkdtempSync(path.join(os.tmpdir(), "candelabra-"));
process.on("exit", () => fs.rmSync(place, { recursive: true, force: true }));

const sums = scenes.map(name => {
    const words = [path.join(folder, "bin/candelabra.js"), path.join(folder, "examples", name + ".pov"), "+W64", "+H48", "+FN16",
                   "-A", "--samples", "2", "--seed", "3", "-o", "made.png"];
    const { status, stderr } = spawnSync(process.execPath, words, { cwd: place });
    if (status !== 0) throw new Error(`${name} does not render: ${stderr}`);
    return createHash("sha256").update(fs.readFileSync(path.join(place, "made.png"))).digest("hex") + " " + name;
});
if (list) {
    const known = fs.readFileSync(list, "utf8").trim().split(/\r?\n/);
    const other = sums.filter((sum, i) => sum !== known[i]);
    console.log(other.length === 0 ? `all ${sums.length} pictures are the same` : "different:\n" + other.join("\n"));
    process.exitCode = other.length === 0 ? 0 : 1;
} else {
    console.log(sums.join("\n"));
}
