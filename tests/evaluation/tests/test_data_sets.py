import json
import pathlib
import subprocess
import tempfile
import unittest

import data_sets


def volume(id, units, kind):
    return {"id": id, "units": units, "first_look": {"kind": kind}}


VOLUMES = [
    volume("ct.nii.gz", "HU", "CT in Hounsfield units"),
    volume("mr.nii.gz", "none", "MR"),
    volume("series", "HU", "CT in Hounsfield units"),
    volume("mask.nrrd", "none", "two values (a mask)"),
    volume("labels.nrrd", "none", "labels"),
]


class Folder(unittest.TestCase):
    def of(self, script):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "cutaway"
            program.write_text(f"#!/bin/sh\n{script}\n")
            program.chmod(0o755)
            return data_sets.read(program, pathlib.Path("/data"))

    def test_it_is_read_as_the_server_lists_it(self):
        asked = '[ "$*" = "info --json /data" ] || exit 1'
        told = json.dumps({"volumes": VOLUMES, "refused": []})
        self.assertEqual(self.of(f"{asked}\ncat <<'END'\n{told}\nEND"), VOLUMES)

    def test_a_failure_is_not_an_empty_folder(self):
        with self.assertRaises(subprocess.CalledProcessError):
            self.of("exit 3")

    def test_only_volumes_in_hounsfield_units_are_cts(self):
        found, others = data_sets.cts(VOLUMES)
        self.assertEqual(found, ["ct.nii.gz", "series"])
        self.assertEqual(others, ["mr.nii.gz", "mask.nrrd", "labels.nrrd"])

    def test_a_mask_has_nothing_for_a_lens_to_show(self):
        self.assertEqual(data_sets.with_two_surfaces(VOLUMES), ["ct.nii.gz", "mr.nii.gz", "series"])
