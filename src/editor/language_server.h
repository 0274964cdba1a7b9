// SPDX-License-Identifier: GPL-3.0-or-later
// The Language Server Protocol: receives an editor's messages and sends answers. `candelabra lsp`
// connects it to standard input and output; tests call it directly. Performs no I/O itself.
#pragma once

#include "editor/checking.h"
#include "editor/parameters.h"
#include "editor/protocol.h"
#include "editor/workspace.h"

#include <functional>
#include <set>
#include <string>
#include <string_view>

namespace candelabra {

class LanguageServer {
public:
    /// `library`: folder of the standard library, or "". Scenes that write files write them below
    /// `scratch`. Scenes are evaluated within the limits.
    LanguageServer(std::string library, std::string scratch,
                   std::function<void(const std::string& message)> send, CheckLimits limits = {})
        : workspace_(std::move(library)),
          scratch_(std::move(scratch)),
          send_(std::move(send)),
          limits_(limits) {}

    /// Maximum nesting depth of JSON messages.
    static constexpr int deepest = 64;

    /// Handles a message and answers it. Invalid or untimely messages are answered with a JSON-RPC
    /// error. Where the editor expects no answer, errors in parameters are sent to its log.
    void receive(std::string_view message);
    /// Answers a message that was too long to be read.
    void receive_too_long();

    /// Whether documents have changed since they were last checked. catch_up() checks them, and is
    /// called while the editor is idle. An exceeded limit is reported as a problem. Meanwhile the
    /// editor's messages are served. Once they change a document or end the server, or serve()
    /// returns false, the check ends without a report.
    bool behind() const { return !changed_.empty(); }
    void catch_up(const Meanwhile& serve = {});

    /// Whether the editor has sent `exit`.
    bool ended() const { return ended_; }
    /// Whether it sent `shutdown` first, as required.
    bool ended_well() const { return ended_ && shut_down_; }

    // Handlers by method. Parameters and results are those of the protocol.
    Json initialize(Parameters&);
    Json shutdown(Parameters&);
    Json exit(Parameters&);
    Json did_open(Parameters&);
    Json did_change(Parameters&);
    Json did_save(Parameters&);
    Json did_close(Parameters&);
    Json hover(Parameters&);
    Json completion(Parameters&);
    Json signature_help(Parameters&);
    Json code_actions(Parameters&);
    Json definition(Parameters&);
    Json references(Parameters&);
    Json rename(Parameters&);
    Json prepare_rename(Parameters&);
    Json highlights(Parameters&);
    Json symbols(Parameters&);
    Json workspace_symbols(Parameters&);
    Json semantic_tokens(Parameters&);
    Json semantic_tokens_of_range(Parameters&);
    Json folding(Parameters&);
    Json inlay_hints(Parameters&);
    Json knobs(Parameters&);
    Json links(Parameters&);
    Json colours(Parameters&);
    Json colour_texts(Parameters&);
    Json formatting(Parameters&);
    Json range_formatting(Parameters&);

private:
    void send(const Json& message);
    void refuse(const Json& id, int code, const std::string& why);
    void receive(const Json& message, Json& id);
    /// Returns the error number if the request must not be answered in the current state; 0
    /// otherwise.
    int untimely(std::string_view method) const;
    void publish(const std::string& path, const std::vector<Json>& problems);
    void fail(std::string reason) { failure_ = std::move(reason); }
    /// Returns the path of the open document that the parameters name, or refuses them.
    std::string open_path(Parameters&);
    /// Returns the open document that the parameters name; refuses them and returns null if there
    /// is none.
    FileHandle open_file(Parameters&);

    Workspace workspace_;
    std::string scratch_;
    std::function<void(const std::string&)> send_;
    std::set<std::string> changed_;
    std::string failure_;  ///< why the current request cannot be answered
    CheckLimits limits_;
    bool initialized_ = false;
    bool shut_down_ = false;
    bool ended_ = false;
};

}  // namespace candelabra
