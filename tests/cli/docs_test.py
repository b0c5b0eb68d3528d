"""The examples of docs/debugging.md run, exit as they say, and print what they show; those of README.md run.

An ellipsis stands for any text, on a line of its own for any lines. Figures and ids are compared: the same input gives
the same bytes, and whoever follows an example is to see what it shows.
"""

import os
import re
import shlex
import signal

import program
from program import OK, SOURCE, STEP, run


def blocks(text):
    """The lines of each indented block."""
    for block in re.findall(r"(?:^    .*\n|^\n(?=    ))+", text, re.MULTILINE):
        lines = [line[4:] for line in block.splitlines()]
        yield lines[next((k for k, line in enumerate(lines) if line), 0):]


def examples(text):
    """(arguments, exit code, expected output) of each indented block that begins with "$ triscope"."""
    for lines in blocks(text):
        if not lines or not lines[0].startswith("$ triscope "):
            continue
        command, _, comment = lines[0].partition("  # exits ")
        yield shlex.split(command)[2:], int(comment or 0), "\n".join(lines[1:]).rstrip()


def pattern(expected):
    """A regular expression of the output."""
    parts = []
    for line in expected.split("\n"):
        parts.append(r"(?:[^\n]*\n)*?" if line.strip() == "…" else re.escape(line).replace("…", r"[^\n]*") + r"\n")
    return re.compile("".join(parts))


class InFolder(program.ProgramTest):
    """Commands name files of the folder of the test and of assets/."""

    def setUp(self):
        super().setUp()
        os.symlink(SOURCE / "assets", self.folder / "assets")
        before = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, before)


class Docs(InFolder):
    def test_every_example(self):
        text = (SOURCE / "docs" / "debugging.md").read_text(encoding="utf-8")
        count = 0
        for arguments, code, expected in examples(text):
            with self.subTest(arguments):
                process = run(*arguments)
                self.assertEqual(process.returncode, code, process.stderr)
                printed = process.stdout or process.stderr
                self.assertTrue(pattern(expected).fullmatch(printed), f"{expected}\n--- but it printed\n{printed}")
            count += 1
        self.assertGreater(count, 12)

    def test_the_comparison_can_fail(self):
        self.assertTrue(pattern("a 1\n…\nb … c").fullmatch("a 1\nx\ny\nb 7 or so c\n"))
        self.assertFalse(pattern("a 1\nb").fullmatch("a 1\nc\n"))
        self.assertFalse(pattern("a 1").fullmatch("a 2\n"))
        self.assertFalse(pattern("a").fullmatch("a\nb\n"))


class Readme(InFolder):
    """Every command that needs no display: what is in capitals stands for a file, what is in brackets may be left out."""

    FILES = {"DOMAIN": STEP, "MESH": "OUT.msh", "FILE": "session.json"}

    def commands(self):
        for lines in self.blocks:
            for line in lines:
                line = re.split(r"\s+#|\s+&&", line)[0]
                if re.match(r"triscope [a-z]", line):
                    yield line

    def setUp(self):
        super().setUp()
        self.blocks = list(blocks((SOURCE / "README.md").read_text(encoding="utf-8")))

    def test_every_command(self):
        domain = next("\n".join(lines).split("\n\n")[0] for lines in self.blocks if lines[0] == "{")
        self.write("plate.json", domain)
        self.expect(OK, run("debug", STEP, "--save-session", "session.json"))
        seen = set()
        for command in self.commands():
            for line in {re.sub(r" *\[.*?\]", "", command), re.sub(r"[][]", "", command)}:
                arguments = [self.FILES.get(word, word) for word in shlex.split(line)[1:]]
                with self.subTest(line):
                    self.expect(OK, run(*arguments))
                seen.add(arguments[0])
        self.assertEqual(seen, {"mesh", "check", "figure", "debug", "sweep", "replay", "settings"})
        self.assertTrue((self.folder / "plate.msh").exists())

    def test_exit_codes(self):
        """README, --help and the program agree on what there is, and README begins with the words of --help."""
        text = (SOURCE / "README.md").read_text(encoding="utf-8")
        table = {int(code): words for code, words in re.findall(r"^\| (\d+) \| (.*) \|$", text, re.MULTILINE)}
        footer = self.expect(OK, run("--help")).stdout.partition("Exit codes:\n")[2]
        said = {int(code): words for code, words in re.findall(r"^ *(\d+) +(.*?) *$", footer, re.MULTILINE)}
        self.assertEqual(list(table), list(said))
        for code, words in said.items():
            self.assertTrue(table[code].startswith(words), f"{code}: {words}")
        header = (SOURCE / "src" / "cli" / "exit_codes.h").read_text(encoding="utf-8")
        codes = re.findall(r"^  \w+ = (\d+),", header.partition("enum class ExitCode")[2], re.MULTILINE)
        self.assertLessEqual({int(code) for code in codes}, set(said))
        self.assertGreater(len(codes), 8)
        stop = (SOURCE / "src" / "core" / "base" / "stop.cpp").read_text(encoding="utf-8")
        signals = re.findall(r"^    \{(SIG\w+), ", stop, re.MULTILINE)
        self.assertLessEqual({128 + signal.Signals[name] for name in signals}, set(said))
        self.assertEqual(len(signals), 4)


if __name__ == "__main__":
    program.main()
