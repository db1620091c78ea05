# SPDX-License-Identifier: LGPL-2.1-or-later
"""A browser without a window, for tests of pages: chromedriver by its protocol."""

import atexit
import base64
import io
import json
import re
import shutil
import subprocess
import sys
import urllib.error
import urllib.request

import matplotlib.image

from report_test import check, require_three

# WebGL without a graphics card, and a pipe to the driver: a machine need not know the
# name localhost
OPTIONS = ["--headless=new", "--no-sandbox", "--window-size=1000,900",
           "--force-device-scale-factor=1", "--hide-scrollbars",
           "--disable-dev-shm-usage", "--enable-unsafe-swiftshader",
           "--use-angle=swiftshader", "--remote-debugging-pipe"]

# The letters that stand for keys
KEYS = {"Home": "\ue011", "ArrowLeft": "\ue012", "ArrowUp": "\ue013"}


class Browser:
    """A session with one page, and the view in one of its sections."""

    def __init__(self, path, *options, section="shell"):
        """Opens a page and waits for its view; skips the test if that or the
        browser cannot be there."""
        require_three()
        self.figure = f'document.querySelector("#{section} figure.view")'
        programs = [shutil.which(name) for name in ("chromium", "chromedriver")]
        if not all(programs):
            print("skipped: chromium or its chromedriver is missing")
            sys.exit(77)
        self.driver = subprocess.Popen(
            [programs[1], "--port=0"], stdout=subprocess.PIPE, text=True)
        atexit.register(self.close)
        port = next(found for line in self.driver.stdout
                    if (found := re.search(r"successfully on port (\d+)", line))).group(1)
        self.address = f"http://127.0.0.1:{port}/session"
        try:
            answer = self._post("", {"capabilities": {"alwaysMatch": {
                "goog:chromeOptions": {"binary": programs[0],
                                       "args": [*OPTIONS, *options]},
                "goog:loggingPrefs": {"browser": "ALL"}}}})
        except urllib.error.HTTPError as error:
            # before any page: as in a root without the devices that it needs
            reason = json.load(error)["value"]["message"].partition("\n")[0]
            print(f"skipped: the browser does not start ({reason})")
            sys.exit(77)
        self.address += "/" + answer["sessionId"]
        self._post("/url", {"url": path.resolve().as_uri()})
        self.run("figure.scrollIntoView(); await view?.ready;")

    def _post(self, command, body):
        """The answer to a command, or None."""
        request = urllib.request.Request(
            self.address + command, json.dumps(body).encode(),
            {"Content-Type": "application/json"})
        with urllib.request.urlopen(request, timeout=60) as answer:
            return json.load(answer)["value"]

    def run(self, script, *arguments):
        """What a function with this body returns; it may await promises, and knows
        the figure of the view and the view."""
        return self._post("/execute/async", {
            "script": "const done = arguments[arguments.length - 1];"
                      f"const figure = {self.figure}, view = figure.view;"
                      f"(async function () {{ {script} }}).apply(null, arguments)"
                      ".then(done, (error) => done('error: ' + error));",
            "args": list(arguments)})

    def set(self, label, value):
        """Sets a control of the view by its label and waits for the drawing; the
        value of a box is true or false."""
        error = self.run("""
            const [start, value] = arguments;
            const label = [...figure.querySelectorAll("label")].find(
              (label) => label.textContent.trim().startsWith(start));
            const control = label.querySelector("input, select");
            if (control.type === "checkbox") {
              if (control.checked !== value)
                control.click();
            } else {
              control.value = value;
              control.dispatchEvent(new Event("input"));
            }
            await view.ready;""", label, value)
        check(error is None, f"{label} cannot be set: {error}")

    def drag(self, right, down):
        """Drags from the middle of the view by some pixels."""
        element = self.run("return view.canvas;")
        moves = [{"type": "pointerMove", "origin": element, "x": 0, "y": 0},
                 {"type": "pointerDown", "button": 0},
                 {"type": "pointerMove", "origin": "pointer", "x": right, "y": down,
                  "duration": 50},
                 {"type": "pointerUp", "button": 0}]
        self._post("/actions", {"actions": [
            {"type": "pointer", "id": "mouse", "actions": moves}]})

    def press(self, *keys):
        """Presses keys, by their names in KEYS, where the focus is."""
        actions = [{"type": kind, "value": KEYS[key]} for key in keys
                   for kind in ("keyDown", "keyUp")]
        self._post("/actions", {"actions": [
            {"type": "key", "id": "keyboard", "actions": actions}]})

    def picture(self):
        """What the window shows: rows of pixels, red, green and blue from 0 to
        255."""
        with urllib.request.urlopen(self.address + "/screenshot",
                                    timeout=60) as answer:
            data = base64.b64decode(json.load(answer)["value"])
        return 255 * matplotlib.image.imread(io.BytesIO(data))[..., :3]

    def check_no_errors(self):
        """Checks that the console has no errors, and nothing was loaded."""
        errors = [entry["message"] for entry in
                  self._post("/se/log", {"type": "browser"})
                  if entry["level"] == "SEVERE"]
        check(not errors, f"the console has errors: {errors}")
        loaded = self.run("return performance.getEntriesByType('resource')"
                          ".map((entry) => entry.name)"
                          ".filter((name) => !/^(data|blob):/.test(name));")
        check(not loaded, f"the page loads {loaded}")

    def close(self):
        """Ends the browser."""
        try:
            urllib.request.urlopen(urllib.request.Request(
                self.address, method="DELETE"), timeout=10).close()
        except OSError:
            pass
        self.driver.terminate()
        self.driver.wait()
        self.driver.stdout.close()
