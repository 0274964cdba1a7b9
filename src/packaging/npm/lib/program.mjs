// SPDX-License-Identifier: GPL-3.0-or-later
// Starts the program as WebAssembly once: with words, as its main() gets them, and what it asks of its surroundings.
import candelabra from "./candelabra.mjs";

const deep = "error: this is nested too deeply\nhelp: let a loop do what a macro does by calling itself\n";

/// `prepare` gets the file system before the program starts. Returns its exit status.
export async function runProgram(words, { environment = {}, prepare = () => {}, err, ...surroundings }) {
    const module = await candelabra({ ...surroundings, thisProgram: "candelabra",
                                      preRun: [module => Object.assign(module.ENV, environment)] });
    prepare(module.FS, module);
    try {
        return module.callMain(words) ?? 0;
    } catch (problem) {
        if (problem?.name === "ExitStatus") return problem.status;
        // The engine's stack, or the one in memory, has ended before the program's own limit.
        const stack = problem instanceof WebAssembly.RuntimeError && /out of bounds/.test(problem.message);
        if (!stack && !(problem instanceof RangeError)) throw problem;
        err(deep);
        return 1;
    }
}
