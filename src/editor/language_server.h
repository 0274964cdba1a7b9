// SPDX-License-Identifier: GPL-3.0-or-later
// The Language Server Protocol: messages of an editor in, answers out. `candelabra lsp` carries
// them between standard input and output; tests hand them over directly. Knows no streams.
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
    /// `scratch`, and are evaluated within the limits.
    LanguageServer(std::string library, std::string scratch,
                   std::function<void(const std::string& message)> send, CheckLimits limits = {})
        : workspace_(std::move(library)),
          scratch_(std::move(scratch)),
          send_(std::move(send)),
          limits_(limits) {}

    /// JSON may be nested so deep.
    static constexpr int deepest = 64;

    /// Takes a message and answers it. What is no message, or none for now, is answered with an
    /// error of JSON-RPC; where the editor waits for no answer, with a line for its log.
    void receive(std::string_view message);
    /// Answers a message that was too long to be read.
    void receive_too_long();

    /// Whether texts have changed since they were looked at for mistakes: to be done by catch_up()
    /// when the editor has nothing to say for a moment. What breaks a limit is one more mistake.
    bool behind() const { return !changed_.empty(); }
    void catch_up();

    /// After the editor has said goodbye.
    bool ended() const { return ended_; }
    /// Whether it did so in the right order.
    bool ended_well() const { return ended_ && shut_down_; }

    // The answers, by method; parameters and results are those of the protocol.
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
    Json highlights(Parameters&);
    Json symbols(Parameters&);
    Json workspace_symbols(Parameters&);
    Json semantic_tokens(Parameters&);
    Json semantic_tokens_of_range(Parameters&);
    Json folding(Parameters&);
    Json links(Parameters&);
    Json colours(Parameters&);
    Json colour_texts(Parameters&);
    Json formatting(Parameters&);
    Json range_formatting(Parameters&);

private:
    void send(const Json& message);
    void refuse(const Json& id, int code, const std::string& why);
    void receive(const Json& message, Json& id);
    /// Why the request cannot be answered at the moment: 0 if it can, or the error's number.
    int untimely(std::string_view method) const;
    void publish(const std::string& path, const std::vector<Json>& problems);
    void fail(std::string reason) { failure_ = std::move(reason); }
    /// The path of the open document that the parameters name, which else are refused.
    std::string open_path(Parameters&);
    /// The open document that the parameters name; null when there is none, which refuses them.
    FileHandle open_file(Parameters&);

    Workspace workspace_;
    std::string scratch_;
    std::function<void(const std::string&)> send_;
    std::set<std::string> changed_;
    std::string failure_;  ///< why the request that is being answered cannot be
    CheckLimits limits_;
    bool initialized_ = false;
    bool shut_down_ = false;
    bool ended_ = false;
};

}  // namespace candelabra
