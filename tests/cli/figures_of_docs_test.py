"""The figures of docs/figures are what today's program draws, to the byte."""

import os
import pathlib
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["TRISCOPE_SOURCE_DIR"])
BUILD = pathlib.Path(os.environ["TRISCOPE_BUILD_DIR"])


class FiguresOfDocs(unittest.TestCase):
    def test_each_is_as_it_is_drawn_now(self):
        program = BUILD / "docs" / "figures" / "triscope_figures"
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([program, SOURCE / "assets" / "domains", folder], check=True)
            drawn = {file.name: file.read_bytes() for file in pathlib.Path(folder).iterdir()}
        committed = {file.name: file.read_bytes() for file in (SOURCE / "docs" / "figures").glob("figure_*")}
        self.assertGreater(len(drawn), 10)
        self.assertEqual(sorted(drawn), sorted(committed))
        changed = sorted(name for name, content in drawn.items() if content != committed[name])
        self.assertEqual(changed, [], "cmake --build build/release --target figures draws them again")


if __name__ == "__main__":
    unittest.main()
