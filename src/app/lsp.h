// SPDX-License-Identifier: GPL-3.0-or-later
// `candelabra lsp`: the language server between standard input and output, for editors.
#pragma once

#include "app/console.h"
#include "editor/framing.h"

#include <optional>
#include <string>

namespace candelabra {

/// Messages of the Language Server Protocol as they come through a file descriptor.
class MessageReader {
public:
    explicit MessageReader(int descriptor) : descriptor_(descriptor) {}

    /// The next message; nothing when none came in so many milliseconds (below 0: ever) or none
    /// will come any more.
    std::optional<Framing::Message> next(int milliseconds);
    bool ended() const { return ended_; }
    /// Why the stream has ended before it should; or empty.
    std::string problem() const;

private:
    int descriptor_;
    Framing framing_;
    bool ended_ = false;
};

/// Serves until the editor says goodbye, closes its end, or sends what cannot be told apart into
/// messages; gives the exit status.
int run_lsp(int descriptor, const Console&);

}  // namespace candelabra
