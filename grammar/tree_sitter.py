#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes a grammar for tree-sitter, by which Neovim, Helix, Emacs and others colour and fold scenes.

    tree_sitter.py PROGRAM FOLDER

Words come from the program, tokens from tokens.re, and directives from scene.yy with the words that syntax/lexer.cpp
has for them. Editors show scenes that are being written, so elements stand in no order here, values and signs beside
each other: what must match are brackets and directives (braces that a branch opens for what stands behind its condition do not, and
are left to the recovery of tree-sitter). `tree-sitter generate` in the folder makes the parser.
"""
import json
import pathlib
import re
import subprocess
import sys

here = pathlib.Path(__file__).resolve().parent

# What editors call the classes of words.
classes = {"word": "word", "layer": "word", "unary_function": "function_word", "function": "function_word",
           "constant": "constant", "colour": "colour_word", "colour_prefix": "colour_word", "channel": "colour_word",
           "array": "value_word", "function_literal": "value_word"}


def definitions(text):
    """The named expressions of re2c, as those of JavaScript."""
    found = {}
    for name, value in re.findall(r"^ {8}(\w+) += (.*);$", text, re.M):
        found[name] = javascript(value, found)
    return found


def javascript(expression, known):
    parts = []
    for part in re.findall(r'"[^"]*"|\[[^]]*\]|\w+|\{[\d,]+\}|[|()*+?]|\s+', expression):
        if part.startswith('"'):
            parts.append("".join(c if c.isalnum() or c in ',"<>' else "\\" + c for c in part[1:-1]))
        elif re.fullmatch(r"[A-Za-z_]\w*", part):
            parts.append("(" + known[part] + ")")
        elif not part.isspace():
            parts.append(part.replace("/", r"\/") if part[0] == "[" else part)
    return "".join(parts)


def productions(text):
    """The alternatives of each rule in scene.yy, as lists of symbols, without what is done and what is wrong."""
    text = text[text.index("\n%%") + 3:text.rindex("\n%%")]
    text = re.sub(r"//.*|%prec \w+|%empty", "", text)
    while True:
        shorter = re.sub(r"\{[^{}]*\}", "", text)
        if shorter == text:
            break
        text = shorter
    rules = {}
    for name, body in re.findall(r"(\w+):([^;]*);", text):
        rules[name] = [alternative.split() for alternative in body.split("|")]
    return {name: [a for a in found if "error" not in a and "lost" not in a] for name, found in rules.items()}


def directive_words(text):
    """The words of each directive's token, in scene.yy's name for it."""
    words = {}
    for word, kind in re.findall(r'DirectiveWord\{"(\w+)", TokenKind::hash_(\w+)', text):
        words.setdefault("HASH_END" if kind == "end" else kind.upper(), []).append(word)
    return words


def described(program, part):
    """What the program has of that part."""
    done = subprocess.run([program, "--describe", "json", part], check=True, capture_output=True, text=True)
    return json.loads(done.stdout)


def own_words(program):
    """The words of blocks that only this language has: they are no reserved words, but names that blocks know."""
    reserved = {word for words in described(program, "words").values() for word in words}
    known = set()
    for group in described(program, "items"):
        for item in group["items"]:
            known.add(item["name"])
            known.update(field["name"] for field in item["fields"]
                         if field["place"] not in ("positional", "counted", "following"))
    return sorted(known - reserved)


class Grammar:
    def __init__(self, program):
        tokens = (here / "tokens.re").read_text()
        self.rules = productions((here / "scene.yy").read_text())
        self.directives = directive_words((here.parent / "src/syntax/lexer.cpp").read_text())
        self.words = described(program, "words")
        self.regular = definitions(tokens)
        literal = re.search(r'("<" blank.*?">")', tokens).group(1)
        self.vector = javascript(literal, self.regular)
        self.name = javascript(re.search(r"(letter \(letter.*?\*)", tokens).group(1), self.regular)
        signs = re.findall(r'"([^"\w\\]+)" +\{ return token\((\w+), first\)', tokens)
        brackets = "{}()[]"
        self.signs = [sign for sign, _ in signs if sign not in brackets]

    def hash(self, token):
        words = self.directives[token]
        return "hash($, " + ", ".join(f"'{word}'" for word in words) + ")"

    def symbol(self, name):
        """A symbol of scene.yy in a directive."""
        if name == "NAME":
            return "field('name', $.name)"
        if name in self.directives:
            return self.hash(name)
        if name in ("condition", "IN PARENTHESES"):
            return "$.parentheses"
        if name == "elements":
            return "repeat($._element)"
        return f"repeat($.{name})"

    def sequence(self, symbols):
        """What stands in parentheses is read as anything that is in them."""
        joined = re.sub(r"OPEN_PARENTHESIS.*?CLOSE_PARENTHESIS", "IN_PARENTHESES", " ".join(symbols)).split()
        return "seq(" + ", ".join(self.symbol(s.replace("_P", " P")) for s in joined) + ")"

    def structure(self):
        """The directives that have an #end, with what divides them."""
        found = {}
        for rule in ("directive", "loop"):
            for symbols in self.rules[rule]:
                if "HASH_END" in symbols:
                    found[self.directives[symbols[0]][0] + "_directive"] = self.sequence(symbols)
        openers = {s[0] for s in self.rules["branch_condition"]}
        openings = [self.sequence(s) for s in self.rules["branch_condition"]]
        dividers = [self.sequence(s[1:]) for s in self.rules["branches"] if s[0] == "branches"]
        dividers += [self.sequence(s[1:-1]) for s in self.rules["conditional"] if len(s) > 2]
        assert openers == {"IF", "IFDEF"}, openers
        found["if_directive"] = (f"seq(choice({', '.join(openings)}), repeat($._element), repeat($.branch), "
                                 f"{self.hash('HASH_END')})")
        found["branch"] = f"choice({', '.join(dividers)})"
        found["case"] = f"choice({', '.join(self.sequence(s) for s in self.rules['case'])})"
        found["switch_directive"] = found["switch_directive"].replace("$.cases", "$.case")
        return found

    def plain(self):
        """The directives without an #end; those in front of a name declare it."""
        structured = {"HASH_END", "IF", "IFDEF", "ELSEIF", "ELSE", "WHILE", "FOR", "SWITCH", "CASE", "RANGE", "MACRO",
                      "DECLARE"}
        return [self.hash(token) for token in self.directives if token not in structured]

    def text(self):
        structure = self.structure()
        by_class = {}
        for name, words in self.words.items():
            if name in classes:
                by_class.setdefault(classes[name], []).extend(words)
        elements = ["block", "call", "braces", "parentheses", "brackets", "declaration", "directive", "string", "number",
                    "vector", "name", "sign", *by_class, *(n for n in structure if n.endswith("_directive"))]
        rules = {
            "source_file": "repeat($._element)",
            "_element": "choice(" + ", ".join(f"$.{name}" for name in elements) + ")",
            "block": "prec(1, seq(field('word', choice($.word, $.name, $.value_word)), $.braces))",
            "call": "prec(1, seq(field('function', choice($.name, $.function_word)), $.parentheses))",
            "braces": "seq('{', repeat($._element), '}')",
            "parentheses": "seq('(', repeat($._element), ')')",
            "brackets": "seq('[', repeat($._element), ']')",
            "declaration": f"prec.right(seq({self.hash('DECLARE')}, optional(field('name', $.name))))",
            "directive": "choice(" + ", ".join(self.plain()) + ")",
            **structure,
            **{name: "choice(" + ", ".join(f"'{word}'" for word in sorted(set(words))) + ")"
               for name, words in by_class.items()},
            "string": r"/" + r'"([^"\\]|\\[^])*"' + "/",
            "number": "/" + self.regular["number"] + "/",
            "vector": "token(prec(1, /" + self.vector + "/))",
            "name": "/" + self.name + "/",
            "sign": "choice(" + ", ".join(f"'{sign}'" for sign in self.signs) + ")",
            "comment": r"token(seq('//', /[^\r\n]*/))",
        }
        body = "\n".join(f"    {name}: $ => {rule}," for name, rule in rules.items())
        return f"""// SPDX-License-Identifier: GPL-3.0-or-later
// Made by grammar/tree_sitter.py of candelabra, which also says how it differs from the language.
// Between # and its word there may be blanks.
const hash = ($, ...words) => alias(token(seq('#', /[ \\t]*/, choice(...words))), $.hash_word);

module.exports = grammar({{
  name: 'pov',
  word: $ => $.name,
  extras: $ => [/{self.regular['blank']}/, $.comment, $.block_comment],
  externals: $ => [$.block_comment],
  rules: {{
{body}
  }},
}});
"""


scanner = r"""// SPDX-License-Identifier: GPL-3.0-or-later
// Comments, which lie in comments.
#include "tree_sitter/parser.h"

enum TokenType { BLOCK_COMMENT };

void *tree_sitter_pov_external_scanner_create(void) { return 0; }
void tree_sitter_pov_external_scanner_destroy(void *state) { (void)state; }
unsigned tree_sitter_pov_external_scanner_serialize(void *state, char *buffer) {
  (void)state;
  (void)buffer;
  return 0;
}
void tree_sitter_pov_external_scanner_deserialize(void *state, const char *buffer, unsigned length) {
  (void)state;
  (void)buffer;
  (void)length;
}

static bool take(TSLexer *lexer, char sign) {
  if (lexer->lookahead != sign) return false;
  lexer->advance(lexer, false);
  return true;
}

static bool is_blank(int c) { return c == ' ' || (c >= '\t' && c <= '\r') || c == 0x1a; }

bool tree_sitter_pov_external_scanner_scan(void *state, TSLexer *lexer, const bool *valid) {
  (void)state;
  if (!valid[BLOCK_COMMENT]) return false;
  while (is_blank(lexer->lookahead)) lexer->advance(lexer, true);
  if (!take(lexer, '/') || !take(lexer, '*')) return false;
  for (int depth = 1; depth > 0 && !lexer->eof(lexer);) {
    if (take(lexer, '*')) {
      if (take(lexer, '/')) --depth;
    } else if (take(lexer, '/')) {
      if (take(lexer, '*')) ++depth;
    } else {
      lexer->advance(lexer, false);
    }
  }
  lexer->result_symbol = BLOCK_COMMENT;
  return true;
}
"""

highlights = """; SPDX-License-Identifier: GPL-3.0-or-later
(comment) @comment
(block_comment) @comment
(string) @string
(number) @number
(vector) @number
(constant) @constant.builtin
(function_word) @function.builtin
(colour_word) @property
(value_word) @type
(word) @property
(block word: (word) @type)
(block word: (name) @type)
(call function: (name) @function.call)
(declaration name: (name) @variable)
(macro_directive name: (name) @function)
(hash_word) @keyword.directive
(sign) @operator
(braces (name) @property (#any-of? @property OWN_WORDS))
["{" "}" "(" ")" "[" "]"] @punctuation.bracket
"""

folds = """; SPDX-License-Identifier: GPL-3.0-or-later
[(braces) (parentheses) (if_directive) (branch) (while_directive) (for_directive) (switch_directive) (case)
 (macro_directive) (block_comment)] @fold
"""

facts = {"grammars": [{"name": "pov", "scope": "source.pov", "path": ".", "file-types": ["pov", "inc"],
                       "highlights": "queries/highlights.scm"}],
         "metadata": {"version": "0.0.0", "license": "GPL-3.0-or-later", "description": "Scenes of Candelabra and POV-Ray",
                      "links": {}}}


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    for name in ("src", "queries"):
        (folder / name).mkdir(parents=True, exist_ok=True)
    version = subprocess.run([program, "--version"], check=True, capture_output=True, text=True).stdout.split()[1]
    facts["metadata"]["version"] = version
    (folder / "grammar.js").write_text(Grammar(program).text())
    (folder / "src/scanner.c").write_text(scanner)
    own = " ".join(f'"{word}"' for word in own_words(program))
    (folder / "queries/highlights.scm").write_text(highlights.replace("OWN_WORDS", own))
    (folder / "queries/folds.scm").write_text(folds)
    (folder / "tree-sitter.json").write_text(json.dumps(facts, indent=2) + "\n")


main()
