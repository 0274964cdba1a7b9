// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/language_server.h"

#include "editor/hover.h"
#include "editor/layout.h"
#include "editor/problems.h"
#include "editor/renaming.h"
#include "editor/suggestions.h"
#include "editor/swatches.h"

#include <algorithm>
#include <array>
#include <map>

namespace {

struct Method {
    std::string_view name;
    Json (LanguageServer::*answer)(const Json&);
};

constexpr auto methods = std::array{
    Method{"initialize", &LanguageServer::initialize},
    Method{"shutdown", &LanguageServer::shutdown},
    Method{"exit", &LanguageServer::exit},
    Method{"textDocument/didOpen", &LanguageServer::did_open},
    Method{"textDocument/didChange", &LanguageServer::did_change},
    Method{"textDocument/didSave", &LanguageServer::did_save},
    Method{"textDocument/didClose", &LanguageServer::did_close},
    Method{"textDocument/hover", &LanguageServer::hover},
    Method{"textDocument/completion", &LanguageServer::completion},
    Method{"textDocument/definition", &LanguageServer::definition},
    Method{"textDocument/references", &LanguageServer::references},
    Method{"textDocument/rename", &LanguageServer::rename},
    Method{"textDocument/documentSymbol", &LanguageServer::symbols},
    Method{"textDocument/documentColor", &LanguageServer::colours},
    Method{"textDocument/colorPresentation", &LanguageServer::colour_texts},
    Method{"textDocument/formatting", &LanguageServer::formatting},
};

constexpr int method_not_found = -32601;
constexpr int invalid_message = -32600;
constexpr int request_failed = -32803;

/// A member of a member ... of an object; null when there is none.
template <class... Names>
Json within(const Json& object, const Names&... names) {
    const Json* at = &object;
    const auto descend = [&](const char* name) {
        if (!at) return;
        const auto found = at->is_object() ? at->find(name) : at->end();
        at = at->is_object() && found != at->end() ? &*found : nullptr;
    };
    (descend(names), ...);
    return at ? *at : Json();
}

std::string text(const Json& json) { return json.is_string() ? json.get<std::string>() : ""; }

std::string document(const Json& parameters) {
    return path_of(text(within(parameters, "textDocument", "uri")));
}

double channel(const Json& colour, const char* name) {
    const Json value = within(colour, name);
    return value.is_number() ? value.get<double>() : 0;
}

/// The protocol's numbers for what a suggestion is.
int completion_kind(Suggestion::Kind kind) {
    switch (kind) {
        case Suggestion::field:
            return 5;
        case Suggestion::item:
            return 7;
        case Suggestion::function:
        case Suggestion::macro:
            return 3;
        case Suggestion::name:
            return 6;
        case Suggestion::file:
            return 17;
        case Suggestion::directive:
        case Suggestion::word:
            break;
    }
    return 14;
}

/// Ranges of places in several files, of which there may be many.
class Ranges {
public:
    explicit Ranges(Workspace& workspace) : workspace_(workspace) {}

    Json of(const Mention& mention) {
        auto known = tables_.find(mention.path);
        if (known == tables_.end()) {
            FileHandle file = workspace_.file(mention.path);
            const LineTable table(file ? std::string_view(file->text) : std::string_view());
            known = tables_.emplace(mention.path, std::pair(std::move(file), table)).first;
        }
        return known->second.second.range_of(mention.place);
    }

private:
    Workspace& workspace_;
    std::map<std::string, std::pair<FileHandle, LineTable>>
        tables_;  ///< the handles hold the texts
};

}  // namespace

void LanguageServer::send(const Json& message) {
    // Bytes of a scene that are no UTF-8 become a replacement character.
    send_(message.dump(-1, ' ', false, Json::error_handler_t::replace));
}

void LanguageServer::receive(std::string_view message) {
    const Json request = Json::parse(message, nullptr, false);
    const std::string name = text(within(request, "method"));
    const Json id = within(request, "id");
    const auto refuse = [&](int code, const std::string& why) {
        send({{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", code}, {"message", why}}}});
    };
    if (name.empty()) {
        // An answer to something that was never asked, or noise.
        if (!request.is_object()) refuse(invalid_message, "this is no message");
        return;
    }
    const auto* const method = std::ranges::find(methods, name, &Method::name);
    if (method == methods.end()) {
        if (!id.is_null()) refuse(method_not_found, "there is no method " + name);
        return;
    }
    failure_.clear();
    const Json result = (this->*method->answer)(within(request, "params"));
    if (id.is_null()) return;
    if (!failure_.empty()) return refuse(request_failed, failure_);
    send({{"jsonrpc", "2.0"}, {"id", id}, {"result", result}});
}

void LanguageServer::publish(const std::string& path, const std::vector<Json>& problems) {
    send({{"jsonrpc", "2.0"},
          {"method", "textDocument/publishDiagnostics"},
          {"params", {{"uri", uri_of(path)}, {"diagnostics", problems}}}});
}

void LanguageServer::catch_up() {
    // A scene's problems may lie in any file, and each file's in any scene: all are looked at.
    changed_.clear();
    std::map<std::string, std::vector<Json>> all;
    for (const std::string& path : workspace_.open_files()) {
        Report result;
        report(workspace_, path, scratch_, result);
        for (auto& [shown_in, list] : problems(result, workspace_, path)) {
            std::vector<Json>& there = all[shown_in];
            for (Json& each : list)
                if (std::ranges::find(there, each) == there.end()) there.push_back(each);
        }
    }
    for (const auto& [path, list] : all) publish(path, list);
}

Json LanguageServer::initialize(const Json&) {
    return {{"capabilities",
             {{"textDocumentSync", {{"openClose", true}, {"change", 1}, {"save", true}}},
              {"hoverProvider", true},
              {"completionProvider", {{"triggerCharacters", {"#", "\""}}}},
              {"definitionProvider", true},
              {"referencesProvider", true},
              {"renameProvider", true},
              {"documentSymbolProvider", true},
              {"colorProvider", true},
              {"documentFormattingProvider", true}}},
            {"serverInfo", {{"name", "candelabra"}}}};
}

Json LanguageServer::shutdown(const Json&) {
    shut_down_ = true;
    return nullptr;
}

Json LanguageServer::exit(const Json&) {
    ended_ = true;
    return nullptr;
}

Json LanguageServer::did_open(const Json& parameters) {
    const std::string path = document(parameters);
    workspace_.open(path, text(within(parameters, "textDocument", "text")));
    changed_.insert(path);
    return nullptr;
}

Json LanguageServer::did_change(const Json& parameters) {
    const Json changes = within(parameters, "contentChanges");
    if (!changes.is_array() || changes.empty()) return nullptr;
    const std::string path = document(parameters);
    workspace_.open(path, text(within(changes.back(), "text")));
    changed_.insert(path);
    return nullptr;
}

Json LanguageServer::did_save(const Json& parameters) {
    changed_.insert(document(parameters));
    return nullptr;
}

Json LanguageServer::did_close(const Json& parameters) {
    const std::string path = document(parameters);
    workspace_.close(path);
    publish(path, {});
    if (!workspace_.open_files().empty()) changed_.insert(path);
    return nullptr;
}

std::string LanguageServer::text_of(const std::string& path) {
    const FileHandle file = workspace_.file(path);
    return file ? file->text : std::string();
}

Json LanguageServer::hover(const Json& parameters) {
    const std::string path = document(parameters), content = text_of(path);
    const auto found =
        ::hover(workspace_, path, offset_of(content, within(parameters, "position")));
    if (!found) return nullptr;
    return {{"contents", {{"kind", "markdown"}, {"value", found->text}}},
            {"range", range_of(content, found->place)}};
}

Json LanguageServer::completion(const Json& parameters) {
    const std::string path = document(parameters), content = text_of(path);
    Json items = Json::array();
    for (const Suggestion& each :
         suggestions(workspace_, path, offset_of(content, within(parameters, "position")))) {
        std::string order = std::to_string(items.size());
        order.insert(0, 6 - std::min<std::size_t>(order.size(), 6), '0');
        items.push_back({{"label", each.text},
                         {"kind", completion_kind(each.kind)},
                         {"detail", each.detail},
                         {"documentation", each.help},
                         {"sortText", order}});
    }
    return items;
}

Json LanguageServer::definition(const Json& parameters) {
    const std::string path = document(parameters), content = text_of(path);
    const std::uint32_t offset = offset_of(content, within(parameters, "position"));
    const FileHandle file = workspace_.file(path);
    const Token* const token = file ? file->token_at(offset) : nullptr;
    if (!token) return nullptr;
    if (token->kind == TokenKind::text) {
        const auto found = workspace_.loader(directory_of(path))
                               .load(file->values.texts[token->value], directory_of(path));
        if (!found) return nullptr;
        return {{"uri", uri_of(found->path)}, {"range", range_of("", {})}};
    }
    if (token->kind != TokenKind::name) return nullptr;
    Json places = Json::array();
    for (const auto& each : workspace_.declarations(NameId(token->value), path, offset))
        places.push_back({{"uri", uri_of(each.file->path)},
                          {"range", range_of(each.file->text, each.declaration->place)}});
    return places;
}

Json LanguageServer::references(const Json& parameters) {
    const std::string path = document(parameters), content = text_of(path);
    Json places = Json::array();
    Ranges ranges(workspace_);
    for (const Mention& each :
         mentions(workspace_, path, offset_of(content, within(parameters, "position"))))
        places.push_back({{"uri", uri_of(each.path)}, {"range", ranges.of(each)}});
    return places;
}

Json LanguageServer::rename(const Json& parameters) {
    const std::string path = document(parameters), content = text_of(path);
    const std::string new_name = text(within(parameters, "newName"));
    const auto result =
        renaming(workspace_, path, offset_of(content, within(parameters, "position")), new_name);
    if (const auto* reason = std::get_if<std::string>(&result)) {
        fail(*reason);
        return nullptr;
    }
    Json changes = Json::object();
    Ranges ranges(workspace_);
    for (const Mention& each : *std::get_if<std::vector<Mention>>(&result))
        changes[uri_of(each.path)].push_back({{"range", ranges.of(each)}, {"newText", new_name}});
    return {{"changes", changes}};
}

Json LanguageServer::symbols(const Json& parameters) {
    const FileHandle file = workspace_.file(document(parameters));
    Json all = Json::array();
    if (!file) return all;
    const LineTable lines(file->text);
    for (const DeclaredName& each : file->declarations) {
        if (each.local || each.kind == DeclaredName::parameter) continue;
        const Json range = lines.range_of(each.place);
        all.push_back({{"name", std::string(workspace_.names().spelling(each.name))},
                       {"kind", each.kind == DeclaredName::macro ? 12 : 13},
                       {"range", range},
                       {"selectionRange", range}});
    }
    return all;
}

Json LanguageServer::colours(const Json& parameters) {
    const FileHandle file = workspace_.file(document(parameters));
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

Json LanguageServer::colour_texts(const Json& parameters) {
    const FileHandle file = workspace_.file(document(parameters));
    if (!file) return Json::array();
    const Json colour = within(parameters, "color");
    const Part place{offset_of(file->text, within(parameters, "range", "start")),
                     offset_of(file->text, within(parameters, "range", "end"))};
    const auto text =
        recoloured(*file, workspace_.names(), place,
                   Vec3(channel(colour, "red"), channel(colour, "green"), channel(colour, "blue")));
    return text ? Json::array({{{"label", *text}}}) : Json::array();
}

Json LanguageServer::formatting(const Json& parameters) {
    const std::string content = text_of(document(parameters));
    const std::string better = laid_out(content);
    if (better == content) return Json::array();
    const Part all{0, static_cast<std::uint32_t>(content.size())};
    return Json::array({{{"range", range_of(content, all)}, {"newText", better}}});
}
