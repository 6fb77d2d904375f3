"""What `measure` and `paper` share: the program run with its cost, its evaluation, tables."""
import json
import math
import os
import subprocess
import tempfile
import time
from pathlib import Path


class Failure(Exception):
    """A sentence for the person who called."""


class Program:
    def __init__(self, file, threads):
        self.file, self.threads = str(Path(file).resolve()), threads

    def run(self, *arguments):
        """Runs a command with --json; its object, with what it cost. Status 1 and 3 are results."""
        command = [self.file, *map(str, arguments), "--json", "--quiet"]
        if self.threads:
            command += ["--threads", str(self.threads)]
        with tempfile.TemporaryFile("w+") as printed:
            begun = time.monotonic()
            try:
                child = subprocess.Popen(command, stdout=printed)
            except OSError as error:
                raise Failure(f"{self.file} cannot be started: {error.strerror}.") from None
            _, status, usage = os.wait4(child.pid, 0)
            child.returncode = os.waitstatus_to_exitcode(status)  # known: nobody waits again
            printed.seek(0)
            text = printed.read()
        if child.returncode not in (0, 1, 3):
            raise Failure(f"`{' '.join(command)}` ended with status {child.returncode}: {text}")
        return json.loads(text), {
            "cpu_s": round(usage.ru_utime + usage.ru_stime, 2),
            "wall_s": round(time.monotonic() - begun, 2),
            "memory_mb": round(usage.ru_maxrss / 1024),
            "exit_status": child.returncode,
        }

    def evaluate(self, out, truth, *options):
        return self.run("evaluate", out, "--truth", truth, *options)[0]


def sets_of(folder):
    """The sets of scans below a folder: those with a truth.json, a front and a back."""
    return sorted(t.parent for t in Path(folder).glob("*/truth.json")
                  if (t.parent / "back").is_dir())


def register(program, scans, out, *options):
    """A set of scans registered: its evaluation and its cost."""
    _, cost = program.run("register", "--front", scans / "front", "--back", scans / "back",
                          "--output", out, *options)
    return program.evaluate(out, scans)["pairs"], cost


def rms_of(row):
    """Of a right pair; infinite where no pose was given."""
    return float("inf") if row.get("rms_mm") is None else row["rms_mm"]


def together(pairs):
    """Several evaluations of pairs as one: each pair weighs the same, as in `evaluate`."""
    rows = [row for one in pairs for row in one["rows"]]
    right = [row for row in rows if row["right"]]
    rms = sorted(map(rms_of, right))
    true_pairs = sum(one["summary"]["true_pairs"] for one in pairs)

    def share(limit):
        return 100 * sum(value <= limit for value in rms) / max(1, true_pairs)

    def quantile(part):  # the smallest value that reaches the share
        return rms[max(1, math.ceil(part * len(rms))) - 1] if rms else float("inf")

    return {
        "true_pairs": true_pairs,
        "right": len(right),
        "right_pct": 100 * len(right) / max(1, true_pairs),
        "silent_errors": sum(one["summary"]["silent_errors"] for one in pairs),
        "flagged": sum(row["ambiguous"] for row in rows),
        "lone": sum(one["summary"]["lone"] for one in pairs),
        "lone_right": sum(one["summary"]["lone_right"] for one in pairs),
        "median_mm": quantile(0.5),
        "p95_mm": quantile(0.95),
        "max_mm": quantile(1),
        "within_0_10_pct": share(0.10),
        "over_0_40_unflagged": sum(not row["ambiguous"] and rms_of(row) > 0.40 for row in right),
    }


def table(head, rows):
    """A table in Markdown."""
    lines = [head, ["---"] * len(head), *rows]
    return "".join("| " + " | ".join(map(str, line)) + " |\n" for line in lines)
