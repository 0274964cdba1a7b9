// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/preview_address.h"

#include "text/message.h"
#include "text/printable.h"
#include "web/server.h"

#include <vector>

namespace candelabra {

std::string host_of(const Options& options) {
    return options.preview_host.empty() ? std::string(own_host) : options.preview_host;
}

Diagnostic problem_with_address(const std::string& host, int port) {
    if (host == own_host)
        return error(Fault::io, {}, message("port ", port, " cannot be had"))
            .with_help("--preview 0 takes any that is free");
    return error(Fault::io, {}, message("port ", port, " of `", printable(host), "` cannot be had"))
        .with_help("--preview-host takes an address of this machine, or 0.0.0.0 for all of them");
}

std::string words_on_address(const std::string& host, int port, const std::string& token) {
    if (host == own_host) return message("preview: http://localhost:", port, "/\n");
    std::string words =
        "Whoever has this address sees the picture and can turn the numbers of its page. The "
        "connection is not encrypted.\n";
    std::vector<std::string> addresses = addresses_of(host);
    if (addresses.empty()) addresses.emplace_back(own_host);  // without a network
    for (const std::string& each : addresses)
        words += message("preview: http://", each, ":", port, "/?token=", token, "\n");
    return words;
}

}  // namespace candelabra
