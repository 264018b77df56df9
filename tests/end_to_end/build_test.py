"""When deploy/build makes the web client anew, and which CTs the benchmark takes: in a small tree with stand-ins.

Usage: build_test.py [unittest arguments]
"""

import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "deploy" / "build"
BENCHMARK = ROOT / "tests" / "benchmark" / "run"
NPM = """#!/bin/sh
echo "$*" >>"$CALLS"
[ "$1" = run ] && mkdir -p dist src/protocol/generated && date +%N | tee dist/index.html >src/protocol/generated/protocol.ts
[ "$1" = ci ] && mkdir -p node_modules && touch node_modules/.package-lock.json
exit 0
"""


class BuildTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.calls = self.root / "calls"
        for name in ("src/main.ts", "src/old.ts", "tsconfig.json", "scripts/generate_types.mjs", "package-lock.json"):
            self.write(f"web-client/{name}", name)
        self.write("protocol/schema/scene.schema.json", "{}")
        self.write("build/release/build.ninja", "")
        self.write("deploy/node-path", '#!/bin/sh\necho "$PWD/tools"\n')
        self.write("tools/npm", NPM)
        self.write("tools/cmake", "#!/bin/sh\n")
        shutil.copy(SCRIPT, self.root / "deploy" / "build")
        self.build()

    def write(self, name, content):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(content)
        path.chmod(0o755)

    def build(self):
        """What npm was asked for."""
        self.calls.write_text("")
        environment = os.environ | {"CALLS": str(self.calls), "PATH": f"{self.root}/tools:{os.environ['PATH']}"}
        subprocess.run([self.root / "deploy" / "build"], env=environment, check=True, stdout=subprocess.DEVNULL)
        return self.calls.read_text().splitlines()

    def test_nothing_is_done_twice(self):
        self.assertEqual(self.build(), [])

    def test_a_new_time_alone_is_no_change(self):
        (self.root / "web-client/src/main.ts").touch()
        self.assertEqual(self.build(), [])

    def test_whatever_the_client_is_made_from_counts(self):
        for name in ("web-client/src/main.ts", "web-client/tsconfig.json", "web-client/scripts/generate_types.mjs",
                     "web-client/src/new.ts", "protocol/schema/scene.schema.json"):  # fmt: skip
            self.write(name, "changed")
            self.assertEqual(self.build(), ["run build"], name)
            self.assertEqual(self.build(), [], name)

    def test_so_does_a_source_that_was_deleted(self):
        (self.root / "web-client/src/old.ts").unlink()
        self.assertEqual(self.build(), ["run build"])

    def test_another_lock_file_installs_and_builds(self):
        lock = self.root / "web-client/package-lock.json"
        lock.write_text("changed")
        os.utime(lock, (os.stat(lock).st_atime + 10, os.stat(lock).st_mtime + 10))
        self.assertEqual([call.split()[0] for call in self.build()], ["ci", "run"])

    def test_a_build_that_is_gone_is_made_again(self):
        (self.root / "web-client/dist/index.html").unlink()
        self.assertEqual(self.build(), ["run build"])


class BenchmarkTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name).resolve()
        self.root = self.folder / "checkout"
        for tool, does in (
            ("deploy/install-packages", "exit 0"),
            ("deploy/build", "exit 0"),
            ("build/release/cutaway-benchmark", 'echo "$@"'),
        ):
            path = self.root / tool
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(f"#!/bin/sh\n{does}\n")
            path.chmod(0o755)
        self.script = self.root / "tests" / "benchmark" / "run"
        self.script.parent.mkdir(parents=True)
        shutil.copy(BENCHMARK, self.script)

    def arguments(self, *given, **variables):
        """What the benchmark is called with."""
        environment = {name: value for name, value in os.environ.items() if name != "CUTAWAY_TEST_DATA"} | variables
        done = subprocess.run([self.script, *given], env=environment, check=True, capture_output=True, text=True)
        return done.stdout.split()

    def test_data_is_taken_where_it_is_named_alone(self):
        (self.folder / "shared" / "data").mkdir(parents=True)
        self.assertEqual(self.arguments("--json", "f"), ["--json", "f"])
        self.assertEqual(self.arguments(CUTAWAY_TEST_DATA="/other"), ["--data", "/other"])
        self.assertEqual(self.arguments("--data", "/named"), ["--data", "/named"])


if __name__ == "__main__":
    unittest.main(verbosity=2)
