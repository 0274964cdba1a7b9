// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/library_manual.h"

#include "text/message.h"

#include <nlohmann/json.hpp>

namespace candelabra {

namespace {

using OrderedJson = nlohmann::ordered_json;

std::vector<ManualEntry> listed_macros(const LibraryFile& file) {
    std::vector<ManualEntry> result;
    for (const LibraryMacro& each : file.macros)
        if (each.listed) result.push_back(manual_entry(each, file.name));
    return result;
}

OrderedJson json_file(const LibraryFile& file) {
    OrderedJson macros = OrderedJson::array();
    for (const LibraryMacro& each : file.macros)
        if (each.listed)
            macros.push_back({{"name", each.name},
                              {"form", each.form},
                              {"help", each.help},
                              {"example", each.example},
                              {"value", each.value}});
    return {{"file", file.name}, {"about", file.about}, {"macros", std::move(macros)}};
}

}  // namespace

ManualEntry manual_entry(const LibraryMacro& macro, std::string_view file) {
    const std::string value = macro.value.empty() ? "" : " -> " + macro.value;
    return {macro.form, macro.help.empty() ? message("a macro of ", file) : macro.help,
            macro.example + value};
}

std::string library_manual(const LibraryGuide& guide, ManualForm form) {
    if (form == ManualForm::json) {
        OrderedJson all = OrderedJson::array();
        for (const LibraryFile& file : guide) all.push_back(json_file(file));
        return all.dump(2) + "\n";
    }
    std::string text;
    for (const LibraryFile& file : guide) {
        const std::string macros = manual(listed_macros(file), form);
        text += form == ManualForm::roff
                    ? message(".SS ", roff(file.name), "\n", roff_lines(file.about), macros)
                    : message(text.empty() ? "" : "\n", file.name, ": ", wrapped(file.about, 2),
                              "\n", macros);
    }
    return text;
}

}  // namespace candelabra
