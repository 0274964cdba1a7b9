// SPDX-License-Identifier: GPL-3.0-or-later
// Every switch, keyword and long option, in one table: how it is written, what it means, where its
// value goes. The command line is read with it; help and manual are made from it. Switches of
// POV-Ray that we do not offer have their rows, too.
#pragma once

#include "app/option_store.h"

#include <span>
#include <string_view>

namespace candelabra {

/// What follows an option.
enum class Takes {
    nothing,
    sign,            ///< `+V` on, `-V` off; `Verbose=on`
    sign_and_value,  ///< `+A`, `+A0.1`, `-A`; `Antialias=on`
    value,           ///< `+W640`, `Width=640`, `--samples 64`
    maybe_value,     ///< `--check`, `--check=syntax`
    maybe_words,     ///< `--help`, `--help sphere`: words that are no options
};

/// What becomes of a POV-Ray option that has no meaning here.
enum class Unoffered {
    no,        ///< it is offered
    accepted,  ///< nothing would be different
    ignored,   ///< with a warning: the picture is the same
    refused,   ///< with an error: the picture would be another one
};

/// What an option has to do with files, and with what a scene may do.
enum class Touches {
    nothing,
    reads,       ///< its value names a file or folder that is read
    searches,    ///< the same, which is looked for in the folders of the scene and the library
    writes,      ///< its value names a file or folder that is written to
    writes_ini,  ///< the same for options themselves
    permits,     ///< it opens something to scenes or to others
};

struct OptionRow {
    std::string_view letters;    ///< POV-Ray's switch without its sign; empty: none
    std::string_view keyword;    ///< of `Keyword=value`; empty: none
    std::string_view word;       ///< of `--word`; empty: none
    std::string_view parameter;  ///< how its value is called in help
    Takes takes;
    std::string_view help;        ///< empty: the field's
    std::string_view field = {};  ///< of a setting; empty: `store` is called
    void (*store)(Options&, const Given&, Diagnostics&) = nullptr;
    Unoffered unoffered = Unoffered::no;
    Touches touches = Touches::nothing;
};

std::span<const OptionRow> option_table();

/// Puts the value where it belongs, or says what is wrong with it.
void apply(const OptionRow&, Options&, const Given&, Diagnostics&);

}  // namespace candelabra
