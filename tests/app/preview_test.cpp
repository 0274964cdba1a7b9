// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/preview.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

#include <cstdlib>

#include <sys/wait.h>

namespace candelabra {

namespace {

/// Common beginning of all clients: starts the preview of a scene with options, and defines
/// requests.
constexpr auto client_beginning = R"(
import json, re, subprocess, sys, time, urllib.error, urllib.parse, urllib.request
program, scene = sys.argv[1:]
run = said = address = token = None
def begin(*options):
    global run, said, address, token
    run = subprocess.Popen([program, scene, *options, "--preview", "0"], stderr=subprocess.PIPE, text=True)
    said = ""
    while not said.splitlines()[-1:] or not said.splitlines()[-1].startswith("preview: "): said += run.stderr.readline()
    address = said.split()[-1]
    token = re.search("content=.([0-9a-f]{32}).>", get("").decode()).group(1)
def get(path): return urllib.request.urlopen(address + path, timeout=10).read()
def code(path, form=None, heads={}):
    request = urllib.request.Request(address + path, form, heads)
    try: return urllib.request.urlopen(request, timeout=10).status
    except urllib.error.HTTPError as refusal: return refusal.code
def post(path, form): return code(path, form, {"X-Token": token})
def status(): return json.loads(get("status"))
def until(what, test):
    for _ in range(300):
        if test(status()): return
        time.sleep(0.1)
    sys.exit("never: " + what + " " + str(status()))
)";

/// Ends the preview even if the client has failed.
constexpr auto client_ending = R"(
try: look()
finally: run.terminate() if run else None
assert run.wait(20) == 0
)";

/// Whether a Python program succeeds that has the program and the scene as arguments.
bool python_succeeds(const Shell& shell, const std::string& text) {
    shell.write("client.py", text);
    const std::string command = "timeout 100 python3 " + shell.path("client.py") +
                                " " CANDELABRA_BINARY " " + shell.path("scene.pov");
    return std::system(command.c_str()) == 0;
}

/// Whether all checks of a client succeed. The client starts the preview and checks it in `look()`.
bool client_succeeds(const Shell& shell, const std::string& client) {
    return python_succeeds(shell, client_beginning + client + client_ending);
}

bool has_python() { return std::system("command -v python3 > /dev/null") == 0; }

}  // namespace

TEST_CASE("the preview shows a picture, an error after a change, and the picture again") {
    if (!has_python()) return;
    const Shell shell;
    shell.write("scene.pov",
                "#ifndef (Size) #declare Size = 1; #end  // 0.5 to 2 by 0.5: of the lamp\n" +
                    std::string(lit_scene));
    CHECK(client_succeeds(shell, R"(
def turn(own, method="POST", **more):
    heads = {"X-Token": own, **{name.replace("_", "-"): value for name, value in more.items()}}
    if method == "GET": return code("turn?name=Size&value=7", None, heads)
    return code("turn", b"name=Size&value=7", heads)
def look():
    begin("+W64", "+H48", "+BS16")
    assert "`+BS16` is ignored" in said
    until("a finished picture", lambda s: s["progress"] == 1 and not s["errors"])
    assert get("picture.png")[1:4] == b"PNG"
    assert b"<!DOCTYPE html>" in get("")
    assert get("picture")[:8] == bytes([64, 0, 0, 0, 48, 0, 0, 0]) and len(get("picture")) == 20 + 4 * 64 * 48
    assert get("pick?x=3&y=40").startswith(b"<3, 40>: rgb <")
    under = get("pick?x=32&y=40").decode()
    assert "\nobject 2: " in under and "pigment { checker" in under and "100 %  " in under, under
    assert get("pick?x=64&y=0") == b""
    assert b"scene.pov:" in get("report") and b"%" in get("report")
    pictures = set()
    for name in status()["views"]:
        assert post("look", b"view=" + name.encode()) == 200
        until("the view", lambda s: s["shown_view"] == name and s["columns"] == 64)
        pictures.add(get("picture.png"))
    assert len(pictures) == 8 and all(p[1:4] == b"PNG" for p in pictures)
    assert post("look", b"view=none") == 400 and post("look", b"view=picture") == 200
    until("the picture", lambda s: s["shown_view"] == "picture")
    assert status()["knobs"] == [{"name": "Size", "kind": "slider", "value": 1, "low": 0.5, "high": 2, "step": 0.5,
                                  "choices": [], "help": "of the lamp", "section": ""}]
    before = status()["generation"]
    assert turn(token, "GET") == 405
    assert turn("0" * 32) == 403
    assert turn(token, Origin="http://evil.example") == 403
    assert turn(token, Origin="null") == 403
    assert turn(token, Host="evil.example") == 403
    assert turn(token, Sec_Fetch_Site="cross-site") == 403
    assert status()["knobs"][0]["value"] == 1
    assert turn(token, Origin=address.rstrip("/"), Sec_Fetch_Site="same-origin") == 200
    until("a picture of a larger lamp", lambda s: s["generation"] > before and s["progress"] == 1)
    assert status()["knobs"][0]["value"] == 2
    assert post("turn", b"name=None&value=1") == 404
    good = open(scene).read()
    open(scene, "w").write(good + "sphere { 0, 1 pigmnt }")
    until("an error", lambda s: "pigmnt" in s["errors"] and "^" in s["errors"])
    assert any("`+BS16` is ignored" in each for each in status()["warnings"]), status()["warnings"]
    before = status()["generation"]
    open(scene, "w").write(good + " ")
    until("a new picture", lambda s: s["generation"] > before and s["progress"] == 1 and not s["errors"])
)"));
}

TEST_CASE("lamps, film and camera of the preview are changed by its page, and by nobody else") {
    if (!has_python()) return;
    const Shell shell;
    shell.write("scene.pov", lit_scene);
    CHECK(client_succeeds(shell, R"(
def floor(): return list(get("picture")[20 + 4 * (64 * 40 + 32):][:3])
def changed(path, form):
    before = status()["picture"]
    assert post(path, form) == 200, (path, form)
    until("a picture", lambda s: s["picture"] > before)
addresses = ["turn", "develop", "dim", "look", "orbit", "point", "pause"]
def look():
    begin("+W64", "+H48", "--samples", "4")
    until("a finished picture", lambda s: s["progress"] == 1)
    generation, before = status()["generation"], status()
    for path in addresses:
        assert code(path) == 405 and code(path + "?name=exposure&value=1") == 405, path
        assert code(path, b"x=1") == 403, path
        assert code(path, b"x=1", {"X-Token": "0" * 32}) == 403, path
        assert code(path, b"x=1", {"X-Token": token, "Origin": "http://evil.example"}) == 403, path
        assert code(path, b"x=1", {"X-Token": token, "Sec-Fetch-Site": "cross-site"}) == 403, path
    for path in ["picture", "status", "save.png", "save.exr", "camera", "film", "manual", "manual/", "report", "pick?x=1&y=1"]:
        assert code(path, b"x=1", {"X-Token": token}) == 405, path
        assert code(path, None, {"Origin": "http://evil.example"}) == 403, path
        assert code(path, None, {"Host": "evil.example"}) == 403, path
        assert code(path, None, {"Sec-Fetch-Site": "cross-site"}) == 403, path
    for path in ["manual/../scene.pov", "manual//etc/passwd", "manual/%2e%2e/x.html", "manual/.x.html"]:
        assert code(path) == 404, path
    assert status()["version"] == before["version"] and status()["film"] == before["film"]
    for path, form in [("dim", b"lamp=9&strength=1&red=1&green=1&blue=1")]: assert post(path, form) == 404
    for path, form in [("dim", b"lamp=0&strength=nan&red=1&green=1&blue=1"), ("dim", b"lamp=0"), ("develop", b"name=none&value=1"),
                       ("develop", b"name=exposure&value=inf"), ("develop", b"name=response&value=none"),
                       ("orbit", b"by=turn&right=1e9&up=0"), ("orbit", b"by=none&right=1&up=1"), ("orbit", b"approach=-1"),
                       ("orbit", b""), ("point", b"x=1"), ("point", b"x=nan&y=0"), ("look", b"view=")]:
        assert post(path, form) == 400, (path, form)
    bright = floor()
    assert bright[0] > 20
    changed("dim", b"lamp=0&strength=0&red=1&green=1&blue=1")
    until("a dark floor", lambda s: floor() == [0, 0, 0])
    changed("dim", b"lamp=0&strength=1&red=0&green=0&blue=1")
    until("a blue floor", lambda s: floor()[:2] == [0, 0])
    assert status()["relit"]
    changed("dim", b"reset=all")
    until("the floor as it was", lambda s: floor() == bright)
    changed("develop", b"name=exposure&value=-2")
    until("a darker floor", lambda s: floor()[0] < bright[0])
    assert get("film").decode().startswith("film { exposure -2"), get("film")
    changed("develop", b"name=reset")
    until("the floor as it was", lambda s: floor() == bright)
    assert status()["generation"] == generation  # all that without rendering
    assert b"<0, 1, -5>" in get("camera")
    assert post("orbit", b"by=turn&right=90&up=0") == 200
    until("another picture", lambda s: s["generation"] > generation and s["progress"] == 1 and s["moved"])
    assert b"<0, 1, -5>" not in get("camera") and b"look_at" in get("camera")
    assert post("orbit", b"reset=all") == 200
    until("the scene's camera", lambda s: not s["moved"] and s["progress"] == 1 and floor() == bright)
    saved = urllib.request.urlopen(address + "save.exr")
    assert "scene.exr" in saved.headers["Content-Disposition"] and saved.read()[:4] == bytes([0x76, 0x2f, 0x31, 1])
    assert get("save.png")[1:4] == b"PNG"
    assert post("point", b"x=0.5&y=0.9") == 200 and post("pause", b"on=yes") == 200 and status()["paused"]
    assert b"book" in get("manual") if code("manual") == 200 else code("manual") == 404
)"));
}

TEST_CASE("of an animation the preview shows the frame that is chosen") {
    if (!has_python()) return;
    const Shell shell;
    shell.write("scene.pov",
                "camera { orthographic location -5*z right 4*x up 3*y }\n"
                "plane { z, 1 pigment { rgb clock } finish { ambient 1 diffuse 0 } }");
    CHECK(client_succeeds(shell, R"(
def red():
    for _ in range(300):
        if status()["progress"] == 1: return get("pick?x=3&y=3").decode().split("rgb <")[1].split(",")[0]
        time.sleep(0.1)
def look():
    begin("+W8", "+H6", "+KFI3", "+KFF5")
    assert red() == "0"
    assert [(k["name"], k["low"], k["high"]) for k in status()["knobs"]] == [("frame_number", 3, 5)]
    before = status()["generation"]
    assert post("turn", b"name=frame_number&value=5") == 200
    while status()["generation"] == before: time.sleep(0.1)
    assert red() == "1", red()
)"));
}

TEST_CASE("a preview for other machines answers those who have its whole address") {
    if (!has_python()) return;
    const Shell shell;
    shell.write("scene.pov", lit_scene);
    CHECK(python_succeeds(shell, R"py(
import re, subprocess, sys, urllib.error, urllib.request
run = subprocess.Popen([*sys.argv[1:], "--preview", "0", "--preview-host", "127.0.0.2"],
                       stderr=subprocess.PIPE, text=True)
try:
    while not (line := run.stderr.readline()).startswith("preview: "): pass
    whole = line.split()[-1]
    base, token = re.fullmatch("(http://127.0.0.2:[0-9]+/).token=([0-9a-f]{32})", whole).groups()
    def code(path, **heads):
        try: return urllib.request.urlopen(urllib.request.Request(base + path, None, heads), timeout=10).status
        except urllib.error.HTTPError as refusal: return refusal.code
    assert code("") == code("status") == code("?token=" + "0" * 32) == 403
    page = urllib.request.urlopen(whole, timeout=10)
    cookie = page.headers["Set-Cookie"].split(";")[0]
    assert b"<!DOCTYPE html>" in page.read()
    assert code("status", Cookie=cookie) == code("style.css", Cookie=cookie) == 200
finally: run.terminate()
assert run.wait(20) == 0
)py"));
    Shell wrong;
    CHECK(wrong({wrong.path("lit.pov"), "--preview-host", "0.0.0.0"}) == exit_status::usage);
    CHECK_THAT(wrong.err, Catch::Contains("--preview 8000 --preview-host 0.0.0.0"));
    CHECK(wrong({wrong.path("lit.pov"), "--preview", "0", "--preview-host", "here"}) ==
          exit_status::file);
    CHECK_THAT(wrong.err, Catch::Contains("an address of this machine"));
}

}  // namespace candelabra
