# SPDX-License-Identifier: GPL-3.0-or-later
"""A browser without a window, driven by the DevTools protocol over a pipe. For tests of the preview's page."""
import base64
import json
import os
import select
import subprocess
import time
from pathlib import Path


class Chromium:
    """One page. Errors of its scripts are collected in `errors`."""

    def __init__(self, profile, width=1280, height=800):
        self.errors, self.buffer, self.number = [], b"", 0
        to_child, self.out = os.pipe()
        self.into, from_child = os.pipe()

        def descriptors():
            low = os.dup(to_child), os.dup(from_child)
            os.dup2(low[0], 3)
            os.dup2(low[1], 4)

        self.process = subprocess.Popen(
            ["chromium", "--headless=new", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--no-first-run",
             "--user-data-dir=" + profile, f"--window-size={width},{height}", "--remote-debugging-pipe", "about:blank"],
            preexec_fn=descriptors, close_fds=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_child)
        os.close(from_child)
        targets = self.call("Target.getTargets")["targetInfos"]
        target = next(each["targetId"] for each in targets if each["type"] == "page")
        self.session = None
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log"):
            self.call(domain + ".enable")
        self.size(width, height)

    session = None

    def message(self, seconds):
        """The next message, or nothing."""
        end = time.monotonic() + seconds
        while b"\0" not in self.buffer:
            rest = end - time.monotonic()
            if rest <= 0 or not select.select([self.into], [], [], rest)[0]:
                return None
            part = os.read(self.into, 1 << 20)
            if not part:
                raise RuntimeError("the browser has ended")
            self.buffer += part
        one, self.buffer = self.buffer.split(b"\0", 1)
        message = json.loads(one)
        if message.get("method") == "Runtime.exceptionThrown":
            self.errors.append(message["params"]["exceptionDetails"])
        if message.get("method") == "Log.entryAdded" and message["params"]["entry"]["level"] == "error":
            self.errors.append(message["params"]["entry"])
        return message

    def call(self, method, **params):
        self.number += 1
        number = self.number
        request = {"id": number, "method": method, "params": params}
        if self.session:
            request["sessionId"] = self.session
        os.write(self.out, json.dumps(request).encode() + b"\0")
        end = time.monotonic() + 60
        while time.monotonic() < end:
            message = self.message(1)
            if message and message.get("id") == number:
                if "error" in message:
                    raise RuntimeError(f"{method}: {message['error']}")
                return message["result"]
        raise RuntimeError(method + ": no answer")

    def size(self, width, height, phone=False):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=phone)
        self.call("Emulation.setTouchEmulationEnabled", enabled=phone)

    def go(self, address):
        self.call("Page.navigate", url=address)

    def run(self, script):
        """The value of an expression on the page, which may be a promise."""
        result = self.call("Runtime.evaluate", expression=script, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in result:
            raise RuntimeError(str(result["exceptionDetails"]))
        return result["result"].get("value")

    def until(self, script, seconds=60):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            try:
                if value := self.run(script):
                    return value
            except RuntimeError as not_yet:
                if "no answer" in str(not_yet):
                    raise
            time.sleep(0.05)
        raise AssertionError("never: " + script)

    def mouse(self, kind, x, y, **more):
        self.call("Input.dispatchMouseEvent", type="mouse" + kind, x=x, y=y, **more)

    def drag(self, path, modifiers=0):
        (x, y), *rest = path
        self.mouse("Pressed", x, y, button="left", buttons=1, clickCount=1, modifiers=modifiers)
        for x, y in rest:
            self.mouse("Moved", x, y, button="left", buttons=1, modifiers=modifiers)
        self.mouse("Released", x, y, button="left", clickCount=1, modifiers=modifiers)

    def click(self, x, y):
        self.drag([(x, y)])

    def key(self, key):
        self.call("Input.dispatchKeyEvent", type="keyDown", key=key, text=key if len(key) == 1 else "")
        self.call("Input.dispatchKeyEvent", type="keyUp", key=key)

    def shot(self, path):
        with open(path, "wb") as file:
            file.write(base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"]))

    def cpu(self):
        """Seconds of processors that the browser and its processes have taken."""
        parents, ticks = {}, {}
        for stat in Path("/proc").glob("[0-9]*/stat"):
            try:
                fields = stat.read_text().rsplit(")", 1)[1].split()
            except OSError:
                continue  # it has ended
            parents[int(stat.parent.name)] = int(fields[1])
            ticks[int(stat.parent.name)] = sum(int(each) for each in fields[11:15])  # with those of children that have ended
        own = [self.process.pid]
        for one in own:
            own += [child for child, parent in parents.items() if parent == one]
        return sum(ticks[one] for one in own) / os.sysconf("SC_CLK_TCK")

    def end(self):
        self.process.terminate()
        self.process.wait(20)
