# SPDX-License-Identifier: BSD-3-Clause
"""Shared by the packing cases: a case of data/cases run with several seeds, its fill heights."""
import argparse
import concurrent.futures
import os

import numpy as np

from validation import ROOT, Page, Run, plt


def arguments():
    parser = argparse.ArgumentParser()
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--reuse", action="store_true", help="take runs that are finished as they are")
    return parser.parse_args()


def pack(name, template, options):
    """Runs data/cases/NAME.ini once per seed, one core each."""
    text = (ROOT / f"data/cases/{name}.ini").read_text()

    def one(seed):
        return Run(f"{name}_{seed}", text, "--threads", "1", "--set", f"run.seed={seed}",
                   "--set", f"particles.{template.stem}.template={template}", reuse=options.reuse)

    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        return list(pool.map(one, range(1, options.seeds + 1)))


def report(page: Page, runs, experiment, tolerance, paper, total):
    """Table, claim and plot of the fill heights against the experiment (mm)."""
    names = ["height_highest", "height_top_ten", "height_surface"]
    heights = np.array([[1e3 * run.history[n][-1] for n in names] for run in runs])
    rows = [[k + 1, *(f"{h:.2f}" for h in heights[k]), int(run.summary["steps"]),
             f"{run.summary['microseconds_per_particle_step']:.3f}", run.summary["state_hash"]]
            for k, run in enumerate(runs)]
    rows.append(["mean", *(f"{h:.2f}" for h in heights.mean(axis=0)), "", "", ""])
    page.table(["seed", "highest point [mm]", "mean of the ten highest [mm]", "mean surface [mm]", "steps",
                "us per particle and step", "state hash"], rows)
    mean = heights[:, 0].mean()
    page.claim(f"highest point, mean over {len(runs)} seeds, within the experiment's {experiment:g} +- {tolerance:g} mm "
               f"({mean:.2f} mm; the paper: {paper})", abs(mean - experiment) <= tolerance)
    placed = min(len(run.final["x"]) for run in runs)
    page.claim(f"all {total} particles inside ({placed})", placed == total)
    figure, axes = plt.subplots()
    axes.axhspan(experiment - tolerance, experiment + tolerance, color="0.85", label="experiment")
    for k, run in enumerate(runs):
        axes.plot(run.history["time"], 1e3 * run.history[names[0]], lw=1, label=f"seed {k + 1}")
    axes.set(xlabel="time [s]", ylabel="highest point [mm]")
    axes.legend()
    page.plot(figure, "", "Fill height while the vessel is filled")
