// SPDX-License-Identifier: GPL-3.0-or-later
// Names by which users choose lamps: `Facade` is all lamps of a name, `Facade[17]` one of them,
// `Facade[0..99]` some, `*` all lamps of the picture.
#pragma once

#include "relight/lamp_list.h"
#include "text/diagnostic.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

class LampNames {
public:
    /// The list must outlive the names.
    explicit LampNames(const LampList&);

    const LampList& lamps() const { return *lamps_; }

    /// Returns the places of the chosen lamps in the list, in the order of their numbers. Returns
    /// nothing after an error has been reported.
    std::optional<std::vector<std::uint32_t>> chosen(std::string_view name, Diagnostics&) const;

private:
    bool unknown(std::string_view name, Diagnostics&) const;

    const LampList* lamps_;
    std::map<std::string, std::size_t, std::less<>> groups_;
};

}  // namespace candelabra
