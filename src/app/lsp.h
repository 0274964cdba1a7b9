// SPDX-License-Identifier: GPL-3.0-or-later
// `candelabra lsp`: the language server between standard input and output, for editors.
#pragma once

#include "console/console.h"
#include "editor/framing.h"

#include <optional>
#include <string>

namespace candelabra {

/// Reads messages of the Language Server Protocol from a file descriptor.
class MessageReader {
public:
    explicit MessageReader(int descriptor) : descriptor_(descriptor) {}

    /// Returns the next message. Returns nothing if none came within the timeout (negative: no
    /// timeout), or none will come any more.
    std::optional<Framing::Message> next(int milliseconds);
    bool ended() const { return ended_; }
    /// Describes why the stream ended prematurely; empty if it did not.
    std::string problem() const;

private:
    int descriptor_;
    Framing framing_;
    bool ended_ = false;
};

/// Serves until the editor exits, closes its end, or sends data that cannot be split into messages.
/// Returns the exit status.
int run_lsp(int descriptor, const Console&);

}  // namespace candelabra
