// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/semantic_tokens.h"

#include "editor/extents.h"
#include "syntax/token_classes.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <unordered_map>
#include <unordered_set>

namespace candelabra {

namespace {

/// Resolves the names in a file: parameters within their macros, then names of the file itself,
/// then those of other files.
class Meanings {
public:
    Meanings(Workspace& workspace, const EditedFile& file) {
        const std::vector<Part> reach = extents(file);
        for (std::size_t i = 0; i < file.declarations.size(); ++i) {
            const DeclaredName& each = file.declarations[i];
            declared_at_.insert(each.place.first);
            if (each.kind == DeclaredName::parameter)
                parameters_[each.name].push_back(reach[i]);
            else
                names_.try_emplace(each.name, Meaning{kind_of(each), 0});
        }
        for (const FileHandle& other : workspace.around(file.path))
            if (other->path != file.path) add(*other, workspace.in_library(other->path));
    }

    std::optional<SemanticToken> of(const Token& token) const {
        SemanticToken found{{token.first, token.last}};
        if (declared_at_.contains(token.first)) found.modifiers = SemanticToken::declaration;
        const NameId name{token.value};
        if (is_parameter(name, token.first)) {
            found.kind = SemanticToken::parameter;
            return found;
        }
        const auto known = names_.find(name);
        if (known == names_.end()) return std::nullopt;
        found.kind = known->second.kind;
        found.modifiers |= known->second.modifiers;
        return found;
    }

private:
    struct Meaning {
        SemanticToken::Kind kind;
        std::uint8_t modifiers;
    };

    static SemanticToken::Kind kind_of(const DeclaredName& each) {
        return each.kind == DeclaredName::macro ? SemanticToken::macro : SemanticToken::variable;
    }

    void add(const EditedFile& file, bool library) {
        const std::uint8_t modifiers = library ? SemanticToken::of_library : 0;
        for (const DeclaredName& each : file.declarations)
            if (!each.local && each.kind != DeclaredName::parameter)
                names_.try_emplace(each.name, Meaning{kind_of(each), modifiers});
    }

    /// The macros that have the parameter are in source order.
    bool is_parameter(NameId name, std::uint32_t offset) const {
        const auto known = parameters_.find(name);
        if (known == parameters_.end()) return false;
        const auto next = std::ranges::upper_bound(known->second, offset, {}, &Part::first);
        return next != known->second.begin() && offset < std::prev(next)->last;
    }

    std::unordered_map<NameId, Meaning> names_;
    std::unordered_map<NameId, std::vector<Part>> parameters_;
    std::unordered_set<std::uint32_t> declared_at_;
};

class SemanticTokens {
public:
    SemanticTokens(Workspace& workspace, const EditedFile& file)
        : file_(file), meanings_(workspace, file) {}

    std::vector<SemanticToken> operator()() {
        auto comment = file_.comments.begin();
        for (std::size_t i = 0; i < file_.tokens.size(); ++i) {
            const Token& token = file_.tokens[i];
            for (; comment != file_.comments.end() && comment->first < token.first; ++comment)
                add({*comment, SemanticToken::comment});
            if (const auto found = meaning(i)) add(*found);
        }
        for (; comment != file_.comments.end(); ++comment) add({*comment, SemanticToken::comment});
        return std::move(all_);
    }

private:
    bool before_brace(std::size_t i) const {
        return i + 1 < file_.tokens.size() && file_.tokens[i + 1].kind == TokenKind::open_brace;
    }

    std::optional<SemanticToken> meaning(std::size_t i) const {
        using enum TokenKind;
        const Token& token = file_.tokens[i];
        const Part place{token.first, token.last};
        if (is_directive(token.kind)) return SemanticToken{place, SemanticToken::keyword};
        switch (token.kind) {
            case name:
                if (const auto declared = meanings_.of(token)) return declared;
                // Words that only this language has are not reserved.
                if (before_brace(i)) return SemanticToken{place, SemanticToken::type};
                return std::nullopt;
            case word:
            case layer:
                return SemanticToken{
                    place, before_brace(i) ? SemanticToken::type : SemanticToken::property};
            case constant:
                return SemanticToken{place, SemanticToken::constant};
            case unary_function:
            case function:
                return SemanticToken{place, SemanticToken::function};
            case colour_prefix:
            case channel:
            case colour:
                return SemanticToken{place, SemanticToken::property};
            case array:
            case function_literal:
                return SemanticToken{place, SemanticToken::type};
            case deprecated:
            case once:
            case unofficial:
            case powers:
            case mixed:
            case optional_list:
                return SemanticToken{place, SemanticToken::keyword};
            case number:
            case literal:
                return SemanticToken{place, SemanticToken::number};
            case text:
                return SemanticToken{place, SemanticToken::string};
            default:
                return std::nullopt;
        }
    }

    /// Splits tokens of several lines, which not all editors support.
    void add(SemanticToken token) {
        const Part whole = token.place;
        for (std::uint32_t first = whole.first; first < whole.last;) {
            const std::size_t end =
                std::min<std::size_t>(file_.text.find_first_of("\r\n", first), whole.last);
            token.place = {first, static_cast<std::uint32_t>(end)};
            if (end > first) all_.push_back(token);
            first = static_cast<std::uint32_t>(end) + 1;
        }
    }

    const EditedFile& file_;
    const Meanings meanings_;
    std::vector<SemanticToken> all_;
};

constexpr auto semantic_kind_names =
    std::to_array<std::string_view>({"comment", "keyword", "string", "number", "type", "property",
                                     "function", "enumMember", "macro", "parameter", "variable"});
constexpr auto semantic_modifier_names =
    std::to_array<std::string_view>({"declaration", "defaultLibrary"});

}  // namespace

std::span<const std::string_view> semantic_kinds() { return semantic_kind_names; }

std::span<const std::string_view> semantic_modifiers() { return semantic_modifier_names; }

std::vector<SemanticToken> semantic_tokens(Workspace& workspace, const std::string& path) {
    const FileHandle file = workspace.file(path);
    return file ? SemanticTokens(workspace, *file)() : std::vector<SemanticToken>();
}

}  // namespace candelabra
