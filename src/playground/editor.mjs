// SPDX-License-Identifier: GPL-3.0-or-later
// The editor: a text area over its own text in colours, with proposals and hints. element() is that
// of src/preview/page/widgets.js.


function escaped(text) { return text.replace(/[&<>]/g, c => ({ "&": "&amp;", "<": "&lt;", ">": "&gt;" })[c]); }

export class Editor {
  // `colour` cuts a text into classes; `language` answers questions; `files()` are those beside the scene.
  constructor({ colour, language, files, changed }) {
    Object.assign(this, { colour, language, files, changed, marks: [], proposals: [], chosen: 0, start: 0 });
    this.area = element("text");
    this.paper = element("colours");
    this.list = element("proposals");
    this.hint = element("hint");
    this.area.addEventListener("input", () => this.#edited());
    this.area.addEventListener("scroll", () => this.#follow());
    this.area.addEventListener("keydown", event => this.#key(event));
    this.area.addEventListener("blur", () => this.#close());
    this.area.addEventListener("mousemove", event => this.#point(event));
    this.area.addEventListener("mouseleave", () => this.#forget());
    this.list.addEventListener("mousedown", event => {
      const item = event.target.closest("li");
      if (item) this.#accept(Number(item.dataset.index));
      event.preventDefault();
    });
  }

  get text() { return this.area.value; }
  set text(text) {
    this.area.value = text;
    this.marks = [];
    this.paint();
    this.changed();
  }

  // Underlines places: [{first, last, severity}].
  mark(marks) {
    this.marks = marks;
    this.paint();
  }

  paint() {
    const { text } = this, ends = new Map();
    for (const { first, last, severity } of this.marks)
      ends.set(first, { last: Math.max(last, first + 1), severity });
    let html = "", at = 0;
    const add = (first, last, name) => {
      let open = first;
      const put = (a, b) => {
        if (a < b) html += name ? `<span class="${name}">${escaped(text.slice(a, b))}</span>` : escaped(text.slice(a, b));
      };
      for (const [start, { last: end, severity }] of ends) {
        const a = Math.max(start, open), b = Math.min(end, last);
        if (a >= b) continue;
        put(open, a);
        html += `<mark class="${severity}">`;
        put(a, b);
        html += "</mark>";
        open = b;
      }
      put(open, last);
    };
    for (const [first, last, name] of this.colour(text)) {
      add(at, first, "");
      add(first, last, name);
      at = last;
    }
    add(at, text.length, "");
    this.paper.innerHTML = html + "\n";
    this.#follow();
  }

  goToLine(line) { this.go(this.text.split("\n").slice(0, line - 1).join("\n").length + (line > 1 ? 1 : 0)); }

  // Shows a place, from 0 in the text.
  go(first) {
    this.area.focus();
    this.area.setSelectionRange(first, first);
    const line = this.text.slice(0, first).split("\n").length - 1;
    this.area.scrollTop = Math.max(0, line * this.#metrics().height - this.area.clientHeight / 3);
  }

  #edited() {
    this.marks = [];
    this.paint();
    this.changed();
    const before = this.text.slice(0, this.area.selectionStart);
    if (/[A-Za-z_]\w+$/.test(before)) this.#propose();
    else this.#close();
  }

  #follow() {
    this.paper.style.transform = `translate(${-this.area.scrollLeft}px, ${-this.area.scrollTop}px)`;
    this.paper.style.right = this.paper.style.bottom = "auto";
  }

  #metrics() {
    if (!this.measured) {
      const style = getComputedStyle(this.area), context = document.createElement("canvas").getContext("2d");
      context.font = style.font;
      this.measured = { width: context.measureText("0".repeat(100)).width / 100, height: parseFloat(style.lineHeight),
                        left: parseFloat(style.paddingLeft), top: parseFloat(style.paddingTop) };
    }
    return this.measured;
  }

  #place(offset) {
    const lines = this.text.slice(0, offset).split("\n");
    return { line: lines.length - 1, character: lines.at(-1).length };
  }

  async #propose() {
    const at = this.area.selectionStart, { text } = this, { line, character } = this.#place(at);
    const asked = this.asking = {};
    const word = text.slice(0, at).match(/\w*$/)[0];
    const answer = await this.language.ask("textDocument/completion", text, this.files(), line, character);
    if (this.asking !== asked || this.text !== text) return;
    const items = Array.isArray(answer) ? answer : answer?.items ?? [];
    const begins = items.filter(each => each.label.toLowerCase().startsWith(word.toLowerCase()) && each.label !== word);
    this.#show(begins.sort((a, b) => (a.sortText ?? a.label) < (b.sortText ?? b.label) ? -1 : 1).slice(0, 40), at - word.length);
  }

  #show(proposals, start) {
    Object.assign(this, { proposals, start, chosen: 0 });
    this.list.hidden = proposals.length === 0;
    this.list.innerHTML = proposals.map((each, i) => `<li role="option" data-index="${i}" aria-selected="${i === 0}">` +
      `<span>${escaped(each.label)}</span><small>${escaped(each.detail ?? "")}</small></li>`).join("");
    const { line, character } = this.#place(start), { width, height, left, top } = this.#metrics();
    const x = left + character * width - this.area.scrollLeft, y = top + (line + 1) * height - this.area.scrollTop;
    this.list.style.left = Math.max(4, Math.min(x, this.area.clientWidth - this.list.offsetWidth - 4)) + "px";
    const below = y + this.list.offsetHeight < this.area.clientHeight;
    this.list.style.top = (below ? y : Math.max(0, y - height - this.list.offsetHeight)) + "px";
  }

  #close() {
    this.asking = null;
    this.list.hidden = true;
    this.proposals = [];
  }

  #accept(index) {
    const proposal = this.proposals[index], text = proposal.textEdit?.newText ?? proposal.insertText ?? proposal.label;
    const plain = text.replace(/\$\{\d+:?([^}]*)\}|\$\d+/g, "$1");
    this.area.setRangeText(plain, this.start, this.area.selectionStart, "end");
    this.#close();
    this.marks = [];
    this.paint();
    this.changed();
  }

  #key(event) {
    const open = !this.list.hidden;
    if (open && (event.key === "ArrowDown" || event.key === "ArrowUp")) {
      const count = this.proposals.length, step = event.key === "ArrowDown" ? 1 : count - 1;
      this.list.children[this.chosen].setAttribute("aria-selected", "false");
      this.chosen = (this.chosen + step) % count;
      this.list.children[this.chosen].setAttribute("aria-selected", "true");
      this.list.children[this.chosen].scrollIntoView({ block: "nearest" });
    } else if (open && (event.key === "Enter" || event.key === "Tab") && !event.ctrlKey) {
      this.#accept(this.chosen);
    } else if (open && event.key === "Escape") {
      this.#close();
      event.stopPropagation();
    } else if (event.key === " " && event.ctrlKey) {
      this.#propose();
    } else if (event.key === "Tab" && !event.shiftKey && !event.ctrlKey) {
      this.area.setRangeText("    ", this.area.selectionStart, this.area.selectionEnd, "end");
      this.#edited();
    } else {
      return;
    }
    event.preventDefault();
  }

  // Asks about the word under the pointer once it rests.
  #point(event) {
    this.#forget();
    const box = this.area.getBoundingClientRect(), { width, height, left, top } = this.#metrics();
    const line = Math.floor((event.clientY - box.top + this.area.scrollTop - top) / height);
    const character = Math.floor((event.clientX - box.left + this.area.scrollLeft - left) / width);
    const { text } = this, lines = text.split("\n");
    if (line < 0 || line >= lines.length || !/\w/.test(lines[line][character] ?? "")) return;
    this.resting = setTimeout(async () => {
      const asked = this.resting;
      const answer = await this.language.ask("textDocument/hover", text, this.files(), line, character);
      const help = answer?.contents?.value ?? answer?.contents;
      if (this.resting !== asked || typeof help !== "string") return;
      this.hint.textContent = help.replace(/^```\w*\n?|```$/gm, "").replaceAll("**", "").replaceAll("`", "").trim();
      this.hint.hidden = false;
      this.hint.style.left = Math.max(4, Math.min(event.clientX - box.left, box.width - this.hint.offsetWidth - 8)) + "px";
      const below = event.clientY - box.top + 18;
      this.hint.style.top = (below + this.hint.offsetHeight < box.height ? below
        : Math.max(0, below - this.hint.offsetHeight - 30)) + "px";
    }, 500);
  }

  #forget() {
    clearTimeout(this.resting);
    this.resting = null;
    this.hint.hidden = true;
  }
}
