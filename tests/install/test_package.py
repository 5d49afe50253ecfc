"""The Debian package: made by cpack, unpacked elsewhere, run there."""

import os
import unittest

from installed import BUILD, InstalledTest, run


class Package(InstalledTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        run(os.environ["FRIT_CPACK"], "--config", BUILD / "CPackConfig.cmake", "-G", "DEB", "-B", cls.folder)
        cls.package = next(cls.folder.glob("*.deb"))
        run("dpkg-deb", "-x", cls.package, cls.folder / "root")
        cls.prefix = cls.folder / "root/usr"

    def test_program_module_pages_and_completion(self):
        self.check_program()
        self.check_module()
        self.check_pages()
        self.check_completion()

    def test_it_depends_on_the_libraries_that_the_program_loads(self):
        depends = run("dpkg-deb", "-f", self.package, "Depends")
        for library in ("libtbb", "libfmt", "libcairo", "libc6"):
            self.assertIn(library, depends)

    def test_it_holds_no_headers_and_no_static_libraries(self):
        names = [path.name for path in self.prefix.rglob("*")]
        self.assertFalse([name for name in names if name.endswith((".hpp", ".a"))])
        self.assertIn("copyright", names)


if __name__ == "__main__":
    unittest.main()
