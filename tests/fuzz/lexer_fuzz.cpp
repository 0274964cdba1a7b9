// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as tokens: no crash, no hang, and every token lies inside the text, behind the one
// before it.
#include "fuzz/target.h"
#include "syntax/lexer.h"

#include <cstdlib>

using namespace candelabra;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    SourceStore sources;
    const SourceId id = sources.add("input", {reinterpret_cast<const char*>(data), size});
    static const Names reserved;  // making them anew takes longer than most inputs
    Names names = reserved;
    Tree tree;
    tree.source = id;
    Diagnostics diagnostics;
    Lexer lexer(id, sources, names, tree, diagnostics);
    std::uint32_t end = 0;
    for (Token token = lexer.next(); token.kind != TokenKind::end_of_file; token = lexer.next()) {
        if (token.first < end || token.last <= token.first || token.last > size) std::abort();
        end = token.last;
    }
    return 0;
}
