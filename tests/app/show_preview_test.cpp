// SPDX-License-Identifier: GPL-3.0-or-later
// tests/production/share_page.py looks at the page in a browser.
#include "app/show_preview.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

#include <cstdlib>

namespace candelabra {

TEST_CASE("a show is served, anew when its table changes, and as it was with a mistake",
          "[app][relight]") {
    if (std::system("command -v python3 > /dev/null") != 0) return;
    Shell shell;
    REQUIRE(shell.render({"-V", "--keep-lights", shell.path("a.lights"),
                          "+O" + shell.path("a.png")}) == exit_status::done);
    shell.write("show.csv", "frame,*\n1,1\n2,0.5\n");
    shell.write("client.py", R"(
import json, re, subprocess, sys, time, urllib.error, urllib.request
program, lights, table = sys.argv[1:]
run = subprocess.Popen([program, "relight", lights, "--csv", table, "--preview", "0"], stderr=subprocess.PIPE, text=True)
try:
    address = run.stderr.readline().split()[-1]
    def get(path): return urllib.request.urlopen(address + path, timeout=20).read().decode()
    def code(path, form=None):
        try: return urllib.request.urlopen(urllib.request.Request(address + path, form), timeout=10).status
        except urllib.error.HTTPError as refusal: return refusal.code
    def facts(): return json.loads(re.search('id="data">(.*?)</script>', get("")).group(1))
    def until(number):
        for _ in range(100):
            if get(f"changed?since={number - 1}") == str(number): return
        sys.exit("never")
    assert facts()["show"]["frames"] == 2 and facts()["watched"] == 1
    assert get("changed?since=0") == "1"
    assert code("none") == 404 and code("", b"x=1") in (403, 405)
    time.sleep(0.3)
    open(table, "a").write("3,0.1\n")
    until(2)
    assert facts()["show"]["frames"] == 3
    time.sleep(0.3)
    open(table, "w").write("frame,Nobody\n1,1\n")
    assert "error" in run.stderr.readline()
    assert facts()["show"]["frames"] == 3 and facts()["watched"] == 2
finally:
    run.terminate()
assert run.wait(20) == 0
)");
    const std::string command = "timeout 100 python3 " + shell.path("client.py") +
                                " " CANDELABRA_BINARY " " + shell.path("a.lights") + " " +
                                shell.path("show.csv");
    CHECK(std::system(command.c_str()) == 0);
}

}  // namespace candelabra
