"""cmake --install into a folder of its own; a program of others that links the libraries."""

import os
import unittest

from installed import BUILD, SOURCE, InstalledTest, run


class Prefix(InstalledTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.prefix = cls.folder / "prefix"
        run(os.environ["FRIT_CMAKE"], "--install", BUILD, "--prefix", cls.prefix)

    def test_program_module_pages_and_completion(self):
        self.check_program()
        self.check_module()
        self.check_pages()
        self.check_completion()

    def test_no_file_names_the_source_or_build_folder(self):
        for file in (self.prefix / "lib/cmake/frit").iterdir():
            text = file.read_text()
            self.assertNotIn(str(SOURCE), text, file.name)
            self.assertNotIn("/usr/include", text, file.name)

    def test_another_program_finds_and_links_the_libraries(self):
        build = self.folder / "consumer"
        run(os.environ["FRIT_CMAKE"], "-S", SOURCE / "examples/consumer", "-B", build, "-G", "Ninja",
            f"-DCMAKE_PREFIX_PATH={self.prefix}", f"-DCMAKE_CXX_COMPILER={os.environ['FRIT_CXX']}")
        run(os.environ["FRIT_CMAKE"], "--build", build)
        lines = run(build / "consumer").splitlines()
        self.assertTrue(lines[-1].endswith("  0.6000"), lines)
        (self.folder / "powder.toml").write_text((SOURCE / "examples/consumer/main.cpp").read_text().split('R"(')[1].split(')"')[0])
        run(self.prefix / "bin/frit", "run", "powder.toml", "--quiet", cwd=self.folder)
        last = (self.folder / "powder/series.csv").read_text().splitlines()[-1].split(",")[0]
        self.assertEqual(lines[-1].split()[0], f"{float(last):.6g}")


if __name__ == "__main__":
    unittest.main()
