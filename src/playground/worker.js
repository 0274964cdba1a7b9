// SPDX-License-Identifier: GPL-3.0-or-later
// A worker of the playground: runs the program once for each message, with files in memory. pack.sh
// puts the program itself and runProgram() (src/packaging/npm/lib/program.mjs) in front.
let compiled = null, library = {};

function writeFiles(FS, folder, files) {
  for (const [name, content] of Object.entries(files)) {
    const path = folder + "/" + name;
    FS.mkdirTree(path.slice(0, path.lastIndexOf("/")));
    FS.writeFile(path, content);
  }
}

// Runs the program with `words` as its command line and `input` as its standard input, in a folder
// with `files`. Returns its status, its output and messages, and the files of `wants` that it made.
async function run({ words, files, input = "", wants = [] }) {
  const given = new TextEncoder().encode(input), said = { out: [], err: [] };
  let at = 0, FS = null;
  const status = await runProgram(words, {
    environment: { CANDELABRA_STDLIB: "/library", NO_COLOR: "1" },
    freeMemory: (navigator.deviceMemory ?? 4) * 2 ** 29,  // half of what the device has
    locateFile: name => name,
    instantiateWasm: (imports, done) => {
      WebAssembly.instantiate(compiled, imports).then(instance => done(instance, compiled));
      return {};
    },
    stdin: () => at < given.length ? given[at++] : null,
    stdout: code => { if (code !== null) said.out.push(code & 255); },
    stderr: code => { if (code !== null) said.err.push(code & 255); },
    err: text => said.err.push(...new TextEncoder().encode(text)),
    prepare: system => {
      FS = system;
      writeFiles(FS, "/library", library);
      FS.mkdir("/scene");
      writeFiles(FS, "/scene", files);
      FS.chdir("/scene");
    },
  });
  const text = codes => new TextDecoder().decode(new Uint8Array(codes));
  const made = {};
  for (const name of wants)
    if (FS.analyzePath("/scene/" + name).exists) made[name] = FS.readFile("/scene/" + name);
  return { status, out: text(said.out), err: text(said.err), made };
}

onmessage = async ({ data }) => {
  if (data.compiled) {
    ({ compiled, library } = data);
    return;
  }
  try {
    postMessage({ id: data.id, ...await run(data) });
  } catch (problem) {
    postMessage({ id: data.id, status: 3, out: "", err: `error: ${problem?.message ?? problem}\n`, made: {} });
  }
};
