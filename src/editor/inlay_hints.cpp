// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/inlay_hints.h"

#include "editor/signatures.h"
#include "text/ascii.h"

#include <algorithm>
#include <iterator>
#include <map>

namespace candelabra {

namespace {

/// The names of the parameters, without what the macro accepts for them.
std::vector<std::string> names_of(const Signature& signature) {
    std::vector<std::string> names;
    for (const std::string& each : signature.parameters) {
        const auto end = std::ranges::find_if_not(each, in_name);
        names.emplace_back(each.begin(), end);
    }
    return names;
}

/// Whether the argument is only a name, and the parameter has the same one.
bool says_it_itself(const EditedFile& file, const CallArgument& argument,
                    const std::string& parameter) {
    const Token* const after = std::next(argument.token);
    const bool alone =
        after != file.tokens.data() + file.tokens.size() &&
        (after->kind == TokenKind::comma || after->kind == TokenKind::close_parenthesis);
    return alone &&
           same_letters(file.part({argument.token->first, argument.token->last}), parameter);
}

}  // namespace

std::vector<InlayHint> inlay_hints(Workspace& workspace, const std::string& path, Part part) {
    std::vector<InlayHint> hints;
    const FileHandle file = workspace.file(path);
    if (!file) return hints;
    std::map<std::uint32_t, std::vector<std::string>> known;  // by the place of the call
    for (const CallArgument& each : arguments_in(*file)) {
        if (each.token->first < part.first || each.token->first >= part.last) continue;
        auto names = known.find(each.call->first);
        if (names == known.end()) {
            const auto signature = macro_signature(workspace, *file, *each.call);
            names = known
                        .emplace(each.call->first,
                                 signature ? names_of(*signature) : std::vector<std::string>())
                        .first;
        }
        if (each.index >= names->second.size()) continue;
        const std::string& name = names->second[each.index];
        if (!name.empty() && !says_it_itself(*file, each, name))
            hints.push_back({each.token->first, name});
    }
    return hints;
}

}  // namespace candelabra
