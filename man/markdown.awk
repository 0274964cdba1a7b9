# SPDX-License-Identifier: GPL-3.0-or-later
# Makes a manual page of Markdown: awk -f markdown.awk page.md > page.7.in
# It knows what man/tutorial.md has: a comment with the page's name, section and date, headings, paragraphs, `code`,
# **bold**, lists of terms (- `term`: text), and fenced blocks. The language of a block tells tests and the book what it is:
# `pov NAME` a scene, `pov` an addition to the scene before it, `sh` commands, `csv NAME` a file, `text` output.
function roff(text) {
    gsub(/\\/, "\\e", text)
    gsub(/-/, "\\-", text)
    if (text ~ /^[.']/) text = "\\&" text
    return text
}

# Replaces what stands between two marks by bold text.
function bold(text, mark,    at, rest, result) {
    while ((at = index(text, mark)) > 0) {
        rest = substr(text, at + length(mark))
        if (index(rest, mark) == 0) break
        result = result substr(text, 1, at - 1) "\\fB" substr(rest, 1, index(rest, mark) - 1) "\\fR"
        text = substr(rest, index(rest, mark) + length(mark))
    }
    return result text
}

function prose(text) { return bold(bold(roff(text), "**"), "`") }

function fail(why) {
    print FILENAME ":" FNR ": " why > "/dev/stderr"
    failed = 1
    exit 1
}

/^<!-- SPDX/ && !code { print ".\\\" " substr($0, 6, length($0) - 9); next }
/^<!-- [a-z-]+\([1-9]\) / && !code {
    name = substr($2, 1, length($2) - 3)
    print ".TH " toupper(name) " " substr($2, length($2) - 1, 1) " " $3 " \"Candelabra @VERSION@\" \"Candelabra's Book\""
    next
}
/^# / && !code {
    if (name == "") fail("the name of the page is missing")
    print ".SH NAME"
    print roff(name) " \\- " tolower(substr($0, 3, 1)) roff(substr($0, 4))
    print ".SH DESCRIPTION"
    begun = 1
    next
}
/^## / && !code { print ".SH " toupper(roff(substr($0, 4))); begun = 1; next }
/^```/ && code { print ".fi\n.RE"; code = 0; begun = 0; next }
/^```/ {
    kind = $1 == "```pov" ? ($2 == "" ? "fragment" : "scene") : $1 == "```csv" ? "file" : \
           $1 == "```sh" ? "command" : $1 == "```text" ? "output" : ""
    if (kind == "") fail("a block needs a language: pov, csv, sh or text")
    if (!begun) print ".PP"
    print ".\\\" " kind ($2 == "" ? "" : " " $2)
    print ".RS\n.nf"
    code = 1
    next
}
code { print roff($0); next }
/^- `[^`]*`: / {
    end = index(substr($0, 4), "`")
    print ".TP\n.B " roff(substr($0, 4, end - 1))
    print prose(substr($0, end + 6))
    begun = 1
    next
}
/^$/ { empty = 1; next }
{
    if (empty && !begun) print ".PP"
    empty = begun = 0
    sub(/^ +/, "")
    print prose($0)
}
END {
    if (code) fail("a block is open")
    exit failed
}
