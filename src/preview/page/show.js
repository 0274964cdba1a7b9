// SPDX-License-Identifier: GPL-3.0-or-later
// A show of many lamps: which of them light a pixel, and what they do in each frame
// (src/relight/page_records.h, page_frames.h).
class ShortNumbers {
  constructor(bytes) { Object.assign(this, { bytes, at: 0 }); }
  next() {
    let number = 0, factor = 1;
    for (;; factor *= 128) {
      const byte = this.bytes[this.at++];
      number += (byte & 127) * factor;
      if (!(byte & 128)) return number;
    }
  }
  signed() {
    const number = this.next();
    return number % 2 === 0 ? number / 2 : -(number + 1) / 2;
  }
  word() {
    const word = this.bytes[this.at] | this.bytes[this.at + 1] << 8;
    this.at += 2;
    return word;
  }
}

class Show {
  constructor(facts, bytes, width, height) {
    Object.assign(this, facts, { width, height });
    const parts = [];
    let at = 0;
    for (const size of facts.sizes) parts.push(bytes.subarray(at, at += size));
    this.lamps = facts.groups.reduce((sum, lamps) => sum + lamps, 0);
    this.readCells(new ShortNumbers(parts[0]));
    this.readDots(new ShortNumbers(parts[1]));
    const powers = new Float32Array(parts[2].slice().buffer);
    this.powers = new Float64Array(this.lamps + 1);  // of all lamps before
    for (let i = 0; i < this.lamps; ++i) this.powers[i + 1] = this.powers[i] + powers[i];
    this.power = powers;
    this.readFrames(parts[3]);
  }

  readCells(reader) {
    const nodes = [], shares = [], begins = [0];
    for (let cell = 0; cell < this.columns * this.rows; ++cell) {
      let place = 0;
      for (let count = reader.next(); count > 0; --count) {
        const first = place + reader.next();
        place = first + reader.next();
        nodes.push(first, place);
        for (let c = 0; c < 3; ++c) shares.push(reader.word() / 65535);
      }
      begins.push(nodes.length / 2);
    }
    this.nodes = Uint32Array.from(nodes);
    this.shares = Float32Array.from(shares);
    this.begins = Uint32Array.from(begins);
  }

  readDots(reader) {
    const count = reader.next();
    this.dots = { pixel: new Uint32Array(count), lamp: new Uint32Array(count), light: new Uint16Array(3 * count) };
    this.rowBegins = new Uint32Array(this.height + 1).fill(count);
    let pixel = 0, lamp = 0, row = 0;
    for (let i = 0; i < count; ++i) {
      pixel += reader.next();
      lamp += reader.signed();
      for (; row <= pixel / this.width; ++row) this.rowBegins[row] = i;
      this.dots.pixel[i] = pixel;
      this.dots.lamp[i] = lamp;
      for (let c = 0; c < 3; ++c) this.dots.light[3 * i + c] = reader.word();
    }
  }

  readFrames(bytes) {
    const each = this.lamps * (this.grey ? 1 : 3);
    this.codes = Uint8Array.from(bytes);
    for (let i = each; i < bytes.length; ++i) this.codes[i] += this.codes[i - each];
    this.factorOfCode = Float32Array.from({ length: 256 }, (_, code) => this.scale * (code / 255) ** 2);
  }

  // The factors of lamps in a frame, with those of the groups, and the factors of cells.
  mixed(frame, groups) {
    const { lamps, grey, factorOfCode, codes, power } = this;
    const factors = new Float32Array(3 * lamps);
    const sums = [0, 1, 2].map(() => new Float64Array(lamps + 1));
    let place = 0, code = frame * lamps * (grey ? 1 : 3);
    this.groups.forEach((count, k) => {
      const { strength, colour } = groups[k] ?? { strength: 1, colour: [1, 1, 1] };
      for (const end = place + count; place < end; ++place)
        for (let c = 0; c < 3; ++c) {
          const factor = strength * colour[c] * factorOfCode[codes[code]];
          if (!grey || c === 2) ++code;
          factors[3 * place + c] = factor;
          sums[c][place + 1] = sums[c][place] + power[place] * factor;
        }
    });
    const cells = new Float32Array(3 * this.columns * this.rows);
    const empty = [];
    for (let cell = 0; cell < this.columns * this.rows; ++cell) {
      const first = this.begins[cell], last = this.begins[cell + 1];
      if (first === last) empty.push(cell);
      for (let c = 0; c < 3; ++c) {
        let sum = 0, all = 0;
        for (let n = first; n < last; ++n) {
          const from = this.nodes[2 * n], to = this.nodes[2 * n + 1], share = this.shares[3 * n + c];
          sum += share * (sums[c][to] - sums[c][from]) / (this.powers[to] - this.powers[from]);
          all += share;
        }
        cells[3 * cell + c] = all > 0 ? sum / all : 0;
      }
    }
    this.fillEmpty(cells, empty);
    return { factors, cells };
  }

  // Cells without light do what those beside them do.
  fillEmpty(cells, empty) {
    const none = new Set(empty);
    for (const cell of empty) {
      const column = cell % this.columns, around = [];
      if (column > 0) around.push(cell - 1);
      if (column + 1 < this.columns) around.push(cell + 1);
      around.push(cell - this.columns, cell + this.columns);
      const lit = around.filter(each => each >= 0 && each < this.columns * this.rows && !none.has(each));
      for (let c = 0; c < 3; ++c)
        cells[3 * cell + c] = lit.reduce((sum, each) => sum + cells[3 * each + c], 0) / (lit.length || 1);
    }
  }

  // Adds the light of a row, of each `stride`-th pixel. `crowd`: its light as rendered, as codes.
  addRow(row, y, stride, { factors, cells }, crowd, lightOfCode, gain) {
    const { width, columns, cell, dots } = this, count = row.length / 3;
    const down = Math.min(this.rows - 1, Math.max(0, (y + 0.5) / cell - 0.5));
    const upper = Math.floor(down), lower = Math.min(this.rows - 1, upper + 1), low = down - upper;
    const line = new Float32Array(3 * columns);
    for (let i = 0; i < 3 * columns; ++i)
      line[i] = (1 - low) * cells[3 * columns * upper + i] + low * cells[3 * columns * lower + i];
    for (let x = 0, i = 3 * y * width; x < count; ++x, i += 3 * stride) {
      const across = Math.min(columns - 1, Math.max(0, (x * stride + 0.5) / cell - 0.5));
      const left = Math.floor(across), right = Math.min(columns - 1, left + 1), part = across - left;
      for (let c = 0; c < 3; ++c)
        row[3 * x + c] += gain * lightOfCode[crowd[i + c]] *
          ((1 - part) * line[3 * left + c] + part * line[3 * right + c]);
    }
    for (let i = this.rowBegins[y]; i < this.rowBegins[y + 1]; ++i) {
      const x = dots.pixel[i] - y * width, lamp = dots.lamp[i];
      if (x % stride !== 0) continue;
      for (let c = 0; c < 3; ++c)
        row[3 * x / stride + c] += gain * factors[3 * lamp + c] * lightOfCode[dots.light[3 * i + c]];
    }
  }
}
