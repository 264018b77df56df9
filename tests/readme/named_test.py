"""What counts as a command of a README."""

import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import commands  # noqa: E402
import named  # noqa: E402

SCRIPTS = {"tests/benchmark/run", "tests/run", "tests/benchmark/scaling", "deploy/run"}
THERE = SCRIPTS | {"tests", "tests/support/reference_ray.cpp"}


def keys(text):
    return [key for _, key in named.named_in(text, SCRIPTS, THERE)]


class Named(unittest.TestCase):
    def test_lines_of_a_block_and_spans_are_read(self):
        text = "```\ndeploy/run   # starts\ntests/run --full\n```\nor `cutaway info PATH [--json]` and `npm run dev`\n"
        self.assertEqual(keys(text), ["deploy/run", "tests/run", "cutaway info", "npm run dev"])

    def test_what_is_joined_is_taken_apart_and_what_is_continued_is_one(self):
        text = "```\ncmake --preset release && cmake --build x\nbuild/release/cutaway serve & pid=$!\ntests/run \\\n  --full\n```"
        self.assertEqual(keys(text), ["cmake --preset", "cmake --build", "cutaway serve", "tests/run"])

    def test_variables_before_it_and_pipes_in_tables_change_nothing(self):
        text = '| `PATH="$(a b):$PATH" X=1 node tests/page.mjs [--json FILE]` | prints |\n| `tests/run` | runs |\n'
        self.assertEqual(keys(text), ["node tests/page.mjs", "tests/run"])

    def test_a_script_by_its_name_alone_needs_an_option_to_be_told_from_a_word(self):
        self.assertEqual(keys("`scaling` measures; `scaling --clients 2`"), ["tests/benchmark/scaling"])

    def test_files_types_and_prose_are_none(self):
        self.assertEqual(keys("`tests/support/reference_ray.cpp`, `cutaway.v1`, `cutaway`, `--full`, `it's`, `a && b`"), [])

    def test_a_script_that_is_gone_is_found(self):
        self.assertEqual(keys("`tests/gone --fast`"), ["tests/gone"])


class Table(unittest.TestCase):
    def test_readmes_and_table_name_the_same(self):
        told = {each.key for each in named.all_named(commands.ROOT)}
        self.assertEqual(told, set(commands.COMMANDS))

    def test_a_row_that_points_to_what_does_not_run_it_is_found(self):
        commands.Elsewhere("tests/run", "tests/readme/run").check()
        with self.assertRaisesRegex(AssertionError, "does not say 'tests/nothing'"):
            commands.Elsewhere("tests/run", "tests/nothing").check()


if __name__ == "__main__":
    unittest.main(verbosity=2)
