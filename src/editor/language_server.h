// SPDX-License-Identifier: GPL-3.0-or-later
// The Language Server Protocol: messages of an editor in, answers out. `candelabra lsp` carries
// them between standard input and output; tests hand them over directly. Knows no streams.
#pragma once

#include "editor/protocol.h"
#include "editor/workspace.h"

#include <functional>
#include <set>
#include <string>
#include <string_view>

class LanguageServer {
public:
    /// `library`: folder of the standard library, or "". Scenes that write files write them below
    /// `scratch`.
    LanguageServer(std::string library, std::string scratch,
                   std::function<void(const std::string& message)> send)
        : workspace_(std::move(library)), scratch_(std::move(scratch)), send_(std::move(send)) {}

    /// Takes a message and answers it. What is no message is answered with an error.
    void receive(std::string_view message);

    /// Whether texts have changed since they were looked at for mistakes: to be done by catch_up()
    /// when the editor has nothing to say for a moment.
    bool behind() const { return !changed_.empty(); }
    void catch_up();

    /// After the editor has said goodbye.
    bool ended() const { return ended_; }
    /// Whether it did so in the right order.
    bool ended_well() const { return ended_ && shut_down_; }

    // The answers, by method; parameters and results are those of the protocol.
    Json initialize(const Json& parameters);
    Json shutdown(const Json& parameters);
    Json exit(const Json& parameters);
    Json did_open(const Json& parameters);
    Json did_change(const Json& parameters);
    Json did_save(const Json& parameters);
    Json did_close(const Json& parameters);
    Json hover(const Json& parameters);
    Json completion(const Json& parameters);
    Json definition(const Json& parameters);
    Json references(const Json& parameters);
    Json rename(const Json& parameters);
    Json symbols(const Json& parameters);
    Json colours(const Json& parameters);
    Json colour_texts(const Json& parameters);
    Json formatting(const Json& parameters);

private:
    void send(const Json& message);
    void publish(const std::string& path, const std::vector<Json>& problems);
    void fail(std::string reason) { failure_ = std::move(reason); }
    std::string text_of(const std::string& path);

    Workspace workspace_;
    std::string scratch_;
    std::function<void(const std::string&)> send_;
    std::set<std::string> changed_;
    std::string failure_;  ///< why the request that is being answered cannot be
    bool shut_down_ = false;
    bool ended_ = false;
};
