// SPDX-License-Identifier: GPL-3.0-or-later
// A small web server for the preview, on one address of this machine. Enough for a page that looks
// at a picture, and little enough to be understood; nothing is linked for it that every run would
// have to load. All connections are waited for at once and each has its time, so that a slow or
// silent one holds up no other.
#pragma once

#include "web/request.h"

#include <atomic>
#include <functional>
#include <thread>

namespace candelabra {

/// What the server puts up with.
struct WebLimits {
    std::size_t connections = 64;  ///< beyond, the oldest gives way, first of the silent ones
    std::size_t waiting_bytes = 1 << 28;  ///< of answers that are being fetched; beyond: status 503
    int request_milliseconds = 5000;      ///< for the whole request, which else gets status 408
    int answer_milliseconds = 60000;      ///< for fetching the whole answer
    int patience_milliseconds = 2000;     ///< until a request is put for the last time
};

class WebServer {
public:
    using Handler = std::function<WebAnswer(const WebRequest&)>;

    /// Listens on 127.0.0.1; port 0: any that is free. The handler is called from one thread. What
    /// changes something it should do for POST only, which needs the token. A request that it
    /// answers with `later` is put again whenever somebody calls wake(), until its time is over.
    WebServer(int port, std::string token, Handler, WebLimits = {});
    WebServer(const WebServer&) = delete;
    WebServer& operator=(const WebServer&) = delete;
    ~WebServer();

    /// 0: the port could not be had, or the token is empty.
    int port() const { return key_.port; }
    /// There may be answers to waiting requests. Called by any thread.
    void wake() const;

private:
    void serve();

    WebKey key_;
    Handler handler_;
    WebLimits limits_;
    int socket_ = -1;
    int bell_ = -1;  ///< an event that wake() counts
    std::atomic<bool> ending_ = false;
    std::thread thread_;
};

}  // namespace candelabra
