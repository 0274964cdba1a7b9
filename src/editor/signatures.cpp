// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/signatures.h"

#include "editor/library_guide.h"
#include "objects/object_functions.h"
#include "text/message.h"

#include <algorithm>
#include <iterator>

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

/// A group or a vector that is open at a place.
struct OpenGroup {
    const Token* opening;
    std::size_t commas = 0;  ///< in the group itself

    bool vector() const { return opening->kind == TokenKind::less; }
};

/// Follows the groups that are open from token to token.
class OpenGroups {
public:
    explicit OpenGroups(const EditedFile& file) : file_(file) {}

    void pass(const Token& token) {
        if (opens_group(token.kind) ||
            (token.kind == TokenKind::less && begins_vector(file_, token)))
            open.push_back({&token});
        else if (token.kind == TokenKind::comma && !open.empty())
            ++open.back().commas;
        else if (token.kind == TokenKind::greater && !open.empty() && open.back().vector())
            open.pop_back();
        else if (closes_group(token.kind)) {
            while (!open.empty() && open.back().vector()) open.pop_back();
            if (!open.empty()) open.pop_back();
        }
    }

    std::vector<OpenGroup> open;

private:
    const EditedFile& file_;
};

std::vector<OpenGroup> open_groups(const EditedFile& file, std::uint32_t offset) {
    OpenGroups groups(file);
    for (const Token& token : file.tokens) {
        if (token.first >= offset) break;
        groups.pass(token);
    }
    return groups.open;
}

/// Finds the innermost parenthesis that is open at the place, with the commas before the place.
/// Vectors and brackets may be open within it, blocks may not.
std::optional<Call> call_around(const EditedFile& file, std::uint32_t offset) {
    std::vector<OpenGroup> open = open_groups(file, offset);
    for (; !open.empty(); open.pop_back()) {
        const OpenGroup& group = open.back();
        if (group.vector() || group.opening->kind == TokenKind::open_bracket) continue;
        if (group.opening->kind != TokenKind::open_parenthesis ||
            group.opening == &file.tokens.front())
            return std::nullopt;
        return Call{std::prev(group.opening), group.commas};
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

/// Returns the signature of the macro, with one of its arguments active.
std::optional<Signature> macro_signature(Workspace& workspace, const EditedFile& file,
                                         const Token& call, std::size_t active) {
    if (call.kind != TokenKind::name) return std::nullopt;
    const std::string_view name = file.part({call.first, call.last});
    for (const auto& found : workspace.declarations(NameId(call.value), file.path, call.first)) {
        if (found.declaration->kind != DeclaredName::macro) continue;
        const LibraryFile declaring = library_file({}, found.file->text);
        if (const LibraryMacro* macro = find_macro(declaring, name))
            return signature(macro->form, macro->help, active);
    }
    return std::nullopt;
}

}  // namespace

std::vector<CallArgument> arguments_in(const EditedFile& file) {
    std::vector<CallArgument> result;
    OpenGroups groups(file);
    const Token* before = nullptr;
    for (const Token& token : file.tokens) {
        const bool begins = before && (before->kind == TokenKind::open_parenthesis ||
                                       before->kind == TokenKind::comma);
        const bool empty = token.kind == TokenKind::comma || closes_group(token.kind) ||
                           token.kind == TokenKind::end_of_file;
        if (begins && !empty && !groups.open.empty()) {
            const OpenGroup& group = groups.open.back();
            const Token* const first = file.tokens.data();
            const Token* const call = group.opening > first ? group.opening - 1 : nullptr;
            const bool defines = call && call > first && call[-1].kind == TokenKind::hash_macro;
            if (group.opening->kind == TokenKind::open_parenthesis && call && !defines)
                result.push_back({call, group.commas, &token});
        }
        groups.pass(token);
        before = &token;
    }
    return result;
}

std::optional<Signature> macro_signature(Workspace& workspace, const EditedFile& file,
                                         const Token& call) {
    return macro_signature(workspace, file, call, 0);
}

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
    return macro_signature(workspace, *file, *call->name, call->commas);
}

}  // namespace candelabra
