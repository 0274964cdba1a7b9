// SPDX-License-Identifier: GPL-3.0-or-later
// `candelabra lsp`: the language server between standard input and output, for editors.
#pragma once

#include "app/console.h"

#include <optional>
#include <string>

/// Messages of the Language Server Protocol as they come through a file descriptor, each behind a
/// head that says how long it is.
class MessageReader {
public:
    explicit MessageReader(int descriptor) : descriptor_(descriptor) {}

    /// The next message; nothing when none came in so many milliseconds (below 0: ever) or none
    /// will come any more.
    std::optional<std::string> next(int milliseconds);
    bool ended() const { return ended_; }

private:
    std::optional<std::string> take();

    int descriptor_;
    std::string waiting_;
    bool ended_ = false;
};

/// Serves until the editor says goodbye or closes its end; gives the exit status.
int run_lsp(int descriptor, const Console&);
