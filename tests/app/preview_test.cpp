// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/preview.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

#include <cstdlib>

#include <sys/wait.h>

namespace candelabra {

TEST_CASE("the preview shows a picture, an error after a change, and the picture again") {
    if (std::system("command -v python3 > /dev/null") != 0) return;
    const Shell shell;
    shell.write("lit.pov",
                "#ifndef (Size) #declare Size = 1; #end  // 0.5 to 2 by 0.5: of the lamp\n" +
                    std::string(lit_scene));
    shell.write("client.py", R"(
import json, re, subprocess, sys, time, urllib.error, urllib.parse, urllib.request
program, scene = sys.argv[1:]
run = subprocess.Popen([program, scene, "+W64", "+H48", "--preview", "0", "+BS16"],
                       stderr=subprocess.PIPE, text=True)
said = ""
while not said.splitlines()[-1:] or not said.splitlines()[-1].startswith("preview: "): said += run.stderr.readline()
assert "`+BS16` is ignored" in said
address = said.split()[-1]
def get(path): return urllib.request.urlopen(address + path, timeout=10).read()
def turn(token, method="POST", **more):
    form = urllib.parse.urlencode({"name": "Size", "value": 7}).encode()
    heads = {"X-Token": token, **{name.replace("_", "-"): value for name, value in more.items()}}
    request = urllib.request.Request(address + "turn", form, heads, method=method)
    if method == "GET": request = urllib.request.Request(address + "turn?name=Size&value=7", None, heads)
    try: return urllib.request.urlopen(request, timeout=10).status
    except urllib.error.HTTPError as refusal: return refusal.code
def status(): return json.loads(get("status"))
def until(what, test):
    for _ in range(300):
        if test(status()): return
        time.sleep(0.1)
    sys.exit("never: " + what + " " + str(status()))
try:
    until("a finished picture", lambda s: s["progress"] == 1 and not s["errors"])
    assert get("picture.png")[1:4] == b"PNG"
    assert b"<!DOCTYPE html>" in get("")
    assert get("pick?x=3&y=40").startswith(b"<3, 40>: rgb <")
    under = get("pick?x=32&y=40").decode()
    assert "\nobject 2: " in under and "pigment { checker" in under and "100 %  " in under, under
    assert get("pick?x=64&y=0") == b""
    assert "lit.pov:" in status()["lights"] and "%" in status()["lights"]
    pictures = {get("view.png?name=" + name) for name in status()["views"]}
    assert len(pictures) == 8 and all(p[1:4] == b"PNG" for p in pictures)
    try: get("view.png?name=none"); assert False
    except urllib.error.HTTPError: pass
    assert status()["knobs"] == [{"name": "Size", "value": 1, "low": 0.5, "high": 2, "step": 0.5, "help": "of the lamp"}]
    before = status()["picture"]
    token = re.search("content=.([0-9a-f]{32}).>", get("").decode()).group(1)
    assert turn(token, "GET") == 405
    assert turn("0" * 32) == 403
    assert turn(token, Origin="http://evil.example") == 403
    assert turn(token, Origin="null") == 403
    assert turn(token, Host="evil.example") == 403
    assert turn(token, Sec_Fetch_Site="cross-site") == 403
    assert status()["knobs"][0]["value"] == 1
    assert turn(token, Origin=address.rstrip("/"), Sec_Fetch_Site="same-origin") == 200
    until("a picture of a larger lamp", lambda s: s["picture"] > before and s["progress"] == 1)
    assert status()["knobs"][0]["value"] == 2
    none = urllib.request.Request(address + "turn", b"name=None&value=1", {"X-Token": token})
    try: urllib.request.urlopen(none); assert False
    except urllib.error.HTTPError as refusal: assert refusal.code == 404
    good = open(scene).read()
    open(scene, "w").write(good + "sphere { 0, 1 pigmnt }")
    until("an error", lambda s: "pigmnt" in s["errors"] and "^" in s["errors"])
    before = status()["picture"]
    open(scene, "w").write(good + " ")
    until("a new picture", lambda s: s["picture"] > before and s["progress"] == 1 and not s["errors"])
finally:
    run.terminate()
assert run.wait(20) == 0
)");
    const std::string command = "timeout 100 python3 " + shell.path("client.py") +
                                " " CANDELABRA_BINARY " " + shell.path("lit.pov");
    CHECK(std::system(command.c_str()) == 0);
}

TEST_CASE("of an animation the preview shows the frame that is chosen") {
    if (std::system("command -v python3 > /dev/null") != 0) return;
    const Shell shell;
    shell.write("moving.pov",
                "camera { orthographic location -5*z right 4*x up 3*y }\n"
                "plane { z, 1 pigment { rgb clock } finish { ambient 1 diffuse 0 } }");
    shell.write("client.py", R"(
import json, subprocess, sys, time, urllib.request
run = subprocess.Popen([sys.argv[1], sys.argv[2], "+W8", "+H6", "--preview", "0", "+KFI3", "+KFF5"],
                       stderr=subprocess.PIPE, text=True)
said = ""
while not said.startswith("preview: "): said = run.stderr.readline()
address = said.split()[-1]
def get(path): return urllib.request.urlopen(address + path, timeout=10).read()
def status(): return json.loads(get("status"))
def red():
    for _ in range(300):
        if status()["progress"] == 1: return get("pick?x=3&y=3").decode().split("rgb <")[1].split(",")[0]
        time.sleep(0.1)
try:
    assert red() == "0"
    assert [(k["name"], k["low"], k["high"]) for k in status()["knobs"]] == [("frame_number", 3, 5)]
    before = status()["picture"]
    token = get("").decode().split('name="token" content="')[1].split('"')[0]
    urllib.request.urlopen(urllib.request.Request(address + "turn", b"name=frame_number&value=5", {"X-Token": token}))
    while status()["picture"] == before: time.sleep(0.1)
    assert red() == "1", red()
finally:
    run.terminate()
assert run.wait(20) == 0
)");
    const std::string command = "timeout 100 python3 " + shell.path("client.py") +
                                " " CANDELABRA_BINARY " " + shell.path("moving.pov");
    CHECK(std::system(command.c_str()) == 0);
}

}  // namespace candelabra
