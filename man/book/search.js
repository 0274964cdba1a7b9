// SPDX-License-Identifier: GPL-3.0-or-later
// The search of the book: words.js has [title, kind, address, text] for each thing to be found.
const field = document.getElementById("search");
const found = document.getElementById("found");

// How well an entry fits: its title before its text, and a beginning before a middle.
function rank(entry, wanted) {
    const title = entry[0].toLowerCase();
    if (title === wanted) return 0;
    if (title.startsWith(wanted)) return 1;
    if (title.includes(wanted)) return 2;
    return entry[3].toLowerCase().includes(wanted) ? 3 : 4;
}

function show() {
    const wanted = field.value.trim().toLowerCase().replace(/^#/, "");
    found.replaceChildren();
    if (wanted === "") return;
    const ranked = words.map(entry => [rank(entry, wanted), entry]).filter(([place]) => place < 4);
    ranked.sort(([a], [b]) => a - b);
    for (const [, [title, kind, address, text]] of ranked.slice(0, 20)) {
        const link = document.createElement("a");
        link.href = address;
        link.textContent = title;
        const more = document.createElement("small");
        more.textContent = kind + (text ? ": " + text.slice(0, 90) : "");
        const item = document.createElement("li");
        item.append(link, more);
        found.append(item);
    }
}

// index.html?search=sphere
field.value = new URLSearchParams(location.search).get("search") ?? "";
show();
field.addEventListener("input", show);
document.addEventListener("keydown", event => {
    if (event.key === "/" && document.activeElement !== field) {
        event.preventDefault();
        field.focus();
    }
});
