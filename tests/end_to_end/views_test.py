"""Slices beside the 3-D picture, stills of any size, pictures of scenes that are not taken up.

Usage: views_test.py CUTAWAY_BINARY [unittest arguments]
"""

from png import png_pixels
from served import HEAD, KNEES, ServedTest, run
from wire import jpeg_size, png_size

AXIAL, CORONAL, SAGITTAL = 1, 2, 3


class ViewsTest(ServedTest):
    def showing_slices(self):
        client = self.showing()
        for view in (AXIAL, CORONAL, SAGITTAL):
            client.frame(client.viewport(120 + view, 90, view), still=True, view=view)
        return client

    def test_each_slice_has_frames_of_its_own_size(self):
        client = self.showing_slices()
        for view in (AXIAL, CORONAL, SAGITTAL):
            last = [frame for frame in client.frames if frame.view == view][-1]
            self.assertEqual(jpeg_size(last.data), (120 + view, 90))

    def test_the_crosshair_moves_one_slice_and_nothing_else(self):
        client = self.showing_slices()
        client.frames.clear()
        moved = client.scene({"slices": {"crosshair_mm": [0, 0, 30]}})
        middle = client.scene({"slices": {"crosshair_mm": [0, 0, 33]}})
        client.frame(max(moved, middle), still=True, view=AXIAL)
        self.assertNotIn(0, {frame.view for frame in client.frames})

    def test_a_closed_slice_is_silent(self):
        client = self.showing_slices()
        client.send(type="close_view", view=AXIAL)
        client.frames.clear()
        client.scene({"slices": {"window": {"centre": 300, "width": 1500}}})
        client.frame(client.inputs, still=True, view=SAGITTAL)
        self.assertNotIn(AXIAL, {frame.view for frame in client.frames})

    def test_a_slices_greys_are_the_values_that_are_picked_there(self):
        client = self.showing_slices()
        centre, width = 200, 2400
        client.scene({"slices": {"window": {"centre": centre, "width": width}}})
        seen = set()
        for view in (AXIAL, CORONAL, SAGITTAL):
            size = (120 + view, 90)
            client.send(type="save_still", view=view, request=view, width_px=size[0], height_px=size[1])
            pixels = png_pixels(client.saved(view).data)
            for x, y in ((60, 45), (50, 30), (72, 62), (45, 50), (64, 20)):
                client.send(type="pick", view=view, request=9, position_px=[x + 0.5, y + 0.5])
                picked = client.text("picked", request=9)
                if "value" not in picked:
                    continue
                grey = 255 * min(max((picked["value"] - centre) / width + 0.5, 0), 1)
                seen.add(round(grey / 20))
                # A still's pixel is the mean of four points.
                self.assertAlmostEqual(pixels[y * size[0] + x][0], grey, delta=25)
        self.assertGreater(len(seen), 2, "the points differ")

    def test_a_still_that_is_drawn_in_tiles(self):
        client = self.showing()
        client.send(type="save_still", request=3, width_px=2500, height_px=1100)
        self.assertEqual(png_size(client.saved(3).data), (2500, 1100))

    def test_a_client_that_goes_leaves_its_large_still_to_nobody(self):
        client = self.showing()
        for request in (1, 2):
            client.send(type="save_still", request=request, width_px=8000, height_px=6000)
        client.frame(client.scene({"camera": {"eye_mm": [20, -500, 0]}}))
        client.close()
        other = self.showing()
        other.send(type="save_still", request=3, width_px=2100, height_px=300)
        self.assertEqual(png_size(other.saved(3).data), (2100, 300))

    def test_a_still_of_a_changed_scene_leaves_the_scene_alone(self):
        client = self.showing()
        for request, scene in ((1, {}), (2, {"lens": {"mode": "none"}}), (3, {})):
            client.send(type="save_still", request=request, width_px=160, height_px=120, scene=scene)
            client.saved(request)
        first, changed, again = client.stills
        self.assertEqual(first.data, again.data)
        self.assertNotEqual(first.data, changed.data)

    def test_a_preview_of_another_volume_and_of_a_patch(self):
        client = self.showing()
        client.send(type="preview", request=4, volume=KNEES, width_px=96, height_px=64)
        knees = client.preview(4)
        client.send(type="preview", request=5, scene={"lens": {"mode": "none"}}, width_px=96, height_px=64)
        head = client.preview(5)
        self.assertEqual(jpeg_size(knees.data), (96, 64))
        self.assertNotEqual(knees.data, head.data)
        client.send(type="preview", request=6, volume="no-such-volume", width_px=96, height_px=64)
        self.assertEqual(client.text("error")["request"], 6)
        self.assertFalse([text for text in client.texts if text.get("volume", {}) == KNEES])

    def test_the_volume_is_told_with_its_grid(self):
        client = self.connect()
        _, message = client.open(HEAD)
        self.assertEqual(len(message["volume"]["axes"]), 3)
        self.assertEqual(message["scene"]["slices"]["convention"], "radiological")


if __name__ == "__main__":
    run()
