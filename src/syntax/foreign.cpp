// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/foreign.h"

#include <array>

namespace {

constexpr auto signs = std::array{
    ForeignSign{"\u201C", "a typographic quote", "\""},
    ForeignSign{"\u201D", "a typographic quote", "\""},
    ForeignSign{"\u201E", "a typographic quote", "\""},
    ForeignSign{"\u00AB", "a typographic quote", "\""},
    ForeignSign{"\u00BB", "a typographic quote", "\""},
    ForeignSign{"\u2018", "a typographic quote", "\""},
    ForeignSign{"\u2019", "a typographic quote", "\""},
    ForeignSign{"\u2010", "a hyphen", "-"},
    ForeignSign{"\u2011", "a hyphen", "-"},
    ForeignSign{"\u2013", "a dash", "-"},
    ForeignSign{"\u2014", "a dash", "-"},
    ForeignSign{"\u2212", "a minus sign beyond ASCII", "-"},
    ForeignSign{"\u00D7", "a multiplication sign", "*"},
    ForeignSign{"\u00B7", "a multiplication sign", "*"},
    ForeignSign{"\u00F7", "a division sign", "/"},
    ForeignSign{"\u2264", "a sign beyond ASCII", "<="},
    ForeignSign{"\u2265", "a sign beyond ASCII", ">="},
    ForeignSign{"\u2260", "a sign beyond ASCII", "!="},
    ForeignSign{"\u00A0", "a no-break space", " "},
    ForeignSign{"\u2009", "a thin space", " "},
    ForeignSign{"\u202F", "a narrow space", " "},
    ForeignSign{"\u200B", "a space without width", " "},
    ForeignSign{"\u3000", "a wide space", " "},
    ForeignSign{"\uFEFF", "a byte order mark", " "},
};

}  // namespace

const ForeignSign* foreign_sign(std::string_view text) {
    for (const ForeignSign& each : signs)
        if (text.starts_with(each.sign)) return &each;
    return nullptr;
}
