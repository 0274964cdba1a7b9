// SPDX-License-Identifier: GPL-3.0-or-later
// OpenEXR files as the program writes them: scan lines, in blocks of rows that are compressed each by itself.

export const rowsOfBlock = 16;
const headBytes = 8;

function parsed(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength), decoder = new TextDecoder();
  const attributes = [];
  let at = headBytes;
  const text = () => {
    const end = bytes.indexOf(0, at), found = decoder.decode(bytes.subarray(at, end));
    at = end + 1;
    return found;
  };
  for (let name = text(); name !== ""; name = text()) {
    const type = text(), length = view.getUint32(at, true);
    attributes.push({ name, type, value: bytes.subarray(at + 4, at + 4 + length) });
    at += 4 + length;
  }
  const rows = attributes.find(each => each.name === "dataWindow").value;
  const height = new DataView(rows.buffer, rows.byteOffset).getInt32(12, true) + 1;
  const blocks = Array.from({ length: Math.ceil(height / rowsOfBlock) }, (_, i) => {
    const place = Number(view.getBigUint64(at + 8 * i, true));
    return bytes.subarray(place, place + 8 + view.getUint32(place + 4, true));
  });
  return { attributes, blocks };
}

// The texts in the head of a file, by name.
export function textsOfExr(bytes) {
  return Object.fromEntries(parsed(bytes).attributes.filter(({ type }) => type === "string")
    .map(({ name, value }) => [name, new TextDecoder().decode(value)]));
}

function joined(parts) {
  const whole = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

const numbers = (count, set) => {
  const view = new DataView(new ArrayBuffer(count));
  set(view);
  return new Uint8Array(view.buffer);
};

// The file of a whole picture, of files each of which has some of its rows: `bands` are their first and
// last ones, from 1, and end where blocks do. What the head says of rows is left out.
export function joinBands(files, bands) {
  const encoder = new TextEncoder(), decoder = new TextDecoder(), parts = files.map(parsed);
  const whole = value => encoder.encode(decoder.decode(value).replace(/ (?:Start|End)_Row=\d+;| \+[SE]R\d+/g, ""));
  const head = [files[0].subarray(0, headBytes)];
  for (const { name, type, value } of parts[0].attributes) {
    const content = type === "string" ? whole(value) : value;
    head.push(encoder.encode(`${name}\0${type}\0`), numbers(4, view => view.setUint32(0, content.length, true)), content);
  }
  const blocks = parts[0].blocks.map((_, i) =>
    parts[bands.findIndex(([, last]) => i * rowsOfBlock < last)].blocks[i]);
  const start = joined([...head, new Uint8Array(1)]);
  const table = numbers(8 * blocks.length, view => {
    let place = start.length + 8 * blocks.length;
    blocks.forEach((block, i) => {
      view.setBigUint64(8 * i, BigInt(place), true);
      place += block.length;
    });
  });
  return joined([start, table, ...blocks]);
}
