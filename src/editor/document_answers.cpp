// SPDX-License-Identifier: GPL-3.0-or-later
// Handlers for whole documents: outline, semantic tokens, folding, links, colours, layout.
#include "editor/extents.h"
#include "editor/folding.h"
#include "editor/highlights.h"
#include "editor/inlay_hints.h"
#include "editor/knobs.h"
#include "editor/language_server.h"
#include "editor/layout.h"
#include "editor/links.h"
#include "editor/ranges.h"
#include "editor/semantic_tokens.h"
#include "editor/swatches.h"
#include "editor/symbols.h"

namespace candelabra {

namespace {

/// Returns the protocol's SymbolKind.
int symbol_kind(bool is_macro) { return is_macro ? 12 : 13; }

const char* folding_kind(Fold::Kind kind) {
    return kind == Fold::comment ? "comment" : kind == Fold::imports ? "imports" : "region";
}

/// Encodes the tokens in the range as five numbers each: line and column relative to the token
/// before, length in UTF-16 code units, kind and modifiers.
Json encoded(const std::vector<SemanticToken>& tokens, std::string_view text, Part range) {
    Json numbers = Json::array();
    TextWalk walk(text);
    int line = 0, column = 0;
    for (const SemanticToken& each : tokens) {
        if (each.place.last <= range.first || each.place.first >= range.last) continue;
        walk.go_to(each.place.first);
        const int first = walk.column();
        numbers.push_back(walk.line() - line);
        numbers.push_back(walk.line() == line ? first - column : first);
        line = walk.line();
        column = first;
        walk.go_to(each.place.last);
        numbers.push_back(walk.column() - first);
        numbers.push_back(int{each.kind});
        numbers.push_back(each.modifiers);
    }
    return {{"data", std::move(numbers)}};
}

}  // namespace

Json LanguageServer::highlights(Parameters& parameters) {
    const FileHandle file = open_file(parameters);
    if (!file) return nullptr;
    const std::uint32_t offset = parameters.place(file->text, {"position"});
    const LineTable lines(file->text);
    Json all = Json::array();
    for (const WordHighlight& each : candelabra::highlights(*file, offset))
        all.push_back({{"range", lines.range_of(each.place)}, {"kind", int{each.kind} + 1}});
    return all;
}

Json LanguageServer::workspace_symbols(Parameters& parameters) {
    const std::string query = parameters.text({"query"});
    if (!parameters.problem().empty()) return nullptr;
    Json all = Json::array();
    Ranges ranges(workspace_);
    for (const Symbol& each : candelabra::symbols(workspace_, query))
        all.push_back(
            {{"name", each.name},
             {"kind", symbol_kind(each.is_macro)},
             {"containerName", each.path.substr(each.path.rfind('/') + 1)},
             {"location",
              {{"uri", uri_of(each.path)}, {"range", ranges.of(each.path, each.place)}}}});
    return all;
}

Json LanguageServer::semantic_tokens(Parameters& parameters) {
    const FileHandle file = open_file(parameters);
    if (!file) return nullptr;
    const Part all{0, static_cast<std::uint32_t>(file->text.size())};
    return encoded(candelabra::semantic_tokens(workspace_, file->path), file->text, all);
}

Json LanguageServer::semantic_tokens_of_range(Parameters& parameters) {
    const FileHandle file = open_file(parameters);
    if (!file) return nullptr;
    const Part range = parameters.range(file->text, "range");
    if (!parameters.problem().empty()) return nullptr;
    return encoded(candelabra::semantic_tokens(workspace_, file->path), file->text, range);
}

Json LanguageServer::folding(Parameters& parameters) {
    const FileHandle file = open_file(parameters);
    if (!file) return nullptr;
    Json all = Json::array();
    for (const Fold& each : folds(*file))
        all.push_back({{"startLine", each.first_line},
                       {"endLine", each.last_line},
                       {"kind", folding_kind(each.kind)}});
    return all;
}

Json LanguageServer::inlay_hints(Parameters& parameters) {
    const FileHandle file = open_file(parameters);
    if (!file) return nullptr;
    const Part range = parameters.range(file->text, "range");
    if (!parameters.problem().empty()) return nullptr;
    constexpr int kind_of_parameter = 2;
    const LineTable lines(file->text);
    Json all = Json::array();
    for (const InlayHint& each : candelabra::inlay_hints(workspace_, file->path, range))
        all.push_back({{"position", lines.range_of({each.offset, each.offset})["start"]},
                       {"label", each.name + ":"},
                       {"kind", kind_of_parameter},
                       {"paddingRight", true}});
    return all;
}

Json LanguageServer::knobs(Parameters& parameters) {
    const FileHandle file = open_file(parameters);
    if (!file) return nullptr;
    Json all = Json::array();
    for (const Knob& each : candelabra::knobs(file->text)) all.push_back(json_of(each, each.value));
    return all;
}

Json LanguageServer::links(Parameters& parameters) {
    const FileHandle file = open_file(parameters);
    if (!file) return nullptr;
    const LineTable lines(file->text);
    Json all = Json::array();
    for (const Link& each : candelabra::links(workspace_, file->path))
        all.push_back({{"range", lines.range_of(each.place)}, {"target", uri_of(each.path)}});
    return all;
}

Json LanguageServer::symbols(Parameters& parameters) {
    const FileHandle file = open_file(parameters);
    Json all = Json::array();
    if (!file) return all;
    const LineTable lines(file->text);
    const std::vector<Part> whole = extents(*file);
    for (std::size_t i = 0; i < whole.size(); ++i) {
        const DeclaredName& each = file->declarations[i];
        if (each.local || each.kind == DeclaredName::parameter) continue;
        all.push_back({{"name", std::string(workspace_.names().spelling(each.name))},
                       {"kind", symbol_kind(each.kind == DeclaredName::macro)},
                       {"range", lines.range_of(whole[i])},
                       {"selectionRange", lines.range_of(each.place)}});
    }
    return all;
}

Json LanguageServer::colours(Parameters& parameters) {
    const FileHandle file = open_file(parameters);
    Json all = Json::array();
    if (!file) return all;
    const LineTable lines(file->text);
    for (const Swatch& each : swatches(*file, workspace_.names()))
        all.push_back({{"range", lines.range_of(each.place)},
                       {"color",
                        {{"red", each.srgb.x},
                         {"green", each.srgb.y},
                         {"blue", each.srgb.z},
                         {"alpha", 1}}}});
    return all;
}

Json LanguageServer::colour_texts(Parameters& parameters) {
    const FileHandle file = open_file(parameters);
    if (!file) return nullptr;
    const Vec3 colour(parameters.channel({"color", "red"}), parameters.channel({"color", "green"}),
                      parameters.channel({"color", "blue"}));
    const Part place = parameters.range(file->text, "range");
    if (!parameters.problem().empty()) return nullptr;
    const auto text = recoloured(*file, workspace_.names(), place, colour);
    return text ? Json::array({{{"label", *text}}}) : Json::array();
}

Json LanguageServer::formatting(Parameters& parameters) {
    const FileHandle file = open_file(parameters);
    if (!file) return nullptr;
    const std::string& content = file->text;
    const std::string better = laid_out(content);
    if (better == content) return Json::array();
    const Part all{0, static_cast<std::uint32_t>(content.size())};
    return Json::array({{{"range", range_of(content, all)}, {"newText", better}}});
}

Json LanguageServer::range_formatting(Parameters& parameters) {
    const FileHandle file = open_file(parameters);
    if (!file) return nullptr;
    const Part range = parameters.range(file->text, "range");
    if (!parameters.problem().empty()) return nullptr;
    const LaidOutPart better = laid_out_lines(file->text, range);
    if (better.text == file->part(better.place)) return Json::array();
    return Json::array({{{"range", range_of(file->text, better.place)}, {"newText", better.text}}});
}

}  // namespace candelabra
