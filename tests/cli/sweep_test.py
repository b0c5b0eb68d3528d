"""triscope sweep: a row for every pair, each the run with those settings."""

import csv
import io
import json
import signal
import subprocess
import time

import program
from program import BLUNT_BODY, CANCELLED, CANNOT_WRITE, LONG_RUN, OK, STEP, USAGE, run


class Sweep(program.ProgramTest):
    def rows(self, text):
        return list(csv.DictReader(io.StringIO(text)))

    def test_every_row_is_a_run(self):
        rows = self.rows(self.expect(OK, run("sweep", STEP, "--omega", "0.05:0.25:3", "--theta", "5:10:2")).stdout)
        self.assertEqual([(r["omega"], r["theta_deg"]) for r in rows],
                         [("0.05", "5"), ("0.05", "10"), ("0.15", "5"), ("0.15", "10"), ("0.25", "5"), ("0.25", "10")])
        for row in rows[1::2]:
            self.expect(OK, run("mesh", STEP, "-q", "--until", "refine", "--report", self.path("r.json"), "--set", f"omega={row['omega']}",
                                "--set", f"theta={row['theta_deg']}"))
            report = json.loads((self.folder / "r.json").read_text())
            for key in ("triangles", "vertices", "aspect_ratio_max", "aspect_ratio_mean", "area_ratio_max",
                        "edge_ratio_max", "min_angle_deg", "max_angle_deg", "obtuse"):
                self.assertEqual(float(row[key]), report[key], key)
            self.assertEqual(row["bounds_met"], "1" if report["bounds_met"] else "0")
            self.assertEqual(int(row["moved"]), next(s for s in report["stages"] if s["key"] == "refine")["moved"])

    def test_without_step_6_there_is_nothing_to_sweep(self):
        process = run("sweep", STEP, "--preset", "best", "--omega", "0.1:0.2:2", "--theta", "5")
        self.assertIn("all of step 6 is off", self.expect(USAGE, process).stderr)

    def test_threads_do_not_show(self):
        outputs = {self.expect(OK, run("sweep", BLUNT_BODY, "--omega", "0.05:0.25:3", "--theta", "7.5", "-j", j)).stdout
                   for j in ("1", "2", "8")}
        self.assertEqual(len(outputs), 1)

    def test_into_a_file(self):
        process = self.expect(OK, run("sweep", STEP, "--omega", "0.1", "--theta", "7", "-o", self.path("a.csv")))
        self.assertEqual(process.stdout, "")
        self.assertIn("a.csv", process.stderr)
        self.assertEqual(len(self.rows((self.folder / "a.csv").read_text())), 1)

    def test_what_cannot_be_swept(self):
        for omega in ("", "x", "0:1", "0:1:0", "0:1:2:3", "0:2:3", "-1"):
            self.expect(USAGE, run("sweep", STEP, f"--omega={omega}", "--theta", "7", "-o", self.path("a.csv")))
        self.expect(USAGE, run("sweep", STEP, "--omega", "0.1"))
        self.expect(USAGE, run("sweep", STEP, "--omega", "0.1", "--theta", "7", "-j", "0"))
        self.expect(CANNOT_WRITE,
                    run("sweep", STEP, "--omega", "0.1", "--theta", "7", "-o", self.path("no such folder/a.csv")))
        self.assertEqual(self.files(), [])

    def test_control_c_leaves_nothing(self):
        # Once while steps 1-5 run, once while the pairs do.
        for settings, wait in ((LONG_RUN, 0.5), (["--set", "min_edge_length=0.02"], 3.0)):
            process = subprocess.Popen(
                [program.PROGRAM, "sweep", BLUNT_BODY, "--omega", "0.05:0.25:1000", "--theta", "5:10:1000", "-o",
                 self.path("a.csv"), *settings], stderr=subprocess.PIPE, text=True)
            time.sleep(wait)
            self.assertIsNone(process.poll(), "the run ended before Ctrl+C was pressed")
            process.send_signal(signal.SIGINT)
            _, error = process.communicate(timeout=60)
            self.assertEqual(process.returncode, CANCELLED, error)
            self.assertEqual(self.files(), [])


if __name__ == "__main__":
    program.main()
