"""Holds the mesh of every sample against what was approved: its figures, and the digest of its bytes.

With TRISCOPE_APPROVE set (./test --approve) it writes what the program does now instead; read git diff after.
"""

import hashlib
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["TRISCOPE_PROGRAM"]
SOURCE = pathlib.Path(os.environ["TRISCOPE_SOURCE_DIR"])
GOLDEN = SOURCE / "tests" / "golden"
APPROVE = bool(os.environ.get("TRISCOPE_APPROVE"))
SAMPLES = sorted(SOURCE.glob("assets/domains/*.json"))
FIGURES = ["method_version", "vertices", "triangles", "boundary_vertices", "estimated_triangles", "aspect_ratio_max", "area_ratio_max",
           "edge_ratio_max", "min_angle_deg", "max_angle_deg", "obtuse", "min_edge_length"]


def figures(sample, until, folder):
    mesh, report = folder / "mesh.msh", folder / "report.json"
    process = subprocess.run([PROGRAM, "mesh", sample, "-q", "--until", until, "-o", mesh, "--report", report],
                             capture_output=True, text=True, timeout=300, check=False)
    if process.returncode != 0:
        raise AssertionError(f"{sample.name} until {until}: exit {process.returncode}: {process.stderr}")
    data = json.loads(report.read_text(encoding="utf-8"))
    # Six digits are for the reader; the digest is what no bit escapes.
    known = {key: float(f"{data[key]:.6g}") if isinstance(data[key], float) else data[key] for key in FIGURES}
    known["inserted"] = {}
    for stage in data["stages"]:
        if stage["inserted"]:
            known["inserted"][stage["key"]] = stage["inserted"]
    known["sha256"] = hashlib.sha256(mesh.read_bytes()).hexdigest()
    return known


class Golden(unittest.TestCase):
    maxDiff = None

    def test_samples(self):
        self.assertTrue(SAMPLES, "there are no samples")
        for sample in SAMPLES:
            with self.subTest(sample=sample.stem), tempfile.TemporaryDirectory() as folder:
                now = {until: figures(sample, until, pathlib.Path(folder)) for until in ("rounds", "refine")}
                golden = GOLDEN / f"{sample.stem}.json"
                if APPROVE:
                    golden.write_text(json.dumps(now, indent=2) + "\n", encoding="utf-8")
                    continue
                self.assertTrue(golden.exists(), f"{golden.name} is missing: run ./test --approve and look at it")
                self.assertEqual(json.loads(golden.read_text(encoding="utf-8")), now,
                                 "changed; if that is meant, raise kMethodVersion (core/base/version.h), ./test --approve, "
                                 "and say why in the commit")

    def test_no_golden_without_a_sample(self):
        stems = {sample.stem for sample in SAMPLES}
        self.assertEqual([path.name for path in GOLDEN.glob("*.json") if path.stem not in stems], [])


if __name__ == "__main__":
    unittest.main()
