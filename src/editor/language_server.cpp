// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/language_server.h"

#include "editor/corrections.h"
#include "editor/hover.h"
#include "editor/ranges.h"
#include "editor/renaming.h"
#include "editor/semantic_tokens.h"
#include "editor/signatures.h"
#include "editor/suggestions.h"

#include "text/message.h"

#include <algorithm>
#include <array>
#include <map>
#include <new>

namespace candelabra {

namespace {

struct Method {
    std::string_view name;
    Json (LanguageServer::*answer)(Parameters&);
    bool question = false;  ///< without effect unless an answer is expected
};

constexpr auto methods = std::array{
    Method{"initialize", &LanguageServer::initialize, true},
    Method{"shutdown", &LanguageServer::shutdown, true},
    Method{"exit", &LanguageServer::exit},
    Method{"textDocument/didOpen", &LanguageServer::did_open},
    Method{"textDocument/didChange", &LanguageServer::did_change},
    Method{"textDocument/didSave", &LanguageServer::did_save},
    Method{"textDocument/didClose", &LanguageServer::did_close},
    Method{"textDocument/hover", &LanguageServer::hover, true},
    Method{"textDocument/completion", &LanguageServer::completion, true},
    Method{"textDocument/signatureHelp", &LanguageServer::signature_help, true},
    Method{"textDocument/codeAction", &LanguageServer::code_actions, true},
    Method{"textDocument/definition", &LanguageServer::definition, true},
    Method{"textDocument/references", &LanguageServer::references, true},
    Method{"textDocument/rename", &LanguageServer::rename, true},
    Method{"textDocument/prepareRename", &LanguageServer::prepare_rename, true},
    Method{"textDocument/documentHighlight", &LanguageServer::highlights, true},
    Method{"textDocument/documentSymbol", &LanguageServer::symbols, true},
    Method{"workspace/symbol", &LanguageServer::workspace_symbols, true},
    Method{"textDocument/semanticTokens/full", &LanguageServer::semantic_tokens, true},
    Method{"textDocument/semanticTokens/range", &LanguageServer::semantic_tokens_of_range, true},
    Method{"textDocument/foldingRange", &LanguageServer::folding, true},
    Method{"textDocument/inlayHint", &LanguageServer::inlay_hints, true},
    Method{"candelabra/knobs", &LanguageServer::knobs, true},
    Method{"textDocument/documentLink", &LanguageServer::links, true},
    Method{"textDocument/documentColor", &LanguageServer::colours, true},
    Method{"textDocument/colorPresentation", &LanguageServer::colour_texts, true},
    Method{"textDocument/formatting", &LanguageServer::formatting, true},
    Method{"textDocument/rangeFormatting", &LanguageServer::range_formatting, true},
};

// Error codes of JSON-RPC and of the protocol.
constexpr int parse_error = -32700;
constexpr int invalid_request = -32600;
constexpr int method_not_found = -32601;
constexpr int invalid_params = -32602;
constexpr int internal_error = -32603;
constexpr int not_initialized = -32002;
constexpr int request_failed = -32803;

/// Returns the protocol's CompletionItemKind of a suggestion.
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

}  // namespace

void LanguageServer::send(const Json& message) {
    // Bytes of a scene that are not valid UTF-8 become replacement characters.
    send_(message.dump(-1, ' ', false, Json::error_handler_t::replace));
}

void LanguageServer::refuse(const Json& id, int code, const std::string& why) {
    send({{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", code}, {"message", why}}}});
}

void LanguageServer::receive(std::string_view message) {
    Json id;
    try {
        if (nests_deeper(message, deepest))
            return refuse(id, invalid_request,
                          candelabra::message("a message nests at most ", deepest, " deep"));
        receive(Json::parse(message, nullptr, false), id);
    } catch (const std::bad_alloc&) {
        refuse(id, internal_error, "there is not enough memory for this");
    }
}

void LanguageServer::receive_too_long() {
    refuse(nullptr, invalid_request, "the message is too long to be read");
}

int LanguageServer::untimely(std::string_view method) const {
    if (method == "exit") return 0;
    if (shut_down_ || (initialized_ && method == "initialize")) return invalid_request;
    return initialized_ || method == "initialize" ? 0 : not_initialized;
}

void LanguageServer::receive(const Json& request, Json& id) {
    if (request.is_discarded()) return refuse(id, parse_error, "the message is no JSON in UTF-8");
    if (!request.is_object()) return refuse(id, invalid_request, "this is no message");
    // A response, although this server sends no requests.
    if (request.contains("result") || request.contains("error")) return;
    const bool waits = request.contains("id");
    if (waits && !request["id"].is_string() && !request["id"].is_number_integer())
        return refuse(id, invalid_request, "`id` must be a string or an integer");
    if (waits) id = request["id"];
    if (!request.contains("method") || !request["method"].is_string())
        return refuse(id, invalid_request, "`method` must be a string");
    const auto& name = request["method"].get_ref<const std::string&>();
    const auto* const method = std::ranges::find(methods, name, &Method::name);
    if (method == methods.end()) {
        if (waits) refuse(id, method_not_found, message("there is no method ", name));
        return;
    }
    if (const int code = untimely(name)) {
        if (waits)
            refuse(id, code,
                   code == not_initialized ? "the first request must be `initialize`"
                                           : message("it is too late for `", name, '`'));
        return;
    }
    if (method->question && !waits) return;
    failure_.clear();
    const Json none;
    Parameters parameters(request.contains("params") ? request["params"] : none);
    const Json result = (this->*method->answer)(parameters);
    if (!waits && !parameters.problem().empty())
        return send(
            {{"jsonrpc", "2.0"},
             {"method", "window/logMessage"},
             {"params", {{"type", 1}, {"message", message(name, ": ", parameters.problem())}}}});
    if (!waits) return;
    if (!parameters.problem().empty()) return refuse(id, invalid_params, parameters.problem());
    if (!failure_.empty()) return refuse(id, request_failed, failure_);
    send({{"jsonrpc", "2.0"}, {"id", id}, {"result", result}});
}

void LanguageServer::publish(const std::string& path, const std::vector<Json>& problems) {
    send({{"jsonrpc", "2.0"},
          {"method", "textDocument/publishDiagnostics"},
          {"params", {{"uri", uri_of(path)}, {"diagnostics", problems}}}});
}

void LanguageServer::catch_up(const Meanwhile& serve) {
    // A scene's problems may be in any file, and a file's problems may come from any scene: check
    // all.
    changed_.clear();
    bool goes_on = true;
    const Meanwhile meanwhile{serve.descriptor, [&] {
                                  goes_on = serve.serve() && changed_.empty() && !ended_;
                                  return goes_on;
                              }};
    std::map<std::string, std::vector<Json>> all;
    for (const std::string& path : workspace_.open_files()) {
        auto found = check(workspace_, path, scratch_, limits_, meanwhile);
        if (!goes_on) return;
        for (auto& [shown_in, list] : found) {
            std::vector<Json>& there = all[shown_in];
            for (Json& each : list)
                if (std::ranges::find(there, each) == there.end()) there.push_back(each);
        }
    }
    for (const auto& [path, list] : all) publish(path, list);
}

Json LanguageServer::initialize(Parameters&) {
    initialized_ = true;
    return {{"capabilities",
             {{"positionEncoding", "utf-16"},
              {"textDocumentSync", {{"openClose", true}, {"change", 2}, {"save", true}}},
              {"hoverProvider", true},
              {"completionProvider", {{"triggerCharacters", {"#", "\""}}}},
              {"signatureHelpProvider", {{"triggerCharacters", {"(", ","}}}},
              {"codeActionProvider", {{"codeActionKinds", {"quickfix"}}}},
              {"definitionProvider", true},
              {"referencesProvider", true},
              {"renameProvider", {{"prepareProvider", true}}},
              {"documentHighlightProvider", true},
              {"documentSymbolProvider", true},
              {"workspaceSymbolProvider", true},
              {"semanticTokensProvider",
               {{"legend",
                 {{"tokenTypes", semantic_kinds()}, {"tokenModifiers", semantic_modifiers()}}},
                {"full", true},
                {"range", true}}},
              {"foldingRangeProvider", true},
              {"inlayHintProvider", true},
              {"documentLinkProvider", {{"resolveProvider", false}}},
              {"colorProvider", true},
              {"documentFormattingProvider", true},
              {"documentRangeFormattingProvider", true}}},
            {"serverInfo", {{"name", "candelabra"}}}};
}

Json LanguageServer::shutdown(Parameters&) {
    shut_down_ = true;
    return nullptr;
}

Json LanguageServer::exit(Parameters&) {
    ended_ = true;
    return nullptr;
}

Json LanguageServer::did_open(Parameters& parameters) {
    const std::string path = parameters.document();
    std::string text = parameters.text({"textDocument", "text"});
    if (!parameters.problem().empty()) return nullptr;
    workspace_.open(path, std::move(text));
    changed_.insert(path);
    return nullptr;
}

Json LanguageServer::did_change(Parameters& parameters) {
    const FileHandle file = open_file(parameters);
    if (!file) return nullptr;
    const std::string path = file->path;
    std::string text = parameters.changed_text(file->text);
    if (!parameters.problem().empty()) return nullptr;
    workspace_.open(path, std::move(text));
    changed_.insert(path);
    return nullptr;
}

Json LanguageServer::did_save(Parameters& parameters) {
    const std::string path = open_path(parameters);
    if (parameters.problem().empty()) changed_.insert(path);
    return nullptr;
}

Json LanguageServer::did_close(Parameters& parameters) {
    const std::string path = open_path(parameters);
    if (!parameters.problem().empty()) return nullptr;
    workspace_.close(path);
    publish(path, {});
    changed_.erase(path);
    if (!workspace_.open_files().empty()) changed_.insert(path);
    return nullptr;
}

std::string LanguageServer::open_path(Parameters& parameters) {
    const std::string path = parameters.document();
    if (parameters.problem().empty() && !workspace_.is_open(path))
        parameters.refuse(message('`', path, "` is not open"));
    return path;
}

FileHandle LanguageServer::open_file(Parameters& parameters) {
    const std::string path = open_path(parameters);
    return parameters.problem().empty() ? workspace_.file(path) : nullptr;
}

Json LanguageServer::hover(Parameters& parameters) {
    const FileHandle file = open_file(parameters);
    if (!file) return nullptr;
    const std::uint32_t offset = parameters.place(file->text, {"position"});
    const auto found = candelabra::hover(workspace_, file->path, offset);
    if (!found) return nullptr;
    return {{"contents", {{"kind", "markdown"}, {"value", found->text}}},
            {"range", range_of(file->text, found->place)}};
}

Json LanguageServer::completion(Parameters& parameters) {
    const FileHandle file = open_file(parameters);
    if (!file) return nullptr;
    const std::uint32_t offset = parameters.place(file->text, {"position"});
    Json items = Json::array();
    for (const Suggestion& each : suggestions(workspace_, file->path, offset)) {
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

Json LanguageServer::signature_help(Parameters& parameters) {
    const FileHandle file = open_file(parameters);
    if (!file) return nullptr;
    const std::uint32_t offset = parameters.place(file->text, {"position"});
    const auto found = signature_at(workspace_, file->path, offset);
    if (!found) return nullptr;
    Json names = Json::array();
    for (const std::string& each : found->parameters) names.push_back({{"label", each}});
    return {{"signatures",
             {{{"label", found->label},
               {"documentation", found->help},
               {"parameters", std::move(names)},
               {"activeParameter", found->active}}}},
            {"activeSignature", 0},
            {"activeParameter", found->active}};
}

Json LanguageServer::code_actions(Parameters& parameters) {
    const FileHandle file = open_file(parameters);
    const Json mistakes = parameters.objects({"context", "diagnostics"});
    if (!file || !parameters.problem().empty()) return nullptr;
    Json actions = Json::array();
    for (const Json& each : mistakes) {
        Parameters mistake(each);
        const Part place = mistake.range(file->text, "range");
        const std::string text = mistake.text({"message"});
        if (!mistake.problem().empty()) {
            parameters.refuse(mistake.problem());
            return nullptr;
        }
        const auto better = correction(text, file->part(place));
        if (!better) continue;
        Json edit = {{"changes", Json::object()}};
        edit["changes"][uri_of(file->path)] =
            Json::array({{{"range", range_of(file->text, place)}, {"newText", *better}}});
        actions.push_back({{"title", message("Change to ", *better)},
                           {"kind", "quickfix"},
                           {"diagnostics", Json::array({each})},
                           {"isPreferred", true},
                           {"edit", std::move(edit)}});
    }
    return actions;
}

Json LanguageServer::definition(Parameters& parameters) {
    const FileHandle file = open_file(parameters);
    if (!file) return nullptr;
    const std::string& path = file->path;
    const std::uint32_t offset = parameters.place(file->text, {"position"});
    const Token* const token = file->token_at(offset);
    if (!token) return nullptr;
    if (token->kind == TokenKind::text) {
        const auto found = workspace_.loader(directory_of(path))
                               .located(file->values.texts[token->value], directory_of(path));
        if (!found) return nullptr;
        return {{"uri", uri_of(*found)}, {"range", range_of("", {})}};
    }
    if (token->kind != TokenKind::name) return nullptr;
    Json places = Json::array();
    for (const auto& each : workspace_.declarations(NameId(token->value), path, offset))
        places.push_back({{"uri", uri_of(each.file->path)},
                          {"range", range_of(each.file->text, each.declaration->place)}});
    return places;
}

Json LanguageServer::references(Parameters& parameters) {
    const FileHandle file = open_file(parameters);
    if (!file) return nullptr;
    const std::uint32_t offset = parameters.place(file->text, {"position"});
    Json places = Json::array();
    Ranges ranges(workspace_);
    for (const Mention& each : mentions(workspace_, file->path, offset))
        places.push_back({{"uri", uri_of(each.path)}, {"range", ranges.of(each.path, each.place)}});
    return places;
}

Json LanguageServer::prepare_rename(Parameters& parameters) {
    const FileHandle file = open_file(parameters);
    if (!file) return nullptr;
    const std::uint32_t offset = parameters.place(file->text, {"position"});
    const Token* const token = file->token_at(offset);
    if (!parameters.problem().empty() || !token) return nullptr;
    const Part place{token->first, token->last};
    // No scene has this name, so that only the name at the place can be the reason.
    const auto result = renaming(workspace_, file->path, offset, "Name_of_no_scene_7e5b3");
    if (const auto* reason = std::get_if<std::string>(&result)) {
        fail(*reason);
        return nullptr;
    }
    return {{"range", range_of(file->text, place)}, {"placeholder", file->part(place)}};
}

Json LanguageServer::rename(Parameters& parameters) {
    const FileHandle file = open_file(parameters);
    if (!file) return nullptr;
    const std::string new_name = parameters.text({"newName"});
    const std::uint32_t offset = parameters.place(file->text, {"position"});
    if (!parameters.problem().empty()) return nullptr;
    const auto result = renaming(workspace_, file->path, offset, new_name);
    if (const auto* reason = std::get_if<std::string>(&result)) {
        fail(*reason);
        return nullptr;
    }
    Json changes = Json::object();
    Ranges ranges(workspace_);
    for (const Mention& each : *std::get_if<std::vector<Mention>>(&result))
        changes[uri_of(each.path)].push_back(
            {{"range", ranges.of(each.path, each.place)}, {"newText", new_name}});
    return {{"changes", changes}};
}

}  // namespace candelabra
