// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hover.h"

#include "editor/library_guide.h"
#include "objects/object_functions.h"
#include "scene/catalogue.h"
#include "text/message.h"
#include "text/trimmed.h"
#include "vocabulary/examples.h"
#include "vocabulary/glossary.h"
#include "vocabulary/manual.h"

#include <algorithm>
#include <iterator>

namespace candelabra {

namespace {

std::string fenced(std::string_view text) { return message("```pov\n", text, "\n```\n"); }

/// The example below an explanation.
std::string with_example(std::string_view example) {
    return example.empty() ? "" : "\n\n" + fenced(example);
}

std::string function_help(std::string_view word) {
    for (const FunctionInfo& each : all_functions())
        if (each.name == word)
            return message(fenced(message(each.name, "(", each.arguments, ")")), each.help,
                           with_example(each.example));
    return {};
}

/// Returns help on the word in a block of that name: as a field of its item, or as one of its
/// kinds.
std::string help_in_block(std::string_view word, std::string_view block) {
    for (const ItemGroup& group : catalogue())
        for (const ItemInfo* item : group.items) {
            if (item->name != block && group.block != block) continue;
            if (item->name == word && group.block == block) return fenced(manual(*item, block));
            for (std::size_t i = 0; i < item->fields.size(); ++i)
                if (item->fields[i].name == word)
                    return message(fenced(message(word, " ", values(*item, i))),
                                   item->fields[i].help, "\n\nin `", item->name, "`",
                                   with_example(example_of(word, item->examples)));
        }
    return {};
}

std::string item_help(std::string_view word) {
    std::string text;
    for (const ItemGroup& group : catalogue())
        for (const ItemInfo* item : group.items)
            if (item->name == word) text += fenced(manual(*item, group.block));
    return text;
}

std::string word_help(const EditedFile& file, const Token& token, const Names& names) {
    const std::string_view word = file.part({token.first, token.last});
    for (const NameId block : blocks_around(file, token.first)) {
        std::string text = help_in_block(word, names.spelling(block));
        if (!text.empty()) return text;
    }
    std::string text = function_help(word);
    if (text.empty()) text = item_help(word);
    if (const GlossaryEntry* entry = glossary_entry(word); entry && text.empty())
        text = message(fenced(entry->form), entry->help,
                       with_example(example_of(word, entry->examples)));
    return text;
}

std::size_t line_start(std::string_view text, std::size_t offset) {
    const std::size_t end = text.rfind('\n', offset == 0 ? 0 : offset - 1);
    return offset == 0 || end == text.npos ? 0 : end + 1;
}

constexpr std::string_view blanks_of_line = " \t\r";

std::string_view line_at(std::string_view text, std::size_t offset) {
    const std::size_t first = line_start(text, offset);
    return trimmed(text.substr(first, text.find('\n', first) - first), blanks_of_line);
}

/// Returns the // comment lines directly above a place.
std::string comment_above(std::string_view text, std::size_t offset) {
    std::string comment;
    for (std::size_t first = line_start(text, offset); first > 0;) {
        first = line_start(text, first - 1);
        std::string_view line = line_at(text, first);
        if (!line.starts_with("//")) break;
        line.remove_prefix(std::min(line.find_first_not_of('/'), line.size()));
        comment = message(trimmed(line, blanks_of_line), "\n", comment);
    }
    return comment;
}

/// Returns the library's own description of one of its macros; empty if there is none.
std::string library_help(const EditedFile& file, std::string_view name) {
    const LibraryFile library = library_file({}, file.text);
    const LibraryMacro* const macro = find_macro(library, name);
    if (!macro || macro->help.empty()) return {};
    const std::string value = macro->value.empty() ? "" : " -> " + macro->value;
    return message(fenced(macro->form), macro->help, "\n\n",
                   macro->example.empty() ? "" : fenced(macro->example + value));
}

std::string name_help(Workspace& workspace, const Workspace::Found& found) {
    const EditedFile& file = *found.file;
    const std::uint32_t place = found.declaration->place.first;
    std::string text;
    if (found.declaration->kind == DeclaredName::macro && workspace.in_library(file.path))
        text = library_help(file, workspace.names().spelling(found.declaration->name));
    if (text.empty()) {
        const std::string comment = comment_above(file.text, place);
        text = message(fenced(line_at(file.text, place)), comment, comment.empty() ? "" : "\n");
    }
    return message(text, "in `", file.path.substr(file.path.rfind('/') + 1), "`");
}

}  // namespace

std::vector<NameId> blocks_around(const EditedFile& file, std::uint32_t offset) {
    std::vector<NameId> blocks;
    int closed = 0;
    const auto end = std::ranges::lower_bound(file.tokens, offset, {}, &Token::first);
    for (auto token = end; token != file.tokens.begin();) {
        --token;
        if (token->kind == TokenKind::close_brace) ++closed;
        if (token->kind != TokenKind::open_brace || closed-- > 0) continue;
        closed = 0;
        if (token == file.tokens.begin()) break;
        const Token& word = *std::prev(token);
        if (word.kind == TokenKind::word || word.kind == TokenKind::layer ||
            word.kind == TokenKind::name)
            blocks.push_back(NameId(word.value));
    }
    return blocks;
}

std::optional<Hover> hover(Workspace& workspace, const std::string& path, std::uint32_t offset) {
    const FileHandle file = workspace.file(path);
    const Token* const token = file ? file->token_at(offset) : nullptr;
    if (!token) return std::nullopt;
    std::string text;
    if (token->kind == TokenKind::name) {
        const auto found = workspace.declarations(NameId(token->value), path, offset);
        if (!found.empty()) text = name_help(workspace, found.front());
    }
    if (text.empty()) text = word_help(*file, *token, workspace.names());
    if (text.empty()) return std::nullopt;
    return Hover{std::move(text), {token->first, token->last}};
}

}  // namespace candelabra
