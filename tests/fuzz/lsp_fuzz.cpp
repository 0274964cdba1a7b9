// SPDX-License-Identifier: GPL-3.0-or-later
// Any lines as messages of an editor, and the same bytes as its stream: no crash, answers that can
// be read, and for each request one. Scenes are not evaluated: evaluate_fuzz does that.
#include "editor/framing.h"
#include "editor/language_server.h"
#include "fuzz/target.h"

#include <cstdlib>

using namespace candelabra;

namespace {

/// The answers must be readable; gives how many belong to requests.
class Answers {
public:
    void operator()(const std::string& text) {
        const Json answer = Json::parse(text, nullptr, false);
        if (!answer.is_object() || answer["jsonrpc"] != "2.0") std::abort();
        if (answer.contains("id")) ++count_;
    }
    int take() { return std::exchange(count_, 0); }

private:
    int count_ = 0;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string_view bytes(reinterpret_cast<const char*>(data), size);
    Answers answers;
    LanguageServer server("", "/nonexistent", [&](const std::string& text) { answers(text); });
    Framing framing;
    while (!bytes.empty() && !server.ended()) {
        const std::string_view line = bytes.substr(0, bytes.find('\n'));
        const std::string_view taken = bytes.substr(0, line.size() + 1);
        framing.add(taken);
        while (framing.take()) {
        }
        bytes.remove_prefix(taken.size());
        server.receive(line);
        if (answers.take() > 1) std::abort();
    }
    return 0;
}
