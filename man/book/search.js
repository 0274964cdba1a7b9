// SPDX-License-Identifier: GPL-3.0-or-later
// The search of the book: words.js has [title, kind, address, text] for each thing to be found.
const field = document.getElementById("search");
const found = document.getElementById("found");

// Letters only, so that "light ring" finds Light_Ring, and "light report" --light-report.
function plain(text) {
    return text.toLowerCase().replace(/[_\-+#]+/g, " ").trim();
}

// How well an entry fits: its title before its text, a beginning before a middle, and all words
// together before each of them somewhere.
function rank(entry, wanted) {
    const title = plain(entry[0]), text = plain(entry[3]);
    if (title === wanted) return 0;
    if (title.startsWith(wanted)) return 1;
    if (title.includes(wanted)) return 2;
    if (text.includes(wanted)) return 3;
    return wanted.split(/\s+/).every(word => title.includes(word) || text.includes(word)) ? 4 : 5;
}

function show() {
    const wanted = plain(field.value);
    found.replaceChildren();
    if (wanted === "") return;
    const ranked = words.map(entry => [rank(entry, wanted), entry]).filter(([place]) => place < 5);
    ranked.sort(([a], [b]) => a - b);
    if (ranked.length === 0) {
        const none = document.createElement("li");
        none.textContent = "Nothing is found.";
        found.append(none);
    }
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

// On a phone the contents would fill the first screen.
document.querySelector("nav details").open = !matchMedia("(max-width: 45rem)").matches;

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
