// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a tree: no crash, no hang; what parses is written and read again to the same tree;
// all messages can be printed.
#include "fuzz/target.h"
#include "syntax/dump.h"
#include "syntax/lint.h"
#include "syntax/parser.h"
#include "syntax/print.h"
#include "text/excerpt.h"

#include <cstdlib>

using namespace candelabra;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    SourceStore sources;
    const SourceId id = sources.add("input", {reinterpret_cast<const char*>(data), size});
    static const Names reserved;  // making them anew takes longer than most inputs
    Names names = reserved;
    Diagnostics diagnostics;
    const Tree tree = parse(id, sources, names, diagnostics);
    lint(tree, names, diagnostics);
    for (const Diagnostic& each : diagnostics.all()) format(each, sources, false);
    if (diagnostics.failed()) return 0;
    Diagnostics again;
    const SourceId printed = sources.add("printed", print(tree, names));
    const Tree second = parse(printed, sources, names, again);
    if (again.failed() || dump(second, names) != dump(tree, names)) std::abort();
    return 0;
}
