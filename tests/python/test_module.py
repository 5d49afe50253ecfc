"""The package as a whole: stubs, docstrings, what is public."""

import ast
import inspect
import pathlib
import unittest

import frit
from frit import _frit


def stub_names():
    """Public names of the stub: functions, classes, and class.member."""
    tree = ast.parse((pathlib.Path(frit.__file__).parent / "_frit.pyi").read_text())
    names = set()
    for node in tree.body:
        if isinstance(node, ast.FunctionDef):
            names.add(node.name)
        if isinstance(node, ast.ClassDef):
            names.add(node.name)
            names |= {f"{node.name}.{member.name}" for member in node.body if isinstance(member, ast.FunctionDef)}
    return names


def module_names():
    """The same of the compiled module."""
    names = set()
    for name, value in vars(_frit).items():
        if name.startswith("_"):
            continue
        names.add(name)
        if inspect.isclass(value) and not issubclass(value, Exception):
            names |= {f"{name}.{member}" for member in vars(value) if not member.startswith("_")}
            if value is not frit.State:  # a State is made by a run only
                names.add(f"{name}.__init__")
    return names


class Package(unittest.TestCase):
    def test_stubs_and_module_have_the_same_names(self):
        self.assertEqual(stub_names(), module_names())

    def test_everything_public_is_there_and_documented(self):
        for name in frit.__all__:
            value = getattr(frit, name)
            if name != "__version__":
                self.assertTrue(inspect.getdoc(value), name)

    def test_every_property_of_a_state_tells_what_it_is(self):
        for name, member in vars(frit.State).items():
            if isinstance(member, property):
                if name not in ("radii", "time", "temperature"):
                    self.assertGreater(len(member.__doc__), 10, name)
                self.assertTrue(member.__doc__, name)

    def test_the_version_is_the_programs(self):
        self.assertRegex(frit.__version__, r"^\d+\.\d+\.\d+$")

    def test_reference_and_materials(self):
        self.assertIn("bilateral", frit.describe("contact.pull"))
        self.assertIn("copper", frit.materials())
        with self.assertRaisesRegex(frit.InputError, "contact.pull"):
            frit.describe("contact.pul")

    def test_threads(self):
        frit.set_threads(1)
        self.assertEqual(frit.threads(), 1)
        frit.set_threads(0)
        self.assertGreaterEqual(frit.threads(), 1)
        with self.assertRaisesRegex(frit.InputError, "4096"):
            frit.set_threads(-1)


if __name__ == "__main__":
    unittest.main()
