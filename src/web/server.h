// SPDX-License-Identifier: GPL-3.0-or-later
// A small web server for the preview: answers GET requests, one at a time, on one address of this
// machine. Enough for a page that looks at a picture, and little enough to be understood; nothing
// is linked for it that every run would have to load.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <thread>

struct WebRequest {
    std::string path;   ///< without the query: "/picture.png"
    std::string query;  ///< behind the question mark: "x=3&y=4"

    /// The value of a parameter of the query; empty when there is none.
    std::string parameter(std::string_view name) const;
};

struct WebAnswer {
    std::string type;  ///< "text/html"
    std::string body;
    int status = 200;
};

/// The request in the head of an HTTP message that came to this port; nothing for anything but GET,
/// and for pages of other hosts: a name on the web that leads here is not let in.
std::optional<WebRequest> read_request(std::string_view head, int port);

class WebServer {
public:
    using Handler = std::function<WebAnswer(const WebRequest&)>;

    /// Listens on 127.0.0.1; port 0: any that is free. The handler is called from one thread.
    WebServer(int port, Handler);
    WebServer(const WebServer&) = delete;
    WebServer& operator=(const WebServer&) = delete;
    ~WebServer();

    /// 0: the port could not be had.
    int port() const { return port_; }

private:
    void serve();
    void answer(int connection) const;

    Handler handler_;
    int socket_ = -1;
    int port_ = 0;
    std::atomic<bool> ending_ = false;
    std::thread thread_;
};
