"""How each command that a README names is proven to work: by a run of its quick form, or by what
runs it anyway. A row for each key of named.py.
"""
import http.client
import json
import pathlib
import re
import subprocess
import sys
from dataclasses import dataclass
from typing import Callable

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "end_to_end"))
from wire import GENEROUS_S, Client, Server  # noqa: E402  (a client of protocol/README.md)

SMALL = "phantom:head@32"
SMALL_FRAMES = ["--sizes", "64x64", "--seconds", "0.05", "--least-frames", "1", "--frames", "2"]
IN_WEB_CLIENT = 'cd web-client && PATH="$(../deploy/node-path):$PATH"'
PATH_WITH_NODE = 'PATH="$(deploy/node-path):$PATH"'


@dataclass(frozen=True)
class Run:
    """work(folder): raises where it fails. in_full: done with --full alone, with the reason."""

    work: Callable
    in_full: str = ""


@dataclass(frozen=True)
class Elsewhere:
    """What runs it: a file of the repository, and the words there that do."""

    file: str
    words: str

    def check(self):
        text = (ROOT / self.file).read_text()
        assert self.words in text, f"{self.file} was to run it, and does not say '{self.words}'"


def shell(command, **arguments):
    """To its end; what it says is in the exception where it fails."""
    done = subprocess.run(
        command, shell=isinstance(command, str), cwd=ROOT, text=True,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **arguments,
    )  # fmt: skip
    assert done.returncode == 0, f"{command} ended with {done.returncode}:\n{done.stdout[-4000:]}"
    return done.stdout


def built(program):
    return ROOT / "build" / "release" / program


def page_at(port):
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=GENEROUS_S)
    connection.request("GET", "/")
    answer = connection.getresponse()
    assert answer.status == 200, answer.status
    return answer.read()


def started(command, words, use):
    """Starts it, waits for a line with the words, whose first group is a port, and ends it after use(port)."""
    process = subprocess.Popen(
        command, cwd=ROOT, text=True, shell=True, start_new_session=True,
        stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
    )  # fmt: skip
    try:
        said = []
        for line in process.stdout:
            said.append(line)
            found = re.search(words, re.sub(r"\x1b\[[0-9;]*m", "", line))
            if found:
                return use(int(found[1]))
        raise AssertionError(f"{command} ended without '{words}':\n{''.join(said)[-4000:]}")
    finally:
        subprocess.run(["kill", "--", f"-{process.pid}"], check=False)
        process.communicate(timeout=GENEROUS_S)


def deploy_run(folder):
    def see(port):
        assert b"Cutaway" in page_at(port)
        client = Client(port)
        client.open(SMALL)
        client.rest()
        client.close()

    started("deploy/run --listen 127.0.0.1:0", r"Cutaway is at http://127\.0\.0\.1:(\d+)/", see)


def serve(folder):
    server = Server(built("cutaway"), "--data", folder)
    assert server.get("/healthz")[0] == 200
    assert server.stop() == 0


def info(folder):
    assert '"size"' in shell([built("cutaway"), "info", SMALL, "--json"])


def render(folder):
    picture = folder / "out.png"
    style = ROOT / "server" / "styles" / "flagship.json"
    shell([built("cutaway"), "render", style, "-o", picture, "--volume", SMALL, "--size", "64x48"])
    assert picture.stat().st_size > 0


def load(folder):
    server = Server(built("cutaway"))
    report, page = folder / "load.json", folder / "load.html"
    script = ROOT / "tests" / "load" / "scripts" / "sessions.json"  # asks for no speed
    command = [built("cutaway-load"), script, "--url", f"ws://127.0.0.1:{server.port}/ws", "--clients", "2",
               "--seconds", "3", "--watch-pid", str(server.process.pid), "--json", report, "--html", page]  # fmt: skip
    done = subprocess.run(command, capture_output=True, text=True, timeout=GENEROUS_S)
    server.stop()
    # On a busy machine a client may see no frame in so short a time: 1 says so.
    assert done.returncode in (0, 1), done.stdout + done.stderr
    clients = json.loads(report.read_text())["clients"]
    assert [(c["errors"], c["disconnected"]) for c in clients] == [(0, False)] * 2, done.stdout
    assert "<svg" in page.read_text()


def benchmark(folder):
    report = folder / "benchmark.json"
    shell(["tests/benchmark/run", "--phantom-size", "32", "--volumes", "head", "--cases", "lens",
           *SMALL_FRAMES, "--json", report])  # fmt: skip
    assert report.stat().st_size


def scaling(folder):
    told = shell(
        ["tests/benchmark/scaling", "--edges", "32", "48", "--edge", "32", "--size", "64x64", "--sizes", "64x64",
         "128x128", "--jpeg-sizes", "64x64", "--threads", "1", "--seconds", "0.05", "--clients", "1", "2",
         "--session-seconds", "3", "--json", folder / "scaling.json"]
    )  # fmt: skip
    assert "sessions" in told


def evaluation(folder):
    shell(["tests/evaluation/run", folder / "evaluation", "--quick"])
    page = (folder / "evaluation" / "report.html").read_text()
    assert page.rstrip().endswith("</table></body></html>") and "sobel" in page[-4000:]


def whole_evaluation(folder):
    shell(["tests/evaluation/run", folder / "evaluation"])


def page(folder):
    shell(f"{PATH_WITH_NODE} CUTAWAY_BINARY=build/release/cutaway node tests/benchmark/page.mjs --seconds 1")


def dev_server(folder):
    """The page as Vite serves it."""
    started(
        f"{IN_WEB_CLIENT} npm run dev -- --port 0 --host 127.0.0.1", r"http://127\.0\.0\.1:(\d+)/", page_at
    )


def mock_server(folder):
    started(f"{IN_WEB_CLIENT} npm run mock -- --port 0", r"http://127\.0\.0\.1:(\d+)/", page_at)


COMMANDS = {
    "deploy/run": Run(deploy_run),
    "deploy/build": Elsewhere("tests/run", "deploy/build release"),
    "deploy/install-packages": Elsewhere("tests/run", "deploy/install-packages deploy/packages.txt tests/packages.txt"),
    "cutaway serve": Run(serve),
    "cutaway info": Run(info),
    "cutaway render": Run(render),
    "cutaway-load": Run(load),
    "cmake --preset": Elsewhere("tests/run", 'cmake --preset "$preset"'),
    "cmake --build": Elsewhere("tests/run", 'cmake --build --preset "$preset"'),
    "npm ci": Elsewhere("deploy/build", "npm ci"),
    "npm run build": Elsewhere("deploy/build", "npm run build"),
    "npm run check": Elsewhere("tests/run", "npm run check"),
    "npm run test:browser": Elsewhere("tests/run", "npm --prefix web-client run test:browser"),
    "npm run dev": Run(dev_server),
    "npm run mock": Run(mock_server),
    "tests/run": Elsewhere("tests/run", "tests/readme/run"),
    "tests/tools/check_arrows": Elsewhere("tests/run", "tests/tools/check_arrows"),
    "tests/fresh_machine": Elsewhere(".ci/run", "tests/fresh_machine"),
    "tests/evaluation/tests/run": Elsewhere("tests/run", "tests/evaluation/tests/run"),
    "tests/evaluation/run": Run(evaluation),
    "tests/benchmark/run": Run(benchmark),
    "tests/benchmark/scaling": Run(scaling),
    "node tests/benchmark/page.mjs": Run(page, "a browser that is dragged in for a minute"),
    "tests/benchmark/yardstick": Run(
        lambda folder: shell(["tests/benchmark/yardstick", folder / "out.json", "--volume", "head", "--size",
                              "128x128", "--rounds", "1"]),
        "VTK is installed for it",
    ),
    "tests/soak": Run(
        lambda folder: shell(["tests/soak", "1", "--html", folder / "soak.html"]), "a minute at the least"
    ),
    "tests/benchmark/bundle": Run(
        lambda folder: shell(["tests/benchmark/bundle", folder / "bundle"]), "all is built once more for it"
    ),
}  # fmt: skip

# Of those above, what is run as a whole where time does not matter.
WHOLE = {"tests/evaluation/run, as a whole": Run(whole_evaluation, "a quarter of an hour")}
