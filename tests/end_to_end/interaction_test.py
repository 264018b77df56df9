"""What a user does to the picture: lens, picking, stills, styles.

Usage: interaction_test.py CUTAWAY_BINARY [unittest arguments]
"""

from served import ServedTest, run
from wire import png_size


class InteractionTest(ServedTest):
    def test_drag_lens_moves_it_over_the_surface(self):
        client = self.showing()
        dragging = client.send_input("drag_lens", position_px=[190, 120])
        centre = client.text("scene")["scene"]["lens"]["centre_mm"]
        client.frame(dragging)
        dragging = client.send_input("drag_lens", position_px=[140, 110])
        self.assertNotEqual(client.text("scene")["scene"]["lens"]["centre_mm"], centre)
        client.frame(dragging)

    def test_the_lens_is_where_it_was_dragged(self):
        client = self.showing()
        client.send_input("drag_lens", position_px=[160, 120])
        client.scene({"lens": {"mode": "none"}})
        client.send(type="pick", request=1, position_px=[160, 120])
        picked = client.text("picked", request=1)
        client.scene({"lens": {"mode": "cutaway", "centre_mm": None}})
        client.send_input("drag_lens", position_px=[160, 120])
        centre = client.text("scene")["scene"]["lens"]["centre_mm"]
        for axis in range(3):
            self.assertAlmostEqual(picked["position_mm"][axis], centre[axis], delta=0.5)

    def test_pick_answers_with_place_value_and_branch(self):
        client = self.showing()
        client.scene({"lens": {"mode": "none"}})
        client.send(type="pick", request=17, position_px=[160, 120])
        picked = client.text("picked", request=17)
        self.assertEqual((picked["branch"], picked["units"]), ("context", "HU"))
        self.assertEqual(len(picked["position_mm"]), 3)
        client.send(type="pick", request=18, position_px=[0, 0])
        self.assertNotIn("position_mm", client.text("picked", request=18))

    def test_inside_the_lens_the_focus_is_picked(self):
        client = self.showing()
        client.scene({"lens": {"radius_mm": 1500}})
        client.send(type="pick", request=1, position_px=[160, 120])
        self.assertEqual(client.text("picked", request=1)["branch"], "focus")

    def test_save_still_is_a_png_of_its_own_size_and_always_the_same(self):
        client = self.showing()
        for request in (5, 6):
            client.send(type="save_still", request=request, width_px=200, height_px=150)
            client.saved(request)
        first, second = client.stills
        self.assertTrue(first.lossless and first.still)
        self.assertEqual(png_size(first.data), (200, 150))
        self.assertEqual(first.viewport, (200, 150))
        self.assertEqual(first.data, second.data)

    def test_null_takes_a_field_back_and_the_scene_is_told(self):
        client = self.showing()
        client.scene({"lens": {"cap": "open"}})
        client.scene({"lens": {"cap": None}})
        self.assertEqual(client.text("scene")["scene"]["lens"]["cap"], "flat")

    def test_every_style_can_be_applied(self):
        client = self.showing()
        styles = client.texts[0]["styles"]
        for shade, style in enumerate(styles):
            client.scene(style["scene"] | {"background": {"colour": [0, 0, (shade + 1) / len(styles)]}})
            client.rest()
        self.assertFalse([text for text in client.texts if text["type"] == "error"])


if __name__ == "__main__":
    run()
