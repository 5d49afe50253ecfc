"""Every mistake of wrong_cases.toml: exit code and standard error, word for word."""

import concurrent.futures
import os
import pathlib
import re
import subprocess
import tempfile
import tomllib
import unittest

from program import PROGRAM

TABLE = pathlib.Path(__file__).with_name("wrong_cases.toml")


def case_of(wrong, plain):
    text = wrong.get("whole", plain)
    if "replace" in wrong:
        old, new = wrong["replace"]
        assert text.count(old) == 1, wrong["name"]
        text = text.replace(old, new)
    return text + wrong.get("add", "") + "\n"


def outcome(wrong, table):
    """Exit code, standard error and what was made, in a folder of its own."""
    with tempfile.TemporaryDirectory(prefix="frit-wrong-") as parent:
        folder = pathlib.Path(parent)
        files = {"case.toml": case_of(wrong, table["case"]), "packing.csv": table["packing"], **wrong.get("files", {})}
        for name in wrong.get("folders", []):
            (folder / name).mkdir()
        for name, text in files.items():
            (folder / name).parent.mkdir(exist_ok=True)
            (folder / name).write_text(text)
        before = sorted(folder.rglob("*"))
        done = subprocess.run([PROGRAM, *wrong.get("command", "check case.toml").split()], cwd=folder, text=True,
                              capture_output=True, timeout=60)
        said = done.stderr.replace(str(folder.resolve()) + "/", "").replace(str(folder.resolve()), "FOLDER")
        return done.returncode, said, sorted(folder.rglob("*")) != before


class WrongCases(unittest.TestCase):
    maxDiff = None

    def test_each_is_told_word_for_word(self):
        text = TABLE.read_text()
        table = tomllib.loads(text)
        self.assertGreaterEqual(len(table["wrong"]), 60)
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            outcomes = list(pool.map(lambda wrong: outcome(wrong, table), table["wrong"]))
        if os.environ.get("FRIT_UPDATE"):
            said = iter(outcomes)
            text = re.sub(r"^says = '''\n.*?'''$", lambda _: f"says = '''\n{next(said)[1]}'''", text, flags=re.S | re.M)
            TABLE.write_text(text)
            table = tomllib.loads(text)
        for wrong, (code, said, has_made) in zip(table["wrong"], outcomes, strict=True):
            with self.subTest(wrong["name"]):
                self.assertEqual(said, wrong["says"])
                self.assertEqual(code, wrong.get("code", 2))
                self.assertFalse(has_made and code in (1, 2), "something was written")


if __name__ == "__main__":
    unittest.main()
