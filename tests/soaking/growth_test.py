"""That a leak is told from noise, spikes and a warm-up; that the page shows it."""
import os
import pathlib
import random
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import growth  # noqa: E402
import page  # noqa: E402
import watch  # noqa: E402

LIMIT = growth.Limit("memory", "MiB", 32, share=0.05)


def series(value, seconds=60):
    noise = random.Random(7)
    return [(t / 2, value(t / 2) + noise.uniform(-8, 8)) for t in range(2 * seconds)]


class Growth(unittest.TestCase):
    def grown(self, value, seconds=60):
        return growth.judge(LIMIT, series(value, seconds))

    def test_noise_and_steps_up_and_down_are_flat(self):
        self.assertTrue(self.grown(lambda t: 300).holds)
        self.assertTrue(self.grown(lambda t: 300 + 60 * (int(t / 5) % 2)).holds)

    def test_what_a_start_takes_does_not_count(self):
        self.assertTrue(self.grown(lambda t: 100 + min(200, 20 * t)).holds)

    def test_spikes_do_not_count_even_at_the_end(self):
        self.assertTrue(self.grown(lambda t: 1000 if t > 56 or 30 < t < 32 else 300).holds)

    def test_a_leak_is_found_quickly_where_it_is_large_and_in_time_where_it_is_small(self):
        verdict = self.grown(lambda t: 300 + t)
        self.assertFalse(verdict.holds)
        self.assertAlmostEqual(verdict.grown, 40, delta=6)
        self.assertFalse(self.grown(lambda t: 300 + t / 30, seconds=1800).holds)

    def test_a_leak_in_steps_is_found(self):
        self.assertFalse(self.grown(lambda t: 300 + 100 * int(t / 15)).holds)

    def test_too_few_samples_are_no_verdict(self):
        with self.assertRaisesRegex(ValueError, "measure for longer"):
            growth.judge(LIMIT, [(0, 1), (1, 1)])


class Page(unittest.TestCase):
    def test_it_has_verdicts_and_plots(self):
        leak = series(lambda t: 300 + 2 * t)
        text = page.report("T <1>", ["a & b"], [growth.judge(LIMIT, leak)], [("memory", "MiB", leak), ("none", "", [])])
        for told in ("T &lt;1&gt;", "a &amp; b", "GROWS", "<polyline", "Nothing was measured"):
            self.assertIn(told, text)


class Watched(unittest.TestCase):
    def test_a_process_is_looked_into(self):
        before = watch.look(os.getpid())
        with tempfile.TemporaryFile():
            self.assertEqual(watch.look(os.getpid())["descriptors"], before["descriptors"] + 1)
        self.assertGreater(before["memory"], 1)
        self.assertEqual(before["threads"], 1)


if __name__ == "__main__":
    unittest.main(verbosity=2)
