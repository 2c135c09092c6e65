#!/usr/bin/env python3
"""check_defaults.py complains about each value that a button and a menu set differently, and about nothing else."""
import pathlib
import types
import unittest

import check_defaults

PANELS = {"Tube": {"Radius": 1.0, "Sides": 6.0}}


def steps(**properties):
    return types.SimpleNamespace(
        FIRST={"Tube": {"Sides": 12}},
        PIPELINES={"to_tube": {"tube": types.SimpleNamespace(proxy="Tube", properties={"Sides": 12, **properties})}})


class CheckDefaults(unittest.TestCase):
    def said(self, given, exceptions=()):
        return check_defaults.complaints(given, PANELS, exceptions)

    def test_same_values(self):
        self.assertEqual(self.said(steps()), [])
        self.assertEqual(self.said(steps(Radius=1.0)), [])

    def test_other_value(self):
        said = self.said(steps(Radius=2.0))
        self.assertEqual(len(said), 1)
        self.assertIn("Radius of Tube is 2.0 by the button and 1.0 by the menu", said[0])
        self.assertEqual(self.said(steps(Radius=2.0), {("to_tube", "tube", "Radius"): "thick"}), [])
        self.assertEqual(self.said(steps(Radius=2.0), {("*", "tube", "Radius"): "thick"}), [])

    def test_first_value_that_the_button_lacks(self):
        given = steps()
        del given.PIPELINES["to_tube"]["tube"].properties["Sides"]
        self.assertIn("Sides of Tube is 6.0 by the button and 12 by the menu", self.said(given)[0])

    def test_exception_that_is_not_needed(self):
        self.assertIn("not needed", self.said(steps(), {("to_tube", "tube", "Radius"): "thick"})[0])

    def test_unknown_names(self):
        self.assertIn("has no number Length", self.said(steps(Length=1.0))[0])
        given = steps()
        given.FIRST["Ball"] = {"Radius": 1.0}
        self.assertIn("steps.FIRST: Ball has no number Radius", self.said(given)[0])

    def test_this_tree(self):
        root = pathlib.Path(check_defaults.__file__).resolve().parents[1]
        panels = check_defaults.defaults_of(root)
        self.assertEqual(panels["PoissonBoltzmannOnSurface"]["IonicStrength"], 0.0)  # of the base proxy
        self.assertEqual(check_defaults.load_steps(root).FIRST["PoissonBoltzmann"]["IonicStrength"], 0.15)


if __name__ == "__main__":
    unittest.main()
