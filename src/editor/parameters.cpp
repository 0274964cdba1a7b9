// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/parameters.h"

#include "text/message.h"

#include <algorithm>

namespace candelabra {

namespace {

const Json* member(const Json* object, const char* name) {
    if (!object || !object->is_object()) return nullptr;
    const auto found = object->find(name);
    return found == object->end() ? nullptr : &*found;
}

/// Whether the value is a `uinteger` of the protocol, which is at most 2^31-1.
bool is_count(const Json* json) {
    if (!json || !json->is_number_integer()) return false;
    const auto value = json->get<std::int64_t>();  // larger values come out negative
    return value >= 0 && value <= 0x7fffffff;
}

}  // namespace

const Json* Parameters::find(Way way) const {
    const Json* at = &json_;
    for (const char* const name : way) at = member(at, name);
    return at;
}

void Parameters::wrong(Way way, std::string_view kind) {
    std::string name = "params";
    for (const char* const each : way) name += message('.', each);
    refuse(message('`', name, "` must be ", kind));
}

void Parameters::refuse(std::string why) {
    if (problem_.empty()) problem_ = std::move(why);
}

std::string Parameters::text(Way way) {
    const Json* const found = find(way);
    if (found && found->is_string()) return found->get<std::string>();
    wrong(way, "a string");
    return {};
}

Json Parameters::objects(Way way) {
    const Json* const found = find(way);
    const auto is_object = [](const Json& each) { return each.is_object(); };
    if (found && found->is_array() && std::ranges::all_of(*found, is_object)) return *found;
    wrong(way, "a list of objects");
    return Json::array();
}

std::string Parameters::document() {
    const Way way = {"textDocument", "uri"};
    std::string path = path_of(text(way));
    if (path.empty() || path.find('\0') != path.npos) {
        wrong(way, "a URI");
        return {};
    }
    return path;
}

std::uint32_t Parameters::place(std::string_view text, Way way) {
    const Json* const position = find(way);
    if (is_count(member(position, "line")) && is_count(member(position, "character")))
        return offset_of(text, *position);
    wrong(way, "a position: `line` and `character`, integers from 0 to 2147483647");
    return 0;
}

Part Parameters::range(std::string_view text, const char* name) {
    const Part part{place(text, {name, "start"}), place(text, {name, "end"})};
    if (part.first <= part.last) return part;
    wrong({name}, "a range that does not end before it begins");
    return {};
}

double Parameters::channel(Way way) {
    const Json* const found = find(way);
    const double value = found && found->is_number() ? found->get<double>() : -1;
    if (value >= 0 && value <= 1) return value;
    wrong(way, "a number from 0 to 1");
    return 0;
}

bool Parameters::change(std::string& text, const Json& change) {
    const Json* const inserted = member(&change, "text");
    if (!inserted || !inserted->is_string()) return false;
    const auto& piece = inserted->get_ref<const std::string&>();
    if (!change.contains("range")) {
        text = piece;
        return true;
    }
    Parameters inner(change);
    const Part part = inner.range(text, "range");
    if (!inner.problem().empty()) return false;
    if (text.size() - (part.last - part.first) + piece.size() > longest_document) return false;
    text.replace(part.first, part.last - part.first, piece);
    return true;
}

std::string Parameters::changed_text(std::string text) {
    const Json* const changes = find({"contentChanges"});
    if (!changes || !changes->is_array() || changes->empty()) {
        wrong({"contentChanges"}, "a list of changes");
        return {};
    }
    for (const Json& each : *changes) {
        if (change(text, each)) continue;
        wrong({"contentChanges"},
              "a list of changes, each a `text` for all of the document or for a `range` that does "
              "not end before it begins, and the document has at most 64 MB");
        return {};
    }
    return text;
}

}  // namespace candelabra
