// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/preview.h"

namespace candelabra {

int run_preview(const Options& options, const std::optional<Animation>&, const Console& console,
                Diagnostics& diagnostics) {
    diagnostics.add(error(Fault::option, {},
                          "the program as WebAssembly serves no pages, which a preview needs")
                        .with_help("leave out --preview, or take the program for Linux"));
    say_errors(console, options, diagnostics);
    return exit_status::usage;
}

}  // namespace candelabra
