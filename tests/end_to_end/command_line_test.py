"""Runs the executable as a person or a script does: arguments, exit status, what is printed where.

Usage: command_line_test.py CUTAWAY_BINARY [unittest arguments]
"""

import json
import os
import pathlib
import socket
import subprocess
import sys
import tempfile
import unittest
import zlib

from png import png_pixels
from wire import png_size

BINARY = None
OK, FAILED, WRONG_USAGE = 0, 1, 2
SMALL = "phantom:head@32"
NRRD = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n\n12345678"


def run(*arguments):
    done = subprocess.run([BINARY, *map(str, arguments)], capture_output=True, text=True, timeout=300)
    return done.returncode, done.stdout, done.stderr


class CommandLineTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def file(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def scene(self, **fields):
        return self.file("scene.json", json.dumps({"volume": SMALL, **fields}))

    def assert_one_plain_line(self, errors, *words):
        self.assertEqual(len(errors.splitlines()), 1, errors)
        self.assertTrue(errors.startswith("cutaway"), errors)
        for word in words:
            self.assertIn(str(word), errors)

    def assert_fails(self, arguments, *words):
        status, output, errors = run(*arguments)
        self.assertEqual((status, output), (FAILED, ""), (arguments, errors))
        self.assert_one_plain_line(errors, *words)

    def assert_wrong_usage(self, arguments, *words):
        status, output, errors = run(*arguments)
        self.assertEqual((status, output), (WRONG_USAGE, ""), (arguments, errors))
        for word in words:
            self.assertIn(word, errors)


class UsageTest(CommandLineTest):
    def test_help_is_everywhere_and_no_failure(self):
        for arguments, words in (
            ([], ("serve", "info", "render")),
            (["serve"], ("--data", "--listen", "--config", "--require-gpu")),
            (["info"], ("path", "--json")),
            (["render"], ("scene", "--output", "--volume", "--size")),
        ):
            status, output, errors = run(*arguments, "--help")
            self.assertEqual((status, errors), (OK, ""), arguments)
            for word in words:
                self.assertIn(word, output)
        self.assertNotIn("read-volume-worker", run("--help")[1])

    def test_the_version_is_said(self):
        status, output, _ = run("--version")
        self.assertEqual(status, OK)
        self.assertRegex(output, r"^cutaway \d+\.\d+\.\d+\n$")

    def test_what_is_not_understood_is_named(self):
        self.assert_wrong_usage([], "subcommand")
        self.assert_wrong_usage(["bogus"], "bogus")
        self.assert_wrong_usage(["serve", "bogus"], "bogus")
        self.assert_wrong_usage(["serve", "--no-such-option"], "--no-such-option")
        self.assert_wrong_usage(["info"], "path")
        self.assert_wrong_usage(["info", "a", "b"], "b")
        self.assert_wrong_usage(["render"], "scene")
        self.assert_wrong_usage(["render", "scene.json"], "--output")

    def test_malformed_arguments_are_wrong_usage(self):
        for address in ("foo", "127.0.0.1", "127.0.0.1:", ":80", "127.0.0.1:99999", "127.0.0.1:http"):
            self.assert_wrong_usage(["serve", "--listen", address], "--listen", address)
        for size in ("abc", "0x0", "640", "640x", "-1x5", "100000x100000", "640x480x3"):
            self.assert_wrong_usage(["render", "s.json", "-o", "x.png", "--size", size], "--size", size)
        self.assert_wrong_usage(["render", "s.json", "-o", "x.png", "--supersampling", "5"], "--supersampling")
        self.assert_wrong_usage(["render", "s.json", "-o", "x.png", "--volume", ""], "--volume", "empty")
        self.assert_wrong_usage(["info", ""], "path", "empty")


class ServeTest(CommandLineTest):
    def test_an_address_that_cannot_be_had_is_said_in_one_line(self):
        self.assert_fails(["serve", "--listen", "300.1.1.1:80"], "300.1.1.1:80", "address")
        self.assert_fails(["serve", "--listen", "192.0.2.1:8080"], "192.0.2.1:8080")
        with socket.create_server(("127.0.0.1", 0)) as taken:
            address = f"127.0.0.1:{taken.getsockname()[1]}"
            self.assert_fails(["serve", "--listen", address], address)

    def test_data_or_configuration_that_is_not_there_is_said_in_one_line(self):
        self.assert_fails(["serve", "--data", "/nowhere/at/all"], "/nowhere/at/all")
        self.assert_fails(["serve", "--config", "/nowhere/cutaway.toml"], "/nowhere/cutaway.toml")
        config = self.file("cutaway.toml", "[server]\nlisten = 'foo'\n")
        self.assert_fails(["serve", "--config", config], f"{config}:2", "foo")


class InfoTest(CommandLineTest):
    def test_a_phantom_in_words_and_as_json(self):
        status, output, errors = run("info", SMALL)
        self.assertEqual((status, errors), (OK, ""))
        self.assertIn("32 x 32 x 32 voxels", output)
        status, output, errors = run("info", SMALL, "--json")
        self.assertEqual((status, errors), (OK, ""))
        (volume,) = json.loads(output)["volumes"]
        self.assertEqual((volume["id"], volume["size"], volume["units"]), (SMALL, [32, 32, 32], "HU"))

    def test_what_holds_no_volume_fails_in_one_line(self):
        self.assert_fails(["info", "/nowhere/at/all"], "/nowhere/at/all")
        self.assert_fails(["info", "phantom:unicorn"], "phantom:unicorn")
        status, _, errors = run("info", self.file("notes.txt", "no volume"))
        self.assertEqual(status, FAILED)
        self.assert_one_plain_line(errors, "notes.txt")


    def test_a_volume_takes_hardly_more_memory_than_its_voxels(self):
        """Of the process and of its reader, each: 1.5 times the voxels and 64 MB."""
        size, bytes_of_voxels = 400, 2 * 400**3
        header = (f"NDims = 3\nDimSize = {size} {size} {size}\nElementSpacing = 1 1 1\nElementType = MET_SHORT\n"
                  "CompressedData = True\nElementDataFile = LOCAL\n")
        path = self.folder / "mask.mha"
        packer = zlib.compressobj(1)
        with path.open("wb") as file:
            file.write(header.encode())
            for plane in range(size):
                file.write(packer.compress(bytes([plane % 2, 0]) * size * size))
            file.write(packer.flush())
        measure = ("import resource, subprocess, sys; done = subprocess.run(sys.argv[1:], stdout=subprocess.DEVNULL);"
                   "print(done.returncode, resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)")
        done = subprocess.run([sys.executable, "-c", measure, BINARY, "info", str(path)], capture_output=True,
                              text=True, timeout=300)
        status, most_kib = map(int, done.stdout.split())
        self.assertEqual(status, OK, done.stderr)
        self.assertLess(most_kib * 1024, 1.5 * bytes_of_voxels + (64 << 20))

    def test_a_report_that_cannot_be_written_fails_in_one_line(self):
        for arguments in (["info", SMALL], ["info", SMALL, "--json"]):
            with open("/dev/full", "w") as full:
                done = subprocess.run([BINARY, *arguments], stdout=full, stderr=subprocess.PIPE, text=True, timeout=300)
            self.assertEqual(done.returncode, FAILED)
            self.assert_one_plain_line(done.stderr, "cannot be written")

    def test_a_link_that_is_named_is_followed(self):
        (self.folder / "links").mkdir()
        link = self.folder / "links" / "link.nrrd"
        link.symlink_to(self.file("real.nrrd", NRRD))
        status, output, errors = run("info", link)
        self.assertEqual((status, errors), (OK, ""))
        self.assertIn("2 x 2 x 2 voxels", output)

    def test_a_hostile_name_moves_no_cursor(self):
        self.file("bad\x1b[31m.nrrd", "NRRD0004\n\n")
        status, output, errors = run("info", self.folder)
        self.assertEqual((status, errors), (OK, ""))
        self.assertIn("refused", output)
        self.assertIn("\\x1b[31m", output)
        self.assertNotIn("\x1b", output)
        status, _, errors = run("info", self.folder / "bad\x1b[31m.nrrd")
        self.assertEqual(status, FAILED)
        self.assert_one_plain_line(errors, "\\x1b[31m")
        self.assertNotIn("\x1b", errors)


class RenderTest(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.picture = self.folder / "picture.png"

    def test_writes_a_png_of_the_size_that_was_asked_for(self):
        status, output, errors = run("render", self.scene(), "-o", self.picture, "--size", "97x61")
        self.assertEqual((status, output, errors), (OK, "", ""))
        self.assertEqual(png_size(self.picture.read_bytes()), (97, 61))

    def test_the_documents_viewport_and_the_volume_of_the_command_line(self):
        scene = self.scene(volume="phantom:abdomen", viewport={"width_px": 50, "height_px": 40})
        status, _, errors = run("render", scene, "-o", self.picture, "--volume", "phantom:knees@32")
        self.assertEqual((status, errors), (OK, ""))
        self.assertEqual(png_size(self.picture.read_bytes()), (50, 40))

    def test_a_volume_whose_path_holds_a_hash_and_one_behind_a_link(self):
        (self.folder / "a#b").mkdir()
        volume = self.file("a#b/volume.nrrd", NRRD)
        link = self.folder / "link.nrrd"
        link.symlink_to(volume)
        for named in (volume, f"{volume}#volume.nrrd", link):
            status, _, errors = run("render", self.scene(), "-o", self.picture, "--volume", named, "--size", "20x20")
            self.assertEqual((status, errors), (OK, ""), named)

    def test_a_style_is_a_scene_too(self):
        style = self.file("style.json", json.dumps({"name": "plain", "title": "Plain", "description": "", "scene": {}}))
        status, _, errors = run("render", style, "-o", self.picture, "--volume", SMALL, "--size", "20x20")
        self.assertEqual((status, errors), (OK, ""))

    def test_vectors_of_any_width_draw_the_same_picture(self):
        def drawn(**environment):
            command = [BINARY, "render", self.scene(), "-o", self.picture, "--size", "160x120"]
            done = subprocess.run(command, env={**os.environ, **environment}, capture_output=True, timeout=300)
            self.assertEqual(done.returncode, OK, (environment, done.stderr))
            return png_pixels(self.picture.read_bytes())

        usual = drawn()
        for bits in ("0", "128", "256"):
            pixels = drawn(LP_NATIVE_VECTOR_WIDTH=bits)
            difference = sum(abs(a - b) for pair in zip(usual, pixels, strict=True) for a, b in zip(*pair))
            self.assertLess(difference / len(usual) / 3, 0.5, f"{bits} bits")  # of 255: the last bit here and there

    def test_a_scene_that_cannot_be_read_is_said_in_one_line(self):
        deep = self.file("deep.json", "[" * 500_000)
        for scene, word in (
            (deep, "deeply"),
            (self.file("broken.json", '{"volume": '), "JSON"),
            (self.folder, "cannot be read"),
            (self.folder / "none.json", "cannot be read"),
        ):
            self.assert_fails(["render", scene, "-o", self.picture], scene, word)
        wrong = self.scene(lens={"radius_mm": "large"})
        self.assert_fails(["render", wrong, "-o", self.picture], f"{wrong}#/lens/radius_mm")
        self.assertFalse(self.picture.exists())

    def test_a_picture_that_cannot_be_written_is_said_before_anything_is_rendered(self):
        # A volume that would be refused later: what is said first is the picture.
        scene = self.scene(volume="/nowhere/at/all")
        self.assert_fails(["render", scene, "-o", "/nope/x.png"], "/nope/x.png")
        self.assert_fails(["render", scene, "-o", self.folder], self.folder)
        self.assert_fails(["render", scene, "-o", self.picture], "/nowhere/at/all")

    @unittest.skipIf(os.path.exists("/dev/dri") or os.path.exists("/dev/nvidia0"), "a GPU may be here")
    def test_a_gpu_that_is_not_there_is_said_in_one_line(self):
        arguments = ["render", self.scene(), "-o", self.picture, "--size", "20x20", "--require-gpu"]
        self.assert_fails(arguments, "GPU")
        self.assert_fails(["serve", "--listen", "127.0.0.1:0", "--require-gpu"], "GPU")


if __name__ == "__main__":
    BINARY = sys.argv.pop(1)
    unittest.main(verbosity=2)
