// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a request to the preview: no crash; what a part of the bytes has decided stays, and
// nobody changes anything without the token, or comes in under another address.
#include "fuzz/target.h"
#include "web/request.h"

#include <algorithm>
#include <cstdlib>

using namespace candelabra;

namespace {

const WebKey fuzzed_key{8000, "0123456789abcdef"};

void must(bool holds) {
    if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const ReadRequest whole = read_request(bytes, fuzzed_key);
    const std::size_t step = std::max<std::size_t>(1, size / 50);
    for (std::size_t length = 0; length < size; length += step) {
        const ReadRequest part = read_request(bytes.substr(0, length), fuzzed_key);
        if (!std::holds_alternative<std::monostate>(part)) must(part.index() == whole.index());
    }
    if (const auto* const request = std::get_if<WebRequest>(&whole)) {
        must(request->path.starts_with('/') && request->form.size() <= longest_head);
        must(!request->post || bytes.find(fuzzed_key.token) != bytes.npos);
        must(bytes.find(":8000") != bytes.npos);
        for (const char* name : {"name", "value", "x"}) request->parameter(name);
    }
    if (const auto* const refusal = std::get_if<WebAnswer>(&whole)) {
        must(refusal->status >= 400);
        sent_form(*refusal);
    }
    return 0;
}
