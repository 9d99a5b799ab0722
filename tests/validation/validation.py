# SPDX-License-Identifier: BSD-3-Clause
"""What every validation case needs: the programs, a case file, what they wrote, a page."""
import csv
import json
import pathlib
import shutil
import subprocess
import sys

import h5py
import matplotlib
import numpy as np

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402

matplotlib.rcParams.update({"svg.hashsalt": "shapedem", "font.size": 9, "figure.figsize": (6.4, 4.0),
                            "axes.grid": True, "grid.alpha": 0.3, "savefig.bbox": "tight"})

ROOT = pathlib.Path(__file__).resolve().parents[2]
BIN = ROOT / "build/release/bin"
WORK = ROOT / "build/validation"
PAGES = ROOT / "docs/validation"


def cook(profile, *options, suffix="profile"):
    """Cooks the text of a profile or, by its suffix, of a .convex file (or the name of a profile in data/profiles) and returns the
    template's path."""
    WORK.mkdir(parents=True, exist_ok=True)
    if "\n" in profile:
        name = f"inline_{abs(hash_text(profile + ' '.join(options))):x}"
        source = WORK / f"{name}.{suffix}"
        source.write_text(profile)
    else:
        source = ROOT / f"data/profiles/{profile}.profile"
        name = profile + "".join(o.replace("-", "_").replace("%", "") for o in options)
    template = WORK / f"{name}.tpl"
    subprocess.run([BIN / "shapegen", source, "-o", template, "--quiet", *options], check=True)
    return template


def cook_mesh(mesh, *options):
    """Cooks a mesh file and returns the template's path."""
    WORK.mkdir(parents=True, exist_ok=True)
    template = WORK / f"{mesh.stem}{''.join(o.replace('-', '_').replace('%', '') for o in options)}.tpl"
    subprocess.run([BIN / "shapegen", mesh, "-o", template, "--quiet", *options], check=True)
    return template


def shapegen(name, *arguments):
    """Makes a template by any command of shapegen and returns its path."""
    WORK.mkdir(parents=True, exist_ok=True)
    template = WORK / f"{name}.tpl"
    subprocess.run([BIN / "shapegen", *arguments, "-o", template, "--quiet"], check=True)
    return template


def inspect(template):
    """What `shapegen inspect --json` says of a template."""
    return json.loads(subprocess.run([BIN / "shapegen", "inspect", template, "--json"], check=True,
                                     capture_output=True, text=True).stdout)


def hash_text(text):
    value = 0xCBF29CE484222325
    for byte in text.encode():
        value = ((value ^ byte) * 0x100000001B3) % 2**64
    return value


def write_bodies(name, rows):
    """Writes a file of bodies for `insert = file`; rows are dicts of its columns."""
    WORK.mkdir(parents=True, exist_ok=True)
    columns = "x y z qw qx qy qz vx vy vz wx wy wz".split()
    defaults = dict.fromkeys(columns, 0.0) | {"qw": 1.0}
    path = WORK / f"{name}.csv"
    with open(path, "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(columns)
        for row in rows:
            writer.writerow(repr(float((defaults | row)[c])) for c in columns)
    return path


class Run:
    """One finished run of demrun: final states, history, frames, summary."""

    def __init__(self, name, case, *options, reuse=False):
        WORK.mkdir(parents=True, exist_ok=True)
        path = WORK / f"{name}.ini"
        path.write_text(case)
        self.directory = WORK / name
        if not (reuse and (self.directory / "summary.json").exists()):
            subprocess.run([BIN / "demrun", path, "--out", self.directory, "--force", "--quiet", *options], check=True)
        self.final = table(self.directory / "final.csv")
        self.history = table(self.directory / "history.csv")
        self.summary = json.loads((self.directory / "summary.json").read_text())

    def frames(self):
        """Times (n) and a dict of arrays (n, bodies, components) of everything in the frames."""
        with h5py.File(self.directory / "frames.h5") as file:
            groups = [file["frames"][k] for k in sorted(file["frames"])]
            times = np.array([g.attrs["time"] for g in groups])
            names = [n for n in groups[0] if groups[0][n].shape[0] == groups[-1][n].shape[0]]
            return times, {n: np.stack([g[n][...] for g in groups]) for n in names}


def table(path):
    """A csv file with a header as a dict of arrays (numbers where all are numbers, NaN where a field is empty)."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    columns = {}
    for name in rows[0]:
        values = [row[name] for row in rows]
        try:
            columns[name] = np.array([float(v or "nan") for v in values])
        except ValueError:
            columns[name] = values
    return columns


class Page:
    """docs/validation/NAME.md: text, tables and plots, with a verdict a reader can check."""

    def __init__(self, name, title):
        self.name = name
        self.lines = [f"# {title}", ""]
        self.failures = []
        PAGES.mkdir(parents=True, exist_ok=True)

    def end_list(self):
        """What follows claims is not part of the last one."""
        if self.lines[-1].startswith("- "):
            self.lines.append("")

    def text(self, text):
        self.end_list()
        self.lines += [text.strip(), ""]

    def table(self, header, rows):
        self.end_list()
        self.lines.append("| " + " | ".join(header) + " |")
        self.lines.append("|" + "---|" * len(header))
        self.lines += ["| " + " | ".join(str(c) for c in row) + " |" for row in rows]
        self.lines.append("")

    def plot(self, figure, suffix, caption):
        file = f"{self.name}{suffix}.svg"
        figure.savefig(PAGES / file, metadata={"Date": None})
        plt.close(figure)
        self.end_list()
        self.lines += [f"![{caption}]({file})", "", f"*{caption}*", ""]

    def picture(self, source, caption):
        """A PNG that a program drew."""
        file = f"{self.name}_{source.stem}.png"
        shutil.copyfile(source, PAGES / file)
        self.end_list()
        self.lines += [f"![{caption}]({file})", "", f"*{caption}*", ""]

    def claim(self, statement, holds):
        """A statement with its number; remembered when it does not hold."""
        self.lines.append(f"- {'met' if holds else '**not met**'}: {statement}")
        if not holds:
            self.failures.append(statement)

    def shortfall(self, statement, holds):
        """An aim that is known not to be reached, stated with its number; an error once it is reached."""
        self.lines.append(f"- **not met**: {statement}")
        if holds:
            self.failures.append(f"listed as a shortfall, yet met: {statement}")

    def finish(self):
        self.lines += ["", f"Reproduce: `tests/validation/run {self.name}`", ""]
        (PAGES / f"{self.name}.md").write_text("\n".join(self.lines))
        for failure in self.failures:
            print(f"{self.name}: not met: {failure}", file=sys.stderr)
        print(f"{self.name}: docs/validation/{self.name}.md, {len(self.failures)} claims not met")
        return 1 if self.failures else 0
