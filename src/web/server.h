// SPDX-License-Identifier: GPL-3.0-or-later
// A small web server for the preview, on this machine or in its network. It suffices for a page
// that shows a picture, and is small enough to be understood. It needs no library, which every run
// would have to load. All connections are polled together and each has its deadline, so that slow
// or silent ones do not block others.
#pragma once

#include "web/request.h"

#include <atomic>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace candelabra {

/// Limits that protect the server.
struct WebLimits {
    std::size_t connections = 64;         ///< beyond, the oldest is closed, silent ones first
    std::size_t waiting_bytes = 1 << 28;  ///< of answers being sent; beyond: status 503
    int request_milliseconds = 5000;      ///< to receive the whole request; then status 408
    int answer_milliseconds = 60000;      ///< to send the whole answer
    int patience_milliseconds = 2000;     ///< until a waiting request is handled for the last time
};

/// The address that only this machine reaches, and the one that stands for all of its addresses.
inline constexpr std::string_view own_host = "127.0.0.1", any_host = "0.0.0.0";

/// Returns the addresses under which other machines may reach a server that listens on `host`:
/// itself, or all of this machine's for any_host.
std::vector<std::string> addresses_of(std::string_view host);

class WebServer {
public:
    using Handler = std::function<WebAnswer(const WebRequest&)>;

    /// Listens on an address of IPv4 that this machine has; port 0 selects a free port. On another
    /// one than own_host, each request needs the token. The handler is called from one thread. It
    /// should change something for POST only, which needs the token. A request that it answers with
    /// `later` is handled again after each wake(), until its time is over.
    WebServer(std::string_view host, int port, std::string token, Handler, WebLimits = {});
    WebServer(const WebServer&) = delete;
    WebServer& operator=(const WebServer&) = delete;
    ~WebServer();

    /// 0 if the address or the port is not available, or the token is empty.
    int port() const { return key_.port; }
    /// Announces that there may be answers to waiting requests. May be called by any thread.
    void wake() const;

private:
    void serve();

    WebKey key_;
    Handler handler_;
    WebLimits limits_;
    int socket_ = -1;
    int bell_ = -1;  ///< an eventfd that wake() increments
    std::atomic<bool> ending_ = false;
    std::thread thread_;
};

}  // namespace candelabra
