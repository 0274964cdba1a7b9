// SPDX-License-Identifier: GPL-3.0-or-later
// WebAssembly has no sockets: no address is available.
#include "web/server.h"

namespace candelabra {

std::vector<std::string> addresses_of(std::string_view) { return {}; }

WebServer::WebServer(std::string_view, int, std::string, Handler, WebLimits) {}
WebServer::~WebServer() = default;
void WebServer::wake() const {}

}  // namespace candelabra
