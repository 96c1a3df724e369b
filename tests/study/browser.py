# SPDX-License-Identifier: MIT
"""A page in headless Chromium, driven by the DevTools protocol through a pipe: no other package, no port."""
import base64
import json
import os
import select
import subprocess
import tempfile
import time

KEYS = {"ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39, "ArrowDown": 40, "Enter": 13, "Tab": 9, "p": 80}


class Page:
    """Problems: errors of the console, exceptions, and requests for anything but files and data."""

    def __init__(self, url, width=1400, height=1000, dark=False):
        self.folder = tempfile.TemporaryDirectory(prefix="strobe_browser_", ignore_cleanup_errors=True)
        to_child, to_browser = os.pipe()
        from_browser, from_child = os.pipe()
        command = ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--remote-debugging-pipe", "--no-first-run",
                   f"--user-data-dir={self.folder.name}", f"--window-size={width},{height}", "about:blank"]

        def connect():  # the browser reads from 3 and writes to 4
            read, write = os.dup(to_child), os.dup(from_child)
            os.dup2(read, 3)
            os.dup2(write, 4)

        self.process = subprocess.Popen(command, preexec_fn=connect, pass_fds=(3, 4), stdin=subprocess.DEVNULL,
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_child)
        os.close(from_child)
        self.output, self.input, self.rest, self.number = to_browser, from_browser, b"", 0
        self.problems, self.events, self.session = [], [], None
        target = next(one for one in self.call("Target.getTargets")["targetInfos"] if one["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=target["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(domain + ".enable")
        self.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])
        self.go(url)

    def close(self):
        try:
            self.session = None
            self.call("Browser.close")
            self.process.wait(10)
        except (OSError, TimeoutError, subprocess.TimeoutExpired):
            self.process.kill()
            self.process.wait()
        os.close(self.output)
        os.close(self.input)
        self.folder.cleanup()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def message(self, until):
        while b"\0" not in self.rest:
            if not select.select([self.input], [], [], max(0, until - time.monotonic()))[0]:
                raise TimeoutError("the browser does not answer")
            got = os.read(self.input, 1 << 20)
            if not got:
                raise OSError("the browser has ended")
            self.rest += got
        text, self.rest = self.rest.split(b"\0", 1)
        return json.loads(text)

    def heard(self, message):
        method, of = message.get("method"), message.get("params", {})
        self.events.append(method)
        if method == "Runtime.exceptionThrown":
            details = of["exceptionDetails"]
            self.problems.append(details.get("exception", {}).get("description", details["text"]))
        if method == "Runtime.consoleAPICalled" and of["type"] in ("error", "warning", "assert"):
            self.problems.append("console: " + json.dumps(of["args"]))
        if method == "Log.entryAdded" and of["entry"]["level"] in ("error", "warning"):
            self.problems.append("log: " + of["entry"]["text"])
        if method == "Network.requestWillBeSent" and not of["request"]["url"].startswith(("file:", "data:", "blob:")):
            self.problems.append("request: " + of["request"]["url"])

    def call(self, name, **parameters):
        self.number += 1
        message = {"id": self.number, "method": name, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.output, json.dumps(message).encode() + b"\0")
        until = time.monotonic() + 60
        while True:
            answer = self.message(until)
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(f"{name}: {answer['error']}")
                return answer["result"]
            self.heard(answer)

    def go(self, url):
        self.events.clear()
        self.call("Page.navigate", url=url)
        until = time.monotonic() + 60
        while "Page.loadEventFired" not in self.events and "Page.navigatedWithinDocument" not in self.events:
            self.heard(self.message(until))

    def run(self, script):
        """The value of a script's last expression; promises are awaited."""
        result = self.call("Runtime.evaluate", expression=script, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in result:
            raise RuntimeError(script + ": " + result["exceptionDetails"].get("exception", {}).get("description", "?"))
        return result["result"].get("value")

    def key(self, key):
        text = {"text": key} if len(key) == 1 else {"text": "\r"} if key == "Enter" else {}
        for kind in ("keyDown", "keyUp"):
            self.call("Input.dispatchKeyEvent", type=kind, key=key, windowsVirtualKeyCode=KEYS[key], **(text if kind == "keyDown" else {}))

    def place(self, selector, x=0.5, y=0.5):
        self.run(f"document.querySelector({json.dumps(selector)}).scrollIntoView({{block: 'center'}})")
        box = self.run(f"(() => {{ const b = document.querySelector({json.dumps(selector)}).getBoundingClientRect();"
                       " return [b.left, b.top, b.width, b.height]; })()")
        return {"x": box[0] + x * box[2], "y": box[1] + y * box[3]}

    def click(self, selector):
        at = self.place(selector)
        for kind in ("mousePressed", "mouseReleased"):
            self.call("Input.dispatchMouseEvent", type=kind, button="left", clickCount=1, **at)

    def drag(self, selector, start, end):
        """From one place in an element to another, as shares of its sides."""
        for kind, at, held in (("mousePressed", start, 1), ("mouseMoved", end, 1), ("mouseReleased", end, 0)):
            self.call("Input.dispatchMouseEvent", type=kind, button="left", buttons=held, clickCount=1, **self.place(selector, *at))

    def point(self, selector, x, y):
        """Moves the pointer to a place in an element, as shares of its sides."""
        self.call("Input.dispatchMouseEvent", type="mouseMoved", **self.place(selector, x, y))

    def screenshot(self, file, whole=False):
        data = self.call("Page.captureScreenshot", format="png", captureBeyondViewport=whole)["data"]
        with open(file, "wb") as stream:
            stream.write(base64.b64decode(data))

    def pdf(self, file):
        data = self.call("Page.printToPDF", printBackground=True, preferCSSPageSize=True)["data"]
        with open(file, "wb") as stream:
            stream.write(base64.b64decode(data))
