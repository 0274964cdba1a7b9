// SPDX-License-Identifier: GPL-3.0-or-later
#include "imports/importer.h"

#include <exception>

namespace candelabra {

namespace {

std::string read_guarded(std::string_view name, std::string_view bytes, const BesideModel& beside,
                         ImportedModel& model) {
    try {
        return import_model(name, bytes, beside, model);
    } catch (const std::exception& problem) {
        return problem.what();
    }
}

}  // namespace

extern "C" const Imports* candelabra_imports() {
    static constexpr Imports entries{&read_guarded};
    return &entries;
}

}  // namespace candelabra
