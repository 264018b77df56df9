import json
import pathlib
import subprocess
import tempfile
import unittest

import data_sets

LISTING = {
    "volumes": [
        {"id": "ct.nii.gz", "modality": "CT", "units": "HU"},
        {"id": "mr.nii.gz", "modality": "", "units": "none"},
        {"id": "series", "modality": "CT", "units": "HU"},
        {"id": "mr-series", "modality": "MR", "units": "none"},
    ],
    "refused": [],
}


class Cts(unittest.TestCase):
    def of(self, script):
        with tempfile.TemporaryDirectory() as folder:
            program = pathlib.Path(folder) / "cutaway"
            program.write_text(f"#!/bin/sh\n{script}\n")
            program.chmod(0o755)
            return data_sets.cts(program, pathlib.Path("/data"))

    def test_only_volumes_in_hounsfield_units_are_cts(self):
        asked = '[ "$*" = "info --json /data" ] || exit 1'
        self.assertEqual(
            self.of(f"{asked}\ncat <<'END'\n{json.dumps(LISTING)}\nEND"),
            (["ct.nii.gz", "series"], ["mr.nii.gz", "mr-series"]),
        )

    def test_a_failure_is_not_an_empty_folder(self):
        with self.assertRaises(subprocess.CalledProcessError):
            self.of("exit 3")
