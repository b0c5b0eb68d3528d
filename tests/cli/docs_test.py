"""The examples of docs/debugging.md: they run, exit as they say, and print what they show.

An ellipsis stands for any text, on a line of its own for any lines. Figures and ids are not compared: they are those of
one version of the method, and other tests hold them.
"""

import os
import re
import shlex

import program
from program import SOURCE, run

NUMBER = re.compile(r"-?\b\d+(\.\d+)?([eE][-+]?\d+)?\b")


def examples(text):
    """(arguments, exit code, expected output) of each indented block that begins with "$ triscope"."""
    for block in re.findall(r"(?:^    .*\n|^\n(?=    ))+", text, re.MULTILINE):
        lines = [line[4:] for line in block.splitlines()]
        lines = lines[next((k for k, line in enumerate(lines) if line), 0):]
        if not lines or not lines[0].startswith("$ triscope "):
            continue
        command, _, comment = lines[0].partition("  # exits ")
        yield shlex.split(command)[2:], int(comment or 0), "\n".join(lines[1:]).rstrip()


def pattern(expected):
    """A regular expression of the output, numbers aside."""
    parts = []
    for line in NUMBER.sub("#", expected).split("\n"):
        parts.append(r"(?:[^\n]*\n)*?" if line.strip() == "…" else re.escape(line).replace("…", r"[^\n]*") + r"\n")
    return re.compile("".join(parts))


class Docs(program.ProgramTest):
    def test_every_example(self):
        os.symlink(SOURCE / "assets", self.folder / "assets")
        before = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, before)
        text = (SOURCE / "docs" / "debugging.md").read_text(encoding="utf-8")
        count = 0
        for arguments, code, expected in examples(text):
            with self.subTest(arguments):
                process = run(*arguments)
                self.assertEqual(process.returncode, code, process.stderr)
                printed = NUMBER.sub("#", process.stdout or process.stderr)
                self.assertTrue(pattern(expected).fullmatch(printed), f"{expected}\n--- but it printed\n{printed}")
            count += 1
        self.assertGreater(count, 12)

    def test_the_comparison_can_fail(self):
        self.assertTrue(pattern("a 1\n…\nb … c").fullmatch(NUMBER.sub("#", "a 5.5\nx\ny\nb 7 or so c\n")))
        self.assertFalse(pattern("a 1\nb").fullmatch("a #\nc\n"))
        self.assertFalse(pattern("a").fullmatch("a\nb\n"))


if __name__ == "__main__":
    program.main()
