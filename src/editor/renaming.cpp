// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/renaming.h"

#include "text/ascii.h"
#include "text/message.h"

#include <algorithm>

namespace candelabra {

namespace {

std::vector<Mention> mentions_of(NameId name, const std::vector<FileHandle>& files) {
    std::vector<Mention> found;
    for (const FileHandle& file : files)
        for (const Token& token : file->tokens)
            if (token.kind == TokenKind::name && NameId(token.value) == name)
                found.push_back({file->path, {token.first, token.last}});
    return found;
}

const Token* name_at(const FileHandle& file, std::uint32_t offset) {
    const Token* const token = file ? file->token_at(offset) : nullptr;
    return token && token->kind == TokenKind::name ? token : nullptr;
}

bool is_name(const std::string& text) {
    return !text.empty() && is_letter(text[0]) && std::ranges::all_of(text, in_name);
}

}  // namespace

std::vector<Mention> mentions(Workspace& workspace, const std::string& path, std::uint32_t offset) {
    const FileHandle file = workspace.file(path);
    const Token* const token = name_at(file, offset);
    return token ? mentions_of(NameId(token->value), workspace.around(path))
                 : std::vector<Mention>();
}

std::variant<std::vector<Mention>, std::string> renaming(Workspace& workspace,
                                                         const std::string& path,
                                                         std::uint32_t offset,
                                                         const std::string& new_name) {
    const FileHandle file = workspace.file(path);
    const Token* const token = name_at(file, offset);
    if (!token) return "only names that a scene declares can be renamed";
    if (!is_name(new_name)) return message("`", new_name, "` is no name");
    Names& names = workspace.names();
    const NameId wanted = names.intern(new_name);
    if (names.reserved(wanted)) return message("`", new_name, "` is a word of the language");
    const std::vector<FileHandle> files = workspace.around(path);
    const std::vector<Mention> taken = mentions_of(wanted, files);
    if (!taken.empty())
        return message("`", new_name, "` is used in `", taken.front().path, "` already");
    std::vector<Mention> found = mentions_of(NameId(token->value), files);
    for (const Mention& each : found)
        if (workspace.in_library(each.path))
            return message("`", names.spelling(NameId(token->value)),
                           "` belongs to the standard library");
    return found;
}

}  // namespace candelabra
