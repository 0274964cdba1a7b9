#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The grammar for tree-sitter is one: by tree-sitter's own program where that is installed, and else by node, Bison and
a C compiler, which read the examples and the library by its rules. Ends with 77 where these are missing.

    tree_sitter.py PROGRAM
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parent.parent.parent
# Braces that a branch opens for what stands behind its condition are left to the recovery of editors.
scenes = [scene for scene in sorted([*root.glob("examples/*/*.pov"), *root.glob("stdlib/*.inc")])
          if not re.search(r"\{\s*#\s*else\b", scene.read_text(errors="replace"))]

# The language of grammars, as far as it is used; prints the rules as JSON.
dsl = r"""
const rule = r => typeof r === 'string' ? { type: 'STRING', value: r } : r instanceof RegExp
  ? { type: 'PATTERN', value: r.source } : r;
const members = type => (...m) => ({ type, members: m.map(rule) });
Object.assign(global, {
  choice: members('CHOICE'), seq: members('SEQ'),
  repeat: r => ({ type: 'REPEAT', content: rule(r) }),
  optional: r => ({ type: 'CHOICE', members: [rule(r), { type: 'BLANK' }] }),
  prec: Object.assign((n, r) => rule(r), { right: r => rule(r) }), field: (name, r) => rule(r),
  token: r => ({ type: 'TOKEN', content: rule(r) }), alias: r => rule(r),
  grammar: g => {
    const $ = new Proxy({}, { get: (_, name) => ({ type: 'SYMBOL', name }) });
    const rules = {};
    for (const [name, make] of Object.entries(g.rules)) rules[name] = rule(make($));
    console.log(JSON.stringify({ name: g.name, rules, extras: g.extras($).map(rule), externals: g.externals($) }));
  },
});
require(process.argv[1]);
"""

driver = r"""
%%
static FILE *input;
static int line;
static int yylex(void) {
  int token;
  return fscanf(input, "%d %d", &token, &line) == 2 ? token : 0;
}
static void yyerror(const char *message) { printf("line %d: %s\n", line, message); }
int main(void) { input = stdin; return yyparse(); }
"""


def expression(rule):
    """A token as a regular expression."""
    if rule["type"] == "STRING":
        return re.escape(rule["value"])
    if rule["type"] == "PATTERN":
        return rule["value"].replace("[^]", r"[\s\S]")
    if rule["type"] == "TOKEN":
        return expression(rule["content"])
    parts = [expression(part) for part in rule["members"]]
    return "(?:" + "|".join(parts) + ")" if rule["type"] == "CHOICE" else "".join(parts)


class Rules:
    """The grammar in Bison's form; tokens are numbers from 1000."""

    def __init__(self, grammar):
        self.tokens, self.lines, self.lists = {}, [], 0
        self.rules = grammar["rules"]
        for name, rule in self.rules.items():
            if not self.is_token(rule):
                self.add(name, self.alternatives(rule))

    def add(self, name, alternatives):
        self.lines.append(f"{name}: " + " | ".join(" ".join(a) or "%empty" for a in alternatives) + ";")

    def is_token(self, rule):
        return rule["type"] in ("STRING", "PATTERN", "TOKEN")

    def token(self, rule):
        return f"T{self.tokens.setdefault(expression(rule), 1000 + len(self.tokens))}"

    def alternatives(self, rule):
        """Choices within a rule are rules of their own there, too."""
        kind = rule["type"]
        if self.is_token(rule):
            return [[self.token(rule)]]
        if kind == "BLANK":
            return [[]]
        if kind == "SYMBOL":
            named = self.rules[rule["name"]]
            return [[self.token(named) if self.is_token(named) else rule["name"]]]
        if kind == "CHOICE":
            return [a for member in rule["members"] for a in self.alternatives(member)]
        if kind == "SEQ":
            found = [[]]
            for member in rule["members"]:
                found = [a + b for a in found for b in self.alternatives(member)]
            return found
        assert kind == "REPEAT", kind
        self.lists += 1
        name = f"list{self.lists}"
        self.add(name, [[], *([name, *a] for a in self.alternatives(rule["content"]))])
        return [[name]]

    def text(self):
        head = "%{\n#include <stdio.h>\nstatic int yylex(void);\nstatic void yyerror(const char *);\n%}\n"
        head += "".join(f"%token T{number} {number}\n" for number in self.tokens.values())
        return head + "%start source_file\n%%\n" + "\n".join(self.lines) + driver


def without_comments(text):
    """Comments, which the scanner in C knows, become blanks."""
    out, at = [], 0
    for found in re.finditer(r'"(?:[^"\\]|\\[\s\S])*"|//[^\r\n]*|/\*', text):
        if found.start() < at:
            continue
        out.append(text[at:found.start()])
        at = found.end()
        if found.group() == "/*":
            depth = 1
            while depth and at < len(text):
                sign = text[at:at + 2]
                depth += {"/*": 1, "*/": -1}.get(sign, 0)
                at += 2 if sign in ("/*", "*/") else 1
        part = text[found.start():at]
        out.append(part if part[0] == '"' else "\n" * part.count("\n") + " ")
    return "".join(out) + text[at:]


def tokens_of(text, tokens):
    """The longest token, and of those the first word before names; what is none is 999."""
    compiled = [(re.compile(pattern), number) for pattern, number in tokens.items()]
    at, line = 0, 1
    while at < len(text):
        if text[at].isspace() or text[at] == "\x1a":
            line += text[at] == "\n"
            at += 1
            continue
        best, kind = 1, 999
        for pattern, number in compiled:
            found = pattern.match(text, at)
            if found and found.end() - at >= best and (kind == 999 or found.end() - at > best):
                best, kind = found.end() - at, number
        yield f"{kind} {line}\n"
        line += text.count("\n", at, at + best)
        at += best


def own_reading(folder):
    if not all(shutil.which(tool) for tool in ("node", "bison", "cc")):
        print("skipped: neither tree-sitter nor node, bison and cc are installed")
        sys.exit(77)
    output = subprocess.run(["node", "-e", dsl, str(folder / "grammar.js")], check=True, capture_output=True, text=True)
    grammar = json.loads(output.stdout)
    rules = Rules(grammar)
    (folder / "own.y").write_text(rules.text())
    made = subprocess.run(["bison", "-Wno-yacc", "-o", "own.c", "own.y"], cwd=folder, capture_output=True, text=True)
    assert made.returncode == 0 and "reduce/reduce" not in made.stderr, made.stderr
    assert "useless" not in made.stderr, made.stderr
    print("what precedence decides:", made.stderr.strip() or "nothing")
    subprocess.run(["cc", "-O1", "-o", "own", "own.c"], cwd=folder, check=True)
    (folder / "src/tree_sitter").mkdir(exist_ok=True)
    header = """#include <stdbool.h>
#include <stdint.h>
typedef struct TSLexer { int32_t lookahead; uint16_t result_symbol; void (*advance)(struct TSLexer *, bool);
                         bool (*eof)(const struct TSLexer *); } TSLexer;
"""
    (folder / "src/tree_sitter/parser.h").write_text(header)
    subprocess.run(["cc", "-Wall", "-Wextra", "-Werror", "-Isrc", "-c", "src/scanner.c"], cwd=folder, check=True)
    failures = 0
    # Names come last, so that words are found before them.
    name = expression(grammar["rules"]["name"])
    tokens = {p: n for p, n in rules.tokens.items() if p != name} | {name: rules.tokens[name]}
    for scene in scenes:
        text = without_comments(scene.read_text(errors="replace"))
        read = subprocess.run([folder / "own"], input="".join(tokens_of(text, tokens)), capture_output=True, text=True)
        if read.returncode:
            failures += 1
            print(f"FAILED: {scene.relative_to(root)} {read.stdout.strip()}")
    return failures


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        subprocess.run([sys.executable, root / "grammar/tree_sitter.py", program, folder], check=True)
        highlights = (folder / "queries/highlights.scm").read_text()
        assert '"exposure"' in highlights and '"light_octree"' in highlights and '"sphere"' not in highlights
        if shutil.which("tree-sitter"):
            subprocess.run(["tree-sitter", "generate"], cwd=folder, check=True)
            failures = subprocess.run(["tree-sitter", "parse", "--quiet", *scenes], cwd=folder).returncode
        else:
            failures = own_reading(folder)
    print(f"{len(scenes)} files read" if not failures else "FAILED")
    assert len(scenes) > 60
    return 1 if failures else 0


sys.exit(main())
