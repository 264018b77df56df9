import unittest

from studio import Studio


class FakeClient:
    """Hands out what is laid ready; keeps what it was sent."""

    def __init__(self):
        self.ready, self.sent = [], []

    def scene(self, scene, replace=False):
        self.sent.append(scene)

    def send_input(self, type, **fields):
        self.sent.append((type, fields))

    def until(self, wanted, what):
        while self.ready:
            message = self.ready.pop(0)
            if wanted(message):
                return message
        raise AssertionError(f"{what} did not come")


def told(mark, centre_mm):
    scene = {"background": {"colour": mark}, "lens": {"centre_mm": centre_mm}}
    return {"type": "scene", "revision": 1, "scene": scene}


class Answers(unittest.TestCase):
    def setUp(self):
        self.studio = Studio.__new__(Studio)
        self.studio._client, self.studio._resets, self.studio._volume = FakeClient(), 0, "head"
        self.ready = self.studio._client.ready

    def test_a_scene_told_late_does_not_pass_for_the_answer(self):
        self.ready += [told([0.5, 0.5, 0.5], [9, 9, 9]), told([1 / 1024, 0, 0], [1, 2, 3])]
        self.assertEqual(self.studio.reset({})["lens"]["centre_mm"], [1, 2, 3])
        self.ready.append(told([1 / 1024, 0, 0], [4, 5, 6]))
        self.assertEqual(self.studio.drag_lens(0.5, 0.5), [4, 5, 6])

    def test_each_reset_has_its_own_mark(self):
        for number in (1, 2):
            self.ready.append(told([number / 1024, 0, 0], [number, 0, 0]))
            self.studio.reset({"camera": {}})
        marks = [scene["background"]["colour"] for scene in self.studio._client.sent]
        self.assertNotEqual(*marks)

    def test_what_the_server_refuses_is_not_waited_out(self):
        self.ready += [{"type": "error", "code": "rate-limited"}, told([1 / 1024, 0, 0], [1, 2, 3])]
        with self.assertRaisesRegex(RuntimeError, "rate-limited"):
            self.studio.reset({})
