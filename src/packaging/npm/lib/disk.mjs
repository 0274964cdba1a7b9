// SPDX-License-Identifier: GPL-3.0-or-later
// The disk and the standard streams of node, for the program as WebAssembly. Folders are mounted where they are; on Windows
// the drive C: is /c. lockable() makes a function that closes what has not been allowed.
import fs from "node:fs";
import path from "node:path";
import tty from "node:tty";

const windows = process.platform === "win32";

/// A path of the system as the program names it.
export function inside(name) {
    if (!windows) return name;
    const whole = path.resolve(name);
    return "/" + whole[0].toLowerCase() + whole.slice(2).replaceAll("\\", "/");
}

/// The words of a command line with paths as the program names them.
export function wordsInside(words, onWindows = windows) {
    if (!onWindows) return words;
    return words.map(word => word.replaceAll("\\", "/").replace(/^([+-][A-Za-z]|--[\w-]+=)?([A-Za-z]):\//,
        (_, option = "", drive) => `${option}/${drive.toLowerCase()}/`));
}

function mount(FS, host, place) {
    try {
        if (!FS.analyzePath(place).exists) FS.mkdir(place);
        FS.mount(FS.filesystems.NODEFS, { root: host }, place);
    } catch {
        // A folder that cannot be read is not there for the program.
    }
}

/// Mounts the whole disk, except what the kernel makes up.
export function mountDisk(FS) {
    if (windows) {
        for (const letter of "abcdefghijklmnopqrstuvwxyz")
            if (fs.existsSync(letter + ":\\")) mount(FS, letter + ":\\", "/" + letter);
    } else {
        for (const name of fs.readdirSync("/"))
            if (!["dev", "proc", "sys"].includes(name) && fs.statSync("/" + name, { throwIfNoEntry: false })?.isDirectory())
                mount(FS, fs.realpathSync("/" + name), "/" + name);
    }
    FS.chdir(inside(process.cwd()));
}

/// Wraps the functions of mounted folders. allow(path, rights) opens a path and, from the first call on, closes all that
/// has not been named; rights: 0 to read, 1 to read and write, 2 to write. Names and sizes of files remain visible, as
/// Linux's Landlock leaves them.
export function lockable(FS) {
    const readable = [], writable = [];
    let locked = false;
    const denied = () => new FS.ErrnoError(2);  // EACCES
    const below = (name, folders) => folders.some(each => name === each || name.startsWith(each.endsWith("/") ? each : each + "/"));
    const check = (node, writes, name = null) => {
        if (!locked) return;
        const whole = FS.getPath(node) + (name === null ? "" : "/" + name);
        if (!below(whole, writes ? writable : readable)) throw denied();
    };
    const { node_ops: nodes, stream_ops: streams } = FS.filesystems.NODEFS;
    const wrap = (table, name, before) => {
        const inner = table[name];
        table[name] = (...all) => { before(...all); return inner(...all); };
    };
    wrap(nodes, "readdir", node => check(node, false));
    wrap(nodes, "setattr", node => check(node, true));
    wrap(nodes, "mknod", (parent, name) => check(parent, true, name));
    wrap(nodes, "symlink", (parent, name) => check(parent, true, name));
    wrap(nodes, "unlink", (parent, name) => check(parent, true, name));
    wrap(nodes, "rmdir", (parent, name) => check(parent, true, name));
    wrap(nodes, "rename", (node, parent, name) => { check(node, true); check(parent, true, name); });
    wrap(streams, "open", stream => {
        const way = stream.flags & 3;  // O_RDONLY, O_WRONLY, O_RDWR
        const onlyPlace = stream.flags & 0o10000000;  // O_PATH
        if (onlyPlace) return;
        if (way !== 1) check(stream.node, false);
        if (way !== 0) check(stream.node, true);
    });
    // Descriptors that were opened as places only must not be read.
    for (const name of ["read", "mmap"]) wrap(streams, name, stream => {
        if (stream.flags & 0o10000000) throw new FS.ErrnoError(8);  // EBADF
    });
    return (name, rights) => {
        locked = true;
        let real;
        try {
            real = FS.lookupPath(name, { follow: true }).path;
        } catch {
            return;  // what is not there gets no rights
        }
        if (rights !== 2) readable.push(real);
        if (rights !== 0) writable.push(real);
    };
}

function pause() { Atomics.wait(new Int32Array(new SharedArrayBuffer(4)), 0, 0, 5); }

/// Gives the program the standard streams of this process, byte for byte.
export function connectStreams(FS) {
    const errors = { EPIPE: 64, ENOSPC: 51, EIO: 29, EBADF: 8, EFBIG: 22 };
    const tried = work => {
        for (;;) {
            try {
                return work();
            } catch (problem) {
                if (problem.code === "EOF") return 0;
                if (problem.code !== "EAGAIN") throw new FS.ErrnoError(errors[problem.code] ?? 29);
                pause();
            }
        }
    };
    for (const [descriptor, name] of ["stdin", "stdout", "stderr"].entries()) {
        const device = FS.makedev(64, descriptor);
        FS.registerDevice(device, {
            open: stream => {
                stream.seekable = false;
                if (tty.isatty(descriptor)) stream.tty = { ops: {} };
            },
            read: (stream, buffer, offset, length) => tried(() => fs.readSync(descriptor, buffer, offset, length, null)),
            write: (stream, buffer, offset, length) => {
                for (let written = 0; written < length;)
                    written += tried(() => fs.writeSync(descriptor, buffer, offset + written, length - written));
                return length;
            },
        });
        FS.unlink("/dev/" + name);
        FS.mkdev("/dev/" + name, device);
        FS.close(FS.getStream(descriptor));
        FS.open("/dev/" + name, descriptor === 0 ? 0 : 1);
    }
}
