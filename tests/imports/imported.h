// SPDX-License-Identifier: GPL-3.0-or-later
// Models read through the library's table, for the tests of this module.
#pragma once

#include "base/loaded_library.h"
#include "imports/imported_model.h"

#include <map>
#include <string>

namespace candelabra {

struct Imported {
    ImportedModel model;
    std::string problem;
    std::vector<std::string> asked;  ///< names of files beside the model
};

/// Reads a model; `files` lie beside it.
inline Imported imported(const std::string& name, const std::string& bytes,
                         const std::map<std::string, std::string>& files = {}) {
    static const LoadedFunction library = load_function(imports_library, imports_function);
    Imported made;
    if (!library.address) {
        made.problem = library.problem;
        return made;
    }
    struct Beside {
        const std::map<std::string, std::string>& files;
        std::vector<std::string>& asked;
    } beside{files, made.asked};
    const auto read = [](void* context, std::string_view wanted, std::string& text) {
        auto& [all, asked] = *static_cast<Beside*>(context);
        asked.emplace_back(wanted);
        const auto found = all.find(std::string(wanted));
        if (found == all.end()) return false;
        text = found->second;
        return true;
    };
    const auto* const imports = reinterpret_cast<const Imports* (*)()>(library.address)();
    made.problem = imports->read(name, bytes, {read, &beside}, made.model);
    return made;
}

}  // namespace candelabra
