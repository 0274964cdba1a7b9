// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/signatures.h"

#include "bind/object_functions.h"
#include "editor/library_guide.h"
#include "text/message.h"

#include <algorithm>

namespace candelabra {

namespace {

/// The call around a place: the token of its name, and the number of commas before the place.
struct Call {
    const Token* name;
    std::size_t commas;
};

bool opens_group(TokenKind kind) {
    return kind == TokenKind::open_parenthesis || kind == TokenKind::open_bracket ||
           kind == TokenKind::open_brace;
}

bool closes_group(TokenKind kind) {
    return kind == TokenKind::close_parenthesis || kind == TokenKind::close_bracket ||
           kind == TokenKind::close_brace;
}

/// Whether `<` begins a vector; after a value it is a comparison.
bool begins_vector(const EditedFile& file, const Token& less) {
    if (&less == &file.tokens.front()) return true;
    const TokenKind before = std::prev(&less)->kind;
    return opens_group(before) || (before >= TokenKind::less && before <= TokenKind::no) ||
           before == TokenKind::comma;
}

/// Searches backwards for the innermost parenthesis that is open at the place. Commas inside a
/// vector that has begun are not counted.
std::optional<Call> call_around(const EditedFile& file, std::uint32_t offset) {
    int closed = 0;
    std::size_t commas = 0;
    const auto end = std::ranges::lower_bound(file.tokens, offset, {}, &Token::first);
    for (auto token = end; token != file.tokens.begin();) {
        --token;
        const bool vector = token->kind == TokenKind::less && begins_vector(file, *token);
        if (closes_group(token->kind) || token->kind == TokenKind::greater) ++closed;
        if (token->kind == TokenKind::comma && closed == 0) ++commas;
        if (!opens_group(token->kind) && !vector) continue;
        if (closed > 0) {
            --closed;
            continue;
        }
        commas = token->kind == TokenKind::open_parenthesis ? commas : 0;
        if (token->kind != TokenKind::open_parenthesis || token == file.tokens.begin()) {
            if (vector || token->kind == TokenKind::open_bracket) continue;
            return std::nullopt;
        }
        return Call{&*std::prev(token), commas};
    }
    return std::nullopt;
}

/// Returns the parts between the commas in a form's parentheses.
std::vector<std::string> parameters_of(std::string_view form) {
    const std::size_t open = form.find('(');
    if (open == form.npos || form.size() < open + 2) return {};
    std::string_view list = form.substr(open + 1, form.rfind(')') - open - 1);
    std::vector<std::string> result;
    while (!list.empty()) {
        const std::size_t comma = std::min(list.find(','), list.size());
        std::string_view one = list.substr(0, comma);
        while (one.starts_with(' ')) one.remove_prefix(1);
        if (!one.empty()) result.emplace_back(one);
        list.remove_prefix(std::min(comma + 1, list.size()));
    }
    return result;
}

Signature signature(std::string form, std::string help, std::size_t active) {
    Signature result;
    result.parameters = parameters_of(form);
    result.label = std::move(form);
    result.help = std::move(help);
    result.active = active;
    return result;
}

}  // namespace

std::optional<Signature> signature_at(Workspace& workspace, const std::string& path,
                                      std::uint32_t offset) {
    const FileHandle file = workspace.file(path);
    const std::optional<Call> call = file ? call_around(*file, offset) : std::nullopt;
    if (!call) return std::nullopt;
    const std::string_view name = file->part({call->name->first, call->name->last});
    for (const FunctionInfo& each : all_functions())
        if (each.name == name)
            return signature(message(each.name, "(", each.arguments, ")"), std::string(each.help),
                             call->commas);
    if (call->name->kind != TokenKind::name) return std::nullopt;
    for (const auto& found :
         workspace.declarations(NameId(call->name->value), path, call->name->first)) {
        if (found.declaration->kind != DeclaredName::macro) continue;
        const LibraryFile declaring = library_file({}, found.file->text);
        if (const LibraryMacro* macro = find_macro(declaring, name))
            return signature(macro->form, macro->help, call->commas);
    }
    return std::nullopt;
}

}  // namespace candelabra
