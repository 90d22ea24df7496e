# SPDX-License-Identifier: BSD-3-Clause
"""A page in headless Chromium with the network blocked, driven through the DevTools protocol."""

import base64
import io
import json
import subprocess
import time
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.image import imread
from websockets.sync.client import ClientConnection, connect

PATIENCE_S = 120.0
POLL_S = 0.05
WIDTH, HEIGHT = 700, 620
OPTIONS = (
    "--headless=new",
    "--no-sandbox",  # root has none
    "--no-first-run",
    "--disable-background-networking",
    "--disable-dev-shm-usage",
    "--host-resolver-rules=MAP * ~NOTFOUND",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--remote-debugging-port=0",
    f"--window-size={WIDTH},{HEIGHT}",
)


class Page:
    """`errors` holds what went wrong in the page, `requests` every address that it asked for."""

    def __init__(self, connection: ClientConnection) -> None:
        self._connection = connection
        self._sent = 0
        self.errors: list[str] = []
        self.requests: list[str] = []
        for domain in ("Runtime", "Log", "Network", "Page"):
            self._send(f"{domain}.enable")

    def open(self, file: Path) -> None:
        self._send("Page.navigate", url=file.resolve().as_uri())

    def evaluate(self, expression: str) -> Any:
        answer = self._send("Runtime.evaluate", expression=expression, returnByValue=True)
        assert "exceptionDetails" not in answer, answer
        return answer["result"].get("value")

    def wait_for(self, expression: str) -> Any:
        """What the expression is once it is true."""
        return wait_until(lambda: self.evaluate(expression), expression)

    def wait_for_frames(self, count: int) -> None:
        draw = "(function draw() { if (--frames_left > 0) requestAnimationFrame(draw) })()"
        self.evaluate(f"window.frames_left = {count + 1}; {draw}")
        self.wait_for("frames_left === 0")

    def click(self, selector: str, share: float = 0.5) -> None:
        """At this share of the element's width."""
        box = self.evaluate(
            f"document.querySelector({json.dumps(selector)}).getBoundingClientRect().toJSON()"
        )
        place = {"x": box["x"] + share * box["width"], "y": box["y"] + box["height"] / 2}
        for kind in ("mousePressed", "mouseReleased"):
            self._send("Input.dispatchMouseEvent", type=kind, button="left", clickCount=1, **place)
            self.wait_for_frames(2)  # a slider follows the mouse from frame to frame

    def picture(self) -> np.ndarray:
        data = self._send("Page.captureScreenshot", format="png")["data"]
        return imread(io.BytesIO(base64.b64decode(data)))[:, :, :3]

    def _send(self, method: str, **parameters: object) -> dict[str, Any]:
        self._sent += 1
        self._connection.send(json.dumps({"id": self._sent, "method": method, "params": parameters}))
        while True:
            message = json.loads(self._connection.recv(timeout=PATIENCE_S))
            if message.get("id") == self._sent:
                assert "error" not in message, message
                return message["result"]
            self._note(message["method"], message["params"])

    def _note(self, event: str, about: dict[str, Any]) -> None:
        if event == "Network.requestWillBeSent":
            self.requests.append(about["request"]["url"])
        elif event == "Network.webSocketCreated":
            self.requests.append(about["url"])
        elif event == "Runtime.exceptionThrown":
            self.errors.append(str(about["exceptionDetails"]))
        elif event == "Runtime.consoleAPICalled" and about["type"] in ("error", "assert"):
            self.errors.append(str(about["args"]))
        elif event == "Log.entryAdded" and about["entry"]["level"] == "error":
            self.errors.append(about["entry"]["text"])


def wait_until(condition: Any, what: str) -> Any:
    end = time.monotonic() + PATIENCE_S
    while time.monotonic() < end:
        if found := condition():
            return found
        time.sleep(POLL_S)
    raise AssertionError(f"not within {PATIENCE_S} s: {what}")


@contextmanager
def chromium(profile: Path) -> Iterator[Page]:
    """`profile`: an empty folder. Fails where Debian's chromium is not installed."""
    command = ["chromium", *OPTIONS, f"--user-data-dir={profile}", "about:blank"]
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        port_file = profile / "DevToolsActivePort"
        wait_until(lambda: port_file.is_file() and port_file.read_text().count("\n"), "DevTools are there")
        port = port_file.read_text().split()[0]
        local = urllib.request.build_opener(urllib.request.ProxyHandler({}))
        targets = json.load(local.open(f"http://127.0.0.1:{port}/json/list"))
        address = next(one["webSocketDebuggerUrl"] for one in targets if one["type"] == "page")
        with connect(address, max_size=None, proxy=None) as connection:
            yield Page(connection)
    finally:
        process.terminate()
        process.wait()
